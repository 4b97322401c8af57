// Shader graphs, changed at random: whatever a file holds, it is refused at a place, or it becomes a graph that the
// compiler accepts. The files that are changed are given: a project of Unity, for example.
//
//   build/fuzz_shader_graphs FOLDER [COUNT [FIRST]]    # COUNT changed files; FIRST: the number of the first one
//
// It prints the number of each failure. `FOLDER 1 NUMBER` makes that file again and keeps it as fuzz.shadergraph.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "compiler/importers/importer.h"
#include "patina/patina.h"

namespace {

namespace fs = std::filesystem;
using patina::importers::Imported;
using Random = std::mt19937;

std::size_t below(Random& random, std::size_t limit) {
    return static_cast<std::size_t>(random()) % limit;
}

struct Seed {
    fs::path path;
    std::string text;
};

std::vector<Seed> seeds_in(const fs::path& folder) {
    std::vector<Seed> made;
    for (const auto& each : fs::recursive_directory_iterator(folder)) {
        const std::string ending = each.path().extension().string();
        if (ending != ".shadergraph" && ending != ".shadersubgraph") continue;
        std::ifstream file(each.path(), std::ios::binary);
        std::string text{std::istreambuf_iterator<char>(file), {}};
        if (!text.empty()) made.push_back({each.path(), std::move(text)});
    }
    std::sort(made.begin(), made.end(), [](const Seed& a, const Seed& b) { return a.path < b.path; });
    return made;
}

// A line of the text, from its begin to behind its end.
std::pair<std::size_t, std::size_t> line_at(const std::string& text, std::size_t at) {
    const std::size_t before = text.rfind('\n', at), after = text.find('\n', at);
    return {before == text.npos ? 0 : before + 1, after == text.npos ? text.size() : after + 1};
}

// Bytes, numbers, and lines: most of what a line holds keeps its form, so that the importer goes on.
void change(std::string& text, const std::string& other, Random& random) {
    if (text.empty()) return;
    const std::size_t at = below(random, text.size()), count = 1 + below(random, 12);
    const auto [begin, end] = line_at(text, at);
    const std::size_t digit = std::min(text.find_first_of("0123456789", at), text.size() - 1);
    switch (below(random, 8)) {
        case 0: text[at] = static_cast<char>(random()); break;
        case 1: text.erase(at, count); break;
        case 2: text.insert(at, text.substr(below(random, text.size()), count)); break;
        case 3: text[digit] = static_cast<char>('0' + below(random, 10)); break;
        case 4: text.replace(digit, 1, below(random, 2) == 0 ? "-1" : "1e30"); break;
        case 5: text.erase(begin, end - begin); break;
        case 6: {
            const auto [from, to] = line_at(text, below(random, text.size()));
            text.insert(begin, text.substr(from, to - from));
            break;
        }
        case 7: {
            const auto [from, to] = line_at(other, below(random, other.size()));
            text.replace(begin, end - begin, other, from, to - from);
            break;
        }
    }
}

// What is wrong; empty: nothing.
std::string wrong_with(const Imported& made) {
    if (!made.error.empty()) return made.graphs.empty() ? "" : "an error and graphs: " + made.error;
    if (made.graphs.empty()) return "neither an error nor graphs";
    static const patina::Compiler compiler;
    patina::CompileOptions options{.targets = {}};
    options.accept_parts = true;
    options.files.read = [&](const std::string& path) -> std::optional<std::string> {
        for (const auto& each : made.graphs)
            if (each.name == path || "./" + each.name == path) return each.text;
        return std::nullopt;
    };
    const patina::importers::TextFile& graph = made.graphs.back();
    for (const auto& each : compiler.compile_text(graph.name, graph.text, options).diagnostics)
        if (each.severity == patina::Severity::Error) return to_text(each);
    return {};
}

}  // namespace

int main(int count, char** arguments) {
    const std::vector<std::string> words(arguments + 1, arguments + count);
    if (words.empty()) {
        std::fputs("usage: fuzz_shader_graphs FOLDER [COUNT [FIRST]]\n", stderr);
        return 2;
    }
    const std::vector<Seed> seeds = seeds_in(words[0]);
    const unsigned long total = words.size() > 1 ? std::strtoul(words[1].c_str(), nullptr, 10) : 1000;
    const unsigned long first = words.size() > 2 ? std::strtoul(words[2].c_str(), nullptr, 10) : 0;
    if (seeds.empty()) {
        std::fputs("the folder has no shader graphs\n", stderr);
        return 2;
    }
    const fs::path path = fs::current_path() / "fuzz.shadergraph";
    unsigned long imported = 0, failed = 0;
    double slowest = 0;
    for (unsigned long number = first; number < first + total; ++number) {
        Random random(static_cast<Random::result_type>(number));
        const Seed& seed = seeds[below(random, seeds.size())];
        std::string text = seed.text;
        for (std::size_t edits = 1 + below(random, 4); edits > 0; --edits)
            change(text, seeds[below(random, seeds.size())].text, random);
        std::ofstream(path, std::ios::binary) << text;
        const patina::importers::Source source{.path = path.string(), .start = {}};
        patina::importers::Options options;
        options.include_dirs = {below(random, 4) == 0 ? seed.path.parent_path().string() : path.parent_path().string()};
        const auto begin = std::chrono::steady_clock::now();
        const Imported made = patina::importers::importer_of(source)->read(source, options);
        const std::string wrong = wrong_with(made);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        slowest = std::max(slowest, seconds);
        imported += made.error.empty() ? 1 : 0;
        if (wrong.empty() && seconds < 10) continue;
        ++failed;
        std::printf("%lu (%s): %s\n", number, seed.path.filename().c_str(),
                    wrong.empty() ? "it takes too long" : wrong.c_str());
    }
    std::printf("%lu files, %lu imported, %lu failures, the slowest took %.0f ms\n", total, imported, failed,
                slowest * 1000);
    return failed == 0 ? 0 : 1;
}
