// Materials of the high definition pipeline's Lit.
#include <gtest/gtest.h>

#include "tests/unit/importers/unitymaterial/unitymaterial_check.h"

namespace patina::importers {
namespace {

constexpr const char* kPicture = "2123456789abcdef0123456789abcdef";
constexpr const char* kHdLit = "{fileID: 4800000, guid: 6e4ae4064600d784cac1e41a9e6f2e59, type: 3}";

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

MaterialText with(std::vector<std::string> keywords, std::vector<ValueText> numbers = {}) {
    return {.shader = kHdLit, .keywords = std::move(keywords), .numbers = std::move(numbers)};
}

// A whole material, as the pipeline's inspector leaves it.
constexpr std::string_view kPainted = R"x({
  "patina": 1,
  "kind": "material",
  "name": "x",
  "workflow": "metallic-smoothness",
  "lighting": "unity-brdf1",
  "properties": [
    { "name": "_BaseColorMap", "type": "texture2d", "usage": "color", "default": "./picture.png" },
    { "name": "_MaskMap", "type": "texture2d", "usage": "data", "default": "./picture.png" },
    { "name": "_BaseColor", "type": "color", "default": "#ff8000" },
    { "name": "_SmoothnessRemapMin", "type": "float", "default": 0.25, "range": [0, 1] },
    { "name": "_SmoothnessRemapMax", "type": "float", "default": 0.75, "range": [0, 1] },
    { "name": "_NormalScale", "type": "float", "default": 2, "range": [0, 8] },
    { "name": "_NormalMap", "type": "texture2d", "usage": "normal", "default": "./picture.png" },
    { "name": "_EmissiveColor", "type": "color", "default": [0, 2, 4], "range": [0, 4] },
    { "name": "_AlphaCutoff", "type": "float", "default": 0.3, "range": [0, 1] }
  ],
  "nodes": [
    { "id": "uv", "node": "TilingOffset", "in": { "tiling": [2, 2] } },
    { "id": "main", "node": "SampleTexture2D", "in": { "texture": "$_BaseColorMap", "uv": "uv" } },
    { "id": "mask", "node": "SampleTexture2D", "in": { "texture": "$_MaskMap", "uv": "uv" } },
    {
      "id": "bumps",
      "node": "SampleNormalMap",
      "in": { "texture": "$_NormalMap", "uv": "uv", "scale": "$_NormalScale" }
    }
  ],
  "surface": {
    "baseColor": "= main.rgb * $_BaseColor.rgb",
    "metallic": "mask.r",
    "smoothness": "= lerp($_SmoothnessRemapMin, $_SmoothnessRemapMax, mask.a)",
    "normalTS": "bumps",
    "occlusion": "mask.g",
    "emission": "$_EmissiveColor.rgb",
    "alpha": "main.a",
    "alphaClip": "$_AlphaCutoff"
  },
  "render": { "surface": "cutout", "cull": "off" }
}
)x";

TEST(UnityHighDefinition, AMaterialBecomesAGraph) {
    const MaterialFolder folder;
    folder.save("picture.png", "", kPicture);
    MaterialText material = with({"_ALPHATEST_ON", "_DOUBLESIDED_ON", "_MASKMAP", "_NORMALMAP",
                                  "_NORMALMAP_TANGENT_SPACE", "_DISABLE_SSR_TRANSPARENT"},
                                 {{"_Metallic", "0.5"},
                                  {"_MetallicRemapMin", "0"},
                                  {"_MetallicRemapMax", "1"},
                                  {"_Smoothness", "0.5"},
                                  {"_SmoothnessRemapMin", "0.25"},
                                  {"_SmoothnessRemapMax", "0.75"},
                                  {"_NormalScale", "2"},
                                  {"_AlphaCutoff", "0.3"},
                                  {"_CullMode", "0"},
                                  {"_MaterialID", "1"},
                                  {"_StencilRef", "2"}});
    material.textures = {{"_BaseColorMap", kPicture, "{x: 2, y: 2}"}, {"_MaskMap", kPicture}, {"_NormalMap", kPicture}};
    material.colors = {{"_BaseColor", "{r: 1, g: 0.5019608, b: 0, a: 1}"},
                       {"_EmissiveColor", "{r: 0, g: 2, b: 4, a: 1}"},
                       {"_Color", "{r: 1, g: 0, b: 0, a: 1}"}};
    material.queue = "2475";
    const Imported made = import_in(folder, material);
    EXPECT_EQ(graph_of(made), kPainted);
    EXPECT_FALSE(made.has_refused);
    EXPECT_TRUE(has(remarks(made, Remark::Kind::Changed), "shader 'HDRP/Lit'"));
    EXPECT_TRUE(has(remarks(made, Remark::Kind::Taken), "properties _StencilRef, _Color: not read by this shader\n"))
        << remarks(made, Remark::Kind::Taken);
    expect_compiles(made, "painted");
}

// Without a mask map, the numbers count, and the remapping does not.
TEST(UnityHighDefinition, NumbersCountWithoutAMask) {
    const Imported made =
        import(with({}, {{"_Metallic", "0.5"}, {"_Smoothness", "0.25"}, {"_SmoothnessRemapMin", "0.5"}}));
    EXPECT_TRUE(has(graph_of(made), R"("metallic": "$_Metallic", "smoothness": "$_Smoothness")")) << graph_of(made);
    EXPECT_FALSE(has(graph_of(made), "Remap"));
    expect_compiles(made, "numbers");
}

// Before the pipeline remapped metal, its number was a factor.
TEST(UnityHighDefinition, MetalOfOldMaterialsIsAFactor) {
    const MaterialFolder folder;
    folder.save("picture.png", "", kPicture);
    MaterialText material = with({"_MASKMAP"}, {{"_Metallic", "0.5"}, {"_AORemapMin", "0.5"}});
    material.textures = {{"_MaskMap", kPicture}};
    const std::string old = graph_of(import_in(folder, material));
    EXPECT_TRUE(has(old, R"("metallic": "= mask.r * $_Metallic")")) << old;
    EXPECT_TRUE(has(old, R"x("occlusion": "= lerp($_AORemapMin, $_AORemapMax, mask.g)")x")) << old;
    material.numbers.push_back({"_MetallicRemapMin", "0.25"});
    material.numbers.push_back({"_MetallicRemapMax", "1"});
    const Imported made = import_in(folder, material);
    EXPECT_TRUE(has(graph_of(made), R"x("metallic": "= lerp($_MetallicRemapMin, $_MetallicRemapMax, mask.r)")x"))
        << graph_of(made);
    expect_compiles(made, "remapped");
}

TEST(UnityHighDefinition, ASpecularColorIsTheOtherWorkflow) {
    MaterialText material = with({"_MATERIAL_FEATURE_SPECULAR_COLOR"}, {{"_MaterialID", "4"}});
    material.colors = {{"_SpecularColor", "{r: 0.5, g: 0.25, b: 0, a: 1}"}};
    const Imported made = import(material);
    for (const char* part : {R"("workflow": "specular-glossiness")", R"("specular": "$_SpecularColor.rgb")",
                             R"("glossiness": "$_Smoothness")"})
        EXPECT_TRUE(has(graph_of(made), part)) << part << "\n" << graph_of(made);
    expect_compiles(made, "specular");
}

TEST(UnityHighDefinition, TheBlendModeIsTheKindOfTheSurface) {
    struct Case {
        const char *mode, *preserve, *kind;
        bool is_exact;
    };
    for (const Case& each : {Case{"0", "1", "transparent", true}, Case{"0", "0", "fade", true},
                             Case{"1", "1", "additive", false}, Case{"4", "1", "transparent", false}}) {
        MaterialText material =
            with({"_SURFACE_TYPE_TRANSPARENT"}, {{"_SurfaceType", "1"},
                                                 {"_BlendMode", each.mode},
                                                 {"_EnableBlendModePreserveSpecularLighting", each.preserve},
                                                 {"_SrcBlend", "1"},
                                                 {"_DstBlend", "10"},
                                                 {"_ZWrite", "0"}});
        material.colors = {{"_BaseColor", "{r: 1, g: 1, b: 1, a: 0.5}"}};
        material.queue = "3000";
        const Imported made = import(material);
        EXPECT_TRUE(has(graph_of(made), fmt::format(R"("surface": "{}" }})", each.kind))) << graph_of(made);
        EXPECT_EQ(has(remarks(made, Remark::Kind::Changed), "_BlendMode"), !each.is_exact) << each.mode;
        expect_compiles(made, each.kind);
    }
}

// What a graph does not have is told, and the graph is made without it.
TEST(UnityHighDefinition, FeaturesThatAGraphLacksAreTold) {
    struct Case {
        const char *keyword, *text;
    };
    for (const Case& each : {Case{"_MATERIAL_FEATURE_CLEAR_COAT", "the surface has no coat"},
                             Case{"_MATERIAL_FEATURE_ANISOTROPY", "highlights have the same width"},
                             Case{"_MATERIAL_FEATURE_IRIDESCENCE", "highlights have no colours of a thin film"},
                             Case{"_MATERIAL_FEATURE_SUBSURFACE_SCATTERING", "light does not go below the surface"},
                             Case{"_DETAIL_MAP", "the detail map is left out"},
                             Case{"_MAPPING_TRIPLANAR", "not projected from three sides"}}) {
        const Imported made = import(with({each.keyword}, {{"_CoatMask", "1"}}));
        const std::string changed = remarks(made, Remark::Kind::Changed);
        EXPECT_TRUE(has(changed, fmt::format("keyword '{}': ", each.keyword))) << changed;
        EXPECT_TRUE(has(changed, each.text)) << changed;
        expect_compiles(made, each.keyword);
    }
}

// Light is linear; the base colour tints it if the material says so.
TEST(UnityHighDefinition, EmissionIsLinear) {
    MaterialText material = with({}, {{"_AlbedoAffectEmissive", "1"}, {"_UseEmissiveIntensity", "1"}});
    material.colors = {{"_BaseColor", "{r: 1, g: 0, b: 0, a: 1}"}, {"_EmissiveColor", "{r: 8, g: 0.5, b: 0, a: 1}"}};
    const Imported made = import(material);
    EXPECT_TRUE(has(graph_of(made), R"("default": [8, 0.5, 0])")) << graph_of(made);
    EXPECT_TRUE(has(graph_of(made), R"("emission": "= $_EmissiveColor.rgb * $_BaseColor.rgb")")) << graph_of(made);
    EXPECT_TRUE(has(remarks(made, Remark::Kind::Taken), "property '_UseEmissiveIntensity': it concerns the inspector"));
    EXPECT_TRUE(
        has(remarks(made, Remark::Kind::Changed), "'_EmissiveColor': it is not multiplied by the camera's exposure"));
    expect_compiles(made, "emission");
}

// A shader of one's own for this pipeline has its names.
TEST(UnityHighDefinition, AShaderWithItsPropertiesIsReadAsIt) {
    const MaterialFolder folder;
    folder.save("picture.png", "", kPicture);
    MaterialText material{.shader = "{fileID: 4800000, guid: 3123456789abcdef0123456789abcdef, type: 3}"};
    material.textures = {{"_MaskMap", kPicture}, {"_NormalMap", kPicture}};
    const Imported made = import_in(folder, material);
    EXPECT_TRUE(has(remarks(made, Remark::Kind::Changed), "the properties are read as those of 'HDRP/Lit'"));
    for (const char* part : {R"("smoothness": "mask.a")", R"("normalTS": "bumps")"})
        EXPECT_TRUE(has(graph_of(made), part)) << part << "\n" << graph_of(made);
    expect_compiles(made, "guessed");
}

}  // namespace
}  // namespace patina::importers
