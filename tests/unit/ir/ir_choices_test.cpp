// The builder knows the condition of a choice on both sides of it (fold/choices.h).
#include "tests/unit/ir/ir_testing.h"

namespace patina::ir {
namespace {

struct Choices : testing::Test {
    Module module{};
    Function function{.name = "f", .params = {kC, {"d", kBool, Rate::Pixel}, kX, kY, kZ}};
    Builder b{module, function};
    Value c = b.param(0), d = b.param(1), x = b.param(2), y = b.param(3), z = b.param(4);

    Value select(Value condition, Value yes, Value no) { return b.emit(Op::Select, kFloat, {condition, yes, no}); }
    Value mul(Value left, Value right) { return b.emit(Op::Mul, {left, right}); }
};

TEST_F(Choices, TheSameConditionIsKnownInside) {
    EXPECT_EQ(select(c, mul(select(c, x, y), z), x), select(c, mul(x, z), x));
    EXPECT_EQ(select(c, x, mul(select(c, x, y), z)), select(c, x, mul(y, z)));
    const Value deep = b.emit(Op::Sin, {mul(z, select(c, x, y))});
    EXPECT_EQ(select(c, deep, z), select(c, b.emit(Op::Sin, {mul(z, x)}), z));
}

TEST_F(Choices, AnotherConditionIsNot) {
    const Value inner = mul(select(d, x, y), z);
    const Value outer = select(c, inner, x);
    EXPECT_EQ(b.args(outer)[1], inner);
}

// A pass makes branches of the text of what keywords choose.
TEST_F(Choices, KeywordsAreLeft) {
    module.keywords.emplace_back().property = "MAP";
    module.globals = {{.name = "MAP", .type = kBool, .keyword = 0}};
    const Value keyword = b.emit(Op::Global, kBool, {}, 0);
    const Value inner = mul(select(keyword, x, y), z);
    EXPECT_EQ(b.args(select(keyword, inner, x))[1], inner);
}

// A sample or a call is not made twice for it.
TEST_F(Choices, WhatCostsMuchIsNotRepeated) {
    const FunctionId sine =
        add(module, "sine", {kX}, kFloat, [](Builder& other) { return long_chain(other, other.param(0)); });
    const Value called = b.call(sine, std::vector{select(c, x, y)});
    EXPECT_EQ(b.args(select(c, called, z))[1], called);
    const Value slope = b.emit(Op::Ddx, {select(c, x, y)});
    EXPECT_EQ(b.args(select(c, slope, z))[1], slope);
}

}  // namespace
}  // namespace patina::ir
