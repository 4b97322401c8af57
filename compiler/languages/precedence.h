// How tightly a piece of printed text holds together, in the order that GLSL and HLSL share with C. Text goes into
// parentheses where its place asks for a higher precedence than it has, and nowhere else.
//
//   a * (b + c)     the right side of * asks for Unary, a sum has Additive
#pragma once

#include <string>
#include <utility>

namespace patina::targets {

enum class Precedence : unsigned char {
    Any,  // an argument, an initial value
    Ternary,
    LogicalOr,
    LogicalAnd,
    BitOr,
    BitXor,
    BitAnd,
    Equality,
    Relational,
    Shift,
    Additive,
    Multiplicative,
    Unary,
    Postfix,
    Primary,
};

// The precedence that the right operand of a left-associative operator needs.
constexpr Precedence above(Precedence p) {
    return static_cast<Precedence>(static_cast<unsigned char>(p) + 1);
}

struct Text {
    std::string text;
    Precedence precedence = Precedence::Primary;
};

// The text, in parentheses if its place asks for more than it has.
inline std::string at_least(Precedence needed, Text t) {
    return t.precedence < needed ? "(" + t.text + ")" : std::move(t.text);
}

}  // namespace patina::targets
