// drop_needless: limits that the arguments of all calls keep by themselves, and unit vectors that are normalised again.
#include "compiler/ir/passes/passes.h"
#include "tests/unit/ir/ir_testing.h"

namespace patina::ir {
namespace {

// weight(c) = a long chain of saturate(1 - c), as Schlick's
FunctionId add_weight(Module& module) {
    return add(module, "weight", {kX}, kFloat, [](Builder& b) {
        const Value rest = b.emit(Op::Sub, {b.constant(kFloat, {1}), b.param(0)});
        return long_chain(b, b.emit(Op::Saturate, {rest}));
    });
}

// The limits that are left in weight() when it is called with these two arguments.
std::size_t limits_left(const Body& first, const Body& second) {
    Module module;
    const FunctionId weight = add_weight(module);
    const FunctionId main = add(module, "main", {kX, kY}, kFloat, [&](Builder& b) {
        const Value one = b.call(weight, std::vector{first(b)});
        return b.emit(Op::Add, {one, b.call(weight, std::vector{second(b)})});
    });
    set_entry(module, main);
    module = checked(drop_needless(std::move(module)));
    return count(module.functions[0], Op::Saturate);
}

Body saturated(std::uint32_t param) {
    return [=](Builder& b) { return b.emit(Op::Saturate, {b.param(param)}); };
}
Body plain(std::uint32_t param) {
    return [=](Builder& b) { return b.param(param); };
}

TEST(DropNeedless, ALimitThatAllArgumentsKeep) {
    EXPECT_EQ(limits_left(saturated(0), saturated(1)), 0u);
    EXPECT_EQ(limits_left(saturated(0), plain(1)), 1u);
}

// 1 - c is between 0 and 1 only if c is; from -1 to 1 it reaches 2.
TEST(DropNeedless, ALimitThatAnArgumentMayBreakStays) {
    const Body signed_cosine = [](Builder& b) {
        return b.emit(Op::Clamp, {b.param(0), b.constant(kFloat, {-1}), b.constant(kFloat, {1})});
    };
    EXPECT_EQ(limits_left(saturated(0), signed_cosine), 1u);
}

TEST(DropNeedless, AVectorThatAllCallersHaveNormalised) {
    for (const bool is_unit : {true, false}) {
        Module module;
        const FunctionId f = add(module, "f", {{"n", kFloat3, Rate::Pixel}}, kFloat, [](Builder& b) {
            return long_chain(b, b.extract(b.emit(Op::Normalize, {b.param(0)}), 0));
        });
        const FunctionId main = add(module, "main", {{"n", kFloat3, Rate::Pixel}}, kFloat, [&](Builder& b) {
            const Value n = is_unit ? b.emit(Op::Normalize, {b.param(0)}) : b.param(0);
            return b.call(f, std::vector{n});
        });
        set_entry(module, main);
        module = checked(drop_needless(std::move(module)));
        EXPECT_EQ(count(module.functions[0], Op::Normalize), is_unit ? 0u : 1u);
    }
}

// n / sqrt(max(n.n, 1e-7)), as nodes normalise a vector that may be zero.
TEST(DropNeedless, TheLengthOfAUnitVector) {
    for (const bool is_unit : {true, false}) {
        Module module;
        const FunctionId f = add(module, "f", {{"n", kFloat3, Rate::Pixel}}, kFloat3, [](Builder& b) {
            const Value squared = b.emit(Op::Dot, {b.param(0), b.param(0)});
            const Value limited = b.emit(Op::Max, {squared, b.constant(kFloat, {1e-7})});
            return b.emit(Op::Mul, {b.param(0), b.splat(b.emit(Op::Rsqrt, {limited}), 3)});
        });
        const FunctionId main = add(module, "main", {{"n", kFloat3, Rate::Pixel}}, kFloat3, [&](Builder& b) {
            return b.call(f, std::vector{is_unit ? b.emit(Op::Normalize, {b.param(0)}) : b.param(0)});
        });
        set_entry(module, main);
        module = checked(drop_needless(std::move(module)));
        EXPECT_EQ(count(module.functions[0], Op::Mul), is_unit ? 0u : 1u);
        EXPECT_EQ(count(module.functions[0], Op::Rsqrt), is_unit ? 0u : 1u);
    }
}

}  // namespace
}  // namespace patina::ir
