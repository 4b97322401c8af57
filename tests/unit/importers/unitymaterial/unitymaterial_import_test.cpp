// Materials of Unity: each shader, each keyword and setting, the pictures, variants of materials, and materials of
// shader graphs. Broken files are in unitymaterial_broken_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "tests/unit/importers/unitymaterial/unitymaterial_check.h"

namespace patina::importers {
namespace {

constexpr const char* kBrick = "0123456789abcdef0123456789abcdef";
constexpr const char* kBumps = "1123456789abcdef0123456789abcdef";

// --- Standard

MaterialText painted() {
    return {.numbers = {{"_Glossiness", "0.25"}, {"_Metallic", "0"}, {"_Mode", "0"}, {"_ZWrite", "1"}},
            .colors = {{"_Color", "{r: 1, g: 0.5019608, b: 0, a: 1}"}}};
}

constexpr std::string_view kPainted = R"({
  "patina": 1,
  "kind": "material",
  "name": "x",
  "workflow": "metallic-smoothness",
  "lighting": "unity-brdf1",
  "properties": [
    { "name": "_Color", "type": "color", "default": "#ff8000" },
    { "name": "_Metallic", "type": "float", "default": 0, "range": [0, 1] },
    { "name": "_Glossiness", "type": "float", "default": 0.25, "range": [0, 1] }
  ],
  "surface": { "baseColor": "$_Color.rgb", "metallic": "$_Metallic", "smoothness": "$_Glossiness" }
}
)";

TEST(UnityMaterial, BothFormsBecomeTheSameGraph) {
    const Imported made = import(painted());
    EXPECT_EQ(graph_of(made), kPainted);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    EXPECT_FALSE(made.has_refused);
    const Imported old = import_material(painted().old_text());
    EXPECT_EQ(graph_of(old), kPainted);
    EXPECT_EQ(remarks(old, Remark::Kind::Changed), "");
    expect_compiles(made, "painted");
}

TEST(UnityMaterial, EachPartHasARemarkWithItsPlace) {
    MaterialText material = painted();
    material.numbers.push_back({"_TheirNumber", "3"});
    material.colors.push_back({"_TheirColor", "{r: 1, g: 1, b: 1, a: 1}"});
    material.invalid_keywords = {"THEIR_KEYWORD"};
    const Imported made = import(material);
    std::string all;
    for (const Remark& each : made.remarks) all += each.part + ": " + each.text + "\n";
    for (const char* part :
         {"shader 'Standard': the workflow 'metallic-smoothness', lit by 'unity-brdf1'\n",
          "property '_Color': the property '_Color'\n", "property '_Mode': it concerns the inspector alone",
          "properties _TheirNumber, _TheirColor: not read by this shader\n",
          "keywords THEIR_KEYWORD: not read by this shader\n",
          "setting 'm_DoubleSidedGI': it concerns lightmaps alone\n",
          "setting 'm_CustomRenderQueue': \"queue\": 2000\n"})
        EXPECT_EQ(count(all, part), 1u) << part << "\n" << all;
    for (const Remark& each : made.remarks) {
        if (each.part == "shader 'Standard'") {
            EXPECT_EQ(each.line, 17);
            EXPECT_EQ(each.column, 3);
        }
    }
}

// A whole material of the universal pipeline, with detail maps. Of the values of another shader, nothing is left.
constexpr std::string_view kDetailed = R"x({
  "patina": 1,
  "kind": "material",
  "name": "x",
  "workflow": "metallic-smoothness",
  "lighting": "unity-brdf2",
  "properties": [
    { "name": "_BaseMap", "type": "texture2d", "usage": "color", "default": "./color.png" },
    { "name": "_BaseColor", "type": "color", "default": "#ff8000" },
    { "name": "_DetailMask", "type": "texture2d", "usage": "data", "default": "./mask.png" },
    { "name": "_DetailAlbedoMap", "type": "texture2d", "usage": "color", "default": "./detail.png" },
    { "name": "_DetailAlbedoMapScale", "type": "float", "default": 0.5, "range": [0, 2] },
    { "name": "_MetallicGlossMap", "type": "texture2d", "usage": "data", "default": "./packed.png" },
    { "name": "_Smoothness", "type": "float", "default": 0.75, "range": [0, 1] },
    { "name": "_DetailNormalMapScale", "type": "float", "default": 2, "range": [-2, 2] },
    { "name": "_DetailNormalMap", "type": "texture2d", "usage": "normal", "default": "./detailBumps.png" },
    { "name": "_OcclusionMap", "type": "texture2d", "usage": "data", "default": "./packed.png" },
    { "name": "_OcclusionStrength", "type": "float", "default": 0.25, "range": [0, 1] },
    { "name": "_EmissionColor", "type": "color", "default": [0, 2, 4], "range": [0, 4] },
    { "name": "_Cutoff", "type": "float", "default": 0.3, "range": [0, 1] }
  ],
  "nodes": [
    { "id": "uv", "node": "TilingOffset", "in": { "tiling": [2, 2] } },
    { "id": "detailUV", "node": "TilingOffset", "in": { "uv": "uv", "tiling": [4, 4] } },
    { "id": "main", "node": "SampleTexture2D", "in": { "texture": "$_BaseMap", "uv": "uv" } },
    { "id": "mask", "node": "SampleTexture2D", "in": { "texture": "$_DetailMask", "uv": "uv" } },
    { "id": "detail", "node": "SampleTexture2D", "in": { "texture": "$_DetailAlbedoMap", "uv": "detailUV" } },
    {
      "id": "detailed",
      "node": "DetailAlbedo",
      "in": {
        "base": "= main.rgb * $_BaseColor.rgb",
        "detail": "= lerp(float3(0.5), detail.rgb, $_DetailAlbedoMapScale)",
        "mask": "mask.a",
        "space": "Gamma"
      },
      "note": "Unity's universal pipeline doubles the texel in linear colours, too."
    },
    {
      "id": "metallicGloss",
      "node": "SampleTexture2D",
      "in": { "texture": "$_MetallicGlossMap", "uv": "uv" }
    },
    {
      "id": "detailBumps",
      "node": "SampleNormalMap",
      "in": { "texture": "$_DetailNormalMap", "uv": "detailUV", "scale": "$_DetailNormalMapScale" }
    },
    {
      "id": "detailedBumps",
      "node": "DetailNormal",
      "in": { "detail": "detailBumps", "mask": "mask.a", "mode": "Reoriented" }
    },
    { "id": "cavity", "node": "SampleTexture2D", "in": { "texture": "$_OcclusionMap", "uv": "uv" } },
    {
      "id": "occlusion",
      "node": "OcclusionStrength",
      "in": { "occlusion": "cavity.g", "strength": "$_OcclusionStrength" }
    }
  ],
  "surface": {
    "baseColor": "detailed",
    "metallic": "metallicGloss.r",
    "smoothness": "= metallicGloss.a * $_Smoothness",
    "normalTS": "detailedBumps",
    "occlusion": "occlusion",
    "emission": "$_EmissionColor.rgb",
    "alpha": "main.a",
    "alphaClip": "$_Cutoff"
  },
  "render": { "surface": "cutout", "cull": "off" }
}
)x";

TEST(UnityMaterial, AWholeMaterialReadsAsAPersonWritesIt) {
    const MaterialFolder folder;
    MaterialText material{
        .shader = kLit,
        .keywords = {"_ALPHATEST_ON", "_DETAIL_SCALED", "_EMISSION", "_METALLICSPECGLOSSMAP", "_OCCLUSIONMAP"},
        .numbers = {{"_Smoothness", "0.75"},
                    {"_DetailAlbedoMapScale", "0.5"},
                    {"_DetailNormalMapScale", "2"},
                    {"_OcclusionStrength", "0.25"},
                    {"_Cutoff", "0.3"},
                    {"_Cull", "0"},
                    {"_Glossiness", "0.9"}},
        .colors = {{"_BaseColor", "{r: 1, g: 0.5019608, b: 0, a: 1}"},
                   {"_EmissionColor", "{r: 0, g: 2, b: 4, a: 1}"},
                   {"_Color", "{r: 1, g: 0, b: 0, a: 1}"}},
        .queue = "2450"};
    const TextureText textures[] = {{"_BaseMap", "color.png", "{x: 2, y: 2}"},
                                    {"_MetallicGlossMap", "packed.png"},
                                    {"_OcclusionMap", "packed.png"},
                                    {"_DetailAlbedoMap", "detail.png", "{x: 4, y: 4}"},
                                    {"_DetailNormalMap", "detailBumps.png"},
                                    {"_DetailMask", "mask.png"},
                                    {"_MainTex", "color.png"}};
    for (TextureText each : textures) {
        const std::string guid = fmt::format("{:032x}", std::hash<std::string>()(each.guid));
        folder.save(each.guid, "", guid);
        each.guid = guid;
        material.textures.push_back(each);
    }
    const Imported made = import_in(folder, material);
    EXPECT_EQ(graph_of(made), kDetailed);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    EXPECT_NE(
        remarks(made, Remark::Kind::Taken).find("properties _MainTex, _Glossiness, _Color: not read by this shader\n"),
        std::string::npos)
        << remarks(made, Remark::Kind::Taken);
    expect_compiles(made, "detailed");
}

// The height map moves the coordinates of all maps, the detail maps, too.
TEST(UnityMaterial, AHeightMapMovesAllMaps) {
    const MaterialFolder folder;
    folder.save("brick.png", "", kBrick);
    MaterialText material{.keywords = {"_NORMALMAP", "_PARALLAXMAP", "_DETAIL_MULX2"},
                          .textures = {{"_MainTex", kBrick, "{x: 2, y: 2}"},
                                       {"_BumpMap", kBrick},
                                       {"_ParallaxMap", kBrick},
                                       {"_DetailAlbedoMap", kBrick, "{x: 8, y: 8}"}},
                          .numbers = {{"_Parallax", "0.03"}, {"_UVSec", "1"}}};
    const Imported made = import_in(folder, material);
    const std::string& text = graph_of(made);
    for (const char* part :
         {R"({ "texture": "$_ParallaxMap", "uv": "uv" })", R"("id": "moved", "expr": "uv + parallax")",
          R"({ "texture": "$_MainTex", "uv": "moved" })", R"({ "texture": "$_BumpMap", "uv": "moved" })",
          R"({ "uv": "@uv1", "tiling": [8, 8] })", R"("id": "movedDetail", "expr": "detailUV + parallax")",
          R"({ "texture": "$_DetailAlbedoMap", "uv": "movedDetail" })"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    expect_compiles(made, "parallax");
}

// A map is read if its keyword is on, and only then.
TEST(UnityMaterial, KeywordsDecideWhatIsRead) {
    const MaterialFolder folder;
    folder.save("brick.png", "", kBrick);
    struct Case {
        const char *keyword, *texture, *shader, *expected;
    };
    const Case cases[] = {
        {"_NORMALMAP", "_BumpMap", kStandard, R"("normalTS": "bumps")"},
        {"_METALLICGLOSSMAP", "_MetallicGlossMap", kStandard, R"("metallic": "metallicGloss.r")"},
        {"_METALLICGLOSSMAP", "_MetallicGlossMap", kStandard, R"("smoothness": "metallicGloss.a")"},
        {"_SPECGLOSSMAP", "_SpecGlossMap", kStandardSpecular, R"("specular": "specGloss.rgb")"},
        {"_SPECGLOSSMAP", "_SpecGlossMap", kStandardSpecular, R"("glossiness": "specGloss.a")"},
        {"_PARALLAXMAP", "_ParallaxMap", kStandard, R"("expr": "@uv0 + parallax")"},
        {"_DETAIL_MULX2", "_DetailAlbedoMap", kStandard, R"("baseColor": "detailed")"},
        {"_METALLICSPECGLOSSMAP", "_MetallicGlossMap", kLit, R"("metallic": "metallicGloss.r")"},
        {"_METALLICSPECGLOSSMAP", "_MetallicGlossMap", kLit, R"("smoothness": "= metallicGloss.a * $_Smoothness")"},
        {"_OCCLUSIONMAP", "_OcclusionMap", kLit, R"("occlusion": "cavity.g")"},
        {"_NORMALMAP", "_BumpMap", kLit, R"("normalTS": "bumps")"},
        {"_DETAIL_MULX2", "_DetailAlbedoMap", kLit, R"("space": "Gamma")"},
        {"_NORMALMAP", "_BumpMap", kSimpleLit, R"("normalTS": "bumps")"},
        {"_SPECGLOSSMAP", "_SpecGlossMap", kSimpleLit, R"("specularColor": "= specGloss.rgb * $_SpecColor.rgb")"},
    };
    for (const Case& each : cases) {
        MaterialText material{.shader = each.shader, .textures = {{each.texture, kBrick}}};
        Imported made = import_in(folder, material);
        EXPECT_EQ(graph_of(made).find("brick.png"), std::string::npos) << each.keyword;
        EXPECT_NE(remarks(made, Remark::Kind::Taken).find(each.texture + std::string("': it has no effect")),
                  std::string::npos)
            << remarks(made, Remark::Kind::Taken);
        expect_compiles(made, each.keyword);
        material.keywords = {each.keyword};
        made = import_in(folder, material);
        EXPECT_NE(graph_of(made).find(each.expected), std::string::npos) << each.keyword << "\n" << graph_of(made);
        EXPECT_NE(graph_of(made).find("./brick.png"), std::string::npos) << each.keyword << "\n" << graph_of(made);
        expect_compiles(made, each.keyword);
    }
}

TEST(UnityMaterial, SmoothnessMayBeTheAlphaOfTheAlbedo) {
    const MaterialFolder folder;
    folder.save("brick.png", "", kBrick);
    MaterialText material{.keywords = {"_SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A"},
                          .textures = {{"_MainTex", kBrick}},
                          .numbers = {{"_GlossMapScale", "0.5"}}};
    const Imported standard = import_in(folder, material);
    EXPECT_NE(graph_of(standard).find(R"("smoothness": "= main.a * $_GlossMapScale")"), std::string::npos)
        << graph_of(standard);
    expect_compiles(standard, "standard");
    material.shader = kLit;
    material.textures[0].name = "_BaseMap";
    material.numbers = {{"_Smoothness", "1"}};
    const Imported universal = import_in(folder, material);
    EXPECT_NE(graph_of(universal).find(R"("smoothness": "main.a")"), std::string::npos) << graph_of(universal);
    expect_compiles(universal, "universal");
}

// Standard decodes its slider of metallic; the universal pipeline does not.
TEST(UnityMaterial, MetallicOfStandardIsDecoded) {
    MaterialText material = painted();
    material.numbers[1].value = "0.5";
    EXPECT_NE(graph_of(import(material)).find(R"("metallic": "= SrgbToLinear($_Metallic).x")"), std::string::npos);
    expect_compiles(import(material), "metallic");
    material.shader = kLit;
    EXPECT_NE(graph_of(import(material)).find(R"("metallic": "$_Metallic")"), std::string::npos);
}

// The colour is HDR in the universal pipeline, and decoded in the built-in one: 0.5 is 0.2140 in linear light (IEC
// 61966-2-1), and 2 is 2^2.2 = 4.5948, as Unity continues the curve.
TEST(UnityMaterial, EmissionIsLight) {
    MaterialText material{.keywords = {"_EMISSION"}, .colors = {{"_EmissionColor", "{r: 0.5, g: 2, b: 0, a: 1}"}}};
    const std::string standard_graph = graph_of(import(material));
    const std::vector<double> standard =
        numbers_of(standard_graph.substr(standard_graph.find("_EmissionColor")), "\"default\": [");
    ASSERT_EQ(standard.size(), 3u) << standard_graph;
    EXPECT_NEAR(standard[0], 0.2140, 1e-4);
    EXPECT_NEAR(standard[1], 4.5948, 1e-4);
    EXPECT_EQ(standard[2], 0);
    expect_compiles(import(material), "standard");
    material.shader = kLit;
    const Imported universal = import(material);
    EXPECT_NE(graph_of(universal).find(R"("type": "color", "default": [0.5, 2, 0], "range": [0, 2])"),
              std::string::npos)
        << graph_of(universal);
    EXPECT_NE(graph_of(universal).find(R"("emission": "$_EmissionColor.rgb")"), std::string::npos);
    material.colors[0].value = "{r: 0, g: 0, b: 0, a: 1}";
    EXPECT_EQ(graph_of(import(material)).find("emission"), std::string::npos);
    material.keywords.clear();
    EXPECT_EQ(graph_of(import(material)).find("emission"), std::string::npos);
}

// --- the render state

TEST(UnityMaterial, SettingsBecomeTheRenderState) {
    struct Case {
        const char* what;
        MaterialText material;
        const char* expected;  // empty: no "render"
    };
    const auto blend = [](const char* shader, const char* source, const char* destination, const char* write,
                          std::vector<std::string> keywords, const char* queue) {
        return MaterialText{.shader = shader,
                            .keywords = std::move(keywords),
                            .numbers = {{"_SrcBlend", source}, {"_DstBlend", destination}, {"_ZWrite", write}},
                            .queue = queue};
    };
    const Case cases[] = {
        {"opaque", blend(kStandard, "1", "0", "1", {}, "-1"), ""},
        {"cutout", blend(kStandard, "1", "0", "1", {"_ALPHATEST_ON"}, "2450"), R"({ "surface": "cutout" })"},
        {"fade", blend(kStandard, "5", "10", "0", {"_ALPHABLEND_ON"}, "3000"), R"({ "surface": "fade" })"},
        {"transparent", blend(kStandard, "1", "10", "0", {"_ALPHAPREMULTIPLY_ON"}, "3000"),
         R"({ "surface": "transparent" })"},
        {"queue", blend(kStandard, "5", "10", "0", {"_ALPHABLEND_ON"}, "3010"),
         R"({ "surface": "fade", "queue": 3010 })"},
        {"the shader's queue", blend(kStandard, "5", "10", "0", {"_ALPHABLEND_ON"}, "-1"),
         R"({ "surface": "fade", "queue": 2000 })"},
        {"depth", blend(kStandard, "5", "10", "1", {"_ALPHABLEND_ON"}, "3000"),
         R"({ "surface": "fade", "depthWrite": true })"},
        {"additive", blend(kUnlit, "5", "1", "0", {"_SURFACE_TYPE_TRANSPARENT"}, "3000"),
         R"({ "surface": "additive" })"},
        {"multiply", blend(kUnlit, "2", "0", "0", {"_SURFACE_TYPE_TRANSPARENT", "_ALPHAMODULATE_ON"}, "3000"),
         R"({ "surface": "multiply" })"},
        {"both faces", {.shader = kLit, .numbers = {{"_Cull", "0"}}}, R"({ "cull": "off" })"},
        {"back faces", {.shader = kLit, .numbers = {{"_Cull", "1"}}}, R"({ "cull": "front" })"},
        {"clipped and blended", blend(kLit, "5", "10", "0", {"_ALPHATEST_ON"}, "3000"), R"({ "surface": "fade" })"},
    };
    for (const Case& each : cases) {
        const Imported made = import(each.material);
        const std::string& text = graph_of(made);
        if (*each.expected) {
            EXPECT_NE(text.find("\"render\": " + std::string(each.expected)), std::string::npos) << each.what << "\n"
                                                                                                 << text;
        } else {
            EXPECT_EQ(text.find("\"render\""), std::string::npos) << each.what << "\n" << text;
        }
        EXPECT_EQ(remarks(made, Remark::Kind::Changed), "") << each.what;
        expect_compiles(made, each.what);
    }
}

TEST(UnityMaterial, AlphaIsCutOff) {
    const MaterialFolder folder;
    folder.save("leaf.png", "", kBrick);
    MaterialText material{.keywords = {"_ALPHATEST_ON"},
                          .textures = {{"_MainTex", kBrick}},
                          .numbers = {{"_Cutoff", "0.3"}},
                          .colors = {{"_Color", "{r: 1, g: 1, b: 1, a: 0.5}"}},
                          .queue = "2450"};
    const std::string cutout = graph_of(import_in(folder, material));
    EXPECT_NE(cutout.find(R"("alpha": "= main.a * $_Color.a")"), std::string::npos) << cutout;
    EXPECT_NE(cutout.find(R"("alphaClip": "$_Cutoff")"), std::string::npos) << cutout;
    expect_compiles(import_in(folder, material), "cutout");
    material.numbers = {{"_Cutoff", "0.3"}, {"_SrcBlend", "5"}, {"_DstBlend", "10"}, {"_ZWrite", "0"}};
    const std::string both = graph_of(import_in(folder, material));
    EXPECT_NE(both.find(R"("alphaClip": "$_Cutoff")"), std::string::npos) << both;
    EXPECT_NE(both.find(R"("surface": "fade")"), std::string::npos) << both;
    expect_compiles(import_in(folder, material), "both");
}

TEST(UnityMaterial, WhatAGraphDoesNotSayIsApproximated) {
    MaterialText material = painted();
    material.shader = kComplexLit;
    material.keywords = {"_SPECULARHIGHLIGHTS_OFF", "_ENVIRONMENTREFLECTIONS_OFF", "_RECEIVE_SHADOWS_OFF",
                         "_CLEARCOAT"};
    material.disabled_passes = {"MOTIONVECTORS", "SHADOWCASTER"};
    material.numbers = {{"_SrcBlend", "4"}, {"_DstBlend", "1"}};
    material.queue = "9000";
    const Imported made = import(material);
    const std::string changed = remarks(made, Remark::Kind::Changed);
    for (const char* part :
         {"keyword '_SPECULARHIGHLIGHTS_OFF': lights have highlights", "keyword '_ENVIRONMENTREFLECTIONS_OFF': ",
          "keyword '_RECEIVE_SHADOWS_OFF': ", "keyword '_CLEARCOAT': the surface has no coat", "it casts shadows",
          "the blend factors 4 and 1 of Unity are none that a graph has", "\"queue\": 5000"})
        EXPECT_NE(changed.find(part), std::string::npos) << part << "\n" << changed;
    EXPECT_FALSE(made.has_refused);
    expect_compiles(made, "approximate");
}

// --- other shaders

TEST(UnityMaterial, EachShaderHasItsWorkflow) {
    struct Case {
        const char *shader, *workflow, *lighting;
    };
    const Case cases[] = {
        {kStandard, "metallic-smoothness", R"("unity-brdf1")"},
        {kStandardSpecular, "specular-glossiness", R"("unity-brdf1")"},
        {kLit, "metallic-smoothness", R"("unity-brdf2")"},
        {kComplexLit, "metallic-smoothness", R"("unity-brdf2")"},
        {kSimpleLit, "specular-glossiness", R"({ "use": "blinn-phong", "in": { "_Normalization": "Classic" } })"},
        {kBakedLit, "specular-glossiness", R"("lambert")"},
        {kUnlit, "unlit", ""},
        {"{fileID: 10750, guid: 0000000000000000f000000000000000, type: 0}", "unlit", ""},
        {"{fileID: 10751, guid: 0000000000000000f000000000000000, type: 0}", "unlit", ""},
        {"{fileID: 10752, guid: 0000000000000000f000000000000000, type: 0}", "unlit", ""},
        {"{fileID: 10755, guid: 0000000000000000f000000000000000, type: 0}", "unlit", ""},
    };
    for (const Case& each : cases) {
        const Imported made = import({.shader = each.shader});
        const std::string& text = graph_of(made);
        EXPECT_NE(text.find("\"workflow\": \"" + std::string(each.workflow) + "\""), std::string::npos) << text;
        EXPECT_EQ(text.find("\"lighting\"") == std::string::npos, !*each.lighting) << text;
        EXPECT_NE(text.find(each.lighting), std::string::npos) << text;
        EXPECT_FALSE(made.has_refused) << each.shader;
        expect_compiles(made, each.shader);
    }
}

// The exponent of Unity's highlight is 2^(10 s + 1), s the alpha of the specular colour.
TEST(UnityMaterial, SimpleLitHasAHighlight) {
    MaterialText material{
        .shader = kSimpleLit,
        .keywords = {"_SPECULAR_COLOR"},
        .colors = {{"_SpecColor", "{r: 1, g: 0, b: 0, a: 0.4}"}, {"_BaseColor", "{r: 1, g: 1, b: 1, a: 0.5}"}}};
    std::string text = graph_of(import(material));
    EXPECT_NE(text.find(R"("specularColor": "$_SpecColor.rgb")"), std::string::npos) << text;
    EXPECT_NE(text.find(R"x("exponent": "= exp2(10 * $_SpecColor.a + 1)")x"), std::string::npos) << text;
    expect_compiles(import(material), "highlight");
    material.keywords.push_back("_GLOSSINESS_FROM_BASE_ALPHA");
    text = graph_of(import(material));
    EXPECT_NE(text.find(R"x("exponent": "= exp2(10 * $_BaseColor.a + 1)")x"), std::string::npos) << text;
    expect_compiles(import(material), "base alpha");
    material.keywords.clear();
    text = graph_of(import(material));
    EXPECT_NE(text.find(R"("specularColor": 0)"), std::string::npos) << text;
}

TEST(UnityMaterial, OtherShadersAreReadByTheNamesOfTheirProperties) {
    const MaterialFolder folder;
    folder.save("Toon.shader", "Shader \"Toon\" {}", kBumps);
    folder.save("brick.png", "", kBrick);
    MaterialText material = painted();
    material.shader = fmt::format("{{fileID: 4800000, guid: {}, type: 3}}", kBumps);
    material.textures = {{"_BumpMap", kBrick}};
    Imported made = import_in(folder, material);
    EXPECT_NE(remarks(made, Remark::Kind::Changed)
                  .find("the shader 'Toon.shader' is not known: the properties are read as those of 'Standard'"),
              std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    // No keyword says whether it reads its normal map.
    EXPECT_NE(graph_of(made).find("\"normalTS\": \"bumps\""), std::string::npos) << graph_of(made);
    expect_compiles(made, "toon");
    material.shader = "{fileID: 4800000, guid: 9123456789abcdef0123456789abcdef, type: 3}";
    made = import_in(folder, {.shader = material.shader, .colors = {{"_TheirColor", "{r: 1, g: 1, b: 1, a: 1}"}}});
    EXPECT_TRUE(made.has_refused);
    EXPECT_NE(
        remarks(made, Remark::Kind::LeftOut).find("has the GUID 9123456789abcdef0123456789abcdef, and no property"),
        std::string::npos)
        << remarks(made, Remark::Kind::LeftOut);
    EXPECT_NE(graph_of(made).find("float3(1, 0, 1)"), std::string::npos);
    expect_compiles(made, "unknown");
}

// --- pictures

// Unity counts v from the bottom: with a scale of 2 and an offset of 0.25, v = 0 of the graph, the top, is the place
// 1 - (1 * 2 + 0.25) = -1.25 from the top, of which a picture that repeats keeps 0.75.
TEST(UnityMaterial, TilingCountsFromTheBottom) {
    const MaterialFolder folder;
    folder.save("brick.png", "", kBrick);
    MaterialText material = painted();
    material.textures = {{"_MainTex", kBrick, "{x: 2, y: 2}", "{x: 0.5, y: 0.25}"}};
    std::string text = graph_of(import_in(folder, material));
    EXPECT_NE(text.find(R"("node": "TilingOffset", "in": { "tiling": [2, 2], "offset": [0.5, 0.75] })"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find(R"("in": { "texture": "$_MainTex", "uv": "uv" })"), std::string::npos) << text;
    expect_compiles(import_in(folder, material), "tiled");
    folder.save("brick.png", "", kBrick, texture_meta("sRGBTexture: 1", "wrapU: 1\n    wrapV: 1"));
    text = graph_of(import_in(folder, material));
    EXPECT_NE(text.find(R"("offset": [0.5, -1.25])"), std::string::npos) << text;
    EXPECT_NE(text.find(R"("sampler": { "wrap": "clamp" })"), std::string::npos) << text;
}

TEST(UnityMaterial, ImportSettingsOfPicturesCount) {
    const MaterialFolder folder;
    const auto text_with = [&](const std::string& settings, const char* property, const char* keyword) {
        folder.save("a.png", "", kBrick, settings);
        MaterialText material = painted();
        material.keywords = {keyword};
        material.textures = {{property, kBrick}};
        const Imported made = import_in(folder, material);
        expect_compiles(made, settings);
        return graph_of(made) + remarks(made, Remark::Kind::Changed);
    };
    struct Case {
        std::string settings;
        const char *property, *keyword, *expected;
    };
    const Case cases[] = {
        {"", "_MetallicGlossMap", "_METALLICGLOSSMAP", R"("usage": "data")"},
        {texture_meta("sRGBTexture: 1", "wrapU: 0"), "_MetallicGlossMap", "_METALLICGLOSSMAP", R"("usage": "color")"},
        {texture_meta("sRGBTexture: 0", "wrapU: 0"), "_MainTex", "", R"("usage": "data")"},
        {texture_meta("sRGBTexture: 1", "wrapU: 2\n    wrapV: 2\n    filterMode: 0\n    aniso: 9"), "_MainTex", "",
         R"("sampler": { "wrap": "mirror", "filter": "nearest", "anisotropy": 8 })"},
        {texture_meta("sRGBTexture: 1", "wrapU: 0\n    wrapV: 1"), "_MainTex", "", "one wrap mode for both directions"},
        {texture_meta("sRGBTexture: 1", "wrapU: 0", "  alphaUsage: 0\n"), "_MainTex", "", R"("swizzle": "rgb1")"},
        {texture_meta("sRGBTexture: 1", "wrapU: 0", "  alphaUsage: 2\n"), "_MainTex", "", "its alpha is its own"},
        {texture_meta("sRGBTexture: 0", "wrapU: 0", "  textureType: 1\n  bumpmap:\n    flipGreenChannel: 1\n"),
         "_BumpMap", "_NORMALMAP", R"("handedness": "directx")"},
        {texture_meta("sRGBTexture: 1", "wrapU: 0"), "_BumpMap", "_NORMALMAP", "it is not imported as a normal map"},
        {texture_meta("sRGBTexture: 0", "wrapU: 0", "  textureType: 1\n  bumpmap:\n    convertToNormalMap: 1\n"),
         "_BumpMap", "_NORMALMAP", "Unity makes a normal map of this picture"},
    };
    for (const Case& each : cases) {
        const std::string text = text_with(each.settings, each.property, each.keyword);
        EXPECT_NE(text.find(each.expected), std::string::npos) << each.settings << "\n" << text;
    }
}

TEST(UnityMaterial, MissingPicturesAreSaid) {
    const MaterialFolder folder;
    MaterialText material = painted();
    material.textures = {{"_MainTex", kBrick}};
    Imported made = import_in(folder, material);
    EXPECT_NE(
        remarks(made, Remark::Kind::Changed).find(std::string("has the GUID ") + kBrick + ": the texture is white"),
        std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    EXPECT_NE(graph_of(made).find(std::string("// The picture with the GUID ") + kBrick), std::string::npos);
    EXPECT_FALSE(made.has_refused);
    expect_compiles(made, "missing");
    folder.save("a.png", "", kBrick);
    folder.save("b.png", "", kBrick);
    made = import_in(folder, material);
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("b.png' has the same GUID as '"), std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    EXPECT_NE(graph_of(made).find("./a.png"), std::string::npos);
}

// --- variants of materials

TEST(UnityMaterial, AVariantHasTheValuesOfItsParents) {
    const MaterialFolder folder;
    MaterialText base = painted();
    base.keywords = {"_ALPHATEST_ON"};
    base.numbers.push_back({"_Cutoff", "0.75"});
    base.queue = "2460";
    folder.save("Base.mat", base.text(), kBrick);
    MaterialText middle{.numbers = {{"_Glossiness", "0.5"}}};
    middle.parent = fmt::format("{{fileID: 2100000, guid: {}, type: 2}}", kBrick);
    folder.save("Middle.mat", middle.text(), kBumps);
    MaterialText material{.shader = "{fileID: 0}", .colors = {{"_Color", "{r: 0, g: 1, b: 0, a: 1}"}}};
    material.parent = fmt::format("{{fileID: 2100000, guid: {}, type: 2}}", kBumps);
    Imported made = import_in(folder, material);
    const std::string text = graph_of(made);
    EXPECT_NE(text.find(R"("default": "#00ff00")"), std::string::npos) << text;
    EXPECT_NE(text.find(R"("_Glossiness", "type": "float", "default": 0.5)"), std::string::npos) << text;
    EXPECT_NE(text.find(R"("_Cutoff", "type": "float", "default": 0.75)"), std::string::npos) << text;
    EXPECT_NE(text.find(R"("render": { "surface": "cutout", "queue": 2460 })"), std::string::npos) << text;
    EXPECT_NE(remarks(made, Remark::Kind::Taken).find("property '_Cutoff' of 'Base.mat': "), std::string::npos);
    expect_compiles(made, "variant");
    // A queue of its own.
    material.queue = "2470";
    material.modified = "16";
    EXPECT_NE(graph_of(import_in(folder, material)).find("\"queue\": 2470"), std::string::npos);
}

TEST(UnityMaterial, AWrongValueOfAParentIsSaidAtItsPlace) {
    const MaterialFolder folder;
    MaterialText base = painted();
    base.numbers.push_back({"_Cutoff", "much"});
    folder.save("Base.mat", base.text(), kBrick);
    MaterialText material{.shader = "{fileID: 0}"};
    material.parent = fmt::format("{{fileID: 2100000, guid: {}, type: 2}}", kBrick);
    const Imported made = import_in(folder, material);
    const auto found = std::ranges::find(made.remarks, "property '_Cutoff'", &Remark::part);
    ASSERT_NE(found, made.remarks.end());
    EXPECT_EQ(found->file, "Base.mat");
    const std::string text = base.text();
    EXPECT_EQ(found->line, 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(text.find("much")), '\n'));
}

TEST(UnityMaterial, AMissingParentIsRefused) {
    MaterialText material = painted();
    material.parent = "{fileID: 2100000, guid: 9123456789abcdef0123456789abcdef, type: 2}";
    const Imported made = import(material);
    EXPECT_TRUE(made.has_refused);
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find("has the GUID 9123456789abcdef0123456789abcdef"),
              std::string::npos);
    expect_compiles(made, "orphan");
}

}  // namespace
}  // namespace patina::importers
