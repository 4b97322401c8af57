// Expressions that code makes: their text has the fewest parentheses, and is the same tree again.
#include "compiler/nodelang/tree.h"

#include <gtest/gtest.h>

#include <random>

namespace patina::nodelang {
namespace {

void expect_same(const Expr& a, const Expr& b, const std::string& text) {
    // "-1" is a number that was made, and a sign before a number that was read.
    double first = 0, second = 0;
    if (is_number(a, first) && is_number(b, second)) {
        EXPECT_FLOAT_EQ(first, second) << text;
        return;
    }
    ASSERT_EQ(a.kind, b.kind) << text;
    EXPECT_EQ(a.text, b.text) << text;
    ASSERT_EQ(a.args.size(), b.args.size()) << text;
    for (std::size_t i = 0; i < a.args.size(); ++i) expect_same(*a.args[i], *b.args[i], text);
}

TEST(Trees, HaveTheTextThatAPersonWouldWrite) {
    for (const std::string text : {"a + b * c",
                                   "(a + b) * c",
                                   "a - (b - c)",
                                   "a - b - c",
                                   "a / (b * c)",
                                   "-a * b",
                                   "-(a + b)",
                                   "-(-a)",
                                   "!a",
                                   "a < b && c == d || e",
                                   "a ? b : c ? d : e",
                                   "(a ? b : c) ? d : e",
                                   "(a ? b : c) + 1",
                                   "(a + b).xyz",
                                   "f(a, b + c).x",
                                   "m[1].xy",
                                   "(a * b)[i + 1]",
                                   "$_Tint.rgb",
                                   "@uv0",
                                   "$_Map.Sample(uv, 2)",
                                   "a << 1 & b",
                                   "0.50",
                                   "1e-5",
                                   "3u",
                                   "true",
                                   "float3(0)",
                                   "~a ^ b | c"}) {
        const Tree tree = parsed_tree(text);
        ASSERT_TRUE(tree) << text;
        EXPECT_EQ(printed(*tree), text);
    }
    EXPECT_EQ(printed(*parsed_tree("((a) + ((b * c)))")), "a + b * c");
    EXPECT_FALSE(parsed_tree("a +"));
    EXPECT_FALSE(parsed_tree(""));
}

TEST(Trees, OwnTheirParts) {
    Tree sum;
    {
        const Tree long_one = parsed_tree("f(a + b, c)");
        sum = arg(long_one, 0);
    }
    EXPECT_EQ(printed(*binary("*", sum, number(-0.5))), "(a + b) * -0.5");
    EXPECT_EQ(printed(*member(number(-1), "x")), "(-1).x");
    EXPECT_EQ(printed(*call("max", {name("$_X"), choice(flag(true), name("a"), name("@uv0"))})),
              "max($_X, true ? a : @uv0)");
    const Tree other =
        replaced(sum, [](const Tree& part) { return part->text == "a" ? unary("-", name("x")) : nullptr; });
    EXPECT_EQ(printed(*other), "-x + b");
}

Tree random_tree(std::mt19937& random, int depth) {
    const auto next = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
    const auto part = [&] { return random_tree(random, depth - 1); };
    static constexpr const char* kBinary[] = {"||", "&&", "|",  "^",  "&", "==", "!=", "<", ">",
                                              "<=", ">=", "<<", ">>", "+", "-",  "*",  "/", "%"};
    static constexpr const char* kUnary[] = {"-", "!", "~", "+"};
    switch (depth == 0 ? next(3) : next(9)) {
        case 0: return name("a");
        case 1: return number(next(9) - 4);
        case 2: return name("$_Tint");
        case 3: return unary(kUnary[next(4)], part());
        case 4: return choice(part(), part(), part());
        case 5: return member(part(), "x");
        case 6: return call("f", {part(), part()});
        case 7: return index(part(), part());
        default: return binary(kBinary[next(18)], part(), part());
    }
}

TEST(Trees, AreTheSameWhenTheirTextIsRead) {
    std::mt19937 random(7);
    for (int i = 0; i < 20000; ++i) {
        const Tree tree = random_tree(random, 4);
        const std::string text = printed(*tree);
        const Tree read = parsed_tree(text);
        ASSERT_TRUE(read) << text;
        expect_same(*tree, *read, text);
        if (HasFailure()) return;
    }
}

}  // namespace
}  // namespace patina::nodelang
