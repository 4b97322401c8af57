// What stands in a ShaderLab file around its programs, and two files as a whole, for a reader to look at.
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "tests/support/received.h"
#include "unity/compiled.h"
#include "unity/shader_lab.h"

namespace patina::unity {
namespace {

class UnityFile : public ::testing::TestWithParam<std::string> {};

TEST_P(UnityFile, ReadsAsExpected) {
    const Result result = for_unity(GetParam() + ".graph.json");
    ASSERT_EQ(result.shaders.size(), 1u);
    const std::string file = GetParam().substr(GetParam().rfind('/') + 1) + ".shader";
    EXPECT_EQ(result.shaders.front().file_name, file);
    EXPECT_TRUE(patina::testing::as_expected("unity/expected/" + file, result.shaders.front().text));
}

INSTANTIATE_TEST_SUITE_P(All, UnityFile,
                         ::testing::Values("tests/unity/graphs/standard", "tests/unity/graphs/wave",
                                           "tests/unity/graphs/passes", "tests/unity/graphs/fade",
                                           "tests/unity/graphs/override", "examples/sources/standard-cutout"),
                         [](const auto& info) {
                             std::string name = info.param.substr(info.param.rfind('/') + 1);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

// What an artist sees. Colours are those of a picker, but for those that may be brighter than white: 0.5 of linear
// light is 0.7354 there (IEC 61966-2-1).
TEST(UnityProperties, AreDeclaredAsArtistsSetThem) {
    const std::string text = shader(material(R"("properties": [
        { "name": "_Color", "type": "color", "default": [0.5, 0, 1], "label": "Paint" },
        { "name": "_Bright", "type": "color", "default": [2, 1, 0.5] },
        { "name": "_EmissionColor", "type": "color", "default": [0.5, 0.5, 0.5] },
        { "name": "_Wear", "type": "float", "default": 0.25, "range": [0, 1], "group": "Wear & tear" },
        { "name": "_FINE_UV", "type": "float", "default": 0.00002, "range": [0, 0.005] },
        { "name": "_Count", "type": "int", "default": 3, "range": [1, 8], "group": "Wear & tear" },
        { "name": "_Steps", "type": "int", "default": 2 },
        { "name": "_On", "type": "bool", "default": true },
        { "name": "_Kind", "type": "enum", "values": ["Dry", "Wet"], "default": "Wet" },
        { "name": "_Shift", "type": "float3", "default": [1, 2, 3] },
        { "name": "_MainTex", "type": "texture2d", "tiling": true },
        { "name": "_BumpMap", "type": "texture2d", "usage": "normal" },
        { "name": "_Mask", "type": "texture2d", "usage": "data", "default": "gray" } ],
      "surface": { "baseColor": "= $_Color.rgb * $_Bright.rgb", "emission": "$_EmissionColor.rgb" })"));
    for (const char* line :
         {R"(_Color ("Paint", Color) = (0.7354, 0, 1, 1))", R"([HDR] _Bright ("Bright", Color) = (2, 1, 0.5, 1))",
          R"([HDR] _EmissionColor ("Emission Color", Color) = (0.5, 0.5, 0.5, 1))", R"([Header(Wear tear)])",
          R"(_Wear ("Wear", Range(0, 1)) = 0.25)", R"([IntRange] _Count ("Count", Range(1, 8)) = 3)",
          R"(_FINE_UV ("Fine UV", Range(0, 0.005)) = 0.00002)", R"(_Steps ("Steps", Int) = 2)",
          R"([Toggle] _On ("On", Float) = 1)", R"([Enum(Dry, 0, Wet, 1)] _Kind ("Kind", Float) = 1)",
          R"(_Shift ("Shift", Vector) = (1, 2, 3, 0))", R"( _MainTex ("Main Tex", 2D) = "white" {})",
          R"([NoScaleOffset] [Normal] _BumpMap ("Bump Map", 2D) = "bump" {})",
          R"([NoScaleOffset] _Mask ("Mask", 2D) = "gray" {})"})
        EXPECT_TRUE(has(text, line)) << line << "\n" << text.substr(0, 1800);
    EXPECT_FALSE(has(text, "[NoScaleOffset] _MainTex"));
}

// An attribute of Unity's makes room where no header does: the inspector shows no empty lines.
TEST(UnityProperties, OutsideOfGroupsAreSetApart) {
    const std::string text = shader(material(R"("properties": [
        { "name": "_A", "type": "float" },
        { "name": "_B", "type": "float", "group": "Wear" },
        { "name": "_C", "type": "float" },
        { "name": "_D", "type": "float" } ],
      "surface": { "metallic": "= $_A + $_B + $_C + $_D" })"));
    EXPECT_TRUE(has(text, R"(    {
        _A ("A", Float) = 0

        [Header(Wear)]
        _B ("B", Float) = 0

        [Space]
        _C ("C", Float) = 0
        _D ("D", Float) = 0
    })"))
        << text;
}

// Slashes are Unity's menus; text that it cannot read or would show empty is omitted, with a message at the name.
TEST(UnityName, IsTheGraphsAsFarAsShaderLabCan) {
    for (const auto& [name, shown, is_told] : std::initializer_list<std::tuple<std::string, std::string, bool>>{
             {"Worn metal", "Worn metal", false},
             {"Metals/Größe 2 (worn)", "Metals/Größe 2 (worn)", false},
             {R"(Leather \"fine\")", "Leather 'fine'", true},
             {R"(a\\\tb)", "a b", true},
             {" a ", "a", true},
             {"a/", "a", true},
             {"/ a // b", "a/b", true},
             {"/", "Unnamed", true}}) {
        const Result result = of_text(R"({ "patina": 1, "workflow": "unlit", "name": ")" + name + "\" }");
        ASSERT_TRUE(result.ok) << name;
        EXPECT_TRUE(has(result.shaders.front().text, "\nShader \"Patina/" + shown + "\"\n")) << name;
        ASSERT_EQ(result.diagnostics.size(), is_told ? 1u : 0u) << name;
        if (!is_told) continue;
        EXPECT_EQ(result.diagnostics.front().code, "inspector-text");
        EXPECT_EQ(result.diagnostics.front().column, 45) << name;  // of the name's value
        EXPECT_TRUE(has(result.diagnostics.front().message, "\"Patina/" + shown + "\" for the name")) << name;
    }
}

// Its size is a variable that Unity fills, where it is read. Hardware of shader model 3.0 can do that.
TEST(UnityTextures, HaveTheirSizeBesideThem) {
    const std::string properties = R"("properties": [ { "name": "_MainTex", "type": "texture2d" },
        { "name": "_Mask", "type": "texture2d", "usage": "data" } ],
      "nodes": [ { "id": "texel", "node": "TexelSize", "in": { "texture": "$_MainTex" } },
        { "id": "mask", "node": "SampleTexture2D", "in": { "texture": "$_Mask" } } ], )";
    const std::string text =
        shader(material(properties + R"("surface": { "baseColor": "= frac(@uv0.x * texel.size.x) * mask.rgb",
          "metallic": "= $_MainTex.texelSize.y" })"));
    EXPECT_TRUE(has(text, "float4 _MainTex_TexelSize;\n")) << text;
    EXPECT_TRUE(has(text, "* _MainTex_TexelSize.z")) << text;
    EXPECT_TRUE(has(text, "_MainTex_TexelSize.y)")) << text;
    EXPECT_FALSE(has(text, "_Mask_TexelSize") || has(text, "GetDimensions")) << text;
    EXPECT_TRUE(has(text, "#pragma target 3.0") && !has(text, "#pragma target 3.5")) << text;
}

// The shader model follows from what the shader does, not from names.
TEST(UnityFile, NamesDoNotRaiseTheShaderModel) {
    const std::string named = shader(material(R"("properties": [ { "name": "_Squint", "type": "float", "default": 1 } ],
      "nodes": [ { "id": "uintLike", "expr": "sin($_Squint) * $_Squint" } ],
      "surface": { "metallic": "uintLike", "smoothness": "= uintLike * 0.5" })"));
    EXPECT_TRUE(has(named, "_Squint"));
    EXPECT_FALSE(has(named, "#pragma target 3.5")) << named;
    const std::string whole = shader(material(R"j("surface": { "metallic": "= float(uint(@uv0.x * 8) & 1u)" })j"));
    EXPECT_TRUE(has(whole, "#pragma target 3.5")) << whole;
}

// Values that are computed at vertices, a vector each.
std::string with_values(const std::string& workflow, int count) {
    std::string nodes, sum = "float3(0)";
    for (int i = 0; i < count; ++i) {
        const std::string n = std::to_string(i);
        nodes += (i == 0 ? "" : ",") + (R"({ "id": "v)" + n + R"(", "stage": "vertex", "expr": ")" + n +
                                        R"(.5 * @positionOS.xyzx * @positionOS.yzxx" })");
        sum += " + sin(v" + n + ".rgb) * v" + n + ".a";
    }
    const std::string input = workflow == "unlit" ? "color" : "baseColor";
    return R"({ "patina": 1, "workflow": ")" + workflow + R"(", "nodes": [ )" + nodes + R"( ], "surface": { ")" +
           input + R"(": "= )" + sum + R"(" } })";
}

std::string model_of_first(const std::string& text) {
    const std::size_t at = text.find("#pragma target ");
    return at == text.npos ? "" : text.substr(at + 15, 3);
}

// Fog takes one vector, light two, an instance and an eye one each, and the position one. Shader model 3.0 has 10
// beside the position (and no instances), Direct3D 10 and OpenGL ES 3.0 have 16 with it, Direct3D 11 has 32.
TEST(UnityInterpolators, AskForTheModelThatHoldsThem) {
    const std::string inside = "UNITY_FOG_COORDS(";
    for (const auto& [count, model] : std::initializer_list<std::pair<int, std::string>>{
             {9, "3.0"}, {10, "3.5"}, {12, "3.5"}, {13, "5.0"}, {28, "5.0"}}) {
        const std::string text = shader(with_values("unlit", count));
        EXPECT_EQ(model_of_first(text), model) << count;
        EXPECT_TRUE(has(text, inside + std::to_string(count) + ")")) << text;
    }
    // A lit material needs three more: the normal, the position and the light of lightmaps.
    for (const auto& [count, model] :
         std::initializer_list<std::pair<int, std::string>>{{4, "3.0"}, {5, "3.5"}, {7, "3.5"}, {8, "5.0"}}) {
        const std::string text = shader(with_values("metallic-roughness", count));
        EXPECT_EQ(model_of_first(text), model) << count;
        EXPECT_TRUE(has(text, "UNITY_LIGHTING_COORDS(" + std::to_string(count + 3) + ", ")) << text;
    }
}

TEST(UnityInterpolators, AreRefusedWhereNoModelHoldsThem) {
    const Result result = of_text(with_values("unlit", 29));
    EXPECT_FALSE(result.ok);
    const Diagnostic told = first_error(result);
    EXPECT_EQ(told.code, "too-many");
    EXPECT_EQ(told.message, "32 interpolated values are too many: the limit is 31");
    EXPECT_EQ(told.line, 1);
    EXPECT_TRUE(has(told.notes.front().message, "'unity-forward-base'")) << to_text(told);
    EXPECT_TRUE(has(told.notes.back().message, "stereo")) << to_text(told);
}

// The file contains only those parts of the engine's text that it needs.
TEST(UnityTextures, BringTheMacrosThatReadThem) {
    const std::string text = shader(material(R"("properties": [ { "name": "_MainTex", "type": "texture2d" } ],
      "nodes": [ { "id": "texel", "node": "SampleTexture2DLevel", "in": { "texture": "$_MainTex", "level": 2 } } ],
      "surface": { "baseColor": "texel.rgb" })"));
    EXPECT_TRUE(has(text, "#define SAMPLE_TEX2D_LOD(") && has(text, "SAMPLE_TEX2D_LOD(_MainTex, ")) << text;
    EXPECT_FALSE(has(text, "SAMPLE_TEX2D_SAMPLER_") || has(text, "SAMPLE_TEX2D_BIAS")) << text;
    EXPECT_TRUE(has(text, "#pragma target 3.0") && !has(text, "#pragma target 3.5")) << text;
}

struct SurfaceCase {
    std::string surface, type, queue, blend, fallback;
    std::vector<std::string> modes;
};

class UnityKind : public ::testing::TestWithParam<SurfaceCase> {};

// Blending as Unity's manual gives it for premultiplied and plain alpha, additive and multiplicative surfaces.
TEST_P(UnityKind, SaysHowItIsDrawn) {
    const SurfaceCase& kind = GetParam();
    const std::string text = shader(material(R"("render": { "surface": ")" + kind.surface + "\" }"));
    EXPECT_TRUE(has(text, "\"RenderType\" = \"" + kind.type + "\" \"Queue\" = \"" + kind.queue + "\"")) << text;
    EXPECT_TRUE(has(text, "FallBack " + kind.fallback)) << text;
    const ShaderLab file = taken_apart(text);
    std::vector<std::string> modes;
    for (const LabPass& pass : file.passes) modes.push_back(pass.light_mode);
    EXPECT_EQ(modes, kind.modes);
    const std::string& state = file.passes.front().state;
    if (kind.blend.empty()) {
        EXPECT_FALSE(has(state, "Blend")) << state;
        EXPECT_FALSE(has(state, "ZWrite")) << state;
    } else {
        EXPECT_TRUE(has(state, "Blend " + kind.blend + "\n")) << state;
        EXPECT_TRUE(has(state, "ZWrite Off")) << state;
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, UnityKind,
    ::testing::Values(
        SurfaceCase{
            "opaque", "Opaque", "Geometry", "", "\"VertexLit\"", {"ForwardBase", "ForwardAdd", "Meta", "Deferred"}},
        SurfaceCase{"cutout",
                    "TransparentCutout",
                    "AlphaTest",
                    "",
                    "\"Legacy Shaders/Transparent/Cutout/VertexLit\"",
                    {"ForwardBase", "ForwardAdd", "Meta", "ShadowCaster", "Deferred"}},
        SurfaceCase{"fade",
                    "Transparent",
                    "Transparent",
                    "SrcAlpha OneMinusSrcAlpha, One OneMinusSrcAlpha",
                    "Off",
                    {"ForwardBase", "ForwardAdd", "Meta"}},
        SurfaceCase{"transparent",
                    "Transparent",
                    "Transparent",
                    "One OneMinusSrcAlpha",
                    "Off",
                    {"ForwardBase", "ForwardAdd", "Meta"}},
        SurfaceCase{"additive", "Transparent", "Transparent", "One One, Zero One", "Off", {"ForwardBase", "Meta"}},
        SurfaceCase{
            "multiply", "Transparent", "Transparent", "DstColor Zero, Zero One", "Off", {"ForwardBase", "Meta"}}),
    [](const auto& info) { return info.param.surface; });

TEST(UnityState, IsThatOfTheGraph) {
    const std::string text = shader(
        material(R"("render": { "cull": "front", "depthWrite": false, "depthTest": "greaterEqual", "queue": 2460 })"));
    EXPECT_TRUE(has(text, "Cull Front"));
    EXPECT_TRUE(has(text, "ZWrite Off"));
    EXPECT_TRUE(has(text, "ZTest GEqual"));
    EXPECT_TRUE(has(text, "\"Queue\" = \"AlphaTest+10\""));
}

// Only Unity's own lighting can be left to its deferred path.
TEST(UnityDeferred, IsForUnitysModelsAlone) {
    for (const char* model : {"unity-brdf1", "unity-brdf2", "unity-brdf3"}) {
        const Result result =
            of_text(R"({ "patina": 1, "workflow": "metallic-smoothness", "lighting": ")" + std::string(model) + "\" }");
        ASSERT_TRUE(result.ok);
        EXPECT_TRUE(result.diagnostics.empty()) << to_text(result.diagnostics.front());
        EXPECT_TRUE(taken_apart(result.shaders.front().text).pass("Deferred")) << model;
    }
    for (const char* model : {"\"lambert\"", "\"gltf\"", R"({ "direct": "= @light.radiance" })"}) {
        const Result result =
            of_text(R"({ "patina": 1, "workflow": "metallic-smoothness", "lighting": )" + std::string(model) + "}");
        ASSERT_TRUE(result.ok);
        ASSERT_EQ(result.diagnostics.size(), 1u);
        EXPECT_EQ(result.diagnostics.front().code, "pass-left-out");
        const std::string message = result.diagnostics.front().message;
        EXPECT_TRUE(has(message, "the pass 'Deferred' is left out") && has(message, "unity-brdf1")) << message;
        EXPECT_EQ(result.diagnostics.front().column, 63);  // of the model
        EXPECT_FALSE(taken_apart(result.shaders.front().text).pass("Deferred")) << model;
    }
}

// Where an object has a Deferred pass its other passes are not drawn: those that a material adds are kept instead.
TEST(UnityDeferred, MakesRoomForPassesThatAreAdded) {
    const Result result = of_text(material(
        R"("passes": [ { "name": "outline", "workflow": "unlit", "render": { "cull": "front" }, "surface": { "color": 0 } } ])"));
    ASSERT_TRUE(result.ok) << to_text(result.diagnostics.front());
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics.front().code, "pass-left-out");
    EXPECT_TRUE(has(result.diagnostics.front().message, "'outline' is not")) << result.diagnostics.front().message;
    EXPECT_TRUE(has(result.diagnostics.front().source_line, "outline"));
    EXPECT_GT(result.diagnostics.front().column, 90);
    const ShaderLab file = taken_apart(result.shaders.front().text);
    EXPECT_FALSE(file.pass("Deferred"));
    EXPECT_EQ(file.passes.size(), 4u);
    EXPECT_TRUE(has(result.shaders.front().text, "Name \"outline\""));
}

// What is known to be kept is not asked for: alpha is 1 and alphaClip 0.5 unless the material says something else.
TEST(UnityCutout, AsksForNoAlphaThatIsKnown) {
    const auto discards = [](const std::string& surface) {
        const std::string text = shader(material(surface + R"("render": { "surface": "cutout" })"));
        const std::size_t begin = text.find("Name \"ShadowCaster\"");
        return has(text.substr(begin, text.find("Name \"DEFERRED\"") - begin), "discard;");
    };
    EXPECT_FALSE(discards(""));
    EXPECT_TRUE(discards(R"("surface": { "alpha": "@uv0.x" }, )"));
    EXPECT_TRUE(discards(R"("surface": { "alpha": 0.2 }, )"));
}

// A pass that could add nothing is not there, and no light would look different in the deferred path.
TEST(UnityUnlit, HasNoPassForLights) {
    const Result result = of_text(R"({ "patina": 1, "workflow": "unlit", "surface": { "color": "#ff8000" } })");
    ASSERT_TRUE(result.ok);
    EXPECT_TRUE(result.diagnostics.empty()) << to_text(result.diagnostics.front());
    const std::string& text = result.shaders.front().text;
    EXPECT_FALSE(taken_apart(text).pass("Deferred"));
    const ShaderLab file = taken_apart(text);
    EXPECT_TRUE(file.forward());
    EXPECT_FALSE(file.pass("ForwardAdd"));
    EXPECT_FALSE(has(text, "AutoLight.cginc"));
    EXPECT_FALSE(has(text, "multi_compile_fwdbase"));
    for (const std::string kind : {"additive", "multiply", "fade"}) {
        const Result blended = of_text(R"({ "patina": 1, "workflow": "unlit", "surface": { "color": 0.5 },
            "render": { "surface": ")" +
                                       kind + "\" } }");
        EXPECT_TRUE(blended.diagnostics.empty()) << to_text(blended.diagnostics.front());
    }
}

// What a material reads of the picture makes it wait for it, and keeps it out of the G-buffer.
TEST(UnityBackground, IsGrabbed) {
    const Result result = of_text(R"({ "patina": 1, "workflow": "metallic-smoothness", "lighting": "unity-brdf1",
        "surface": { "baseColor": "@sceneColor" } })");
    ASSERT_TRUE(result.ok);
    ASSERT_EQ(result.diagnostics.size(), 2u);  // of the G-buffer and of lightmaps
    for (const Diagnostic& each : result.diagnostics) EXPECT_EQ(each.code, "pass-left-out");
    const std::string& text = result.shaders.front().text;
    EXPECT_TRUE(has(text, "GrabPass { \"_BackgroundTexture\" }"));
    EXPECT_TRUE(has(text, "\"Queue\" = \"Transparent-100\""));
    EXPECT_FALSE(taken_apart(text).pass("Deferred"));
}

// Attributes of an engine's passes are refused in other pass files.
TEST(UnityAttributes, AreRefusedInPassFilesOfOnesOwn) {
    for (const std::string declaration :
         {"[foreign] float4 _Sun;", "[foreign] float3 Sun(float3 position);",
          "[gives(\"viewDirWS\")] float3 f() { return 0; }", "[text(\"pragma\", \"x\")] float3 f() { return 0; }",
          "[decodes(\"color\")] float3 f(float3 c) { return c; }"}) {
        CompileOptions options;
        options.request = CompileOptions::Passes{.path = "./mine.pass.hlsl"};
        options.files.read = [&](const std::string& path) -> std::optional<std::string> {
            if (path.ends_with(".graph.json")) return material("\"surface\": {}");
            return declaration + R"(
[pass("mine")] [vertex] float4 mineVertex(float3 position = positionWS) { return mul(worldToClip, float4(position, 1)); }
[pass("mine")] [fragment] [lights("none")] [blend("opaque", "one", "zero")] float4 mine() { return float4(1); }
)";
        };
        const Result result = compiler().compile_file("t.graph.json", options);
        EXPECT_FALSE(result.ok) << declaration;
        ASSERT_FALSE(result.diagnostics.empty()) << declaration;
        EXPECT_EQ(result.diagnostics.front().code, "bad-attribute") << declaration;
        EXPECT_EQ(result.diagnostics.front().line, 1) << declaration;
    }
}

// What is asked of Unity that it does not have is refused, at the node that asks.
TEST(UnitySeam, IsRefusedWhereUnityHasNothingLikeIt) {
    const Result added = of_text(R"({ "patina": 1, "workflow": "metallic-smoothness", "lighting": {
        "nodes": [ { "id": "sky", "node": "AmbientIrradiance" } ], "direct": "= sky * @light.color" } })");
    EXPECT_FALSE(added.ok);
    const Diagnostic in_add = first_error(added);
    EXPECT_EQ(in_add.code, "pass-refused");
    EXPECT_EQ(in_add.node, "sky") << to_text(in_add);
    EXPECT_TRUE(has(in_add.message, "'ForwardAdd'") && has(in_add.message, "'AmbientIrradiance'")) << in_add.message;
    const Result at_vertices = of_text(R"({ "patina": 1, "workflow": "metallic-smoothness",
        "nodes": [ { "id": "lit", "expr": "@light.color", "stage": "vertex" } ], "surface": { "baseColor": "lit" } })");
    EXPECT_FALSE(at_vertices.ok);
    EXPECT_EQ(first_error(at_vertices).code, "pass-refused");
    EXPECT_EQ(first_error(at_vertices).node, "lit") << to_text(first_error(at_vertices));
    EXPECT_TRUE(at_vertices.shaders.empty());
}

// What several sides need stands behind the narrowest condition of theirs, in the fewest words that Unity knows; what
// all need stands alone.
TEST(UnityKeywords, AreTestedInFewWords) {
    const auto text = [](const std::string& nodes, const std::string& color) {
        return shader(R"({ "patina": 1, "workflow": "unlit", "properties": [
            { "name": "_C", "type": "enum", "values": ["X", "Y", "Z", "W"], "as": "variant" },
            { "name": "_A", "type": "bool", "as": "variant" },
            { "name": "_MainTex", "type": "texture2d" } ],
          "nodes": [ { "id": "t", "node": "SampleTexture2D", "in": { "texture": "$_MainTex" } }, )" +
                      nodes + R"( ], "surface": { "color": ")" + color + R"(" } })");
    };
    const std::string other = text(R"({ "id": "d", "expr": "$_C != X && $_C != Y ? t.rgb : @normalWS" })", "d");
    EXPECT_TRUE(has(other, "#if defined(_C_Z) || defined(_C_W)\n")) << other;
    const std::string first = text(R"({ "id": "d", "expr": "$_C == X || $_C != Y && $_C == X ? t.rgb : 0.5" })", "d");
    EXPECT_TRUE(has(first, "#if !defined(_C_Y) && !defined(_C_Z) && !defined(_C_W)\n")) << first;
    const std::string all = text(R"({ "id": "d", "expr": "$_C == X ? t.rgb : $_C == Y ? t.gbr : t.brg" })", "d");
    EXPECT_TRUE(has(all, "float4 t = LinearColor(UNITY_SAMPLE_TEX2D(_MainTex, i.uv0));") ||
                has(all, "float4 t = LinearColor(UNITY_SAMPLE_TEX2D(_MainTex, uv0));"))
        << all;
    // Needed where _A is on, by one of them only if _C is Y.
    const std::string narrow = text(R"({ "id": "d", "expr": "$_A ? ($_C == Y ? t.rgb : 0.25) : 0.5" },
          { "id": "e", "expr": "$_A ? d * t.a : d" })",
                                    "e");
    const std::size_t sample = narrow.find("UNITY_SAMPLE_TEX2D(_MainTex");
    const std::size_t test = narrow.rfind("#if ", sample);
    EXPECT_EQ(narrow.substr(test, narrow.find('\n', test) - test), "#if defined(_A)") << narrow;
}

// A switch of other passes does not belong to this file; if GLSL is also written, it is GLSL's.
TEST(UnitySwitches, ArePropertiesAlone) {
    const std::string graph = material(R"("properties": [ { "name": "_WORN", "type": "bool", "as": "variant" } ],
      "surface": { "metallic": "= $_WORN ? 1 : 0" })");
    CompileOptions options;
    options.targets = {kUnity};
    options.switches = {{"_WORN", "true"}};
    const Result worn = compiler().compile_text("t.graph.json", graph, options);
    ASSERT_TRUE(worn.ok);
    EXPECT_FALSE(has(worn.shaders.front().text, "_WORN"));
    // A metal scatters no light.
    EXPECT_TRUE(has(worn.shaders.front().text, "output.diffuse = float4(ProjectColor(float3(0.0, 0.0, 0.0)), 1.0);"))
        << worn.shaders.front().text;

    options.switches.emplace_back("shadows", "");
    const Result refused = compiler().compile_text("t.graph.json", graph, options);
    EXPECT_EQ(first_error(refused).code, "unknown-word");
    EXPECT_EQ(first_error(refused).message, "'shadows' is not a variant or specialization constant of the graph");

    options.targets = {Target::Glsl, kUnity};
    const Result both = compiler().compile_text("t.graph.json", graph, options);
    ASSERT_TRUE(both.ok);
    EXPECT_EQ(both.shaders.back().text, worn.shaders.front().text);
}

TEST(UnityFunctions, AreRefused) {
    CompileOptions options;
    options.targets = {kUnity};
    options.request = CompileOptions::Functions{.prefix = "Rust_"};
    const Result result = compiler().compile_text("t.graph.json", material("\"surface\": {}"), options);
    EXPECT_FALSE(result.ok);
    EXPECT_EQ(result.diagnostics.front().code, "not-yet");
}

// One line of the file, one place in the graph.
TEST(UnityLines, AreMapped) {
    const Result result = for_unity("tests/unity/graphs/standard.graph.json");
    const Shader& shader = result.shaders.front();
    ASSERT_FALSE(shader.line_map.empty());
    int line = 1, found = 0;
    std::string before = "\n";
    for (std::size_t at = 0; at < shader.text.size(); ++line) {
        const std::size_t end = shader.text.find('\n', at);
        const std::string text = shader.text.substr(at, end - at);
        at = end + 1;
        if (!has(text, "float4 albedo = ")) continue;
        ++found;
        const auto after = std::upper_bound(shader.line_map.begin(), shader.line_map.end(), line,
                                            [](int l, const LineOrigin& origin) { return l < origin.line; });
        ASSERT_NE(after, shader.line_map.begin());
        EXPECT_EQ(std::prev(after)->node, "albedo");
        EXPECT_TRUE(has(std::prev(after)->source_text, "\"albedo\""));
    }
    EXPECT_EQ(found, 1);
}

// ... and those of the passes that a material adds, whose nodes are counted by themselves.
TEST(UnityLines, OfAddedPassesAreMapped) {
    const Result result = for_unity("tests/unity/graphs/passes.graph.json");
    const Shader& shader = result.shaders.front();
    const std::size_t at = shader.text.find("float3 positionOS = v.vertex.xyz + v.normal * _Width;");
    ASSERT_NE(at, std::string::npos);
    const auto line =
        static_cast<int>(std::count(shader.text.begin(), shader.text.begin() + std::ptrdiff_t(at), '\n')) + 1;
    const auto after = std::upper_bound(shader.line_map.begin(), shader.line_map.end(), line,
                                        [](int l, const LineOrigin& origin) { return l < origin.line; });
    ASSERT_NE(after, shader.line_map.begin());
    EXPECT_EQ(std::prev(after)->node, "shell");
    EXPECT_TRUE(has(std::prev(after)->source_text, "\"shell\"")) << std::prev(after)->source_text;
}

}  // namespace
}  // namespace patina::unity
