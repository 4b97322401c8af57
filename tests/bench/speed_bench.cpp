// What scripts/performance measures: it builds this file with the library of this tree and with that of another one, so
// only public headers are used. `speed_bench TASK COUNT GRAPH` prints the milliseconds of one item.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <thread>

#include "patina/patina.h"

namespace {

using namespace patina;

CompileOptions along(const std::string& path) {
    CompileOptions options;
    options.request = CompileOptions::Passes{.path = path};
    return options;
}

void compile(const Compiler& compiler, const std::string& path, const std::string& text,
             const CompileOptions& options) {
    if (compiler.compile_text(path, text, options).ok) return;
    std::fprintf(stderr, "%s does not compile\n", path.c_str());
    std::exit(1);
}

// The graph with another constant in the expression of its roughness, so that its surface computes something else.
std::string edited(std::string text, int edit) {
    const std::string constant = "0.7 *";
    const std::size_t at = text.find(constant);
    return text.replace(at, constant.size(), std::to_string(0.3 + 0.0001 * edit) + " *");
}

// Small graphs, of which each computes something else: one to five nodes with constants of their own.
std::string small_graph(int i) {
    static constexpr const char* kNodes[] = {"Multiply", "Add", "Maximum", "Minimum"};
    std::string text = R"({ "patina": 1, "workflow": "metallic-roughness", "properties": [
  { "name": "_MainTex", "type": "texture2d", "usage": "color" }, { "name": "_Tint", "type": "color" } ], "nodes": [
  { "id": "n0", "node": "SampleTexture2D", "in": { "texture": "$_MainTex" } })";
    const int nodes = 1 + i % 5;
    for (int n = 1; n <= nodes; ++n)
        text += ",\n  { \"id\": \"n" + std::to_string(n) + "\", \"node\": \"" + kNodes[(i / 5 + n) % 4] +
                R"(", "in": { "left": "n)" + std::to_string(n - 1) +
                "\", \"right\": " + std::to_string(0.003 + 0.0003 * i + 0.01 * n) + " } }";
    return text + " ], \"surface\": { \"baseColor\": \"= n" + std::to_string(nodes) +
           ".rgb * $_Tint.rgb\", \"roughness\": " + std::to_string(0.1 + 0.0003 * i) + " } }";
}

void compile_small_graphs(int count, unsigned jobs) {
    const Compiler compiler;
    const CompileOptions options = along("forward");
    std::atomic<int> next{0};
    const auto work = [&] {
        for (int i = next++; i < count; i = next++)
            compile(compiler, "small" + std::to_string(i) + ".graph.json", small_graph(i), options);
    };
    std::vector<std::thread> threads;
    for (unsigned job = 1; job < jobs; ++job) threads.emplace_back(work);
    work();
    for (std::thread& thread : threads) thread.join();
}

double milliseconds(int count, const std::function<void()>& run) {
    const auto begin = std::chrono::steady_clock::now();
    run();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count() / count;
}

// A graph that is compiled again and again, by a compiler that has compiled it before.
double warm(int count, const std::string& path, const std::string& passes, bool edits) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const Compiler compiler;
    const CompileOptions options = along(passes);
    compile(compiler, path, text, options);
    return milliseconds(count, [&] {
        for (int i = 0; i < count; ++i) compile(compiler, path, edits ? edited(text, i) : text, options);
    });
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) return 2;
    const std::string task = argv[1], graph = argv[3];
    const int count = std::atoi(argv[2]);
    const std::map<std::string, std::function<double()>> tasks = {
        {"library",
         [&] {
             return milliseconds(count, [&] {
                 for (int i = 0; i < count; ++i) Compiler();
             });
         }},
        {"again", [&] { return warm(count, graph, "forward", false); }},
        {"edited", [&] { return warm(count, graph, "forward", true); }},
        {"all again", [&] { return warm(count, graph, "all", false); }},
        {"all edited", [&] { return warm(count, graph, "all", true); }},
        {"small", [&] { return milliseconds(1, [&] { compile_small_graphs(count, 1); }); }},
        {"small by two", [&] { return milliseconds(1, [&] { compile_small_graphs(count, 2); }); }}};
    const auto found = tasks.find(task);
    if (found == tasks.end()) return 2;
    std::printf("%.6f\n", found->second());
}
