// Types of HLSL, as far as its implicit conversions need them.
#pragma once

#include <string>
#include <string_view>

namespace patina::importers::shadergraph {

enum class Kind { Unknown, Bool, Int, Uint, Float, Texture };  // numbers: HLSL converts to the later one of two

struct Type {
    Kind kind = Kind::Unknown;
    int size = 1;     // of a vector; of a matrix the rows
    int columns = 0;  // of a matrix
    // An integer of HLSL that is any number in the node language: "2", "c ? 1 : 0", "sign(x)".
    bool is_loose = false;
    bool is_array = false;

    bool is_known() const { return kind != Kind::Unknown && kind != Kind::Texture && !is_array; }
    bool is_vector() const { return is_known() && columns == 0; }  // or a scalar
};
Type type_of(std::string_view word);  // "float3", "half4x4", "Texture2D"
std::string word_for(Kind kind, int size);

// What a function of HLSL does with the types of its arguments.
enum class Rule {
    None,      // another function
    Float,     // all are floats, of the same size
    Numbers,   // all are of one kind, of the same size
    Scalar,    // all are floats, and the result is one float
    First,     // all are floats, and the result has the size of the first
    Sign,      // integers of its argument's size
    Test,      // bools of its argument's size
    AnyOrAll,  // of bools, and one bool
    Product,   // "mul"
    AsFloat,   // the same bits, of another kind
    AsInt,
    AsUint
};
Rule rule_of(std::string_view function);
Type product(const Type& a, const Type& b);

}  // namespace patina::importers::shadergraph
