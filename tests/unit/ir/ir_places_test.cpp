// Where things are computed: textures of all callers, loops, rates, discards.
#include "compiler/ir/dump.h"
#include "compiler/ir/passes/passes.h"
#include "tests/unit/ir/ir_testing.h"

namespace patina::ir {
namespace {

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
