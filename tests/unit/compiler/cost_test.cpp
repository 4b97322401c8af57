// What shaders cost: numbers that were counted by hand in small modules and shaders; and for every example, shares of
// nodes that sum to the whole.
#include "patina/cost.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <spirv-tools/libspirv.hpp>

#include "compiler/validate/count.h"
#include "compiler/validate/expand_calls.h"
#include "compiler/validate/numbers.h"
#include "patina/validate.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

// --- modules

constexpr const char* kHead = R"(
    OpCapability Shader
    OpMemoryModel Logical GLSL450
    OpEntryPoint Fragment %main "main" %in
    OpExecutionMode %main OriginUpperLeft
    OpDecorate %in Location 0
    %void = OpTypeVoid
    %procedure = OpTypeFunction %void
    %float = OpTypeFloat 32
    %int = OpTypeInt 32 1
    %bool = OpTypeBool
    %float3 = OpTypeVector %float 3
    %input = OpTypePointer Input %float3
    %in = OpVariable %input Input
    %unary = OpTypeFunction %float %float
    %one = OpConstant %float 1
    %zero = OpConstant %int 0
    %true = OpConstantTrue %bool
)";

spirv::Spirv assembled(const std::string& functions) {
    std::vector<std::uint32_t> words;
    const spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
    EXPECT_TRUE(tools.Assemble(kHead + functions, &words));
    return spirv::parse(std::move(words));
}

struct Count {
    Instructions once{}, per_light{};
};
Count count(const spirv::Spirv& module) {
    Count made;
    spirv::for_each_run(
        module, [](const spirv::Instruction&) { return true; },
        [&](const spirv::Instruction& at, bool per_light) { spirv::add(per_light ? made.per_light : made.once, at); });
    return made;
}

TEST(CountOfInstructions, OfNothing) {
    EXPECT_TRUE(spirv::parse({}).instructions.empty());
    EXPECT_TRUE(spirv::parse({1, 2, 3, 4, 5, 6}).instructions.empty());
    EXPECT_EQ(count(spirv::parse({})).once, Instructions{});
}

TEST(CountOfInstructions, ByWhatComputesThem) {
    const Count made = count(assembled(R"(
        %main = OpFunction %void None %procedure
        %0 = OpLabel
        %a = OpLoad %float3 %in
        %b = OpFAdd %float3 %a %a
        %c = OpDot %float %a %b
        %d = OpFDiv %float %c %c
        %e = OpDPdx %float %d
        OpReturn
        OpFunctionEnd)"));
    EXPECT_EQ(made.once, (Instructions{.arithmetic = 2, .transcendental = 1, .derivative = 1, .other = 2}));
    EXPECT_EQ(made.once.total(), 6u);
    EXPECT_EQ(made.per_light, Instructions{});
}

// A function counts for each of its calls, in the loop as in the loop; the one that nobody calls does not count.
TEST(CountOfInstructions, OfALoopThatCalls) {
    const Count made = count(assembled(R"(
        %main = OpFunction %void None %procedure
        %0 = OpLabel
        %x = OpFunctionCall %float %f %one
        OpBranch %head
        %head = OpLabel
        OpLoopMerge %end %next None
        OpBranchConditional %true %body %end
        %body = OpLabel
        %y = OpFunctionCall %float %f %one
        %z = OpFunctionCall %float %f %y
        OpBranch %next
        %next = OpLabel
        OpBranch %head
        %end = OpLabel
        OpReturn
        OpFunctionEnd
        %f = OpFunction %float None %unary
        %p = OpFunctionParameter %float
        %1 = OpLabel
        %q = OpFMul %float %p %p
        OpReturnValue %q
        OpFunctionEnd
        %unused = OpFunction %float None %unary
        %r = OpFunctionParameter %float
        %2 = OpLabel
        %s = OpFMul %float %r %r
        OpReturnValue %s
        OpFunctionEnd)"));
    // A call, its function, the branch to the loop, and the return.
    EXPECT_EQ(made.once, (Instructions{.arithmetic = 1, .other = 4}));
    // Two calls, their functions, and three branches.
    EXPECT_EQ(made.per_light, (Instructions{.arithmetic = 2, .other = 2 + 2 + 3}));
}

// All of a loop in a loop is in the outer one, once; what comes after is not.
TEST(CountOfInstructions, OfALoopInALoop) {
    const Count made = count(assembled(R"(
        %main = OpFunction %void None %procedure
        %0 = OpLabel
        OpBranch %head
        %head = OpLabel
        OpLoopMerge %end %next None
        OpBranchConditional %true %inner %end
        %inner = OpLabel
        OpLoopMerge %innerEnd %innerNext None
        OpSwitch %zero %innerNext 1 %case
        %case = OpLabel
        OpBranch %innerEnd
        %innerNext = OpLabel
        OpBranch %inner
        %innerEnd = OpLabel
        OpBranch %next
        %next = OpLabel
        OpBranch %head
        %end = OpLabel
        OpReturn
        OpFunctionEnd)"));
    EXPECT_EQ(made.per_light.total(), 6u);
    EXPECT_EQ(made.once.total(), 2u);
}

// a and b are alive together (6 numbers), and with c (7) where they are read; then only numbers that are smaller.
TEST(LiveNumbers, InOneBlock) {
    EXPECT_EQ(spirv::live_numbers(assembled(R"(
        %main = OpFunction %void None %procedure
        %0 = OpLabel
        %a = OpLoad %float3 %in
        %b = OpFAdd %float3 %a %a
        %c = OpDot %float %a %b
        %d = OpVectorTimesScalar %float3 %b %c
        %e = OpFAdd %float3 %d %a
        OpReturn
        OpFunctionEnd)")),
              7u);
}

// a is read after the loop, so it is alive in it: with i and its next value in the body.
TEST(LiveNumbers, AroundALoop) {
    EXPECT_EQ(spirv::live_numbers(assembled(R"(
        %main = OpFunction %void None %procedure
        %0 = OpLabel
        %a = OpLoad %float3 %in
        OpBranch %head
        %head = OpLabel
        %i = OpPhi %float %one %0 %j %next
        OpLoopMerge %end %next None
        OpBranchConditional %true %next %end
        %next = OpLabel
        %j = OpFAdd %float %i %one
        OpBranch %head
        %end = OpLabel
        %s = OpFAdd %float3 %a %a
        OpReturn
        OpFunctionEnd)")),
              4u);
}

// The array is alive everywhere; during the call, a and what the function needs: p, with its square.
TEST(LiveNumbers, OfVariablesAndCalls) {
    EXPECT_EQ(spirv::live_numbers(assembled(R"(
        %four = OpConstant %int 4
        %array = OpTypeArray %float %four
        %local = OpTypePointer Function %array
        %main = OpFunction %void None %procedure
        %0 = OpLabel
        %v = OpVariable %local Function
        %a = OpLoad %float3 %in
        %x = OpFunctionCall %float %f %one
        %b = OpVectorTimesScalar %float3 %a %x
        OpReturn
        OpFunctionEnd
        %f = OpFunction %float None %unary
        %p = OpFunctionParameter %float
        %1 = OpLabel
        %q = OpFMul %float %p %p
        %r = OpFAdd %float %p %q
        OpReturnValue %r
        OpFunctionEnd)")),
              4u + 3u + 2u);
}

TEST(LiveNumbers, OfTheInterface) {
    const spirv::Spirv module =
        assembled("%main = OpFunction %void None %procedure\n%0 = OpLabel\nOpReturn\nOpFunctionEnd");
    EXPECT_EQ(spirv::interface_numbers(module, spv::StorageClassInput), 3u);
    EXPECT_EQ(spirv::interface_numbers(module, spv::StorageClassOutput), 0u);
}

// --- shares

// A line of a node; without a node, of the rendering path.
LineOrigin line_of(int line, std::string node) {
    LineOrigin made;
    made.line = made.source_line = line;
    made.node = std::move(node);
    if (!made.node.empty()) made.file = "a.graph.json";
    return made;
}

const NodeCost* find(const StageCost& cost, std::string_view node) {
    const auto found = std::ranges::find(cost.nodes, node, &NodeCost::node);
    return found == cost.nodes.end() ? nullptr : &*found;
}

Instructions sum(const StageCost& cost, Instructions NodeCost::*part) {
    Instructions all;
    for (const NodeCost& node : cost.nodes) all += node.*part;
    return all;
}

// Two nodes call one function, and one of them computes more. Each has the function's sine and its own product.
TEST(Shares, OfAFunctionThatTwoNodesCall) {
    Shader shader;
    shader.stage = Stage::Fragment;
    shader.text =
        "#version 450\n"
        "layout(location = 0) in vec2 v;\n"
        "layout(location = 0) out vec4 color;\n"
        "float wave(float x) { return sin(x); }\n"
        "void main() {\n"
        "    float a = wave(v.x) * 3.0;\n"
        "    float b = sqrt(wave(v.y)) * 5.0;\n"
        "    color = vec4(a, b, 0.0, 1.0);\n"
        "}\n";
    shader.line_map = {line_of(6, "a"), line_of(7, "b"), line_of(8, "")};
    std::vector<Diagnostic> diagnostics;
    const std::optional<StageCost> cost = measure_cost(shader, diagnostics);
    ASSERT_TRUE(cost) << diagnostics.front().message;
    const NodeCost *a = find(*cost, "a"), *b = find(*cost, "b"), *rest = find(*cost, "");
    ASSERT_TRUE(a && b && rest);
    EXPECT_EQ(a->once.transcendental, 1u);
    EXPECT_EQ(b->once.transcendental, 2u);
    EXPECT_EQ(a->once.arithmetic, 1u);
    EXPECT_EQ(b->once.arithmetic, 1u);
    EXPECT_EQ(rest->once.transcendental + rest->once.arithmetic, 0u);
    EXPECT_EQ(cost->varyings, 2u);
    EXPECT_EQ(sum(*cost, &NodeCost::once), cost->once);
}

// The loop of a node is no loop over lights; that of a line without a place in a graph is one.
TEST(Shares, OfLoops) {
    Shader shader;
    shader.stage = Stage::Fragment;
    shader.text =
        "#version 450\n"
        "layout(location = 0) flat in int n;\n"
        "layout(location = 0) out float color;\n"
        "void main() {\n"
        "    float a = 1.0;\n"
        "    for (int i = 0; i < n; ++i)\n"
        "        a = cos(a);\n"
        "    for (int i = 0; i < n; ++i)\n"
        "        a = exp(a);\n"
        "    color = a;\n"
        "}\n";
    shader.line_map = {line_of(5, "a"), line_of(8, "")};
    std::vector<Diagnostic> diagnostics;
    const std::optional<StageCost> cost = measure_cost(shader, diagnostics);
    ASSERT_TRUE(cost);
    EXPECT_EQ(cost->once.transcendental, 1u);
    EXPECT_EQ(cost->per_light.transcendental, 1u);
    ASSERT_TRUE(find(*cost, "a"));
    EXPECT_EQ(find(*cost, "a")->once.transcendental, 1u);
}

TEST(Shares, OfAShaderThatDoesNotCompile) {
    Shader shader;
    shader.text = "#version 450\nvoid main() { x; }\n";
    std::vector<Diagnostic> diagnostics;
    EXPECT_FALSE(measure_cost(shader, diagnostics));
    ASSERT_EQ(diagnostics.size(), 1u);
    EXPECT_EQ(diagnostics.front().code, "downstream-error");
}

// --- the examples

CompileOptions glsl() {
    CompileOptions options;
    options.targets = {Target::Glsl};
    return options;
}

// The rendering paths limit the number of lights where they have a loop.
bool has_lights(const std::string& text) {
    return text.find("min(lightCount") != text.npos || text.find("min(vertexLightCount") != text.npos;
}

// Shares sum to the whole; copies of functions change nothing; loops over lights are what is counted for each light.
void check_stage(const Shader& shader) {
    std::vector<Diagnostic> diagnostics;
    const std::optional<StageCost> cost = measure_cost(shader, diagnostics);
    ASSERT_TRUE(cost) << shader.file_name;
    EXPECT_EQ(sum(*cost, &NodeCost::once), cost->once) << shader.file_name;
    EXPECT_EQ(sum(*cost, &NodeCost::per_light), cost->per_light) << shader.file_name;
    EXPECT_GT(cost->once.total(), 0u);
    const Count plain = count(spirv::parse(optimised(validate(shader).spirv)));
    EXPECT_EQ(plain.once.total() + plain.per_light.total(), cost->total()) << shader.file_name;
    EXPECT_EQ(cost->per_light.total() > 0, has_lights(shader.text)) << shader.file_name;
}

TEST(Costs, OfEveryExample) {
    const Compiler compiler;
    std::size_t graphs = 0;
    for (const char* folder : {"examples/graphs", "examples/sources", "examples/surfaces"}) {
        for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
            if (!entry.path().string().ends_with(".graph.json")) continue;
            ++graphs;
            const Result result = compiler.compile_file(entry.path().string(), glsl());
            ASSERT_TRUE(result.ok) << entry.path();
            for (const Shader& shader : result.shaders) check_stage(shader);
        }
    }
    EXPECT_GT(graphs, 30u);
}

TEST(Costs, OfEveryPath) {
    CompileOptions options = glsl();
    options.path = "all";
    const Result result = Compiler().compile_file("examples/graphs/rusted_steel.graph.json", options);
    ASSERT_TRUE(result.ok);
    for (const Shader& shader : result.shaders) check_stage(shader);
    const MaterialCost cost = measure_cost(result);
    ASSERT_TRUE(cost.ok);
    EXPECT_EQ(cost.passes.size(), result.reflection.passes.size());
    const auto forward = std::ranges::find(cost.passes, "forward", &PassCost::name);
    ASSERT_NE(forward, cost.passes.end());
    EXPECT_EQ(forward->textures, 4u) << "colour, normal, roughness with metalness; the environment";
    EXPECT_GT(forward->uniform_bytes, 0u);
    EXPECT_GT(forward->fragment.registers, 20u);
    EXPECT_EQ(forward->fragment.varyings, 2u + 3u + 3u + 4u);
}

// The key comes after all others, and the rest is unchanged.
TEST(Costs, InTheReflection) {
    const Result result = Compiler().compile_text(
        "a.graph.json", R"({ "patina": 1, "workflow": "unlit", "surface": { "color": [1, 0, 0] } })", glsl());
    const std::string plain = result.reflection.to_json(), with = with_cost(plain, measure_cost(result));
    EXPECT_TRUE(with.starts_with(plain.substr(0, plain.size() - 3)));
    EXPECT_NE(with.find(",\n  \"cost\": [\n    {\n      \"name\": \"forward\""), with.npos) << with;
    EXPECT_TRUE(with.ends_with("\n  ]\n}\n"));
}

}  // namespace
}  // namespace patina
