// Values on their way from node to node of an imported material, as a graph writes them: numbers, a link, or an
// expression. Chains of arithmetic become one expression; only what is read twice, or is long, gets a name.
//
//   const Term tint = link("$_Tint", Type::Float4);
//   converted(tint, Type::Float3).text();                              // "$_Tint.xyz"
//   computed("lerp(a, b, 0.5)", {tint, number_term(1)}, Type::Float4)  // "lerp($_Tint, 1, 0.5)": patterns.h
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/importers/gradient.h"
#include "compiler/importers/names.h"
#include "compiler/importers/types.h"
#include "compiler/nodelang/tree.h"

namespace patina::importers::terms {

using nodelang::Tree;

struct Term {
    Type type = Type::None;
    std::vector<double> numbers{};               // of a constant, as many as its type has; else
    Tree tree{};                                 // what computes it
    std::vector<std::size_t> widths{};           // if `tree` is float4(a, b, c): the components of its parts
    std::size_t whole_width = 0;                 // if swizzled() made `tree`: the components of what is swizzled
    Tree from_top{};                             // of texture coordinates: the same with v counted from the top
    Tree tangent{};                              // of a normal in world space: a link to the same in tangent space
    bool is_color = false;                       // its components are called r, g, b, a
    std::string transform{};                     // of a texture that is read without its tiling: the node that says it
    std::string name{};                          // the id that it would get as a node
    std::set<std::size_t> nodes{};               // of the source, that are written in it
    std::optional<std::size_t> owner{};          // the node whose output it is, after which it can be named
    std::shared_ptr<const Gradient> gradient{};  // of a gradient, as long as it is a constant

    void add_nodes(const Term& part) { nodes.insert(part.nodes.begin(), part.nodes.end()); }  // of a part of it
    bool is_constant() const { return !numbers.empty(); }
    bool is_all(double value) const;  // a constant whose components are all that
    Tree expression() const;          // as a part of an expression; without a value, nothing that compiles
    std::string text() const;         // the same: "float3(1, 0, 0)", "mask.x", "a + b"
    bool is_link() const;             // a name with or without a port and a swizzle
    bool is_short() const;            // it is written again where it is read
    GraphValue value() const;         // at a port

    // What a swizzle reads, and its components: "mask" and "xy".
    Tree whole() const { return whole_width > 0 ? nodelang::arg(tree, 0) : expression(); }
    std::string_view components() const { return whole_width > 0 ? tree->text : std::string_view(); }
    // With another value, which is what it is for its readers. `widths`: as above.
    Term with(Tree other, Type other_type, std::vector<std::size_t> its_widths = {}) const;
};

Term number_term(double value);
Term constant(std::vector<double> values);  // one to four: a number or a vector
Term flag_term(bool value);
Term white();  // in the place of a texture that is not there
// Stands for a value that cannot be imported, so that it is seen: magenta, 1, or the identity. For a sampler, a usual
// one.
Term stand_in(Type type);
Term of_tree(Tree tree, Type type);                 // float3(a, b, c) and numbers are known as what they are
Term link(std::string_view text, Type type);        // "$_Tint", "mask.r", "@uv0"
Term color_link(std::string_view text);             // of four components, which are called r, g, b, a
Term expression(std::string_view text, Type type);  // of_tree() of its text

// The term in another type. What is missing is 0, but the fourth component is 1. Numbers stay numbers if
// `may_stay_number`, because an operator or a port converts them. Of a matrix, the first rows and columns. Without such
// a conversion: the type None.
Term converted(const Term& term, Type type, bool may_stay_number = false);
// Components of a vector: "x", "bgr"; '0' and '1' are these numbers.
Term swizzled(const Term& term, std::string_view components);
// A call of the type with the terms: float3(a, b.x). Components of one value that follow each other are joined.
Term vector_of(Type type, std::span<const Term> terms);
// The same texture coordinates, with v counted from the other side.
Term flipped(const Term& term);

}  // namespace patina::importers::terms
