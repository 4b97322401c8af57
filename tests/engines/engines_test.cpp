// An engine is data: the default one, a second one of which every convention differs (mirror.json) and a third one with
// the clip space of OpenGL and WebGL draw the same pictures, and each text holds the engine's own numbers and names.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "compiler/api/compiler_impl.h"
#include "compiler/format/keys.h"
#include "compiler/nodelang/embedded.h"
#include "patina/validate.h"
#include "runtime/picture/compare.h"
#include "runtime/render/render_request.h"

namespace patina {
namespace {

std::string mirror_text() {
    std::ostringstream text;
    text << std::ifstream("tests/engines/mirror.json").rdbuf();
    return text.str();
}

// With depth from -1 to 1, and otherwise as the first one.
std::string symmetric_text() {
    std::string text = mirror_text();
    text.replace(text.find("reversed\""), 8, "symmetric");
    return text;
}

const Compiler& compiler() {
    static const std::string kText = mirror_text(), kSymmetric = symmetric_text();
    static const nodelang::EmbeddedFile kFiles[] = {{"nodes/engines/mirror/engine.json", kText},
                                                    {"nodes/engines/symmetric/engine.json", kSymmetric}};
    static const Compiler kCompiler = CompilerAccess::with_files(kFiles);
    return kCompiler;
}

Result compile(const std::string& graph, const std::string& path, const std::string& engine) {
    CompileOptions options;
    options.targets = {{engine, "glsl"}, {engine, "hlsl"}};
    options.request = CompileOptions::Passes{.path = path};
    return compiler().compile_file(graph, options);
}

bool has(std::string_view text, std::string_view part) {
    return text.find(part) != text.npos;
}

TEST(Engines, TheLibraryIsWithoutFaults) {
    for (const Diagnostic& d : compiler().library_diagnostics()) ADD_FAILURE() << to_text(d);
}

std::string faults_of(const std::string& text) {
    const nodelang::EmbeddedFile files[] = {{"nodes/engines/broken/engine.json", text}};
    const Compiler broken = CompilerAccess::with_files(files);
    std::string faults;
    for (const Diagnostic& d : broken.library_diagnostics()) faults += to_text(d) + "\n";
    return faults;
}

TEST(Engines, MistakesInTheFileAreReportedAtTheirPlaces) {
    const std::string text = mirror_text();
    const auto with = [&](std::string_view old, std::string_view now) {
        std::string changed = text;
        changed.replace(changed.find(old), old.size(), now);
        return faults_of(changed);
    };
    EXPECT_EQ(faults_of(text), "");
    std::string faults = with("\"matrices\"", "\"matrixes\"");
    EXPECT_TRUE(has(faults, "nodes/engines/broken/engine.json:33:4: error:")) << faults;
    EXPECT_TRUE(has(faults, "'matrixes'")) << faults;
    EXPECT_TRUE(has(faults, "did you mean 'matrices'?")) << faults;
    faults = with("\"rows\"", "\"row\"");
    EXPECT_TRUE(has(faults, "did you mean 'rows'?")) << faults;
    faults = with("[\"hlsl\", \"glsl\"]", "[\"hlsl\", \"gsl\"]");
    EXPECT_TRUE(has(faults, "'gsl' is not a language that Patina writes")) << faults;
    EXPECT_TRUE(has(faults, "did you mean 'glsl'?")) << faults;
    faults = with("\"matrices\"", "\"file\": \"shaderlap\", \"matrices\"");
    EXPECT_TRUE(has(faults, "'shaderlap' is not a file format that Patina writes")) << faults;
    faults = with("\"set\": 2", "\"set\": -2");
    EXPECT_TRUE(has(faults, "'set'")) << faults;
    faults = with("\"clip\": { \"depth\": \"reversed\" },", "\"passes\": \"gone.pass.hlsl\",");
    EXPECT_TRUE(has(faults, "'gone.pass.hlsl'")) << faults;
    EXPECT_TRUE(has(faults, "'clip'")) << faults;
    EXPECT_TRUE(has(faults_of("{ \"patina\": 1"), "engine.json:1:")) << faults_of("{ \"patina\": 1");
}

TEST(Engines, ThePageNamesEveryKey) {
    std::ostringstream page;
    page << std::ifstream("docs/engines.md").rdbuf();
    using enum format::ObjectKind;
    for (const format::ObjectKind kind :
         {Engine, EngineSets, EngineSet, EngineVertexInput, EngineClip, EngineLimits, EngineNames}) {
        for (const format::KeyInfo& key : format::keys_of(kind))
            EXPECT_TRUE(has(page.str(), fmt::format("`{}`", key.name))) << key.name;
    }
}

TEST(Engines, AreListedTheDefaultOneFirst) {
    const std::vector<EngineInfo>& engines = compiler().engines();
    const auto found = [&](std::string_view name) {
        const auto at = std::ranges::find(engines, name, &EngineInfo::name);
        EXPECT_NE(at, engines.end()) << name;
        return at == engines.end() ? EngineInfo{} : *at;
    };
    ASSERT_GE(engines.size(), 4u);
    EXPECT_TRUE(engines[0].is_default);
    EXPECT_EQ(engines[0].name, "vulkan");
    EXPECT_EQ(found("mirror").title, "Mirror");
    EXPECT_EQ(found("mirror").file, "stages");
    EXPECT_FALSE(found("mirror").has_own_passes);
    EXPECT_TRUE(found("unity").is_one_file);
    EXPECT_TRUE(found("unity").has_own_passes);
}

TEST(Engines, WordsOfTargets) {
    EXPECT_EQ(compiler().targets("glsl"), std::vector<Target>{Target::Glsl});
    EXPECT_EQ(compiler().targets("vulkan"), (std::vector<Target>{Target::Glsl, Target::Hlsl}));
    EXPECT_EQ(compiler().targets("mirror"), (std::vector<Target>{{"mirror", "hlsl"}, {"mirror", "glsl"}}));
    EXPECT_EQ(compiler().targets("unity"), (std::vector<Target>{{"unity", "hlsl"}}));
    EXPECT_TRUE(compiler().targets("nothing").empty());
}

TEST(Engines, AnUnknownOneIsRefused) {
    CompileOptions options;
    options.targets = {{"mirorr", "glsl"}};
    Result result = compiler().compile_file("examples/graphs/azulejo.graph.json", options);
    ASSERT_FALSE(result.ok);
    EXPECT_TRUE(has(to_text(result.diagnostics.at(0)), "did you mean 'mirror'?")) << to_text(result.diagnostics[0]);
    options.targets = {{"unity", "glsl"}};
    result = compiler().compile_file("examples/graphs/azulejo.graph.json", options);
    ASSERT_FALSE(result.ok);
    EXPECT_TRUE(has(to_text(result.diagnostics.at(0)), "'glsl'")) << to_text(result.diagnostics[0]);
}

TEST(Engines, RequestsThatMeanNothingAreRefused) {
    const std::string graph = "examples/graphs/azulejo.graph.json";
    CompileOptions options;
    options.dump = {"ir", "nonsense"};
    const Result refused = compiler().compile_file(graph, options);
    EXPECT_FALSE(refused.ok);
    ASSERT_EQ(refused.diagnostics.size(), 1u);
    EXPECT_TRUE(has(refused.diagnostics[0].message, "'nonsense' is not a step that can be dumped"));
    options.dump.clear();
    // The default engine has a name, too.
    for (const Target& again : {Target::Glsl, Target{"vulkan", "glsl"}}) {
        options.targets = {Target::Glsl, again};
        const Result twice = compiler().compile_file(graph, options);
        ASSERT_TRUE(twice.ok);
        EXPECT_EQ(twice.shaders.size(), 2u);  // two stages, each once
    }
}

TEST(Engines, EachTextHasTheEnginesNumbersAndNames) {
    const Result result = compile("examples/graphs/azulejo.graph.json", "forward", "mirror");
    ASSERT_TRUE(result.ok);
    for (const Shader& shader : result.shaders) {
        const Validated validated = validate(shader);
        EXPECT_TRUE(validated.ok) << validated.log << shader.text;
        const bool is_vertex = shader.stage == Stage::Vertex;
        EXPECT_EQ(shader.target.engine, "mirror");
        EXPECT_FALSE(has(shader.text, "Camera"));
        if (shader.target.language == "glsl" && is_vertex) {
            EXPECT_TRUE(has(shader.text, "layout(set = 2, binding = ")) << shader.text;
            EXPECT_TRUE(has(shader.text, ", std140, row_major) uniform ViewConstants")) << shader.text;
            EXPECT_TRUE(has(shader.text, "layout(location = 5) in vec3 inPositionOS;")) << shader.text;
        }
        if (shader.target.language == "hlsl" && is_vertex) {
            EXPECT_TRUE(has(shader.text, "row_major float4x4 worldToClip;")) << shader.text;
            EXPECT_TRUE(has(shader.text, "[[vk::location(5)]] float3 positionOS : ATTRIBUTE0;")) << shader.text;
        }
    }
    const Reflection& reflection = result.reflection;
    EXPECT_EQ(reflection.clip_depth, ClipDepth::Reversed);
    for (const Block& block : reflection.blocks) {
        EXPECT_EQ(block.matrices, MatrixOrder::Rows);
        EXPECT_EQ(block.set, block.is_material ? 0u : 2u) << block.name;
        EXPECT_GE(block.binding, block.is_material ? 7u : 3u) << block.name;
    }
    for (const Texture& texture : reflection.textures) {
        EXPECT_EQ(texture.set, texture.is_material ? 0u : 2u) << texture.name;
        EXPECT_GE(texture.binding, texture.is_material ? 9u : 20u) << texture.name;
        EXPECT_GE(texture.sampler_binding, texture.is_material ? 40u : 60u) << texture.name;
    }
    EXPECT_EQ(reflection.passes.at(0).depth_test, Compare::GreaterEqual);
    const std::string json = reflection.to_json();
    EXPECT_TRUE(has(json, "\"clipDepth\": \"reversed\"")) << json;
    EXPECT_TRUE(has(json, "\"matrices\": \"rows\"")) << json;
}

TEST(Engines, TheDefaultOneIsAsItWas) {
    const Result result = compile("examples/graphs/azulejo.graph.json", "forward", "");
    ASSERT_TRUE(result.ok);
    EXPECT_EQ(result.reflection.clip_depth, ClipDepth::NearToFar);
    for (const Block& block : result.reflection.blocks) {
        EXPECT_EQ(block.matrices, MatrixOrder::Columns);
        EXPECT_EQ(block.set, block.is_material ? 1u : 0u);
    }
    EXPECT_FALSE(has(result.reflection.to_json(), "clipDepth"));
}

TEST(Engines, LimitsAreTheEngines) {
    const std::string many = [] {
        std::string nodes, sum = "0";
        for (int i = 0; i < 16; ++i) {
            nodes += fmt::format(R"json({}{{ "id": "n{}", "expr": "sin(@positionOS * {})", "stage": "vertex" }})json",
                                 i ? ", " : "", i, i + 2);
            sum += fmt::format(" + n{}.x", i);
        }
        return fmt::format(R"({{ "patina": 1, "workflow": "unlit", "nodes": [{}], "surface": {{ "color": "= {}" }} }})",
                           nodes, sum);
    }();
    CompileOptions options;
    EXPECT_TRUE(compiler().compile_text("t.graph.json", many, options).ok);
    options.targets = {{"mirror", "glsl"}};
    const Result result = compiler().compile_text("t.graph.json", many, options);
    ASSERT_FALSE(result.ok);
    EXPECT_TRUE(has(to_text(result.diagnostics.at(0)), "15")) << to_text(result.diagnostics[0]);
}

struct Picture {
    const char* name;
    const char* file;
    const char* path;
    const char* via;
    const char* engine = "mirror";
};

class Pictures : public testing::TestWithParam<Picture> {};

// The rasterised edges and depths differ in the last bits alone.
TEST_P(Pictures, AreTheDefaultEngines) {
    static runtime::RenderMachine machine;
    const Picture& picture = GetParam();
    const auto draw = [&](const std::string& engine) {
        runtime::RenderRequest request{.graph = picture.file, .size = 96, .samples = 1};
        request.options.path = picture.path;
        request.options.via = picture.via;
        request.options.engine = engine;
        return runtime::render(compiler(), request, machine);
    };
    const runtime::RenderOutcome wanted = draw(""), received = draw(picture.engine);
    ASSERT_TRUE(wanted.ok) << wanted.error;
    for (const Diagnostic& d : received.diagnostics) EXPECT_NE(d.severity, Severity::Error) << to_text(d);
    ASSERT_TRUE(received.ok) << received.error;
    const runtime::Comparison difference = runtime::compare(wanted.image, received.image, 2.01 / 255);
    EXPECT_TRUE(difference.same_size);
    EXPECT_LE(difference.share, 0.002) << difference.largest;
    EXPECT_LE(difference.average, 0.0002);
    double brightest = 0;
    for (const float value : received.image.pixels) brightest = std::max(brightest, double(value));
    EXPECT_GT(brightest, 0.1);
}

INSTANTIATE_TEST_SUITE_P(
    All, Pictures,
    testing::Values(
        Picture{"TilesGlsl", "examples/graphs/azulejo.graph.json", "forward", "glsl"},
        Picture{"TilesHlsl", "examples/graphs/azulejo.graph.json", "forward", "hlsl"},
        Picture{"TilesCpu", "examples/graphs/azulejo.graph.json", "forward", "cpu"},
        Picture{"LightsForward", "examples/scenes/five-lights.scene.json", "forward", "glsl"},
        Picture{"LightsForwardAdd", "examples/scenes/five-lights.scene.json", "forward-add", "hlsl"},
        Picture{"LightsDeferred", "examples/scenes/five-lights.scene.json", "deferred", "glsl"},
        Picture{"LightsDeferredHlsl", "examples/scenes/five-lights.scene.json", "deferred", "hlsl"},
        Picture{"LightsVertex", "examples/scenes/five-lights.scene.json", "vertex", "glsl"},
        Picture{"ShoreReadsDepth", "examples/scenes/shore.scene.json", "forward", "glsl"},
        Picture{"SymmetricTiles", "examples/graphs/azulejo.graph.json", "forward", "hlsl", "symmetric"},
        Picture{"SymmetricTilesCpu", "examples/graphs/azulejo.graph.json", "forward", "cpu", "symmetric"},
        Picture{"SymmetricLights", "examples/scenes/five-lights.scene.json", "forward", "glsl", "symmetric"},
        Picture{"SymmetricDeferred", "examples/scenes/five-lights.scene.json", "deferred", "glsl", "symmetric"},
        Picture{"SymmetricDepth", "examples/scenes/shore.scene.json", "forward", "glsl", "symmetric"}),
    [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace patina
