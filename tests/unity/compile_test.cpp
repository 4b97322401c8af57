// Every pass of the examples' ShaderLab files, in every combination of keywords that Unity would compile and that makes
// a difference to it, is accepted by a compiler of HLSL, over stand-ins for Unity's includes: with textures that have
// samplers beside them, and with DirectX 9's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <sstream>

#include "patina/validate.h"
#include "unity/compiled.h"
#include "unity/shader_lab.h"

namespace patina::unity {
namespace {

namespace fs = std::filesystem;
using Keywords = std::vector<std::string>;

const std::map<std::string, std::vector<Keywords>>& variants() {
    static const std::map<std::string, std::vector<Keywords>> kVariants = {
        {"ForwardBase",
         {{"DIRECTIONAL"},
          {"DIRECTIONAL", "UNITY_COLORSPACE_GAMMA", "FOG_LINEAR"},
          {"DIRECTIONAL", "LIGHTPROBE_SH", "SHADOWS_SCREEN", "VERTEXLIGHT_ON", "INSTANCING_ON"},
          {"DIRECTIONAL", "LIGHTMAP_ON", "SHADOWS_SCREEN", "FOG_EXP2", "STAND_IN_2017"},
          {"DIRECTIONAL", "LIGHTMAP_ON", "DYNAMICLIGHTMAP_ON", "DIRLIGHTMAP_COMBINED", "UNITY_SPECCUBE_BOX_PROJECTION"},
          {"DIRECTIONAL", "UNITY_SPECCUBE_BLENDING", "STAND_IN_2017"}}},
        {"", {{}, {"UNITY_COLORSPACE_GAMMA", "FOG_LINEAR"}, {"FOG_EXP2", "INSTANCING_ON", "STAND_IN_2017"}}},
        {"ForwardAdd",
         {{"POINT"},
          {"POINT", "STAND_IN_2017", "FOG_LINEAR"},
          {"SPOT", "SHADOWS_SCREEN", "FOG_EXP", "INSTANCING_ON"},
          {"DIRECTIONAL", "UNITY_COLORSPACE_GAMMA"},
          {"POINT_COOKIE"}}},
        {"Meta", {{}, {"UNITY_COLORSPACE_GAMMA"}}},
        {"ShadowCaster", {{"SHADOWS_DEPTH"}, {"SHADOWS_CUBE"}, {"SHADOWS_DEPTH", "INSTANCING_ON"}}},
        {"Deferred",
         {{},
          {"UNITY_HDR_ON", "LIGHTPROBE_SH", "INSTANCING_ON"},
          {"LIGHTMAP_ON", "SHADOWS_SHADOWMASK", "UNITY_HDR_ON"},
          {"UNITY_COLORSPACE_GAMMA", "UNITY_ENABLE_REFLECTION_BUFFERS"}}}};
    return kVariants;
}

std::vector<std::string> examples() {
    std::vector<std::string> files;
    for (const char* folder : {"examples/graphs", "examples/sources", "examples/surfaces", "tests/unity/graphs",
                               "tests/graphs", "tests/snapshots"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
            const std::string path = entry.path().string();
            const bool is_refused = path.find("reserved-names") != path.npos;  // names_test.cpp
            if (path.ends_with(".graph.json") && !is_refused) files.push_back(path);
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string words(const Keywords& keywords) {
    std::string text;
    for (const std::string& keyword : keywords) text += " " + keyword;
    return text;
}

// Every combination of the material's own keywords.
std::vector<Keywords> features(const LabPass& pass) {
    std::vector<Keywords> made = {{}};
    for (const std::string& pragma : pass.pragmas) {
        std::istringstream in(pragma);
        std::string word;
        in >> word;
        if (word != "shader_feature_local") continue;
        Keywords choices;
        while (in >> word) choices.push_back(word);
        if (choices.size() == 1) choices.emplace_back();  // it may be off
        std::vector<Keywords> longer;
        for (const Keywords& keywords : made) {
            for (const std::string& choice : choices) {
                longer.push_back(keywords);
                if (!choice.empty()) longer.back().push_back(choice);
            }
        }
        made = std::move(longer);
    }
    if (made.size() == 1) made.clear();
    return made;
}

// Texels that are counted need hardware whose textures have their samplers beside them: Unity compiles a program for
// shader model 3.5 and up for no other.
bool counts_texels(const LabPass& pass) {
    const bool counts =
        pass.program.find(".Load(") != pass.program.npos || pass.program.find(".GetDimensions(") != pass.program.npos;
    if (counts) {
        EXPECT_EQ(pass.pragmas.front(), "target 3.5");
    }
    return counts;
}

// Unity sets keywords only for passes that name them.
bool has_keyword_of_light(const LabPass& pass) {
    return std::any_of(pass.pragmas.begin(), pass.pragmas.end(),
                       [](const std::string& pragma) { return pragma.starts_with("multi_compile_fwd"); });
}

void expect_accepted(const LabPass& pass, const Result& result, Keywords keywords) {
    if (!has_keyword_of_light(pass)) std::erase(keywords, "DIRECTIONAL");
    for (const bool is_dx9 : {false, true}) {
        if (is_dx9 && counts_texels(pass)) continue;
        if (is_dx9) keywords.emplace_back("STAND_IN_DX9");
        for (const Stage which : {Stage::Vertex, Stage::Fragment}) {
            const Shader shader = stage(pass, result.reflection, which, keywords, Values::OfFile);
            const Validated validated = validate(shader, HlslSamplers::Combined);
            ASSERT_TRUE(validated.ok) << pass.light_mode << words(keywords) << "\n"
                                      << validated.log << result.shaders.back().text;
        }
    }
}

class UnityExample : public testing::TestWithParam<std::string> {};

void expect_accepted(const Result& result) {
    ASSERT_TRUE(result.ok) << to_text(first_error(result));
    const ShaderLab file = taken_apart(result.shaders.back().text);
    ASSERT_TRUE(file.forward());
    for (const LabPass& pass : file.passes) {
        ASSERT_TRUE(variants().contains(pass.light_mode)) << pass.light_mode;
        for (const Keywords& keywords : variants().at(pass.light_mode)) {
            expect_accepted(pass, result, keywords);
        }
        for (Keywords keywords : features(pass)) {
            const Keywords& usual = variants().at(pass.light_mode).front();
            keywords.insert(keywords.end(), usual.begin(), usual.end());
            expect_accepted(pass, result, keywords);
        }
    }
}

void expect_compiles(const std::string& graph, const std::string& path) {
    CompileOptions options;
    options.targets = {{"unity", "hlsl"}};
    options.request = CompileOptions::Passes{.path = path};
    const Result result = compiler().compile_file(graph, options);
    for (const Diagnostic& d : result.diagnostics) {
        if (d.code != "pass-left-out" && d.code != "no-file-default" && d.code != "no-sampler" &&
            d.code != "fixed-sampler" && d.code != "no-default")
            ADD_FAILURE() << to_text(d);
    }
    expect_accepted(result);
}

TEST_P(UnityExample, CompilesInEveryVariant) {
    expect_compiles(GetParam(), "forward");
}

// The shaders of the documents that are lit at the vertices, and one with most of what a surface can have.
TEST(UnityVertexLit, CompilesInEveryVariant) {
    for (const char* graph : {"examples/sources/diffuse-pixel-level.graph.json",
                              "examples/sources/specular-pixel-level.graph.json", "examples/graphs/ivy.graph.json",
                              "tests/unity/graphs/standard.graph.json", "tests/unity/graphs/fade.graph.json",
                              "tests/unity/graphs/override.graph.json", "tests/unity/graphs/wave.graph.json",
                              "tests/unity/graphs/passes.graph.json", "tests/unity/graphs/tiers_passes.graph.json"}) {
        SCOPED_TRACE(graph);
        expect_compiles(graph, "vertex");
    }
}

TEST(UnityTiers, CompileInEveryVariant) {
    for (const char* graph : {"examples/sources/standard.graph.json", "tests/unity/graphs/standard.graph.json",
                              "tests/unity/graphs/fade.graph.json", "tests/unity/graphs/transparent.graph.json",
                              "tests/unity/graphs/override.graph.json", "tests/unity/graphs/tiers_passes.graph.json"}) {
        SCOPED_TRACE(graph);
        expect_compiles(graph, "tiers");
    }
}

std::string texture_name(int i) {
    return "_T" + std::to_string(i);
}

// A material with textures "_T0", ... of which the base colour reads all.
std::string with_textures(int count, const std::string& keys, const std::string& rest) {
    std::string properties, sum;
    for (int i = 0; i < count; ++i) {
        const std::string separator = i == 0 ? "" : ", ";
        properties += separator + R"({ "name": ")" + texture_name(i) + R"(", "type": "texture2d")" + keys + " }";
        sum += (i == 0 ? "" : " + ") + ("SampleTexture2D($" + texture_name(i) + ").rgb");
    }
    return R"({ "patina": 1, "workflow": "metallic-smoothness", "properties": [ )" + properties +
           R"( ], "surface": { "baseColor": "= )" + sum + "\"" + rest + " }";
}

// Passes read different numbers of textures, but a texture is declared once for all, with a sampler or without.
TEST(UnitySharedSamplers, AreTheSameInAllPasses) {
    const std::string surface = R"( })", cutout = R"j(, "alpha": "= SampleTexture2D($_T11).a" }, "render": {
      "surface": "cutout" })j";
    const std::string emission = R"j(, "emission": "= SampleTexture2D($_T10).rgb + SampleTexture2D($_T11).rgb" })j";
    const std::string moved = R"j( }, "vertex": { "positionOS": "= @positionOS * $_T11.SampleLevel(@uv0, 0).r" })j";
    const std::string counted = R"j(, "emission": "= $_T11.Load(int2(0, 0), 0).rgb" })j";
    for (const std::string keys : {"", R"(, "sampler": "trilinearRepeat")"}) {
        for (const int count : {12, 13, 20, 40}) {
            for (const std::string& rest : {surface, cutout, emission, moved, counted}) {
                SCOPED_TRACE(std::to_string(count) + keys + rest);
                const Result result = of_text(with_textures(count, keys, rest));
                const auto shares = [](const Diagnostic& d) { return d.code == "sampler-limit"; };
                EXPECT_TRUE(std::any_of(result.diagnostics.begin(), result.diagnostics.end(), shares));
                expect_accepted(result);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, UnityExample, testing::ValuesIn(examples()), [](const auto& info) {
    std::string name = info.param.substr(0, info.param.find('.'));
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
});

}  // namespace
}  // namespace patina::unity
