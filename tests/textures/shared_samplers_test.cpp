// Textures that share samplers: "sampler": "trilinearRepeat".
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "tests/textures/drawn.h"

namespace patina::runtime {
namespace {

class SharedSamplers : public testing::TestWithParam<std::string> {};

// The engine has 64 samplers in a stage. Each texture counts: they hold 1/255, 2/255 and so on.
constexpr int kMany = 72;

std::string many(const std::string& sampler) {
    std::string properties, sum;
    for (int i = 0; i < kMany; ++i) {
        properties += fmt::format(R"({}{{ "name": "_T{}", "type": "texture2d", "usage": "data"{} }})",
                                  i == 0 ? "" : ", ", i, sampler);
        sum += fmt::format("{}SampleTexture2D($_T{}).r", i == 0 ? "" : " + ", i);
    }
    return R"("properties": [ )" + properties + R"( ], "nodes": [ { "id": "sum", "expr": ")" + sum +
           fmt::format(R"(" }} ], "surface": {{ "color": "= sum / {}" }})", kMany);
}

TEST_P(SharedSamplers, ServeMoreTexturesThanThereAreSamplers) {
    std::map<std::string, std::string> files;
    double sum = 0;
    for (int i = 0; i < kMany; ++i) {
        const float value = static_cast<float>(i + 1) / 255;
        files[fmt::format("_T{}", i)] = png_of(fmt::format("value{}", i), 1, 1, {{value, 0, 0, 1}});
        sum += (i + 1) / 255.0;
    }
    const Image seen = drawn(GetParam(), "many", many(R"(, "sampler": "trilinearRepeat")"), files);
    expect_at(seen, 0, 0, {sum / kMany, sum / kMany, sum / kMany}, "the mean of all textures");
}

// Two columns, 0.2 and 0.8. At u = 1.25, a texture that repeats shows the first, and one that is clamped the second; at
// u = 0.5, one that filters shows their mean.
TEST_P(SharedSamplers, KeepTheirStates) {
    const std::string file = png_of("columns", 2, 1, {{0.2f, 0.2f, 0.2f, 1}, {0.8f, 0.8f, 0.8f, 1}});
    std::string properties;
    std::map<std::string, std::string> files;
    int count = 0;
    for (const char* sampler :
         {"nearestRepeat", "nearestClamp", "trilinearRepeat", "nearestRepeat", "nearestClamp", "trilinearRepeat"}) {
        const std::string name = fmt::format("_T{}", count++);
        properties += fmt::format(R"({}{{ "name": "{}", "type": "texture2d", "usage": "data", "sampler": "{}" }})",
                                  count == 1 ? "" : ", ", name, sampler);
        files[name] = file;
    }
    const Image seen = drawn(GetParam(), "states", R"("properties": [ )" + properties + R"j( ], "nodes": [
          { "id": "a", "expr": "SampleTexture2DLevel($_T3, float2(1.25, 0))"
},
          { "id": "b", "expr": "SampleTexture2DLevel($_T4, float2(1.25, 0))" },
          { "id": "c", "expr": "SampleTexture2DLevel($_T5, float2(0.5, 0))" },
          { "id": "d", "expr": "SampleTexture2DLevel($_T0, float2(1.25, 0))" },
          { "id": "e", "expr": "SampleTexture2DLevel($_T1, float2(1.25, 0))" },
          { "id": "f", "expr": "SampleTexture2DLevel($_T2, float2(0.5, 0))" } ],
        "surface": { "color": "= @uv0.x < 0.5 ? float3(a.r, b.r, c.r) : float3(d.r, e.r, f.r)" })j",
                             files);
    expect_at(seen, 0, 0, {0.2, 0.8, 0.5}, "the second textures");
    expect_at(seen, 1, 0, {0.2, 0.8, 0.5}, "the first textures");
}

INSTANTIATE_TEST_SUITE_P(Via, SharedSamplers, testing::Values("glsl", "hlsl", "cpu"));

Result compiled(const std::string& graph, std::vector<Target> targets) {
    static const Compiler compiler;
    const std::string path = testing::TempDir() + "compiled.graph.json";
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

TEST(SharedSamplers, AreDeclaredOnceAndNamedByTheReflection) {
    const Result made = compiled(many(R"(, "sampler": "trilinearRepeat")"), {Target::Glsl, Target::Hlsl});
    ASSERT_TRUE(made.ok);
    for (const Shader& shader : made.shaders) {
        if (shader.stage != Stage::Fragment) continue;
        const bool is_glsl = shader.target == Target::Glsl;
        EXPECT_EQ(count_of(shader.text, is_glsl ? "uniform sampler trilinearRepeat;" : "SamplerState trilinearRepeat "),
                  1U);
        EXPECT_EQ(count_of(shader.text, is_glsl ? "uniform sampler " : "SamplerState "), 1U);
    }
    std::set<std::uint32_t> textures, samplers;
    for (const Texture& texture : made.reflection.textures) {
        if (!texture.is_material) continue;
        EXPECT_EQ(texture.sampler_name, "trilinearRepeat");
        EXPECT_EQ(texture.sampler, Sampler{});
        textures.insert(texture.binding);
        samplers.insert(texture.sampler_binding);
    }
    EXPECT_EQ(textures.size(), std::size_t(kMany));
    EXPECT_EQ(samplers.size(), 1U);
    EXPECT_FALSE(textures.contains(*samplers.begin()));
}

TEST(SharedSamplers, OfTheirOwnAreTooMany) {
    const Result made = compiled(many(""), {Target::Glsl});
    ASSERT_FALSE(made.ok);
    ASSERT_EQ(made.diagnostics.size(), 1U);
    EXPECT_EQ(made.diagnostics[0].code, "too-many");
    EXPECT_EQ(made.diagnostics[0].message, "72 samplers in one stage are too many: the limit is 64");
}

// In Unity, the asset of a texture sets its sampler.
TEST(SharedSamplers, AreNotSharedInUnity) {
    const std::string two = R"("properties": [
        { "name": "_A", "type": "texture2d", "sampler": "nearestClamp" },
        { "name": "_B", "type": "texture2d", "sampler": "nearestClamp" } ],
      "surface": { "color": "= SampleTexture2D($_A).rgb * SampleTexture2D($_B).rgb" })";
    const Result made = compiled(two, {{"unity", "hlsl"}});
    ASSERT_TRUE(made.ok);
    ASSERT_EQ(made.diagnostics.size(), 2U);
    for (const Diagnostic& each : made.diagnostics) EXPECT_EQ(each.code, "no-sampler");
    for (const char* name : {"_A", "_B"})
        EXPECT_EQ(count_of(made.shaders[0].text, fmt::format("UNITY_DECLARE_TEX2D({});", name)), 1U) << name;
}

// Each name says what it is.
TEST(SharedSamplers, HaveTheStateThatTheirNamesSay) {
    for (const char* filter : {"trilinear", "nearest", "anisotropic4", "anisotropic16"}) {
        for (const char* wrap : {"Repeat", "Clamp", "Mirror"}) {
            const Result made = compiled(fmt::format(R"("properties": [ {{ "name": "_A", "type": "texture2d",
                "sampler": "{}{}" }} ], "surface": {{ "color": "= SampleTexture2D($_A).rgb" }})",
                                                     filter, wrap),
                                         {Target::Glsl});
            ASSERT_TRUE(made.ok) << filter << wrap;
            const Sampler& sampler = made.reflection.textures[0].sampler;
            const std::string_view word = filter;
            EXPECT_EQ(sampler.filter, word == "nearest" ? Filter::Nearest : Filter::Linear);
            EXPECT_EQ(sampler.anisotropy, word == "anisotropic4" ? 4 : word == "anisotropic16" ? 16 : 1);
            std::string lower(wrap);
            lower[0] = static_cast<char>(lower[0] - 'A' + 'a');
            EXPECT_EQ(to_string(sampler.wrap), lower);
        }
    }
}

}  // namespace
}  // namespace patina::runtime
