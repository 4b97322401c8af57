// drop_members: which members are removed, and which instructions with them. ir_passes_meaning_test.cpp checks that the
// meaning stays the same.
#include "compiler/ir/passes/passes.h"
#include "tests/unit/ir/ir_testing.h"

namespace patina::ir {
namespace {

std::vector<std::string> members(const Module& module, std::size_t structure) {
    std::vector<std::string> names;
    for (const Member& member : module.structs[structure].members) names.push_back(member.name);
    return names;
}

// make(x) -> {a: x, b: exp(x), c: sin(x), d: x}
FunctionId add_maker(Module& module) {
    module.structs.push_back({"Four", {{"a", kFloat}, {"b", kFloat}, {"c", kFloat}, {"d", kFloat}}});
    return add(module, "make", {kX}, Type::structure(0), [](Builder& b) {
        const Value x = b.param(0);
        const std::vector<Value> parts = {x, b.emit(Op::Exp, {x}), b.emit(Op::Sin, {x}), x};
        return b.construct(Type::structure(0), parts);
    });
}

FunctionId add_reader(Module& module, const std::string& name, FunctionId maker, std::uint32_t member) {
    return add(module, name, {kX}, kFloat,
               [&](Builder& b) { return b.extract(b.call(maker, std::vector{b.param(0)}), member); });
}

TEST(DropMembers, WhatOneEntryReadsAllKeep) {
    Module module;
    const FunctionId maker = add_maker(module);
    const std::vector<FunctionId> entries = {add_reader(module, "first", maker, 0),
                                             add_reader(module, "second", maker, 2)};
    module = checked(drop_members(std::move(module), entries, {}));
    EXPECT_EQ(members(module, 0), (std::vector<std::string>{"a", "c"}));
    EXPECT_EQ(count(module[maker], Op::Exp), 0u);
    EXPECT_EQ(count(module[maker], Op::Sin), 1u);
}

TEST(DropMembers, FunctionsThatNothingReachesDoNotCount) {
    Module module;
    const FunctionId maker = add_maker(module);
    const FunctionId entry = add_reader(module, "entry", maker, 0);
    add_reader(module, "idle", maker, 1);
    const FunctionId recipe = add_reader(module, "recipe", maker, 3);
    module = checked(drop_members(std::move(module), std::span(&entry, 1), std::span(&recipe, 1)));
    EXPECT_EQ(members(module, 0), (std::vector<std::string>{"a", "d"}));
}

TEST(DropMembers, EntriesAndFunctionsFromElsewhereKeepWhatTheyGive) {
    Module module;
    const FunctionId maker = add_maker(module);
    Module whole = checked(drop_members(module, std::span(&maker, 1), {}));
    EXPECT_EQ(members(whole, 0).size(), 4u);

    const FunctionId entry = add_reader(module, "entry", maker, 0);
    const FunctionId taker = add(module, "taker", {{"four", Type::structure(0), Rate::Pixel}}, kFloat,
                                 [](Builder& b) { return b.constant(kFloat, {0}); });
    module[taker].linkage = Linkage::Foreign;
    module = drop_members(std::move(module), std::span(&entry, 1), {});
    EXPECT_EQ(members(module, 0).size(), 4u);
}

TEST(DropMembers, AStructThatIsOnlyHandedOnKeepsOne) {
    Module module;
    const FunctionId maker = add_maker(module);
    const FunctionId deaf = add(module, "deaf", {{"four", Type::structure(0), Rate::Pixel}, kX}, kFloat,
                                [](Builder& b) { return long_chain(b, b.param(1)); });
    const FunctionId entry = add(module, "entry", {kX}, kFloat, [&](Builder& b) {
        return b.call(deaf, std::vector{b.call(maker, std::vector{b.param(0)}), b.param(0)});
    });
    module = checked(drop_members(std::move(module), std::span(&entry, 1), {}));
    EXPECT_EQ(members(module, 0), (std::vector<std::string>{"a"}));
}

TEST(DropMembers, AnInsertIntoWhatGoesIsTheStructItself) {
    Module module;
    const FunctionId maker = add_maker(module);
    const FunctionId entry = add(module, "entry", {kX, kY}, kFloat, [&](Builder& b) {
        const Value made = b.call(maker, std::vector{b.param(0)});
        const Type type = Type::structure(0);
        const Value first = b.emit(Op::Insert, type, {made, b.emit(Op::Cos, {b.param(1)})}, 1);
        return b.extract(b.emit(Op::Insert, type, {first, b.param(1)}, 3), 2);
    });
    module = checked(drop_members(std::move(module), std::span(&entry, 1), {}));
    EXPECT_EQ(members(module, 0), (std::vector<std::string>{"c"}));
    EXPECT_EQ(count(module[entry], Op::Insert), 0u);
    EXPECT_EQ(count(module[entry], Op::Cos), 0u);
}

}  // namespace
}  // namespace patina::ir
