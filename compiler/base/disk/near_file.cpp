#include "compiler/base/disk/near_file.h"

#include <filesystem>
#include <string_view>
#include <vector>

#include "compiler/base/disk/disk.h"
#include "compiler/base/text.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 2000;  // of a folder that are looked at

// ".graph.json"
std::string ending_of(const std::string& name) {
    const std::size_t dot = name.find('.', 1);
    return dot == name.npos ? std::string() : name.substr(dot);
}

}  // namespace

std::string near_file(const std::string& path, const Root* root) {
    const fs::path wanted(path);
    const fs::path folder = wanted.parent_path();
    const std::string ending = ending_of(wanted.filename().string());
    if (!is_folder_on_disk(folder.empty() ? "." : folder.string(), root)) return {};
    std::error_code failure;
    std::vector<std::string> names;
    fs::directory_iterator each(folder.empty() ? fs::path(".") : folder, failure);
    for (; !failure && each != fs::directory_iterator() && names.size() < kMostFiles; each.increment(failure)) {
        const std::string name = each->path().filename().string();
        if (ending_of(name) == ending && is_on_disk(each->path().string(), root))
            names.push_back(name.substr(0, name.size() - ending.size()));
    }
    const std::string name = wanted.filename().string();
    const std::vector<std::string_view> views(names.begin(), names.end());
    const std::string_view best = nearest(std::string_view(name).substr(0, name.size() - ending.size()), views);
    return best.empty() ? "" : "did you mean '" + (folder / (std::string(best) + ending)).string() + "'?";
}

}  // namespace patina
