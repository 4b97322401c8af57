// Samplers as values: properties, words at ports, inputs of sub-graphs and parameters of functions.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "tests/textures/drawn.h"

namespace patina::runtime {
namespace {

class SamplerValues : public testing::TestWithParam<std::string> {};

// Two columns, 0.2 and 0.8. At u = 1.25, a texture that repeats shows the first one, and one that is clamped or
// mirrored the second; at u = 0.5, one that filters shows their mean, and one that does not shows the second.
std::string columns() {
    return png_of("sampler_columns", 2, 1, {{0.2f, 0.2f, 0.2f, 1}, {0.8f, 0.8f, 0.8f, 1}});
}

void keep(const std::string& file, const std::string& text) {
    std::ofstream(testing::TempDir() + file) << text;
}

constexpr const char* kTexture = R"("name": "_T", "type": "texture2d", "usage": "data", "sampler": "nearestRepeat")";

TEST_P(SamplerValues, TakeThePlaceOfTheTexturesOwn) {
    const std::string graph = fmt::format(R"x("properties": [ {{ {} }} ], "nodes": [
        {{ "id": "own", "node": "SampleTexture2DLevel", "in": {{ "texture": "$_T", "uv": [1.25, 0] }} }},
        {{ "id": "clamped", "node": "SampleTexture2DLevel",
          "in": {{ "texture": "$_T", "uv": [1.25, 0], "sampler": "nearestClamp" }} }},
        {{ "id": "filtered", "expr": "SampleTexture2DLevel($_T, float2(0.5, 0), 0, trilinearRepeat)" }} ],
      "surface": {{ "color": "= float3(own.r, clamped.r, filtered.r)" }})x",
                                          kTexture);
    expect_at(drawn(GetParam(), "own", graph, {{"_T", columns()}}), 0, 0, {0.2, 0.8, 0.5}, "own, clamped, filtered");
}

TEST_P(SamplerValues, ArePropertiesThatCanBeSet) {
    const std::string graph = fmt::format(R"x("properties": [
        {{ "name": "_Edge", "type": "sampler", "default": "nearestClamp" }},
        {{ {} }},
        {{ "name": "_Filter", "type": "sampler" }} ],
      "nodes": [
        {{ "id": "edge", "node": "SampleTexture2DLevel",
          "in": {{ "texture": "$_T", "uv": [1.25, 0], "sampler": "$_Edge" }} }},
        {{ "id": "filter", "node": "SampleTexture2DLevel",
          "in": {{ "texture": "$_T", "uv": [0.5, 0], "sampler": "$_Filter" }} }} ],
      "surface": {{ "color": "= float3(edge.r, filter.r, 0)" }})x",
                                          kTexture);
    expect_at(drawn(GetParam(), "defaults", graph, {{"_T", columns()}}), 0, 0, {0.8, 0.5, 0}, "the defaults");
    expect_at(
        drawn(GetParam(), "set", graph, {{"_T", columns()}, {"_Edge", "nearestRepeat"}, {"_Filter", "nearestMirror"}}),
        0, 0, {0.2, 0.8, 0}, "other values");
}

TEST_P(SamplerValues, GoIntoSubGraphsAndFunctions) {
    keep("edge.node.hlsl", R"x(/// One texel.
[node("Test/Edge")]
float ReadEdge(Texture2D picture, SamplerState how = picture.sampler) {
    return picture.SampleLevel(how, float2(1.25, 0), 0).r;
}
)x");
    keep("edge.subgraph.json", R"x({ "patina": 1, "kind": "subgraph",
  "inputs": [ { "name": "picture", "type": "texture2d" }, { "name": "how", "type": "sampler", "default": "nearestClamp" } ],
  "nodes": [ { "id": "read", "node": "./edge.node.hlsl", "in": { "picture": "$picture", "how": "$how" } } ],
  "outputs": { "out": "read", "mirrored": "nearestMirror" } })x");
    const std::string graph = fmt::format(R"x("properties": [ {{ {} }} ], "nodes": [
        {{ "id": "a", "node": "./edge.subgraph.json", "in": {{ "picture": "$_T" }} }},
        {{ "id": "b", "node": "./edge.subgraph.json", "in": {{ "picture": "$_T", "how": "nearestRepeat" }} }},
        {{ "id": "how", "expr": "nearestMirror" }},
        {{ "id": "c", "node": "./edge.subgraph.json", "in": {{ "picture": "$_T", "how": "how" }} }},
        {{ "id": "d", "node": "./edge.node.hlsl", "in": {{ "picture": "$_T" }} }},
        {{ "id": "e", "node": "./edge.node.hlsl", "in": {{ "picture": "$_T", "how": "a.mirrored" }} }} ],
      "surface": {{ "color": "= @uv0.x < 0.5 ? float3(a.out, b.out, c.out) : float3(d, e, 0)" }})x",
                                          kTexture);
    const Image seen = drawn(GetParam(), "parts", graph, {{"_T", columns()}});
    expect_at(seen, 0, 0, {0.8, 0.2, 0.8}, "the default, repeated, mirrored");
    expect_at(seen, 1, 0, {0.2, 0.8, 0}, "the texture's own, and what a sub-graph gives");
}

INSTANTIATE_TEST_SUITE_P(Via, SamplerValues, testing::Values("glsl", "hlsl", "cpu"));

Result compiled(const std::string& graph, std::vector<Target> targets) {
    static const Compiler compiler;
    const std::string path = testing::TempDir() + "sampler_values.graph.json";
    std::ofstream(path) << R"({ "patina": 1, "workflow": "unlit", )" << graph << " }";
    CompileOptions options;
    options.targets = std::move(targets);
    return compiler.compile_file(path, options);
}

std::size_t count_of(const std::string& text, std::string_view part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
    return count;
}

constexpr const char* kTwo = R"("properties": [
    { "name": "_A", "type": "texture2d", "sampler": "nearestClamp" },
    { "name": "_B", "type": "texture2d" },
    { "name": "_How", "type": "sampler", "default": "trilinearMirror" } ],
  "nodes": [
    { "id": "a", "node": "SampleTexture2D", "in": { "texture": "$_A" } },
    { "id": "b", "node": "SampleTexture2D", "in": { "texture": "$_B", "sampler": "nearestClamp" } },
    { "id": "c", "node": "SampleTexture2D", "in": { "texture": "$_B", "sampler": "$_How" } } ],
  "surface": { "color": "= a.rgb * b.rgb * c.rgb" })";

// The word at the port and the word of a texture are one sampler.
TEST(SamplerValues, AreBoundAsTheReflectionSays) {
    const Result made = compiled(kTwo, {Target::Glsl, Target::Hlsl});
    ASSERT_TRUE(made.ok);
    EXPECT_TRUE(made.diagnostics.empty());
    const std::vector<BoundSampler>& samplers = made.reflection.samplers;
    ASSERT_EQ(samplers.size(), 2U);
    const auto named = [&](const char* name) {
        return *std::find_if(samplers.begin(), samplers.end(), [&](const auto& each) { return each.name == name; });
    };
    const BoundSampler how = named("_How"), clamp = named("nearestClamp");
    EXPECT_TRUE(how.is_property);
    EXPECT_FALSE(clamp.is_property);
    EXPECT_EQ(how.sampler, (Sampler{.wrap = Wrap::Mirror}));
    EXPECT_EQ(made.reflection.textures[0].sampler_binding, clamp.binding);
    EXPECT_NE(made.reflection.textures[1].sampler_binding, clamp.binding);
    ASSERT_EQ(made.reflection.properties.size(), 3U);
    EXPECT_EQ(made.reflection.properties[2].sampler, how.sampler);
    std::set<std::uint32_t> bindings;
    for (const Texture& texture : made.reflection.textures)
        if (texture.is_material) bindings.insert({texture.binding, texture.sampler_binding});
    for (const BoundSampler& each : samplers) bindings.insert(each.binding);
    EXPECT_EQ(bindings.size(), 5U) << "two textures, and the samplers _How, nearestClamp and that of _B";
    for (const Pass& pass : made.reflection.passes) {
        if (pass.name != "forward") continue;
        EXPECT_EQ(pass.samplers.size(), 2U);
        EXPECT_EQ(std::count(pass.fragment_reads.begin(), pass.fragment_reads.end(), "_How"), 1);
    }
    for (const Shader& shader : made.shaders) {
        if (shader.stage != Stage::Fragment) continue;
        const bool is_glsl = shader.target == Target::Glsl;
        for (const std::string name : {"_How", "nearestClamp"})
            EXPECT_EQ(count_of(shader.text, is_glsl ? "uniform sampler " + name + ";" : "SamplerState " + name + " "),
                      1U)
                << shader.text;
        // Nothing reads _B by its own.
        EXPECT_EQ(count_of(shader.text, "sampler_B"), 0U);
    }
    const ReadReflection read = Reflection::from_json(made.reflection.to_json());
    ASSERT_TRUE(read.ok);
    EXPECT_EQ(read.reflection.to_json(), made.reflection.to_json());
    EXPECT_EQ(read.reflection.properties[2].sampler, how.sampler);
}

// Unity makes a sampler by its name.
TEST(SamplerValues, AreInlineSamplersInUnity) {
    const Result made = compiled(kTwo, {{"unity", "hlsl"}});
    ASSERT_TRUE(made.ok);
    const auto is_fixed = [](const Diagnostic& each) { return each.code == "fixed-sampler"; };
    EXPECT_EQ(std::count_if(made.diagnostics.begin(), made.diagnostics.end(), is_fixed), 1);
    const std::string& text = made.shaders[0].text;
    for (const char* part :
         {"UNITY_DECLARE_TEX2D(_A);", "UNITY_DECLARE_TEX2D_NOSAMPLER(_B);", "DECLARE_SAMPLER(_point_clamp)",
          "DECLARE_SAMPLER(_trilinear_mirror)", "UNITY_SAMPLE_TEX2D_SAMPLER(_B, _point_clamp, ",
          "UNITY_SAMPLE_TEX2D_SAMPLER(_B, _trilinear_mirror, ", "UNITY_SAMPLE_TEX2D(_A, "})
        EXPECT_NE(text.find(part), text.npos) << part << "\n" << text;
}

}  // namespace
}  // namespace patina::runtime
