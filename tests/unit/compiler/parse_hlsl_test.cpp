// The parser of files that begin with "#pragma hlsl": more statements and expressions, jumps, and the preprocessor.
#include "tests/unit/compiler/parsed.h"

using namespace patina;
using namespace patina::nodelang;

namespace {

std::string hlsl(const std::string& function) {
    const auto parsed = parse(As::File, "#pragma hlsl\n" + function);
    EXPECT_EQ(parsed->errors(), std::vector<std::string>{});
    return parsed->ast.functions.empty() ? "nothing" : show(parsed->ast.functions[0].body);
}

}  // namespace

TEST(ParseHlsl, StatementsAndExpressions) {
    EXPECT_EQ(hlsl("void f() { float a = 1, b; a = b = 2; a++; --b; a += (b -= 1); c = d++; }"),
              "{ float a = 1; float b; a = (= b 2); a += 1; b -= 1; a += (-= b 1); c = (later += d 1); }");
    EXPECT_EQ(hlsl("void f() { x = (float3)y * (int)-z; w = (a) * (b); v = (S)0; }"),
              "{ x = (* (float3() y) (int() (- z))); w = (* a b); v = (S() 0); }");
    EXPECT_EQ(hlsl("void f() { x = (a = 1, b, c) + F(d, e); }"), "{ x = (+ (, (, (= a 1) b) c) (F() d e)); }");
    EXPECT_EQ(hlsl("void f() { for (int i = 9; i >= 0; i -= 3, j++) G(i); do H(); while (c); }"),
              "{ { int i = 9; while (>= i 0){ (G() i); }{ i -= 3; j += 1; } } do c{ (H()); } }");
    EXPECT_EQ(hlsl("void f() { switch (x) { case 0: case 1: a = 1; break; default: a = 2; } }"),
              "{ { if (|| (== x 0) (== x 1)){ a = 1; } else{ a = 2; } } }");
}

TEST(ParseHlsl, JumpsBecomeBranches) {
    EXPECT_EQ(hlsl("void f() { if (a) return; b = 1; }"), "{ if a{ } else{ b = 1; } }");
    EXPECT_EQ(hlsl("float f() { if (a) return 1; b = 1; return 2; }"),
              "{ if a{ return 1; } else{ b = 1; return 2; } }");
    EXPECT_EQ(hlsl("float f() { if (a) { if (b) return 1; c = 1; } return 2; }"),
              "{ float result; bool done = false; if a{ if b{ result = 1; done = true; } else{ c = 1; } } else{ } "
              "if (! done){ result = 2; } else{ } return result; }");
    EXPECT_EQ(hlsl("void f() { while (a) { if (b) continue; c = 1; } }"), "{ while a{ if b{ } else{ c = 1; } } }");
    EXPECT_EQ(hlsl("void f() { while (a) { if (b) break; c = 1; } }"),
              "{ { bool running = true; while a and running{ if b{ running = false; } else{ c = 1; } } } }");
    EXPECT_EQ(hlsl("void f() { while (a) { if (b) { if (c) continue; d = 1; } e = 1; } }"),
              "{ while a{ bool skipped = false; if b{ if c{ skipped = true; } else{ d = 1; } } else{ } "
              "if (! skipped){ e = 1; } else{ } } }");
}

// What the language lacks is parsed all the same, so that the rest of the function is.
TEST(ParseHlsl, WhatTheLanguageLacks) {
    const auto parsed = parse(As::File,
                              "#pragma hlsl\nfloat z;\nvoid f() { static float a = 1; float b[2][3]; if (c) discard; "
                              "struct S { float x; }; d = 1; }");
    EXPECT_EQ(parsed->errors(), (Errors{"[float] a variable of the file is 'const', or a parameter brings it",
                                        "[static] no variable keeps its value between two calls: write 'static const'",
                                        "[[] an array of arrays: write one with the product of the sizes",
                                        "[discard] a function leaves out no pixel: use the alpha clip of the surface",
                                        "[struct] a struct inside of a function: declare it before the function"}));
    EXPECT_EQ(show(parsed->ast.functions[0].body), "{ float a = 1; float b[3]; if c{ (discard()); } else{ } d = 1; }");
}

TEST(ParseHlsl, Preprocessor) {
    EXPECT_EQ(hlsl("#define TWO 2\n#define ADD(a, b) ((a) + (b))\n#define GLUE(a) x##a\n"
                   "void f() { a = ADD(TWO, GLUE(1)); }"),
              "{ a = (+ 2 x1); }");
    EXPECT_EQ(hlsl("#define G(a, ...) H(__VA_ARGS__)\n#define N(...) 1\n#define E() e\nvoid f() { a = G(1, 2, (3)) + "
                   "N() + E(); }"),
              "{ a = (+ (+ (H() 2 3) 1) e); }");
    EXPECT_EQ(hlsl("void f() {\n#if defined(A) || !B\na = 1;\n#elif 1\na = 2;\n#else\n'\n#endif\n}"), "{ a = 1; }");
    const auto errors = [](const std::string& text) { return parse(As::File, "#pragma hlsl\n" + text)->errors(); };
    EXPECT_EQ(errors("#if A == 1\n#endif\n"),
              Errors{"[A] expected a macro whose value is known here, or 'defined(...)', not 'A'"});
    EXPECT_EQ(errors("#if 1\n"), Errors{"[#] expected '#endif' after this, not the end of the file"});
    EXPECT_EQ(errors("#define A\n'"), Errors{"['] ''' is not allowed here"});
    EXPECT_EQ(errors("#else\n"), Errors{"[else] expected '#if' before this, not '#else'"});
    EXPECT_EQ(errors("#define F(a) a\nvoid f() { b = F(1, 2) + 3; }"),
              Errors{"[F] wrong number of arguments for 'F': it takes 1, not 2"});
}

// Macros that stand for themselves many times over end, with a message.
TEST(ParseHlsl, MacrosAreBounded) {
    std::string text = "#pragma hlsl\n#define M0 x +\n";
    for (int i = 1; i < 40; ++i) text += fmt::format("#define M{} M{} M{}\n", i, i - 1, i - 1);
    const auto parsed = parse(As::File, text + "void f() { a = M39 x; }");
    ASSERT_FALSE(parsed->errors().empty());
    EXPECT_NE(parsed->errors()[0].find("tokens of macros are too many"), std::string::npos) << parsed->errors()[0];
}

TEST(ParseHlsl, EveryPrefixOfAFileIsRead) {
    const std::string text =
        "#pragma hlsl\n#define F(a, b) a##b\n#if defined(F) && (1 + 2 * 3) == 7\nstruct S { float3 x, y : N; "
        "};\n#endif\n"
        "static const float k[2] = {1, 2}, z = 3;\nfloat f(inout float a, in S s : T) : U { float b = (int)a++, c;\n"
        "[unroll] for (int i = 9; i >= 0; i -= 3) { if (a) continue; else break; }\n"
        "do { switch (i) { case 0: return F(a, ); case 1: case 2: break; default: c = 1; } } while (b = c);\n"
        "while (1) { return (S)0; } return a; }\n";
    for (std::size_t length = 0; length < text.size(); ++length) {
        parse(As::File, text.substr(0, length));
        std::string broken = text;
        broken.erase(length, 1);
        parse(As::File, broken);
    }
}
