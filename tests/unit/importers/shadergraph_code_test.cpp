// Custom functions of Unity's shader graphs: what their code becomes.
#include <gtest/gtest.h>

#include "tests/unit/importers/shadergraph_import.h"

namespace patina::importers {
namespace {

TEST(ShaderGraphCode, CodeBecomesANodeFile) {
    const Imported made = import_graph(one_node(
        custom(
            R"(#if SHADERGRAPH_PREVIEW\nOut = 1;\n#else\n$precision3 twice = A * 2.0f; // doubled\nOut = pow(twice, B);\n#endif)"),
        2));
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    const std::string& code = text_of(made, "Glow.node.hlsl");
    EXPECT_NE(
        code.find(
            "void Glow(float3 A, float B, out float3 Out) {\n    float3 twice = A * 2.0;\n    Out = pow(twice, B);\n}"),
        std::string::npos)
        << code;
    expect_compiles(made, "code");
}

TEST(ShaderGraphCode, CodeOfTheEnginesLightReadsTheMainLight) {
    const Imported made = import_graph(one_node(
        custom(R"(Light l = GetMainLight();\nOut = l.color * l.distanceAttenuation * dot(A, l.direction) * B;)"), 2));
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("@light"), std::string::npos);
    expect_compiles(made, "light");
}

TEST(ShaderGraphCode, CodeThatIsNotValidIsRefusedWithTheReason) {
    const Imported made = import_graph(one_node(custom(R"(Out = SomethingOfTheEngine(A);)"), 2));
    EXPECT_TRUE(made.has_refused);
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find("SomethingOfTheEngine"), std::string::npos)
        << remarks(made, Remark::Kind::LeftOut);
    expect_compiles(made, "magenta");
}

// Only HLSL has loops without a known end.
TEST(ShaderGraphCode, CodeThatTheNodeLanguageCannotSayBecomesForeign) {
    save_shader_graph(
        "Glow.hlsl",
        "float Below_float(float x) { while (x > 1.0f) x -= 1; return x; }\n"
        "void Glow_float(float3 A, float B, out float3 Out)\n{\n"
        "    float low = 0, high = 1;\n    do { low += 0.25; high *= low; } while (low < Below_float(B));\n"
        "    Out = A * clamp(low, high, 4.0h).xxx;\n}\n",
        kGuid);
    const Imported made = import_graph(one_node(custom("", "Glow", 0), 2));
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("only HLSL takes its code"), std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    const std::string& code = text_of(made, "Glow.node.hlsl");
    EXPECT_NE(code.find("[foreign]\nfloat Below(float x) {"), std::string::npos) << code;
    EXPECT_NE(code.find("[node(\"Custom/Glow\")]\n[foreign]\nvoid Glow(float3 A, float B, out float3 Out) {"),
              std::string::npos)
        << code;

    CompileOptions options;
    options.files.read = [&](const std::string& path) -> std::optional<std::string> {
        for (const TextFile& file : made.graphs)
            if (path == file.name || path == "./" + file.name) return file.text;
        return std::nullopt;
    };
    options.targets = compiler().targets("hlsl");
    const Result hlsl = compiler().compile_text("x.graph.json", text_of(made), options);
    ASSERT_TRUE(hlsl.ok) << (hlsl.diagnostics.empty() ? "" : to_text(hlsl.diagnostics[0]));
    EXPECT_NE(hlsl.shaders[1].text.find("while (low < Glow_Below(B));"), std::string::npos) << hlsl.shaders[1].text;
    options.targets = compiler().targets("glsl");
    const Result glsl = compiler().compile_text("x.graph.json", text_of(made), options);
    ASSERT_FALSE(glsl.ok);
    EXPECT_EQ(glsl.diagnostics[0].code, "foreign-text");
}

// Code with a mistake is no HLSL either, so it does not become the text of a [foreign] function.
TEST(ShaderGraphCode, CodeThatIsNoHlslIsRefusedAtItsLine) {
    const std::pair<const char*, const char*> mistakes[] = {
        {R"(float3 C = A;\nOut = C * ;)", "line 2 of its code: a value is missing before ';', in 'Out = C * ;'"},
        {R"(Out = A * B\nfloat x = 1;)", "line 1 of its code: a ';' is missing before 'float', in 'Out = A * B'"},
        {R"(Out = A * (B + 1;)", "line 1 of its code: "},
        {R"(Out = A;\nwhile B > 1 { Out = A; })", "line 2 of its code: a '(' is missing before 'B'"},
        {R"(Out = A;\nfor (int i = 0; i < 3) Out = A;)", "line 2 of its code: a ';' is missing before ')'"},
        {R"(Out = pow(A, );)", "line 1 of its code: a value is missing before ')'"},
        {R"(Out = A.;)", "line 1 of its code: a name is missing before ';'"},
        {R"(Out = A; else Out = A;)", "line 1 of its code: a value is missing before 'else'"},
        {R"(float = 1;\nOut = A * ? 1 : 2;)", "line 2 of its code: a value is missing before '?'"}};
    for (const auto& [body, reason] : mistakes) {
        const Imported made = import_graph(one_node(custom(body), 2));
        EXPECT_TRUE(made.has_refused) << body;
        EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find(reason), std::string::npos)
            << body << "\n"
            << remarks(made, Remark::Kind::LeftOut);
        expect_compiles(made, body);
    }
}

// All of it is HLSL, and the node language lacks a part of it.
TEST(ShaderGraphCode, WellFormedHlslBecomesForeign) {
    for (
        const char* body :
        {R"(static const float3 kAll[2] = { float3(1, 0, 0), { 0, 1, 0 } };\nOut = kAll[1] * (float3)A;)",
         R"(float3 C = (float3)0, D;\n[loop] while (C.x < .5e+1) { C += 1; if (C.y > 2) break; }\nOut = C;)",
         R"(int i = 0;\ndo { i++; } while (i < 3 && !(B > 1));\nOut = -A * i;)",
         R"(float x = B > 1 ? 1 : B < 0 ? 2 : (3, 4);\nwhile (x > 9) { --x; continue; }\nOut = A * x;)",
         R"(uint u = (uint)B;\nswitch (u) { case 0: Out = A; break; default: Out = A * 2; }\nwhile (u > 9u) u >>= 1;)"}) {
        const Imported made = import_graph(one_node(custom(body), 2));
        EXPECT_FALSE(made.has_refused) << body << "\n" << remarks(made, Remark::Kind::LeftOut);
        EXPECT_NE(text_of(made, "Glow.node.hlsl").find("[foreign]"), std::string::npos) << body;
    }
}

// What the engine declares is not in the text.
TEST(ShaderGraphCode, CodeThatReadsTheEngineIsNotForeign) {
    const Imported made =
        import_graph(one_node(custom(R"(float x = B;\nwhile (x < unity_LightmapST.x) x += 1;\nOut = A * x;)"), 2));
    EXPECT_TRUE(made.has_refused);
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut)
                  .find("the engine, or another part of its file, declares 'unity_LightmapST'"),
              std::string::npos)
        << remarks(made, Remark::Kind::LeftOut);
}

TEST(ShaderGraphCode, AFunctionOfAFileBringsWhatItCalls) {
    save_shader_graph(
        "Glow.hlsl",
        "#ifndef GLOW\n#define GLOW\nfloat Half_float(float x) { return x * 0.5; }\nvoid Unused_float(out float x) { x "
        "= tex2D(a, b); }\n"
        "void Glow_float(float3 A, float B, out float3 Out)\n{\n    Out = A * Half_float(B);\n}\n#endif\n",
        kGuid);
    const Imported made = import_graph(one_node(custom("", "Glow", 0), 2));
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    EXPECT_EQ(text_of(made, "Glow.node.hlsl").find("Unused"), std::string::npos);
    expect_compiles(made, "file");
}

// The parameters of a function have names of their own; their order is that of the slots.
TEST(ShaderGraphCode, ParametersAreThoseOfTheFunction) {
    save_shader_graph(
        "Glow.hlsl",
        "void Glow_float(float3 color, float strength, out float3 result) { result = color * strength; }\n", kGuid);
    const Imported made = import_graph(one_node(custom("", "Glow", 0), 2));
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    EXPECT_NE(text_of(made).find(R"("strength": 2)"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find("glow.result"), std::string::npos) << text_of(made);
    expect_compiles(made, "parameters");
}

}  // namespace
}  // namespace patina::importers
