// Pictures of small models, drawn as `patina render` draws them, against the values that the specification gives in
// closed form; and that the imported scene draws the same picture.
#include <gtest/gtest.h>

#include <cmath>

#include "compiler/cli/render/model_file.h"
#include "runtime/files/files.h"
#include "runtime/render/render_request.h"
#include "tests/unit/importers/gltf/gltf_writer.h"

namespace patina::importers {
namespace {

using runtime::Image;
using runtime::RenderRequest;

constexpr int kSize = 16;
const double kPi = std::acos(-1.0);

const Compiler& compiler() {
    static const Compiler made;
    return made;
}

Image draw(RenderRequest request) {
    request.size = kSize;
    request.samples = 1;
    request.background = "0";
    request.options.via = "cpu";
    runtime::RenderMachine machine;
    const runtime::RenderOutcome outcome = runtime::render(compiler(), request, machine);
    for (const Diagnostic& each : outcome.diagnostics) ADD_FAILURE() << to_text(each);
    EXPECT_EQ(outcome.error, "");
    return outcome.ok ? outcome.image : runtime::make_image(kSize, kSize);
}

// A camera at z = 5 that sees exactly the square, as the file states it; without light from the surroundings.
const std::string kCamera =
    R"("cameras":[{"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"znear":0.1,"zfar":10}}])";
std::string nodes(const std::string& square, const std::string& more = "") {
    return R"([{"children":[1,2)" + std::string(more.empty() ? "" : ",3") + R"(]},{"name":"square","mesh":0)" + square +
           R"(},{"camera":0,"translation":[0,0,5]})" + (more.empty() ? "" : "," + more) + "]";
}

Image picture_of_model(Square square, const std::string& variant = {}) {
    if (square.nodes == Square{}.nodes) square.nodes = nodes("");
    square.more = kCamera + (square.more.empty() ? "" : "," + square.more);
    const auto model = cli::import_model(save_gltf(square), {.variant = variant});
    EXPECT_EQ(model.error, "");
    RenderRequest request{.graph = model.value.scene, .ambient = "0"};
    request.options.files = model.value.files;
    return draw(request);
}

void expect_pixel(const Image& image, int x, int y, const glm::vec3& expected, float tolerance = 2e-3f) {
    const auto pixel = image.at(x, y);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(pixel[static_cast<std::size_t>(c)], expected[c], tolerance) << x << ", " << y << ": channel " << c;
}

std::string unlit(const std::string& core, const std::string& more = "") {
    return R"([{"pbrMetallicRoughness":{)" + core + R"(},"extensions":{"KHR_materials_unlit":{}})" + more + "}]";
}

TEST(GltfPicture, AFactorIsLinear) {
    const Image image = picture_of_model({.materials = unlit(R"("baseColorFactor":[0.2,0.4,0.6,1])")});
    expect_pixel(image, 8, 8, {0.2f, 0.4f, 0.6f});
    expect_pixel(image, 0, 0, {0.2f, 0.4f, 0.6f});
}

// Black at the left side, red at the right one; the colour of the pixel's centre.
TEST(GltfPicture, VertexColorsAreLinearFactors) {
    const Image image = picture_of_model({.materials = unlit(R"("baseColorFactor":[0.5,1,1,1])"), .has_colors = true});
    expect_pixel(image, 12, 8, {0.5f * 12.5f / 16, 0, 0});
}

TEST(GltfPicture, NodesArePlacedAndMirroredNodesShowTheirFront) {
    const std::string white = unlit(R"("baseColorFactor":[1,1,1,1])");
    const Image moved = picture_of_model({.materials = white, .nodes = nodes(R"(,"translation":[1,0,0])")});
    expect_pixel(moved, 4, 8, {0, 0, 0});
    expect_pixel(moved, 12, 8, {1, 1, 1});
    const Image turned = picture_of_model({.materials = white, .nodes = nodes(R"(,"rotation":[0,1,0,0])")});
    expect_pixel(turned, 8, 8, {0, 0, 0});  // its back is culled
    const Image sides = picture_of_model({.materials = unlit(R"("metallicFactor":1)", R"(,"doubleSided":true)"),
                                          .nodes = nodes(R"(,"rotation":[0,1,0,0])")});
    expect_pixel(sides, 8, 8, {1, 1, 1});
    const Image mirrored =
        picture_of_model({.materials = white, .nodes = nodes(R"(,"scale":[-1,1,1])"), .has_colors = true});
    expect_pixel(mirrored, 3, 8, {12.5f / 16, 0, 0});  // red is at the left now
}

// A picture of 2 by 2 texels, the nearest one of each quarter.
const std::string kQuarters =
    R"("samplers":[{"magFilter":9728,"minFilter":9728}],"textures":[{"source":0,"sampler":0}],"images":[)" +
    picture_of(png_of(2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 51})) + "]";

TEST(GltfPicture, TexturesStandUpright) {
    const Image image =
        picture_of_model({.materials = unlit(R"("baseColorTexture":{"index":0})"), .textures = kQuarters});
    expect_pixel(image, 3, 3, {1, 0, 0});
    expect_pixel(image, 12, 3, {0, 1, 0});
    expect_pixel(image, 3, 12, {0, 0, 1});
    expect_pixel(image, 12, 12, {1, 1, 1});
}

TEST(GltfPicture, FurtherCoordinatesAreTurnedByHalf) {
    for (const std::string set : {"1", "2", "3"}) {
        const Image image = picture_of_model(
            {.materials = unlit(R"("baseColorTexture":{"index":0,"texCoord":)" + set + "}"),
             .meshes = R"([{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"TEXCOORD_)" + set +
                       R"(":3},"indices":5,"material":0}]}])",
             .textures = kQuarters});
        expect_pixel(image, 3, 3, {1, 1, 1});
        expect_pixel(image, 12, 12, {1, 0, 0});
    }
}

// "utilizes only the lower left quadrant of the source image, rotated clockwise": the blue texel alone.
TEST(GltfPicture, TheExampleOfTextureTransforms) {
    const Image image =
        picture_of_model({.materials = unlit(R"("baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":
                               {"offset":[0,1],"rotation":1.57079632679,"scale":[0.5,0.5]}}})"),
                          .textures = kQuarters});
    for (const int x : {2, 13})
        for (const int y : {2, 13}) expect_pixel(image, x, y, {0, 0, 1});
}

TEST(GltfPicture, AlphaModes) {
    // The last texel's alpha is 0.2, below the cutoff; the others are opaque.
    const Image masked = picture_of_model(
        {.materials = unlit(R"("baseColorTexture":{"index":0})", R"(,"alphaMode":"MASK","alphaCutoff":0.3)"),
         .textures = kQuarters});
    expect_pixel(masked, 12, 12, {0, 0, 0});
    expect_pixel(masked, 12, 3, {0, 1, 0});
    const Image blended =
        picture_of_model({.materials = unlit(R"("baseColorFactor":[1,0.5,0,0.25])", R"(,"alphaMode":"BLEND")")});
    expect_pixel(blended, 8, 8, {0.25f, 0.125f, 0});  // over black
}

// A diffuse surface without any reflection: baseColor E / pi.
std::string diffuse(const std::string& core) {
    return R"([{"pbrMetallicRoughness":{"metallicFactor":0,)" + core +
           R"(},"extensions":{"KHR_materials_specular":{"specularFactor":0}}}])";
}
std::string light(const std::string& members) {
    return R"("extensions":{"KHR_lights_punctual":{"lights":[{)" + members + "}]}}";
}
const std::string kLamp = R"({"translation":[0,0,2],"extensions":{"KHR_lights_punctual":{"light":0}}})";

TEST(GltfPicture, LightsAreInLuxAndCandela) {
    const std::string half = diffuse(R"("baseColorFactor":[0.5,0.5,0.5,1])");
    const Image sun = picture_of_model(
        {.materials = half, .nodes = nodes("", kLamp), .more = light(R"("type":"directional","intensity":2)")});
    const auto lux = static_cast<float>(0.5 * 2 / kPi);
    expect_pixel(sun, 3, 8, {lux, lux, lux});
    const Image lamp = picture_of_model({.materials = half,
                                         .nodes = nodes("", kLamp),
                                         .more = light(R"("type":"point","intensity":8,"color":[1,0.5,0])")});
    // At the pixel's centre, 1 / 16 from the middle in x and y.
    const double squared = 4 + 2.0 / 256, cosine = 2 / std::sqrt(squared);
    const auto candela = static_cast<float>(0.5 * 8 / squared * cosine / kPi);
    expect_pixel(lamp, 8, 8, {candela, candela / 2, 0});
}

// The older workflow with black specular: diffuse light alone.
TEST(GltfPicture, SpecularGlossinessWithoutSpecular) {
    const Image image = picture_of_model(
        {.materials = R"([{"extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[0.5,0.25,1,1],
                          "specularFactor":[0,0,0],"glossinessFactor":0}}}])",
         .nodes = nodes("", kLamp),
         .more = light(R"("type":"directional","intensity":3.14159265)")});
    expect_pixel(image, 8, 8, {0.5f, 0.25f, 1}, 5e-3f);
}

// Light, view and normal are one direction: F is f0, and the diffuse colour, less its share of the largest channel of
// f0, gets what F leaves. A rough lobe with alpha = 1 adds D V F = f0 / pi / 4.
TEST(GltfPicture, SpecularGlossinessHasTheStatedF0AndDiffuseColor) {
    const glm::vec3 f0(0.1f, 0.2f, 0.3f), diffuse = glm::vec3(0.5f, 0.25f, 1) * 0.7f;
    const Image image = picture_of_model(
        {.materials = R"([{"extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[0.5,0.25,1,1],
                          "specularFactor":[0.1,0.2,0.3],"glossinessFactor":0}}}])",
         .nodes = nodes("", kLamp),
         .more = light(R"("type":"directional","intensity":3.14159265)")});
    expect_pixel(image, 8, 8, (1.0f - f0) * diffuse + f0 * 0.25f, 5e-3f);
}

TEST(GltfPicture, EmissionHasItsStrength) {
    const Image image = picture_of_model({.materials = R"([{"pbrMetallicRoughness":{"baseColorFactor":[0,0,0,1]},
        "emissiveFactor":[1,0.5,0.25],"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":4}}}])"});
    expect_pixel(image, 8, 8, {4, 2, 1});
}

TEST(GltfPicture, AVariantShowsItsMaterial) {
    const Square square{
        .materials = R"([{"pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1]},"extensions":{"KHR_materials_unlit":{}}},
                                         {"pbrMetallicRoughness":{"baseColorFactor":[0,1,0,1]},"extensions":{"KHR_materials_unlit":{}}}])",
        .meshes = R"([{"primitives":[{"attributes":{"POSITION":0},"indices":5,"material":0,"extensions":
                                      {"KHR_materials_variants":{"mappings":[{"material":1,"variants":[0]}]}}}]}])",
        .more = R"("extensions":{"KHR_materials_variants":{"variants":[{"name":"Green"}]}})"};
    expect_pixel(picture_of_model(square), 8, 8, {1, 0, 0});
    expect_pixel(picture_of_model(square, "Green"), 8, 8, {0, 1, 0});
}

// Light that passes a volume is coloured by its thickness, which the node's scale doubles: 0.5^(2 * 0.5 / 0.5).
TEST(GltfPicture, AVolumesThicknessGrowsWithItsNode) {
    const auto behind = [](const std::string& scale) {
        const std::string glass = R"({"pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0},"extensions":{
            "KHR_materials_specular":{"specularFactor":0},"KHR_materials_transmission":{"transmissionFactor":1},
            "KHR_materials_volume":{"thicknessFactor":0.5,"attenuationDistance":0.5,"attenuationColor":[0.5,0.25,1]}}})";
        const std::string wall = R"({"pbrMetallicRoughness":{},"extensions":{"KHR_materials_unlit":{}}})";
        const std::string primitive = R"("attributes":{"POSITION":0,"NORMAL":1},"indices":5,"material":)";
        return picture_of_model(
            {.materials = "[" + glass + "," + wall + "]",
             .nodes = nodes(scale, R"({"mesh":1,"translation":[0,0,-3],"scale":[9,9,1]})"),
             .meshes = R"([{"primitives":[{)" + primitive + R"(0}]},{"primitives":[{)" + primitive + "1}]}]"});
    };
    expect_pixel(behind(""), 8, 8, {0.5f, 0.25f, 1}, 5e-3f);
    expect_pixel(behind(R"(,"scale":[2,2,2])"), 8, 8, {0.25f, 0.0625f, 1}, 5e-3f);
}

TEST(GltfPicture, TheImportedSceneDrawsTheSame) {
    const std::string path =
        save_gltf({.materials = R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"roughnessFactor":0.4}}])",
                   .nodes = nodes(R"(,"rotation":[0,0.2588,0,0.9659])"),
                   .textures = kQuarters,
                   .more = kCamera});
    const auto model = cli::import_model(path, {});
    ASSERT_EQ(model.error, "");
    RenderRequest in_memory{.graph = model.value.scene};
    in_memory.options.files = model.value.files;

    const std::filesystem::path folder = std::filesystem::path(path).parent_path() / "imported";
    const Source source{.path = path, .start = {}};
    const Imported made = read_verified(*importer_of(source), source, {.folder = folder.string()});
    std::vector<runtime::OutputFile> files;
    for (const TextFile& each : made.graphs)
        files.push_back({.path = (folder / each.name).string(), .bytes = each.text});
    for (const BinaryFile& each : made.copies)
        files.push_back({.path = (folder / each.name).string(), .bytes = each.bytes});
    ASSERT_EQ(runtime::write_files(files), "");
    const Image drawn = draw(in_memory);
    EXPECT_EQ(drawn.pixels, draw({.graph = (folder / made.scene).string()}).pixels);
    EXPECT_GT(drawn.at(8, 8)[0] + drawn.at(8, 8)[1] + drawn.at(8, 8)[2], 0);
}

}  // namespace
}  // namespace patina::importers
