#include "runtime/files/find_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

struct Below {
    std::vector<std::string> files{}, folders{};
    std::string error{};
};

// std::filesystem::recursive_directory_iterator would end at a folder that is removed meanwhile.
void look_into(const fs::path& folder, bool is_outermost, Below& below) {
    std::error_code error;
    fs::directory_iterator at(folder, error);
    if (error == std::errc::no_such_file_or_directory && !is_outermost) return;
    below.folders.push_back(folder.lexically_normal().string());
    for (const fs::directory_iterator end; !error && at != end; at.increment(error)) {
        if (at->path().filename().string().starts_with('.')) continue;
        std::error_code ignored;
        const fs::file_status status = at->status(ignored);
        if (fs::is_regular_file(status) || !fs::exists(status))  // a link that leads nowhere is said when it is read
            below.files.push_back(at->path().lexically_normal().string());
        else if (fs::is_directory(status) && !at->is_symlink(ignored))
            look_into(at->path(), false, below);
    }
    if (error) below.error = "cannot read the folder '" + folder.string() + "': " + error.message();
}

Outcome<std::vector<std::string>> sorted(std::vector<std::string> Below::*paths, const std::string& folder) {
    Below below;
    look_into(folder, true, below);
    if (!below.error.empty()) return Failure{below.error};
    std::sort((below.*paths).begin(), (below.*paths).end());
    return below.*paths;
}

}  // namespace

Outcome<std::vector<std::string>> files_below(const std::string& folder) {
    return sorted(&Below::files, folder);
}

Outcome<std::vector<std::string>> folders_below(const std::string& folder) {
    return sorted(&Below::folders, folder);
}

}  // namespace patina::runtime
