// What a compiler keeps of earlier compilations changes no result. All examples, all lighting models along all paths
// and random graphs are compiled by one compiler, in one order and in another, and by compilers that have compiled
// nothing.
#include <fmt/format.h>
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

// Results as text. Each struct is taken apart whole, so that this file does not compile if a member is added to one and
// forgotten here.
std::string text_of(const LineOrigin& origin) {
    const auto& [line, node, file, source_line, source_column, source_end_column, source_text] = origin;
    return fmt::format("{} {} {}:{}:{}-{} {}\n", line, node, file, source_line, source_column, source_end_column,
                       source_text);
}

std::string text_of(const Diagnostic& diagnostic) {
    const auto& [severity, code, message, file, line, column, end_line, end_column, source_line, node, port, notes] =
        diagnostic;
    std::string all = fmt::format("{} {} {} {}:{}:{}-{}:{} {} {} {}\n", static_cast<int>(severity), code, message, file,
                                  line, column, end_line, end_column, source_line, node, port);
    for (const Diagnostic& note : notes) all += text_of(note);
    return all;
}

std::string text_of(const Shader& shader) {
    const auto& [pass, stage, target, file_name, text, line_map, light_loops, shifts, listed_as, has_main, hash] =
        shader;
    std::string all =
        fmt::format("--- {} {} {} {} {} {} {} {} {}\n{}", pass, to_string(stage), target.engine, target.language,
                    file_name, listed_as, has_main, hash, fmt::join(light_loops, " "), text);
    for (const auto& [set, buffers, textures, samplers] : shifts)
        all += fmt::format("shifts {} {} {} {}\n", set, buffers, textures, samplers);
    for (const LineOrigin& origin : line_map) all += text_of(origin);
    return all;
}

std::string text_of(const std::optional<Budget::Limit>& limit) {
    if (!limit) return {};
    const auto& [most, place] = *limit;
    const auto& [file, line, column, end_line, end_column, source_line] = place;
    return fmt::format("at most {} {}:{}:{}-{}:{} {}\n", most, file, line, column, end_line, end_column, source_line);
}

std::string text_of(const Result& result) {
    const auto& [ok, diagnostics, shaders, reflection, dependencies, missing, nodes, budget, dumps, program] = result;
    const auto& [instructions, textures] = budget;
    std::string all = fmt::format("ok: {}\n{}{}{}", ok, reflection.to_json(), text_of(instructions), text_of(textures));
    for (const Diagnostic& diagnostic : diagnostics) all += text_of(diagnostic);
    for (const Shader& shader : shaders) all += text_of(shader);
    for (const std::string& file : dependencies) all += "file " + file + "\n";
    for (const std::string& file : missing) all += "missing " + file + "\n";
    for (const std::string& node : nodes) all += "node " + node + "\n";
    for (const auto& [stage, text] : dumps) all += "dump " + stage + "\n" + text;
    EXPECT_EQ(program, nullptr);  // it keeps nothing, and nobody has asked for it
    return all;
}

// All that a program gets, as one text.
std::string compiled_for(const Compiler& compiler, const Graph& graph, CompileOptions options) {
    options.hashes = true;
    if (!graph.files.empty()) {
        options.files.read = [&](const std::string& path) {
            const auto found = graph.files.find(path);
            return found == graph.files.end() ? std::nullopt : std::optional(found->second);
        };
    }
    return text_of(compiler.compile_text(graph.path, graph.text, options));
}

// With other limits, which none of the graphs reaches, it is another request of the same result.
std::string compiled(const Compiler& compiler, const Graph& graph, int limits = 0) {
    CompileOptions usual;
    usual.limits.nodes -= static_cast<std::size_t>(limits);
    CompileOptions unity = usual, functions = usual;
    usual.request = CompileOptions::Passes{.path = graph.along};
    unity.targets = {Target{.engine = "unity", .language = "hlsl"}};
    functions.request = CompileOptions::Functions{.prefix = "Kept_"};
    return compiled_for(compiler, graph, usual) + compiled_for(compiler, graph, unity) +
           compiled_for(compiler, graph, functions);
}

// Each graph by a compiler of its own.
std::vector<std::string> compiled_alone(const std::vector<Graph>& graphs) {
    std::vector<std::string> made;
    for (const Graph& graph : graphs) made.push_back(compiled(Compiler(), graph));
    return made;
}

void expect_same(const Compiler& warm, const Graph& graph, const std::string& alone, int limits = 0) {
    const std::string made = compiled(warm, graph, limits);
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
// compilation of a graph finds its stages. The next two, with the same limits, get its whole result.
void expect_kept_results_change_nothing(const std::vector<Graph>& graphs) {
    const std::vector<std::string> alone = compiled_alone(graphs);
    const Compiler warm;
    for (std::size_t i = 0; i < graphs.size(); ++i)
        for (const int limits : {0, 1, 2, 2, 2}) expect_same(warm, graphs[i], alone[i], limits);
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

std::vector<Graph> random_graphs(unsigned count) {
    const Compiler compiler;
    std::vector<Graph> graphs;
    for (unsigned seed = 0; seed < count; ++seed) {
        const GraphText text = random_graph(compiler, seed).exact;
        graphs.push_back(
            {.path = std::to_string(seed) + ".graph.json", .text = text.json, .files = text.files, .along = "forward"});
    }
    return graphs;
}

TEST(KeptResults, ChangeNoRandomGraph) {
    expect_kept_results_change_nothing(random_graphs(100));
}

// The same for many, which takes a minute.
TEST(ManyKeptResults, ChangeNoRandomGraph) {
    expect_kept_results_change_nothing(random_graphs(1000));
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
                for (const int limits : {0, 1, 2, 2, 2}) expect_same(warm, graphs[at], alone[at], limits);
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
}

TEST(Remembered, KeepsTheLastOfEachKey) {
    Remembered<int> numbers(1 << 10);
    EXPECT_EQ(numbers.find("a"), nullptr);
    numbers.keep("a", 1, 4);
    numbers.keep("a", 2, 4);
    numbers.keep("b", 3, 4);
    ASSERT_NE(numbers.find("a"), nullptr);
    EXPECT_EQ(*numbers.find("a"), 2);
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
    Remembered<int> numbers(12'000);  // ten or eleven of 1,000 bytes
    numbers.keep("used", 0, 1000);
    for (int i = 0; i < 100; ++i) {
        numbers.keep("n" + std::to_string(i), i, 1000);
        ASSERT_NE(numbers.find("used"), nullptr) << i;
    }
    EXPECT_EQ(numbers.find("n0"), nullptr);
    ASSERT_NE(numbers.find("n99"), nullptr);
    EXPECT_EQ(*numbers.find("n99"), 99);
    for (int i = 0; i < 3; ++i) numbers.keep("large", 1, 100'000);
    EXPECT_EQ(numbers.find("large"), nullptr);
    EXPECT_NE(numbers.find("n99"), nullptr) << "what is too large to keep drives out nothing";
    int kept = 0;
    for (int i = 0; i < 100; ++i) kept += numbers.find("n" + std::to_string(i)) != nullptr;
    EXPECT_LE(kept, 11);
}

// The key takes room, too.
TEST(Remembered, CountsKeys) {
    Remembered<int> numbers(12'000);
    for (char letter = 'a'; letter <= 'z'; ++letter) numbers.keep(std::string(1000, letter), letter, 0);
    int kept = 0;
    for (char letter = 'a'; letter <= 'z'; ++letter) kept += numbers.find(std::string(1000, letter)) != nullptr;
    EXPECT_GE(kept, 5);
    EXPECT_LE(kept, 11);
}

}  // namespace
}  // namespace patina::witness
