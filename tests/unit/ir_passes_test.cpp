// The passes: what each does to small functions, and that all of them keep the meaning of random ones, as the
// interpreter sees it.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <random>

#include "compiler/interpret/interpret.h"
#include "compiler/ir/builder.h"
#include "compiler/ir/dump.h"
#include "compiler/ir/passes/passes.h"
#include "compiler/ir/verify.h"

namespace patina::ir {
namespace {

using Body = std::function<Value(Builder&)>;

// Adds a function whose body returns what `body` makes.
FunctionId add(Module& module, std::string name, std::vector<Param> params, Type result, const Body& body,
               bool fold = true) {
    Function function;
    function.name = std::move(name);
    function.params = std::move(params);
    function.result = result;
    Builder b(module, function, {.fold = fold});
    b.ret(body(b));
    module.functions.push_back(std::move(function));
    return {static_cast<std::uint32_t>(module.functions.size() - 1)};
}

void set_entry(Module& module, FunctionId entry) {
    module.stage.entry = entry;
    for (const Param& param : module[entry].params) {
        module.stage.inputs.push_back({.name = param.name, .type = param.type});
    }
    if (module[entry].result.kind != Kind::Struct) return;
    for (const Member& member : module.structs[module[entry].result.ref].members) {
        module.stage.outputs.push_back({.name = member.name, .type = member.type});
    }
}

std::vector<std::string> names(const Module& module) {
    std::vector<std::string> all;
    for (const Function& function : module.functions) all.push_back(function.name);
    return all;
}

// What stands in the blocks, loops and branches included.
std::size_t count(const Function& function, Op op) {
    std::size_t n = 0;
    for (const Block& block : function.blocks) {
        for (const Value value : block.insts) n += function[value].op == op ? 1 : 0;
    }
    return n;
}
std::size_t count_in(const Function& function, std::uint32_t block, Op op) {
    std::size_t n = 0;
    for (const Value value : function.blocks[block].insts) n += function[value].op == op ? 1 : 0;
    return n;
}
const Inst& only(const Function& function, Op op) {
    for (const Inst& inst : function.insts) {
        if (inst.op == op) return inst;
    }
    ADD_FAILURE() << "no " << info(op).text;
    return function.insts[0];
}

Module checked(Module module) {
    EXPECT_EQ(verify(module), "");
    return module;
}

const Param kX{"x", kFloat, Rate::Pixel}, kY{"y", kFloat, Rate::Pixel}, kZ{"z", kFloat, Rate::Pixel};
const Param kC{"c", kBool, Rate::Pixel}, kRoughness{"roughness", kFloat, Rate::Uniform};

// A body long enough not to be inlined for its size.
Value long_chain(Builder& b, Value v) {
    for (const Op op : {Op::Sin, Op::Cos, Op::Exp, Op::Sqrt, Op::Tan}) v = b.emit(op, {v});
    return v;
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

// f(x, mode): a branch on mode.
FunctionId add_switch(Module& module) {
    return add(module, "f", {kX, {"mode", kInt, Rate::Uniform}}, kFloat, [](Builder& b) {
        const Value x = b.param(0), one = b.constant(kInt, {1});
        const Value branch = b.begin_if(b.emit(Op::Equal, {b.param(1), one}));
        const Value a = long_chain(b, x);
        b.begin_else();
        const Value c = b.emit(Op::Log, {x});
        b.end_if(std::vector{a}, std::vector{c});
        return b.result(branch, 0);
    });
}

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
    EXPECT_EQ(names(module), (std::vector<std::string>{"f", "f_2", "f_3", "main"}));
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

// --- inline_calls

TEST(Inline, SpellsOutSmallFunctions) {
    Module module;
    module.origins = {{.label = "Wave", .id = "wave", .span = {}}};
    const FunctionId small = add(module, "small", {kX}, kFloat,
                                 [](Builder& b) { return b.emit(Op::Saturate, {b.emit(Op::Sin, {b.param(0)})}); });
    const FunctionId large = add(module, "large", {kX}, kFloat, [](Builder& b) { return long_chain(b, b.param(0)); });
    const FunctionId main = add(module, "main", {kX}, kFloat, [&](Builder& b) {
        b.set_origin({0});
        const Value wave = b.call(small, std::vector{b.param(0)});
        b.name(wave, b.module().intern("wave"));
        return b.call(large, std::vector{wave});
    });
    set_entry(module, main);
    module = checked(prune(inline_calls(std::move(module))));
    EXPECT_EQ(names(module), (std::vector<std::string>{"large", "main"}));
    const Function& made = module.functions[1];
    EXPECT_EQ(module.name_of(only(made, Op::Saturate).name), "wave");
    EXPECT_EQ(only(made, Op::Sin).origin, OriginId{0});
    EXPECT_FALSE(only(made, Op::Sin).name);
}

TEST(Inline, SpellsOutWhatTakesTextures) {
    Module module;
    const Type texture = Type::of(Kind::Texture2D), sampler = Type::of(Kind::Sampler);
    module.structs.push_back({"Texture", {{"texture", texture}, {"sampler", sampler}}});
    module.globals = {{.name = "t", .type = texture}, {.name = "s", .type = sampler}};
    const Type pair = Type::structure(0);
    const FunctionId f =
        add(module, "f", {{"t", pair, Rate::Uniform}, {"uv", kFloat2, Rate::Pixel}}, kFloat, [](Builder& b) {
            const Value t = b.extract(b.param(0), 0), s = b.extract(b.param(0), 1);
            const Value texel = b.emit(Op::Sample, {t, s, b.param(1)});
            return long_chain(b, b.extract(texel, 0));
        });
    const FunctionId main = add(module, "main", {{"uv", kFloat2, Rate::Pixel}}, kFloat, [&](Builder& b) {
        const std::vector<Value> parts = {b.emit(Op::Global, b.module().globals[0].type, {}, 0),
                                          b.emit(Op::Global, b.module().globals[1].type, {}, 1)};
        return b.call(f, std::vector{b.construct(pair, parts), b.param(0)});
    });
    set_entry(module, main);
    module = checked(prune(inline_calls(std::move(module))));
    EXPECT_EQ(names(module), std::vector<std::string>{"main"});
    EXPECT_EQ(count(module.functions[0], Op::Construct), 0u);
    EXPECT_EQ(count(module.functions[0], Op::Sample), 1u);
}

// A loop over lights that calls f(light index, roughness); f has work that only the roughness decides.
Module light_loop() {
    Module module;
    const FunctionId f = add(module, "f", {kX, kRoughness}, kFloat, [](Builder& b) {
        const Value by_light = long_chain(b, b.param(0));
        const Value by_pixel = b.emit(Op::Log, {b.param(1)});
        return b.emit(Op::Mul, {by_light, by_pixel});
    });
    const FunctionId main = add(module, "main", {kRoughness}, kFloat, [&](Builder& b) {
        const Value begin = b.constant(kInt, {0}), end = b.constant(kInt, {4}), zero = b.constant(kFloat, {0});
        const Value loop = b.begin_for(begin, end, std::vector{zero}, true);
        const Value light = b.convert(b.loop_index(), Scalar::Float);
        const Value lit = b.call(f, std::vector{light, b.param(0)});
        b.end_for(std::vector{b.emit(Op::Add, {b.loop_carried(0), lit})});
        return b.result(loop, 0);
    });
    set_entry(module, main);
    return module;
}

TEST(Inline, SpellsOutWhatHidesWorkFromALightLoop) {
    const Module module = checked(schedule(inline_calls(light_loop())));
    const Function& main = module.functions.back();
    EXPECT_EQ(count(main, Op::Call), 0u);
    const std::uint32_t body = only(main, Op::For).data;
    EXPECT_EQ(count_in(main, 0, Op::Log), 1u);
    EXPECT_EQ(count_in(main, body, Op::Log), 0u);
    EXPECT_EQ(count_in(main, body, Op::Tan), 1u);
}

// --- schedule

TEST(Schedule, HoistsOutOfEachLoopThatDoesNotMatter) {
    Module module;
    add(module, "main", {kX, kC}, kFloat, [](Builder& b) {
        const Value begin = b.constant(kInt, {0}), end = b.constant(kInt, {4});
        const Value x = b.param(0), condition = b.param(1);
        const Value outer = b.begin_for(begin, end, std::vector{x});
        const Value i = b.convert(b.loop_index(), Scalar::Float), outer_sum = b.loop_carried(0);
        const Value inner = b.begin_for(begin, end, std::vector{outer_sum});
        const Value j = b.convert(b.loop_index(), Scalar::Float);
        const Value by_nothing = b.emit(Op::Sin, {x});
        const Value by_outer = b.emit(Op::Cos, {i});
        const Value by_inner = b.emit(Op::Exp, {j});
        // In a branch too: the sine of y is needed wherever the branch is taken.
        const Value branch = b.begin_if(condition);
        const Value root = b.emit(Op::Sqrt, {b.emit(Op::Add, {x, by_nothing})});
        const Value in_branch = b.emit(Op::Mul, {root, by_inner});
        b.begin_else();
        b.end_if(std::vector{in_branch}, std::vector{by_outer});
        const Value sum = b.emit(Op::Add, {b.loop_carried(0), b.result(branch, 0)});
        b.end_for(std::vector{sum});
        b.end_for(std::vector{b.result(inner, 0)});
        return b.result(outer, 0);
    });
    module = checked(schedule(std::move(module)));
    const Function& main = module.functions[0];
    const std::uint32_t outer = only(main, Op::For).data;
    EXPECT_EQ(count_in(main, 0, Op::Sin), 1u) << dump(module, main);
    EXPECT_EQ(count_in(main, 0, Op::Sqrt), 1u) << dump(module, main);
    EXPECT_EQ(count_in(main, outer, Op::Cos), 1u) << dump(module, main);
    EXPECT_EQ(count_in(main, outer, Op::Exp), 0u) << dump(module, main);
    EXPECT_EQ(count(main, Op::Exp), 1u);
}

TEST(Schedule, MovesWholeStructuresOut) {
    Module module;
    add(module, "main", {kX, kC}, kFloat, [](Builder& b) {
        const Value begin = b.constant(kInt, {0}), end = b.constant(kInt, {4});
        const Value x = b.param(0), condition = b.param(1);
        const Value outer = b.begin_for(begin, end, std::vector{x});
        const Value inner = b.begin_for(begin, end, std::vector{x});
        b.end_for(std::vector{b.emit(Op::Mul, {b.loop_carried(0), b.emit(Op::Sin, {x})})});
        const Value branch = b.begin_if(condition);
        const Value root = b.emit(Op::Sqrt, {b.result(inner, 0)});
        b.begin_else();
        b.end_if(std::vector{root}, std::vector{x});
        b.end_for(std::vector{b.emit(Op::Mul, {b.loop_carried(0), b.result(branch, 0)})});
        return b.result(outer, 0);
    });
    module = checked(schedule(std::move(module)));
    const Function& main = module.functions[0];
    EXPECT_EQ(count_in(main, 0, Op::For), 2u) << dump(module, main);
    EXPECT_EQ(count_in(main, 0, Op::If), 1u) << dump(module, main);
    EXPECT_EQ(count_in(main, 0, Op::Sin), 1u) << dump(module, main);
}

// --- rates

TEST(Rates, FollowOperandsLoopsAndCalls) {
    Module module;
    module.globals = {{.name = "g", .type = kFloat}};
    const FunctionId reads =
        add(module, "reads", {}, kFloat, [](Builder& b) { return b.emit(Op::Global, kFloat, {}, 0); });
    Value constant, called, product, light, lit, sum;
    add(module, "main", {kRoughness, {"n", kFloat, Rate::Vertex}}, kFloat, [&](Builder& b) {
        constant = b.constant(kFloat, {2});
        called = b.call(reads, {});
        product = b.emit(Op::Mul, {called, b.param(1)});
        const Value begin = b.constant(kInt, {0}), end = b.constant(kInt, {4});
        const Value loop = b.begin_for(begin, end, std::vector{constant}, true);
        light = b.convert(b.loop_index(), Scalar::Float);
        lit = b.emit(Op::Mul, {light, product});
        b.end_for(std::vector{b.emit(Op::Add, {b.loop_carried(0), lit})});
        sum = b.result(loop, 0);
        return sum;
    });
    const std::vector<Rate> found = rates(module, module.functions[1]);
    EXPECT_EQ(found[constant.index], Rate::Constant);
    EXPECT_EQ(found[called.index], Rate::Uniform);
    EXPECT_EQ(found[product.index], Rate::Vertex);
    EXPECT_EQ(found[light.index], Rate::Light);
    EXPECT_EQ(found[lit.index], Rate::Light);
    EXPECT_EQ(found[sum.index], Rate::Vertex);  // summed up in each vertex
}

TEST(Rates, WhatALoopYieldsRaisesWhatItCarries) {
    Module module;
    Value carried, doubled, result;
    add(module, "main", {kX}, kFloat, [&](Builder& b) {
        const Value begin = b.constant(kInt, {0}), end = b.constant(kInt, {4}), one = b.constant(kFloat, {1});
        const Value loop = b.begin_for(begin, end, std::vector{one});
        carried = b.loop_carried(0);
        doubled = b.emit(Op::Add, {carried, carried});
        b.end_for(std::vector{b.emit(Op::Mul, {doubled, b.param(0)})});
        result = b.result(loop, 0);
        return result;
    });
    const std::vector<Rate> found = rates(module, module.functions[0]);
    EXPECT_EQ(found[doubled.index], Rate::Pixel);
    EXPECT_EQ(found[result.index], Rate::Pixel);
}

// --- legalize_discard

TEST(LegalizeDiscard, FollowsTheLastDerivative) {
    Module module;
    const FunctionId edge =
        add(module, "edge", {kX}, kFloat, [](Builder& b) { return b.emit(Op::Fwidth, {b.param(0)}); });
    const FunctionId main = add(module, "main", {kX, kC}, kFloat, [&](Builder& b) {
        b.emit(Op::DiscardIf, Type::none(), {b.param(1)});
        const Value width = b.call(edge, std::vector{b.param(0)});
        return b.emit(Op::Sin, {width});
    });
    set_entry(module, main);
    module = checked(legalize_discard(std::move(module)));
    std::vector<Op> ops;
    for (const Value v : module.functions[1].blocks[0].insts) ops.push_back(module.functions[1][v].op);
    EXPECT_EQ(ops, (std::vector{Op::Param, Op::Param, Op::Call, Op::DiscardIf, Op::Sin, Op::Return}));
}

TEST(LegalizeDiscard, StaysWhereNothingNeedsNeighbours) {
    Module module;
    const FunctionId main = add(module, "main", {kX, kC}, kFloat, [&](Builder& b) {
        const Value condition = b.param(1);
        b.emit(Op::DiscardIf, Type::none(), {condition});
        return b.emit(Op::Sin, {b.param(0)});
    });
    set_entry(module, main);
    const std::string before = dump(module, module.functions[0]);
    module = checked(legalize_discard(std::move(module)));
    EXPECT_EQ(dump(module, module.functions[0]), before);
}

// --- meaning

// Random modules of calls, branches, loops and structs, from ops that are exact: every witness must agree to the bit.
class RandomModule {
public:
    explicit RandomModule(unsigned seed) : random_(seed) {
        module.structs.push_back({"Triple", {{"a", kFloat}, {"b", kFloat}, {"c", kFloat}}});
        for (int k = 0; k < 4; k++) {
            const bool returns_struct = k < 3 && pick(2) == 0;
            std::vector<Param> params(1 + pick(3), kX);
            const Type result = returns_struct ? Type::structure(0) : kFloat;
            const FunctionId made = add(
                module, "f" + std::to_string(k), params, result,
                [&](Builder& b) {
                    visible_.clear();
                    for (std::uint32_t i = 0; i < params.size(); i++) visible_.push_back(b.param(i));
                    statements(b, 6, 0);
                    if (!returns_struct) return any();
                    const std::vector<Value> parts = {any(), any(), any()};
                    return b.construct(result, parts);
                },
                false);
            callable_.push_back(made);
        }
        set_entry(module, callable_.back());
    }
    Module module;

private:
    std::uint32_t pick(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }
    Value any() { return visible_[pick(static_cast<std::uint32_t>(visible_.size()))]; }

    void statements(Builder& b, int n, int depth) {
        for (int k = 0; k < n; k++) {
            const std::uint32_t kind = pick(10);
            if (kind == 0 && depth < 3) {
                branch(b, depth);
            } else if (kind == 1 && depth < 3) {
                loop(b, depth);
            } else if (kind == 2 && !callable_.empty()) {
                call(b);
            } else if (kind == 3) {
                static constexpr double kNumbers[] = {0, 1, -1, 0.5, 2, 3};
                visible_.push_back(b.constant(kFloat, {kNumbers[pick(6)]}));
            } else {
                arithmetic(b);
            }
        }
    }

    void arithmetic(Builder& b) {
        static constexpr Op kBinary[] = {Op::Add, Op::Sub, Op::Mul, Op::Min, Op::Max};
        static constexpr Op kUnary[] = {Op::Neg, Op::Abs, Op::Floor, Op::Saturate};
        const Value x = any(), y = any();
        if (pick(3) == 0) {
            visible_.push_back(b.emit(kUnary[pick(4)], {x}));
        } else if (pick(4) == 0) {
            visible_.push_back(b.emit(Op::Select, kFloat, {b.emit(Op::Less, {x, y}), x, y}));
        } else if (pick(4) == 0) {
            const std::vector<Value> parts = {x, y, any()};
            const Value v = b.construct(kFloat3, parts);
            const std::vector<unsigned> components = {pick(3), pick(3)};
            visible_.push_back(b.extract(b.swizzle(v, components), pick(2)));
        } else {
            visible_.push_back(b.emit(kBinary[pick(5)], {x, y}));
        }
    }

    Value condition(Builder& b) {
        if (pick(4) == 0) return b.constant(kBool, {static_cast<double>(pick(2))});
        const Value x = any(), y = any();
        return b.emit(Op::Less, {x, y});
    }

    void branch(Builder& b, int depth) {
        const Value structure = b.begin_if(condition(b));
        const std::size_t before = visible_.size();
        std::vector<Value> values[2];
        for (int side = 0; side < 2; side++) {
            if (side == 1) b.begin_else();
            statements(b, static_cast<int>(pick(4)), depth + 1);
            values[side] = {any(), any()};
            visible_.resize(before);
        }
        b.end_if(values[0], values[1]);
        for (std::uint32_t i = 0; i < 2; i++) visible_.push_back(b.result(structure, i));
    }

    void loop(Builder& b, int depth) {
        const Value begin = b.constant(kInt, {0}), end = b.constant(kInt, {static_cast<double>(pick(4))});
        const std::vector<Value> initial = {any(), any()};
        const Value structure = b.begin_for(begin, end, initial, pick(2) == 0);
        const std::size_t before = visible_.size();
        visible_.push_back(b.loop_carried(0));
        visible_.push_back(b.loop_carried(1));
        visible_.push_back(b.convert(b.loop_index(), Scalar::Float));
        statements(b, 1 + static_cast<int>(pick(5)), depth + 1);
        // Saturated, so that sums do not run away to infinity, where min and max of NaN begin to differ.
        const Value next = b.emit(Op::Saturate, {any()});
        const Value other = pick(2) == 0 ? b.loop_carried(1) : any();
        b.end_for(std::vector{next, other});
        visible_.resize(before);
        for (std::uint32_t i = 0; i < 2; i++) visible_.push_back(b.result(structure, i));
    }

    void call(Builder& b) {
        const FunctionId callee = callable_[pick(static_cast<std::uint32_t>(callable_.size()))];
        std::vector<Value> args;
        for (std::size_t i = 0; i < module[callee].params.size(); i++) args.push_back(any());
        const Value made = b.call(callee, args);
        visible_.push_back(b.type(made) == kFloat ? made : b.extract(made, pick(3)));
    }

    std::mt19937 random_;
    std::vector<FunctionId> callable_;
    std::vector<Value> visible_;
};

// Arguments by the name of the stage's inputs' places, which pruning may thin out.
interpret::QuadResult run(const Module& module, const std::vector<std::array<double, 4>>& inputs,
                          const std::vector<std::uint32_t>& used) {
    std::array<std::vector<interpret::Flat>, 4> arguments;
    for (std::size_t lane = 0; lane < 4; lane++) {
        for (const std::uint32_t input : used) arguments[lane].push_back({inputs[input][lane]});
    }
    return interpret::run(module, module.stage.entry, arguments, {}, Precision::Float);
}

std::vector<std::uint32_t> inputs_of(const Module& module) {
    std::vector<std::uint32_t> used;
    for (const StageVariable& variable : module.stage.inputs) used.push_back(variable.location);
    return used;
}

struct NamedPass {
    const char* name;
    Module (*run)(Module);
};
constexpr NamedPass kPasses[] = {{"prune", prune},
                                 {"specialise", specialise},
                                 {"inline_calls", inline_calls},
                                 {"schedule", schedule},
                                 {"tidy", tidy}};

TEST(Passes, KeepTheMeaningOfRandomModules) {
    for (unsigned seed = 0; seed < 400; seed++) {
        RandomModule source(seed);
        for (std::uint32_t i = 0; i < source.module.stage.inputs.size(); i++)
            source.module.stage.inputs[i].location = i;
        ASSERT_EQ(verify(source.module), "");
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> real(-2, 2);
        std::vector<std::array<double, 4>> inputs(3);
        for (auto& input : inputs) {
            for (double& lane : input) lane = static_cast<double>(static_cast<float>(real(random)));
        }
        const interpret::QuadResult expected = run(source.module, inputs, inputs_of(source.module));
        for (const NamedPass& pass : kPasses) {
            const Module made = pass.run(source.module);
            ASSERT_EQ(verify(made), "") << pass.name << " of seed " << seed;
            const interpret::QuadResult result = run(made, inputs, inputs_of(made));
            for (std::size_t lane = 0; lane < 4; lane++) {
                const double a = expected.lanes[lane][0], b = result.lanes[lane][0];
                ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b)))
                    << a << " became " << b << " by " << pass.name << " of seed " << seed << "\n"
                    << dump(source.module) << "\n"
                    << dump(made);
            }
        }
    }
}

// --- cost

TEST(Passes, AreLinear) {
    const auto begin = std::chrono::steady_clock::now();
    for (const bool is_ladder : {false, true}) {
        Module module;
        const FunctionId main = add(
            module, "main", {kX}, kFloat,
            [&](Builder& b) {
                Value value = b.param(0);
                for (int i = 0; i < 10000; i++) {
                    value = is_ladder ? b.emit(Op::Mul, {value, value})
                                      : b.emit(Op::Add, {value, b.constant(kFloat, {i + 1.0})});
                }
                return value;
            },
            false);
        set_entry(module, main);
        module = tidy(std::move(module));
        EXPECT_EQ(count(module.functions[0], is_ladder ? Op::Mul : Op::Add), 10000u);
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
}

// Each function calls the one before twice: spelled out, or specialised, they would be 2^60 instructions.
TEST(Passes, DoNotExplode) {
    const auto begin = std::chrono::steady_clock::now();
    Module module;
    FunctionId last = add_switch(module);
    for (int k = 0; k < 60; k++) {
        last = add(module, "g" + std::to_string(k), {kX, {"mode", kInt, Rate::Uniform}}, kFloat, [&](Builder& b) {
            // No two of the calls have the same mode.
            const Value one = b.constant(kInt, {1}), two = b.constant(kInt, {2});
            const Value same = b.emit(Op::Mul, {b.param(1), two}), next = b.emit(Op::Add, {same, one});
            const Value a = b.call(last, std::vector{b.param(0), next}),
                        c = b.call(last, std::vector{b.param(0), same});
            const Value is_one = b.emit(Op::Equal, {same, one});
            return b.emit(Op::Select, kFloat, {is_one, a, b.emit(Op::Mul, {a, c})});
        });
        module[last].always_inline = k > 20;
    }
    const FunctionId main = add(module, "main", {kX}, kFloat, [&](Builder& b) {
        return b.call(last, std::vector{b.param(0), b.constant(kInt, {0})});
    });
    set_entry(module, main);
    checked(tidy(std::move(module)));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

// Each function calls the one before inside of a branch: spelled out, branches would stand as deep as there are
// functions.
Module nested_calls(int depth) {
    Module module;
    FunctionId last = add(module, "f", {kX}, kFloat, [](Builder& b) { return long_chain(b, b.param(0)); });
    for (int k = 0; k < depth; k++) {
        last = add(module, "g" + std::to_string(k), {kX}, kFloat, [&](Builder& b) {
            const Value x = b.param(0), limit = b.constant(kFloat, {k + 1.0});
            const Value branch = b.begin_if(b.emit(Op::Less, {x, limit}));
            const Value called = b.call(last, std::vector{x});
            b.begin_else();
            b.end_if(std::vector{called}, std::vector{limit});
            return b.result(branch, 0);
        });
        module[last].always_inline = true;
    }
    set_entry(module, last);
    return module;
}

TEST(Passes, DoNotNestWithoutEnd) {
    const Module module = checked(tidy(nested_calls(250)));
    std::size_t deepest = 0;
    for (const Function& function : module.functions) deepest = std::max(deepest, function.blocks.size() / 2);
    EXPECT_GT(deepest, 100u);
    EXPECT_LE(deepest, 200u);
    checked(tidy(nested_calls(5000)));
}

}  // namespace
}  // namespace patina::ir
