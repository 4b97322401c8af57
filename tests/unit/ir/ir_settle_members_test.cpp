// settle_members: which members are constants for their readers. ir_passes_meaning_test.cpp checks that the meaning
// stays the same.
#include "compiler/ir/passes/passes.h"
#include "tests/unit/ir/ir_testing.h"

namespace patina::ir {
namespace {

// make(x) -> {a: x, b: number}
FunctionId add_maker(Module& module, const std::string& name, double number) {
    if (module.structs.empty()) module.structs.push_back({"Two", {{"a", kFloat}, {"b", kFloat}}});
    return add(module, name, {kX}, Type::structure(0), [&](Builder& b) {
        const std::vector<Value> parts = {b.param(0), b.constant(kFloat, {number})};
        return b.construct(Type::structure(0), parts);
    });
}

// read(x) = make(x).b + make(x).a
FunctionId add_reader(Module& module, const std::string& name, FunctionId maker) {
    return add(module, name, {kX}, kFloat, [&](Builder& b) {
        const Value made = b.call(maker, std::vector{b.param(0)});
        return b.emit(Op::Add, {b.extract(made, 1), b.extract(made, 0)});
    });
}

TEST(SettleMembers, WhatIsAlwaysTheSameIsAConstant) {
    Module module;
    const FunctionId reader = add_reader(module, "read", add_maker(module, "make", 3));
    module = checked(settle_members(std::move(module)));
    EXPECT_EQ(count(module[reader], Op::Extract), 1u);
    EXPECT_EQ(count(module[reader], Op::Constant), 1u);
}

TEST(SettleMembers, AnotherValueAnywhereKeepsIt) {
    for (const double other : {4.0, -3.0}) {
        Module module;
        const FunctionId reader = add_reader(module, "read", add_maker(module, "make", 3));
        add_maker(module, "other", other);
        module = checked(settle_members(std::move(module)));
        EXPECT_EQ(count(module[reader], Op::Extract), 2u) << other;
    }
    // 0 is not -0.
    Module module;
    const FunctionId reader = add_reader(module, "read", add_maker(module, "make", 0.0));
    add_maker(module, "other", -0.0);
    module = checked(settle_members(std::move(module)));
    EXPECT_EQ(count(module[reader], Op::Extract), 2u);
}

TEST(SettleMembers, AnInsertIsAnotherValue) {
    Module module;
    const FunctionId maker = add_maker(module, "make", 3);
    const FunctionId reader = add_reader(module, "read", maker);
    add(module, "change", {kX}, Type::structure(0), [&](Builder& b) {
        const Value made = b.call(maker, std::vector{b.param(0)});
        return b.emit(Op::Insert, Type::structure(0), {made, b.param(0)}, 1);
    });
    module = checked(settle_members(std::move(module)));
    EXPECT_EQ(count(module[reader], Op::Extract), 2u);
}

TEST(SettleMembers, WhatOtherTextsMakeOrReadStays) {
    for (const Linkage linkage : {Linkage::Exported, Linkage::Foreign}) {
        Module module;
        const FunctionId reader = add_reader(module, "read", add_maker(module, "make", 3));
        const FunctionId taker = add(module, "take", {{"two", Type::structure(0), Rate::Pixel}}, kFloat,
                                     [](Builder& b) { return b.constant(kFloat, {0}); });
        module[taker].linkage = linkage;
        module = settle_members(std::move(module));
        EXPECT_EQ(count(module[reader], Op::Extract), 2u);
    }
}

TEST(SettleMembers, AMemberMayBeWhatAnotherStructGets) {
    Module module;
    const FunctionId maker = add_maker(module, "make", 3);
    module.structs.push_back({"Other", {{"c", kFloat}, {"d", kFloat}}});
    const FunctionId second = add(module, "second", {kX}, Type::structure(1), [&](Builder& b) {
        const Value made = b.call(maker, std::vector{b.param(0)});
        const std::vector<Value> parts = {b.extract(made, 0), b.extract(made, 1)};
        return b.construct(Type::structure(1), parts);
    });
    const FunctionId reader = add(module, "read", {kX}, kFloat,
                                  [&](Builder& b) { return b.extract(b.call(second, std::vector{b.param(0)}), 1); });
    module = checked(settle_members(std::move(module)));
    EXPECT_EQ(count(module[reader], Op::Extract), 0u);
}

}  // namespace
}  // namespace patina::ir
