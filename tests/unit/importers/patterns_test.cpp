// Patterns of imported graphs, filled with values.
#include "compiler/importers/patterns.h"

#include <gtest/gtest.h>

namespace patina::importers::terms {
namespace {

const Term kUv = link("@uv0", Type::Float2), kX = link("x", Type::Float), kColor = link("$_Tint.rgb", Type::Float3);

std::string text_of(std::string_view pattern, const std::vector<Term>& terms, Type type = Type::Float) {
    return computed(pattern, terms, type).text();
}

TEST(Patterns, HaveTheFewestBrackets) {
    const Term sum = expression("x + y", Type::Float), product = expression("x * y", Type::Float);
    EXPECT_EQ(text_of("a * b", {sum, sum}), "(x + y) * (x + y)");
    EXPECT_EQ(text_of("a + b", {product, sum}), "x * y + x + y");
    EXPECT_EQ(text_of("a - b", {product, sum}), "x * y - (x + y)");
    EXPECT_EQ(text_of("a / b", {product, product}), "x * y / (x * y)");
    EXPECT_EQ(text_of("a > b ? a : b", {sum, product}), "x + y > x * y ? x + y : x * y");
    EXPECT_EQ(text_of("-a", {product}), "-x * y");
    EXPECT_EQ(text_of("-a", {sum}), "-(x + y)");
    EXPECT_EQ(text_of("f(a)", {sum}), "f(x + y)");
}

TEST(Patterns, LeaveOutWhatChangesNothing) {
    EXPECT_EQ(text_of("a * b + c", {kUv, constant({1, 1}), constant({0, 0})}, Type::Float2), "@uv0");
    EXPECT_EQ(text_of("a / b - c", {kX, number_term(1), number_term(0)}), "x");
    EXPECT_EQ(text_of("a - b", {kX, number_term(-1)}), "x + 1");
    EXPECT_EQ(text_of("a * b", {number_term(-1), kX}), "-x");
    // A vector of ones makes a vector of a number.
    EXPECT_EQ(text_of("a * b", {kX, constant({1, 1, 1})}, Type::Float3), "x * float3(1)");
}

TEST(Patterns, MultiplyWithoutBrackets) {
    const Term factors = expression("x * y", Type::Float);
    EXPECT_EQ(product({kColor, factors}).text(), "$_Tint.rgb * x * y");
    EXPECT_EQ(product({kColor, factors}).type, Type::Float3);
    EXPECT_EQ(product({number_term(2), factors, number_term(1)}).text(), "2 * x * y");
    EXPECT_TRUE(product({}).is_all(1));
    // Whoever writes a pattern decides the order.
    EXPECT_EQ(text_of("a * b", {kX, factors}), "x * (x * y)");
}

TEST(Patterns, ComputeNumbers) {
    EXPECT_EQ(text_of("(a - b) / (c - b)", {kX, number_term(-1), number_term(1)}), "(x + 1) / 2");
    EXPECT_EQ(text_of("sin(a + 1)", {number_term(1)}), "sin(2)");
    EXPECT_EQ(text_of("a * b", {constant({1, 2, 3}), number_term(2)}, Type::Float3), "float3(2, 4, 6)");
    EXPECT_EQ(text_of("a / b", {number_term(1), number_term(0)}), "1 / 0");
    EXPECT_EQ(text_of("a < b ? c : d", {number_term(1), number_term(2), kX, kUv}), "x");
}

TEST(Patterns, ReadComponents) {
    EXPECT_EQ(text_of("float2(a.x, 1 - a.y)", {kUv}, Type::Float2), "float2(@uv0.x, 1 - @uv0.y)");
    EXPECT_EQ(text_of("a.x", {expression("x + y", Type::Float2)}), "(x + y).x");
    const Term whole = computed("a", {kColor}, Type::Float3);
    EXPECT_EQ(whole.text(), "$_Tint.rgb");
    EXPECT_EQ(whole.type, Type::Float3);
}

TEST(Patterns, OfATableHavePlaces) {
    const Pattern pattern = pattern_of("lerp({from}, $, {t.x})");
    EXPECT_EQ(pattern.places, (std::vector<std::string>{"from", "t.x"}));
    const Term made = filled(
        pattern.tree, [&](const nodelang::Expr& part) { return place_of(part) || is_self(part) ? &kX : nullptr; },
        Type::Float);
    EXPECT_EQ(made.text(), "lerp(x, x, x)");
}

TEST(Terms, KeepWhatTheyAreMadeOf) {
    EXPECT_EQ(swizzled(link("mask", Type::Float4), "xyz").text(), "mask.xyz");
    EXPECT_EQ(swizzled(swizzled(link("mask", Type::Float4), "zyx"), "x").text(), "mask.z");
    EXPECT_EQ(swizzled(swizzled(link("mask", Type::Float3), "zyx"), "zyx").text(), "mask");
    EXPECT_EQ(swizzled(flipped(kUv), "y").text(), "1 - @uv0.y");
    EXPECT_EQ(swizzled(converted(kX, Type::Float3), "y").text(), "x");
    EXPECT_EQ(converted(kUv, Type::Float4).text(), "float4(@uv0, 0, 1)");
    const Term parts[] = {swizzled(kColor, "x"), swizzled(kColor, "y"), number_term(0)};
    EXPECT_EQ(vector_of(Type::Float3, parts).text(), "float3($_Tint.rgb.xy, 0)");
}

}  // namespace
}  // namespace patina::importers::terms
