// The passes: what each does to small functions. That they keep the meaning of larger ones: ir_passes_meaning_test.cpp.
#include "compiler/ir/dump.h"
#include "compiler/ir/passes/passes.h"
#include "tests/unit/ir/ir_testing.h"

namespace patina::ir {
namespace {

std::vector<std::string> names(const Module& module) {
    std::vector<std::string> all;
    for (const Function& function : module.functions) all.push_back(function.name);
    return all;
}

const Inst& only(const Function& function, Op op) {
    for (const Inst& inst : function.insts) {
        if (inst.op == op) return inst;
    }
    ADD_FAILURE() << "no " << info(op).text;
    return function.insts[0];
}

// --- prune

TEST(Prune, DropsDeadCodeAndFunctions) {
    Module module;
    add(module, "unused", {kX}, kFloat, [](Builder& b) { return b.emit(Op::Sin, {b.param(0)}); });
    const FunctionId main = add(
        module, "main", {kX, kC}, kFloat,
        [](Builder& b) {
            b.emit(Op::Sin, {b.param(0)});
            const Value condition = b.param(1);
            b.begin_if(condition);
            const Value dead = b.emit(Op::Exp, {b.param(0)});
            b.begin_else();
            b.end_if(std::vector{dead}, std::vector{dead});
            return b.emit(Op::Cos, {b.param(0)});
        },
        false);
    set_entry(module, main);
    module = checked(prune(std::move(module)));
    EXPECT_EQ(names(module), std::vector<std::string>{"main"});
    EXPECT_EQ(dump(module, module.functions[0]),
              "func main(x: float pixel) -> float {\n"
              "  %0 = param float x\n"
              "  %1 = cos float (%0)\n"
              "  return (%1)\n"
              "}\n");
    ASSERT_EQ(module.stage.inputs.size(), 1u);
    EXPECT_EQ(module.stage.inputs[0].name, "x");
}

TEST(Prune, DropsParamsThatNobodyReads) {
    Module module;
    const FunctionId inner =
        add(module, "inner", {kX, kY}, kFloat, [](Builder& b) { return long_chain(b, b.param(1)); });
    const FunctionId outer = add(module, "outer", {kX, kY}, kFloat, [&](Builder& b) {
        return b.call(inner, std::vector{b.param(0), b.param(1)});
    });
    const FunctionId main = add(module, "main", {kX, kY}, kFloat, [&](Builder& b) {
        const Value expensive = b.emit(Op::Exp, {b.param(0)});
        return b.call(outer, std::vector{expensive, b.param(1)});
    });
    set_entry(module, main);
    module = checked(prune(std::move(module)));
    EXPECT_EQ(module.functions[0].params.size(), 1u);
    EXPECT_EQ(module.functions[1].params.size(), 1u);
    EXPECT_EQ(count(module.functions[2], Op::Exp), 0u);
    EXPECT_EQ(module.stage.inputs.size(), 1u);
}

struct Triple {
    Module module;
    Type type;
    FunctionId make;
    Triple() {
        module.structs.push_back({"Triple", {{"a", kFloat}, {"b", kFloat}, {"c", kFloat}}});
        type = Type::structure(0);
        make = add(module, "make", {kX}, type, [&](Builder& b) {
            const std::vector<Value> parts = {b.emit(Op::Sin, {b.param(0)}), b.emit(Op::Cos, {b.param(0)}),
                                              b.emit(Op::Exp, {b.param(0)})};
            return b.construct(type, parts);
        });
    }
};

TEST(Prune, NarrowsAResultStruct) {
    Triple t;
    const FunctionId main = add(t.module, "main", {kX}, kFloat, [&](Builder& b) {
        const Value made = b.call(t.make, std::vector{b.param(0)});
        const Value a = b.extract(made, 0), c = b.extract(made, 2);
        return b.emit(Op::Add, {a, c});
    });
    set_entry(t.module, main);
    const Module module = checked(prune(std::move(t.module)));
    EXPECT_EQ(count(module.functions[0], Op::Cos), 0u);
    const Struct& narrowed = module.structs[module.functions[0].result.ref];
    EXPECT_EQ(narrowed.name, "Triple");
    ASSERT_EQ(narrowed.members.size(), 2u);
    EXPECT_EQ(narrowed.members[1].name, "c");
}

TEST(Prune, UnwrapsASingleMember) {
    Triple t;
    // Through a second function that hands the struct on, and an insert that changes a member.
    const FunctionId change = add(t.module, "change", {kX, kY}, t.type, [&](Builder& b) {
        const Value made = b.call(t.make, std::vector{b.param(0)});
        return b.emit(Op::Insert, t.type, {made, b.param(1)}, 0);
    });
    const FunctionId main = add(t.module, "main", {kX, kY}, kFloat, [&](Builder& b) {
        return b.extract(b.call(change, std::vector{b.param(0), b.param(1)}), 1);
    });
    set_entry(t.module, main);
    const Module module = checked(prune(std::move(t.module)));
    EXPECT_EQ(module.functions[0].result, kFloat);
    EXPECT_EQ(module.functions[1].result, kFloat);
    EXPECT_EQ(count(module.functions[0], Op::Cos), 1u);
    EXPECT_EQ(count(module.functions[0], Op::Sin) + count(module.functions[0], Op::Exp), 0u);
    EXPECT_EQ(module.functions[1].params.size(), 1u);
}

TEST(Prune, KeepsAStructThatIsReadAsAWhole) {
    Triple t;
    const FunctionId main = add(t.module, "main", {kX, kC}, t.type, [&](Builder& b) {
        const Value made = b.call(t.make, std::vector{b.param(0)});
        const Value other = b.emit(Op::Insert, t.type, {made, b.extract(made, 1)}, 0);
        return b.emit(Op::Select, t.type, {b.param(1), made, other});
    });
    set_entry(t.module, main);
    const Module module = checked(prune(std::move(t.module)));
    EXPECT_EQ(module.functions[0].result, t.type);
}

TEST(Prune, DropsCarriedValues) {
    Module module;
    const FunctionId main = add(
        module, "main", {kX, kY, kZ}, kFloat,
        [](Builder& b) {
            const Value begin = b.constant(kInt, {0}), end = b.constant(kInt, {8});
            const std::vector<Value> initial = {b.param(0), b.param(1), b.param(2)};
            const Value loop = b.begin_for(begin, end, initial);
            const Value same = b.loop_carried(1);
            const Value unread = b.emit(Op::Exp, {b.loop_carried(2)});
            const Value sum = b.emit(Op::Add, {b.loop_carried(0), same});
            b.end_for(std::vector{sum, same, unread});
            return b.result(loop, 0);
        },
        false);
    set_entry(module, main);
    module = checked(prune(std::move(module)));
    EXPECT_EQ(only(module.functions[0], Op::For).operand_count, 3u);
    EXPECT_EQ(count(module.functions[0], Op::Exp), 0u);
    EXPECT_EQ(module.functions[0].params.size(), 2u);
}

TEST(Prune, KeepsDiscards) {
    Module module;
    const FunctionId main = add(module, "main", {kC}, Type::none(), [](Builder& b) {
        b.emit(Op::DiscardIf, Type::none(), {b.param(0)});
        return Value();
    });
    set_entry(module, main);
    module = checked(prune(std::move(module)));
    EXPECT_EQ(count(module.functions[0], Op::DiscardIf), 1u);
}

// --- structure that folds while any pass rebuilds

TEST(Rebuild, AKnownConditionLeavesItsBranch) {
    Module module;
    add(
        module, "main", {kX}, kFloat,
        [](Builder& b) {
            const Value yes = b.constant(kBool, {1});
            const Value branch = b.begin_if(yes);
            const Value then_value = b.emit(Op::Sin, {b.param(0)});
            b.begin_else();
            const Value else_value = b.emit(Op::Cos, {b.param(0)});
            b.end_if(std::vector{then_value}, std::vector{else_value});
            return b.result(branch, 0);
        },
        false);
    module = checked(prune(std::move(module)));
    EXPECT_EQ(count(module.functions[0], Op::If), 0u);
    EXPECT_EQ(count(module.functions[0], Op::Sin), 1u);
    EXPECT_EQ(count(module.functions[0], Op::Cos), 0u);
}

TEST(Rebuild, ALoopWithoutATripIsItsInitialValues) {
    Module module;
    add(module, "main", {kX}, kFloat, [](Builder& b) {
        const Value three = b.constant(kInt, {3});
        const Value x = b.param(0);
        const Value loop = b.begin_for(three, three, std::vector{x});
        b.end_for(std::vector{b.emit(Op::Sin, {b.loop_carried(0)})});
        return b.result(loop, 0);
    });
    module = checked(prune(std::move(module)));
    EXPECT_EQ(count(module.functions[0], Op::For), 0u);
    EXPECT_EQ(count(module.functions[0], Op::Sin), 0u);
}

TEST(Rebuild, BranchesThatComputeNothingBecomeSelects) {
    Module module;
    add(module, "main", {kX, kC}, kFloat, [](Builder& b) {
        const Value condition = b.param(1), x = b.param(0), half = b.constant(kFloat, {0.5});
        const Value branch = b.begin_if(condition);
        b.begin_else();
        b.end_if(std::vector{x}, std::vector{half});
        return b.result(branch, 0);
    });
    module = checked(prune(std::move(module)));
    EXPECT_EQ(count(module.functions[0], Op::If), 0u);
    EXPECT_EQ(count(module.functions[0], Op::Select), 1u);
}

// --- specialise

TEST(Specialise, FillsInWhatDecidesABranch) {
    Module module;
    const FunctionId f = add_switch(module);
    const FunctionId main = add(module, "main", {kX, kY}, kFloat, [&](Builder& b) {
        const Value one = b.constant(kInt, {1});
        const Value a = b.call(f, std::vector{b.param(0), one});
        const Value c = b.call(f, std::vector{b.param(1), one});
        return b.emit(Op::Add, {a, c});
    });
    set_entry(module, main);
    module = checked(specialise(std::move(module)));
    // One copy for both calls; the general function is gone, so the copy has its name.
    EXPECT_EQ(names(module), (std::vector<std::string>{"f", "main"}));
    EXPECT_EQ(module.functions[0].params.size(), 1u);
    EXPECT_EQ(count(module.functions[0], Op::If), 0u);
    EXPECT_EQ(count(module.functions[0], Op::Tan), 1u);
    EXPECT_EQ(count(module.functions[0], Op::Log), 0u);
}

TEST(Specialise, NumbersVersionsThatStandSideBySide) {
    Module module;
    const FunctionId f = add_switch(module);
    const FunctionId main = add(module, "main", {kX, {"mode", kInt, Rate::Uniform}}, kFloat, [&](Builder& b) {
        const Value one = b.constant(kInt, {1}), two = b.constant(kInt, {2});
        const Value a = b.call(f, std::vector{b.param(0), one});
        const Value c = b.call(f, std::vector{b.param(0), two});
        const Value d = b.call(f, std::vector{b.param(0), b.param(1)});
        return b.emit(Op::Add, {a, b.emit(Op::Add, {c, d})});
    });
    set_entry(module, main);
    module = checked(specialise(std::move(module)));
    EXPECT_EQ(names(module), (std::vector<std::string>{"f", "f2", "f3", "main"}));
    EXPECT_EQ(count(module.functions[0], Op::If), 1u);
}

TEST(Specialise, GoesDownThroughCalls) {
    Module module;
    const FunctionId f = add_switch(module);
    const FunctionId outer = add(module, "outer", {kX, {"mode", kInt, Rate::Uniform}}, kFloat, [&](Builder& b) {
        const Value is_two = b.emit(Op::Equal, {b.param(1), b.constant(kInt, {2})});
        const Value called = b.call(f, std::vector{b.param(0), b.param(1)});
        return b.emit(Op::Select, kFloat, {is_two, b.param(0), called});
    });
    const FunctionId main = add(module, "main", {kX}, kFloat, [&](Builder& b) {
        return b.call(outer, std::vector{b.param(0), b.constant(kInt, {1})});
    });
    set_entry(module, main);
    module = checked(specialise(std::move(module)));
    EXPECT_EQ(names(module), (std::vector<std::string>{"f", "outer", "main"}));
    for (const Function& function : module.functions) EXPECT_EQ(function.params.size(), 1u) << function.name;
    EXPECT_EQ(count(module.functions[0], Op::If), 0u);
}

TEST(Specialise, LeavesConstantsThatDecideNothing) {
    Module module;
    const FunctionId f = add(module, "f", {kX, kY}, kFloat, [](Builder& b) {
        return b.emit(Op::Mul, {long_chain(b, b.param(0)), b.param(1)});
    });
    const FunctionId main = add(module, "main", {kX}, kFloat, [&](Builder& b) {
        return b.call(f, std::vector{b.param(0), b.constant(kFloat, {0.25})});
    });
    set_entry(module, main);
    module = checked(specialise(std::move(module)));
    EXPECT_EQ(module.functions[0].params.size(), 2u);
}

TEST(Specialise, FoldsACallOfConstants) {
    Module module;
    const FunctionId f = add(module, "f", {kX, kY}, kFloat, [](Builder& b) {
        const Value product = b.emit(Op::Mul, {b.param(0), b.param(1)});
        return b.emit(Op::Sqrt, {b.emit(Op::Sqrt, {b.emit(Op::Sqrt, {b.emit(Op::Sqrt, {product})})})});
    });
    const FunctionId main = add(module, "main", {}, kFloat, [&](Builder& b) {
        const Value a = b.constant(kFloat, {256}), c = b.constant(kFloat, {256});
        return b.call(f, std::vector{a, c});
    });
    set_entry(module, main);
    module = checked(specialise(std::move(module)));
    EXPECT_EQ(names(module), std::vector<std::string>{"main"});
    const Inst& constant = only(module.functions[0], Op::Constant);
    EXPECT_EQ(module.numbers_of(module.constants[constant.data])[0], 2);  // 65536 to the 16th root
}

}  // namespace
}  // namespace patina::ir
