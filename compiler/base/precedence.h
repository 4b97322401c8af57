// How strongly operators bind: the order that the node language, GLSL and HLSL share with C. Printers put parentheses
// where a place requires a higher precedence than a text has.
//
//   a * (b + c)     the right side of * requires Unary, and a sum has Additive
#pragma once

#include <string_view>

namespace patina {

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

// Of an operator with two operands, all of which group to the left; Any: it is not one.
constexpr Precedence binary_precedence(std::string_view op) {
    struct Operator {
        std::string_view text;
        Precedence precedence;
    };
    constexpr Operator kOperators[] = {
        {"||", Precedence::LogicalOr},     {"&&", Precedence::LogicalAnd},    {"|", Precedence::BitOr},
        {"^", Precedence::BitXor},         {"&", Precedence::BitAnd},         {"==", Precedence::Equality},
        {"!=", Precedence::Equality},      {"<", Precedence::Relational},     {">", Precedence::Relational},
        {"<=", Precedence::Relational},    {">=", Precedence::Relational},    {"<<", Precedence::Shift},
        {">>", Precedence::Shift},         {"+", Precedence::Additive},       {"-", Precedence::Additive},
        {"*", Precedence::Multiplicative}, {"/", Precedence::Multiplicative}, {"%", Precedence::Multiplicative}};
    for (const Operator& each : kOperators)
        if (each.text == op) return each.precedence;
    return Precedence::Any;
}

}  // namespace patina
