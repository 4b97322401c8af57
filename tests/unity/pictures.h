// Draws ShaderLab files by the runtime, through stand-ins for Unity's includes, and the same materials along the
// runtime's own paths.
//
//   const Material material("a.graph.json", scene, {}, {});
//   expect_same(forward(material, scene), in_unity(material, scene, {"FOG_LINEAR"}), "fog");
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "paths/drawing/drawing.h"
#include "patina/validate.h"
#include "runtime/values/engine_values.h"
#include "unity/compiled.h"
#include "unity/shader_lab.h"

namespace patina::unity {

using runtime::Image;
using Keywords = std::vector<std::string>;

inline constexpr double kMost = 2.0 / 255;

inline runtime::Renderer& renderer() {
    static const auto kOpened = runtime::Renderer::open({.validation = true});
    EXPECT_TRUE(kOpened) << kOpened.error;
    return *kOpened.value;
}

inline double decoded(double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

inline runtime::Scene scene_of(const std::string& mesh, std::vector<runtime::Light> lights) {
    runtime::Scene scene = runtime::default_scene(mesh);
    scene.width = scene.height = 96;
    scene.lights = std::move(lights);
    scene.time = 0.7f;
    scene.background = glm::vec4(0);
    return scene;
}

inline const runtime::Light kSun{.direction = {-0.6f, 0.8f, 0.8f}, .color = glm::vec3(0.95f, 0.92f, 0.88f)};
inline const runtime::Light kLamp{
    .kind = LightKind::Point, .position = {1.2f, 0.4f, 1.6f}, .color = glm::vec3(0.5f, 0.8f, 1.1f), .range = 6};
inline const runtime::Light kSpot{.kind = LightKind::Spot,
                                  .position = {-1.2f, 0.2f, 2.0f},
                                  .direction = {0.5f, -0.05f, -0.8f},
                                  .color = glm::vec3(1.2f, 0.4f, 0.2f),
                                  .range = 8,
                                  .inner_angle = 12,
                                  .outer_angle = 24};

inline const runtime::Fog kFog{.mode = FogMode::Linear, .color = glm::vec3(0.3f, 0.4f, 0.6f), .start = 2, .end = 6};

// A material for the runtime's path `forward`, and as Unity's file.
struct Material {
    Result result;
    ShaderLab file;
    std::vector<runtime::LoadedTexture> textures;
    runtime::MaterialValues values;

    Material(const std::string& graph, const runtime::Scene& scene, const std::map<std::string, std::string>& words,
             std::vector<std::pair<std::string, std::string>> switches, const std::string& path = "forward") {
        CompileOptions options;
        options.request = CompileOptions::Passes{.path = path};
        options.targets = {Target::Hlsl, {"unity", "hlsl"}};
        options.switches = std::move(switches);
        result = compiler().compile_file(graph, options);
        EXPECT_TRUE(result.ok) << graph;
        if (!result.ok) return;
        file = taken_apart(result.shaders.back().text);
        const std::string folder = graph.substr(0, graph.rfind('/'));
        auto loaded = runtime::load_textures(result.reflection, folder, {}, true);
        EXPECT_TRUE(loaded.errors.empty());
        textures = std::move(loaded.textures);
        runtime::add_engine_textures(textures, result.reflection, scene);
        const auto given = runtime::material_values(result.reflection, words);
        EXPECT_TRUE(given) << given.error;
        values = given.value;
    }

    Shader own(Stage stage) const {
        for (const Shader& shader : result.shaders) {
            if (shader.stage == stage && shader.target == Target::Hlsl) return shader;
        }
        return {};
    }
};

inline std::vector<std::uint32_t> spirv(const Shader& shader) {
    const Validated validated = validate(shader);
    EXPECT_TRUE(validated.ok) << validated.log << shader.text;
    return validated.spirv;
}

// Draws one pass over the picture. The lights take the slots from 0 on.
struct Drawn {
    Pass pass;
    std::vector<std::uint32_t> vertex, fragment;
    std::vector<runtime::SeenLight> lights;
};

inline Image drawn(const Material& material, const runtime::Scene& scene, std::vector<Drawn>& passes) {
    runtime::Frame frame{
        .targets = {{.name = "color", .width = scene.width, .height = scene.height, .clear = scene.background},
                    {.name = "depth",
                     .format = TargetFormat::Depth,
                     .width = scene.width,
                     .height = scene.height,
                     .clear = glm::vec4(1)}}};
    for (Drawn& each : passes) {
        const runtime::EngineScene seen{.scene = &scene,
                                        .view = runtime::camera_view(scene),
                                        .object_to_world = scene.object_to_world,
                                        .lights = each.lights,
                                        .ambient = scene.ambient};
        frame.steps.push_back({.reflection = &material.result.reflection,
                               .pass = &each.pass,
                               .stages = {.vertex_spirv = each.vertex, .fragment_spirv = each.fragment},
                               .mesh = &scene.mesh,
                               .blocks = runtime::fill_blocks(material.result.reflection, material.values, seen),
                               .constants = runtime::constants_of(material.result.reflection, material.values),
                               .textures = material.textures,
                               .targets = {0},
                               .depth = 1});
    }
    const auto image = renderer().draw(frame);
    EXPECT_TRUE(image) << image.error;
    EXPECT_TRUE(renderer().messages().empty()) << (renderer().messages().empty() ? "" : renderer().messages().front());
    return image ? image.value : runtime::make_image(scene.width, scene.height);
}

inline Image forward(const Material& material, const runtime::Scene& scene) {
    std::vector<runtime::SeenLight> lights;
    for (const runtime::Light& light : scene.lights) lights.push_back({.light = &light, .index = lights.size()});
    std::vector<Drawn> passes = {{.pass = material.result.reflection.passes.front(),
                                  .vertex = spirv(material.own(Stage::Vertex)),
                                  .fragment = spirv(material.own(Stage::Fragment)),
                                  .lights = std::move(lights)}};
    return drawn(material, scene, passes);
}

// Unity's meshes and textures count from the bottom: pictures and coordinates are upside down there.
inline runtime::Scene upward(runtime::Scene scene) {
    for (runtime::Vertex& vertex : scene.mesh.vertices) vertex.uv0.y = 1 - vertex.uv0.y;
    return scene;
}
inline Material upward(Material material) {
    for (runtime::LoadedTexture& texture : material.textures) {
        const auto is_own = [&](const Texture& t) { return t.name == texture.name && t.is_material; };
        const auto& known = material.result.reflection.textures;
        if (texture.dimension == TextureDimension::Cube || std::none_of(known.begin(), known.end(), is_own)) continue;
        TextureData data = *texture.data;
        for (TextureLevel& level : data.levels) {
            const auto row = static_cast<std::ptrdiff_t>(4 * level.width), layer = row * level.height;
            for (auto first = level.texels.begin(); first != level.texels.end(); first += layer) {
                for (int y = 0; y < level.height / 2; ++y)
                    std::swap_ranges(first + y * row, first + (y + 1) * row, first + layer - (y + 1) * row);
            }
        }
        texture.data = std::make_shared<const TextureData>(std::move(data));
    }
    return material;
}

// ForwardBase with the first light, and ForwardAdd with each of the others.
inline Image in_unity(const Material& given, const runtime::Scene& downward, const Keywords& keywords) {
    const Material material = upward(given);
    const runtime::Scene scene = upward(downward);
    const Reflection& reflection = material.result.reflection;
    std::vector<Drawn> passes;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const runtime::Light& light = scene.lights[i];
        const LabPass* pass = i == 0 ? material.file.forward() : material.file.pass("ForwardAdd");
        if (!pass) continue;
        Keywords defined = keywords;
        defined.push_back(light.kind == LightKind::Directional ? "DIRECTIONAL"
                          : light.kind == LightKind::Point     ? "POINT"
                                                               : "SPOT");
        Drawn& made = passes.emplace_back();
        made.pass = reflection.passes.front();
        made.pass.vertex_inputs = appdata_full();
        made.pass.blocks.clear();
        for (const Block& block : reflection.blocks) made.pass.blocks.push_back(block.name);
        if (i > 0) {
            const bool fades = reflection.surface == SurfaceKind::Fade;
            made.pass.depth_write = false;
            made.pass.targets.front().blend = {.source = fades ? BlendFactor::SourceAlpha : BlendFactor::One,
                                               .destination = BlendFactor::One,
                                               .source_alpha = BlendFactor::Zero,
                                               .destination_alpha = BlendFactor::One};
        }
        made.vertex = spirv(stage(*pass, reflection, Stage::Vertex, defined));
        made.fragment = spirv(stage(*pass, reflection, Stage::Fragment, defined));
        made.lights = {{.light = &light, .index = i}};
    }
    return drawn(material, scene, passes);
}

inline Image decoded(Image image) {
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            for (std::size_t c = 0; c < 3; ++c)
                image.pixels[4 * static_cast<std::size_t>(y * image.width + x) + c] = static_cast<float>(
                    decoded(double(image.pixels[4 * static_cast<std::size_t>(y * image.width + x) + c])));
        }
    }
    return image;
}

inline void expect_same(const Image& a, const Image& b, const std::string& what) {
    const paths::Difference how_far = paths::difference(a, b);
    EXPECT_LE(how_far.largest, kMost) << what << ": " << paths::to_text(how_far);
    EXPECT_GT(paths::lit_pixels(a), 500) << what;  // there is something to see
}

}  // namespace patina::unity
