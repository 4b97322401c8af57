// The measurement of cost: on modules written by hand, whose figures can be counted in the text; on a shader written by
// hand, for the owners of its instructions; and on all examples and models.
#include "patina/cost.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <spirv-tools/libspirv.hpp>

#include "compiler/validate/counts.h"
#include "patina/validate.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::uint32_t>;

// Types, a constant, an input of two components and one output, for functions in SPIR-V's assembly language.
Words module_of(const std::string& functions) {
    const std::string before = R"(
        OpCapability Shader
        OpCapability DerivativeControl
%glsl = OpExtInstImport "GLSL.std.450"
        OpMemoryModel Logical GLSL450
        OpEntryPoint Fragment %main "main" %in %out %tex
        OpExecutionMode %main OriginUpperLeft
%file = OpString "test"
        OpDecorate %in Location 0
        OpDecorate %out Location 0
        OpDecorate %tex DescriptorSet 0
        OpDecorate %tex Binding 0
%void = OpTypeVoid
%fn = OpTypeFunction %void
%bool = OpTypeBool
%float = OpTypeFloat 32
%getter = OpTypeFunction %float
%v2 = OpTypeVector %float 2
%v4 = OpTypeVector %float 4
%image = OpTypeImage %float 2D 0 0 0 1 Unknown
%sampled = OpTypeSampledImage %image
%to_sampled = OpTypePointer UniformConstant %sampled
%to_v2 = OpTypePointer Input %v2
%to_v4 = OpTypePointer Output %v4
%local_v4 = OpTypePointer Function %v4
%in = OpVariable %to_v2 Input
%out = OpVariable %to_v4 Output
%tex = OpVariable %to_sampled UniformConstant
%one = OpConstant %float 1
%yes = OpConstantTrue %bool
)";
    const spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
    Words words;
    EXPECT_TRUE(tools.Assemble(before + functions, &words, SPV_TEXT_TO_BINARY_OPTION_PRESERVE_NUMERIC_IDS));
    return words;
}

TEST(Cost, OfNoModule) {
    EXPECT_EQ(count({}, Stage::Fragment).total, StageCost{});
    EXPECT_EQ(count({1, 2, 3, 4, 5, 6}, Stage::Fragment).total, StageCost{});
}

// An instruction of each kind; lines 2 and 4 are those of the owners 1 and 2.
TEST(Cost, OfAStraightFunction) {
    const SpirvCounts counts = count(module_of(R"(
        %main = OpFunction %void None %fn
        %start = OpLabel
        OpLine %file 2 0
        %uv = OpLoad %v2 %in
        %map = OpLoad %sampled %tex
        %texel = OpImageSampleImplicitLod %v4 %map %uv
        OpLine %file 4 0
        %slope = OpDPdx %v2 %uv
        %product = OpFMul %v2 %slope %uv
        %root = OpExtInst %v2 %glsl Sqrt %product
        %bent = OpExtInst %v2 %glsl FAbs %root
        %x = OpCompositeExtract %float %bent 0
        %scaled = OpVectorTimesScalar %v4 %texel %x
        OpLine %file 0 0
        OpStore %out %scaled
        OpReturn
        OpFunctionEnd
    )"),
                                     Stage::Fragment, 3);
    ASSERT_EQ(counts.shares.size(), 3u);
    // The function, its label, OpStore, OpReturn, the end.
    EXPECT_EQ(counts.shares[0].once, (CostCounts{.instructions = 5}));
    EXPECT_EQ(counts.shares[1].once, (CostCounts{.instructions = 3, .textures = 1}));
    // OpFMul, FAbs and OpVectorTimesScalar are arithmetic; the extraction is none of the kinds.
    EXPECT_EQ(counts.shares[2].once,
              (CostCounts{.instructions = 6, .arithmetic = 3, .transcendental = 1, .derivatives = 1}));
    EXPECT_EQ(counts.total.once,
              (CostCounts{.instructions = 14, .arithmetic = 3, .transcendental = 1, .textures = 1, .derivatives = 1}));
    EXPECT_EQ(counts.total.per_light, CostCounts{});
    EXPECT_EQ(counts.total.varyings, 2u);
    // The texel (4) with the uv and the slope (2 and 2).
    EXPECT_EQ(counts.total.registers, 8u);
}

// The lines of a loop over lights are odd. The loop of header 'rows' counts once; what 'lights' calls counts per light.
TEST(Cost, OfLoopsAndCalls) {
    const SpirvCounts counts = count(module_of(R"(
        %main = OpFunction %void None %fn
        %start = OpLabel
        OpBranch %rows
        %rows = OpLabel
        OpLine %file 2 0
        OpLoopMerge %after_rows %next_row None
        OpBranchConditional %yes %row %after_rows
        %row = OpLabel
        %a = OpFunctionCall %float %term
        OpBranch %next_row
        %next_row = OpLabel
        OpBranch %rows
        %after_rows = OpLabel
        OpBranch %lights
        %lights = OpLabel
        OpLine %file 1 0
        OpLoopMerge %after_lights %next_light None
        OpBranchConditional %yes %light %after_lights
        %light = OpLabel
        %b = OpFunctionCall %float %term
        %c = OpFunctionCall %float %term
        %d = OpFAdd %float %b %c
        OpBranch %next_light
        %next_light = OpLabel
        OpBranch %lights
        %after_lights = OpLabel
        OpReturn
        OpFunctionEnd
        %term = OpFunction %float None %getter
        %begin = OpLabel
        %e = OpExtInst %float %glsl Sin %one
        OpReturnValue %e
        OpFunctionEnd
        %never = OpFunction %float None %getter
        %top = OpLabel
        OpReturnValue %one
        OpFunctionEnd
    )"),
                                     Stage::Fragment, 2);
    EXPECT_EQ(counts.light_loops, 1u);
    // The header (3), the body (5), the next round (2), and twice the function (5 each).
    EXPECT_EQ(counts.total.per_light, (CostCounts{.instructions = 20, .arithmetic = 1, .transcendental = 2}));
    // The function and 'start' (3), 'rows' (3), 'row' (3), 'next_row' (2), 'after_rows' (2), 'after_lights' (3), and
    // the function once (5).
    EXPECT_EQ(counts.total.once, (CostCounts{.instructions = 21, .transcendental = 1}));
}

// 'kept' is read after the loop, so its registers are taken while the loop runs. The variable takes registers
// everywhere.
TEST(Cost, CountsLiveRegistersThroughALoop) {
    const SpirvCounts counts = count(module_of(R"(
        %main = OpFunction %void None %fn
        %start = OpLabel
        %memory = OpVariable %local_v4 Function
        %uv = OpLoad %v2 %in
        %kept = OpVectorShuffle %v4 %uv %uv 0 1 0 1
        OpBranch %head
        %head = OpLabel
        %sum = OpPhi %float %one %start %more %next
        OpLoopMerge %after %next None
        OpBranchConditional %yes %next %after
        %next = OpLabel
        %more = OpFAdd %float %sum %one
        OpBranch %head
        %after = OpLabel
        %scaled = OpVectorTimesScalar %v4 %kept %sum
        OpStore %out %scaled
        OpReturn
        OpFunctionEnd
    )"),
                                     Stage::Fragment);
    // The most are in the loop: kept (4), the sum (1) and the variable (4). Nothing reads uv (2) after kept is made.
    EXPECT_EQ(counts.total.registers, 9u);
}

// --- owners

constexpr const char* kGraph = "owners.graph.json";

// What a compiler could have made of a graph with the nodes a, b and c.
Result shader_by_hand() {
    Shader fragment;
    fragment.pass = "one";
    fragment.stage = Stage::Fragment;
    fragment.file_name = "one.frag.glsl";
    fragment.text = R"(#version 450
layout(location = 0) in vec4 v;
layout(location = 0) out vec4 o;
float helper(float x)
{
    return sin(x) + x;
}
void main()
{
    float first = helper(v.x);
    float second = helper(v.y) + helper(v.z);
    float lit = 0.0;
    for (int i = 0; i < int(v.w); ++i) {
        lit += sqrt(float(i));
    }
    o = vec4(first, second, lit, 1.0);
}
)";
    const auto at = [&](int line, std::string node, std::string file) {
        LineOrigin& origin = fragment.line_map.emplace_back();
        origin.line = line;
        origin.node = std::move(node);
        origin.file = std::move(file);
    };
    at(10, "a", kGraph);
    at(11, "b/inner", "inner.subgraph.json");
    at(12, "", "");
    at(14, "a", "other.lighting.json");
    at(15, "", "");
    at(16, "", kGraph);
    fragment.light_loops = {13};
    Shader vertex = fragment;
    vertex.stage = Stage::Vertex;
    vertex.text = "#version 450\nlayout(location = 0) out vec4 v;\nvoid main()\n{\n    v = vec4(0.0);\n}\n";
    vertex.line_map.clear();
    vertex.light_loops.clear();
    Result result;
    result.ok = true;
    result.shaders = {vertex, fragment};
    result.dependencies = {kGraph};
    result.nodes = {"a", "b", "c"};
    result.reflection.passes.emplace_back().name = "one";
    return result;
}

TEST(Cost, BelongsToNodesAndParts) {
    const std::vector<MeasuredPass> passes = measure(shader_by_hand());
    ASSERT_EQ(passes.size(), 1u);
    ASSERT_TRUE(passes[0].vertex.ok && passes[0].fragment.ok);
    const std::vector<CostShare>& shares = passes[0].fragment.shares;
    ASSERT_EQ(shares.size(), 6u);
    using Part = CostShare::Part;
    // helper() works for its callers: a sine and a sum each, and one more sum of b.
    EXPECT_EQ(shares[0].node, "a");
    EXPECT_EQ(shares[0].once.transcendental, 1u);
    EXPECT_EQ(shares[0].once.arithmetic, 1u);
    EXPECT_EQ(shares[1].node, "b");
    EXPECT_EQ(shares[1].once.transcendental, 2u);
    EXPECT_EQ(shares[1].once.arithmetic, 3u);
    EXPECT_EQ(shares[2].node, "c");
    EXPECT_EQ(shares[2].once, CostCounts{});
    EXPECT_EQ(shares[3].part, Part::Surface);
    EXPECT_GT(shares[3].once.instructions, 0u);
    // A node of another graph: the root, the sum and the conversion, for each light.
    EXPECT_EQ(shares[4].part, Part::Lighting);
    EXPECT_EQ(shares[4].once, CostCounts{});
    EXPECT_EQ(shares[4].per_light.transcendental, 1u);
    EXPECT_EQ(shares[4].per_light.arithmetic, 2u);
    EXPECT_EQ(shares[5].part, Part::Pass);
    EXPECT_EQ(passes[0].cost.fragment.varyings, 4u);
    EXPECT_EQ(passes[0].cost.vertex.varyings, 4u);
}

TEST(Cost, OfHalfAPassIsNotMeasured) {
    Result broken = shader_by_hand();
    broken.shaders[1].text = "#version 450\nvoid main() { nothing(); }\n";
    const std::vector<Diagnostic> why = refusals(broken, measure(broken));
    ASSERT_EQ(why.size(), 1u);
    EXPECT_NE(why[0].message.find("nothing"), std::string::npos) << why[0].message;
}

// --- budgets

TEST(Cost, IsComparedWithABudget) {
    const std::vector<MeasuredPass> passes = measure(shader_by_hand());
    const std::uint32_t instructions = passes[0].cost.fragment.total().instructions;
    EXPECT_TRUE(over_budget(passes, {}).empty());
    EXPECT_TRUE(over_budget(passes, {.instructions = Budget::Limit{.most = instructions}, .textures = {}}).empty());
    const FileLocation place{
        .file = kGraph, .line = 3, .column = 7, .end_line = 3, .end_column = 10, .source_line = {}};
    const Budget tight{.instructions = Budget::Limit{.most = instructions - 1, .place = place},
                       .textures = Budget::Limit{.most = 0}};
    const std::vector<Diagnostic> over = over_budget(passes, tight);
    ASSERT_EQ(over.size(), 1u);
    EXPECT_EQ(over[0].code, "too-costly");
    EXPECT_EQ(over[0].line, 3);
    EXPECT_NE(over[0].message.find("'one'"), std::string::npos) << over[0].message;
    EXPECT_NE(over[0].message.find(std::to_string(instructions)), std::string::npos) << over[0].message;
}

// --- the library and the examples

std::vector<std::string> examples() {
    std::vector<std::string> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator("examples"))
        if (entry.path().string().ends_with(".graph.json")) found.push_back(entry.path().generic_string());
    std::ranges::sort(found);
    return found;
}

CostCounts sum_of(const std::vector<CostShare>& shares, CostCounts CostShare::*which) {
    CostCounts sum;
    for (const CostShare& share : shares) sum += share.*which;
    return sum;
}

// And the owners, which the measurement adds to the module, change nothing.
TEST(Cost, OfNodesSumsToThatOfEachExample) {
    const Compiler compiler;
    CompileOptions options;
    options.targets = {Target::Glsl};
    std::size_t with_shares = 0;
    for (const std::string& graph : examples()) {
        const Result result = compiler.compile_file(graph, options);
        ASSERT_TRUE(result.ok) << graph;
        const std::vector<MeasuredPass> passes = measure(result);
        ASSERT_TRUE(refusals(result, passes).empty()) << graph;
        ASSERT_EQ(passes.size(), result.reflection.passes.size()) << graph;
        for (const MeasuredPass& pass : passes) {
            for (const MeasuredStage* stage : {&pass.vertex, &pass.fragment}) {
                EXPECT_EQ(sum_of(stage->shares, &CostShare::once), stage->cost.once) << graph << ' ' << pass.name;
                EXPECT_EQ(sum_of(stage->shares, &CostShare::per_light), stage->cost.per_light)
                    << graph << ' ' << pass.name;
            }
            for (const CostShare& share : pass.fragment.shares)
                with_shares += share.part == CostShare::Part::Node && share.once.instructions > 0;
            for (const Shader& shader : result.shaders) {
                if (shader.pass != pass.name) continue;
                const bool is_vertex = shader.stage == Stage::Vertex;
                const StageCost plain = count(optimised(validate(shader).spirv), shader.stage).total;
                EXPECT_EQ(plain.total(), (is_vertex ? pass.cost.vertex : pass.cost.fragment).total())
                    << graph << ' ' << shader.file_name;
            }
        }
    }
    EXPECT_GT(with_shares, 100u);
}

// 18 levels of sub-graphs, each of which uses the next one twice: few lines, and spirv-opt would not come back.
TEST(Cost, OfUsesThatDoubleIsRefused) {
    const Compiler compiler;
    CompileOptions options;
    options.targets = {Target::Glsl};
    options.files.read = [](const std::string& path) -> std::optional<std::string> {
        const int level = std::stoi(path.substr(1));
        const std::string next = R"("node": "./s)" + std::to_string(level + 1) + R"(.subgraph.json", "in": { "x": "= )";
        const std::string nodes =
            level == 18 ? R"json({ "id": "a", "expr": "sin($x)" }, { "id": "b", "expr": "cos($x)" })json"
                        : R"({ "id": "a", )" + next + R"($x + 1" } }, { "id": "b", )" + next + R"($x * 2" } })";
        return R"({ "patina": 1, "kind": "subgraph", "inputs": [ { "name": "x", "type": "float" } ],
                    "nodes": [ )" +
               nodes + R"( ], "outputs": { "v": "= a + b" } })";
    };
    const auto compile = [&](const std::string& file) {
        return compiler.compile_text("test.graph.json", R"({ "patina": 1, "workflow": "unlit", "nodes": [
            { "id": "few", "node": "./s12.subgraph.json", "in": { "x": "@uv0.x" } },
            { "id": "all", "node": "./)" + file + R"(.subgraph.json", "in": { "x": "= few" } } ],
            "surface": { "color": "= all" } })",
                                     options);
    };
    const Result few = compile("s12");
    ASSERT_TRUE(few.ok);
    EXPECT_TRUE(refusals(few, measure(few)).empty());
    const Result many = compile("s1");
    ASSERT_TRUE(many.ok);
    const std::vector<MeasuredPass> passes = measure(many);
    ASSERT_FALSE(passes.empty());
    EXPECT_TRUE(std::ranges::any_of(passes, [](const MeasuredPass& pass) { return !pass.fragment.ok; }));
    const std::vector<Diagnostic> why = refusals(many, passes);
    ASSERT_FALSE(why.empty());
    for (const Diagnostic& each : why) {
        EXPECT_EQ(each.code, "over-budget");
        EXPECT_NE(each.message.find("more than the budget of 200000"), std::string::npos) << each.message;
        EXPECT_EQ(each.file, "s3.subgraph.json");  // the innermost use that is too much by itself
        EXPECT_EQ(each.node, "all/a/a/a");
    }
}

// The time of spirv-val and spirv-opt grows with the square of the branches, and nobody can stop them.
TEST(Cost, OfManyBranchesIsNotCounted) {
    const Compiler compiler;
    const auto compile = [&](int branches) {
        CompileOptions options;
        options.targets = {Target::Glsl};
        options.files.read = [branches](const std::string&) -> std::optional<std::string> {
            std::string text = "[node(\"Test/F\")]\nfloat F(float2 uv = uv0) {\n    float s = uv.x;\n";
            for (int i = 0; i < branches; ++i) text += "    if (uv.x > " + std::to_string(i) + ") { s += uv.y; }\n";
            return text + "    return s;\n}\n";
        };
        return compiler.compile_text("test.graph.json", R"({ "patina": 1, "workflow": "unlit", "nodes": [
            { "id": "a", "node": "./f.node.hlsl" } ], "surface": { "color": "= a" } })",
                                     options);
    };
    const auto fragment = [](const Result& result) {
        return *std::ranges::find(result.shaders, Stage::Fragment, &Shader::stage);
    };
    const Result few = compile(100), many = compile(3000), most = compile(9000);
    ASSERT_TRUE(few.ok && many.ok && most.ok);
    EXPECT_TRUE(refusals(few, measure(few)).empty());
    const Validated accepted = validate(fragment(many));
    EXPECT_TRUE(accepted.ok);
    const std::optional<Diagnostic> why = too_large(fragment(many), accepted.spirv);
    ASSERT_TRUE(why);
    EXPECT_EQ(why->code, "over-budget");
    EXPECT_NE(why->message.find("blocks of branches"), std::string::npos) << why->message;
    const Validated refused = validate(fragment(most));
    EXPECT_FALSE(refused.ok);
    ASSERT_EQ(refused.diagnostics.size(), 1u);
    EXPECT_EQ(refused.diagnostics[0].code, "over-budget");
    EXPECT_EQ(refused.diagnostics[0].file, "test.graph.json");
    EXPECT_EQ(refused.diagnostics[0].node, "a");
}

// A model has one loop over lights, and a shader without lights has none, whatever other loops there are.
TEST(Cost, OfModelsIsPerLight) {
    const Compiler compiler;
    CompileOptions options;
    options.targets = {Target::Glsl};
    options.request = CompileOptions::Passes{.only = {"forward"}};
    const auto per_light = [&](const std::string& text) -> std::uint32_t {
        const Result result = compiler.compile_text("cost.graph.json", text, options);
        EXPECT_TRUE(result.ok) << text;
        const std::vector<MeasuredPass> passes = measure(result);
        EXPECT_EQ(passes.size(), 1u);
        EXPECT_LT(passes[0].cost.fragment.per_light.instructions, passes[0].cost.fragment.total().instructions);
        return passes[0].cost.fragment.per_light.instructions;
    };
    for (const ModelInfo& model : compiler.lighting_models()) {
        const std::uint32_t count = per_light(R"({ "patina": 1, "workflow": "metallic-roughness", "lighting": ")" +
                                              model.name + R"(", "surface": {} })");
        if (model.name == "unlit")
            EXPECT_EQ(count, 0u);
        else
            EXPECT_GT(count, 20u) << model.name;
    }
    EXPECT_EQ(per_light(R"({ "patina": 1, "workflow": "unlit", "nodes": [
                             { "id": "grain", "node": "FractalNoise", "in": { "scale": 12, "octaves": 5 } } ],
                             "surface": { "color": "= float3(1, 1, 1) * grain" } })"),
              0u);
}

}  // namespace
}  // namespace patina
