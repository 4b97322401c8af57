// Each extension of glTF's materials alone in a small file: the graph says what the specification says, reads as a
// person would have written it, and compiles without a word.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/importers/importer.h"
#include "patina/patina.h"
#include "tests/unit/importers/gltf/gltf_writer.h"

namespace patina::importers {
namespace {

Imported import(const std::string& path, const Options& options = {}) {
    const Source source{.path = path, .start = {}};
    const Importer* importer = importer_of(source);
    return importer ? read_verified(*importer, source, options) : Imported{.error = "there is no importer"};
}

const Compiler& compiler() {
    static const Compiler made;
    return made;
}

// The text of the key's value without line breaks and indentation; empty if the file does not have the key.
std::string part_of(const std::string& text, const std::string& key) {
    const std::size_t at = text.find("\n  \"" + key + "\": ");
    if (at == text.npos) return {};
    const std::size_t begin = at + key.size() + 7;
    int depth = 0;
    bool is_quoted = false;
    std::string made;
    for (std::size_t i = begin; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') is_quoted = !is_quoted;
        if (!is_quoted && (c == '{' || c == '[')) ++depth;
        if (!is_quoted && (c == '}' || c == ']')) --depth;
        if (depth < 0 || (depth == 0 && c == ',')) break;
        if (c == '\n') {
            while (i + 1 < text.size() && text[i + 1] == ' ') ++i;
            if (!made.empty() && made.back() != ' ' && depth > 0 && text[i + 1] != '}' && text[i + 1] != ']' &&
                made.back() != '{' && made.back() != '[')
                made += ' ';
            continue;
        }
        made += c;
    }
    // One line or several: the same.
    for (const auto& [from, to] : {std::pair("{ ", "{"), {" }", "}"}, {"[ ", "["}, {" ]", "]"}}) {
        for (std::size_t k = made.find(from); k != made.npos; k = made.find(from)) made.replace(k, 2, to);
    }
    return made;
}

std::vector<std::string> names_of(const std::string& graph) {
    std::vector<std::string> names;
    for (std::size_t at = graph.find("\"name\": \"_"); at != graph.npos; at = graph.find("\"name\": \"_", at + 1)) {
        const std::size_t begin = at + 9;
        names.push_back(graph.substr(begin, graph.find('"', begin) - begin));
    }
    return names;
}

// The only graph of a file with this material; it must be in canonical form, and compile without a warning.
std::string graph_of(const Square& square) {
    const Imported made = import(save_gltf(square));
    EXPECT_EQ(made.error, "");
    if (made.graphs.size() != 2) {
        ADD_FAILURE() << made.graphs.size() << " files, not a graph and a scene";
        return {};
    }
    const std::string& text = made.graphs[0].text;
    EXPECT_EQ(compiler().format("graph", text).text, text) << "patina fmt changes it";
    CompileOptions options;
    options.files.read = [&](const std::string& path) -> std::optional<std::string> {
        const auto is_it = [&](const BinaryFile& file) { return file.name == path; };
        return std::any_of(made.copies.begin(), made.copies.end(), is_it) ? std::optional("") : std::nullopt;
    };
    const Result compiled = compiler().compile_text(made.graphs[0].name, text, options);
    for (const Diagnostic& each : compiled.diagnostics) ADD_FAILURE() << to_text(each) << "\n" << text;
    EXPECT_TRUE(compiled.ok);
    return text;
}

std::string extended(const std::string& name, const std::string& members, const std::string& core = "") {
    return R"([{"name":"Paint",)" + core +
           R"("pbrMetallicRoughness":{"metallicFactor":0.5},"extensions":{"KHR_materials_)" + name + "\":{" + members +
           "}}}]";
}

const std::string kTexture = R"("textures":[{"source":0}],"images":[)" +
                             picture_of(png_of(1, 1, {255, 128, 0, 255}), R"(,"name":"a picture")") + "]";

struct Case {
    std::string what, materials, surface;
    std::vector<std::string> properties{};
};

TEST(GltfMaterial, WithoutAWordItIsTheSpecificationsDefault) {
    const std::string text = graph_of({.materials = R"([{}])"});
    EXPECT_EQ(part_of(text, "surface"), R"({"baseColor": [1, 1, 1], "metallic": 1, "roughness": 1})");
    EXPECT_EQ(part_of(text, "properties"), "");
    EXPECT_EQ(part_of(text, "nodes"), "");
    EXPECT_EQ(part_of(text, "render"), "");
    EXPECT_EQ(part_of(text, "lighting"), "\"gltf\"");
}

TEST(GltfMaterial, OnlyWhatALayerUsesIsInItsGraph) {
    const std::string core = R"("baseColor": [1, 1, 1], "metallic": "$_Metallic", "roughness": 1)";
    const std::vector<Case> cases = {
        {"clearcoat",
         extended("clearcoat", R"("clearcoatFactor":0.8,"clearcoatRoughnessFactor":0.1)"),
         R"(, "clearcoat": "$_Clearcoat", "clearcoatRoughness": "$_ClearcoatRoughness")",
         {"_Clearcoat", "_ClearcoatRoughness"}},
        {"clearcoat that is off", extended("clearcoat", R"("clearcoatRoughnessFactor":0.1)"), "", {}},
        {"sheen",
         extended("sheen", R"("sheenColorFactor":[1,0.5,0.25],"sheenRoughnessFactor":0.3)"),
         R"(, "sheenColor": "$_SheenColor.rgb", "sheenRoughness": "$_SheenRoughness")",
         {"_SheenColor", "_SheenRoughness"}},
        {"sheen that is off", extended("sheen", R"("sheenRoughnessFactor":0.3)"), "", {}},
        {"specular",
         extended("specular", R"("specularFactor":0.5,"specularColorFactor":[2,1,1])"),
         R"(, "specularFactor": "$_Specular", "specularColor": "$_SpecularColor.rgb")",
         {"_Specular", "_SpecularColor"}},
        {"ior", extended("ior", R"("ior":1.8)"), R"(, "ior": "$_Ior")", {"_Ior"}},
        {"ior of 1.5", extended("ior", R"("ior":1.5)"), "", {}},
        {"anisotropy",
         extended("anisotropy", R"("anisotropyStrength":0.6,"anisotropyRotation":1.5)"),
         R"x(, "anisotropy": "$_Anisotropy", "anisotropyDirection": "= float2(cos($_AnisotropyRotation), sin($_AnisotropyRotation))")x",
         {"_Anisotropy", "_AnisotropyRotation"}},
        {"iridescence",
         extended("iridescence", R"("iridescenceFactor":1,"iridescenceIor":1.6)"),
         R"(, "iridescence": "$_Iridescence", "iridescenceIor": "$_IridescenceIor")",
         {"_Iridescence", "_IridescenceIor"}},
        {"transmission",
         extended("transmission", R"("transmissionFactor":0.9)"),
         R"(, "transmission": "$_Transmission")",
         {"_Transmission"}},
        {"volume without transmission", extended("volume", R"("thicknessFactor":0.9)"), "", {}},
        {"diffuse transmission",
         extended("diffuse_transmission",
                  R"("diffuseTransmissionFactor":0.4,"diffuseTransmissionColorFactor":[1,0.5,0])"),
         R"(, "diffuseTransmission": "$_DiffuseTransmission", "diffuseTransmissionColor": "$_DiffuseTransmissionColor.rgb")",
         {"_DiffuseTransmission", "_DiffuseTransmissionColor"}},
        {"dispersion without transmission", extended("dispersion", R"("dispersion":0.5)"), "", {}},
        {"emissive strength",
         extended("emissive_strength", R"("emissiveStrength":4)", R"("emissiveFactor":[1,0.5,0],)"),
         R"(, "emission": "$_Emission.rgb", "emissiveStrength": "$_EmissiveStrength")",
         {"_Emission", "_EmissiveStrength"}},
        {"emissive strength of black", extended("emissive_strength", R"("emissiveStrength":4)"), "", {}},
    };
    for (const Case& each : cases) {
        const std::string text = graph_of({.materials = each.materials});
        EXPECT_EQ(part_of(text, "surface"), "{" + core + each.surface + "}") << each.what;
        std::vector<std::string> properties = {"_Metallic"};
        properties.insert(properties.end(), each.properties.begin(), each.properties.end());
        EXPECT_EQ(names_of(text), properties) << each.what;
    }
}

TEST(GltfMaterial, TexturesHaveTheChannelsOfTheSpecification) {
    const std::string t = R"({"index":0})";
    const std::vector<Case> cases = {
        {"baseColor", R"([{"pbrMetallicRoughness":{"baseColorTexture":)" + t + "}}]",
         R"("baseColor": "baseColor.rgb")"},
        {"metallic", R"([{"pbrMetallicRoughness":{"metallicRoughnessTexture":)" + t + "}}]",
         R"("metallic": "metallicRoughness.b", "roughness": "metallicRoughness.g")"},
        {"occlusion", R"([{"occlusionTexture":{"index":0,"strength":0.5}}])",
         R"x("occlusion": "= lerp(1, occlusion.r, $_OcclusionStrength)")x"},
        {"emission", R"([{"emissiveTexture":{"index":0},"emissiveFactor":[1,1,1]}])", R"("emission": "emissive.rgb")"},
        {"clearcoat",
         extended(
             "clearcoat",
             R"("clearcoatFactor":1,"clearcoatTexture":{"index":0},"clearcoatRoughnessTexture":{"index":0},"clearcoatRoughnessFactor":1)"),
         R"("clearcoat": "clearcoat.r", "clearcoatRoughness": "clearcoat.g")"},
        {"sheen",
         extended(
             "sheen",
             R"("sheenColorFactor":[1,1,1],"sheenColorTexture":{"index":0},"sheenRoughnessFactor":1,"sheenRoughnessTexture":{"index":0})"),
         R"("sheenColor": "sheenColor.rgb", "sheenRoughness": "sheenRoughness.a")"},
        {"specular", extended("specular", R"("specularTexture":{"index":0},"specularColorTexture":{"index":0})"),
         R"("specularFactor": "specular.a", "specularColor": "specularColor.rgb")"},
        {"anisotropy", extended("anisotropy", R"("anisotropyStrength":1,"anisotropyTexture":{"index":0})"),
         R"("anisotropy": "anisotropy.b", "anisotropyDirection": "= anisotropy.rg * 2 - 1")"},
        {"iridescence",
         extended(
             "iridescence",
             R"("iridescenceFactor":1,"iridescenceTexture":{"index":0},"iridescenceThicknessTexture":{"index":0})"),
         R"x("iridescence": "iridescence.r", "iridescenceThickness": "= lerp($_IridescenceThicknessMinimum, $_IridescenceThicknessMaximum, iridescence.g)")x"},
        {"transmission", extended("transmission", R"("transmissionFactor":1,"transmissionTexture":{"index":0})"),
         R"("transmission": "transmission.r")"},
        {"diffuse transmission",
         extended(
             "diffuse_transmission",
             R"("diffuseTransmissionFactor":1,"diffuseTransmissionTexture":{"index":0},"diffuseTransmissionColorTexture":{"index":0})"),
         R"("diffuseTransmission": "diffuseTransmission.a", "diffuseTransmissionColor": "diffuseTransmissionColor.rgb")"},
    };
    for (const Case& each : cases) {
        const std::string surface = part_of(graph_of({.materials = each.materials, .textures = kTexture}), "surface");
        EXPECT_NE(surface.find(each.surface), surface.npos) << each.what << ": " << surface;
    }
}

// A texture is multiplied by its factor, so beside a factor of 0 no texture is read, and the report says so.
TEST(GltfMaterial, AFactorOfZeroNeedsNoTexture) {
    const std::string sheen = R"([{"pbrMetallicRoughness":{"metallicFactor":0,"metallicRoughnessTexture":{"index":0}},
        "extensions":{"KHR_materials_sheen":{"sheenColorFactor":[1,1,1],"sheenRoughnessTexture":{"index":0}}}}])";
    const Square square{.materials = sheen, .textures = kTexture};
    const std::string surface = part_of(graph_of(square), "surface");
    EXPECT_EQ(surface.find("sheenRoughness"), surface.npos) << surface;
    EXPECT_NE(surface.find(R"("metallic": 0, "roughness": "packed.g")"), surface.npos) << surface;
    const Imported made = import(save_gltf(square));
    const auto told = [&](const std::string& part, const std::string& what) {
        return std::count_if(made.remarks.begin(), made.remarks.end(), [&](const Remark& remark) {
            return remark.part == "materials[0]." + part && remark.text.find(what) != std::string::npos;
        });
    };
    EXPECT_EQ(told("extensions.KHR_materials_sheen.sheenRoughnessTexture.index", "'sheenRoughnessFactor' is 0"), 1);
    EXPECT_EQ(told("pbrMetallicRoughness.metallicRoughnessTexture.index", "read by the node"), 1);
}

// A node is named by all that its texture holds.
TEST(GltfMaterial, APackedTextureIsNamedByWhatItHolds) {
    const auto surface = [](const std::string& more, const std::string& extensions) {
        return part_of(graph_of({.materials = R"([{"occlusionTexture":{"index":0})" + more + R"(,"extensions":{)" +
                                              extensions + "}}]",
                                 .textures = kTexture}),
                       "surface");
    };
    const std::string anisotropy =
        R"("KHR_materials_anisotropy":{"anisotropyStrength":1,"anisotropyTexture":{"index":0}})";
    const std::string two = surface("", anisotropy);
    EXPECT_NE(two.find(R"("occlusion": "anisotropyOcclusion.r")"), two.npos) << two;
    EXPECT_NE(two.find(R"("anisotropyDirection": "= anisotropyOcclusion.rg * 2 - 1")"), two.npos) << two;
    const std::string three =
        surface(R"(,"pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0}})", anisotropy);
    EXPECT_NE(three.find(R"("roughness": "packed.g")"), three.npos) << three;
    EXPECT_NE(three.find(R"("occlusion": "packed.r")"), three.npos) << three;
}

// One picture that is read at two places: each place has a node of its own, and names stay unique.
TEST(GltfMaterial, ATextureIsReadAtTwoPlaces) {
    const std::string here = R"({"index":0})", there = R"({"index":0,"texCoord":1})";
    const std::string clearcoat = R"("KHR_materials_clearcoat":{"clearcoatFactor":1,"clearcoatRoughnessFactor":1,)"
                                  R"("clearcoatTexture":)" +
                                  here + R"(,"clearcoatRoughnessTexture":)" + there + "}";
    const std::string iridescence = R"("KHR_materials_iridescence":{"iridescenceFactor":1,"iridescenceTexture":)" +
                                    here + R"(,"iridescenceThicknessTexture":)" + there + "}";
    const std::string transmission = R"("KHR_materials_transmission":{"transmissionFactor":1,"transmissionTexture":)" +
                                     there + R"(},"KHR_materials_volume":{"thicknessFactor":1,"thicknessTexture":)" +
                                     here + "}";
    const std::string core =
        R"("pbrMetallicRoughness":{"metallicRoughnessTexture":)" + here + R"(},"occlusionTexture":)" + there;
    for (const std::string& layers :
         {clearcoat, iridescence, transmission, clearcoat + "," + iridescence + "," + transmission}) {
        for (const std::string& more : {std::string(), core + ","}) {
            const std::string text =
                graph_of({.materials = "[{" + more + R"("extensions":{)" + layers + "}}]", .textures = kTexture});
            EXPECT_NE(text.find("@uv1"), text.npos) << text;
        }
    }
    const std::string two = part_of(graph_of({.materials = "[{" + core + "}]", .textures = kTexture}), "surface");
    EXPECT_NE(two.find(R"("metallic": "orm.b", "roughness": "orm.g", "occlusion": "occlusion.r")"), two.npos) << two;
}

// The specification's colours are sRGB, all else is data: one picture with both uses is two properties.
TEST(GltfMaterial, ATextureIsDecodedOnlyAsAColor) {
    const std::string text = graph_of(
        {.materials =
             R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":0}},
                           "occlusionTexture":{"index":0},"normalTexture":{"index":0,"scale":0.5}}])",
         .textures = kTexture});
    EXPECT_NE(
        text.find(R"("name": "_BaseColorMap", "type": "texture2d", "usage": "color", "default": "./a_picture.png")"),
        text.npos);
    EXPECT_NE(text.find(R"("name": "_OrmMap", "type": "texture2d", "usage": "data", "default": "./a_picture.png")"),
              text.npos);
    EXPECT_NE(text.find(R"("name": "_NormalMap", "type": "texture2d", "usage": "normal")"), text.npos);
    const std::string surface = part_of(text, "surface");
    EXPECT_NE(
        surface.find(R"("metallic": "orm.b", "roughness": "orm.g", "normalTS": "normalScaled", "occlusion": "orm.r")"),
        surface.npos)
        << surface;
}

TEST(GltfMaterial, AVolumeGrowsWithItsNode) {
    const std::string materials =
        R"([{"pbrMetallicRoughness":{"metallicFactor":0},"extensions":{"KHR_materials_transmission":{"transmissionFactor":1},
             "KHR_materials_dispersion":{"dispersion":0.3},
             "KHR_materials_volume":{"thicknessFactor":0.2,"attenuationDistance":0.4,"attenuationColor":[1,0.5,0]}}}])";
    const auto thickness = [&](const std::string& node) {
        return part_of(graph_of({.materials = materials, .nodes = "[{\"mesh\":0" + node + "}]"}), "surface");
    };
    const std::string plain = thickness("");
    for (const char* part : {R"("thickness": "$_Thickness",)", R"("attenuationDistance": "$_AttenuationDistance",)",
                             R"("attenuationColor": "$_AttenuationColor.rgb",)", R"("dispersion": "$_Dispersion")"})
        EXPECT_NE(plain.find(part), plain.npos) << plain;
    EXPECT_NE(thickness(R"(,"scale":[3,3,3])").find(R"("thickness": "= $_Thickness * @objectScale.x")"), plain.npos);
    EXPECT_NE(thickness(R"(,"scale":[3,1,1])").find("dot(@objectScale, float3(1, 1, 1) / 3)"), plain.npos);
}

TEST(GltfMaterial, AlphaModesAndSidesAreRenderState) {
    const auto render = [](const std::string& members, const std::string& factor = "[1,1,1,0.5]") {
        const std::string text =
            graph_of({.materials = R"([{"pbrMetallicRoughness":{"metallicFactor":0,"baseColorFactor":)" + factor + "}" +
                                   members + "}]"});
        return part_of(text, "render") + part_of(text, "surface");
    };
    const auto has = [](const std::string& text, const std::string& part) { return text.find(part) != text.npos; };
    EXPECT_TRUE(has(render(R"(,"alphaMode":"BLEND")"), R"({"surface": "fade"})"));
    EXPECT_TRUE(has(render(R"(,"alphaMode":"BLEND")"), R"("alpha": "$_BaseColor.a")"));
    EXPECT_FALSE(has(render(R"(,"alphaMode":"BLEND")", "[1,1,1,1]"), "fade"));
    EXPECT_TRUE(has(render(R"(,"alphaMode":"MASK","alphaCutoff":0.3)"), R"({"surface": "cutout"})"));
    EXPECT_TRUE(has(render(R"(,"alphaMode":"MASK","alphaCutoff":0.3)"), R"("alphaClip": "$_AlphaCutoff")"));
    EXPECT_FALSE(has(render(R"(,"alphaCutoff":0.3)"), "alpha"));
    EXPECT_TRUE(has(render(R"(,"doubleSided":true)"), R"({"cull": "off"})"));
}

TEST(GltfMaterial, OtherWorkflows) {
    const std::string unlit = graph_of({.materials = R"([{"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,1]},
                                        "extensions":{"KHR_materials_unlit":{}}}])",
                                        .has_colors = true});
    EXPECT_EQ(part_of(unlit, "workflow"), "\"unlit\"");
    EXPECT_EQ(part_of(unlit, "surface"), R"({"color": "= $_BaseColor.rgb * @vertexColor.rgb"})");
    const std::string gloss = graph_of({.materials = R"([{"extensions":{"KHR_materials_pbrSpecularGlossiness":{
                                        "diffuseFactor":[0.5,0.25,1,1],"specularFactor":[0.1,0.2,0.3],
                                        "glossinessFactor":0.6}}}])"});
    EXPECT_EQ(part_of(gloss, "workflow"), "\"specular-glossiness\"");
    EXPECT_EQ(part_of(gloss, "surface"),
              R"({"baseColor": "$_Diffuse.rgb", "specular": "$_Specular.rgb", "glossiness": "$_Glossiness"})");
}

// The example of the extension's specification: offset (0, 1), rotation pi / 2 and scale 0.5 show the lower left
// quarter of the picture, turned clockwise. So its upper left corner is the quarter's lower left one. The matrix in
// that text turns the other way, and would show another quarter.
TEST(GltfMaterial, ATextureIsTransformedAsTheSpecificationSays) {
    const std::string text =
        graph_of({.materials = R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":1,"extensions":
             {"KHR_texture_transform":{"offset":[0,1],"rotation":1.57079632679,"scale":[0.5,0.5]}}}}}])",
                  .textures = kTexture});
    const std::size_t at = text.find("\"expr\": \"") + 9;
    std::string expression = text.substr(at, text.find('"', at) - at);
    ASSERT_NE(expression.find("@uv1"), expression.npos) << text;
    expression.replace(expression.find("@uv1"), 4, "uv");
    const std::vector<std::pair<std::vector<double>, std::vector<double>>> corners = {
        {{0, 0}, {0, 1}}, {{1, 0}, {0, 0.5}}, {{1, 1}, {0.5, 0.5}}, {{0, 1}, {0.5, 1}}};
    for (const auto& [from, to] : corners) {
        const NamedValue uv{.name = "uv", .values = from};
        const EvalResult moved = compiler().evaluate_expression(expression, {&uv, 1});
        ASSERT_TRUE(moved.ok) << expression;
        EXPECT_NEAR(moved.outputs[0].values[0], to[0], 1e-6);
        EXPECT_NEAR(moved.outputs[0].values[1], to[1], 1e-6);
    }
    const std::string plain =
        graph_of({.materials = R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"extensions":
             {"KHR_texture_transform":{"scale":[2,3],"texCoord":1}}}}}])",
                  .textures = kTexture});
    EXPECT_NE(plain.find(R"("node": "TilingOffset", "in": { "uv": "@uv1", "tiling": [2, 3] })"), plain.npos) << plain;
}

TEST(GltfMaterial, FourSetsOfCoordinatesAreRead) {
    const std::pair<std::string, std::string> sets[] = {{"2", "@uv2"}, {"3", "@uv3"}, {"4", "@uv3"}, {"900", "@uv3"}};
    for (const auto& [set, read] : sets) {
        const std::string text = graph_of(
            {.materials = R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":)" + set + "}}}]",
             .textures = kTexture});
        EXPECT_NE(text.find(R"("uv": ")" + read + "\""), text.npos) << text;
    }
}

TEST(GltfMaterial, SamplersAreThePropertys) {
    const auto sampler = [](const std::string& members) {
        return graph_of({.materials = R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])",
                         .textures = R"("samplers":[{)" + members +
                                     R"(}],"textures":[{"source":0,"sampler":0}],"images":[)" +
                                     picture_of(png_of(1, 1, {0, 0, 0, 255})) + "]"});
    };
    EXPECT_NE(sampler(R"("wrapS":33071,"wrapT":33071)").find(R"("sampler": { "wrap": "clamp" })"), std::string::npos);
    EXPECT_NE(sampler(R"("wrapS":33648,"wrapT":33648,"magFilter":9728)")
                  .find(R"("sampler": { "wrap": "mirror", "filter": "nearest" })"),
              std::string::npos);
    EXPECT_EQ(sampler(R"("wrapS":10497,"magFilter":9729)").find("sampler"), std::string::npos);
}

}  // namespace
}  // namespace patina::importers
