#include "runtime/files/find_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "compiler/base/disk/disk.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

// std::filesystem::recursive_directory_iterator would end at a folder that is removed meanwhile.
void look_into(const fs::path& folder, bool is_outermost, FolderContents& below) {
    std::error_code error;
    fs::directory_iterator at(folder, error);
    if (error == std::errc::no_such_file_or_directory && !is_outermost) return;
    below.folders.push_back(folder.lexically_normal().string());
    for (const fs::directory_iterator end; !error && at != end; at.increment(error)) {
        if (at->path().filename().string().starts_with('.')) continue;
        std::error_code ignored;
        // A link that leads outside of the root is treated like a link that leads nowhere.
        const bool is_outside = at->is_symlink(ignored) && !why_outside(at->path().string()).empty();
        const fs::file_status status = is_outside ? fs::file_status() : at->status(ignored);
        if (fs::is_regular_file(status) ||
            !fs::exists(status))  // a link that leads nowhere is reported when it is read
            below.files.push_back(at->path().lexically_normal().string());
        else if (fs::is_directory(status) && !at->is_symlink(ignored))
            look_into(at->path(), false, below);
    }
    if (error) below.unread.push_back({.path = folder.string(), .why = error.message()});
}

}  // namespace

FolderContents look_below(const std::string& folder) {
    FolderContents below;
    if (std::string why = why_outside(folder); !why.empty())
        below.unread.push_back({.path = folder, .why = std::move(why)});
    else
        look_into(folder, true, below);
    std::ranges::sort(below.files);
    std::ranges::sort(below.folders);
    std::ranges::sort(below.unread, {}, &UnreadFolder::path);
    return below;
}

Outcome<std::vector<std::string>> files_below(const std::string& folder) {
    FolderContents below = look_below(folder);
    if (below.unread.empty()) return std::move(below.files);
    const UnreadFolder& first = below.unread.front();
    return Failure{"cannot read the folder '" + first.path + "': " + first.why};
}

}  // namespace patina::runtime
