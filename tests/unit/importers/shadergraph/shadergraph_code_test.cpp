// Custom functions of Unity's shader graphs: what their code becomes.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/unit/importers/shadergraph/shadergraph_import.h"

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

// Only HLSL has ddx_fine.
TEST(ShaderGraphCode, CodeThatTheNodeLanguageCannotSayBecomesForeign) {
    save_shader_graph(
        "Glow.hlsl",
        "float Below_float(float x) { while (x > 1.0f) x -= 1; return x; }\n"
        "void Glow_float(float3 A, float B, out float3 Out)\n{\n"
        "    float low = 0, high = 1;\n    do { low += 0.25; high *= low; } while (low < Below_float(B));\n"
        "    Out = A * clamp(low, ddx_fine(high), 4.0h).xxx;\n}\n",
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
        {R"(float3 C = A;\nOut = C * ;)", "line 2 of its code: expected a value, not ';', in 'Out = C * ;'"},
        {R"(Out = A * B\nfloat x = 1;)", "line 1 of its code: expected ';' here, not 'float', in 'Out = A * B'"},
        {R"(Out = A * (B + 1;)", "line 1 of its code: expected ')', not ';'"},
        {R"(Out = A;\nwhile B > 1 { Out = A; })", "line 2 of its code: expected '(' and a condition, not 'B'"},
        {R"(Out = A;\nfor (int i = 0; i < 3) Out = A;)", "line 2 of its code: expected ';', not ')'"},
        {R"(Out = pow(A, );)", "line 1 of its code: expected a value, not ')'"},
        {R"(Out = A.;)", "line 1 of its code: expected the name of a member, not ';'"},
        {R"(Out = A; else Out = A;)", "line 1 of its code: expected a statement, not 'else'"},
        {R"(float = 1;\nOut = A * ? 1 : 2;)", "line 2 of its code: expected a value, not '?'"}};
    for (const auto& [body, reason] : mistakes) {
        const Imported made = import_graph(one_node(custom(body), 2));
        EXPECT_TRUE(made.has_refused) << body;
        EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find(reason), std::string::npos)
            << body << "\n"
            << remarks(made, Remark::Kind::LeftOut);
        expect_compiles(made, body);
    }
}

TEST(ShaderGraphCode, WellFormedHlslIsRead) {
    for (
        const char* body :
        {R"(static const float3 kAll[2] = { float3(1, 0, 0), { 0, 1, 0 } };\nOut = kAll[1] * (float3)A;)",
         R"(float3 C = (float3)0, D;\n[loop] while (C.x < .5e+1) { C += 1; if (C.y > 2) break; }\nOut = C;)",
         R"(int i = 0;\ndo { i++; } while (i < 3 && !(B > 1));\nOut = -A * i;)",
         R"(float x = B > 1 ? 1 : (3, 4);\nOut = A * x;)",
         R"(float x = B > 1 ? 1 : B < 0 ? 2 : 4;\nwhile (x > 9) { --x; continue; }\nOut = A * x;)",
         R"(uint u = (uint)B;\nswitch (u) { case 0: Out = A; break; default: Out = A * 2; }\nwhile (u > 9u) u >>= 1;)"}) {
        const Imported made = import_graph(one_node(custom(body), 2));
        EXPECT_EQ(remarks(made, Remark::Kind::LeftOut) + remarks(made, Remark::Kind::Changed), "") << body;
        EXPECT_EQ(text_of(made, "Glow.node.hlsl").find("#pragma hlsl"), 0u) << body;
        expect_compiles(made, body);
    }
}

// All of it is HLSL, and the node language lacks a part of it.
TEST(ShaderGraphCode, WellFormedHlslBecomesForeign) {
    for (const char* body : {R"(double d = B;\nOut = A * d;)", R"(int e;\nOut = frexp(A.x, e);)"}) {
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

// --- what a file has beside the function

const char* const kLights =
    "float Up(float x) { return x + 1; }\n"
    "void Lit_float(float3 A, float B, out float3 Out) { Out = A * B * GetMainLight().color; }\n"
    "void Glow_float(float3 A, float B, out float3 Out) { float Lit = Up(B); Out = A * Lit; }\n"
    "float Late(float x) { return x * _Time.y; }\n"
    "void Lazy_float(float3 A, float B, out float3 Out) { Out = A * Late(B); }\n";

TEST(ShaderGraphCode, OnlyWhatAFunctionReachesReadsTheEngine) {
    save_shader_graph("Glow.hlsl", kLights, kGuid);
    const Imported made = import_graph(one_node(custom("", "Glow", 0), 2));
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    EXPECT_EQ(text_of(made, "Glow.node.hlsl").find("engineLight"), std::string::npos);
    expect_compiles(made, "no light");
    const Imported lit = import_graph(one_node(custom("", "Lit", 0), 2));
    EXPECT_NE(text_of(lit, "Lit.node.hlsl").find("[hidden] Light engineLight = light) {"), std::string::npos)
        << text_of(lit, "Lit.node.hlsl");
    expect_compiles(lit, "light");
    const std::string lost = remarks(import_graph(one_node(custom("", "Lazy", 0), 2)), Remark::Kind::LeftOut);
    EXPECT_NE(lost.find("it calls 'Late', which reads values of the engine"), std::string::npos) << lost;
}

TEST(ShaderGraphCode, IncludesBesideTheFileAreRead) {
    save_shader_graph("Circle.hlsl",
                      "#include \"Glow.hlsl\"\n#include \"Circle.hlsl\"\nfloat Half(float x) { return x * HALF; }\n");
    save_shader_graph("Glow.hlsl",
                      "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl\"\n"
                      "#define HALF 0.5\n  # include \"Circle.hlsl\" // what it needs\n"
                      "void Glow_float(float3 A, float B, out float3 Out) { Out = A * Half(B); }\n",
                      kGuid);
    const Imported made = import_graph(one_node(custom("", "Glow", 0), 2));
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    EXPECT_NE(text_of(made, "Glow.node.hlsl").find("return x * 0.5;"), std::string::npos)
        << text_of(made, "Glow.node.hlsl");
    expect_compiles(made, "an include");
    // Each file is taken once, and not without end.
    for (int i = 0; i < 12; ++i)
        save_shader_graph(fmt::format("Deep{}.hlsl", i), fmt::format("#include \"Deep{}.hlsl\"\n", i + 1));
    save_shader_graph("Deep12.hlsl", "float Half(float x) { return x; }\n");
    save_shader_graph(
        "Glow.hlsl",
        "#include \"Deep0.hlsl\"\nvoid Glow_float(float3 A, float B, out float3 Out) { Out = A * Half(B); }\n", kGuid);
    EXPECT_TRUE(import_graph(one_node(custom("", "Glow", 0), 2)).has_refused);
}

TEST(ShaderGraphCode, ConstantsAndStructsOfAFileAreBrought) {
    save_shader_graph("Glow.hlsl",
                      "float unused;\nCBUFFER_START(UnityPerMaterial) float4 _Color; CBUFFER_END\n"
                      "static const int kCount = 2;\nstatic float2 kSteps[kCount] = { float2(1, 2), { 3, 4 } };\n"
                      "struct GlowStep { float2 at; float weight; };\n"
                      "GlowStep At(int i) { GlowStep made = (GlowStep)0; made.at = kSteps[i]; return made; }\n"
                      "void Glow_float(float3 A, float B, out float3 Out) { Out = A * At(1).at.y * B; }\n",
                      kGuid);
    const Imported made = import_graph(one_node(custom("", "Glow", 0), 2));
    EXPECT_EQ(remarks(made, Remark::Kind::LeftOut) + remarks(made, Remark::Kind::Changed), "");
    const std::string& code = text_of(made, "Glow.node.hlsl");
    EXPECT_NE(code.find("struct GlowStep {\n    float2 at;\n    float weight;\n};\n"), std::string::npos) << code;
    EXPECT_NE(code.find("static const float2 kSteps[kCount] = { float2(1, 2), { 3, 4 } };\n"), std::string::npos)
        << code;
    EXPECT_EQ(code.find("unused"), std::string::npos) << code;
    expect_compiles(made, "constants");
}

// Macros of the file and of the engine are written out, in the lines of the author.
TEST(ShaderGraphCode, MacrosAreWrittenOut) {
    save_shader_graph("Glow.hlsl",
                      "#define TWICE(x) (2 * x)\n#define MINUS -1\n#define SCALED(x, \\\n    y) \\\n    (x * y)\n"
                      "void Glow_float(float3 A, float B, out float3 Out)\n{\n"
                      "    Out = TWICE( A )-MINUS; // of all\n    Out += SCALED(B,\n        3);\n}\n",
                      kGuid);
    const Imported made = import_graph(one_node(custom("", "Glow", 0), 2));
    EXPECT_EQ(remarks(made, Remark::Kind::LeftOut) + remarks(made, Remark::Kind::Changed), "");
    EXPECT_NE(text_of(made, "Glow.node.hlsl").find("{\n    Out = (2 * A)- -1;\n    Out += (B * 3);\n}\n"),
              std::string::npos)
        << text_of(made, "Glow.node.hlsl");
    expect_compiles(made, "macros");
}

// An include becomes a part of the node file and of messages: it must not be any file of the machine.
TEST(ShaderGraphCode, IncludesOfFilesThatAreNoCodeAreLeftAlone) {
    namespace fs = std::filesystem;
    const std::string body = "void Glow_float(float3 A, float B, out float3 Out) { Out = A * B; }\n";
    const fs::path folder = fs::path(save_shader_graph("secret", "float sesame() { return 1; }\n")).parent_path();
    fs::remove(folder / "Link.hlsl");
    fs::create_symlink("secret", folder / "Link.hlsl");
    for (const std::string name : {"secret", "Link.hlsl", "/etc/passwd", "/proc/self/environ"}) {
        save_shader_graph("Glow.hlsl", "#include \"" + name + "\"\n" + body, kGuid);
        const Imported made = import_graph(one_node(custom("", "Glow", 0), 2));
        std::string all = made.error;
        for (const TextFile& each : made.graphs) all += each.text;
        for (const Remark& each : made.remarks) all += each.part + each.text;
        EXPECT_EQ(all.find("sesame"), std::string::npos) << name;
        EXPECT_EQ(all.find("root:"), std::string::npos) << name;
        EXPECT_EQ(all.find("PATH="), std::string::npos) << name;
    }
    // The file of the function itself can be a link, too.
    fs::remove(folder / "Glow.hlsl");
    fs::create_symlink("secret", folder / "Glow.hlsl");
    const std::string refused = remarks(import_graph(one_node(custom("", "Glow", 0), 2)), Remark::Kind::LeftOut);
    EXPECT_NE(refused.find("has none of the endings .hlsl"), std::string::npos) << refused;
    EXPECT_EQ(refused.find("sesame"), std::string::npos) << refused;
    fs::remove(folder / "Glow.hlsl");
    fs::remove(folder / "Link.hlsl");
}

TEST(ShaderGraphCode, OverloadsAreTakenByTheirArguments) {
    const std::string call = "void Glow_float(float3 A, float B, out float3 Out) { Out = A * Help(B); }\n";
    save_shader_graph("Glow.hlsl",
                      "float Help(float x, float y) { return x * y; }\nhalf Help(half x) { return x; }\n"
                      "float Help(float x) { return x * 3; }\n" +
                          call,
                      kGuid);
    const Imported made = import_graph(one_node(custom("", "Glow", 0), 2));
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    EXPECT_NE(text_of(made, "Glow.node.hlsl").find("return x * 3;"), std::string::npos);
    EXPECT_EQ(text_of(made, "Glow.node.hlsl").find("return x * y;"), std::string::npos);
    expect_compiles(made, "one of three");
    save_shader_graph("Glow.hlsl", "float Help(float2 x) { return x.x; }\nfloat Help(float x) { return x; }\n" + call,
                      kGuid);
    const Imported both = import_graph(one_node(custom("", "Glow", 0), 2));
    EXPECT_EQ(remarks(both, Remark::Kind::LeftOut) + remarks(both, Remark::Kind::Changed), "");
    EXPECT_NE(text_of(both, "Glow.node.hlsl").find("float Help(float2 x)"), std::string::npos);
    EXPECT_NE(text_of(both, "Glow.node.hlsl").find("float Help(float x)"), std::string::npos);
    expect_compiles(both, "two of one count");
}

// --- words of HLSL and of the engine

NodeText of_matrix(const std::string& body) {
    NodeText node = custom(body);
    node.slots.push_back({.id = 3, .kind = "Matrix3", .name = "M"});
    return node;
}

TEST(ShaderGraphCode, ElementsOfMatricesAreRead) {
    for (const char* body :
         {"M._m10 = 4;\\nOut = A * M._m01_m02_m00 + M._12_23.xyx * M._m10 * B;",
          "Out = A * B;\\nM._m00_m11 = A.xy;\\nOut.z = M._22;", "Out = A * B;\\nOut.xy = mul(M, M)._m00_m11;"}) {
        const Imported made = import_graph(one_node(of_matrix(body), 2));
        EXPECT_EQ(remarks(made, Remark::Kind::Changed) + remarks(made, Remark::Kind::LeftOut), "") << body;
        expect_compiles(made, body);
    }
}

TEST(ShaderGraphCode, MessagesHaveTheWordsOfTheAuthor) {
    const Imported made = import_graph(one_node(custom("Out = _SinTime.w * A + _Time.y * B;"), 2));
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    const std::string& code = text_of(made, "Glow.node.hlsl");
    EXPECT_NE(code.find("out float3 Out, [hidden] float engineTime = time) {"), std::string::npos) << code;
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    expect_compiles(made, "times");
    const std::string lost =
        remarks(import_graph(one_node(custom("Out = _WorldSpaceCameraPos * A + unity_LightmapST.xyz * _Time.y;"), 2)),
                Remark::Kind::LeftOut);
    EXPECT_EQ(lost.find("engine"), lost.find("engine, or another part")) << lost;
    EXPECT_NE(lost.find("in 'Out = _WorldSpaceCameraPos * A + unity_LightmapST.xyz * _Time.y;'"), std::string::npos)
        << lost;
    EXPECT_NE(lost.find("declares 'unity_LightmapST'"), std::string::npos) << lost;
}

TEST(ShaderGraphCode, ValuesOfTheEngineAreTheSame) {
    const std::pair<const char*, const char*> values[] = {
        {"Out = A * B + _ScreenParams.zwx;", "float4(engineScreen, 1 + 1 / engineScreen).zwx"},
        {"Out = A / _Time.xyz;", "A / (float4(0.05, 1, 2, 3) * engineTime).xyz"},
        {"Out = A * _TimeParameters.xyz;", "float4(engineTime, sin(engineTime), cos(engineTime), 0).xyz"},
        {"Out = mul(UNITY_MATRIX_M, float4(A, B)).xyz;", "mul(objectToWorld, float4(A, B)).xyz"},
        {"Out = mul(GetWorldToObjectMatrix(), float4(A, B)).xyz;", "mul(worldToObject, float4(A, B)).xyz"},
        {"Out = TransformWorldToObject(TransformObjectToWorld(A * B));",
         "mul(worldToObject, float4(mul(objectToWorld, float4(A * B, 1)).xyz, 1)).xyz"},
        {"Out = TransformWorldToView(A);", "mul(worldToView, float4(A, 1)).xyz"},
        {"Out = TransformObjectToWorldDir(A, false);",
         "float3 changed = mul(objectToWorld, float4(direction, 0)).xyz;"},
        {"Out = TransformObjectToWorldNormal(A);", "float3 changed = mul(float4(normal, 0), worldToObject).xyz;"}};
    for (const auto& [body, ours] : values) {
        const Imported made = import_graph(one_node(custom(body), 2));
        EXPECT_EQ(remarks(made, Remark::Kind::Changed) + remarks(made, Remark::Kind::LeftOut), "") << body;
        EXPECT_NE(text_of(made, "Glow.node.hlsl").find(ours), std::string::npos) << text_of(made, "Glow.node.hlsl");
        expect_compiles(made, body);
    }
}

TEST(ShaderGraphCode, AFunctionCannotDiscard) {
    for (const char* body : {"clip(A.x - 0.5);\\nOut = A;", "if (B < 0.5) discard;\\nOut = A;"}) {
        const std::string lost = remarks(import_graph(one_node(custom(body), 2)), Remark::Kind::LeftOut);
        EXPECT_NE(lost.find("use Alpha Clip Threshold"), std::string::npos) << lost;
    }
}

TEST(ShaderGraphCode, AFunctionMayHaveANameOfAnyLetters) {
    const Imported made = import_graph(one_node(custom("Out = A * B;", "名前"), 2));
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    expect_compiles(made, "a name");
    const std::string lost = remarks(import_graph(one_node(custom("", "名前", 0), 2)), Remark::Kind::LeftOut);
    EXPECT_NE(lost.find("its function is called '名前'"), std::string::npos) << lost;
    NodeText node = custom("出力 = A * B;");
    node.slots[2].name = "出力";
    const std::string output = remarks(import_graph(one_node(node, 2)), Remark::Kind::LeftOut);
    EXPECT_NE(output.find("its output '出力' has a name without any letter of English"), std::string::npos) << output;
}

}  // namespace
}  // namespace patina::importers
