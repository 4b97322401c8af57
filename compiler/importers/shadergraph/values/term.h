// A value on its way from slot to slot, as a graph of Patina writes it: numbers, a link, or an expression.
//
//   Term tint = link("$_Tint", Type::Float4);
//   converted(tint, Type::Float3).text();       // "$_Tint.xyz"
//   converted(number_term(0.5), Type::Float3);       // 0.5, which serves as a vector
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/importers/expression_text.h"
#include "compiler/importers/graph_writer.h"
#include "compiler/importers/shadergraph/values/types.h"

namespace patina::importers::shadergraph {

using terms::arguments_of;
using terms::at_least;
using terms::bracketed;
using terms::camel_case;
using terms::digits;
using terms::identifier;
using terms::Names;
using terms::Precedence;
using terms::precedence_of;
using enum terms::Precedence;

struct Gradient {
    struct Key {
        double time = 0;
        std::vector<double> value{};  // a colour as a picker shows it, or an alpha
    };
    std::vector<Key> colors{}, alphas{};
    int mode = 0;  // 0 blend, 1 fixed, 2 perceptual
    bool is_perceptual() const { return mode == 2; }
};
// At a port or as a default: the keys as a picker shows them, but linear if the gradient is perceptual.
Value gradient_value(const Gradient& gradient);

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
    bool is_color = false;                       // its components are called r, g, b, a
    std::vector<std::size_t> nodes{};            // of the source, that are written in it; each once
    std::optional<std::size_t> owner{};          // the node whose output it is, after which it can be named
    std::shared_ptr<const Gradient> gradient{};  // of a property: its default

    void add_nodes(const Term& part);  // those of what is a part of it
    bool is_constant() const { return !numbers.empty(); }
    std::string text() const;  // as a part of an expression: "float3(1, 0, 0)", "mask.x", "a + b"
    bool is_link() const;      // a name with or without a port and a swizzle
    Value value() const;       // at a port
};

Term number_term(double value);
Term constant(std::vector<double> values);  // one to four: a number or a vector
Term flag_term(bool value);
// Stands for a value that cannot be imported, so that it is seen: magenta, 1, or the identity. For a sampler, a usual
// one.
Term stand_in(Type type);
Term link(std::string text, Type type);  // "$_Tint", "mask.r", "@uv0"
Term expression(std::string text, Type type);

// The term in the type that an edge or a slot asks for; numbers keep for vectors if `may_stay_number`, because an
// operator or a port converts them. A conversion that does not exist gives the type None.
Term converted(const Term& term, Type type, bool may_stay_number = false);
// Components of a vector: "x", "zyx".
Term swizzled(const Term& term, std::string_view components);
// A vector of numbers and vectors, which are as many components as its type has: "float3(a, b.xy)". Constants, and
// components of one vector that are together again, become shorter: "a.xyz".
Term vector_term(Type type, std::span<const Term> arguments);
// The same texture coordinates, with v counted from the other side.
Term flipped(const Term& term);

double linear(double srgb);  // a component of a colour

}  // namespace patina::importers::shadergraph
