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
