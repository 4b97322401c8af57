// Values on their way from node to node of an imported material, as a graph writes them: numbers, a link, or an
// expression. Chains of arithmetic become one expression; only what is read twice, or is long, gets a name.
//
//   const Term tint = link("$_Tint", Type::Float4);
//   converted(tint, Type::Float3).text();             // "$_Tint.xyz"

#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/importers/expression_text.h"
#include "compiler/importers/gradient.h"
#include "compiler/importers/graph_writer.h"
#include "compiler/importers/types.h"

namespace patina::importers::terms {

struct Term {
    Type type = Type::None;
    std::vector<double> numbers{};  // of a constant, as many as its type has; else
    std::string base{};             // a link or an expression
    std::string swizzle{};          // behind it: "xyz"
    std::size_t base_width = 0;     // components of `base`, if there is a swizzle; 0: not known
    struct Part {
        std::string text;
        std::size_t width = 1;
    };
    std::vector<Part> parts{};                   // if `base` is float4(a, b, c): its arguments
    std::string from_top{};                      // of texture coordinates: the same with v counted from the top
    std::string tangent{};                       // of a normal in world space: a link to the same in tangent space
    bool is_color = false;                       // its components are called r, g, b, a
    std::string transform{};                     // of a texture that is read without its tiling: the node that says it
    std::string name{};                          // the id that it would get as a node
    std::set<std::size_t> nodes{};               // of the source, that are written in it
    std::optional<std::size_t> owner{};          // the node whose output it is, after which it can be named
    std::shared_ptr<const Gradient> gradient{};  // of a gradient, as long as it is a constant

    void add_nodes(const Term& part) { nodes.insert(part.nodes.begin(), part.nodes.end()); }  // of a part of it
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
// Stands for a value that cannot be imported, so that it is seen: magenta, 1, or the identity. For a sampler, a usual
// one.
Term stand_in(Type type);
Term link(std::string text, Type type);  // "$_Tint", "mask.r", "@uv0"
Term expression(std::string text, Type type);
Term parsed(std::string text, Type type);  // the same, but float3(a, b, c) and numbers are known as what they are

// The term in another type. What is missing is 0, but the fourth component is 1. Numbers stay numbers if
// `may_stay_number`, because an operator or a port converts them. Of a matrix, the first rows and columns. Without such
// a conversion: the type None.
Term converted(const Term& term, Type type, bool may_stay_number = false);
// Components of a vector: "x", "bgr"; '0' and '1' are these numbers.
Term swizzled(const Term& term, std::string_view components);
// The same texture coordinates, with v counted from the other side.
Term flipped(const Term& term);

}  // namespace patina::importers::terms
