// Custom functions of Unity's shader graphs: what HLSL lets its authors leave out. The expected numbers are those of
// HLSL, worked out by hand.
#include <gtest/gtest.h>

#include <array>

#include "tests/unit/importers/shadergraph/shadergraph_import.h"

namespace patina::importers {
namespace {

using Three = std::array<double, 3>;

// What the code gives for A = (0.25, 0.5, 0.75) and B = 3; its node is for every target.
Three value_of(const std::string& body) {
    const Imported made = import_graph(one_node(custom(body), 2));
    EXPECT_EQ(remarks(made, Remark::Kind::Changed) + remarks(made, Remark::Kind::LeftOut), "") << body;
    const std::string& code = text_of(made, "Glow.node.hlsl");
    const std::string path = save_shader_graph("Glow.node.hlsl", code);
    const std::pair<std::string, std::string> arguments[] = {{"A", "0.25,0.5,0.75"}, {"B", "3"}};
    const EvalResult result = compiler().evaluate(path, arguments);
    for (const Diagnostic& each : result.diagnostics) ADD_FAILURE() << body << "\n" << code << to_text(each);
    if (!result.ok || result.outputs.empty() || result.outputs[0].values.size() != 3) return {-999, -999, -999};
    expect_compiles(made, body);
    const std::vector<double>& values = result.outputs[0].values;
    return {values[0], values[1], values[2]};
}

struct Row {
    const char* body;
    Three value;
};
void expect_values(std::initializer_list<Row> rows) {
    for (const Row& row : rows) {
        const Three value = value_of(row.body);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(value[i], row.value[i], 1e-12) << row.body << " at " << i;
    }
}

TEST(ShaderGraphConversions, CastsAreCalls) {
    expect_values({{"Out = (float3)A.x;", {0.25, 0.25, 0.25}},
                   {"Out = (float)3 / 2;", {1.5, 1.5, 1.5}},
                   {"Out = (int)B / 2;", {1, 1, 1}},
                   {"Out = (int)3 / 2;", {1, 1, 1}},
                   {"Out = -(float3)B * A;", {-0.75, -1.5, -2.25}},
                   {"float4 four = float4(A, 1); Out = float3((float2)four, 0);", {0.25, 0.5, 0}},
                   {"Out = (half3)((int3)(A * 4));", {1, 2, 3}},
                   {"float4x4 m = float4x4(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16);\\n"
                    "Out = mul((float3x3)m, float3(1, 0, 1));",
                    {4, 12, 20}}});
}

TEST(ShaderGraphConversions, NumbersOfSeveralKindsMix) {
    expect_values({{"int i = 3; Out = A * i;", {0.75, 1.5, 2.25}},
                   {"uint u = 3u; Out = A * u + 2u;", {2.75, 3.5, 4.25}},
                   {"Out = 0; for (int i = 1; i <= 3; i++) Out += A / i;", {11 / 24.0, 11 / 12.0, 11 / 8.0}},
                   {"int i = B > 1 ? 1 : 2; Out = i / 2.0;", {0.5, 0.5, 0.5}},
                   {"int i = 7.9; i += 1; Out = i;", {8, 8, 8}},
                   {"Out = A * (B > 2) + true;", {1.25, 1.5, 1.75}},
                   {"int n = 2; Out = pow(A, n) + max(n, B);", {3.0625, 3.25, 3.5625}},
                   {"int n = 0; if (n) Out = 1; else Out = B && !n ? A : 5;", {0.25, 0.5, 0.75}},
                   {"int3 v = int3(1, 2, 3); Out = v * A.x + v.z;", {3.25, 3.5, 3.75}},
                   {"bool b = B; Out = b + b;", {2, 2, 2}},
                   {"uint u = (uint)(B * 3); Out = (u >> 1) + (u & 3) + (1 << 2);", {9, 9, 9}},
                   {"int i = -7; Out = i / 2 + i % 3 + i * -1;", {3, 3, 3}}});
}

// A quotient of integers is an integer, of literals too.
TEST(ShaderGraphConversions, QuotientsOfIntegersAreCut) {
    expect_values({{"Out = A * (1 / 2);", {0, 0, 0}},
                   {"Out = 7 / 2 + 7 % 4;", {6, 6, 6}},
                   {"Out = 7 / 2.0;", {3.5, 3.5, 3.5}},
                   {"Out = 7f / 2;", {3.5, 3.5, 3.5}},
                   {"Out = (2 * 3 - 1) / 2 * A;", {0.5, 1, 1.5}},
                   {"Out = (B > 1 ? 3 : 1) / 2;", {1, 1, 1}},
                   {"Out = sign(A) / 2;", {0, 0, 0}},
                   {"Out = (A > 0.3 ? 3 : 1) / 2;", {0, 1, 1}},
                   {"Out = max(3, 1) / 2 + abs(-3) / 2;", {2, 2, 2}}});
}

TEST(ShaderGraphConversions, VectorsAreCut) {
    expect_values({{"float2 a = A; Out = float3(a, 0);", {0.25, 0.5, 0}},
                   {"float a = A * 2; Out = a;", {0.5, 0.5, 0.5}},
                   {"float4 four = float4(A, 1); Out = four * A;", {0.0625, 0.25, 0.5625}},
                   {"Out = 0; Out.xy = A.yzx;", {0.5, 0.75, 0}},
                   {"float2x2 m = float2x2(1, 2, 3, 4); Out = float3(mul(m, A), mul(A, m).x);", {1.25, 2.75, 1.75}},
                   {"Out = lerp(float4(A, 1), A, B - 2.5) + dot(float4(A, 9), A.xy);", {0.5625, 0.8125, 1.0625}}});
}

TEST(ShaderGraphConversions, DeclarationsAreOneByOne) {
    expect_values({{"float a = 1, b = 2; Out = A * b + a;", {1.5, 2, 2.5}},
                   {"const float a = 1,b = a + 1; Out = A * b;", {0.5, 1, 1.5}},
                   {"static const float k = 3; Out = A * k;", {0.75, 1.5, 2.25}},
                   {"float s, c; sincos(0 * B, s, c); Out = float3(s, c, 1);", {0, 1, 1}},
                   {"float3 s, c; if (B > 1) sincos(A * 0, s, c); Out = s + c;", {1, 1, 1}},
                   {"float3x3 m = { 1, 2, 3, 4, 5, 6, 7, 8, 9 }; Out = mul(m, A);", {3.5, 8, 12.5}},
                   {"int k[2] = { 1, 2.5 }; Out = k[1] / 2;", {1, 1, 1}},
                   {"int a = 7, n = 3; Out = 0; for (int i = 0; i < n; ++i) Out += a / 2;", {9, 9, 9}}});
}

TEST(ShaderGraphConversions, LoopsCountIntegers) {
    expect_values({{"Out = 0; for (float i = 0; i < 2.5; i++) Out += A * i;", {0.75, 1.5, 2.25}},
                   {"Out = 0; [unroll] for (uint i = 0; i <= 2; ++i) Out += i / 2;", {1, 1, 1}},
                   {"const int n = 2; Out = 0; [loop] for (int i = 0; i <= n * 2; i++) Out += i;", {10, 10, 10}},
                   {"Out = 0; for (int i = -1; i <= 1; i++) Out += A * i * i;", {0.5, 1, 1.5}},
                   {"UNITY_LOOP for (int i = 0; i < 2; i++) { Out = i; }", {1, 1, 1}}});
}

TEST(ShaderGraphConversions, StatementsAndFunctionsAreWrittenOut) {
    expect_values({{"[branch] if (A.x > 0) { Out = A; } else { Out = 0; }", {0.25, 0.5, 0.75}},
                   {"Out = A; Out.x++; --Out.yz;", {1.25, -0.5, -0.25}},
                   {"int i = 2; i--; ++i; Out = i;", {2, 2, 2}},
                   {"Out = rcp(A) * 3 / rcp(B);", {36, 18, 12}},
                   {"Out = mad(A, 2, 1).zyx * mad(2, 3, 1);", {17.5, 14, 10.5}},
                   {"Out = log10(float3(1, 10, 1000));", {0, 1, 3}},
                   {"Out = A > 0.3 ? A : -1;", {-1, 0.5, 0.75}},
                   {"Out = all(A) ? 1 : 2;", {1, 1, 1}}});
}

TEST(ShaderGraphConversions, AssignmentsConvertAndHaveValues) {
    expect_values({{"int i = 1; i *= 2.5; Out = A * i;", {0.5, 1, 1.5}},
                   {"int i = 2; Out = A * i++ + i;", {3.5, 4, 4.5}},
                   {"float s = 0, c; sincos(s, s, c); Out = float3(s, c, 0);", {0, 1, 0}},
                   {"float x, y; x = y = B; Out = float3(x, y, (x += 1));", {3, 3, 4}}});
}

TEST(ShaderGraphConversions, LoopsOfAnyForm) {
    expect_values(
        {{"Out = 0; for (float i = 0.5; i < 3; i++) Out += A * i;", {1.125, 2.25, 3.375}},
         {"Out = 0; for (int i = 0; i < 4; i++) { Out += A; i += 1; }", {0.5, 1, 1.5}},
         {"int n = 3; n = 2; Out = 0; for (int i = 0; i < n; i++) Out += A;", {0.5, 1, 1.5}},
         {"Out = 0; for (int i = 0; i < 4; i++) if (B > 2) { Out = A; return; } Out = 1;", {0.25, 0.5, 0.75}},
         {"Out = 0; for (int i = 0; i < B; i++) { if (i == 1) continue; Out += A * i; }", {0.5, 1, 1.5}},
         {"Out = 0; int i = 5; while (i > B) { Out += i; i--; }", {9, 9, 9}},
         {"Out = A; do { Out += 1; } while (Out.x < B);", {3.25, 3.5, 3.75}},
         {"switch ((int)B) { case 1: Out = 1; break; case 3: Out = A; break; default: Out = 0; }", {0.25, 0.5, 0.75}}});
}

TEST(ShaderGraphConversions, MacrosWithArguments) {
    expect_values(
        {{"\\n#define TWICE(x) ((x) * 2)\\n#define BOTH(a, b) TWICE(a) + b\\nOut = BOTH(A, 1);\\n", {1.5, 2, 2.5}}});
}

// Compilers differ in what it means, or the language lacks it: it stays HLSL.
TEST(ShaderGraphConversions, WhatIsNotSafeStaysHlsl) {
    for (const char* body : {"Out = 0; [unroll(2)] for (int i = 0; i < 3; i++) Out += A * i;",  // ends after 2 rounds
                             "Out = ddx_fine(A);"}) {
        const Imported made = import_graph(one_node(custom(body), 2));
        const std::string& code = text_of(made, "Glow.node.hlsl");
        EXPECT_NE(code.find("[foreign]"), std::string::npos) << code;
        // As it was written.
        EXPECT_NE(code.find(body), std::string::npos) << code;
    }
}

// It ends, and is refused or stays HLSL.
TEST(ShaderGraphConversions, CodeMayBeNestedDeeply) {
    const std::string many(20000, '{'), closed(20000, '}'), open(20000, '('), shut(20000, ')');
    for (const std::string& body : {"Out = A;" + many + closed, "Out = " + open + "B" + shut + ";"})
        EXPECT_EQ(import_graph(one_node(custom(body), 2)).error, "");
}

TEST(ShaderGraphConversions, FunctionsOfAFileConvertTheirArguments) {
    save_shader_graph("Glow.hlsl",
                      "int Steps(float x) { return x * 2; }\nfloat2 Half(float2 v, int n) { return v / n; }\n"
                      "void Glow_float(float3 A, float B, out float3 Out) {\n"
                      "    Out = float3(Half(A, B - 1), Steps(3) / 4);\n}\n",
                      kGuid);
    const Imported made = import_graph(one_node(custom("", "Glow", 0), 2));
    EXPECT_EQ(remarks(made, Remark::Kind::Changed) + remarks(made, Remark::Kind::LeftOut), "");
    const std::string& code = text_of(made, "Glow.node.hlsl");
    EXPECT_EQ(code.find("#pragma hlsl"), 0u) << code;
    EXPECT_NE(code.find("float3(Half(A, B - 1), Steps(3) / 4)"), std::string::npos) << code;
    expect_compiles(made, "a file");
}

TEST(ShaderGraphConversions, AReturnInABranchEndsTheFunction) {
    expect_values({{"if (B > 2) { Out = A; return; }\\nOut = 1;", {0.25, 0.5, 0.75}},
                   {"if (B < 2) { Out = A; return; }\\nOut = 1;", {1, 1, 1}},
                   {"Out = A; if (B > 2) return;\\nOut = 1;", {0.25, 0.5, 0.75}},
                   {"Out = 0; if (A.x > 1) return; float b = B; if (b > 5) { Out = b; return; } Out = A; return;",
                    {0.25, 0.5, 0.75}}});
}

TEST(ShaderGraphConversions, FunctionsMayHaveOutputsOnly) {
    const auto of_file = [](const std::string& body) {
        save_shader_graph("Glow.hlsl",
                          "void Polar_float(in float2 at, const float scale, out float r, out float a) {\n"
                          "    r = length(at) * scale;\n    a = at.x > 0 ? 1 : 2;\n}\n"
                          "void Twice_float(float x, out float r) { r = x * 2; }\n"
                          "void Glow_float(float3 A, float B, out float3 Out) {\n    float x = 0, y; " +
                              body + "\n}\n",
                          kGuid);
        return import_graph(one_node(custom("", "Glow", 0), 2));
    };
    const Imported made = of_file("if (B > 0) Polar_float(A, 2, x, y); Out = float3(x, y, 0);");
    EXPECT_EQ(remarks(made, Remark::Kind::Changed) + remarks(made, Remark::Kind::LeftOut), "");
    const std::string& code = text_of(made, "Glow.node.hlsl");
    EXPECT_NE(code.find("if (B > 0) Polar(A, 2, x, y);"), std::string::npos) << code;
    EXPECT_NE(code.find("void Polar(float2 at, float scale, out float r, out float a) {"), std::string::npos) << code;
    expect_compiles(made, "a call");
    const Imported twice = of_file("Twice_float(B, x); Twice_float(x, x); Out = A * x;");
    EXPECT_EQ(remarks(twice, Remark::Kind::Changed) + remarks(twice, Remark::Kind::LeftOut), "");
    expect_compiles(twice, "one output");
    // It reads what it writes.
    const Imported same = of_file("Polar_float(x, 2, x, y); Out = float3(x, y, 0);");
    EXPECT_EQ(text_of(same, "Glow.node.hlsl").find("[foreign]"), std::string::npos);
    expect_compiles(same, "an argument that is also an output");
}

}  // namespace
}  // namespace patina::importers
