// The verifier finds each kind of unsound function and says so at the right line of the dump.
#include <gtest/gtest.h>

#include <functional>

#include "compiler/ir/builder.h"
#include "compiler/ir/verify.h"

namespace patina::ir {
namespace {

// if (c) { y = x * x } else { y = x }, then a loop that adds to it: a sound function to break in many ways.
struct Sound {
    Module module;
    Value x, c, product, branch, result, loop, index, carried, sum, end;

    Sound() {
        module.structs.push_back({"Pair", {{"first", kFloat3}, {"second", kFloat}}});
        Function function;
        function.name = "f";
        function.params = {{"x", kFloat, Rate::Pixel}, {"c", kBool, Rate::Pixel}};
        function.result = kFloat;
        Builder b(module, function);
        x = b.param(0);
        c = b.param(1);
        branch = b.begin_if(c);
        product = b.emit(Op::Mul, {x, x});
        b.begin_else();
        b.end_if(std::vector{product}, std::vector{x});
        result = b.result(branch, 0);
        const Value begin = b.constant(kInt, {0}), limit = b.constant(kInt, {4});
        loop = b.begin_for(begin, limit, std::vector{result});
        index = b.loop_index();
        carried = b.loop_carried(0);
        sum = b.emit(Op::Add, {carried, x});
        b.end_for(std::vector{sum});
        end = b.result(loop, 0);
        b.ret(end);
        module.functions.push_back(std::move(function));
    }
    Function& function() { return module.functions[0]; }
    Inst& inst(Value v) { return function().insts[v.index]; }
    Value& operand(Value v, std::uint32_t i) { return function().operands[inst(v).first_operand + i]; }
    std::vector<Value>& body() { return function().blocks[0].insts; }
    std::vector<Value>& block(Value structure) { return function().blocks[inst(structure).data].insts; }
};

struct Break {
    const char* name;
    std::function<void(Sound&)> how;
    const char* reason;
};

class Verify : public testing::TestWithParam<Break> {};

TEST(VerifySound, HasNothingToSay) {
    Sound sound;
    EXPECT_EQ(verify(sound.module), "");
}

// A pass walks the functions in their order, and counts on having seen whatever a function calls.
TEST(VerifySound, ACalleeStandsBeforeItsCallers) {
    Sound sound;
    Function caller;
    caller.name = "caller";
    caller.params = {{"x", kFloat, Rate::Pixel}, {"c", kBool, Rate::Pixel}};
    caller.result = kFloat;
    Builder b(sound.module, caller);
    b.ret(b.call({0}, std::vector{b.param(0), b.param(1)}));
    sound.module.functions.push_back(std::move(caller));
    EXPECT_EQ(verify(sound.module), "");

    std::swap(sound.module.functions[0], sound.module.functions[1]);
    for (Inst& inst : sound.module.functions[0].insts) {
        if (inst.op == Op::Call) inst.data = 1;
    }
    const std::string text = verify(sound.module);
    EXPECT_NE(text.find("'f' does not come before its caller"), std::string::npos) << text;

    for (Inst& inst : sound.module.functions[0].insts) {
        if (inst.op == Op::Call) inst.data = 0;
    }
    EXPECT_NE(verify(sound.module).find("'caller' does not come before its caller"), std::string::npos);
}

TEST_P(Verify, SaysWhatIsWrong) {
    Sound sound;
    GetParam().how(sound);
    const std::string text = verify(sound.module);
    EXPECT_NE(text.find(GetParam().reason), std::string::npos) << text;
}

// What the function is broken with, and what is said about it.
const Break kBreaks[] = {
    {"UseBeforeDefinition", [](Sound& s) { s.operand(s.sum, 0) = s.end; }, "%14 is not visible here"},
    {"UseOfABranchOutside", [](Sound& s) { s.operand(s.sum, 1) = s.product; }, "%3 is not visible here"},
    {"UnknownValue", [](Sound& s) { s.operand(s.sum, 1) = Value{99}; }, "%99 is not visible here"},
    {"NoValue", [](Sound& s) { s.operand(s.sum, 1) = Value{}; }, "is not visible here"},
    {"WrongOperandType", [](Sound& s) { s.operand(s.sum, 1) = s.c; }, "add of (float, bool) is not a float"},
    {"WrongResultType", [](Sound& s) { s.inst(s.sum).type = kFloat3; }, "add of (float, float) is not a float3"},
    {"UnknownType", [](Sound& s) { s.inst(s.sum).type = Type::structure(7); }, "the type does not exist"},
    {"TooFewOperands", [](Sound& s) { s.inst(s.sum).operand_count = 1; }, "1 operands, not 2"},
    {"OperandsOutOfRange", [](Sound& s) { s.inst(s.sum).first_operand = 1000; },
     "the operands are not in the function"},
    {"StructureAsOperand", [](Sound& s) { s.operand(s.sum, 1) = s.branch; }, "is no operand of this"},
    {"ResultOfAValue", [](Sound& s) { s.operand(s.end, 0) = s.x; }, "is no operand of this"},
    {"ResultOutOfRange", [](Sound& s) { s.inst(s.end).data = 3; }, "there is no yielded value 3"},
    {"ConditionIsNoBool", [](Sound& s) { s.operand(s.branch, 0) = s.x; }, "the condition is not a bool"},
    {"LoopCountsWithFloats", [](Sound& s) { s.operand(s.loop, 1) = s.x; }, "a loop counts with ints"},
    {"NoReturn", [](Sound& s) { s.body().pop_back(); }, "the block has no end"},
    {"ReturnInTheMiddle", [](Sound& s) { std::swap(s.body()[s.body().size() - 1], s.body()[s.body().size() - 2]); },
     "not visible"},
    {"WrongReturnType", [](Sound& s) { s.function().result = kFloat3; }, "the function returns a float3"},
    {"YieldMissing", [](Sound& s) { s.block(s.loop).pop_back(); }, "the block has no end"},
    {"EmptyBlock", [](Sound& s) { s.block(s.branch).clear(); }, "a block is empty"},
    {"SharedBlock", [](Sound& s) { s.inst(s.loop).data = s.inst(s.branch).data; }, "has two owners"},
    {"UnknownBlock", [](Sound& s) { s.inst(s.loop).data = 50; }, "there is no block 50"},
    {"LoopWithoutIndex", [](Sound& s) { s.block(s.loop).erase(s.block(s.loop).begin()); },
     "a loop begins with its index"},
    {"TwoPlaces", [](Sound& s) { s.body().insert(s.body().begin() + 1, s.x); }, "is in two blocks or twice in one"},
    {"UnknownInstruction", [](Sound& s) { s.body().insert(s.body().begin(), Value{500}); },
     "there is no instruction 500"},
    {"UnknownParam", [](Sound& s) { s.inst(s.x).data = 9; }, "there is no param 9"},
    {"UnknownConstant", [](Sound& s) { s.module.constants.clear(); }, "there is no constant"},
    {"ConstantWithoutNumbers", [](Sound& s) { s.module.numbers.clear(); }, "numbers are not in the module"},
    {"DiscardInABranch",
     [](Sound& s) {
         s.inst(s.product).op = Op::DiscardIf;
         s.inst(s.product).type = Type::none();
         s.inst(s.product).operand_count = 1;
         s.operand(s.product, 0) = s.c;
     },
     "a discard may only be in the top block"},
    {"StageWithoutInputs", [](Sound& s) { s.module.stage.entry = {0}; }, "the stage's inputs are not"},
    {"StageWithoutEntry", [](Sound& s) { s.module.stage.entry = {4}; }, "entry function does not exist"},
};

INSTANTIATE_TEST_SUITE_P(Each, Verify, testing::ValuesIn(kBreaks),
                         [](const testing::TestParamInfo<Break>& info) { return std::string(info.param.name); });

// One instruction on its own, with operands of the given types.
std::string verdict(Op op, Type type, std::vector<Type> operands, std::uint32_t data = 0) {
    Module module;
    module.structs.push_back({"Pair", {{"first", kFloat3}, {"second", kFloat}}});
    module.array_of(kFloat2, 3);
    Function callee;
    callee.name = "callee";
    callee.params = {{"x", kFloat, Rate::Pixel}};
    callee.result = kFloat;
    Builder in_callee(module, callee);
    in_callee.ret(in_callee.param(0));
    module.functions.push_back(std::move(callee));

    Function function;
    function.name = "f";
    for (const Type operand : operands) function.params.push_back({"p", operand, Rate::Pixel});
    function.result = type;
    Builder b(module, function, {.fold = false});
    std::vector<Value> args;
    for (std::uint32_t i = 0; i < operands.size(); i++) args.push_back(b.param(i));
    // The builder asks no questions about a type that could not be made.
    const Value value = b.emit(op, Type::error(), args, data);
    b.ret(value);
    function.insts[value.index].type = type;
    module.functions.push_back(std::move(function));
    return verify(module);
}

TEST(VerifyTypes, AcceptsWhatTheOpsTableSays) {
    const Type pair = Type::structure(0), array = Type::array(0), matrix = Type::matrix(Scalar::Float, 3, 2);
    const Type texture = Type::of(Kind::Texture2D), sampler = Type::of(Kind::Sampler),
               int2 = Type::vector(Scalar::Int, 2);
    EXPECT_EQ(verdict(Op::Construct, kFloat4, {kFloat3, kFloat}), "");
    EXPECT_EQ(verdict(Op::Construct, kFloat4, {kFloat}), "");
    EXPECT_EQ(verdict(Op::Construct, pair, {kFloat3, kFloat}), "");
    EXPECT_EQ(verdict(Op::Construct, matrix, {kFloat2, kFloat2, kFloat2}), "");
    EXPECT_EQ(verdict(Op::Construct, array, {kFloat2, kFloat2, kFloat2}), "");
    EXPECT_EQ(verdict(Op::Extract, kFloat2, {matrix}, 2), "");
    EXPECT_EQ(verdict(Op::Insert, pair, {pair, kFloat}, 1), "");
    EXPECT_EQ(verdict(Op::Index, kFloat2, {array, kUint}), "");
    EXPECT_EQ(verdict(Op::Swizzle, kFloat2, {kFloat3}, 2 | 0 << 2), "");
    EXPECT_EQ(verdict(Op::Convert, Type::vector(Scalar::Half, 3), {kFloat3}), "");
    EXPECT_EQ(verdict(Op::Bitcast, kUint, {kFloat}), "");
    EXPECT_EQ(verdict(Op::Call, kFloat, {kFloat}), "");
    EXPECT_EQ(verdict(Op::Select, kFloat3, {kBool, kFloat3, kFloat3}), "");
    EXPECT_EQ(verdict(Op::Select, kFloat3, {Type::vector(Scalar::Bool, 3), kFloat3, kFloat3}), "");
    EXPECT_EQ(verdict(Op::MatMul, kFloat3, {matrix, kFloat2}), "");
    EXPECT_EQ(verdict(Op::MatMul, kFloat2, {kFloat3, matrix}), "");
    EXPECT_EQ(verdict(Op::Transpose, Type::matrix(Scalar::Float, 2, 3), {matrix}), "");
    EXPECT_EQ(verdict(Op::Sample, kFloat4, {texture, sampler, kFloat2}), "");
    EXPECT_EQ(verdict(Op::SampleGrad, kFloat4, {texture, sampler, kFloat2, kFloat2, kFloat2}), "");
    EXPECT_EQ(verdict(Op::TexelLoad, kFloat4, {texture, int2, kInt}), "");
    EXPECT_EQ(verdict(Op::TextureSize, int2, {texture, kInt}), "");
}

TEST(VerifyTypes, RefusesWhatItDoesNot) {
    const Type pair = Type::structure(0), matrix = Type::matrix(Scalar::Float, 3, 2);
    const Type texture = Type::of(Kind::Texture2D), sampler = Type::of(Kind::Sampler);
    EXPECT_NE(verdict(Op::Construct, kFloat4, {kFloat3, kFloat3}), "");
    EXPECT_NE(verdict(Op::Construct, kFloat4, {kFloat3, kInt}), "");
    EXPECT_NE(verdict(Op::Construct, pair, {kFloat, kFloat3}), "");
    EXPECT_NE(verdict(Op::Extract, kFloat, {kFloat3}, 3), "");
    EXPECT_NE(verdict(Op::Extract, kFloat, {kFloat}), "");
    EXPECT_NE(verdict(Op::Insert, pair, {pair, kFloat3}, 1), "");
    EXPECT_NE(verdict(Op::Index, kFloat, {kFloat3, kFloat}), "");
    EXPECT_NE(verdict(Op::Index, kFloat3, {pair, kInt}), "");
    EXPECT_NE(verdict(Op::Swizzle, kFloat2, {kFloat2}, 2), "");
    EXPECT_NE(verdict(Op::Convert, kInt, {kFloat2}), "");
    EXPECT_NE(verdict(Op::Bitcast, kInt, {kHalf}), "");
    EXPECT_NE(verdict(Op::Call, kFloat, {kFloat, kFloat}), "");
    EXPECT_NE(verdict(Op::Call, kFloat, {kFloat3}), "");
    EXPECT_NE(verdict(Op::Call, kFloat, {kFloat}, 1), "");  // itself
    EXPECT_NE(verdict(Op::Call, kFloat, {kFloat}, 5), "");
    EXPECT_NE(verdict(Op::MatMul, kFloat3, {matrix, kFloat3}), "");
    EXPECT_NE(verdict(Op::Sample, kFloat4, {texture, sampler, kFloat3}), "");
    EXPECT_NE(verdict(Op::Sample, kFloat4, {sampler, texture, kFloat2}), "");
}

TEST(VerifyText, PointsAtTheLine) {
    Sound sound;
    sound.operand(sound.sum, 1) = sound.c;
    EXPECT_EQ(verify(sound.module),
              "func f(x: float pixel, c: bool pixel) -> float {\n"
              "  %0 = param float x\n"
              "  %1 = param bool c\n"
              "  %7 = constant int 0\n"
              "  %8 = constant int 4\n"
              "  %2 = if (%1) {\n"
              "    %3 = mul float (%0, %0)\n"
              "    yield (%3)\n"
              "  } else {\n"
              "    yield (%0)\n"
              "  }\n"
              "  %6 = result float (%2) 0\n"
              "  %9 = for (%7, %8, %6) {\n"
              "    %10 = loopIndex int\n"
              "    %11 = loopCarried float 0\n"
              ">   %12 = add float (%11, %1)\n"
              "    ^ add of (float, bool) is not a float\n"
              "    yield (%12)\n"
              "  }\n"
              "  %14 = result float (%9) 0\n"
              "  return (%14)\n"
              "}\n");
}

}  // namespace
}  // namespace patina::ir
