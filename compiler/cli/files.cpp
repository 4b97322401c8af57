#include "compiler/cli/files.h"

#include <algorithm>
#include <filesystem>

#include "compiler/base/disk/disk.h"
#include "compiler/cli/failures/failures.h"

namespace patina::cli {
namespace fs = std::filesystem;

std::optional<std::string> read_file(const std::string& path, std::string& error) {
    work_on_file(path);
    if (path == "-") return read_standard_input(kMostTextBytes, error);
    DiskFile file = read_disk(path, kMostTextBytes);
    if (!file.bytes) error = file.why.empty() ? "No such file or directory" : file.why;
    // "patina fmt <(git show HEAD:rust.graph.json)", "/dev/stdin"
    if (file.why == "it is a FIFO") error += ": pipe it into standard input, which is named '-'";
    return std::move(file.bytes);
}

bool is_scene(std::string_view path) {
    return path.ends_with(".scene.json");
}

std::string join_path(std::string_view folder, std::string_view name) {
    if (folder.empty() || folder == ".") return std::string(name);
    return (fs::path(folder) / fs::path(name)).string();
}

}  // namespace patina::cli
