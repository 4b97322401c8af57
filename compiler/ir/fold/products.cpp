#include "compiler/ir/fold/products.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/ir/fold/fold.h"

namespace patina::ir {
namespace {

// How many products back a factor is looked for.
constexpr int kDeepestProduct = 6;

// One factor for each component.
struct Factor {
    std::array<double, 4> numbers{};
    std::size_t count = 0;

    bool repeats(double number, double tolerance) const {
        return std::all_of(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count),
                           [&](double each) { return std::fabs(each - number) <= tolerance; });
    }
};

Factor factor_of(const Builder& b, Value constant) {
    const std::span<const double> numbers = b.constant_of(constant);
    Factor made{.count = numbers.size()};
    if (made.count > made.numbers.size()) return {};
    std::copy(numbers.begin(), numbers.end(), made.numbers.begin());
    return made;
}

template <class Combine>
Factor combined(const Factor& a, const Factor& b, const Combine& combine) {
    Factor made{.count = std::max(a.count, b.count)};
    for (std::size_t i = 0; i < made.count; i++)
        made.numbers[i] = combine(a.numbers[a.count == 1 ? 0 : i], b.numbers[b.count == 1 ? 0 : i]);
    return made;
}
Factor times(const Factor& a, const Factor& b) {
    return combined(a, b, [](double x, double y) { return x * y; });
}
Factor over(const Factor& a, const Factor& b) {
    return combined(a, b, [](double x, double y) { return x / y; });
}

// Far enough from zero and infinity that a product of two is exact but for rounding.
bool is_moderate(const Factor& factor, Scalar scalar) {
    const double most = scalar == Scalar::Half ? 0x1p12 : 0x1p60;
    return factor.count > 0 &&
           std::all_of(factor.numbers.begin(), factor.numbers.begin() + static_cast<std::ptrdiff_t>(factor.count),
                       [&](double each) { return std::fabs(each) <= most && std::fabs(each) >= 1 / most; });
}

// Multiplies a value by a factor by changing a constant factor of the value.
class Scaling {
public:
    explicit Scaling(Builder& b) : b_(b) {}

    // a * (x * pi) where a has a factor 1 / pi. The rest of the value, with the factor that has been taken out of it.
    Value without_factor(Value value, Factor& factor) {
        const Inst& inst = b_[value];
        if (inst.op == Op::Construct && inst.type.is_vector() && inst.operand_count == 1) {
            const unsigned width = inst.type.width();
            const Value rest = without_factor(b_.args(value)[0], factor);
            return rest ? b_.splat(rest, width) : Value();
        }
        if (inst.op != Op::Mul || inst.type.is_matrix()) return {};
        for (const std::size_t i : {1u, 0u}) {
            factor = factor_of(b_, b_.args(value)[i]);
            if (factor.count > 0) return b_.args(value)[1 - i];
        }
        return {};
    }

    // Nothing if the value has no constant factor. If the factor is in a value with a name, or behind the first
    // product, the constants must cancel. A named value must stay readable, and the values between are computed twice
    // if something else reads them, too.
    Value scaled(Value value, const Factor& by, int depth = 0) {
        const Inst inst = b_[value];
        if (depth >= kDeepestProduct || inst.operand_count > 2 || inst.operand_count == 0) return {};
        const std::array<Value, 2> args = {b_.args(value)[0], b_.args(value)[inst.operand_count - 1]};
        const auto again = [&](Value first, Value second) { return b_.emit(inst.op, inst.type, {first, second}); };
        if (inst.op == Op::Mul) {
            for (const std::size_t i : {1u, 0u}) {
                const Factor own = factor_of(b_, args[i]);
                if (own.count > 0)
                    return with_factor(args[1 - i], inst.type, own, times(own, by), may_merge(inst, depth));
            }
            if (const Value made = scaled(args[0], by, depth + 1)) return again(made, args[1]);
            const Value made = scaled(args[1], by, depth + 1);
            return made ? again(args[0], made) : Value();
        }
        if (inst.op == Op::Div) {
            if (const Factor own = factor_of(b_, args[1]); own.count > 0)
                return with_factor(args[0], inst.type, own, over(by, own), may_merge(inst, depth));
            if (const Factor own = factor_of(b_, args[0]); own.count > 0) {
                const Factor made = times(own, by);
                return is_one(made, inst.type) ? again(constant(inst.type, made), args[1]) : Value();
            }
            const Value made = scaled(args[0], by, depth + 1);
            return made ? again(made, args[1]) : Value();
        }
        if (inst.op == Op::Neg) {
            const Value made = scaled(args[0], by, depth + 1);
            return made ? b_.emit(Op::Neg, inst.type, {made}) : Value();
        }
        const bool is_splat = inst.op == Op::Construct && inst.type.is_vector() && inst.operand_count == 1;
        if (!is_splat || !by.repeats(by.numbers[0], 0)) return {};
        const Value made = scaled(args[0], Factor{.numbers = {by.numbers[0]}, .count = 1}, depth + 1);
        return made ? b_.splat(made, inst.type.width()) : Value();
    }

private:
    static bool may_merge(const Inst& product, int depth) { return depth == 0 && !product.name; }
    Value with_factor(Value rest, Type type, const Factor& own, const Factor& made, bool may_merge) {
        if (!is_moderate(own, type.scalar) || !is_moderate(made, type.scalar)) return {};
        if (is_one(made, type)) return rest;
        return may_merge ? b_.emit(Op::Mul, type, {rest, constant(type, made)}) : Value();
    }
    // pi * (1 / pi) is 1 but for rounding.
    static bool is_one(const Factor& factor, Type type) {
        return factor.repeats(1, type.scalar == Scalar::Half ? 0x1p-9 : 0x1p-22);
    }
    Value constant(Type type, const Factor& factor) {
        if (factor.count == 1) return b_.splat_constant(type, factor.numbers[0]);
        return b_.constant(type, std::span<const double>(factor.numbers.data(), factor.count));
    }

    Builder& b_;
};

}  // namespace

Value simplify_product(Builder& b, Op op, Type type, std::span<const Value> args) {
    if (!type.is_floating() || type.is_matrix()) return {};
    for (const std::size_t i : {1u, 0u}) {
        if (b[args[i]].op != Op::Constant || (op == Op::Div && i == 0)) continue;
        const Factor factor = factor_of(b, args[i]);
        if (!is_moderate(factor, type.scalar)) return {};
        const Factor one{.numbers = {1}, .count = 1};
        return Scaling(b).scaled(args[1 - i], op == Op::Div ? over(one, factor) : factor);
    }
    for (const std::size_t i : {1u, 0u}) {
        if (op != Op::Mul) return {};
        Factor factor;
        const Value rest = Scaling(b).without_factor(args[i], factor);
        if (!rest || !is_moderate(factor, type.scalar)) continue;
        // The factors must cancel.
        if (const Value other = Scaling(b).scaled(args[1 - i], factor, 1)) {
            return i == 1 ? b.emit(Op::Mul, type, {other, rest}) : b.emit(Op::Mul, type, {rest, other});
        }
    }
    return {};
}

}  // namespace patina::ir
