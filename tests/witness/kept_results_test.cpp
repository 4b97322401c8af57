// What a compiler keeps of earlier compilations changes no result. All examples, all lighting models along all paths
// and random graphs are compiled by one compiler, in one order and in another, and by compilers that have compiled
// nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "compiler/base/remembered.h"
#include "witness/random_graph.h"

namespace patina::witness {
namespace {

namespace fs = std::filesystem;

struct Graph {
    std::string path, text;
    std::map<std::string, std::string> files{};
    std::string along = "all";
};

// All that a program gets, as one text.
std::string compiled_for(const Compiler& compiler, const Graph& graph, std::vector<Target> targets,
                         const std::string& along) {
    CompileOptions options;
    options.request = CompileOptions::Passes{.path = along};
    options.targets = std::move(targets);
    options.hashes = true;
    if (!graph.files.empty()) {
        options.files.read = [&](const std::string& path) {
            const auto found = graph.files.find(path);
            return found == graph.files.end() ? std::nullopt : std::optional(found->second);
        };
    }
    const Result result = compiler.compile_text(graph.path, graph.text, options);
    std::string all = result.ok ? result.reflection.to_json() : "it does not compile\n";
    for (const Diagnostic& diagnostic : result.diagnostics) all += to_json(diagnostic) + "\n";
    for (const Shader& shader : result.shaders) {
        all += "--- " + shader.file_name + " " + shader.hash + "\n" + shader.text;
        for (const int line : shader.light_loops) all += "light loop " + std::to_string(line) + "\n";
        for (const LineOrigin& line : shader.line_map)
            all += std::to_string(line.line) + " " + line.node + " " + line.file + ":" +
                   std::to_string(line.source_line) + ":" + std::to_string(line.source_column) + "-" +
                   std::to_string(line.source_end_column) + " " + line.source_text + "\n";
    }
    return all;
}

std::string compiled(const Compiler& compiler, const Graph& graph) {
    return compiled_for(compiler, graph, {Target::Glsl, Target::Hlsl}, graph.along) +
           compiled_for(compiler, graph, {Target{.engine = "unity", .language = "hlsl"}}, "forward");
}

// Each graph by a compiler of its own.
std::vector<std::string> compiled_alone(const std::vector<Graph>& graphs) {
    std::vector<std::string> made;
    for (const Graph& graph : graphs) made.push_back(compiled(Compiler(), graph));
    return made;
}

void expect_same(const Compiler& warm, const Graph& graph, const std::string& alone) {
    const std::string made = compiled(warm, graph);
    if (made == alone) return;
    const auto [a, b] = std::mismatch(alone.begin(), alone.end(), made.begin(), made.end());
    const auto around = [](const std::string& text, std::size_t at) {
        return text.substr(at < 200 ? 0 : at - 200, 400);
    };
    ADD_FAILURE() << graph.path << " along " << graph.along << "\n--- alone\n"
                  << around(alone, static_cast<std::size_t>(a - alone.begin())) << "\n--- after others\n"
                  << around(made, static_cast<std::size_t>(b - made.begin()));
}

// What a compiler kept of the others, and then of the same graphs. It keeps what is asked for twice, so the third
// compilation of a graph finds it.
void expect_kept_results_change_nothing(const std::vector<Graph>& graphs) {
    const std::vector<std::string> alone = compiled_alone(graphs);
    const Compiler warm;
    for (std::size_t i = 0; i < graphs.size(); ++i)
        for (int round = 0; round < 3; ++round) expect_same(warm, graphs[i], alone[i]);
    for (std::size_t i = graphs.size(); i-- > 0;) expect_same(warm, graphs[i], alone[i]);
}

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<Graph> examples() {
    std::vector<Graph> graphs;
    for (const fs::directory_entry& entry : fs::directory_iterator(PATINA_EXAMPLES)) {
        if (entry.path().string().ends_with(".graph.json"))
            graphs.push_back({.path = entry.path().string(), .text = read(entry.path())});
    }
    std::sort(graphs.begin(), graphs.end(), [](const Graph& a, const Graph& b) { return a.path < b.path; });
    return graphs;
}

TEST(KeptResults, ChangeNoExample) {
    expect_kept_results_change_nothing(examples());
}

// Equal functions in other places: each line of the map names the place in this text.
TEST(KeptResults, ChangeNoExampleThatHasMoved) {
    std::vector<Graph> graphs = examples();
    const Compiler warm;
    for (const Graph& graph : graphs)
        for (int round = 0; round < 2; ++round) compiled(warm, graph);
    for (Graph& graph : graphs) graph.text = "// One line more.\n" + graph.text;
    const std::vector<std::string> alone = compiled_alone(graphs);
    for (std::size_t i = 0; i < graphs.size(); ++i) expect_same(warm, graphs[i], alone[i]);
}

// The first workflow that the model goes with.
std::string material_of(const Compiler& compiler, const ModelInfo& model) {
    for (const ModelInfo& workflow : compiler.workflows()) {
        const std::string text =
            R"({ "patina": 1, "workflow": ")" + workflow.name + R"(", "lighting": ")" + model.name + "\" }";
        if (compiler.compile_text("m.graph.json", text).ok) return text;
    }
    ADD_FAILURE() << model.name << " goes with no workflow";
    return {};
}

TEST(KeptResults, ChangeNoModelAlongAnyPath) {
    std::vector<Graph> graphs;
    const Compiler compiler;
    for (const ModelInfo& model : compiler.lighting_models()) {
        const std::string text = material_of(compiler, model);
        for (const PathInfo& path : compiler.paths())
            graphs.push_back({.path = model.name + ".graph.json", .text = text, .along = path.name});
    }
    expect_kept_results_change_nothing(graphs);
}

// A function of the library has other names for its locals where a property has taken the usual ones.
TEST(KeptResults, GiveWayToTheNamesOfProperties) {
    std::vector<Graph> graphs;
    for (const std::string name : {"_Tint", "alpha", "cosine", "ndotl", "sum", "m2", "light", "SchlickWeight"}) {
        graphs.push_back({.path = "named.graph.json",
                          .text = R"({ "patina": 1, "workflow": "metallic-roughness", "lighting": "unity-brdf1",
                              "properties": [ { "name": ")" +
                                  name + R"(", "type": "color", "default": "#808080" } ],
                              "surface": { "baseColor": "= $)" +
                                  name + R"(.rgb" } })"});
    }
    expect_kept_results_change_nothing(graphs);
}

TEST(KeptResults, ChangeNoRandomGraph) {
    const Compiler compiler;
    std::vector<Graph> graphs;
    for (unsigned seed = 0; seed < 1000; ++seed) {
        const GraphText text = random_graph(compiler, seed).exact;
        graphs.push_back(
            {.path = std::to_string(seed) + ".graph.json", .text = text.json, .files = text.files, .along = "forward"});
    }
    expect_kept_results_change_nothing(graphs);
}

TEST(KeptResults, ChangeNothingForSeveralThreads) {
    const std::vector<Graph> graphs = examples();
    const std::vector<std::string> alone = compiled_alone(graphs);
    const Compiler warm;
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < 4; ++t) {
        threads.emplace_back([&, t] {
            for (std::size_t i = 0; i < graphs.size(); ++i) {
                const std::size_t at = (i + t * graphs.size() / 4) % graphs.size();
                for (int round = 0; round < 3; ++round) expect_same(warm, graphs[at], alone[at]);
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
}

TEST(Remembered, KeepsTheFirstOfEachKey) {
    Remembered<int> numbers(1 << 10);
    EXPECT_EQ(numbers.find("a"), nullptr);
    numbers.keep("a", 1, 4);
    numbers.keep("a", 2, 4);
    numbers.keep("b", 3, 4);
    ASSERT_NE(numbers.find("a"), nullptr);
    EXPECT_EQ(*numbers.find("a"), 1);
    EXPECT_EQ(*numbers.find("b"), 3);
}

TEST(Remembered, SaysWhatIsAskedForAgain) {
    Remembered<int> numbers(1 << 10);
    EXPECT_FALSE(numbers.ask("a").is_asked_again);
    EXPECT_FALSE(numbers.ask("b").is_asked_again);
    EXPECT_TRUE(numbers.ask("a").is_asked_again);
    EXPECT_EQ(numbers.ask("a").value, nullptr);
}

TEST(Remembered, DropsWhatHasNotBeenUsedForLong) {
    Remembered<int> numbers(100);  // ten of ten bytes
    numbers.keep("used", 0, 6);
    for (int i = 0; i < 100; ++i) {
        numbers.keep("n" + std::to_string(10 + i), i, 7);
        ASSERT_NE(numbers.find("used"), nullptr) << i;
    }
    EXPECT_EQ(numbers.find("n10"), nullptr);
    ASSERT_NE(numbers.find("n109"), nullptr);
    EXPECT_EQ(*numbers.find("n109"), 99);
    numbers.keep("large", 1, 1000);
    EXPECT_EQ(numbers.find("large"), nullptr);
}

}  // namespace
}  // namespace patina::witness
