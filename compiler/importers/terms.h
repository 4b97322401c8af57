// Values on their way from node to node of an imported material, as a graph writes them: numbers, a link, or an
// expression. Chains of arithmetic become one expression; only what is read twice, or is long, gets a name.
//
//   const Term tint = link("$_Tint", Type::Float4);
//   converted(tint, Type::Float3).text();             // "$_Tint.xyz"

#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/importers/expression_text.h"
#include "compiler/importers/graph_writer.h"

namespace patina::importers::terms {

enum class Type { None, Bool, Float, Float2, Float3, Float4, Matrix3, Matrix4 };

bool is_vector(Type type);     // also a number, not a bool
std::size_t width(Type type);  // components of a vector, rows of a matrix; of a bool 1
Type vector_type(std::size_t width);
std::string_view word(Type type);  // in the node language: "float3"

struct Term {
    Type type = Type::None;
    std::vector<double> numbers{};  // of a constant, as many as its type has; else
    std::string base{};             // a link or an expression
    std::string swizzle{};          // behind it: "xyz"
    struct Part {
        std::string text;
        std::size_t width = 1;
    };
    std::vector<Part> parts{};        // if `base` is float4(a, b, c): its arguments
    std::string from_top{};           // of texture coordinates: a link to the same with v counted from the top
    std::string tangent{};            // of a normal in world space: a link to the same in tangent space
    bool is_color = false;            // its components are called r, g, b, a
    std::string name{};               // the id that it would get as a node
    std::set<std::size_t> sources{};  // numbers of the source's nodes that are written in it

    bool is_constant() const { return !numbers.empty(); }
    bool is_all(double value) const;  // a constant whose components are all that
    std::string text() const;         // as a part of an expression: "float3(1, 0, 0)", "mask.x", "a + b"
    bool is_link() const;             // a name with or without a port and a swizzle
    bool is_short() const;            // it is written again where it is read
    Value value() const;              // at a port
};

Term number_term(double value);
Term constant(std::vector<double> values);  // one to four: a number or a vector
Term flag_term(bool value);
Term link(std::string text, Type type);  // "$_Tint", "mask.r", "@uv0"
Term expression(std::string text,
                Type type);  // knows float3(a, b, c), numbers and products of numbers as what they are

// The term in another type. What is missing is 0, but the fourth component is 1. Numbers stay numbers if
// `may_stay_number`, because an operator or a port converts them. Without such a conversion: the type None.
Term converted(const Term& term, Type type, bool may_stay_number = false);
// Components of a vector: "x", "bgr"; '0' and '1' are these numbers.
Term swizzled(const Term& term, std::string_view components);
// The same texture coordinates, with v counted from the other side.
Term flipped(const Term& term);

}  // namespace patina::importers::terms
