// What a reader of an emitted text sees: names that say where a value comes from, comments that fit what is left of a
// function, and no operation that does nothing.
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <sstream>

#include "patina/patina.h"

namespace patina {
namespace {

constexpr const char* kLayer = R"json({
  "patina": 1, "kind": "subgraph",
  "inputs": [ { "name": "at", "type": "float" } ],
  "nodes": [
    { "id": "t", "expr": "sin($at) * 0.5" },
    { "id": "u", "expr": "t * t + $at" }
  ],
  "outputs": { "height": "= u * sqrt(u)", "width": "= t + u" }
})json";

constexpr const char* kTwice = R"json({
  "patina": 1, "kind": "subgraph",
  "nodes": [ { "id": "layer", "node": "./layer.subgraph.json", "in": { "at": "@uv0.y" } } ],
  "outputs": { "out": "= layer.width * layer.height" }
})json";

constexpr const char* kPaint = R"json({
  "patina": 1, "kind": "subgraph",
  "inputs": [ { "name": "paint", "type": "color" } ],
  "outputs": { "out": "= $paint.rgb * $paint.a" }
})json";

std::string text_of(const std::string& graph, const Target& target = Target::Glsl) {
    CompileOptions options;
    options.targets = {target};
    options.files.read = [](const std::string& path) -> std::optional<std::string> {
        if (path.ends_with("layer.subgraph.json")) return kLayer;
        if (path.ends_with("twice.subgraph.json")) return kTwice;
        if (path.ends_with("paint.subgraph.json")) return kPaint;
        return {};
    };
    const Result result = Compiler().compile_text("test.graph.json", graph, options);
    if (!result.ok) return result.diagnostics.empty() ? "?" : result.diagnostics[0].message;
    return result.shaders.back().text;
}

// The text of an unlit material with this colour.
std::string shown(const std::string& color, const std::string& nodes = "", const Target& target = Target::Glsl) {
    return text_of(R"({ "patina": 1, "workflow": "unlit",
        "properties": [ { "name": "_K", "type": "float" }, { "name": "_I", "type": "int" },
                        { "name": "_V", "type": "float3" } ],
        "nodes": [)" + nodes +
                       R"(], "surface": { "color": "= )" + color + R"(" } })",
                   target);
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}
#define EXPECT_HAS(text, part) EXPECT_TRUE(has(text, part)) << "no " << (part) << " in\n" << (text)
#define EXPECT_LACKS(text, part) EXPECT_FALSE(has(text, part)) << (part) << " in\n" << (text)

// --- colours

TEST(EmittedColors, OfThreeNumbersAreOpaque) {
    const std::string text =
        shown("paint", R"({ "id": "paint", "node": "./paint.subgraph.json", "in": { "paint": [0.5, 0.25, 0.75] } })");
    EXPECT_HAS(text, "vec4(0.5, 0.25, 0.75, 1.0)");
}

// --- names

constexpr const char* kLayers = R"(
    { "id": "rustLayer", "node": "./layer.subgraph.json", "in": { "at": "@uv0.x" } },
    { "id": "mossLayer", "node": "./layer.subgraph.json", "in": { "at": "@uv0.y" } })";

TEST(EmittedNames, OfASubGraphSayWhichUseOfIt) {
    const std::string text =
        shown("float3(rustLayer.height, mossLayer.height, rustLayer.width * mossLayer.width)", kLayers);
    for (const char* name : {"rustLayer_t", "mossLayer_t", "rustLayer_u", "mossLayer_u"}) EXPECT_HAS(text, name);
    EXPECT_LACKS(text, "float t ");
    EXPECT_LACKS(text, "t2");
}

TEST(EmittedNames, OfASubGraphAreShortIfThereIsOne) {
    const std::string text =
        shown("rustLayer.height + rustLayer.width",
              R"({ "id": "rustLayer", "node": "./layer.subgraph.json", "in": { "at": "@uv0.x" } })");
    EXPECT_HAS(text, "float t = ");
    EXPECT_LACKS(text, "rustLayer_");
}

TEST(EmittedNames, OfASubGraphGiveWayToTheGraphsOwn) {
    const std::string text = shown("rustLayer.height * t + rustLayer.width * t * t",
                                   R"({ "id": "t", "expr": "cos(@uv0.y) + 2" },
        { "id": "rustLayer", "node": "./layer.subgraph.json", "in": { "at": "@uv0.x" } })");
    EXPECT_HAS(text, "float t = cos(");
    EXPECT_HAS(text, "float rustLayer_t = ");
}

TEST(EmittedNames, OfNestedSubGraphsHaveAsManyWordsAsTheyNeed) {
    const std::string text = shown("layer.width * a.out",
                                   R"({ "id": "layer", "node": "./layer.subgraph.json", "in": { "at": "@uv0.x" } },
        { "id": "a", "node": "./twice.subgraph.json" })");
    EXPECT_HAS(text, "float layer_t = ");
    EXPECT_HAS(text, "float a_layer_t = ");
}

// --- comments

TEST(EmittedComments, DescribeTheOutputsThatAreLeft) {
    const std::string cells = R"({ "id": "cells", "node": "Voronoi" })";
    const std::string random = shown("float3(cells.random)", cells);
    EXPECT_HAS(random, "// A random number for each point, from 0 to 1.\nfloat Voronoi(");
    EXPECT_LACKS(random, "distance");
    const std::string two = shown("float3(cells.random, cells.toPoint)", cells);
    EXPECT_HAS(two,
               "// random: a random number for each point, from 0 to 1\n"
               "// toPoint: from here to the nearest point, in cells\n");
    EXPECT_LACKS(two, "distance");
    EXPECT_HAS(shown("float3(cells, cells.toPoint)", cells), "// The distance to the nearest of random points");
}

// --- operations

TEST(EmittedOperations, OfRepeatedNumbersAreComputedOnce) {
    const std::string text = shown("float3((0.04 + float3(0.96) * $_K).x, $_V.xy)");
    EXPECT_HAS(text, "0.04 + 0.96 * _K");
    EXPECT_LACKS(text, "vec3(0.96)");
    EXPECT_HAS(shown("float3(0.96) * $_K", "", Target::Hlsl), "(0.96 * _K).xxx");
}

TEST(EmittedOperations, LimitOnlyWhereAValueIsNotLimitedYet) {
    EXPECT_HAS(shown("float3(clamp(abs($_K), 0, 1))"), "min(abs(_K), 1.0)");
    EXPECT_HAS(shown("float3(clamp(abs($_K), 0, 1))", "", Target::Hlsl), "saturate(abs(_K))");
    EXPECT_HAS(shown("float3(clamp(abs($_K), 0, 5))", "", Target::Hlsl), "min(abs(_K), 5.0)");
    EXPECT_HAS(shown("float3(clamp(min($_K, 3), 0, 5))"), "clamp(_K, 0.0, 3.0)");
    EXPECT_HAS(shown("float3(max(max($_K, 0.5), 0.25))"), "max(_K, 0.5)");
    EXPECT_HAS(shown("float3(min(max($_K, 0.5), 2))"), "clamp(_K, 0.5, 2.0)");
    EXPECT_HAS(shown("float3(max(saturate($_K), 0.1))"), "clamp(_K, 0.1, 1.0)");
    EXPECT_HAS(shown("float3(clamp(clamp($_K, 0, 4), 1, 9))"), "clamp(_K, 1.0, 4.0)");
    EXPECT_HAS(shown("float3(saturate(1 - saturate($_K)))"), "vec3(1.0 - clamp(_K, 0.0, 1.0))");
    // A limit that turns NaN into a number stays.
    EXPECT_HAS(shown("float3(max(abs($_K), 0))"), "max(abs(_K), 0.0)");
    EXPECT_HAS(shown("float3(max(sqrt($_K), 0))"), "max(sqrt(_K), 0.0)");
    EXPECT_HAS(shown("float3(max($_K * $_K, 0))"), "max(_K * _K, 0.0)");
    const std::string cosine = R"json({ "id": "c", "expr": "clamp($_K, -1, 1)" })json";
    EXPECT_LACKS(shown("float3(max(c * c, 0))", cosine), "max(");
    // A GPU may round a power of a number below 1 to more than 1, but never below 0.
    EXPECT_HAS(shown("float3(saturate(pow(saturate($_K), 2)))"), "min(pow(clamp(_K, 0.0, 1.0), 2.0), 1.0)");
    EXPECT_LACKS(shown("float3(max(pow(saturate($_K), 2), 0))"), "max(");
    EXPECT_HAS(shown("float3(max(pow($_K, 2), 0))"), "max(pow(_K, 2.0), 0.0)");
    EXPECT_HAS(shown("float3(max(pow(saturate($_K), -1), 0))"), "max(pow(");  // pow(0, 0) is NaN on some GPUs
}

TEST(EmittedOperations, TimesZeroNowhere) {
    EXPECT_LACKS(shown("float3($_K * 0.0)"), "_K * 0.0");
    EXPECT_LACKS(shown("$_V + 0.0 * log($_V)"), "log(");
    EXPECT_LACKS(shown("$_V + float3(0.0 * (1 - saturate($_K)))"), "clamp(");
    const std::string part = R"json({ "id": "c", "expr": "saturate($_K)" })json";
    EXPECT_LACKS(shown("$_V + float3(c - c)", part), "clamp(");
    EXPECT_HAS(shown("float3($_K - $_K)"), "_K - _K");
}

// x to the power of 0 is 1, of 0 too: a choice says so where the compiler does not know that one of the two is above 0.
TEST(EmittedOperations, PowersWithAChoiceOnlyWhereBothMayBeZero) {
    EXPECT_HAS(shown("float3(pow(saturate($_K), $_V.x))"), "pow(_V.x == 0.0 ? 1.0 : clamp(_K, 0.0, 1.0), _V.x)");
    EXPECT_HAS(shown("float3(pow(abs($_V), $_V))", "", Target::Hlsl),
               "pow(_V == 0.0 ? float3(1.0, 1.0, 1.0) : abs(_V), _V)");
    for (const char* power : {"pow(saturate($_K), 2.5)", "pow(abs($_K), max($_V.x, 0.1))", "pow(max($_K, 1e-4), $_V.x)",
                              "pow(abs($_K), 0)", "pow(saturate($_K) + 0.5, $_V.x)"})
        EXPECT_LACKS(shown(std::string("float3(") + power + ")"), " ? ");
}

TEST(EmittedOperations, NormalizeOnce) {
    EXPECT_HAS(shown("normalize(normalize($_V))"), " = normalize(_V);");
    EXPECT_HAS(shown("normalize(-normalize($_V))"), "= -normalize(_V)");
    const std::string chosen = shown("normalize($_K > 0 ? normalize($_V) : -normalize($_V))");
    EXPECT_EQ(chosen.find("normalize("), chosen.rfind("normalize(")) << chosen;
    const std::string reflected = shown("normalize(reflect(normalize($_V), normalize($_V.zyx)))");
    EXPECT_LACKS(reflected, "normalize(reflect");
    // Neither a sum nor the reflection of a long vector is a unit vector.
    EXPECT_HAS(shown("normalize(normalize($_V) + normalize($_V.zyx))"), "normalize(normalize(");
    EXPECT_HAS(shown("normalize(reflect($_V, normalize($_V.zyx)))"), "normalize(reflect(");
}

TEST(EmittedOperations, NormalizeOnceAcrossFunctions) {
    const std::string text = text_of(R"json({ "patina": 1, "workflow": "metallic-roughness",
        "properties": [ { "name": "_BumpMap", "type": "texture2d", "usage": "normal" } ],
        "nodes": [ { "id": "bumps", "node": "SampleNormalMap", "in": { "texture": "$_BumpMap" } } ],
        "surface": { "normalTS": "bumps", "baseColor": "= float3(@uv0, 0.5)" } })json");
    EXPECT_HAS(text, " = normalize(tangent");
    EXPECT_LACKS(text, "normalize(material.");
}

TEST(EmittedOperations, LimitNoIndexThatALoopLimits) {
    const std::string text =
        text_of(R"json({ "patina": 1, "workflow": "metallic-roughness", "surface": { "roughness": "@uv0.x" } })json");
    EXPECT_HAS(text, "min(lightCount, 16)");
    EXPECT_LACKS(text, "clamp(index");
}

TEST(EmittedOperations, MultiplyByOneConstant) {
    EXPECT_HAS(shown("float3($_K * 4 * 0.5)"), "vec3(_K * 2.0)");
    EXPECT_HAS(shown("float3($_K / 4 * 6)"), "vec3(_K * 1.5)");
    EXPECT_LACKS(shown("float3($_K * 3.14159265 * 0.318309886)"), "3.14");
    EXPECT_HAS(shown("float3($_K * 3.14159265 * 0.318309886, $_K, 0)"), "vec3(_K, _K, 0.0)");
    EXPECT_HAS(shown("float3($_V.x * ($_K * 3.14159265 / $_V.y) * 0.318309886)"), "_V.x * (_K / _V.y)");
    EXPECT_HAS(shown("float3($_V.x * 0.318309886 / $_V.y) * $_V * (3.14159265 * $_K)"), "_V.x / _V.y * _V * _K");
    EXPECT_HAS(shown("float3(1 - $_K + 2 - 0.5, $_K - 1 + 3, 0)"), "vec3(2.5 - _K, _K + 2.0, 0.0)");
    // Not where a number would overflow on the way, or vanish.
    EXPECT_HAS(shown("float3($_K * 0 * 4)"), "0.0");
}

TEST(EmittedOperations, CallNothingForTrivialConstants) {
    const std::string text = text_of(R"json({ "patina": 1, "workflow": "unlit",
        "properties": [ { "name": "_Color", "type": "color" } ],
        "nodes": [ { "id": "faded", "node": "PremultiplyAlpha",
                     "in": { "diffuseColor": "$_Color.rgb", "alpha": "$_Color.a", "oneMinusReflectivity": 1.0 } } ],
        "surface": { "color": "= faded.out * faded.outAlpha" } })json");
    EXPECT_LACKS(text, "PremultiplyAlpha(");
}

// --- what a path hands from pass to pass

// A usual material's light passes read no more than Unity's layout holds; those of glTF with a clear coat fill all
// targets.
TEST(EmittedText, WritesNoTargetThatNothingReads) {
    struct Case {
        const char* lighting;
        const char* surface;
        std::size_t targets;
    };
    for (const Case& each : {Case{"cook-torrance", R"("baseColor": [1, 0.5, 0])", 4},
                             Case{"gltf", R"("clearcoat": "@uv0.x", "clearcoatRoughness": "@uv0.y")", 7}}) {
        CompileOptions options;
        options.passes()->path = "deferred-extended";
        const Result result =
            Compiler().compile_text("test.graph.json",
                                    std::string(R"({ "patina": 1, "workflow": "metallic-roughness", "lighting": ")") +
                                        each.lighting + R"(", "surface": { )" + each.surface + " } }",
                                    options);
        ASSERT_TRUE(result.ok) << (result.diagnostics.empty() ? "" : result.diagnostics[0].message);
        std::size_t passes = 0;
        for (const Pass& pass : result.reflection.passes) {
            if (pass.name != "gbuffer-extended") continue;
            ++passes;
            EXPECT_EQ(pass.targets.size(), each.targets) << each.lighting;
        }
        EXPECT_EQ(passes, 1u);
        std::size_t written = 0, read = 0;
        for (const Shader& shader : result.shaders) {
            if (shader.stage != Stage::Fragment || shader.target.language != "glsl") continue;
            for (const char* target : {"outExtra1", "outExtra2", "outExtra3"})
                written += has(shader.text, std::string("out vec4 ") + target) ? 1 : 0;
            if (shader.pass != "extended-directional") continue;
            for (const char* target : {"gbufferExtra1Texture;", "gbufferExtra2Texture;", "gbufferExtra3Texture;"})
                read += has(shader.text, std::string("texture2D ") + target) ? 1 : 0;
        }
        EXPECT_EQ(written, each.targets - 4) << each.lighting;
        EXPECT_EQ(read, each.targets - 4) << each.lighting;
    }
}

// For Vulkan a pipeline sets it; for Direct3D it is a macro or a static constant, never a value of a block.
TEST(EmittedText, OfASpecializationConstantIsForBothKindsOfApi) {
    const std::string text = text_of(R"json({ "patina": 1, "workflow": "unlit",
        "properties": [ { "name": "_Wet", "type": "bool", "default": true, "as": "specialization" } ],
        "surface": { "color": "= $_Wet ? float3(1, 0, 0) : float3(0, 0, 1)" } })json",
                                     Target::Hlsl);
    EXPECT_HAS(text,
               "#if defined(__spirv__) || defined(VULKAN)\n[[vk::constant_id(0)]] const bool _Wet = true;\n"
               "#elif !defined(_Wet)\nstatic const bool _Wet = true;\n#endif\n");
}

// --- the texts of the examples, on paths and with switches

// A number or a vector of this number stands before or after `at`, and nothing makes it another one: not 10.0, 0.05,
// x.0.
bool is_lone(std::string_view line, std::size_t at, std::size_t size) {
    const auto continues = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '_'; };
    return (at == 0 || !continues(line[at - 1])) && (at + size >= line.size() || !continues(line[at + size]));
}

bool has_lone(std::string_view line, std::string_view part, std::string_view number) {
    for (std::size_t at = line.find(part); at != line.npos; at = line.find(part, at + 1))
        if (is_lone(line, at + part.find(number), number.size())) return true;
    return false;
}

// What the line computes though it is known.
std::string needless(std::string_view line) {
    struct Row {
        const char* part;
        const char* number;
    };
    constexpr Row kRows[] = {
        {"0.0 * ", "0.0"}, {" * 0.0", "0.0"},  {"(0.0) * ", "0.0"}, {" * vec3(0.0)", "0.0"}, {"0.0, 0.0) * ", "0.0"},
        {" + 0.0", "0.0"}, {"(0.0 + ", "0.0"}, {"= 0.0 + ", "0.0"}, {" - 0.0", "0.0"},       {" * 1.0", "1.0"},
        {"1.0 * ", "1.0"}, {" / 1.0", "1.0"},  {"0.0 / ", "0.0"},   {"mix(0.0, 0.0", "0.0"}, {"max(0.0, 0.0", "0.0"}};
    const std::string_view code = line.substr(0, line.find("//"));
    for (const Row& row : kRows)
        if (has_lone(code, row.part, row.number)) return row.part;
    const bool has_power =
        code.find("pow(") != code.npos && (has_lone(code, ", 1.0)", "1.0") || has_lone(code, ", 0.0)", "0.0"));
    return has_power ? "pow" : "";
}

// The first word in backticks of a comment that neither the line below the comments nor the line itself declares.
std::string unknown_name(const std::vector<std::string>& lines, std::size_t comment) {
    std::size_t below = comment;
    while (below < lines.size() && lines[below].starts_with("//")) ++below;
    if (below == lines.size() || lines[below].find('(') == std::string::npos) return {};
    const std::string& text = lines[comment];
    for (std::size_t at = text.find('`'); at != text.npos; at = text.find('`', at + 1)) {
        const std::size_t end = text.find('`', at + 1);
        if (end == text.npos) return {};
        const std::string name = text.substr(at + 1, end - at - 1);
        if (!has_lone(lines[below], name, name)) return name;
        at = end;
    }
    return {};
}

TEST(EmittedText, OfExamplesComputesNothingThatIsKnown) {
    const std::vector<std::vector<const char*>> switch_lists = {
        {},
        {"fog"},
        {"fog", "shadows", "cookies", "lightmap", "shadowMask", "shadowsFade", "reflectionProbes", "tiles"}};
    const Compiler compiler;
    int texts = 0;
    for (const char* folder : {"examples/graphs", "examples/surfaces", "examples/sources"}) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            const std::string graph = entry.path().string();
            if (!graph.ends_with(".graph.json")) continue;
            for (const char* path : {"forward", "forward-add", "vertex", "deferred", "deferred-extended"}) {
                for (const std::vector<const char*>& switches : switch_lists) {
                    CompileOptions options;
                    options.passes()->path = path;
                    for (const char* name : switches) options.switches.emplace_back(name, "true");
                    // Some paths refuse some graphs.
                    for (const Shader& shader : compiler.compile_file(graph, options).shaders) {
                        SCOPED_TRACE(shader.file_name + " along " + path);
                        ++texts;
                        std::vector<std::string> lines;
                        std::istringstream text(shader.text);
                        for (std::string line; std::getline(text, line);) lines.push_back(line);
                        for (std::size_t i = 0; i < lines.size(); ++i) {
                            ASSERT_EQ(needless(lines[i]), "") << lines[i];
                            ASSERT_EQ(lines[i].starts_with("//") ? unknown_name(lines, i) : "", "") << lines[i];
                        }
                    }
                }
            }
        }
    }
    EXPECT_GT(texts, 1000);
}

}  // namespace
}  // namespace patina
