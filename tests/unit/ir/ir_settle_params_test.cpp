// settle_params: which arguments move into the called function. ir_passes_meaning_test.cpp checks that the meaning
// stays the same.
#include "compiler/ir/dump.h"
#include "compiler/ir/passes/passes.h"
#include "tests/unit/ir/ir_testing.h"

namespace patina::ir {
namespace {

constexpr std::uint32_t kAmbient = 0, kOther = 1;

// f(x, c) = a long chain of x, plus c
FunctionId add_callee(Module& module) {
    module.globals = {{.name = "ambient", .type = kFloat4}, {.name = "other", .type = kFloat4}};
    return add(module, "f", {kX, {"c", kFloat, Rate::Uniform}}, kFloat, [](Builder& b) {
        return b.emit(Op::Add, {long_chain(b, b.param(0)), b.param(1)});
    });
}

Value part_of_global(Builder& b, std::uint32_t global, std::uint32_t component) {
    return b.extract(b.emit(Op::Global, kFloat4, {}, global), component);
}

// main(x) = f(x, first) + f(y, second), settled and pruned; how many parameters f has then.
std::size_t params_left(const Body& first, const Body& second) {
    Module module;
    const FunctionId f = add_callee(module);
    const FunctionId main = add(module, "main", {kX, kY}, kFloat, [&](Builder& b) {
        const Value one = b.call(f, std::vector{b.param(0), first(b)});
        return b.emit(Op::Add, {one, b.call(f, std::vector{b.param(1), second(b)})});
    });
    set_entry(module, main);
    module = checked(prune(settle_params(std::move(module))));
    return module.functions[0].params.size();
}

Body part(std::uint32_t global, std::uint32_t component) {
    return [=](Builder& b) { return part_of_global(b, global, component); };
}
Body number(double n) {
    return [=](Builder& b) { return b.constant(kFloat, {n}); };
}

TEST(SettleParams, TheSameConstantMovesIn) {
    EXPECT_EQ(params_left(number(3), number(3)), 1u);
    EXPECT_EQ(params_left(number(3), number(4)), 2u);
}

TEST(SettleParams, TheSamePartOfAGlobalMovesIn) {
    EXPECT_EQ(params_left(part(kAmbient, 1), part(kAmbient, 1)), 1u);
    EXPECT_EQ(params_left(part(kAmbient, 1), part(kAmbient, 2)), 2u);
    EXPECT_EQ(params_left(part(kAmbient, 1), part(kOther, 1)), 2u);
    EXPECT_EQ(params_left(part(kAmbient, 1), number(3)), 2u);
}

// What is computed of globals stays with the caller, which may do it once for several calls.
TEST(SettleParams, WorkStaysOutside) {
    const Body sine = [](Builder& b) { return b.emit(Op::Sin, {part_of_global(b, kAmbient, 1)}); };
    EXPECT_EQ(params_left(sine, sine), 2u);
}

// What stands in a text: tidy() settles, too.
TEST(SettleParams, IsAPartOfTidy) {
    Module module;
    const FunctionId f = add_callee(module);
    const FunctionId main = add(module, "main", {kX, kY}, kFloat, [&](Builder& b) {
        const Value one = b.call(f, std::vector{b.param(0), part_of_global(b, kAmbient, 1)});
        return b.emit(Op::Add, {one, b.call(f, std::vector{b.param(1), part_of_global(b, kAmbient, 1)})});
    });
    set_entry(module, main);
    module = checked(tidy(std::move(module)));
    ASSERT_EQ(module.functions.size(), 2u);
    EXPECT_EQ(module.functions[0].params.size(), 1u);
}

// A member that a called function fills with a constant, once the call is gone.
TEST(SettleMembers, AreSettledOnceMoreAfterInlining) {
    Module module;
    module.structs.push_back({"Light", {{"color", kFloat}, {"shadow", kFloat}}});
    const Type light = Type::structure(0);
    const FunctionId shadow = add(
        module, "shadow", {kX}, kFloat, [](Builder& b) { return b.constant(kFloat, {1}); }, false);
    const FunctionId make = add(
        module, "make", {kX}, light,
        [&](Builder& b) {
            const std::vector<Value> parts = {long_chain(b, b.param(0)), b.call(shadow, std::vector{b.param(0)})};
            return b.construct(light, parts);
        },
        false);
    const FunctionId main = add(
        module, "main", {kX, kY}, kFloat,
        [&](Builder& b) {
            Value sum = b.param(1);
            for (const std::uint32_t i : {0u, 1u}) {
                const Value made = b.call(make, std::vector{b.param(i)});
                sum = b.emit(Op::Add, {sum, b.emit(Op::Mul, {b.extract(made, 0), b.extract(made, 1)})});
            }
            return sum;
        },
        false);
    set_entry(module, main);
    module = checked(tidy(std::move(module)));
    const Function& entry = module[module.stage.entry];
    EXPECT_EQ(count(entry, Op::Mul), 0u) << dump(module);
}

}  // namespace
}  // namespace patina::ir
