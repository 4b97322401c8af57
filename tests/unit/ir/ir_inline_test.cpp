// inline_calls: which calls it spells out. ir_passes_test.cpp has the other passes.
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

}  // namespace
}  // namespace patina::ir
