// A twin draws the picture that its graph draws: with a sun, a lamp and a spot, with values and textures that are not
// the defaults. So it leaves nothing out, and its cost is a fair measure of what the graph's shaders cost.
#include "tests/bench/twins.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "paths/drawing/drawing.h"
#include "patina/validate.h"
#include "runtime/values/engine_values.h"

namespace patina::bench {
namespace {

using runtime::Image;

runtime::Renderer& renderer() {
    static const auto kOpened = runtime::Renderer::open({.validation = true});
    EXPECT_TRUE(kOpened) << kOpened.error;
    return *kOpened.value;
}

// The object is stretched, turned and mirrored, so that normals and the sign of the bitangent matter.
runtime::Scene scene() {
    runtime::Scene made = runtime::default_scene("sphere");
    made.width = made.height = 128;
    made.background = glm::vec4(0);
    made.object_to_world = glm::mat4({-0.9f, 0.2f, 0, 0}, {0.1f, 0.7f, 0.1f, 0}, {0, -0.2f, 0.8f, 0}, {0.1f, 0, 0, 1});
    made.lights = {
        {.direction = {-0.6f, 0.8f, 0.8f}, .color = glm::vec3(0.75f, 0.72f, 0.68f)},
        {.kind = LightKind::Point, .position = {1.2f, 0.4f, 1.6f}, .color = glm::vec3(0.5f, 0.8f, 1.1f), .range = 6},
        {.kind = LightKind::Spot,
         .position = {-1.2f, 0.2f, 2.0f},
         .direction = {0.5f, -0.05f, -0.8f},
         .color = glm::vec3(1.2f, 0.4f, 0.2f),
         .range = 8,
         .inner_angle = 12,
         .outer_angle = 24}};
    return made;
}

// Each texel has a colour of its own; of a normal map, near the flat one.
std::shared_ptr<const TextureData> pattern(bool is_normal_map, unsigned seed, const Sampler& sampler) {
    constexpr int kSide = 8;
    Image image = runtime::make_image(kSide, kSide);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const float noise = float((i * 7919u + seed * 104729u) % 97u) / 96;
        image.pixels[i] = is_normal_map ? 0.3f + 0.4f * noise : noise;
    }
    return std::make_shared<const TextureData>(TextureData{.levels = runtime::mip_chain(image), .sampler = sampler});
}

struct Material {
    runtime::MaterialValues values;
    std::vector<runtime::LoadedTexture> textures;
};

// Numbers inside of the property's range, which differ from property to property.
runtime::MaterialValues values_of(const Reflection& reflection) {
    runtime::MaterialValues made = runtime::material_values(reflection, {}).value;
    double share = 0.3;
    for (const Property& property : reflection.properties) {
        const auto found = made.numbers.find(property.name);
        if (found == made.numbers.end() || property.binding != Binding::Uniform) continue;
        const auto range = property.range.value_or(std::array<double, 2>{0, 1});
        share = share > 0.7 ? share - 0.5 : share + 0.13;
        for (double& number : found->second) number = range[0] + (range[1] - range[0]) * share;
        if (property.type == PropertyType::Color) found->second[1] *= 0.5;
        if (property.type == PropertyType::Enum) found->second = {1};
    }
    for (const Texture& texture : reflection.textures)
        if (!texture.tiling.empty()) made.tilings[texture.name] = {2, 3, 0.25, 0.125};
    return made;
}

Material material_of(const Reflection& reflection, const runtime::Scene& scene, bool has_patterns) {
    Material made{.values = runtime::material_values(reflection, {}).value,
                  .textures = runtime::load_textures(reflection, "examples/sources", {}, true).textures};
    if (has_patterns) {
        made.values = values_of(reflection);
        unsigned seed = 1;
        for (runtime::LoadedTexture& texture : made.textures) {
            const bool is_normal_map = texture.name.find("Normal") != texture.name.npos || texture.name == "_BumpMap";
            texture.data = pattern(is_normal_map, seed++, texture.data->sampler);
            texture.format = runtime::TexelFormat::Float32;
        }
    }
    runtime::add_engine_textures(made.textures, reflection, scene);
    return made;
}

std::vector<std::uint32_t> spirv(const Shader& shader) {
    const Validated validated = validate(shader);
    EXPECT_TRUE(validated.ok) << shader.file_name << "\n" << validated.log;
    return validated.spirv;
}

Image drawn(const Reflection& reflection, const Material& material, const runtime::Scene& scene,
            const StageTexts& stages) {
    const auto vertex = spirv(stages.vertex), fragment = spirv(stages.fragment);
    runtime::EngineScene seen{.scene = &scene,
                              .view = runtime::camera_view(scene),
                              .object_to_world = scene.object_to_world,
                              .ambient = scene.ambient};
    for (const runtime::Light& light : scene.lights)
        seen.lights.push_back({.light = &light, .index = seen.lights.size()});
    runtime::Frame frame{
        .targets = {{.name = "color", .width = scene.width, .height = scene.height, .clear = scene.background},
                    {.name = "depth",
                     .format = TargetFormat::Depth,
                     .width = scene.width,
                     .height = scene.height,
                     .clear = glm::vec4(1)}}};
    Pass pass = reflection.passes.front();
    pass.cull = Cull::Front;  // the object is mirrored
    // A twin may need less of the mesh.
    std::erase_if(pass.vertex_inputs, [&](const VertexInput& input) {
        const std::string declared = "layout(location = " + std::to_string(input.location) + ") in";
        return stages.vertex.text.find(declared) == std::string::npos;
    });
    frame.steps.push_back({.reflection = &reflection,
                           .pass = &pass,
                           .stages = {.vertex_spirv = vertex, .fragment_spirv = fragment},
                           .mesh = &scene.mesh,
                           .blocks = runtime::fill_blocks(reflection, material.values, seen),
                           .constants = runtime::constants_of(reflection, material.values),
                           .textures = material.textures,
                           .targets = {0},
                           .depth = 1});
    const auto image = renderer().draw(frame);
    EXPECT_TRUE(image) << image.error;
    EXPECT_TRUE(renderer().messages().empty()) << renderer().messages().front();
    return image ? image.value : runtime::make_image(scene.width, scene.height);
}

class Twins : public testing::TestWithParam<Twin> {};

TEST_P(Twins, DrawThePictureOfTheirGraph) {
    const Result result = compiled(GetParam());
    ASSERT_TRUE(result.ok);
    ASSERT_EQ(result.reflection.passes.size(), 1u);
    const runtime::Scene lit = scene();
    for (const bool has_patterns : {false, true}) {
        const Material material = material_of(result.reflection, lit, has_patterns);
        const Image own = drawn(result.reflection, material, lit, stages_of(result));
        const Image by_hand = drawn(result.reflection, material, lit, bench::by_hand(GetParam()));
        EXPECT_GT(paths::lit_pixels(own), 400);
        EXPECT_SAME_PICTURE(own, by_hand);
    }
}

// docs/cost.md has the figures. What is above 1 may become less, and must not become more.
TEST_P(Twins, CostAboutAsMuchAsTheShadersOfTheirGraph) {
    constexpr double kMostInstructions = 1.05, kMostText = 1.65;
    const Result result = compiled(GetParam());
    ASSERT_TRUE(result.ok);
    const StageTexts own = stages_of(result), by_hand = bench::by_hand(GetParam());
    const auto expect_cheap = [](const Shader& made, const Shader& twin) {
        const StageCost cost = cost_of(made), least = cost_of(twin);
        ASSERT_GT(cost.instructions, 0u);
        EXPECT_LE(double(cost.instructions), kMostInstructions * double(least.instructions)) << twin.file_name;
        EXPECT_LE(double(cost.per_light), kMostInstructions * double(least.per_light)) << twin.file_name;
        EXPECT_LE(double(cost.bytes), kMostText * double(least.bytes)) << twin.file_name;
    };
    expect_cheap(own.vertex, by_hand.vertex);
    expect_cheap(own.fragment, by_hand.fragment);
}

// NAME of a test may have no dashes.
std::string word(std::string_view name) {
    std::string made(name);
    std::replace(made.begin(), made.end(), '-', '_');
    return made;
}

INSTANTIATE_TEST_SUITE_P(All, Twins, testing::ValuesIn(kTwins), [](const auto& info) { return word(info.param.name); });

}  // namespace
}  // namespace patina::bench
