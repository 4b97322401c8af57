#include "compiler/ir/fold/known.h"

#include "compiler/ir/fold/facts.h"

namespace patina::ir {
namespace {

// A limit may go if the value keeps it by itself. A value that may be NaN keeps at least one of its limits, because the
// limit turns NaN into a number.
Value least_of(std::span<const Value> args, const Range& a, const Range& b) {
    if (!a.may_be_nan && a.high <= b.low) return args[0];
    return !b.may_be_nan && b.high <= a.low ? args[1] : Value();
}
Value greatest_of(std::span<const Value> args, const Range& a, const Range& b) {
    if (!a.may_be_nan && a.low >= b.high) return args[0];
    return !b.may_be_nan && b.low >= a.high ? args[1] : Value();
}
bool is_between(const Range& x, double low, double high) {
    return !x.may_be_nan && x.low >= low && x.high <= high;
}

bool is_limit(Op op) {
    return op == Op::Min || op == Op::Max || op == Op::Clamp || op == Op::Saturate || op == Op::Abs;
}

// saturate() stays if it limits anything: it costs nothing in HLSL.
Value simpler_limit(Builder& b, Op op, Type type, std::span<const Value> args) {
    if (op != Op::Clamp && op != Op::Abs) return {};
    const FactsOf facts{b.module(), b.function()};
    const Range x = range_of(facts, args[0]);
    if (op == Op::Abs) return x.high <= 0 ? b.emit(Op::Neg, type, {args[0]}) : Value();
    const Range low = range_of(facts, args[1]), high = range_of(facts, args[2]);
    if (x.low >= low.high) return b.emit(Op::Min, type, {args[0], args[2]});
    const bool is_below = x.high <= high.low && low.high <= high.low;
    return is_below ? b.emit(Op::Max, type, {args[0], args[1]}) : Value();
}

// x - x, which is NaN if x is NaN or infinite.
bool is_zero(Builder& b, Op op, std::span<const Value> args) {
    return op == Op::Sub && args[0] == args[1] && range_of({b.module(), b.function()}, args[0]).is_finite();
}

}  // namespace

Value unchanged_operand(const FactsOf& facts, Op op, std::span<const Value> args) {
    if (op == Op::Normalize) return is_unit(facts, args[0]) ? args[0] : Value();
    if (!is_limit(op)) return {};
    const Range x = range_of(facts, args[0]);
    if (op == Op::Min) return least_of(args, x, range_of(facts, args[1]));
    if (op == Op::Max) return greatest_of(args, x, range_of(facts, args[1]));
    if (op == Op::Abs) return x.low >= 0 ? args[0] : Value();
    if (op == Op::Saturate) return is_between(x, 0, 1) ? args[0] : Value();
    return is_between(x, range_of(facts, args[1]).high, range_of(facts, args[2]).low) ? args[0] : Value();
}

Value simplify_known(Builder& b, Op op, Type type, std::span<const Value> args) {
    if (type.is_floating() && !type.is_matrix() && is_zero(b, op, args)) return b.splat_constant(type, 0);
    if ((!is_limit(op) && op != Op::Normalize) || !type.is_numeric()) return {};
    const Value same = unchanged_operand({b.module(), b.function()}, op, args);
    return same ? same : simpler_limit(b, op, type, args);
}

}  // namespace patina::ir
