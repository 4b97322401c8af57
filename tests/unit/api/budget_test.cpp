// What a program allows a compilation: budgets, and cancelling.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "patina/patina.h"
#include "patina/variants.h"

namespace patina {
namespace {

const Compiler& compiler() {
    static const Compiler kCompiler;
    return kCompiler;
}

constexpr const char* kThree = R"json({
    "patina": 1, "workflow": "unlit",
    "nodes": [ { "id": "a", "expr": "@uv0.x" },
               { "id": "b", "expr": "a * 2" },
               { "id": "c", "expr": "a * b" } ],
    "surface": { "color": "= c" }
})json";

std::string said(const std::vector<Diagnostic>& diagnostics) {
    std::string all;
    for (const Diagnostic& diagnostic : diagnostics) all += to_text(diagnostic) + "\n";
    return all;
}

void expect_refused(const Result& result, std::string_view code) {
    EXPECT_FALSE(result.ok);
    EXPECT_TRUE(result.shaders.empty());
    EXPECT_EQ(std::count_if(result.diagnostics.begin(), result.diagnostics.end(),
                            [&](const Diagnostic& each) { return each.code == code; }),
              1)
        << said(result.diagnostics);
}

TEST(Budgets, OfNodesNameTheNodeThatPassesThem) {
    CompileOptions options;
    options.limits.nodes = 3;
    EXPECT_TRUE(compiler().compile_text("test.graph.json", kThree, options).ok);
    options.limits.nodes = 2;
    const Result result = compiler().compile_text("test.graph.json", kThree, options);
    expect_refused(result, "over-budget");
    EXPECT_EQ(result.diagnostics[0].message, "nodes: 3, more than the budget of 2");
    EXPECT_EQ(result.diagnostics[0].node, "c");
    EXPECT_EQ(result.diagnostics[0].line, 5);
}

// 60 levels of sub-graphs, each of which uses the next one twice: no machine could compile that.
TEST(Budgets, OfNodesCountEachUseOfASubGraph) {
    CompileOptions options;
    options.limits.nodes = 1000;
    options.files.read = [](const std::string& path) -> std::optional<std::string> {
        const int level = std::stoi(path.substr(1));
        const std::string next = "./s" + std::to_string(level + 1) + ".subgraph.json";
        const std::string nodes =
            level == 60 ? R"({ "id": "a", "expr": "@uv0.x" }, { "id": "b", "expr": "a" })"
                        : R"({ "id": "a", "node": ")" + next + R"(" }, { "id": "b", "node": ")" + next + R"(" })";
        return R"({ "patina": 1, "kind": "subgraph", "nodes": [ )" + nodes + R"( ], "outputs": { "v": "= a + b" } })";
    };
    const Result result = compiler().compile_text("test.graph.json", R"json({ "patina": 1, "workflow": "unlit",
        "nodes": [ { "id": "all", "node": "./s1.subgraph.json" } ], "surface": { "color": "= all" } })json",
                                                  options);
    EXPECT_FALSE(result.ok);
    ASSERT_FALSE(result.diagnostics.empty());
    EXPECT_EQ(result.diagnostics[0].code, "over-budget");
    EXPECT_EQ(result.diagnostics[0].message, "nodes: 1022, more than the budget of 1000");
}

TEST(Budgets, OfTextCountTheGraphAndItsFiles) {
    const std::string graph = R"json({ "patina": 1, "workflow": "unlit",
        "nodes": [ { "id": "wave", "node": "./wave.node.hlsl" } ], "surface": { "color": "= wave" } })json";
    const std::string wave = "/// A wave.\n[node(\"Test/Wave\")]\nfloat Wave(float2 uv = uv0) { return sin(uv.x); }\n";
    CompileOptions options;
    options.files.read = [&](const std::string& path) {
        return path == "wave.node.hlsl" ? std::optional(wave)
               : path == "f.graph.json" ? std::optional(graph)
                                        : std::nullopt;
    };
    options.limits.source_bytes = graph.size() + wave.size();
    EXPECT_TRUE(compiler().compile_text("test.graph.json", graph, options).ok);
    EXPECT_TRUE(compiler().compile_file("f.graph.json", options).ok);
    --options.limits.source_bytes;
    Result result = compiler().compile_text("test.graph.json", graph, options);
    expect_refused(result, "over-budget");
    EXPECT_EQ(result.diagnostics[0].node, "wave");
    options.limits.source_bytes = graph.size() - 1;
    expect_refused(compiler().compile_text("test.graph.json", graph, options), "over-budget");
    expect_refused(compiler().compile_file("f.graph.json", options), "over-budget");
}

TEST(Budgets, OfShadersCountAllTargets) {
    CompileOptions options;
    const Result whole = compiler().compile_text("test.graph.json", kThree, options);
    std::size_t bytes = 0;
    for (const Shader& shader : whole.shaders) bytes += shader.text.size();
    options.limits.shader_bytes = bytes;
    EXPECT_TRUE(compiler().compile_text("test.graph.json", kThree, options).ok);
    options.limits.shader_bytes = bytes - 1;
    const Result result = compiler().compile_text("test.graph.json", kThree, options);
    expect_refused(result, "over-budget");
    EXPECT_EQ(result.diagnostics[0].message, "bytes of shader text: " + std::to_string(bytes) +
                                                 ", more than the budget of " + std::to_string(bytes - 1));
}

// A budget of nothing is passed by the first node, once.
TEST(Budgets, OfNoNodeAreToldOnce) {
    CompileOptions options;
    options.limits.nodes = 0;
    options.files.read = [](const std::string&) {
        return R"({ "patina": 1, "kind": "subgraph", "nodes": [ { "id": "a", "expr": "@uv0.x" } ],
                    "outputs": { "v": "a" } })";
    };
    const Result result = compiler().compile_text("test.graph.json", R"json({ "patina": 1, "workflow": "unlit",
        "nodes": [ { "id": "s", "node": "./s.subgraph.json" }, { "id": "b", "expr": "s" } ],
        "surface": { "color": "= b" } })json",
                                                  options);
    expect_refused(result, "over-budget");
    EXPECT_EQ(result.diagnostics[0].message, "nodes: 1, more than the budget of 0");
}

TEST(Switches, HaveOneValue) {
    CompileOptions options;
    options.switches = {{"shadows", ""}, {"fog", "false"}, {"shadows", "true"}};
    EXPECT_TRUE(compiler().compile_text("test.graph.json", kThree, options).ok);
    options.switches.emplace_back("fog", "true");
    const Result result = compiler().compile_text("test.graph.json", kThree, options);
    expect_refused(result, "two-values");
    EXPECT_EQ(result.diagnostics[0].message, "'fog' is 'false' already, and cannot be 'true' too");
}

// At each place where the compiler asks.
TEST(Cancelling, EndsWithOneErrorWhereverItHappens) {
    CompileOptions options;
    options.targets = {Target::Glsl, {"unity", "hlsl"}};
    // What the compiler keeps makes later compilations shorter, and so there are fewer questions. With another limit,
    // the request is another one, of which no whole result is kept.
    options.limits.nodes = 1000;
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(compiler().compile_text("test.graph.json", kThree, options).ok);
    options.limits.nodes = 1001;
    int calls = 0, cancelled_at = 0;
    options.limits.cancelled = [&] { return ++calls == cancelled_at; };
    const Result whole = compiler().compile_text("test.graph.json", kThree, options);
    EXPECT_TRUE(whole.ok) << said(whole.diagnostics);
    const int all = calls;
    EXPECT_GT(all, 20);
    for (cancelled_at = 1; cancelled_at <= all; ++cancelled_at) {
        calls = 0;
        expect_refused(compiler().compile_text("test.graph.json", kThree, options), "cancelled");
    }
}

TEST(Cancelling, ByAnExceptionSaysWhy) {
    CompileOptions options;
    options.limits.cancelled = []() -> bool { throw std::runtime_error("the window was closed"); };
    const Result result = compiler().compile_text("test.graph.json", kThree, options);
    expect_refused(result, "cancelled");
    EXPECT_EQ(result.diagnostics[0].message, "cancelled by the program: the window was closed");
}

// --- variants, one after the other

constexpr const char* kVariants = R"json({
    "patina": 1, "workflow": "unlit",
    "properties": [ { "name": "_Kind", "type": "enum", "values": ["A", "B", "C"], "as": "variant" },
                    { "name": "_Red", "type": "bool", "as": "variant" } ],
    "surface": { "color": "= ($_Kind == A ? 0.25 : 0.5) * ($_Red ? float3(1, 0, 0) : 1)" }
})json";

CompileOptions variant_options() {
    CompileOptions options;
    options.targets = {Target::Glsl, {"unity", "hlsl"}};
    options.files.read = [](const std::string&) { return std::optional<std::string>(kVariants); };
    return options;
}

TEST(StreamedVariants, AreThoseThatWouldHaveBeenKept) {
    const CompileOptions options = variant_options();
    const VariantPlan plan = compiler().plan_variants("v.graph.json", VariantsWanted::All, options, kVariantLimit);
    ASSERT_EQ(plan.count, 6u) << said(plan.diagnostics);
    const VariantSet kept = compiler().compile_variants("v.graph.json", plan, options);
    ASSERT_TRUE(kept.ok) << said(kept.diagnostics);
    ASSERT_EQ(kept.programs.size(), 4u);
    std::vector<VariantProgram> streamed;
    std::size_t next = 0;
    std::vector<std::size_t> came_at;
    const VariantSet set = compiler().compile_variants(
        "v.graph.json", plan, options, [&](std::size_t index) { next = index; },
        [&](VariantProgram program) {
            came_at.push_back(next);
            streamed.push_back(std::move(program));
        });
    ASSERT_TRUE(set.ok);
    EXPECT_EQ(came_at, (std::vector<std::size_t>{0, 1, 2, 3}));  // as soon as it is compiled
    EXPECT_EQ(set.program_of, kept.program_of);
    ASSERT_EQ(streamed.size(), kept.programs.size());
    ASSERT_EQ(set.programs.size(), kept.programs.size());
    for (std::size_t i = 0; i < streamed.size(); ++i) {
        EXPECT_EQ(streamed[i].hash, kept.programs[i].hash);
        EXPECT_EQ(set.programs[i].hash, kept.programs[i].hash);
        EXPECT_TRUE(set.programs[i].result.shaders.empty());
        EXPECT_EQ(streamed[i].result.reflection.to_json(), kept.programs[i].result.reflection.to_json());
        ASSERT_EQ(streamed[i].result.shaders.size(), kept.programs[i].result.shaders.size());
        EXPECT_EQ(streamed[i].result.shaders.size(), 3u);
        for (std::size_t s = 0; s < 3; ++s)
            EXPECT_EQ(streamed[i].result.shaders[s].text, kept.programs[i].result.shaders[s].text);
    }
}

// Printing is a long step of a large graph.
TEST(Cancelling, IsPossibleBeforeEachText) {
    const auto calls = [](std::vector<Target> targets) {
        std::size_t count = 0;
        CompileOptions options;
        options.targets = std::move(targets);
        options.limits.cancelled = [&] { return ++count == 0; };
        EXPECT_TRUE(compiler().compile_text("test.graph.json", kThree, options).ok);
        return count;
    };
    EXPECT_EQ(calls({Target::Glsl, Target::Hlsl}), calls({Target::Glsl}) + 1);
}

TEST(Variants, OfAPlanThatIsNotOkHaveItsErrors) {
    const CompileOptions options = variant_options();
    const VariantPlan plan = compiler().plan_variants("v.graph.json", VariantsWanted::All, options, 2);
    const VariantSet set = compiler().compile_variants("v.graph.json", plan, options);
    EXPECT_FALSE(set.ok);
    EXPECT_NE(said(set.diagnostics).find("6 combinations of variants are too many"), std::string::npos)
        << said(set.diagnostics);
    // The library does not speak of the command's options.
    EXPECT_EQ(said(set.diagnostics).find(" -D"), std::string::npos) << said(set.diagnostics);
}

TEST(Variants, OfFunctionsAreRefused) {
    CompileOptions options = variant_options();
    const VariantPlan plan = compiler().plan_variants("v.graph.json", VariantsWanted::All, options, kVariantLimit);
    options.request = CompileOptions::Functions{.prefix = "V_"};
    const VariantPlan refused =
        compiler().plan_variants("v.graph.json", VariantsWanted::Reachable, options, kVariantLimit);
    EXPECT_FALSE(refused.ok);
    ASSERT_EQ(refused.diagnostics.size(), 1u) << said(refused.diagnostics);
    EXPECT_EQ(refused.diagnostics[0].code, "no-program");
    for (const VariantPlan& each : {plan, refused}) {
        const VariantSet set = compiler().compile_variants("v.graph.json", each, options);
        EXPECT_FALSE(set.ok);
        EXPECT_TRUE(set.programs.empty());
        ASSERT_EQ(set.diagnostics.size(), 1u) << said(set.diagnostics);
        EXPECT_EQ(set.diagnostics[0].code, "no-program");
    }
}

TEST(StreamedVariants, EndWithAnErrorIfTheProgramsFunctionFails) {
    const CompileOptions options = variant_options();
    const VariantPlan plan = compiler().plan_variants("v.graph.json", VariantsWanted::All, options, kVariantLimit);
    int taken = 0;
    const VariantSet set = compiler().compile_variants("v.graph.json", plan, options, {}, [&](VariantProgram) {
        if (++taken == 2) throw std::runtime_error("the disk is full");
    });
    EXPECT_FALSE(set.ok);
    EXPECT_EQ(taken, 2);
    EXPECT_EQ(said(set.diagnostics), "error: cancelled by the program: the disk is full [cancelled]\n");
}

TEST(StreamedVariants, CanBeCancelledBetweenTwo) {
    CompileOptions options = variant_options();
    bool stop = false;
    int taken = 0;
    options.limits.cancelled = [&] { return stop; };
    const VariantPlan plan = compiler().plan_variants("v.graph.json", VariantsWanted::All, options, kVariantLimit);
    const VariantSet set =
        compiler().compile_variants("v.graph.json", plan, options, {}, [&](VariantProgram) { stop = ++taken == 2; });
    EXPECT_FALSE(set.ok);
    EXPECT_EQ(taken, 2);
    ASSERT_EQ(set.diagnostics.size(), 1u) << said(set.diagnostics);
    EXPECT_EQ(set.diagnostics[0].code, "cancelled");
}

}  // namespace
}  // namespace patina
