#include "witness/bench.h"

#include <gtest/gtest.h>

#include <charconv>

#include "patina/validate.h"
#include "runtime/cpu/cpu_render.h"
#include "runtime/values/material_values.h"

namespace patina::witness {
namespace {

std::string words_of(const std::vector<Diagnostic>& diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) text += to_text(diagnostic) + "\n";
    return text;
}

// The forward pass, of an opaque surface whose alpha is a number like the others.
constexpr const char* kPath = "values.pass.hlsl";
constexpr const char* kPass = R"(
[pass("values")] [vertex]
float4 valuesVertex(float3 position = positionWS) { return mul(worldToClip, float4(position, 1)); }

[pass("values")] [fragment] [lights("all")] [blend("one", "zero")]
float4 valuesFragment(float3 position = positionWS) {
    LightingSurface lit = lightingSurface();
    return float4(litByAll(lit, position), lit.alpha);
}
)";

// What both ways of drawing are given.
struct Setting {
    runtime::Scene scene;
    std::vector<runtime::LoadedTexture> textures;
    std::vector<runtime::BlockBytes> blocks;

    Setting(const Reflection& reflection, const Inputs& inputs)
        : scene(inputs.scene ? *inputs.scene : runtime::fullscreen_scene(inputs.width, inputs.height)) {
        if (!inputs.scene) {
            scene.time = inputs.time;
            scene.ambient = runtime::studio_environment()->ambient();
            scene.environment = runtime::studio_environment();
        }
        for (const Texture& texture : reflection.textures) {
            if (!texture.is_material) continue;
            const auto found = inputs.textures.find(texture.name);
            textures.push_back({.name = texture.name,
                                .data = found == inputs.textures.end() ? inputs.data : found->second,
                                .format = runtime::TexelFormat::Float32});
        }
        runtime::add_engine_textures(textures, reflection, scene);
        const auto values = runtime::material_values(reflection, inputs.values);
        EXPECT_TRUE(values) << values.error;
        blocks = runtime::fill_blocks(reflection, values.value, scene);
    }
    runtime::Draw draw(const Result& result) const {
        return {.reflection = &result.reflection,
                .pass = "values",
                .scene = &scene,
                .blocks = blocks,
                .textures = textures,
                .program = result.program.get()};
    }
};

}  // namespace

std::string data_property() {
    return R"({ "name": "_Data", "type": "texture2d", "usage": "data", "default": "white" })";
}

std::string load_node(const std::string& id, const std::string& column, const std::string& row) {
    return R"({ "id": ")" + id + R"(", "node": "LoadTexture2D", "in": { "texture": "$_Data", "texel": "= float2()" +
           column + ", " + row + ")\" } }";
}

std::string literal(double value) {
    char buffer[64];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
    EXPECT_EQ(error, std::errc());
    return {buffer, end};
}

std::shared_ptr<const TextureData> texture_of(const Image& texels) {
    TextureData data{.levels = {{.width = texels.width, .height = texels.height, .texels = texels.pixels}},
                     .sampler = {.wrap = Wrap::Clamp, .filter = Filter::Nearest}};
    return std::make_shared<const TextureData>(std::move(data));
}

Bench::Bench() {
    auto opened = runtime::Renderer::open({.validation = true});
    EXPECT_TRUE(opened) << opened.error;
    renderer_ = std::move(opened.value);
}

std::vector<std::uint32_t> Bench::spirv(const Result& result, Stage stage, Target target) {
    for (const Shader& shader : result.shaders) {
        if (shader.stage != stage || shader.target != target) continue;
        if (stage == Stage::Vertex && vertex_stages_.contains(shader.text)) return vertex_stages_[shader.text];
        Validated validated = validate(shader);
        EXPECT_TRUE(validated.ok) << words_of(validated.diagnostics) << validated.log << shader.text;
        if (stage == Stage::Vertex) vertex_stages_[shader.text] = validated.spirv;
        return validated.spirv;
    }
    ADD_FAILURE() << "the graph has no such stage";
    return {};
}

std::optional<Material> Bench::compile(const std::string& text, const std::map<std::string, std::string>& files,
                                       bool only_cpu) {
    const auto read = [&files](const std::string& path) -> std::optional<std::string> {
        if (path.ends_with(kPath)) return kPass;
        const auto found = files.find(path.substr(path.find_last_of('/') + 1));
        return found == files.end() ? std::nullopt : std::optional(found->second);
    };
    Material material{.result = compiler_.compile_text(
                          "witness.graph.json", text,
                          {.targets = only_cpu ? std::vector<Target>{} : std::vector{Target::Glsl, Target::Hlsl},
                           .request = CompileOptions::Passes{.path = kPath},
                           .files = {.read = read},
                           .keep_programs = true}),
                      .vertex = {},
                      .fragment = {}};
    if (!material.result.ok) {
        ADD_FAILURE() << words_of(material.result.diagnostics) << text;
        return {};
    }
    if (only_cpu) return material;
    for (const Target& target : {Target::Glsl, Target::Hlsl}) {
        material.vertex[target] = spirv(material.result, Stage::Vertex, target);
        material.fragment[target] = spirv(material.result, Stage::Fragment, target);
        if (material.vertex[target].empty() || material.fragment[target].empty()) return {};
    }
    return material;
}

Image Bench::draw(const Material& material, Target target, const Inputs& inputs) {
    if (!renderer_) return {};
    const Setting setting(material.result.reflection, inputs);
    runtime::Draw draw = setting.draw(material.result);
    draw.vertex_spirv = material.vertex.at(target);
    draw.fragment_spirv = material.fragment.at(target);
    auto image = renderer_->draw(draw);
    EXPECT_TRUE(image) << image.error;
    return std::move(image.value);
}

Image Bench::run(const Material& material, Precision precision, const Inputs& inputs) {
    const Setting setting(material.result.reflection, inputs);
    auto image = runtime::cpu_draw(setting.draw(material.result), precision);
    EXPECT_TRUE(image) << image.error;
    return std::move(image.value);
}

void Bench::expect_silence() const {
    ASSERT_TRUE(renderer_);
    EXPECT_EQ(renderer_->messages(), std::vector<std::string>{});
}

}  // namespace patina::witness
