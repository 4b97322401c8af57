// Names in a ShaderLab file: those of properties are kept or refused, the others keep out of Unity's way.
#include "unity/compiled.h"

namespace patina::unity {
namespace {

// Names that Unity's includes have are not declared a second time.
TEST(UnityNames, KeepOutOfTheWayOfTheIncludes) {
    const std::string text = shader(material(R"("properties": [ { "name": "_Wear", "type": "float", "default": 1 } ],
      "nodes": [ { "id": "shadow", "expr": "$_Wear * 0.5" }, { "id": "SPOT", "expr": "shadow * shadow + shadow" } ],
      "surface": { "metallic": "SPOT", "smoothness": "= SPOT * SPOT" })"));
    EXPECT_FALSE(has(text, "float SPOT ")) << text;
    EXPECT_FALSE(has(text, "float shadow ")) << text;
    EXPECT_FALSE(has(text, "DisneyDiffuse2(")) << text;
    EXPECT_TRUE(has(text, "DisneyDiffuseTerm(")) << text;
}

// Whatever a name belongs to: nodes, functions, members and values between the stages.
TEST(UnityNames, OfEveryKindKeepOutOfTheWay) {
    const std::string text = shader(material(R"j("properties": [ { "name": "_Wear", "type": "float", "default": 1 } ],
      "nodes": [ { "id": "UNITY_PI", "expr": "sin($_Wear) + 1" },
        { "id": "UnityObjectToWorldDir", "expr": "UNITY_PI * UNITY_PI + UNITY_PI", "stage": "vertex" },
        { "id": "GGXTerm", "expr": "@positionOS.x * $_Wear", "stage": "vertex" } ],
      "surface": { "metallic": "= saturate(UNITY_PI * UnityObjectToWorldDir)", "smoothness": "= GGXTerm * GGXTerm" })j"));
    for (const char* name : {"UNITY_PI", "UnityObjectToWorldDir", "GGXTerm"}) {
        EXPECT_FALSE(has(text, std::string("float ") + name + " ")) << name << text;
        EXPECT_FALSE(has(text, std::string("float ") + name + ";")) << name << text;
        EXPECT_FALSE(has(text, std::string("o.") + name + " =")) << name << text;
        EXPECT_FALSE(has(text, std::string("i.") + name + " ")) << name << text;
    }
}

// Members of the compiler's own structs: what a lighting graph adds to the surface, and outputs of sub-graphs. Many of
// Unity's names are macros, which replace members, too.
TEST(UnityNames, OfMembersKeepOutOfTheWay) {
    for (const std::string name :
         {"ProjectColor", "LinearColor", "BufferReadsProbes", "StoredLight", "SAMPLE_TEX2D_LOD",
          "SAMPLE_TEX2D_SAMPLER_BIAS", "fixed2", "fixed4x4", "sampler2D_half", "sampler3D_float", "samplerCUBE_float",
          "unity_Color", "UNITY_PI", "SPOT"}) {
        const std::string text = shader(
            R"j({ "patina": 1, "workflow": "metallic-smoothness", "properties": [ { "name": "_Wear", "type": "float" } ],
      "lighting": { "surface": [ { "name": ")j" +
            name + R"j(", "type": "float", "default": 0.4 } ],
        "direct": "= @surface.diffuseColor * @surface.)j" +
            name + R"j( * @light.radiance" },
      "surface": { ")j" +
            name + R"j(": "= sin($_Wear * @positionWS.x)" } })j");
        EXPECT_TRUE(has(text, "struct LightingSurface")) << text;
        EXPECT_FALSE(has(text, "float " + name + ";")) << name << "\n" << text;
        EXPECT_FALSE(has(text, "." + name + ";") || has(text, "." + name + " ")) << name << "\n" << text;
    }
}

// A property's name is what materials keep its value under: it is refused, not changed.
TEST(UnityNames, OfPropertiesAreNotUnitysOwn) {
    for (const std::string name : {"_Time",
                                   "_LightColor0",
                                   "unity_Wetness",
                                   "_CameraDepthTexture",
                                   "Luminance",
                                   "SPOT",
                                   "_ShadowMapTexture",
                                   "_ZBufferParams",
                                   "UNITY_PI",
                                   "UnityGI",
                                   "UnityLight",
                                   "UnityObjectToClipPos",
                                   "Unity_SafeNormalize",
                                   "KelemenVisibilityTerm",
                                   "ModifiedKelemenVisibilityTerm",
                                   "CookTorranceVisibilityTerm",
                                   "ODSOffset",
                                   "ImplicitVisibilityTerm",
                                   "LazarovFresnelTerm",
                                   "SebLagardeFresnelTerm",
                                   "RDFBlinnPhongNormalizedTerm",
                                   "DecodeHDR_NoLinearSupportInSM2",
                                   "unitySampleShadow",
                                   "unityShadowCoord4x4",
                                   "Texture2DMS_half",
                                   "sampler1D_float",
                                   "SAMPLER_UNIFORM",
                                   "SHADOWS_CUBE_IN_DEPTH_TEX"}) {
        const Result result = of_text(material(R"("properties": [ { "name": ")" + name +
                                               R"(", "type": "float", "default": 1 } ],
      "surface": { "metallic": "$)" + name + R"(" })"));
        EXPECT_FALSE(result.ok) << name;
        EXPECT_EQ(first_error(result).code, "taken-name") << name;
        EXPECT_EQ(first_error(result).line, 1) << name;
        EXPECT_TRUE(has(first_error(result).message, "'" + name + "' is a name that one of Unity's includes declares"))
            << first_error(result).message;
        EXPECT_TRUE(result.shaders.empty()) << name;
    }
    const Result keyword = of_text(material(
        R"("properties": [ { "name": "Fog", "type": "enum", "values": ["Off", "Linear"], "as": "variant" } ],
      "surface": { "metallic": "= $Fog == 1 ? 1 : 0" })"));
    EXPECT_EQ(first_error(keyword).code, "taken-name") << to_text(first_error(keyword));
    EXPECT_TRUE(has(first_error(keyword).message, "the keyword 'FOG_LINEAR' of the value 'Linear' of 'Fog' is a name"))
        << first_error(keyword).message;
}

// ... nor the file's own, nor a word of the language: there is no other name that Unity would know the property by.
TEST(UnityNames, OfPropertiesAreNotTheFilesOwnOrWords) {
    const std::vector<std::pair<std::string, std::string>> kNames = {{"i", "the file itself"},
                                                                     {"o", "the file itself"},
                                                                     {"v", "the file itself"},
                                                                     {"vert", "the file itself"},
                                                                     {"frag", "the file itself"},
                                                                     {"v2f", "the file itself"},
                                                                     {"WhiteLight", "the file itself"},
                                                                     {"LinearColor", "the file itself"},
                                                                     {"Instances", "the file itself"},
                                                                     {"half", "a reserved word of HLSL"},
                                                                     {"texture", "a reserved word of HLSL"},
                                                                     {"input", "a reserved word of HLSL"},
                                                                     {"point", "a reserved word of HLSL"},
                                                                     {"pass", "a reserved word of HLSL"},
                                                                     {"lit", "a reserved word of HLSL"},
                                                                     {"main", "a reserved word of HLSL"},
                                                                     {"float3", "a reserved word of HLSL"},
                                                                     {"register", "a reserved word of HLSL"},
                                                                     {"a__b", "GLSL reserves"},
                                                                     {"gl_Tint", "GLSL reserves"}};
    for (const auto& [name, why] : kNames) {
        const Result result = of_text(material(R"("properties": [ { "name": ")" + name +
                                               R"(", "type": "float", "default": 1 } ],
      "surface": { "metallic": "$)" + name + R"(" })"));
        EXPECT_EQ(first_error(result).code, "taken-name") << name;
        EXPECT_EQ(first_error(result).column, 105) << name;
        EXPECT_TRUE(has(first_error(result).message, "'" + name + "' is ")) << first_error(result).message;
        EXPECT_TRUE(has(first_error(result).message, why)) << first_error(result).message;
        EXPECT_TRUE(result.shaders.empty()) << name;
    }
}

// Types of Direct3D 9 and 11, and what HLSLSupport.cginc calls them.
TEST(UnityNames, OfTypesAreNotThoseOfPropertiesOrValues) {
    const std::vector<std::string> kNames = {
        "samplerCUBE",      "sampler1D",        "sampler_state",  "textureCUBE",     "asm_fragment",
        "RWTexture2DArray", "texCUBEproj",      "tex3Dgrad",      "float1x4",        "half3x2",
        "double2x3",        "min16float3",      "uint4x4",        "int64_t2",        "dword2",
        "bool1x1",          "sampler2D_float",  "sampler2D_half", "sampler3D_float", "samplerCUBE_float",
        "samplerCUBE_half", "TextureCube_half", "fixed",          "fixed3",          "fixed4x4",
        "CBUFFER_START",    "INTERNAL_DATA"};
    for (const std::string& name : kNames) {
        const Result result = of_text(material(R"("properties": [ { "name": ")" + name +
                                               R"(", "type": "float", "default": 1 } ],
      "surface": { "metallic": "$)" + name + R"(" })"));
        EXPECT_EQ(first_error(result).code, "taken-name") << name;
        const std::string text = shader(material(R"("properties": [ { "name": "_Wear", "type": "float" } ],
      "nodes": [ { "id": ")" + name + R"(", "expr": "$_Wear * 0.3" } ],
      "surface": { "metallic": ")" + name + R"(", "smoothness": "= )" +
                                                 name + " * " + name + "\" }"));
        EXPECT_FALSE(has(text, "float " + name + " =")) << name << "\n" << text;
        EXPECT_TRUE(has(text, " = _Wear * 0.3;")) << name << "\n" << text;
    }
    for (const std::string name : {"half5", "float4x5", "half0", "x3", "sampler4D", "fixed5"}) {
        const std::string text =
            shader(material(R"("properties": [ { "name": ")" + name +
                            R"(", "type": "float" } ], "surface": { "metallic": "$)" + name + R"(" })"));
        EXPECT_TRUE(has(text, "float " + name + ";")) << name;
    }
}

// Unity fills these itself; a keyword that is on is a macro.
TEST(UnityNames, OfPropertiesAreNotThoseOfOthers) {
    for (const std::string name : {"_MainTex_ST", "_MainTex_TexelSize", "_MainTex_HDR", "sampler_MainTex"}) {
        const Result result = of_text(material(
            R"("properties": [ { "name": "_MainTex", "type": "texture2d", "tiling": true }, { "name": ")" + name +
            R"(", "type": "float", "default": 1 } ],
      "nodes": [ { "id": "albedo", "node": "SampleTexture2D", "in": { "texture": "$_MainTex" } } ],
      "surface": { "baseColor": "albedo.rgb", "metallic": "$)" +
            name + R"(" })"));
        EXPECT_EQ(first_error(result).code, "taken-name") << name;
        EXPECT_TRUE(has(first_error(result).message, "the texture '_MainTex'")) << first_error(result).message;
    }
}

// Two keywords of one name would be one choice.
TEST(UnityNames, OfKeywordsAreOneChoiceEach) {
    struct Case {
        std::string other, rest, message;
    };
    const Case kCases[] = {
        {"_MODE_WET", R"("type": "float")", "'_MODE_WET' is the keyword of the value 'Wet' of '_Mode'"},
        {"_MODE_WET", R"("type": "bool", "as": "variant")",
         "the keyword '_MODE_WET' of '_MODE_WET' is also that of the value 'Wet' of '_Mode'"},
        {"_MODE", R"("type": "enum", "values": ["Wet"], "as": "variant")",
         "the keyword '_MODE_WET' of the value 'Wet' of '_MODE' is also that of the value 'Wet' of '_Mode'"}};
    for (const auto& [other, rest, message] : kCases) {
        const Result result = of_text(material(
            R"("properties": [ { "name": "_Mode", "type": "enum", "values": ["Dry", "Wet"], "as": "variant" }, { "name": ")" +
            other + "\", " + rest + R"( } ], "surface": { "metallic": "= $_Mode == Dry ? float($)" + other +
            R"() : 1" })"));
        EXPECT_EQ(first_error(result).code, "taken-name") << to_text(first_error(result));
        EXPECT_TRUE(has(first_error(result).message, message)) << first_error(result).message;
        ASSERT_EQ(first_error(result).notes.size(), 1u);
        EXPECT_TRUE(has(first_error(result).notes[0].message, "here"));
    }
    const Result alike = of_text(material(
        R"("properties": [ { "name": "_V", "type": "enum", "values": ["X", "x", "Y"], "as": "variant" } ],
      "surface": { "metallic": "= $_V == 1 ? 1 : 0" })"));
    EXPECT_EQ(first_error(alike).code, "taken-name");
    EXPECT_TRUE(
        has(first_error(alike).message, "the keyword '_V_X' of the value 'x' of '_V' is also that of its value 'X'"))
        << first_error(alike).message;
    EXPECT_TRUE(has(first_error(alike).source_line.substr(std::size_t(first_error(alike).column) - 1, 2), "x"))
        << first_error(alike).column;
}

// What only the engine of the other targets has is free here.
TEST(UnityNames, OfPropertiesAreKept) {
    const std::string text = shader(material(R"("properties": [ { "name": "lightCount", "type": "float", "default": 1 },
        { "name": "Material", "type": "float", "default": 1 }, { "name": "Surface", "type": "float", "default": 1 },
        { "name": "albedo", "type": "float", "default": 1 }, { "name": "DotClamped_", "type": "float", "default": 1 } ],
      "nodes": [ { "id": "albedo", "expr": "$albedo * $Surface" } ],
      "surface": { "metallic": "= albedo * $lightCount * $Material", "smoothness": "= albedo * $DotClamped_" })"));
    for (const std::string name : {"lightCount", "Material", "Surface", "albedo", "DotClamped_"}) {
        EXPECT_TRUE(has(text, " " + name + " (\"")) << name;
        EXPECT_TRUE(has(text, "float " + name + ";\n")) << name;
    }
}

// What an entry function takes is its own: another function may have a parameter of that name.
TEST(UnityNames, OfParametersAreFreeInOtherFunctions) {
    const std::string text = shader(material(R"("surface": { "normalOS": "@normalOS" }, "render": { "cull": "off" })"));
    EXPECT_TRUE(has(text, "half4 frag(v2f i, bool frontFacing : SV_IsFrontFace)")) << text;
    EXPECT_TRUE(has(text, "LightingSurface lightingSurface(float3 normalOS, bool frontFacing)")) << text;
}

// One that an include declares for materials is read from there.
TEST(UnityNames, OfMaterialsInTheIncludesAreNotDeclaredAgain) {
    const std::string properties =
        R"("properties": [ { "name": "_SpecColor", "type": "color", "default": [0.2, 0.2, 0.2] } ])";
    for (const std::string& text :
         {shader(R"({ "patina": 1, "workflow": "specular-glossiness", "lighting": "unity-brdf1", )" + properties +
                 R"(, "surface": { "specular": "$_SpecColor.rgb" } })"),
          shader(R"({ "patina": 1, "workflow": "unlit", )" + properties +
                 R"(, "surface": { "color": "$_SpecColor.rgb" } })")}) {
        EXPECT_TRUE(has(text, "_SpecColor (\"Spec Color\", Color) = ")) << text;
        EXPECT_TRUE(has(text, "LinearColor(_SpecColor)")) << text;
        EXPECT_FALSE(has(text, "half4 _SpecColor")) << text;
        EXPECT_TRUE(has(text, "#include \"UnityPBSLighting.cginc\"")) << text;
    }
    const Result number = of_text(material(R"("properties": [ { "name": "_SpecColor", "type": "float", "default": 1 } ],
      "surface": { "metallic": "$_SpecColor" })"));
    EXPECT_EQ(first_error(number).code, "taken-name");
}

}  // namespace
}  // namespace patina::unity
