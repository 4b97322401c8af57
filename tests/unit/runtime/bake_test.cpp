// Baked materials: factors and texels against the numbers of their graphs, and pictures of the baked model against
// pictures of the graph, both lit as glTF says.
#include "runtime/bake/bake.h"

#include <gtest/gtest.h>
#include <rapidjson/document.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "compiler/cli/render/model_file.h"
#include "runtime/files/files.h"
#include "runtime/picture/compare.h"
#include "runtime/picture/image.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

// A folder that is gone afterwards.
struct Folder {
    Folder() {
        std::string name = (fs::temp_directory_path() / "patina_bake_XXXXXX").string();
        path = mkdtemp(name.data());
    }
    ~Folder() { fs::remove_all(path); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path / name) << text;
        return (path / name).string();
    }
    fs::path path;
};

struct Baked {
    BakeOutcome outcome;
    rapidjson::Document json;  // of the model

    const rapidjson::Value& material() const { return json["materials"][0]; }
};

// Bakes, and writes the files into the folder.
Baked baked(const Folder& folder, BakeRequest request) {
    const Compiler compiler;
    RenderMachine machine;
    if (request.name.empty()) request.name = "baked";
    Baked made{.outcome = bake(compiler, request, machine), .json = {}};
    EXPECT_TRUE(made.outcome.ok) << made.outcome.error;
    for (const Diagnostic& each : made.outcome.diagnostics) EXPECT_NE(each.severity, Severity::Error) << to_text(each);
    for (const BakedFile& file : made.outcome.files)
        EXPECT_EQ(write_file((folder.path / file.name).string(), file.bytes), "");
    if (!made.outcome.ok) return made;
    const std::string& glb = made.outcome.files.back().bytes;
    std::uint32_t length = 0;
    std::memcpy(&length, glb.data() + 12, sizeof length);
    made.json.Parse(glb.data() + 20, length);
    EXPECT_FALSE(made.json.HasParseError());
    return made;
}

Baked baked_surface(const Folder& folder, const std::string& surface, bool is_specular = false,
                    const std::string& more = "") {
    const std::string workflow = is_specular ? "specular-glossiness" : "metallic-roughness";
    return baked(
        folder,
        {.render = {.graph = folder.write("own.graph.json", R"({ "patina": 1, "workflow": ")" + workflow + "\"," +
                                                                more + R"( "surface": {)" + surface + "} }"),
                    .mesh = "plane",
                    .size = 64},
         .is_specular = is_specular});
}

void expect_numbers(const rapidjson::Value& array, const std::vector<double>& expected) {
    ASSERT_EQ(array.Size(), expected.size());
    for (unsigned i = 0; i < array.Size(); i++) EXPECT_NEAR(array[i].GetDouble(), expected[i], 1e-6) << i;
}

// The warning about texels names the node, whose place in a picture of the object would be another one.
TEST(Bake, TexelsThatAreNotFiniteAreTracedToTheirNode) {
    const Folder folder;
    const std::string nodes = R"j("nodes": [ { "id": "mask", "expr": "step(0.5, @uv0.x)" },
        { "id": "share", "expr": "mask / (1 - mask)" } ],)j";
    for (const char* surface : {R"j("baseColor": "= share * float3(0.5, 1, 1)")j", R"j("roughness": "= share - 0.2")j",
                                R"j("emission": "= float3(share, 0, 0)")j"}) {
        const Baked made = baked_surface(folder, surface, false, nodes);
        const auto& all = made.outcome.diagnostics;
        const auto found = std::find_if(all.begin(), all.end(),
                                        [](const Diagnostic& each) { return each.code == "pixels-not-finite"; });
        ASSERT_NE(found, all.end()) << surface;
        EXPECT_EQ(found->node, "share") << surface;
        EXPECT_EQ(found->line, 2) << surface;
        EXPECT_NE(found->message.find("'share.out' is inf there; they are 0"), std::string::npos) << found->message;
    }
}

// The layer is drawn by itself. What is left of it is the same everywhere: 0.
TEST(Bake, SoAreThoseOfALayer) {
    const Folder folder;
    const std::string nodes = R"j("lighting": "gltf", "nodes": [ { "id": "mask", "expr": "step(0.5, @uv0.x)" },
        { "id": "share", "expr": "mask / (1 - mask)" } ],)j";
    const Baked made = baked_surface(folder, R"j("baseColor": 0.5, "clearcoat": "share")j", false, nodes);
    std::vector<Diagnostic> found;
    for (const Diagnostic& each : made.outcome.diagnostics)
        if (each.code == "pixels-not-finite") found.push_back(each);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found[0].message.starts_with("2048 of 4096 pixels are not finite; the first is 32,0"))
        << found[0].message;
    EXPECT_NE(found[0].message.find("'share.out' is inf there; they are 0 in 'clearcoat'"), std::string::npos)
        << found[0].message;
    EXPECT_EQ(found[0].node, "share");
    EXPECT_EQ(found[0].line, 2);
    EXPECT_EQ(made.outcome.files.size(), 1u);
}

TEST(Bake, WhatIsTheSameEverywhereIsAFactor) {
    const Folder folder;
    const Baked made = baked_surface(
        folder, R"("baseColor": [0.8, 0.4, 0.1], "metallic": 0.25, "roughness": 0.3, "emission": [0, 3, 6])");
    const auto& material = made.material();
    expect_numbers(material["pbrMetallicRoughness"]["baseColorFactor"], {0.8, 0.4, 0.1, 1});
    EXPECT_NEAR(material["pbrMetallicRoughness"]["metallicFactor"].GetDouble(), 0.25, 1e-6);
    EXPECT_NEAR(material["pbrMetallicRoughness"]["roughnessFactor"].GetDouble(), 0.3, 1e-6);
    // Factors are at most 1; the strength is the rest.
    expect_numbers(material["emissiveFactor"], {0, 0.5, 1});
    EXPECT_NEAR(material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"].GetDouble(), 6, 1e-6);
    EXPECT_FALSE(made.json.HasMember("textures"));
    EXPECT_EQ(made.outcome.files.size(), 1u);
}

// The extension's diffuse and specular are the inputs of the workflow.
TEST(Bake, TheSpecularWorkflowKeepsItsInputs) {
    const Folder folder;
    const Baked made =
        baked_surface(folder, R"("baseColor": [0.8, 0.4, 0.1], "specular": [0.5, 0.2, 0.1], "glossiness": 0.7)", true);
    const auto& extension = made.material()["extensions"]["KHR_materials_pbrSpecularGlossiness"];
    expect_numbers(extension["diffuseFactor"], {0.8, 0.4, 0.1, 1});
    expect_numbers(extension["specularFactor"], {0.5, 0.2, 0.1});
    EXPECT_NEAR(extension["glossinessFactor"].GetDouble(), 0.7, 1e-6);
}

// MetallicFromSpecular is exact between 0.04 and a colour: a metal of this colour.
TEST(Bake, TheSpecularWorkflowBecomesMetallic) {
    const Folder folder;
    const std::string graph = folder.write("own.graph.json", R"({ "patina": 1, "workflow": "specular-glossiness",
        "surface": { "baseColor": [0, 0, 0], "specular": [0.8, 0.4, 0.1], "glossiness": 0.7 } })");
    const Baked made = baked(folder, {.render = {.graph = graph, .mesh = "plane", .size = 16}});
    const auto& pbr = made.material()["pbrMetallicRoughness"];
    expect_numbers(pbr["baseColorFactor"], {0.8, 0.4, 0.1, 1});
    EXPECT_NEAR(pbr.HasMember("metallicFactor") ? pbr["metallicFactor"].GetDouble() : 1, 1, 1e-6);
    EXPECT_NEAR(pbr["roughnessFactor"].GetDouble(), 0.3, 1e-6);
}

// On the plane, the centre of the texel x, y has u = (x + 0.5) / size, and v likewise downwards.
TEST(Bake, TexelsAreTheValuesAtTheirCentres) {
    const Folder folder;
    const Baked made = baked_surface(folder, R"js("baseColor": "= float3(@uv0.x, @uv0.y, 0.5)", "roughness": "@uv0.x",
        "metallic": 0.5, "occlusion": "@uv0.y", "normalTS": "= float3(0.6, 0.48, 0.64)")js");
    const Outcome<Image> color = load_image((folder.path / "baked.baseColor.png").string());
    const Outcome<Image> parameters = load_image((folder.path / "baked.metallicRoughness.png").string());
    const Outcome<Image> normal = load_image((folder.path / "baked.normal.png").string());
    const Outcome<Image> occlusion = load_image((folder.path / "baked.occlusion.png").string());
    ASSERT_TRUE(color && parameters && normal && occlusion);
    const float kHalfStep = 0.5f / 255 + 1e-5f;
    for (int y = 0; y < 64; y += 7) {
        for (int x = 0; x < 64; x += 7) {
            const float u = (float(x) + 0.5f) / 64, v = (float(y) + 0.5f) / 64;
            EXPECT_NEAR(color.value.at(x, y)[0], srgb_encode(u), kHalfStep);
            EXPECT_NEAR(color.value.at(x, y)[1], srgb_encode(v), kHalfStep);
            EXPECT_NEAR(parameters.value.at(x, y)[1], u, kHalfStep);
            EXPECT_EQ(parameters.value.at(x, y)[2], 1);  // the factor says all
            EXPECT_NEAR(occlusion.value.at(x, y)[0], v, kHalfStep);
            // Green points up in the texture, and 0.5 is 0 (section 3.9.3 of the specification).
            EXPECT_NEAR(normal.value.at(x, y)[0], 0.8f, kHalfStep);
            EXPECT_NEAR(normal.value.at(x, y)[1], 0.74f, kHalfStep);
            EXPECT_NEAR(normal.value.at(x, y)[2], 0.82f, kHalfStep);
        }
    }
    EXPECT_NEAR(made.material()["pbrMetallicRoughness"]["metallicFactor"].GetDouble(), 0.5, 1e-6);
}

TEST(Bake, AlphaModesAndSides) {
    const Folder folder;
    const auto with = [&](const std::string& surface, const std::string& render) {
        return baked_surface(folder, surface, false, R"("render": {)" + render + "},");
    };
    const Baked cutout = with(R"("alpha": "@uv0.x", "alphaClip": 0.25)", R"("surface": "cutout", "cull": "off")");
    EXPECT_STREQ(cutout.material()["alphaMode"].GetString(), "MASK");
    EXPECT_NEAR(cutout.material()["alphaCutoff"].GetDouble(), 0.25, 1e-6);
    EXPECT_TRUE(cutout.material()["doubleSided"].GetBool());
    const Baked fade = with(R"("alpha": 0.5)", R"("surface": "fade")");
    EXPECT_STREQ(fade.material()["alphaMode"].GetString(), "BLEND");
    expect_numbers(fade.material()["pbrMetallicRoughness"]["baseColorFactor"], {0.5, 0.5, 0.5, 0.5});
    EXPECT_FALSE(fade.material().HasMember("doubleSided"));
    // A cutoff that varies is in alpha already: 1 where the surface is.
    const Baked varying = with(R"("alpha": 0.5, "alphaClip": "@uv0.x")", R"("surface": "cutout")");
    EXPECT_STREQ(varying.material()["alphaMode"].GetString(), "MASK");
    const Outcome<Image> color = load_image((folder.path / "baked.baseColor.png").string());
    ASSERT_TRUE(color) << color.error;
    EXPECT_EQ(color.value.at(31, 5)[3], 1);  // u is 0.492
    EXPECT_EQ(color.value.at(32, 5)[3], 0);  // u is 0.508
}

TEST(Bake, UnlitShowsItsColor) {
    const Folder folder;
    const std::string graph = folder.write("own.graph.json", R"({ "patina": 1, "workflow": "unlit",
        "surface": { "color": [0.2, 0.4, 0.6] } })");
    const Baked made = baked(folder, {.render = {.graph = graph, .mesh = "plane", .size = 16}});
    EXPECT_TRUE(made.material()["extensions"].HasMember("KHR_materials_unlit"));
    expect_numbers(made.material()["pbrMetallicRoughness"]["baseColorFactor"], {0.2, 0.4, 0.6, 1});
}

// What the time or the camera would change has the value that the request fixes.
TEST(Bake, TimeAndCameraCanBeFixed) {
    const Folder folder;
    const std::string graph = folder.write("own.graph.json", R"({ "patina": 1, "workflow": "metallic-roughness",
        "surface": { "roughness": "= @time * 0.1", "metallic": "= @cameraPositionWS.x * 0.01" } })");
    const Baked made = baked(
        folder, {.render = {.graph = graph, .mesh = "plane", .size = 16, .time = 3, .camera = "position=25,0,4"}});
    const auto& pbr = made.material()["pbrMetallicRoughness"];
    EXPECT_NEAR(pbr["roughnessFactor"].GetDouble(), 0.3, 1e-6);
    EXPECT_NEAR(pbr["metallicFactor"].GetDouble(), 0.25, 1e-6);
}

// --- layers

// The value at a texel as the extension's text defines it: the factor times a channel of the texture.
class LayerReader {
public:
    LayerReader(const Folder& folder, const Baked& made) : folder_(folder), made_(made) {}

    double number(const char* extension, const char* factor, const char* texture, int channel, int x, int y) const {
        const auto& object = made_.material()["extensions"][extension];
        const auto& given = object[factor];
        const double value = given.IsArray() ? given[unsigned(channel)].GetDouble() : given.GetDouble();
        return value * texel(object, texture, channel, x, y);
    }
    double texel(const rapidjson::Value& object, const char* texture, int channel, int x, int y) const {
        const int index = object[texture]["index"].GetInt();
        const int image = made_.json["textures"][unsigned(index)]["source"].GetInt();
        const std::string name = made_.json["images"][unsigned(image)]["name"].GetString();
        Outcome<Image> read = load_image((folder_.path / (name + ".png")).string());
        EXPECT_TRUE(read) << read.error;
        if (std::string(texture).find("Color") != std::string::npos) decode_srgb(read.value);
        return double(read.value.at(x, y)[std::size_t(channel)]);
    }
    const rapidjson::Value& extension(const char* name) const { return made_.material()["extensions"][name]; }

private:
    const Folder& folder_;
    const Baked& made_;
};

TEST(Bake, LayersAreWhereTheirExtensionsReadThem) {
    const Folder folder;
    const std::string graph = folder.write("own.graph.json", R"js({ "patina": 1, "workflow": "metallic-roughness",
        "lighting": "gltf", "surface": { "clearcoat": "@uv0.x", "clearcoatRoughness": "@uv0.y",
        "sheenColor": "= float3(@uv0, 0.3)", "sheenRoughness": "@uv0.x", "specularFactor": "@uv0.y",
        "specularColor": "= float3(@uv0 * 2, 0.5)", "ior": 1.4, "anisotropy": "= 0.5 * @uv0.x",
        "anisotropyDirection": [0.6, -0.8], "iridescence": "@uv0.y", "iridescenceThickness": "= 200 + 300 * @uv0.x",
        "transmission": "@uv0.x", "thickness": "= 3 * @uv0.y", "attenuationDistance": 0.7,
        "emission": [0, 0.5, 1], "emissiveStrength": 4 } })js");
    const Baked made = baked(folder, {.render = {.graph = graph, .mesh = "plane", .size = 64}});
    ASSERT_TRUE(made.outcome.ok);
    const LayerReader read(folder, made);
    constexpr int kRed = 0, kGreen = 1, kBlue = 2, kAlpha = 3;
    const double kHalfStep = 0.5 / 255 + 1e-3;
    for (const auto& [x, y] : {std::pair(3, 50), {40, 20}}) {
        const double u = (x + 0.5) / 64, v = (y + 0.5) / 64;
        const auto number = [&, x = x, y = y](const char* extension, const char* factor, const char* texture,
                                              int channel) {
            return read.number(extension, factor, texture, channel, x, y);
        };
        const char* coat = "KHR_materials_clearcoat";
        EXPECT_NEAR(number(coat, "clearcoatFactor", "clearcoatTexture", kRed), u, kHalfStep);
        EXPECT_NEAR(number(coat, "clearcoatRoughnessFactor", "clearcoatRoughnessTexture", kGreen), v, kHalfStep);
        const char* sheen = "KHR_materials_sheen";
        EXPECT_NEAR(number(sheen, "sheenColorFactor", "sheenColorTexture", kRed), u, 2 * kHalfStep);
        EXPECT_NEAR(number(sheen, "sheenColorFactor", "sheenColorTexture", kBlue), 0.3, 2 * kHalfStep);
        EXPECT_NEAR(number(sheen, "sheenRoughnessFactor", "sheenRoughnessTexture", kAlpha), u, kHalfStep);
        const char* specular = "KHR_materials_specular";
        EXPECT_NEAR(number(specular, "specularFactor", "specularTexture", kAlpha), v, kHalfStep);
        EXPECT_NEAR(number(specular, "specularColorFactor", "specularColorTexture", kGreen), 2 * v, 4 * kHalfStep);
        EXPECT_NEAR(number("KHR_materials_transmission", "transmissionFactor", "transmissionTexture", kRed), u,
                    kHalfStep);
        EXPECT_NEAR(number("KHR_materials_volume", "thicknessFactor", "thicknessTexture", kGreen), 3 * v,
                    3 * kHalfStep);
        const auto& film = read.extension("KHR_materials_iridescence");
        EXPECT_NEAR(number("KHR_materials_iridescence", "iridescenceFactor", "iridescenceTexture", kRed), v, kHalfStep);
        const double thinnest = film["iridescenceThicknessMinimum"].GetDouble();
        const double thickest = film["iridescenceThicknessMaximum"].GetDouble();
        EXPECT_NEAR(thinnest + (thickest - thinnest) * read.texel(film, "iridescenceThicknessTexture", kGreen, x, y),
                    200 + 300 * u, 300 * kHalfStep);
        // The texture's direction, turned by the rotation, which is 0 where it is not given.
        const auto& stretch = read.extension("KHR_materials_anisotropy");
        EXPECT_FALSE(stretch.HasMember("anisotropyRotation"));
        EXPECT_NEAR(2 * read.texel(stretch, "anisotropyTexture", kRed, x, y) - 1, 0.6, 2 * kHalfStep);
        EXPECT_NEAR(2 * read.texel(stretch, "anisotropyTexture", kGreen, x, y) - 1, -0.8, 2 * kHalfStep);
        EXPECT_NEAR(number("KHR_materials_anisotropy", "anisotropyStrength", "anisotropyTexture", kBlue), 0.5 * u,
                    kHalfStep);
    }
    EXPECT_NEAR(read.extension("KHR_materials_ior")["ior"].GetDouble(), 1.4, 1e-6);
    EXPECT_NEAR(read.extension("KHR_materials_volume")["attenuationDistance"].GetDouble(), 0.7, 1e-6);
    EXPECT_NEAR(read.extension("KHR_materials_emissive_strength")["emissiveStrength"].GetDouble(), 4, 1e-6);
    expect_numbers(made.material()["emissiveFactor"], {0, 0.5, 1});
}

TEST(Bake, AConstantStretchIsARotation) {
    const Folder folder;
    const std::string graph = folder.write("own.graph.json", R"js({ "patina": 1, "workflow": "metallic-roughness",
        "lighting": "gltf", "surface": { "anisotropy": 0.5, "anisotropyDirection": [0, 1] } })js");
    const Baked made = baked(folder, {.render = {.graph = graph, .mesh = "plane", .size = 16}});
    const auto& stretch = made.material()["extensions"]["KHR_materials_anisotropy"];
    EXPECT_NEAR(stretch["anisotropyStrength"].GetDouble(), 0.5, 1e-6);
    EXPECT_NEAR(stretch["anisotropyRotation"].GetDouble(), std::acos(0.0), 1e-6);
    EXPECT_TRUE(made.json["meshes"][0]["primitives"][0]["attributes"].HasMember("TANGENT"));
}

// --- pictures

Image picture(RenderRequest request) {
    const Compiler compiler;
    RenderMachine machine;
    request.size = 192;
    request.camera = "position=1.5,1.2,3.4 target=0,0,0 fov=34";
    RenderOutcome drawn = render(compiler, request, machine);
    EXPECT_TRUE(drawn.ok) << drawn.error;
    for (const Diagnostic& each : drawn.diagnostics) EXPECT_NE(each.severity, Severity::Error) << to_text(each);
    encode_srgb(drawn.image);
    return drawn.image;
}

// The baked model as `patina render` draws it: by its import.
Image picture_of_model(const Folder& folder, int samples = RenderRequest{}.samples) {
    const Outcome<cli::ModelFile> model = cli::import_model((folder.path / "baked.glb").string(), {});
    EXPECT_EQ(model.error, "");
    EXPECT_EQ(model.value.refused, 0u);
    RenderRequest request{.graph = model.value.scene, .samples = samples};
    request.options.files = model.value.files;
    return picture(request);
}

// A bumpy surface of which every input varies, in object space and by texture coordinates.
constexpr const char* kVaried = R"json("nodes": [
    { "id": "wave", "expr": "0.5 + 0.5 * sin(@positionOS * 9)" },
    { "id": "metal", "expr": "smoothstep(0.3, 0.7, wave.x * wave.y)" },
    { "id": "bump", "expr": "normalize(float3(0.4 * sin(@uv0 * float2(60, 40)), 1))" }
  ],)json";

// The stated tolerance (docs/baking.md): of the picture's pixels, encoded as sRGB, at most 1 % differ by more than 8 of
// 255, and on average they differ by at most 0.5 of 255. Textures have 8 bits, and a texel is larger than a pixel at
// some places.
void expect_alike(const Image& expected, const Image& received, const char* what) {
    const Comparison same = compare(expected, received, 8.0 / 255);
    EXPECT_LE(same.share, 0.01) << what;
    EXPECT_LE(same.average, 0.5 / 255) << what;
}

// The same of lines that are as narrow as a texel.
void expect_nearly_alike(const Image& expected, const Image& received, const char* what) {
    const Comparison same = compare(expected, received, 8.0 / 255);
    std::printf("%s: %.2f %%, %.2f of 255\n", what, 100 * same.share, 255 * same.average);
    EXPECT_LE(same.share, 0.04) << what;
    EXPECT_LE(same.average, 1.0 / 255) << what;
}

TEST(Bake, TheModelLooksLikeTheGraph) {
    for (const char* mesh : {"sphere", "torus"}) {
        const Folder folder;
        const std::string graph =
            folder.write("own.graph.json", std::string(R"({ "patina": 1, "workflow": "metallic-roughness",
            "lighting": "gltf", )") + kVaried +
                                               R"js("surface": { "baseColor": "= 0.2 + 0.7 * wave", "metallic": "metal",
            "roughness": "= 0.3 + 0.5 * wave.z", "normalTS": "bump", "occlusion": "= 0.5 + 0.5 * wave.y",
            "emission": "= float3(0, 0, 2) * saturate(wave.x * 8 - 7)" } })js");
        const Baked made = baked(folder, {.render = {.graph = graph, .mesh = mesh, .size = 1024}});
        ASSERT_TRUE(made.outcome.ok);
        EXPECT_EQ(made.outcome.files.size(), 6u);
        expect_alike(picture({.graph = graph, .mesh = mesh}), picture_of_model(folder), mesh);
    }
}

// Seen through its holes, from behind, too: there the whole tangent frame is turned round.
TEST(Bake, SoDoesACutoutFromBothSides) {
    const Folder folder;
    const std::string graph =
        folder.write("own.graph.json", std::string(R"({ "patina": 1, "workflow": "metallic-roughness",
        "lighting": "gltf", "render": { "surface": "cutout", "cull": "off" }, )") +
                                           kVaried + R"js("surface": {
        "baseColor": "= 0.2 + 0.7 * wave", "normalTS": "bump", "alpha": "@uv0.y", "alphaClip": 0.45 } })js");
    const Baked made = baked(folder, {.render = {.graph = graph, .mesh = "sphere", .size = 1024}});
    ASSERT_TRUE(made.outcome.ok);
    expect_alike(picture({.graph = graph, .mesh = "sphere"}), picture_of_model(folder), "cutout");
}

TEST(Bake, SoDoesTheSpecularModel) {
    const Folder folder;
    const std::string graph =
        folder.write("own.graph.json", std::string(R"({ "patina": 1, "workflow": "specular-glossiness",
        "lighting": "gltf", )") + kVaried + R"js("surface": { "baseColor": "= (0.2 + 0.7 * wave) * (1 - metal)",
        "specular": "= lerp(float3(0.04), 0.3 + 0.6 * wave, metal)", "glossiness": "= 0.2 + 0.5 * wave.z",
        "normalTS": "bump" } })js");
    const Image expected = picture({.graph = graph, .mesh = "sphere"});
    for (const bool is_specular : {true, false}) {
        const Folder own;
        const Baked made =
            baked(own, {.render = {.graph = graph, .mesh = "sphere", .size = 1024}, .is_specular = is_specular});
        ASSERT_TRUE(made.outcome.ok);
        expect_alike(expected, picture_of_model(own), is_specular ? "specular" : "metallic");
    }
}

// Painted tiles, and glowing cracks.
TEST(Bake, SharpPatternsAreAsSharpAsTheTexels) {
    for (const bool is_lava : {false, true}) {
        const Folder folder;
        RenderRequest request{
            .graph = is_lava ? "examples/graphs/lava.graph.json" : "examples/graphs/azulejo.graph.json",
            .size = 1024,
            .time = 0,
            .options = {.lighting = "gltf"}};
        const Baked made = baked(folder, {.render = request, .is_specular = !is_lava});
        ASSERT_TRUE(made.outcome.ok);
        expect_nearly_alike(picture(request), picture_of_model(folder), request.graph.c_str());
        // The lava's differences are those of the viewer's filter, which more samples make smaller.
        request.samples = 12;
        if (is_lava) expect_alike(picture(request), picture_of_model(folder, request.samples), "many samples");
    }
}

// No base colour and metallic give a blue diffuse colour below a grey f0 of 0.3.
TEST(Bake, SoDoesASurfaceThatMetallicCannotExpress) {
    const Folder folder;
    const std::string surface = R"("baseColor": [0.1, 0.2, 0.6], "specular": [0.3, 0.3, 0.3], "glossiness": 0.6)";
    const std::string graph = folder.write(
        "blue.graph.json",
        R"({ "patina": 1, "workflow": "specular-glossiness", "lighting": "gltf", "surface": {)" + surface + "} }");
    const Baked made = baked(folder, {.render = {.graph = graph, .mesh = "sphere", .size = 64}, .is_specular = true});
    ASSERT_TRUE(made.outcome.ok);
    expect_alike(picture({.graph = graph, .mesh = "sphere"}), picture_of_model(folder), "blue");

    // As metallic and roughness it has another colour, which is said; a pair that these can express is not.
    const auto says = [](const Baked& made) {
        return std::any_of(made.outcome.diagnostics.begin(), made.outcome.diagnostics.end(),
                           [](const Diagnostic& each) {
                               return each.message.find("no base colour and metallic have both") != std::string::npos;
                           });
    };
    EXPECT_FALSE(says(made));
    EXPECT_TRUE(says(baked(Folder(), {.render = {.graph = graph, .mesh = "sphere", .size = 64}})));
    const std::string plain = folder.write("plain.graph.json", R"({ "patina": 1, "workflow": "specular-glossiness",
        "lighting": "gltf", "surface": { "baseColor": [0.1, 0.2, 0.6], "specular": [0.04, 0.04, 0.04] } })");
    EXPECT_FALSE(says(baked(Folder(), {.render = {.graph = plain, .mesh = "sphere", .size = 64}})));
}

}  // namespace
}  // namespace patina::runtime
