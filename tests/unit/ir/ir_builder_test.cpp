// The builder: what it hands back, where it puts things, and that it stays linear.
#include <gtest/gtest.h>

#include "compiler/ir/builder.h"
#include "compiler/ir/dump.h"
#include "compiler/ir/verify.h"

namespace patina::ir {
namespace {

Function function_of(std::vector<Param> params, Type result) {
    Function function;
    function.name = "f";
    function.params = std::move(params);
    function.result = result;
    return function;
}

std::string finished(Module& module, Function function) {
    module.functions.push_back(std::move(function));
    EXPECT_EQ(verify(module), "");
    return dump(module, module.functions.back());
}

std::size_t count(const Function& function, Op op) {
    std::size_t n = 0;
    for (const Block& block : function.blocks) {
        for (const Value value : block.insts) n += function[value].op == op ? 1 : 0;
    }
    return n;
}

TEST(Builder, NumbersValues) {
    Module module;
    Function function = function_of({{"x", kFloat, Rate::Pixel}, {"y", kFloat, Rate::Pixel}}, kFloat);
    Builder b(module, function);
    const Value x = b.param(0), y = b.param(1);
    EXPECT_EQ(b.param(0), x);
    EXPECT_EQ(b.emit(Op::Mul, {x, y}), b.emit(Op::Mul, {y, x}));
    EXPECT_NE(b.emit(Op::Sub, {x, y}), b.emit(Op::Sub, {y, x}));
    EXPECT_NE(b.emit(Op::Add, {x, y}), b.emit(Op::Mul, {x, y}));
    EXPECT_EQ(b.constant(kFloat, {0.25}), b.constant(kFloat, {0.25}));
    EXPECT_NE(b.constant(kFloat, {0.0}), b.constant(kFloat, {-0.0}));
    EXPECT_NE(b.constant(kFloat, {1}), b.constant(kInt, {1}));
    EXPECT_EQ(module.constants.size(), 5u);
}

// The order that the author wrote stays: only numbering sees through it.
TEST(Builder, KeepsTheOrderOfOperands) {
    Module module;
    Function function = function_of({{"x", kFloat, Rate::Pixel}}, kFloat);
    Builder b(module, function);
    const Value x = b.param(0), two = b.constant(kFloat, {2});
    const Value product = b.emit(Op::Mul, {two, x});
    EXPECT_EQ(b.args(product)[0], two);
    EXPECT_EQ(b.args(product)[1], x);
}

TEST(Builder, EmitsWhatItIsToldWithoutFolding) {
    Module module;
    Function function = function_of({{"x", kFloat, Rate::Pixel}}, kFloat);
    Builder b(module, function, {.fold = false});
    const Value x = b.param(0), zero = b.constant(kFloat, {0}), tenth = b.constant(kFloat, {0.1});
    const Value sum = b.emit(Op::Add, {x, zero});
    const Value again = b.emit(Op::Add, {x, zero});
    EXPECT_NE(sum, again);
    EXPECT_EQ(b[b.emit(Op::Mul, {tenth, tenth})].op, Op::Mul);
    EXPECT_EQ(b.constant_of(tenth)[0], 0.1);  // every digit, for the interpreter in double
    b.ret(again);
    EXPECT_EQ(finished(module, std::move(function)),
              "func f(x: float pixel) -> float {\n"
              "  %0 = param float x\n"
              "  %1 = constant float 0\n"
              "  %2 = constant float 0.1\n"
              "  %3 = add float (%0, %1)\n"
              "  %4 = add float (%0, %1)\n"
              "  %5 = mul float (%2, %2)\n"
              "  return (%4)\n"
              "}\n");
}

TEST(Builder, FoldsInTheTypesPrecision) {
    Module module;
    Function function = function_of({}, kFloat);
    Builder b(module, function);
    const Value tenth = b.constant(kFloat, {0.1});
    EXPECT_EQ(b.constant_of(tenth)[0], static_cast<double>(0.1f));
    const Value third = b.constant(kFloat, {1.0 / 3});
    const Value product = b.emit(Op::Mul, {third, third});
    EXPECT_EQ(b.constant_of(product)[0], static_cast<double>((1 / 3.f) * (1 / 3.f)));
}

// A value of one branch is not seen in the other, nor after both; a value from before is seen in both.
TEST(Builder, ScopesFollowTheBlocks) {
    Module module;
    Function function = function_of({{"x", kFloat, Rate::Pixel}, {"c", kBool, Rate::Pixel}}, kFloat);
    Builder b(module, function);
    const Value x = b.param(0), before = b.emit(Op::Sin, {x});
    b.begin_if(b.param(1));
    EXPECT_EQ(b.emit(Op::Sin, {x}), before);
    const Value in_then = b.emit(Op::Cos, {x});
    b.begin_else();
    const Value in_else = b.emit(Op::Cos, {x});
    EXPECT_NE(in_else, in_then);
    const Value branch = b.end_if(std::vector{in_then}, std::vector{in_else});
    EXPECT_NE(b.emit(Op::Cos, {x}), in_then);
    const Value result = b.result(branch, 0);
    EXPECT_EQ(b.result(branch, 0), result);
    b.ret(b.emit(Op::Add, {result, before}));
    finished(module, std::move(function));
}

// Leaves stand at the head of the body, so one first asked for inside a branch serves everywhere.
TEST(Builder, LeavesAreSeenEverywhere) {
    Module module;
    Function function = function_of({{"x", kFloat, Rate::Pixel}, {"c", kBool, Rate::Pixel}}, kFloat);
    Builder b(module, function);
    b.begin_if(b.param(1));
    const Value inside = b.emit(Op::Mul, {b.param(0), b.constant(kFloat, {3})});
    b.begin_else();
    const Value outside = b.emit(Op::Add, {b.param(0), b.constant(kFloat, {3})});
    const Value branch = b.end_if(std::vector{inside}, std::vector{outside});
    b.ret(b.result(branch, 0));
    EXPECT_EQ(count(function, Op::Constant), 1u);
    EXPECT_EQ(count(function, Op::Param), 2u);
    finished(module, std::move(function));
}

TEST(Builder, BranchesThatYieldTheSameAreThat) {
    Module module;
    Function function = function_of({{"x", kFloat, Rate::Pixel}, {"c", kBool, Rate::Pixel}}, kFloat);
    Builder b(module, function);
    const Value x = b.param(0);
    b.begin_if(b.param(1));
    b.begin_else();
    const Value branch = b.end_if(std::vector{x}, std::vector{x});
    EXPECT_EQ(b.result(branch, 0), x);
}

TEST(Builder, Loops) {
    Module module;
    Function function = function_of({{"x", kFloat, Rate::Pixel}}, kFloat);
    Builder b(module, function);
    const Value x = b.param(0), begin = b.constant(kInt, {0}), end = b.constant(kInt, {4});
    const Value loop = b.begin_for(begin, end, std::vector{x, x});
    b.begin_if(b.emit(Op::Greater, {b.loop_carried(0), x}));
    EXPECT_EQ(b.type(b.loop_index()), kInt);  // of the loop around the if
    b.begin_else();
    b.end_if({}, {});
    b.end_for(std::vector{b.emit(Op::Mul, {b.loop_carried(0), x}), b.loop_carried(1)});
    EXPECT_EQ(b.result(loop, 1), x);  // handed on unchanged
    b.ret(b.result(loop, 0));
    EXPECT_EQ(finished(module, std::move(function)),
              "func f(x: float pixel) -> float {\n"
              "  %0 = param float x\n"
              "  %1 = constant int 0\n"
              "  %2 = constant int 4\n"
              "  %3 = for (%1, %2, %0, %0) {\n"
              "    %4 = loopIndex int\n"
              "    %5 = loopCarried float 0\n"
              "    %6 = loopCarried float 1\n"
              "    %7 = greater bool (%5, %0)\n"
              "    %8 = if (%7) {\n"
              "      yield\n"
              "    } else {\n"
              "      yield\n"
              "    }\n"
              "    %11 = mul float (%5, %0)\n"
              "    yield (%11, %6)\n"
              "  }\n"
              "  %13 = result float (%3) 0\n"
              "  return (%13)\n"
              "}\n");
}

TEST(Builder, NamesOnlyWhatHasNoNameAndIsNoLeaf) {
    Module module;
    Function function = function_of({{"x", kFloat, Rate::Pixel}}, kFloat);
    Builder b(module, function);
    const Value x = b.param(0), wave = b.emit(Op::Sin, {x});
    b.name(x, module.intern("leaf"));
    b.name(wave, module.intern("wave"));
    b.name(wave, module.intern("other"));
    EXPECT_FALSE(b[x].name);
    EXPECT_EQ(module.name_of(b[wave].name), "wave");
}

TEST(Builder, AcceptsTheOperandsOfAnotherInstruction) {
    Module module;
    Function function = function_of({{"x", kFloat, Rate::Pixel}, {"y", kFloat, Rate::Pixel}}, kFloat);
    Builder b(module, function);
    const Value sum = b.emit(Op::Add, {b.param(0), b.param(1)});
    for (int i = 0; i < 100; i++) {
        const Value difference = b.emit(Op::Sub, kFloat, b.args(sum));
        EXPECT_EQ(b.args(difference)[1], b.param(1));
        b.emit(Op::Mul, {difference, b.constant(kFloat, {i + 2.0})});
    }
}

// tests/bench shows that the time grows with the length.
TEST(Builder, KeepsLongChainsAndLadders) {
    for (const bool is_ladder : {false, true}) {
        Module module;
        Function function = function_of({{"x", kFloat, Rate::Pixel}}, kFloat);
        Builder b(module, function);
        Value value = b.param(0);
        for (int i = 0; i < 10000; i++) {
            value =
                is_ladder ? b.emit(Op::Mul, {value, value}) : b.emit(Op::Add, {value, b.constant(kFloat, {i + 1.0})});
        }
        b.ret(value);
        EXPECT_EQ(count(function, is_ladder ? Op::Mul : Op::Add), 10000u);
        finished(module, std::move(function));
    }
}

// A struct that is written member by member, over and over: what was written is known, and only the first values of
// both members are read from it.
TEST(Builder, ReadsNothingBackFromLongInsertChains) {
    Module module;
    module.structs.push_back({"Pair", {{"a", kFloat}, {"b", kFloat}}});
    const Type pair = Type::structure(0);
    Function function = function_of({{"p", pair, Rate::Pixel}}, kFloat);
    Builder b(module, function);
    Value whole = b.param(0), sum = b.constant(kFloat, {0});
    for (int i = 0; i < 20000; i++) {
        const Value number = b.emit(Op::Add, {b.extract(whole, 0), b.constant(kFloat, {i + 1.0})});
        whole = b.emit(Op::Insert, pair, {whole, number}, static_cast<std::uint32_t>(i % 2));
        sum = b.emit(Op::Add, {sum, b.extract(whole, 1)});
    }
    b.ret(sum);
    EXPECT_EQ(count(function, Op::Extract), 2u);
    EXPECT_EQ(count(function, Op::Add), 39999u);  // the sum begins with 0
    finished(module, std::move(function));
}

}  // namespace
}  // namespace patina::ir
