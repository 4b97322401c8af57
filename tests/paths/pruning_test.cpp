// Each pass has what it needs and nothing more: read off the reflection, which both shaders of a pass are bound by.
#include <algorithm>

#include "paths/drawing.h"

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
    "baseColor": "paint.rgb", "normal_ts": "bumps", "emission": "$_Glow.rgb", "alpha": "holes.r", "alphaClip": "$_Cut"
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
        EXPECT_EQ(inputs_of(depth.pass), is_caster ? (Words{"position_os", "normal_os"}) : Words{"position_os"});
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
                  is_caster ? (Words{"position_os", "normal_os", "uv1"}) : (Words{"position_os", "uv1"}));
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
        EXPECT_EQ(has(pass.blocks, "Lights"), pass.each == "light");
        lighting_passes += !is_gbuffer;
    }
    EXPECT_GE(lighting_passes, 2);
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

}  // namespace
}  // namespace patina::paths
