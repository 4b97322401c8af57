// A program can end each call of the library whenever it is asked: the call gives the error `cancelled`, and nothing
// else.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "compiler/base/cancellation.h"
#include "patina/graph_diff.h"
#include "patina/graph_view.h"
#include "patina/variants.h"
#include "tests/unit/api/large_texts.h"

namespace patina {
namespace {

TEST(Cancelled, AsksAfterSoManySteps) {
    int asked = 0;
    bool stop = false;
    const std::function<bool()> ask = [&] { return ++asked, stop; };
    const Cancellation cancellation(ask);
    for (std::size_t i = 0; i < 10 * Cancellation::kStepsPerQuestion; ++i) Cancellation::step();
    EXPECT_EQ(asked, 10);
    {
        const Cancellation inner;  // asks nobody
        Cancellation::step(100 * Cancellation::kStepsPerQuestion);
        EXPECT_EQ(asked, 10);
    }
    stop = true;
    EXPECT_THROW(Cancellation::step(Cancellation::kStepsPerQuestion), Stopped);
}

std::optional<std::string> large_file(const std::string& path) {
    std::string text;
    if (path == "large.graph.json") return chain_of_nodes(1500);
    if (path == "large.node.hlsl") {
        for (int i = 0; i < 1000; ++i) text += "float f" + std::to_string(i) + "(float x) { return sin(x) + 1; }\n";
        return text + node("float s = uv.x; for (int i = 0; i < 4000; i++) { s = sin(s); } return s;",
                           "/// F.\n/// test: F(float2(0, 0)) == 0\n");
    }
    if (path == "large.scene.json") {
        text = R"({ "patina": 1, "kind": "scene", "meta": [ 0)";
        for (int i = 0; i < 20000; ++i) text += ", 1";
        return text + " ] }";
    }
    return std::nullopt;
}

// What each call does, with as many steps as a large file needs. True if it ended with the error `cancelled` alone.
struct Call {
    const char* name;
    bool (*is_cancelled)(const CompileOptions&);
};

bool is_cancelled(const std::vector<Diagnostic>& diagnostics) {
    return std::count_if(diagnostics.begin(), diagnostics.end(),
                         [](const Diagnostic& each) { return each.code == "cancelled"; }) == 1;
}

const Call kCalls[] = {
    {"compile_file",
     [](const CompileOptions& options) {
         CompileOptions own = options;
         own.keep_programs = true;
         own.dump = {"ir"};
         const Result result = compiler().compile_file("large.graph.json", own);
         return !result.ok && result.shaders.empty() && !result.program && is_cancelled(result.diagnostics);
     }},
    {"check_node_file",
     [](const CompileOptions& options) {
         const NodeFileResult result = compiler().check_node_file("large.node.hlsl", options);
         return !result.ok && is_cancelled(result.diagnostics);
     }},
    {"read_scene",
     [](const CompileOptions& options) {
         const SceneResult result = compiler().read_scene("large.scene.json", options);
         return !result.ok && is_cancelled(result.diagnostics);
     }},
    {"cache_key",
     [](const CompileOptions& options) { return compiler().cache_key("large.graph.json", options).empty(); }},
    {"plan_variants",
     [](const CompileOptions& options) {
         const VariantPlan plan =
             compiler().plan_variants("large.graph.json", VariantsWanted::All, options, kVariantLimit);
         return !plan.ok && is_cancelled(plan.diagnostics);
     }},
    {"view_graph",
     [](const CompileOptions& options) {
         const GraphView view = view_graph(compiler(), "large.graph.json", options);
         return !view.ok && is_cancelled(view.diagnostics);
     }},
    {"format",
     [](const CompileOptions& options) {
         const Compiler::Formatted made = compiler().format("g", chain_of_nodes(3000), options.limits);
         return !made.ok && made.text.empty() && is_cancelled(made.diagnostics);
     }},
    {"diff_graphs",
     [](const CompileOptions& options) {
         const GraphDiff diff =
             diff_graphs({"before", chain_of_nodes(1500)}, {"after", chain_of_nodes(1600)}, options.limits);
         return !diff.ok && diff.changes.empty() && is_cancelled(diff.diagnostics);
     }},
};

// At the first question, at each of the next ones, and at some of all others.
TEST(Cancelled, EndsEachCallWhereverItHappens) {
    CompileOptions options;
    options.files.read = large_file;
    const Result before = compiler().compile_file("large.graph.json", options);
    ASSERT_TRUE(before.ok) << said(before.diagnostics);
    for (const Call& call : kCalls) {
        // What the compiler keeps makes later calls shorter, and so there are fewer questions.
        options.limits.cancelled = nullptr;
        for (int i = 0; i < 3; ++i) EXPECT_FALSE(call.is_cancelled(options)) << call.name;
        int asked = 0, stop = 0;
        options.limits.cancelled = [&] { return ++asked == stop; };
        EXPECT_FALSE(call.is_cancelled(options)) << call.name;
        const int all = asked;
        EXPECT_GT(all, 4) << call.name;
        for (stop = 1; stop <= all; stop += stop < 8 ? 1 : 1 + all / 40) {
            asked = 0;
            EXPECT_TRUE(call.is_cancelled(options)) << call.name << " at question " << stop << " of " << all;
            EXPECT_EQ(asked, stop) << call.name;  // the program is not asked again
        }
    }
    options.limits.cancelled = nullptr;
    const Result after = compiler().compile_file("large.graph.json", options);
    ASSERT_EQ(after.shaders.size(), before.shaders.size());
    for (std::size_t i = 0; i < after.shaders.size(); ++i) EXPECT_EQ(after.shaders[i].text, before.shaders[i].text);
}

}  // namespace
}  // namespace patina
