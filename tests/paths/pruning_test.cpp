// Each pass has what it needs and nothing more: read off the reflection, which both shaders of a pass are bound by.
#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "paths/drawing/drawing.h"

namespace patina::paths {
namespace {

using Words = std::vector<std::string>;

// Every input of the surface comes from a texture or a property of its own.
std::string rich_graph(const std::string& name, const std::string& render) {
    return written(name + ".graph.json", R"({
  "patina": 1,
  "workflow": "metallic-roughness",
  "properties": [
    { "name": "_Paint", "type": "texture2d" },
    { "name": "_Bumps", "type": "texture2d", "usage": "normal" },
    { "name": "_Holes", "type": "texture2d", "usage": "data" },
    { "name": "_Glow", "type": "color" },
    { "name": "_Cut", "type": "float", "default": 0.4 }
  ],
  "nodes": [
    { "id": "paint", "node": "SampleTexture2D", "in": { "texture": "$_Paint" } },
    { "id": "bumps", "node": "SampleNormalMap", "in": { "texture": "$_Bumps" } },
    { "id": "holes", "node": "SampleTexture2D", "in": { "texture": "$_Holes", "uv": "@uv1" } }
  ],
  "surface": {
    "baseColor": "paint.rgb", "normalTS": "bumps", "emission": "$_Glow.rgb", "alpha": "holes.r", "alphaClip": "$_Cut"
  },
  "render": { "surface": ")" + render + R"(" }
})");
}

Words inputs_of(const Pass& pass) {
    Words names;
    for (const VertexInput& input : pass.vertex_inputs) names.push_back(input.name);
    return names;
}

bool reads_material(const Result& result, const Pass& pass) {
    return std::any_of(result.reflection.blocks.begin(), result.reflection.blocks.end(),
                       [&](const Block& block) { return block.is_material && has(pass.blocks, block.name); });
}

struct Depth {
    Result result;
    Pass pass;
};
Depth compiled_depth(const std::string& surface, const std::string& name) {
    const bool is_caster = name == "shadow-caster";
    Depth depth{.result = compiled(rich_graph(surface, surface), is_caster ? "forward" : name,
                                   {{"shadows", is_caster ? "true" : "false"}}),
                .pass = {}};
    const Pass* pass = find_pass(depth.result, name);
    EXPECT_TRUE(pass) << name;
    if (pass) depth.pass = *pass;
    return depth;
}

TEST(Pruning, OpaqueDepthReadsNothingOfTheMaterial) {
    for (const char* name : {"shadow-caster", "depth-only"}) {
        SCOPED_TRACE(name);
        const Depth depth = compiled_depth("opaque", name);
        EXPECT_EQ(depth.pass.textures, Words{});
        EXPECT_FALSE(reads_material(depth.result, depth.pass));
        EXPECT_FALSE(has(depth.pass.blocks, "Lights"));
        EXPECT_FALSE(has(depth.pass.blocks, "Ambient"));
        // The caster moves surfaces along their normals.
        const bool is_caster = depth.pass.name == "shadow-caster";
        EXPECT_EQ(inputs_of(depth.pass), is_caster ? (Words{"positionOS", "normalOS"}) : Words{"positionOS"});
        EXPECT_TRUE(depth.pass.targets.empty());
    }
}

TEST(Pruning, CutoutDepthReadsWhatAlphaNeeds) {
    for (const char* name : {"shadow-caster", "depth-only"}) {
        SCOPED_TRACE(name);
        const Depth depth = compiled_depth("cutout", name);
        EXPECT_EQ(depth.pass.textures, Words{"_Holes"});
        EXPECT_TRUE(reads_material(depth.result, depth.pass));  // _Cut
        EXPECT_FALSE(has(depth.pass.blocks, "Lights"));
        const bool is_caster = depth.pass.name == "shadow-caster";
        EXPECT_EQ(inputs_of(depth.pass),
                  is_caster ? (Words{"positionOS", "normalOS", "uv1"}) : (Words{"positionOS", "uv1"}));
    }
}

// The pass that shows the material does read all of it.
TEST(Pruning, ForwardReadsAllOfIt) {
    const Depth depth = compiled_depth("cutout", "forward");
    for (const char* texture : {"_Paint", "_Bumps", "_Holes"})
        EXPECT_TRUE(has(depth.pass.textures, texture)) << texture;
    EXPECT_TRUE(has(depth.pass.blocks, "Lights"));
}

// The G-buffer knows no light, and lighting passes nothing of the material: its textures were sampled once.
TEST(Pruning, DeferredSamplesTheMaterialOnce) {
    const Result result = compiled(rich_graph("opaque", "opaque"), "deferred");
    int lighting_passes = 0;
    for (const Pass& pass : result.reflection.passes) {
        SCOPED_TRACE(pass.name);
        const bool is_gbuffer = pass.name == "gbuffer";
        EXPECT_EQ(has(pass.textures, "_Paint"), is_gbuffer);
        EXPECT_EQ(has(pass.textures, "_Bumps"), is_gbuffer);
        EXPECT_FALSE(has(pass.textures, "_Holes"));  // an opaque surface
        EXPECT_EQ(reads_material(result, pass), is_gbuffer);
        EXPECT_EQ(has(pass.blocks, "Lights"), pass.each == PassEach::Light);
        lighting_passes += !is_gbuffer;
    }
    EXPECT_GE(lighting_passes, 2);
}

// Where there is no lighting, no pass adds light.
TEST(Pruning, UnlitHasNoPassThatAddsNothing) {
    const std::string unlit = written("unlit_only.graph.json", R"({ "patina": 1, "workflow": "unlit" })");
    const auto passes = [&](const std::string& path) {
        Words names;
        for (const Pass& pass : compiled(unlit, path).reflection.passes) names.push_back(pass.name);
        return names;
    };
    EXPECT_EQ(passes("deferred"), Words{"gbuffer"});
    EXPECT_EQ(passes("deferred-extended"), Words{"gbuffer-extended"});
    EXPECT_EQ(passes("deferred-ldr"), (Words{"gbuffer-ldr", "ldr-resolve"}));
    EXPECT_EQ(passes("deferred-shadowmask"), Words{"gbuffer-shadowmask"});
    EXPECT_EQ(passes("forward-add"), Words{"forward-base"});
    EXPECT_EQ(passes("forward-directional"), Words{"directional-base"});
    // A light that is not used still lets the pass draw that shows everything else.
    const std::string dark = written("no_sum.graph.json", R"({ "patina": 1, "workflow": "metallic-roughness",
  "lighting": { "direct": [1, 1, 1], "final": "@surface.emission" }, "surface": { "emission": 0.5 } })");
    EXPECT_TRUE(find_pass(compiled(dark, "forward-add"), "forward-base"));
    EXPECT_TRUE(find_pass(compiled(dark, "deferred"), "gbuffer"));
}

// Every further light pays for its own light: emission and ambient light are the base pass's.
TEST(Pruning, AdditivePassesHaveNoAmbientLightAndNoEmission) {
    const Result result = compiled(rich_graph("opaque", "opaque"), "forward-add");
    const Pass *base = find_pass(result, "forward-base"), *add = find_pass(result, "forward-add");
    ASSERT_TRUE(base && add);
    EXPECT_TRUE(has(base->blocks, "Ambient"));
    EXPECT_FALSE(has(add->blocks, "Ambient"));
    EXPECT_TRUE(reads_material(result, *base));  // _Glow
    EXPECT_FALSE(reads_material(result, *add));
}

// --- parts of lighting graphs

// Every input of the surface varies, so that no number in the graph is zero.
std::string varying_graph(const ModelInfo& model) {
    const std::vector<ModelInfo>& workflows = compiler().workflows();
    const ModelInfo& workflow = *std::ranges::find(workflows, "metallic-roughness", &ModelInfo::name);
    std::string properties, surface;
    for (const std::vector<ModelInputInfo>* inputs : {&workflow.inputs, &model.inputs}) {
        for (const ModelInputInfo& input : *inputs) {
            if (!input.gives.empty() || input.default_value.find('@') != std::string::npos) continue;
            const char* comma = properties.empty() ? "" : ", ";
            properties += fmt::format(R"({}{{ "name": "_{}", "type": "{}" }})", comma, input.name,
                                      input.type == "color3" ? "color" : input.type);
            surface += fmt::format(R"({}"{}": "= $_{}{} * @uv0.x")", comma, input.name, input.name,
                                   input.type == "color3" ? ".rgb" : "");
        }
    }
    return written("varying-" + model.name + ".graph.json",
                   fmt::format(R"({{ "patina": 1, "workflow": "metallic-roughness", "lighting": "{}",
                                    "properties": [ {} ], "surface": {{ {} }} }})",
                               model.name, properties, surface));
}

const Shader* find_shader(const Result& result, const std::string& pass, Stage stage) {
    for (const Shader& shader : result.shaders) {
        if (shader.pass == pass && shader.stage == stage && shader.target == Target::Glsl) return &shader;
    }
    return nullptr;
}

// What is written behind the `=` of lines that multiply by a zero that is written out.
Words products_with_zero(const std::string& text) {
    static const std::string zero = R"((0\.0|vec[234]\(0\.0\)))";
    static const std::regex product("(^|[^\\w.])" + zero + " \\*|\\*=? " + zero + "($|[^\\d])");
    Words found;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_search(line, product)) found.push_back(line.substr(line.find('=') + 1));
    }
    return found;
}

TEST(Pruning, SeesProductsWithZero) {
    for (const char* line : {"vec3 a = setup.f0 * 0.0;", "b += (vec3(0.0) * (c * d) + e) * f;", "0.0 * ambient * 0.7",
                             "a *= vec3(0.0);", "a *= 0.0;"})
        EXPECT_EQ(products_with_zero(line).size(), 1u) << line;
    for (const char* line :
         {"a * 0.05 + 10.0 * b", "max(a, 0.0) * b", "vec3(0.0, 1.0, 0.0) + a", "a0.0", "0.0 + a * b"})
        EXPECT_EQ(products_with_zero(line).size(), 0u) << line;
}

// What a slot is without something is computed without it, not with a zero in its place.
TEST(Pruning, NothingIsMultipliedByZero) {
    int stages = 0;
    for (const ModelInfo& model : compiler().lighting_models()) {
        // A lighting graph may say so itself: Disney's clear coat is a lobe with an anisotropy of 0.
        Words own;
        for (const Shader& shader : compiled(varying_graph(model), "forward").shaders) {
            for (std::string& product : products_with_zero(shader.text)) own.push_back(std::move(product));
        }
        EXPECT_LE(own.size(), model.name == "disney-principled" ? 2u : 0u) << model.name;
        for (const char* path : {"vertex", "deferred"}) {
            for (const Shader& shader : compiled(varying_graph(model), path).shaders) {
                for (const std::string& product : products_with_zero(shader.text))
                    EXPECT_TRUE(has(own, product))
                        << model.name << ", " << shader.pass << ", " << to_string(shader.stage) << ": " << product;
                ++stages;
            }
        }
    }
    EXPECT_GT(stages, 60);
}

// Its reflections are added later, with the table of what they are multiplied by.
TEST(Pruning, GBuffersHaveNoReflectionsThatComeLater) {
    const auto& models = compiler().lighting_models();
    const ModelInfo& model = *std::ranges::find(models, "cook-torrance", &ModelInfo::name);
    const Result result = compiled(varying_graph(model), "deferred");
    const Pass *gbuffer = find_pass(result, "gbuffer"), *later = find_pass(result, "deferred-reflections");
    ASSERT_TRUE(gbuffer && later);
    for (const char* texture : {"splitSumTable", "environmentMap"}) {
        EXPECT_FALSE(has(gbuffer->textures, texture)) << texture;
        EXPECT_TRUE(has(later->textures, texture)) << texture;
    }
}

std::size_t count(const std::string& text, std::string_view what) {
    std::size_t n = 0;
    for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++n;
    return n;
}

// One loop, whether or not light is split into what the diffuse colour multiplies and the rest; so shadows are sampled
// once for each light.
TEST(Pruning, VerticesEvaluateEachLightOnce) {
    for (const ModelInfo& model : compiler().lighting_models()) {
        for (const char* shadows : {"false", "true"}) {
            SCOPED_TRACE(model.name + ", shadows " + shadows);
            const Result result = compiled(varying_graph(model), "vertex", {{"shadows", shadows}});
            // What was drawn before can be read per pixel only: transmission makes such a material another path's.
            const bool reads_picture = model.name == "gltf" || model.name == "openpbr";
            ASSERT_EQ(result.reflection.path, reads_picture ? "forward" : "vertex");
            if (reads_picture) continue;
            const Shader* vertex = find_shader(result, "vertex", Stage::Vertex);
            ASSERT_TRUE(vertex);
            const std::size_t lights = model.name == "unlit" ? 0 : 1;
            EXPECT_EQ(count(vertex->text, "= lightAt("), lights) << vertex->text;
        }
    }
}

// Lambert's light is all diffuse. That the rest is zero need not be handed over.
TEST(Pruning, VerticesHandOverNoConstants) {
    for (const char* name : {"lambert", "half-lambert"}) {
        const auto& models = compiler().lighting_models();
        const Result result = compiled(varying_graph(*std::ranges::find(models, name, &ModelInfo::name)), "vertex");
        for (const Stage stage : {Stage::Vertex, Stage::Fragment}) {
            const Shader* shader = find_shader(result, "vertex", stage);
            ASSERT_TRUE(shader);
            EXPECT_GT(count(shader->text, "vLightByDiffuse"), 0u) << shader->text;
            EXPECT_EQ(count(shader->text, "vOther"), 0u) << shader->text;
        }
    }
}

}  // namespace
}  // namespace patina::paths
