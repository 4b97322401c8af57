// ForwardBase and ForwardAdd of the ShaderLab files, drawn by the runtime through stand-ins for Unity's includes, show
// what the runtime's own path shows: in a project of linear space and in one of gamma space, whose pictures are
// decoded.
#include <filesystem>

#include "unity/pictures.h"

namespace patina::unity {
namespace {

struct Case {
    std::string graph, mesh = "sphere";
    std::map<std::string, std::string> words = {};
};

class UnityPicture : public testing::TestWithParam<Case> {};

TEST_P(UnityPicture, IsThatOfForward) {
    const runtime::Scene scene = scene_of(GetParam().mesh, {kSun});
    const Material material(GetParam().graph, scene, GetParam().words, {});
    const Image expected = forward(material, scene);
    expect_same(expected, in_unity(material, scene, {}), "linear");
    expect_same(expected, decoded(in_unity(material, scene, {"UNITY_COLORSPACE_GAMMA"})), "gamma");
}

TEST_P(UnityPicture, AddsUpToThatOfForward) {
    const runtime::Scene scene = scene_of(GetParam().mesh, {kSun, kLamp, kSpot});
    const Material material(GetParam().graph, scene, GetParam().words, {});
    if (!material.file.pass("ForwardAdd")) {
        EXPECT_EQ(material.result.reflection.workflow, "unlit");  // lights add nothing to it
        return;
    }
    expect_same(forward(material, scene), in_unity(material, scene, {}), "linear");
}

INSTANTIATE_TEST_SUITE_P(
    All, UnityPicture,
    testing::Values(Case{"tests/unity/graphs/standard.graph.json",
                         "torus",
                         {{"_Color", "#d08050"}, {"_GlossMapScale", "0.6"}, {"_Metallic", "0.4"}}},
                    Case{"examples/graphs/rusted_steel.graph.json"}, Case{"examples/graphs/ivy.graph.json", "plane"},
                    Case{"examples/graphs/toon.graph.json", "torus"}, Case{"examples/graphs/coral.graph.json"},
                    Case{"examples/graphs/lava.graph.json"}, Case{"examples/graphs/azulejo.graph.json", "cube"},
                    Case{"examples/sources/standard-specular-setup.graph.json", "sphere"},
                    Case{"examples/surfaces/bricks_parallax.graph.json", "plane"},
                    Case{"tests/unity/graphs/specular.graph.json", "sphere"},
                    Case{"tests/unity/graphs/texels.graph.json", "sphere"},
                    Case{"tests/unity/graphs/wave.graph.json", "capsule"}),
    [](const auto& info) {
        std::string name = info.param.graph.substr(info.param.graph.rfind('/') + 1);
        name = name.substr(0, name.find('.'));
        std::replace(name.begin(), name.end(), '-', '_');
        return name;
    });

// Where a project's graphics tier has Unity's best lighting, UNITY_BRDF_PBS is the model that the graph names.
TEST(UnityTiers, OfTheBestQualityLookLikeTheModel) {
    const runtime::Scene scene = scene_of("torus", {kSun, kLamp, kSpot});
    const std::map<std::string, std::string> words = {
        {"_Color", "#d08050"}, {"_GlossMapScale", "0.6"}, {"_Metallic", "0.4"}};
    const std::string graph = "tests/unity/graphs/standard.graph.json";
    const Material own(graph, scene, words, {});
    Material by_tier(graph, scene, words, {});
    CompileOptions options;
    options.request = CompileOptions::Passes{.path = "tiers"};
    options.targets = {{"unity", "hlsl"}};
    const Result result = compiler().compile_file(graph, options);
    ASSERT_TRUE(result.ok);
    ASSERT_NE(result.shaders.front().text.find("UNITY_BRDF_PBS"), std::string::npos);
    by_tier.file = taken_apart(result.shaders.front().text);
    expect_same(forward(own, scene), in_unity(by_tier, scene, {}), "linear");
}

// In a project of gamma space, Standard adds light and emission encoded: the picture of both is the sum of two
// pictures.
TEST(UnityTiers, AddEncodedColoursInGammaSpace) {
    runtime::Scene scene = scene_of("torus", {kSun});
    scene.ambient = {};
    scene.environment = nullptr;
    const auto picture = [&](const glm::vec3& sun, const std::string& emission) {
        runtime::Scene seen = scene;
        seen.lights[0].color = sun;
        const std::string graph = "tests/unity/graphs/standard.graph.json";
        Material material(graph, seen, {{"_Color", "#d08050"}, {"_EmissionColor", emission}}, {});
        CompileOptions options;
        options.request = CompileOptions::Passes{.path = "tiers"};
        options.targets = {{"unity", "hlsl"}};
        material.file = taken_apart(compiler().compile_file(graph, options).shaders.front().text);
        return in_unity(material, seen, {"UNITY_COLORSPACE_GAMMA", "_EMISSION"});
    };
    const glm::vec3 sun(0.3f, 0.25f, 0.2f);
    const Image light = picture(sun, "0,0,0"), glow = picture(glm::vec3(0), "0.1,0.2,0.05");
    Image sum = light;
    for (std::size_t i = 0; i < sum.pixels.size(); ++i) {
        if (i % 4 != 3) sum.pixels[i] += glow.pixels[i];
    }
    EXPECT_GT(paths::lit_pixels(glow), 500);
    expect_same(sum, picture(sun, "0.1,0.2,0.05"), "the sum");
}

// The lightmapper gets the diffuse colour, half of the reflectance times the square of the roughness, and the emission.
TEST(UnityPictures, OfLightmapsHoldColourAndEmission) {
    const runtime::Scene scene = scene_of("plane", {});
    const Material material("tests/unity/graphs/meta.graph.json", scene, {}, {});
    const LabPass* pass = material.file.pass("Meta");
    ASSERT_TRUE(pass);
    Drawn made{.pass = material.result.reflection.passes.front(), .vertex = {}, .fragment = {}, .lights = {}};
    made.pass.vertex_inputs = appdata_full();
    made.pass.blocks.clear();
    made.pass.cull = Cull::Off;
    for (const Block& block : material.result.reflection.blocks) made.pass.blocks.push_back(block.name);
    const auto middle = [&](const Keywords& keywords) {
        std::vector<Drawn> passes = {made};
        passes[0].vertex = spirv(stage(*pass, material.result.reflection, Stage::Vertex, keywords));
        passes[0].fragment = spirv(stage(*pass, material.result.reflection, Stage::Fragment, keywords));
        const Image image = drawn(material, scene, passes);
        EXPECT_EQ(paths::lit_pixels(image), static_cast<std::size_t>(image.width * image.height));
        const std::size_t at = 4 * static_cast<std::size_t>(image.width * image.height / 2 + image.width / 2);
        return std::array{image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]};
    };
    // Base colour (0.8, 0.4, 0.2), metallic 0.25, smoothness 0.5: diffuse 0.72 of the colour, f0 = lerp(0.04, colour,
    // 0.25), and a share of 0.5 * 0.25 of it.
    const float expected[] = {0.8f * 0.72f + 0.125f * 0.23f, 0.4f * 0.72f + 0.125f * 0.13f,
                              0.2f * 0.72f + 0.125f * 0.08f};
    const auto albedo = middle({}), emission = middle({"STAND_IN_EMISSION"});
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(albedo[c], expected[c], 1e-5) << c;
    EXPECT_NEAR(emission[0], 0.1, 1e-6);
    EXPECT_NEAR(emission[1], 0.2, 1e-6);
    EXPECT_NEAR(emission[2], 1.5, 1e-6);
}

// Lit at the vertices: what the runtime's own vertex path shows of direct light. The lights have no distance and no
// cone, and there is no light around, because Unity knows these per pixel, and the runtime's path knows them per
// vertex.
class UnityVertexLit : public testing::TestWithParam<Case> {};

TEST_P(UnityVertexLit, IsThatOfTheVertexPath) {
    runtime::Light second = kSun;
    second.direction = {0.8f, 0.1f, 0.5f};
    second.color = glm::vec3(0.2f, 0.5f, 0.4f);
    runtime::Scene scene = scene_of(GetParam().mesh, {kSun, second});
    scene.ambient = {};
    scene.environment = nullptr;
    const Material at_vertices(GetParam().graph, scene, GetParam().words, {}, "vertex");
    ASSERT_EQ(at_vertices.result.reflection.path, "vertex");
    const Image expected = forward(at_vertices, scene);
    expect_same(expected, in_unity(at_vertices, scene, {}), "linear");
    // It is another picture than that of light per pixel.
    const Material per_pixel(GetParam().graph, scene, GetParam().words, {});
    EXPECT_GT(paths::difference(expected, forward(per_pixel, scene)).largest, 0.5 * kMost);
}

INSTANTIATE_TEST_SUITE_P(All, UnityVertexLit,
                         testing::Values(Case{"examples/sources/diffuse-pixel-level.graph.json", "capsule"},
                                         Case{"examples/sources/specular-pixel-level.graph.json", "torus"},
                                         Case{"examples/graphs/ivy.graph.json", "plane"},
                                         Case{"tests/unity/graphs/standard.graph.json",
                                              "torus",
                                              {{"_Color", "#d08050"}, {"_GlossMapScale", "0.6"}}}),
                         [](const auto& info) {
                             std::string name = info.param.graph.substr(info.param.graph.rfind('/') + 1);
                             name = name.substr(0, name.find('.'));
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

// Over a background, as each kind of surface is blended. In gamma space blending itself is another.
class UnityBlending : public testing::TestWithParam<std::string> {};

TEST_P(UnityBlending, IsThatOfForward) {
    runtime::Scene scene = scene_of("sphere", {kSun, kLamp});
    scene.background = glm::vec4(0.4f, 0.5f, 0.2f, 1);
    if (GetParam() == "additive" || GetParam() == "multiply") scene.lights.resize(1);
    const Material material("tests/unity/graphs/" + GetParam() + ".graph.json", scene, {}, {});
    expect_same(forward(material, scene), in_unity(material, scene, {}), "linear");
    scene.fog = kFog;
    const Material in_fog("tests/unity/graphs/" + GetParam() + ".graph.json", scene, {}, {{"fog", "true"}});
    expect_same(forward(in_fog, scene), in_unity(in_fog, scene, {"FOG_LINEAR", "STAND_IN_FOG"}), "fog");
}

INSTANTIATE_TEST_SUITE_P(All, UnityBlending, testing::Values("fade", "transparent", "additive", "multiply"),
                         [](const auto& info) { return info.param; });

// Each combination of the material's keywords is the variant that the compiler makes for these values.
TEST(UnityPictures, OfEachVariantAreThoseOfForward) {
    const runtime::Scene scene = scene_of("torus", {kSun});
    const std::string graph = "tests/unity/graphs/variants.graph.json";
    std::vector<Image> seen;
    for (const bool has_normals : {false, true}) {
        for (const bool glows : {false, true}) {
            for (const char* weather : {"Dry", "Wet", "Icy"}) {
                const Material material(graph, scene, {{"_Emission", glows ? "true" : "false"}},
                                        {{"_NORMALMAP", has_normals ? "true" : "false"}, {"_Weather", weather}});
                std::string on = std::string("_WEATHER_") + weather;
                std::transform(on.begin(), on.end(), on.begin(), [](unsigned char c) { return std::toupper(c); });
                Keywords keywords = {on};
                if (has_normals) keywords.emplace_back("_NORMALMAP");
                if (glows) keywords.emplace_back("_EMISSION_ON");
                const Image expected = forward(material, scene);
                expect_same(expected, in_unity(material, scene, keywords), on);
                // Where none of an enum's keywords is defined the material has its first value.
                std::erase(keywords, "_WEATHER_DRY");
                expect_same(expected, in_unity(material, scene, keywords), on + ", or none");
                for (const Image& other : seen) EXPECT_GT(paths::difference(expected, other).largest, kMost) << on;
                seen.push_back(expected);
            }
        }
    }
}

// The G-buffer: what `gbuffer` of the path `deferred` leaves, target by target. With high dynamic range the light is in
// it as it is, without it as 2^-light.
TEST(UnityPictures, FillTheSameGBuffer) {
    const runtime::Scene scene = scene_of("torus", {});
    const Material material("tests/unity/graphs/standard.graph.json", scene,
                            {{"_Color", "#d08050"}, {"_Metallic", "0.4"}, {"_EmissionColor", "0.1,0.2,0.3"}}, {},
                            "deferred");
    const runtime::Scene upside_down = upward(scene);
    const Material upward_material = upward(material);
    const Reflection& reflection = material.result.reflection;
    const auto gbuffer = std::find_if(reflection.passes.begin(), reflection.passes.end(),
                                      [](const Pass& pass) { return pass.name == "gbuffer"; });
    ASSERT_NE(gbuffer, reflection.passes.end());
    ASSERT_EQ(gbuffer->targets.size(), 4u);
    const LabPass* pass = material.file.pass("Deferred");
    ASSERT_TRUE(pass);
    Drawn own{.pass = *gbuffer, .vertex = {}, .fragment = {}, .lights = {}};
    const auto draw = [&](Drawn& made, std::size_t shown) {
        const bool is_own = &made == &own;
        runtime::Frame frame{.shown = shown};
        for (const RenderTarget& target : gbuffer->targets)
            frame.targets.push_back({.name = target.name, .width = scene.width, .height = scene.height});
        frame.targets.push_back({.name = "depth",
                                 .format = TargetFormat::Depth,
                                 .width = scene.width,
                                 .height = scene.height,
                                 .clear = glm::vec4(1)});
        const runtime::EngineScene seen{.scene = &scene,
                                        .view = runtime::camera_view(scene),
                                        .object_to_world = scene.object_to_world,
                                        .ambient = scene.ambient};
        frame.steps.push_back({.reflection = &reflection,
                               .pass = &made.pass,
                               .stages = {.vertex_spirv = made.vertex, .fragment_spirv = made.fragment},
                               .mesh = is_own ? &scene.mesh : &upside_down.mesh,
                               .blocks = runtime::fill_blocks(reflection, material.values, seen),
                               .textures = is_own ? material.textures : upward_material.textures,
                               .targets = {0, 1, 2, 3},
                               .depth = 4});
        const auto image = renderer().draw(frame);
        EXPECT_TRUE(image) << image.error;
        return image ? image.value : runtime::make_image(scene.width, scene.height);
    };
    for (const Shader& shader : material.result.shaders) {
        if (shader.pass != "gbuffer" || shader.target != Target::Hlsl) continue;
        (shader.stage == Stage::Vertex ? own.vertex : own.fragment) = spirv(shader);
    }
    for (const bool is_hdr : {true, false}) {
        const Keywords keywords = is_hdr ? Keywords{"UNITY_HDR_ON"} : Keywords{};
        Drawn unitys{.pass = *gbuffer, .vertex = {}, .fragment = {}, .lights = {}};
        unitys.pass.vertex_inputs = appdata_full();
        unitys.pass.blocks.clear();
        for (const Block& block : reflection.blocks) unitys.pass.blocks.push_back(block.name);
        unitys.vertex = spirv(stage(*pass, reflection, Stage::Vertex, keywords));
        unitys.fragment = spirv(stage(*pass, reflection, Stage::Fragment, keywords));
        for (std::size_t target = 0; target < 4; ++target) {
            Image expected = draw(own, target);
            if (target == 3 && !is_hdr) {
                for (int y = 0; y < expected.height; ++y) {
                    for (int x = 0; x < expected.width; ++x) {
                        float* pixel = &expected.pixels[4 * static_cast<std::size_t>(y * expected.width + x)];
                        for (int c = 0; c < 3 && pixel[3] > 0; ++c) pixel[c] = std::exp2(-pixel[c]);
                    }
                }
            }
            expect_same(expected, draw(unitys, target), gbuffer->targets[target].name);
        }
    }
}

// The fog that the stand-ins compute from the runtime's settings is the runtime's own.
TEST(UnityPictures, FadeIntoTheSameFog) {
    runtime::Scene scene = scene_of("torus", {kSun, kLamp});
    scene.fog = kFog;
    const Material material("tests/unity/graphs/standard.graph.json", scene, {{"_Color", "#d08050"}},
                            {{"fog", "true"}});
    expect_same(forward(material, scene), in_unity(material, scene, {"FOG_LINEAR", "STAND_IN_FOG"}), "fog");
}

// One texture that no turn or mirror leaves alone, read in many ways.
class UnityTexture : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(UnityTexture, ShowsTheSameTexels) {
    const std::string path = testing::TempDir() + "read_" + GetParam().first + ".graph.json";
    const std::string picture = std::filesystem::absolute("tests/unity/graphs/patches.png").string();
    std::filesystem::copy_file(picture, testing::TempDir() + "patches.png",
                               std::filesystem::copy_options::overwrite_existing);
    std::ofstream(path) << R"j({ "patina": 1, "workflow": "unlit", "properties": [
        { "name": "_Map", "type": "texture2d", "default": "./patches.png" },
        { "name": "_Tiled", "type": "texture2d", "default": "./patches.png", "tiling": true },
        { "name": "_Layers", "type": "texture2dArray", "default": "./patches.png", "grid": [3, 1] },
        { "name": "_Volume", "type": "texture3d", "default": "./patches.png", "grid": [3, 1] },
        { "name": "_Swizzled", "type": "texture2d", "default": "./patches.png", "swizzle": "bgr0" },
        { "name": "_Down", "type": "texture2d", "usage": "normal", "default": "./patches.png", "handedness": "directx" },
        { "name": "_Packed", "type": "texture2d", "usage": "normal", "default": "./patches.png", "swizzle": "brg",
          "handedness": "directx" } ],
      "nodes": [ )j" << GetParam().second
                        << R"j( ], "surface": { "color": "= texel.rgb" } })j";
    const runtime::Scene scene = scene_of("sphere", {kSun});
    const Material material(path, scene, {{"_Tiled_ST", "2,3,0.1,0.3"}}, {});
    ASSERT_TRUE(material.result.ok);
    // The same place of the texture, in numbers that count from the bottom: 1 - 3 - 0.3.
    Material unitys(path, scene, {{"_Tiled_ST", "2,3,0.1,-2.3"}}, {});
    expect_same(forward(material, scene), in_unity(unitys, scene, {}), GetParam().first);
}

INSTANTIATE_TEST_SUITE_P(
    All, UnityTexture,
    testing::Values(
        std::pair{"Plain", R"j({ "id": "texel", "node": "SampleTexture2D", "in": { "texture": "$_Map" } })j"},
        std::pair{"Swizzled", R"j({ "id": "texel", "node": "SampleTexture2D", "in": { "texture": "$_Swizzled" } })j"},
        std::pair{
            "NormalOfDirectX",
            R"j({ "id": "n", "node": "SampleNormalMap", "in": { "texture": "$_Down" } }, { "id": "texel", "expr": "n * 0.5 + 0.5" })j"},
        std::pair{
            "PackedNormal",
            R"j({ "id": "n", "node": "SampleNormalMap", "in": { "texture": "$_Packed" } }, { "id": "texel", "expr": "n * 0.5 + 0.5" })j"},
        std::pair{"Tiled", R"j({ "id": "texel", "node": "SampleTexture2D", "in": { "texture": "$_Tiled" } })j"},
        std::pair{
            "Scaled",
            R"j({ "id": "texel", "node": "SampleTexture2D", "in": { "texture": "$_Map", "uv": "= @uv0 * float2(2, 3)" } })j"},
        std::pair{
            "Moved",
            R"j({ "id": "texel", "node": "SampleTexture2D", "in": { "texture": "$_Map", "uv": "= @uv0 + float2(0.1, 0.3)" } })j"},
        std::pair{
            "MovedAndTiled",
            R"j({ "id": "texel", "node": "SampleTexture2D", "in": { "texture": "$_Tiled", "uv": "= @uv0 + float2(0.1, 0.3)" } })j"},
        std::pair{"Swapped",
                  R"j({ "id": "texel", "node": "SampleTexture2D", "in": { "texture": "$_Map", "uv": "= @uv0.yx" } })j"},
        std::pair{"Flipbook", R"j({ "id": "frame", "node": "Flipbook", "in": { "frame": 6 } },
            { "id": "texel", "node": "SampleTexture2D", "in": { "texture": "$_Map", "uv": "frame" } })j"},
        std::pair{"Matcap", R"j({ "id": "ball", "node": "MatcapUV" },
            { "id": "texel", "node": "SampleTexture2D", "in": { "texture": "$_Map", "uv": "ball" } })j"},
        std::pair{
            "Ramp",
            R"j({ "id": "texel", "node": "SampleTexture2D", "in": { "texture": "$_Map", "uv": "= @normalWS.xy * 0.5 + 0.5" } })j"},
        std::pair{"Screen",
                  R"j({ "id": "texel", "node": "SampleTexture2D", "in": { "texture": "$_Map", "uv": "@screenUV" } })j"},
        std::pair{"Level",
                  R"j({ "id": "texel", "node": "SampleTexture2DLevel", "in": { "texture": "$_Tiled", "level": 1 } })j"},
        std::pair{
            "Gradients",
            R"j({ "id": "texel", "node": "SampleTexture2DMoved", "in": { "texture": "$_Tiled", "uv": "= @uv0 * 4" } })j"},
        std::pair{
            "Texel",
            R"j({ "id": "texel", "node": "LoadTexture2D", "in": { "texture": "$_Map", "texel": "= @uv0 * 7" } })j"},
        std::pair{
            "AtVertices",
            R"j({ "id": "texel", "node": "SampleTexture2DLevel", "in": { "texture": "$_Map" }, "stage": "vertex" })j"},
        std::pair{
            "Layers",
            R"j({ "id": "texel", "node": "SampleTexture2DArray", "in": { "texture": "$_Layers", "index": "= floor(@uv0.x * 3)" } })j"},
        std::pair{
            "LayersSwapped",
            R"j({ "id": "texel", "node": "SampleTexture2DArrayLevel", "in": { "texture": "$_Layers", "uv": "= @uv0.yx", "index": 2 } })j"},
        std::pair{
            "Volume",
            R"j({ "id": "texel", "node": "SampleTexture3D", "in": { "texture": "$_Volume", "uvw": "= float3(@uv0, @uv0.x)" } })j"},
        std::pair{
            "VolumeOfDirections",
            R"j({ "id": "texel", "node": "SampleTexture3DLevel", "in": { "texture": "$_Volume", "uvw": "= @normalWS * 0.5 + 0.5" } })j"},
        std::pair{"Gradient", R"j({ "id": "texel", "expr": "float4(@uv0, @uv0.y * @uv0.y, 1)" })j"}),
    [](const auto& info) { return std::string(info.param.first); });

}  // namespace
}  // namespace patina::unity
