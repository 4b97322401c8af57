// A sub-graph that several nodes use is a function where that makes the text shorter, and else stays where it is used.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "patina/interpret.h"
#include "patina/patina.h"
#include "patina/validate.h"

namespace patina {
namespace {

using Files = std::map<std::string, std::string>;

Result compile(const std::string& graph, const Files& files, CompileOptions options = {}) {
    options.files.read = [&](const std::string& path) -> std::optional<std::string> {
        const auto found = files.find(path.substr(path.find_last_of('/') + 1));
        return found == files.end() ? std::nullopt : std::optional(found->second);
    };
    static const Compiler kCompiler;
    return kCompiler.compile_text("test.graph.json", graph, options);
}

const Shader& shader(const Result& result, Stage stage, const Target& target = Target::Glsl) {
    const auto found = std::find_if(result.shaders.begin(), result.shaders.end(),
                                    [&](const Shader& s) { return s.stage == stage && s.target == target; });
    EXPECT_NE(found, result.shaders.end());
    return *found;
}

std::size_t count(std::string_view text, std::string_view part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + part.size())) ++found;
    return found;
}

std::string unlit(const std::string& nodes, const std::string& color, const std::string& properties = "") {
    return R"({ "patina": 1, "workflow": "unlit", "properties": [)" + properties + R"(], "nodes": [)" + nodes +
           R"(], "surface": { "color": "= )" + color + R"(" } })";
}

std::string use(const std::string& id, const std::string& file, const std::string& in) {
    return R"({ "id": ")" + id + R"(", "node": "./)" + file + R"(", "in": { )" + in + " } }";
}

// Enough work for a function.
const std::string kWaves = R"json({
  "patina": 1, "kind": "subgraph", "help": "Waves upon waves.",
  "inputs": [
    { "name": "at", "type": "float" },
    { "name": "speed", "type": "float", "default": "@time" },
    { "name": "sharp", "type": "bool", "default": false }
  ],
  "nodes": [
    { "id": "swell", "expr": "sin($at * 3 + $speed) + cos($at)" },
    { "id": "chop", "expr": "sqrt(abs(swell)) * exp(-$at) + sin(swell * 7)" }
  ],
  "outputs": { "height": "= $sharp ? pow(abs(chop), 8) : chop + swell" }
})json";

std::string two_waves(const std::string& more = "") {
    return unlit(use("low", "waves.subgraph.json", "\"at\": \"@uv0.x\"" + more) + "," +
                     use("high", "waves.subgraph.json", "\"at\": \"@uv0.y\"" + more),
                 "float3(low, high, 0)");
}

// --- functions

TEST(Subgraph, IsAFunctionOfWhatItsUsesGive) {
    const Result result = compile(two_waves(), {{"waves.subgraph.json", kWaves}});
    ASSERT_TRUE(result.ok);
    const std::string& text = shader(result, Stage::Fragment).text;
    EXPECT_EQ(count(text, "// waves.subgraph.json: Waves upon waves.\nfloat waves(float at"), 1u) << text;
    EXPECT_EQ(count(text, "float low = waves("), 1u) << text;
    EXPECT_EQ(count(text, "float high = waves("), 1u) << text;
    // Nobody gives these two: neither is a parameter.
    EXPECT_EQ(count(text, "float speed"), 0u) << text;
    EXPECT_EQ(count(text, "sharp"), 0u) << text;
    EXPECT_EQ(count(text, "pow("), 0u) << text;
    // Its nodes have their own names.
    EXPECT_EQ(count(text, "float swell = "), 1u) << text;
    for (const Shader& each : result.shaders) {
        const Validated validated = validate(each);
        EXPECT_TRUE(validated.ok) << validated.log;
    }
}

TEST(Subgraph, IsCalledOnceForEqualUses) {
    const std::string graph = unlit(use("low", "waves.subgraph.json", "\"at\": \"@uv0.x\"") + "," +
                                        use("other", "waves.subgraph.json", "\"at\": \"@uv0.x\"") + "," +
                                        use("high", "waves.subgraph.json", "\"at\": \"@uv0.y\""),
                                    "float3(low, high, other)");
    const Result result = compile(graph, {{"waves.subgraph.json", kWaves}});
    ASSERT_TRUE(result.ok);
    EXPECT_EQ(count(shader(result, Stage::Fragment).text, "waves("), 3u) << shader(result, Stage::Fragment).text;
}

TEST(Subgraph, HasAFunctionForEachKnownBool) {
    const std::string graph = unlit(use("low", "waves.subgraph.json", "\"at\": \"@uv0.x\"") + "," +
                                        use("high", "waves.subgraph.json", R"("at": "@uv0.y", "sharp": true)"),
                                    "float3(low, high, 0)");
    const Result result = compile(graph, {{"waves.subgraph.json", kWaves}});
    ASSERT_TRUE(result.ok);
    // Each of the two would be called once, so it stays where it is used.
    const std::string& text = shader(result, Stage::Fragment).text;
    EXPECT_EQ(count(text, "waves("), 0u) << text;
    EXPECT_EQ(count(text, "pow("), 1u) << text;
    EXPECT_EQ(count(text, "float low_swell = "), 1u) << text;
    EXPECT_EQ(count(text, "float high_swell = "), 1u) << text;
}

TEST(Subgraph, WithSeveralOutputsReturnsAStruct) {
    const std::string two = R"json({ "patina": 1, "kind": "subgraph", "inputs": [ { "name": "at", "type": "float2" } ],
        "nodes": [
            { "id": "a", "expr": "sin($at.x * 9) * cos($at.y * 5) + sin($at.x + $at.y) * cos($at.x - $at.y)" },
            { "id": "b", "expr": "sqrt(abs(a)) * exp(-a) + sin(a * 7) * cos(a * 3)" },
            { "id": "c", "expr": "sin(a) * sin(b) + cos(a) * sqrt(abs(b))" } ],
        "outputs": { "height": "= a * c", "slope": "= float2(b, c)" } })json";
    const Files files = {{"wave-field.subgraph.json", two}};
    const std::string nodes = use("low", "wave-field.subgraph.json", "\"at\": \"@uv0\"") + "," +
                              use("high", "wave-field.subgraph.json", "\"at\": \"= @uv0.yx\"");
    const Result both = compile(unlit(nodes, "float3(low.height, high.height, low.slope.x)"), files);
    ASSERT_TRUE(both.ok);
    const std::string& text = shader(both, Stage::Fragment).text;
    EXPECT_EQ(count(text, "struct WaveFieldOutputs\n{\n    float height;\n    vec2 slope;\n};"), 1u) << text;
    EXPECT_EQ(count(text, "WaveFieldOutputs low = waveField(vUv0);"), 1u) << text;
    EXPECT_EQ(count(text, "low.slope.x"), 1u) << text;
    // What nobody reads goes, and with it the struct.
    const Result one = compile(unlit(nodes, "float3(low.height, high.height, 0)"), files);
    ASSERT_TRUE(one.ok);
    EXPECT_EQ(count(shader(one, Stage::Fragment).text, "float waveField(vec2 at)"), 1u);
    EXPECT_EQ(count(shader(one, Stage::Fragment).text, "struct WaveField"), 0u);
}

TEST(Subgraph, StaysWhereItIsUsedIfThatIsShorter) {
    const std::string small = R"json({ "patina": 1, "kind": "subgraph", "inputs": [ { "name": "at", "type": "float" } ],
        "nodes": [ { "id": "wave", "expr": "sin($at * 3) + cos($at)" } ],
        "outputs": { "height": "= sqrt(abs(wave))" } })json";
    const Result result = compile(unlit(use("low", "small.subgraph.json", "\"at\": \"@uv0.x\"") + "," +
                                            use("high", "small.subgraph.json", "\"at\": \"@uv0.y\""),
                                        "float3(low, high, 0)"),
                                  {{"small.subgraph.json", small}});
    ASSERT_TRUE(result.ok);
    EXPECT_EQ(count(shader(result, Stage::Fragment).text, "small("), 0u) << shader(result, Stage::Fragment).text;
}

// A compiler would sample once for each call.
TEST(Subgraph, SharesASampleThatIsTheSameInAllUses) {
    const std::string stained = R"json({ "patina": 1, "kind": "subgraph",
        "inputs": [ { "name": "at", "type": "float" }, { "name": "map", "type": "texture2d" } ],
        "nodes": [
            { "id": "stain", "node": "SampleTexture2D", "in": { "texture": "$map" } },
            { "id": "wave", "expr": "sin($at * 3 + stain.r) + cos($at) * exp($at) + sqrt(abs($at)) * sin($at)" } ],
        "outputs": { "height": "= sqrt(abs(wave)) * sin(wave) + cos(wave * 2)" } })json";
    const Result result = compile(unlit(use("low", "stained.subgraph.json", R"("at": "@uv0.x", "map": "$_Map")") + "," +
                                            use("high", "stained.subgraph.json", R"("at": "@uv0.y", "map": "$_Map")"),
                                        "float3(low, high, 0)", R"({ "name": "_Map", "type": "texture2d" })"),
                                  {{"stained.subgraph.json", stained}});
    ASSERT_TRUE(result.ok);
    EXPECT_EQ(count(shader(result, Stage::Fragment).text, "texture("), 1u) << shader(result, Stage::Fragment).text;
}

// --- what a function cannot be

TEST(Subgraph, WithAPinnedNodeHasAnInterpolatorForEachUse) {
    std::string pinned = kWaves;
    pinned.insert(pinned.find("\" },\n    { \"id\": \"chop\""), "\", \"stage\": \"vertex");
    const Result result = compile(two_waves(), {{"waves.subgraph.json", pinned}});
    ASSERT_TRUE(result.ok) << result.diagnostics[0].message;
    const std::string& text = shader(result, Stage::Fragment).text;
    EXPECT_EQ(count(text, "in float vLowSwell"), 1u) << text;
    EXPECT_EQ(count(text, "in float vHighSwell"), 1u) << text;
}

TEST(Subgraph, IsAFunctionOfEachStage) {
    const std::string graph = R"({ "patina": 1, "workflow": "unlit", "nodes": [)" +
                              use("low", "waves.subgraph.json", "\"at\": \"@positionOS.x\"") + "," +
                              use("high", "waves.subgraph.json", "\"at\": \"@positionOS.y\"") +
                              R"json(], "surface": { "color": "= float3(low, high, 0)" },
                                 "vertex": { "positionOS": "= @positionOS * low * high" } })json";
    const Result result = compile(graph, {{"waves.subgraph.json", kWaves}});
    ASSERT_TRUE(result.ok);
    for (const Stage stage : {Stage::Vertex, Stage::Fragment})
        EXPECT_EQ(count(shader(result, stage).text, "float waves(float at"), 1u) << shader(result, stage).text;
}

// --- what is said of it

const Target kUnity{"unity", "hlsl"};

const LineOrigin* line_of(const Shader& shader, const std::string& node) {
    const auto found = std::find_if(shader.line_map.begin(), shader.line_map.end(),
                                    [&](const LineOrigin& line) { return line.node == node; });
    return found == shader.line_map.end() ? nullptr : &*found;
}

TEST(Subgraph, MapsLinesToTheFirstUse) {
    CompileOptions options;
    options.targets = {Target::Glsl, kUnity};
    const Result result = compile(two_waves(), {{"waves.subgraph.json", kWaves}}, options);
    ASSERT_TRUE(result.ok);
    for (const Shader& each : result.shaders) {
        if (each.stage == Stage::Vertex && each.target == Target::Glsl) continue;
        const LineOrigin* line = line_of(each, "low/chop");
        ASSERT_TRUE(line) << each.file_name;
        EXPECT_TRUE(line->file.ends_with("waves.subgraph.json")) << line->file;
        EXPECT_EQ(line->source_line, 10);
        for (const char* call : {"low", "high"}) {
            EXPECT_TRUE(std::any_of(each.line_map.begin(), each.line_map.end(), [&](const LineOrigin& other) {
                return other.node == call && other.file.ends_with("test.graph.json");
            })) << call;
        }
        EXPECT_FALSE(line_of(each, "high/chop"));
    }
}

TEST(Subgraph, MapsLinesToTheirUseWhereTheyStayInPlace) {
    CompileOptions options;
    options.targets = {kUnity};
    const std::string graph =
        R"({ "patina": 1, "workflow": "unlit", "nodes": [)" +
        use("low", "waves.subgraph.json", "\"at\": \"@positionOS.x\"") + "," +
        use("high", "waves.subgraph.json", "\"at\": \"@positionOS.y\"") +
        R"(], "surface": { "color": "low" }, "vertex": { "positionOS": "= @positionOS * high" } })";
    const Result result = compile(graph, {{"waves.subgraph.json", kWaves}}, options);
    ASSERT_TRUE(result.ok);
    for (const char* node : {"low/chop", "high/chop"})
        EXPECT_TRUE(line_of(result.shaders[0], node)) << node << "\n" << result.shaders[0].text;
}

TEST(Subgraph, ReportsAMistakeOnce) {
    std::string wrong = kWaves;
    wrong.replace(wrong.find("cos($at)"), 8, "cos($att)");
    const Result result = compile(two_waves(), {{"waves.subgraph.json", wrong}});
    EXPECT_FALSE(result.ok);
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].node, "low/swell");
    EXPECT_TRUE(result.diagnostics[0].file.ends_with("waves.subgraph.json"));
}

TEST(Subgraph, IsPreviewedInEachUse) {
    CompileOptions options;
    options.request = CompileOptions::Preview{.port = "high/chop"};
    const Result result = compile(two_waves(), {{"waves.subgraph.json", kWaves}}, options);
    ASSERT_TRUE(result.ok);
    const std::string& text = shader(result, Stage::Fragment).text;
    EXPECT_EQ(count(text, "uv0.x"), 0u) << text;
    EXPECT_GE(count(text, "uv0.y"), 1u) << text;
    EXPECT_EQ(count(text, "waves("), 0u) << text;  // one call is left
}

// --- many levels: each uses the level below twice

Files ladder(int levels, const std::string& in = "", const std::string& inputs = "") {
    Files files;
    for (int level = 0; level < levels; ++level) {
        const std::string below = "l" + std::to_string(level - 1) + ".subgraph.json";
        const std::string nodes = level == 0 ? R"json({ "id": "left", "expr": "sin($x * 3.5) + cos($x) * 0.25" },
                                           { "id": "right", "expr": "left * left + sqrt(abs(left))" })json"
                                             : use("left", below, "\"x\": \"= $x * 1.25 + 0.1\"" + in) + "," +
                                                   use("right", below, "\"x\": \"= $x * 0.75 - 0.2\"" + in);
        files["l" + std::to_string(level) + ".subgraph.json"] =
            R"({ "patina": 1, "kind": "subgraph", "inputs": [ { "name": "x", "type": "float" })" + inputs +
            R"( ], "nodes": [ )" + nodes + R"( ], "outputs": { "value": "= left * 0.5 + right" } })";
    }
    return files;
}

std::size_t text_of_ladder(int levels, const std::string& in, const std::string& given, const std::string& inputs) {
    const std::string top = "l" + std::to_string(levels - 1) + ".subgraph.json";
    const Result result =
        compile(unlit(use("a", top, "\"x\": \"@uv0.x\"" + given) + "," + use("b", top, "\"x\": \"@uv0.y\"" + given),
                      "float3(a, b, 0)", R"({ "name": "_Map", "type": "texture2d" })"),
                ladder(levels, in, inputs));
    EXPECT_TRUE(result.ok);
    if (!result.ok) return 0;
    for (const Target& target : {Target::Glsl, Target::Hlsl}) {
        const Validated validated = validate(shader(result, Stage::Fragment, target));
        EXPECT_TRUE(validated.ok) << validated.log;
    }
    return shader(result, Stage::Fragment).text.size();
}

void expect_linear(const std::string& in = "", const std::string& given = "", const std::string& inputs = "") {
    const std::size_t eight = text_of_ladder(8, in, given, inputs), twelve = text_of_ladder(12, in, given, inputs);
    const std::size_t sixteen = text_of_ladder(16, in, given, inputs), twenty = text_of_ladder(20, in, given, inputs);
    const auto step = static_cast<double>(twelve - eight);
    EXPECT_GT(step, 0);
    // Names get a letter longer from the tenth level on.
    EXPECT_NEAR(static_cast<double>(sixteen - twelve), step, 0.1 * step);
    EXPECT_NEAR(static_cast<double>(twenty - sixteen), step, 0.1 * step);
}

TEST(SubgraphLadder, GrowsWithItsLevels) {
    expect_linear();
}

TEST(SubgraphLadder, GrowsWithItsLevelsIfItPassesATextureOn) {
    expect_linear(R"(, "map": "$map")", R"(, "map": "$_Map")", R"(, { "name": "map", "type": "texture2d" })");
}

TEST(SubgraphLadder, GrowsWithItsLevelsIfItPassesABoolOn) {
    expect_linear(R"(, "on": "$on")", R"(, "on": true)", R"(, { "name": "on", "type": "bool" })");
    expect_linear(R"(, "on": "$on")", R"(, "on": "= @time > 1")", R"(, { "name": "on", "type": "bool" })");
}

double value_of_ladder(int level, double x) {
    if (level == 0) {
        const double left = std::sin(x * 3.5) + std::cos(x) * 0.25;
        return left * 0.5 + left * left + std::sqrt(std::abs(left));
    }
    return value_of_ladder(level - 1, x * 1.25 + 0.1) * 0.5 + value_of_ladder(level - 1, x * 0.75 - 0.2);
}

// 16,384 uses, of which not all stay in place.
TEST(SubgraphLadder, IsKeptForTheInterpreter) {
    CompileOptions options;
    options.keep_programs = true;
    const Result result = compile(unlit(use("a", "l12.subgraph.json", "\"x\": \"@uv0.x\"") + "," +
                                            use("b", "l12.subgraph.json", "\"x\": \"@uv0.y\""),
                                        "float3(a, b, 0)"),
                                  ladder(13), options);
    ASSERT_TRUE(result.ok && result.program);
    Interpreter interpreter(*result.program, "forward", Stage::Fragment, Precision::Double);
    std::vector<double> inputs;
    for (const StageValue& input : interpreter.inputs()) {
        const std::size_t first = inputs.size();
        inputs.resize(first + input.components);
        if (input.name == "uv0")
            std::copy_n(std::array{0.3, 0.7}.begin(), 2, inputs.begin() + static_cast<long>(first));
    }
    QuadInputs quad;
    quad.lanes.fill(inputs);
    const std::vector<double> color = interpreter.run(quad).lanes[0];
    ASSERT_GE(color.size(), 2u);
    EXPECT_NEAR(color[0] / value_of_ladder(12, 0.3), 1, 1e-9);
    EXPECT_NEAR(color[1] / value_of_ladder(12, 0.7), 1, 1e-9);
}

// What is said of normals, data and colours follows each texture through each use.
TEST(SubgraphLadder, MayAddATextureAtEachLevel) {
    Files files = ladder(14);
    for (int level = 1; level < 14; ++level) {
        std::string& text = files["l" + std::to_string(level) + ".subgraph.json"];
        const std::string name = "_T" + std::to_string(level);
        text.insert(text.find("\"inputs\""),
                    R"("properties": [ { "name": ")" + name + R"(", "type": "texture2d" } ], )");
        const std::string plain = "$x * 0.75 - 0.2";
        text.replace(text.find(plain), plain.size(), "$x * 0.75 - SampleTexture2D($" + name + ").r");
    }
    const Result result = compile(unlit(use("a", "l13.subgraph.json", "\"x\": \"@uv0.x\""), "float3(a, 0, 0)"), files);
    EXPECT_TRUE(result.ok);
    EXPECT_TRUE(result.diagnostics.empty()) << result.diagnostics[0].message;
}

}  // namespace
}  // namespace patina
