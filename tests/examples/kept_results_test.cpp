// A compiler keeps results for its next compilations (link/known_passes.h, output/known_texts.h). They must be the
// results that it would have made: of all examples, lighting models and paths, and of random graphs; where a graph is
// compiled again, and where its text was moved, renamed or given other defaults since; with one thread and with
// several.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <thread>

#include "compiler/api/compiler_impl.h"
#include "witness/random_graph.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

struct Case {
    std::string file;
    std::string text;
    std::string path = "forward";
    std::map<std::string, std::string> files{};  // that the graph names; empty: those on the disk
    std::string lighting{};
    bool hashes = false, keep_variants = false;
};

Result compiled(const Compiler& compiler, const Case& what) {
    CompileOptions options;
    options.path = what.path;
    options.lighting = what.lighting;
    options.hashes = what.hashes;
    options.keep_variants = what.keep_variants;
    if (!what.files.empty())
        options.loader = [&](const std::string& path) -> std::optional<std::string> {
            const auto found = what.files.find(fs::path(path).filename());
            return found == what.files.end() ? std::nullopt : std::optional(found->second);
        };
    return compiler.compile_text(what.file, what.text, options);
}

// All that a caller can see of a result.
std::string all_of(const Result& result) {
    std::string all = result.ok ? "ok\n" : "not ok\n";
    for (const Diagnostic& diagnostic : result.diagnostics) all += to_json(diagnostic) + "\n";
    for (const std::string& file : result.dependencies) all += file + "\n";
    for (const Shader& shader : result.shaders) {
        all +=
            shader.pass + " " + shader.file_name + " " + shader.target.name() + " " + shader.hash + "\n" + shader.text;
        for (const LineOrigin& line : shader.line_map)
            all += std::to_string(line.line) + " " + line.node + " " + std::string(line.file) + ":" +
                   std::to_string(line.source_line) + ":" + std::to_string(line.source_column) + "-" +
                   std::to_string(line.source_end_column) + " " + std::string(line.source_text) + "\n";
    }
    return all + (result.ok ? result.reflection.to_json() : "");
}

// What a graph becomes while somebody works on it, and still is the same to a shader.
Case edited(Case what) {
    what.text = "// moved\n\n" + what.text;
    what.file = fs::path(what.file).replace_filename("renamed.graph.json");
    return what;
}

const Compiler& plain() {
    static const Compiler kPlain = [] {
        Compiler made;
        CompilerAccess::keep_nothing(made);
        return made;
    }();
    return kPlain;
}

// Compiles each case, again, and edited; `order`: of the cases.
void expect_same(const Compiler& keeping, const std::vector<Case>& cases, const std::vector<std::string>& expected,
                 const std::vector<std::string>& expected_edited, const std::vector<std::size_t>& order) {
    for (const std::size_t i : order) {
        const std::string where = cases[i].file + " along " + cases[i].path + " lit by " + cases[i].lighting;
        EXPECT_EQ(all_of(compiled(keeping, cases[i])), expected[i]) << where;
        EXPECT_EQ(all_of(compiled(keeping, edited(cases[i]))), expected_edited[i]) << where << ", edited";
        EXPECT_EQ(all_of(compiled(keeping, cases[i])), expected[i]) << where << ", again";
    }
}

void expect_same(const std::vector<Case>& cases) {
    constexpr std::size_t kThreads = 3;
    std::vector<std::string> expected, expected_edited;
    for (const Case& each : cases) {
        expected.push_back(all_of(compiled(plain(), each)));
        expected_edited.push_back(all_of(compiled(plain(), edited(each))));
    }
    const Compiler keeping;
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < kThreads; ++t) {
        threads.emplace_back([&, t] {
            std::vector<std::size_t> order(cases.size());
            std::iota(order.begin(), order.end(), std::size_t{0});
            // Each begins elsewhere, and one goes backwards.
            std::rotate(order.begin(), order.begin() + std::ptrdiff_t(t * order.size() / kThreads), order.end());
            if (t == 1) std::reverse(order.begin(), order.end());
            expect_same(keeping, cases, expected, expected_edited, order);
        });
    }
    for (std::thread& thread : threads) thread.join();
}

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<Case> examples() {
    std::vector<Case> cases;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator("examples")) {
        if (!entry.path().string().ends_with(".graph.json")) continue;
        for (const char* path : {"forward", "all"}) {
            const std::string file = entry.path().lexically_normal();
            cases.push_back({.file = file, .text = read(file), .path = path, .hashes = cases.size() % 2 == 0});
            cases.back().keep_variants = cases.back().text.find("\"variant\"") != std::string::npos;
        }
    }
    return cases;
}

// A material that is almost the same each time: what differs must reach the shader.
std::string painted(const std::string& rest) {
    return R"({ "patina": 1, "workflow": "metallic-roughness", "nodes": [
        { "id": "albedo", "node": "SampleTexture2D", "in": { "texture": "./checker.png" } } ], )" +
           rest + " }";
}

TEST(KeptResults, OfExamplesAreThoseThatWouldBeMade) {
    const std::vector<Case> cases = examples();
    ASSERT_GT(cases.size(), 20u);
    expect_same(cases);
}

TEST(KeptResults, OfModelsAndPathsAreThoseThatWouldBeMade) {
    std::vector<Case> cases;
    for (const ModelInfo& model : plain().lighting_models()) {
        for (const PathInfo& path : plain().paths())
            cases.push_back({.file = "painted.graph.json",
                             .text = painted(R"("surface": { "baseColor": "albedo.rgb", "roughness": "albedo.a" })"),
                             .path = path.name,
                             .files = {{"checker.png", ""}},
                             .lighting = model.name});
    }
    expect_same(cases);
}

TEST(KeptResults, TellApartWhatDiffersALittle) {
    std::vector<Case> cases;
    for (const char* rest :
         {R"("surface": { "baseColor": "albedo.rgb" })", R"("surface": { "baseColor": "albedo.gbr" })",
          R"("surface": { "baseColor": "= albedo.rgb * 0.5" })", R"("surface": { "baseColor": "= albedo.rgb * 0.25" })",
          R"("surface": { "baseColor": "albedo.rgb", "roughness": 0.5 })",
          R"("surface": { "baseColor": "albedo.rgb", "roughness": 0.6 })",
          R"("render": { "surface": "cutout" }, "surface": { "baseColor": "albedo.rgb" })",
          R"("name": "Other", "surface": { "baseColor": "albedo.rgb" })"})
        cases.push_back({.file = "painted.graph.json", .text = painted(rest), .files = {{"checker.png", ""}}});
    expect_same(cases);
}

TEST(KeptResults, OfRandomGraphsAreThoseThatWouldBeMade) {
    std::vector<Case> cases;
    for (unsigned seed = 1; seed <= 1000; ++seed) {
        const witness::GraphText graph = witness::random_graph(plain(), seed).exact;
        cases.push_back({.file = "random.graph.json", .text = graph.json, .files = graph.files});
        cases.back().files["no other"] = "";
    }
    expect_same(cases);
}

}  // namespace
}  // namespace patina
