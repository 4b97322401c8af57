// Ops that work component by component, and conversions: tables from an op to its meaning, one line each.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "compiler/base/bits.h"
#include "compiler/interpret/kernels.h"
#include "compiler/interpret/rounding.h"

namespace patina::interpret {
namespace {

using ir::Op;
using ir::Scalar;

template <class Number>
Number load(const double* from, std::size_t i) {
    return static_cast<Number>(from[i]);
}

// Calls the meaning F with the operands' components in Number, as many as it takes.
template <class Number, class F, class Store>
void map(const Step& step, Machine& machine, Store store) {
    constexpr F f{};
    const double* a = machine.at(step.from[0]);
    const double* b = machine.at(step.from[1]);
    const double* c = machine.at(step.from[2]);
    double* to = machine.at(step.to);
    for (std::size_t i = 0; i < std::size_t{step.count} * kLanes; ++i) {
        if constexpr (std::is_invocable_v<F, Number>) {
            to[i] = store(f(load<Number>(a, i)));
        } else if constexpr (std::is_invocable_v<F, Number, Number>) {
            to[i] = store(f(load<Number>(a, i), load<Number>(b, i)));
        } else {
            to[i] = store(f(load<Number>(a, i), load<Number>(b, i), load<Number>(c, i)));
        }
    }
}

template <class Number, class F>
void map_real(const Step& step, Machine& machine) {
    map<Number, F>(step, machine, [](auto result) { return static_cast<double>(result); });
}

template <Scalar scalar, class F>
void map_whole(const Step& step, Machine& machine) {
    map<std::int64_t, F>(step, machine, [](std::int64_t result) { return wrap(scalar, result); });
}

struct Meaning {
    Op op;
    Kernel first;   // reals: in double; whole numbers: of ints
    Kernel second;  // reals: in float; whole numbers: of uints
};
template <class F>
constexpr Meaning real(Op op, F) {
    return {op, map_real<double, F>, map_real<float, F>};
}
template <class F>
constexpr Meaning whole(Op op, F) {
    return {op, map_whole<Scalar::Int, F>, map_whole<Scalar::Uint, F>};
}

// Of a NaN and a number, min and max return the number, as IEEE 754's minNum and most GPUs do. So clamp and saturate of
// NaN return the lower limit. Not std::fmin: the call costs ten times the comparison.
constexpr auto minimum = [](auto x, auto y) { return y < x || x != x ? y : x; };
constexpr auto maximum = [](auto x, auto y) { return x < y || x != x ? y : x; };
constexpr auto saturate = [](auto x) { return minimum(maximum(x, decltype(x)(0)), decltype(x)(1)); };
constexpr auto smoothstep = [](auto edge0, auto edge1, auto x) {
    const auto t = saturate((x - edge0) / (edge1 - edge0));
    return t * t * (3 - 2 * t);
};

// --- floats; also what integers and bools share with them: comparisons, and choosing one of the operands

constexpr Meaning kReals[] = {
    real(Op::Add, [](auto x, auto y) { return x + y; }),
    real(Op::Sub, [](auto x, auto y) { return x - y; }),
    real(Op::Mul, [](auto x, auto y) { return x * y; }),
    real(Op::Div, [](auto x, auto y) { return x / y; }),
    real(Op::Mod, [](auto x, auto y) { return x - y * std::trunc(x / y); }),
    real(Op::Neg, [](auto x) { return -x; }),
    real(Op::Less, [](auto x, auto y) { return x < y; }),
    real(Op::LessEqual, [](auto x, auto y) { return x <= y; }),
    real(Op::Greater, [](auto x, auto y) { return x > y; }),
    real(Op::GreaterEqual, [](auto x, auto y) { return x >= y; }),
    real(Op::Equal, [](auto x, auto y) { return x == y; }),
    real(Op::NotEqual, [](auto x, auto y) { return x != y; }),
    real(Op::And, [](auto x, auto y) { return x != 0 && y != 0; }),
    real(Op::Or, [](auto x, auto y) { return x != 0 || y != 0; }),
    real(Op::Not, [](auto x) { return x == 0; }),
    real(Op::Abs, [](auto x) { return std::fabs(x); }),
    real(Op::Sign, [](auto x) { return (x > 0) - (x < 0); }),
    real(Op::Floor, [](auto x) { return std::floor(x); }),
    real(Op::Ceil, [](auto x) { return std::ceil(x); }),
    real(Op::Round, [](auto x) { return std::nearbyint(x); }),  // in the default mode: halves to even
    real(Op::Trunc, [](auto x) { return std::trunc(x); }),
    real(Op::Frac, [](auto x) { return x - std::floor(x); }),
    real(Op::Saturate, saturate),
    real(Op::Sqrt, [](auto x) { return std::sqrt(x); }),
    real(Op::Rsqrt, [](auto x) { return 1 / std::sqrt(x); }),
    real(Op::Exp, [](auto x) { return std::exp(x); }),
    real(Op::Exp2, [](auto x) { return std::exp2(x); }),
    real(Op::Log, [](auto x) { return std::log(x); }),
    real(Op::Log2, [](auto x) { return std::log2(x); }),
    real(Op::Sin, [](auto x) { return std::sin(x); }),
    real(Op::Cos, [](auto x) { return std::cos(x); }),
    real(Op::Tan, [](auto x) { return std::tan(x); }),
    real(Op::Asin, [](auto x) { return std::asin(x); }),
    real(Op::Acos, [](auto x) { return std::acos(x); }),
    real(Op::Atan, [](auto x) { return std::atan(x); }),
    real(Op::Sinh, [](auto x) { return std::sinh(x); }),
    real(Op::Cosh, [](auto x) { return std::cosh(x); }),
    real(Op::Tanh, [](auto x) { return std::tanh(x); }),
    real(Op::Radians, [](auto x) { return x * decltype(x)(std::numbers::pi / 180); }),
    real(Op::Degrees, [](auto x) { return x * decltype(x)(180 / std::numbers::pi); }),
    real(Op::Min, minimum),
    real(Op::Max, maximum),
    // GPUs compute exp2(y log2 x), which is NaN for a negative x.
    real(Op::Pow, [](auto x, auto y) { return x < 0 && y != 0 ? decltype(x)(NAN) : std::pow(x, y); }),
    real(Op::Atan2, [](auto y, auto x) { return std::atan2(y, x); }),
    real(Op::Step, [](auto edge, auto x) { return x >= edge; }),
    real(Op::Clamp, [](auto x, auto low, auto high) { return minimum(maximum(x, low), high); }),
    real(Op::Lerp, [](auto a, auto b, auto t) { return a + (b - a) * t; }),
    real(Op::Smoothstep, smoothstep),
    real(Op::IsNan, [](auto x) { return std::isnan(x); }),
    real(Op::IsInf, [](auto x) { return std::isinf(x); }),
};

// --- int and uint, computed in 64 bits; the result is wrapped to 32. Other ops of integers use the functions of
// floats: every integer is exact in a double.

using Wide = std::int64_t;
constexpr auto wide_product = [](Wide x, Wide y) {
    return static_cast<Wide>(static_cast<std::uint64_t>(x) * static_cast<std::uint64_t>(y));
};

constexpr Meaning kWholes[] = {
    whole(Op::Add, [](Wide x, Wide y) { return x + y; }),
    whole(Op::Sub, [](Wide x, Wide y) { return x - y; }),
    whole(Op::Mul, wide_product),
    // All bits set is what Direct3D gives for a division by zero.
    whole(Op::Div, [](Wide x, Wide y) { return y == 0 ? Wide{-1} : x / y; }),
    whole(Op::Mod, [](Wide x, Wide y) { return y == 0 ? Wide{-1} : x % y; }),
    whole(Op::Neg, [](Wide x) { return -x; }),
    whole(Op::Abs, [](Wide x) { return x < 0 ? -x : x; }),
    whole(Op::BitAnd, [](Wide x, Wide y) { return x & y; }),
    whole(Op::BitOr, [](Wide x, Wide y) { return x | y; }),
    whole(Op::BitXor, [](Wide x, Wide y) { return x ^ y; }),
    whole(Op::BitNot, [](Wide x) { return ~x; }),
    // Only the low five bits of the distance count, as on every GPU.
    whole(Op::ShiftLeft, [](Wide x, Wide y) { return static_cast<Wide>(static_cast<std::uint64_t>(x) << (y & 31)); }),
    whole(Op::ShiftRight, [](Wide x, Wide y) { return x >> (y & 31); }),
};

template <std::size_t N>
constexpr auto by_op(const Meaning (&rows)[N]) {
    std::array<const Meaning*, ir::kOpCount> table{};
    for (const Meaning& row : rows) table[static_cast<std::size_t>(row.op)] = &row;
    return table;
}
constexpr auto kRealOf = by_op(kReals);
constexpr auto kWholeOf = by_op(kWholes);

template <Scalar to, Precision precision>
void convert(const Step& step, Machine& machine) {
    const double* from = machine.at(step.from[0]);
    double* result = machine.at(step.to);
    for (std::size_t i = 0; i < std::size_t{step.count} * kLanes; ++i) result[i] = fit(to, precision, from[i]);
}

template <Scalar to>
void rewrap(const Step& step, Machine& machine) {
    const double* from = machine.at(step.from[0]);
    double* result = machine.at(step.to);
    for (std::size_t i = 0; i < std::size_t{step.count} * kLanes; ++i) result[i] = wrap(to, load<Wide>(from, i));
}

template <Precision precision>
Kernel conversion_to(Scalar to) {
    switch (to) {
        case Scalar::Bool: return convert<Scalar::Bool, precision>;
        case Scalar::Int: return convert<Scalar::Int, precision>;
        case Scalar::Uint: return convert<Scalar::Uint, precision>;
        case Scalar::Half: return convert<Scalar::Half, precision>;
        case Scalar::Float: return convert<Scalar::Float, precision>;
    }
    return nullptr;
}

// The bits of a value are those of its float, even where the computation goes on in double.
template <Scalar from, Scalar to>
void reinterpret(const Step& step, Machine& machine) {
    const double* values = machine.at(step.from[0]);
    double* result = machine.at(step.to);
    for (std::size_t i = 0; i < std::size_t{step.count} * kLanes; ++i) {
        const auto bits = from == Scalar::Float ? bits_as<std::uint32_t>(load<float>(values, i))
                                                : static_cast<std::uint32_t>(load<Wide>(values, i));
        result[i] = to == Scalar::Float ? static_cast<double>(bits_as<float>(bits)) : wrap(to, bits);
    }
}

bool is_integer(Scalar scalar) {
    return scalar == Scalar::Int || scalar == Scalar::Uint;
}

}  // namespace

Kernel arithmetic_kernel(Op op, Scalar scalar, Precision precision) {
    const auto row = static_cast<std::size_t>(op);
    if (is_integer(scalar) && kWholeOf[row]) {
        return scalar == Scalar::Int ? kWholeOf[row]->first : kWholeOf[row]->second;
    }
    if (!kRealOf[row]) return nullptr;
    const bool in_float = scalar == Scalar::Float && precision == Precision::Float;
    return in_float ? kRealOf[row]->second : kRealOf[row]->first;
}

Kernel conversion_kernel(Scalar from, Scalar to, Precision precision) {
    if (is_integer(from) && is_integer(to)) return to == Scalar::Int ? rewrap<Scalar::Int> : rewrap<Scalar::Uint>;
    return precision == Precision::Float ? conversion_to<Precision::Float>(to) : conversion_to<Precision::Double>(to);
}

Kernel bitcast_kernel(Scalar from, Scalar to) {
    if (from == Scalar::Float) {
        return to == Scalar::Int ? reinterpret<Scalar::Float, Scalar::Int> : reinterpret<Scalar::Float, Scalar::Uint>;
    }
    if (to == Scalar::Float) return reinterpret<Scalar::Int, Scalar::Float>;
    return to == Scalar::Int ? rewrap<Scalar::Int> : rewrap<Scalar::Uint>;
}

}  // namespace patina::interpret
