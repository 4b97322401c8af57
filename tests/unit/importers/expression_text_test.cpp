// Expressions of imported graphs as text.
#include "compiler/importers/expression_text.h"

#include <gtest/gtest.h>

namespace patina::importers::terms {
namespace {

TEST(ExpressionText, LeavesOutWhatNobodyWrites) {
    EXPECT_EQ(folded("(dotProduct - (-1)) / (1 - (-1))"), "(dotProduct + 1) / 2");
    EXPECT_EQ(folded("x + (-0.5)"), "x - 0.5");
    EXPECT_EQ(folded("(1 - 0.35) * $_Hue"), "0.65 * $_Hue");
    EXPECT_EQ(folded("Rotate((uv) / float2(0.5, 0.25), -radians(30), 0)"),
              "Rotate(uv / float2(0.5, 0.25), -radians(30), 0)");
    EXPECT_EQ(folded("sin(1 + 1)"), "sin(2)");
    EXPECT_EQ(folded("-1 * subtract"), "-subtract");
}

TEST(ExpressionText, KeepsBracketsThatChangeTheValue) {
    for (const std::string each : {"(a + b) * c", "a - (b - c)", "x * (-1)", "(-1) * x", "max(uv, 0)", "-1 * 2",
                                   "(1 / 0) * x", "(a, b)", "f((a + 1) * 2)", "(1 + 2 * 3) * x", "$_T.Sample(uv)"})
        EXPECT_EQ(folded(each), each);
}

}  // namespace
}  // namespace patina::importers::terms
