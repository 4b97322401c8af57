// Equations between expressions, written as equations: `{x + 0, x}`. A pattern is a small tree in prefix order, which
// the operators below build at compile time. identities.cpp matches and rewrites; the tests go through its table, so
// that every identity is tested.
//
//   constexpr Identity kExample = {select(c, x, x), x};
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "compiler/ir/ops.h"

namespace patina::ir {

struct Pattern {
    // What a variable stands for: x, y, z any value, i, j whole numbers, c, d bools, k, l, m, n constants.
    enum class Kind : std::uint8_t { Operation, Number, Any, Integer, Bool, Constant };
    struct Node {
        Kind kind = Kind::Number;
        Op op = Op::Constant;  // of an Operation, whose operands follow it
        std::uint8_t operands = 0;
        std::int8_t number = 0;  // of a Number, in every component; of a variable: which one
    };
    static constexpr std::size_t kMaxNodes = 12;

    std::array<Node, kMaxNodes> nodes{};
    std::size_t size = 0;

    constexpr Pattern() = default;
    constexpr Pattern(int number) : size(1) {
        nodes[0] = {.kind = Kind::Number, .number = static_cast<std::int8_t>(number)};
    }
    constexpr Pattern(Kind kind, int index) : size(1) {
        nodes[0] = {.kind = kind, .number = static_cast<std::int8_t>(index)};
    }
    template <class... Operands>
    static constexpr Pattern operation(Op op, const Operands&... operands) {
        Pattern made;
        made.nodes[made.size++] = {.kind = Kind::Operation, .op = op, .operands = sizeof...(Operands)};
        (made.add(operands), ...);
        return made;
    }

private:
    // An index beyond the array is no constant expression: a pattern that is too long does not compile.
    constexpr void add(const Pattern& operand) {
        for (std::size_t i = 0; i < operand.size; i++) nodes[size++] = operand.nodes[i];
    }
};

struct Identity {
    // Exact: both sides are equal for every operand, NaN and infinity included; only the sign of a zero may differ.
    // Rounded: equal within rounding, for finite operands. Regrouped: the same, but only for constants of a usual size,
    // because (x + 1e8) - 1e8 is meant to round. A value with a name is not regrouped, because readers must find it in
    // the text.
    enum class Holds : std::uint8_t { Exact, Rounded, Regrouped };
    Pattern left, right;
    Holds holds = Holds::Exact;
};

namespace pattern {

inline constexpr int kVariables = 11;
inline constexpr Pattern x{Pattern::Kind::Any, 0}, y{Pattern::Kind::Any, 1}, z{Pattern::Kind::Any, 2};
inline constexpr Pattern i{Pattern::Kind::Integer, 3}, j{Pattern::Kind::Integer, 4};
inline constexpr Pattern c{Pattern::Kind::Bool, 5}, d{Pattern::Kind::Bool, 6};
inline constexpr Pattern k{Pattern::Kind::Constant, 7}, l{Pattern::Kind::Constant, 8};
inline constexpr Pattern m{Pattern::Kind::Constant, 9}, n{Pattern::Kind::Constant, 10};

using P = Pattern;
constexpr P operator+(const P& a, const P& b) {
    return P::operation(Op::Add, a, b);
}
constexpr P operator-(const P& a, const P& b) {
    return P::operation(Op::Sub, a, b);
}
constexpr P operator*(const P& a, const P& b) {
    return P::operation(Op::Mul, a, b);
}
constexpr P operator/(const P& a, const P& b) {
    return P::operation(Op::Div, a, b);
}
constexpr P operator-(const P& a) {
    return P::operation(Op::Neg, a);
}
constexpr P operator<(const P& a, const P& b) {
    return P::operation(Op::Less, a, b);
}
constexpr P operator>(const P& a, const P& b) {
    return P::operation(Op::Greater, a, b);
}
constexpr P operator<=(const P& a, const P& b) {
    return P::operation(Op::LessEqual, a, b);
}
constexpr P operator>=(const P& a, const P& b) {
    return P::operation(Op::GreaterEqual, a, b);
}
constexpr P operator==(const P& a, const P& b) {
    return P::operation(Op::Equal, a, b);
}
constexpr P operator!=(const P& a, const P& b) {
    return P::operation(Op::NotEqual, a, b);
}
constexpr P operator&&(const P& a, const P& b) {
    return P::operation(Op::And, a, b);
}
constexpr P operator||(const P& a, const P& b) {
    return P::operation(Op::Or, a, b);
}
constexpr P operator!(const P& a) {
    return P::operation(Op::Not, a);
}
constexpr P operator&(const P& a, const P& b) {
    return P::operation(Op::BitAnd, a, b);
}
constexpr P operator|(const P& a, const P& b) {
    return P::operation(Op::BitOr, a, b);
}
constexpr P operator^(const P& a, const P& b) {
    return P::operation(Op::BitXor, a, b);
}
constexpr P operator~(const P& a) {
    return P::operation(Op::BitNot, a);
}
constexpr P operator<<(const P& a, const P& b) {
    return P::operation(Op::ShiftLeft, a, b);
}
constexpr P operator>>(const P& a, const P& b) {
    return P::operation(Op::ShiftRight, a, b);
}
constexpr P abs(const P& a) {
    return P::operation(Op::Abs, a);
}
constexpr P sign(const P& a) {
    return P::operation(Op::Sign, a);
}
constexpr P floor(const P& a) {
    return P::operation(Op::Floor, a);
}
constexpr P ceil(const P& a) {
    return P::operation(Op::Ceil, a);
}
constexpr P round(const P& a) {
    return P::operation(Op::Round, a);
}
constexpr P trunc(const P& a) {
    return P::operation(Op::Trunc, a);
}
constexpr P saturate(const P& a) {
    return P::operation(Op::Saturate, a);
}
constexpr P min(const P& a, const P& b) {
    return P::operation(Op::Min, a, b);
}
constexpr P max(const P& a, const P& b) {
    return P::operation(Op::Max, a, b);
}
constexpr P pow(const P& a, const P& b) {
    return P::operation(Op::Pow, a, b);
}
constexpr P clamp(const P& a, const P& low, const P& high) {
    return P::operation(Op::Clamp, a, low, high);
}
constexpr P lerp(const P& a, const P& b, const P& t) {
    return P::operation(Op::Lerp, a, b, t);
}
constexpr P select(const P& c, const P& a, const P& b) {
    return P::operation(Op::Select, c, a, b);
}
constexpr P any(const P& a) {
    return P::operation(Op::Any, a);
}
constexpr P all(const P& a) {
    return P::operation(Op::All, a);
}
constexpr P dot(const P& a, const P& b) {
    return P::operation(Op::Dot, a, b);
}
constexpr P normalize(const P& a) {
    return P::operation(Op::Normalize, a);
}
constexpr P transpose(const P& a) {
    return P::operation(Op::Transpose, a);
}

}  // namespace pattern

// All identities; those with the same op on the left side stand together.
std::span<const Identity> all_identities();

}  // namespace patina::ir
