#include "compiler/cli/files.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "compiler/cli/failures/failures.h"

namespace patina::cli {
namespace fs = std::filesystem;

std::optional<std::string> read_file(const std::string& path, std::string& error) {
    work_on_file(path);
    std::error_code failure;
    if (fs::is_directory(path, failure)) {
        error = "it is a folder";
        return std::nullopt;
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        error = std::strerror(errno);
        return std::nullopt;
    }
    return std::string(std::istreambuf_iterator<char>(file), {});
}

std::string read_standard_input() {
    return std::string(std::istreambuf_iterator<char>(std::cin), {});
}

bool is_scene(std::string_view path) {
    return path.ends_with(".scene.json");
}

std::string join_path(std::string_view folder, std::string_view name) {
    if (folder.empty() || folder == ".") return std::string(name);
    return (fs::path(folder) / fs::path(name)).string();
}

}  // namespace patina::cli
