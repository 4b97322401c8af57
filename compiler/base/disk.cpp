#include "compiler/base/disk.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace patina {

std::optional<std::string> read_from_disk(const std::string& path, std::string& why) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        why = "it is a folder";
        return {};
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        why = std::strerror(errno);
        return {};
    }
    std::ostringstream text;
    text << file.rdbuf();
    return std::move(text).str();
}

bool is_on_disk(const std::string& path) {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error);
}

}  // namespace patina
