#include "compiler/importers/unity/assets.h"

#include <algorithm>
#include <filesystem>

#include "compiler/base/disk/disk.h"
#include "compiler/base/letters.h"
#include "compiler/base/text.h"

namespace patina::importers {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 200'000;  // that are looked at, in all folders
constexpr int kDeepest = 32;

bool is_hex(std::string_view text) {
    return std::ranges::all_of(text, [](char c) { return is_digit(c) || (c >= 'a' && c <= 'f'); });
}

// The digits behind the word "guid".
std::string guid_after(std::string_view text) {
    const std::size_t word = text.find("guid");
    if (word == text.npos) return {};
    const std::size_t begin = text.find_first_of("0123456789abcdef", word + 4);
    if (begin == text.npos || text.size() < begin + 32 || !is_hex(text.substr(begin, 32))) return {};
    return std::string(text.substr(begin, 32));
}

std::string guid_of(const fs::path& meta) {
    const DiskFile file = read_beginning(meta.string(), 512);
    return file.bytes ? guid_after(*file.bytes) : std::string();
}

}  // namespace

Assets::Assets(const std::string& source, std::vector<std::string> folders) : folders_(std::move(folders)) {
    if (!folders_.empty()) return;
    std::error_code ignored;
    const fs::path own = fs::absolute(source, ignored).parent_path();
    folders_.push_back(own.string());
    for (fs::path each = own; each.has_relative_path(); each = each.parent_path())
        if (each.filename() == "Assets" && why_outside(each.string()).empty()) {
            folders_.back() = each.string();
            break;
        }
}

const Assets::Index& Assets::index(std::span<const std::string_view> endings) {
    const auto [found, is_new] = indexes_.try_emplace(endings.front());
    Index& made = found->second;
    if (!is_new) return made;
    std::size_t count = 0;
    for (const std::string& folder : folders_) {
        std::error_code wrong;
        if (!is_folder_on_disk(folder)) continue;
        fs::recursive_directory_iterator each(folder, fs::directory_options::skip_permission_denied, wrong), end;
        for (; !wrong && each != end && count < kMostFiles; each.increment(wrong), ++count) {
            if (each.depth() >= kDeepest) each.disable_recursion_pending();
            const fs::path& path = each->path();
            const std::string name = small_letters(path.filename().string());
            const bool is_meta = name.ends_with(".meta");
            const std::string_view asset = std::string_view(name).substr(0, name.size() - (is_meta ? 5 : 0));
            if (std::ranges::none_of(endings, [&](std::string_view ending) { return asset.ends_with(ending); }))
                continue;
            if (!is_meta) {
                made.by_name[small_letters(path.stem().string())].push_back(path.string());
            } else if (const std::string guid = guid_of(path); !guid.empty()) {
                std::string file = path.string();
                file.resize(file.size() - 5);
                made.by_guid[guid].push_back(std::move(file));
            }
        }
    }
    for (auto* map : {&made.by_guid, &made.by_name})
        for (auto& [key, paths] : *map) {
            std::sort(paths.begin(), paths.end());
            paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
        }
    return made;
}

std::optional<Assets::Found> Assets::find(std::string_view guid, std::string_view name,
                                          std::span<const std::string_view> endings) {
    if (guid.empty() && name.empty()) return {};
    const Index& all = index(endings);
    if (const auto found = all.by_guid.find(small_letters(std::string(guid))); found != all.by_guid.end()) {
        std::vector<std::string> there;
        for (const std::string& path : found->second)
            if (is_on_disk(path)) there.push_back(path);
        if (!there.empty()) return Found{.path = there.front(), .other = there.size() > 1 ? there[1] : std::string()};
    }
    if (name.empty()) return {};
    const auto found = all.by_name.find(small_letters(std::string(name)));
    if (found == all.by_name.end()) return {};
    return Found{.path = found->second.front(),
                 .is_by_name = true,
                 .other = found->second.size() > 1 ? found->second[1] : std::string()};
}

std::string Assets::folders() const {
    const std::vector<std::string_view> words(folders_.begin(), folders_.end());
    return enumerate(words);
}

std::string guid_in(std::string_view json) {
    return guid_after(json);
}

std::string path_from(const std::string& folder, const std::string& path) {
    std::error_code wrong;
    const fs::path from = fs::absolute(folder.empty() ? "." : folder, wrong);
    const std::string file = fs::proximate(path, from, wrong).generic_string();
    if (wrong) return {};
    return file.starts_with("../") ? file : "./" + file;
}

}  // namespace patina::importers
