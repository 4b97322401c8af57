// Decides where printed text needs parentheses: where its place requires a higher precedence than it has. The order is
// the one that GLSL and HLSL share with C.
//
//   a * (b + c)     the right side of * asks for Unary, a sum has Additive
#pragma once

#include <string>
#include <utility>

namespace patina::languages {

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

// The text, in parentheses if its place requires a higher precedence than it has.
inline std::string at_least(Precedence needed, Text t) {
    return t.precedence < needed ? "(" + t.text + ")" : std::move(t.text);
}

}  // namespace patina::languages
