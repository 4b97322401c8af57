#include "runtime/files/find_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace patina::runtime {

namespace fs = std::filesystem;

Outcome<std::vector<std::string>> files_below(const std::string& folder) {
    std::vector<std::string> files;
    std::error_code error;
    for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        std::error_code ignored;
        if (!at->is_directory(ignored))
            files.push_back(at->path().lexically_normal().string());
        else if (at->path().filename().string().starts_with('.'))
            at.disable_recursion_pending();
    }
    if (error) return Failure{"cannot read the folder '" + folder + "': " + error.message()};
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace patina::runtime
