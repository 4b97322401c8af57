// Describes a language to the printer: how each operation is spelled (data), and functions for the few things that data
// cannot express. The printer decides what is printed, and in which order. A language decides how it looks.
//
//   {Op::Lerp, Form::Function, "mix", Precedence::Postfix, {}, kThird}     lerp(a, b, t) is mix(a, b, t), and t may be
//                                                                       a scalar among vectors
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/ir/ir.h"
#include "compiler/languages/precedence.h"

namespace patina::languages {

class Body;     // the function that is being printed; body.h
struct Writer;  // the text so far; writer.h

enum class Form : std::uint8_t {
    Prefix,     // text operand
    Infix,      // operand text operand
    Function,   // text(operands)
    Shared,     // in expressions.cpp: leaves, composites, conversions, calls
    Own,        // in Language::expression
    Statement,  // not an expression: statements.cpp prints it
};

// The operands that may be scalars if the others are vectors, as a mask of their positions.
enum ScalarOperands : std::uint8_t { kNone = 0, kFirst = 1, kSecond = 2, kThird = 4, kEither = 8 };

struct Spelling {
    ir::Op op{};
    Form form = Form::Statement;
    std::string_view text = {};
    Precedence precedence = Precedence::Postfix;
    std::string_view of_vectors = {};  // the function for vector operands; empty: the same spelling
    std::uint8_t scalars = kNone;
};
using SpellingTable = std::array<Spelling, ir::kOpCount>;

// Makes a table indexed by Op of rows in any order: those that languages share, and a language's own. Does not compile
// if an op is missing or there twice.
template <std::size_t N, std::size_t M>
consteval SpellingTable by_op(const Spelling (&shared)[N], const Spelling (&own)[M]) {
    static_assert(N + M == ir::kOpCount, "a spelling table needs one row for each op");
    SpellingTable table{};
    std::array<bool, ir::kOpCount> seen{};
    const auto add = [&](const Spelling& row) {
        const auto index = static_cast<std::size_t>(row.op);
        if (seen[index]) throw "an op is spelled twice";
        seen[index] = true;
        table[index] = row;
    };
    for (const Spelling& row : shared) add(row);
    for (const Spelling& row : own) add(row);
    return table;
}

// How the entry function reads its inputs and writes its outputs.
struct EntryPoint {
    std::string signature;                 // "void main()"
    std::vector<Text> inputs;              // by parameter: "vUv0", "input.uv0"
    std::vector<std::string> outputs;      // by member of the result: "outColor", "output.color"
    std::string before_return, at_return;  // statements around the assignments of the outputs; may be empty
    std::vector<std::string> names = {};   // names that the signature declares
    std::vector<std::string> begin = {};   // statements before everything else
    std::vector<std::string> guards = {};  // by output: a condition of the preprocessor, or empty
    std::vector<std::string> end = {};     // statements before `at_return`
};

// How a language writes what stands around expressions. Each function makes one line, or a part of one.
struct Syntax {
    // "vec3 n", "float k[4]". `sizes`: "[4]"
    using Declaration = std::string (*)(std::string_view type, std::string_view name, std::string_view sizes);
    Declaration local = nullptr;
    Declaration parameter = nullptr;
    Declaration member = nullptr;  // of a struct or a uniform block
    // "vec3 shade(vec3 n, float k)". `params`: as parameter() makes them
    std::string (*signature)(std::string_view result, std::string_view name,
                             std::span<const std::string> params) = nullptr;
    // The line that opens a loop from `begin` up to `end`, which is not in it; "}" closes it.
    std::string (*loop)(std::string_view type, std::string_view index, std::string_view begin,
                        std::string_view end) = nullptr;
    // A branch of one statement, on one line: "if (a < 0.5) discard;"
    std::string (*only_where)(std::string_view condition, std::string_view statement) = nullptr;
    std::string (*open_struct)(std::string_view name) = nullptr;  // the line before "{"
    std::string_view member_end, close_struct;
    // Guards of the preprocessor. Null in a language that has none: it can print neither functions for pasting nor
    // keywords.
    std::string (*once)(std::string_view name) = nullptr;  // until end_guard, unless the name is defined
    std::string (*define)(std::string_view name, std::string_view value) = nullptr;
    std::string (*only_if)(std::string_view condition) = nullptr;
    std::string (*else_if)(std::string_view condition) = nullptr;
    std::string_view otherwise, end_guard;
};
extern const Syntax kCSyntax;  // of GLSL and HLSL (c/syntax.cpp)

struct Language {
    std::string_view name;
    const SpellingTable* spellings = nullptr;
    const Syntax* syntax = &kCSyntax;
    std::string_view half_suffix;
    bool matrices_by_columns = false;  // m[i] is a column, and constructors take columns

    // Numeric and opaque types: "vec3", "float3".
    std::string (*type_name)(ir::Type type) = nullptr;
    // The function that reads the bits of one scalar kind as another's.
    std::string_view (*bitcast)(ir::Scalar to, ir::Scalar from) = nullptr;
    // A vector whose components all equal the scalar.
    Text (*splat)(ir::Type type, const Text& scalar) = nullptr;
    // The initial value of an array with these elements.
    std::string (*array_value)(const std::string& element_type, std::size_t count,
                               const std::string& elements) = nullptr;
    std::string_view set_word;   // the text before the number of a descriptor set
    bool pads_blocks = true;     // the text must declare the space between members of a block
    std::string_view row_major;  // the text before a matrix that a block stores in rows; empty: the block says so
    // The name of a number that an included file defines as a constant; null: no such names.
    std::string_view (*name_of_number)(float number) = nullptr;
    std::string_view constant_array;  // the text before the type of a constant array
    // The expression that reads a value of a uniform block; null: its name.
    std::string (*read)(const Writer& writer, ir::GlobalId global, std::string_view name) = nullptr;
    // Prints the ops that the table marks as Own.
    Text (*expression)(const Body& body, ir::Value value) = nullptr;
    // Prints a value that needs statements of its own. False: the value is an ordinary expression.
    bool (*statement)(Body& body, ir::Value value) = nullptr;

    // Declarations.
    void (*preamble)(Writer& writer) = nullptr;  // version and extensions
    void (*block)(Writer& writer, const ir::UniformBlock& block) = nullptr;
    void (*resource)(Writer& writer, ir::GlobalId global) = nullptr;
    void (*keyword)(Writer& writer, ir::GlobalId global) = nullptr;
    // The preprocessor's test whether a keyword is on, or has this value. Null: the language has no keywords.
    std::string (*keyword_test)(const ir::Keyword& keyword, std::optional<std::size_t> value) = nullptr;
    EntryPoint (*entry_point)(Writer& writer) = nullptr;
};

}  // namespace patina::languages
