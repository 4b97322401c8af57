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

// main(x) calls f `calls` times; f is a sub-graph whose body `body` makes of its parameter.
Module calls_of_subgraph(int calls, const Body& body) {
    Module module;
    module.origins = {{.id = "first/wave", .function_path = 6}};
    const FunctionId f = add(module, "f", {kX}, kFloat, body);
    module[f].inline_if_shorter = true;
    for (int i = 0; i < calls; ++i) module.origins.push_back({.id = "use" + std::to_string(i)});
    const FunctionId main = add(module, "main", {kX}, kFloat, [&](Builder& b) {
        Value sum = b.param(0);
        for (int i = 0; i < calls; ++i) {
            b.set_origin({static_cast<std::uint32_t>(i + 1)});
            sum = b.call(f, std::vector{sum});
        }
        return sum;
    });
    set_entry(module, main);
    return checked(prune(inline_calls(std::move(module))));
}

Value chain_of(Builder& b, Value v, int operations) {
    b.set_origin({0});
    for (int i = 0; i < operations; ++i) v = b.emit(i % 2 == 0 ? Op::Sin : Op::Exp, {v});
    return v;
}

TEST(Inline, KeepsACallOfASubgraphIfThatIsShorter) {
    const auto functions = [](int calls, int operations) {
        return calls_of_subgraph(calls, [&](Builder& b) { return chain_of(b, b.param(0), operations); })
            .functions.size();
    };
    // Five lines around the body, and one for each call, against the body again.
    EXPECT_EQ(functions(2, 7), 1u);
    EXPECT_EQ(functions(2, 8), 2u);
    EXPECT_EQ(functions(3, 4), 1u);
    EXPECT_EQ(functions(3, 5), 2u);
    EXPECT_EQ(functions(1, 100), 1u);
}

TEST(Inline, NamesTheNodesOfASubgraphAfterItsUse) {
    const Module module = calls_of_subgraph(2, [](Builder& b) { return chain_of(b, b.param(0), 4); });
    const Function& main = module.functions[0];
    std::vector<std::string> ids;
    for (const Value value : main.blocks[0].insts) {
        if (main[value].op == Op::Sin) ids.push_back(module.origins[main[value].origin.index].id);
    }
    EXPECT_EQ(ids, (std::vector<std::string>{"use0/wave", "use0/wave", "use1/wave", "use1/wave"}));
}

// Other compilers find equal sums in two calls, but not equal samples.
TEST(Inline, SharesWhatTheCallsOfASubgraphWouldRepeat) {
    Module module;
    module.globals = {{.name = "t", .type = Type::of(Kind::Texture2D)}, {.name = "s", .type = Type::of(Kind::Sampler)}};
    const Param uv{"uv", kFloat2, Rate::Pixel, true};
    const FunctionId f = add(module, "f", {kX, uv}, kFloat, [&](Builder& b) {
        const Value texture = b.emit(Op::Global, b.module().globals[0].type, {}, 0);
        const Value sampler = b.emit(Op::Global, b.module().globals[1].type, {}, 1);
        const Value texel = b.emit(Op::Sample, {texture, sampler, b.param(1)});
        return b.emit(Op::Mul, {chain_of(b, b.param(0), 40), b.extract(texel, 0)});
    });
    module[f].inline_if_shorter = true;
    module.origins.push_back({});
    const FunctionId main = add(module, "main", {kX, uv}, kFloat, [&](Builder& b) {
        const Value once = b.call(f, std::vector{b.param(0), b.param(1)});
        return b.call(f, std::vector{once, b.param(1)});
    });
    set_entry(module, main);
    module = checked(prune(inline_calls(std::move(module))));
    EXPECT_EQ(names(module), std::vector<std::string>{"main"});
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

// --- turn_textures

// main(uv) calls f twice: with the engine's coordinates, and with those that `other` makes of them.
Module sampled_twice(const std::function<Value(Builder&, Value)>& other) {
    Module module;
    module.has_values_from_bottom = true;
    module.globals = {{.name = "t", .type = Type::of(Kind::Texture2D)}, {.name = "s", .type = Type::of(Kind::Sampler)}};
    const FunctionId f = add(module, "f", {{"at", kFloat2, Rate::Pixel}}, kFloat, [](Builder& b) {
        const Value texture = b.emit(Op::Global, b.module().globals[0].type, {}, 0);
        const Value sampler = b.emit(Op::Global, b.module().globals[1].type, {}, 1);
        return b.extract(b.emit(Op::Sample, {texture, sampler, b.param(0)}), 0);
    });
    const FunctionId main = add(module, "main", {{"uv", kFloat2, Rate::Pixel, true, true}}, kFloat, [&](Builder& b) {
        const Value uv = b.param(0), once = b.call(f, std::vector{uv});
        return b.emit(Op::Add, {once, b.call(f, std::vector{other(b, uv)})});
    });
    set_entry(module, main);
    return checked(prune(turn_textures(std::move(module))));
}

TEST(TurnTextures, PassesOnWhatAllCallersHaveFromTheEngine) {
    const Module same = sampled_twice([](Builder&, Value uv) { return uv; });
    EXPECT_EQ(count(same.functions[0], Op::Sub) + count(same.functions[1], Op::Sub), 0u);
    const Module other = sampled_twice([](Builder& b, Value uv) { return b.emit(Op::Sin, {uv}); });
    EXPECT_EQ(count(other.functions[0], Op::Sub), 1u);
    EXPECT_EQ(count(other.functions[1], Op::Sub), 1u);
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
        // Out of a branch too: the root depends on no loop.
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

}  // namespace
}  // namespace patina::ir
