#include <algorithm>
#include <fstream>
#include <iterator>

#include "tests/fuzz/fuzz.h"

namespace patina::fuzz {

namespace fs = std::filesystem;

std::string read_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write_file(const fs::path& path, std::string_view bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

std::vector<Seed> seeds_in(const Setup& setup, std::span<const std::string_view> folders, std::string_view ending,
                           std::size_t most) {
    std::vector<fs::path> roots;
    for (const std::string_view each : folders) roots.push_back(fs::path(PATINA_SOURCE) / each);
    if (!setup.seeds.empty()) roots = {setup.seeds};
    std::vector<Seed> made;
    for (const fs::path& root : roots) {
        if (!fs::is_directory(root)) continue;
        for (const auto& each : fs::recursive_directory_iterator(root)) {
            if (!each.is_regular_file() || !each.path().string().ends_with(ending)) continue;
            Seed seed{.bytes = read_file(each.path()), .path = each.path().string()};
            if (!seed.bytes.empty() && seed.bytes.size() <= most) made.push_back(std::move(seed));
        }
    }
    std::sort(made.begin(), made.end(), [](const Seed& a, const Seed& b) { return a.path < b.path; });
    return made;
}

}  // namespace patina::fuzz
