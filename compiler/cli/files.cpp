#include "compiler/cli/files.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

namespace patina::cli {
namespace {

namespace fs = std::filesystem;

std::string cannot_write(const std::string& path, std::string_view why) {
    return "cannot write '" + path + "': " + std::string(why);
}

std::string write_bytes(const std::string& path, const std::string& bytes) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (!file) return cannot_write(path, std::strerror(errno));
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    const int failure = errno;
    // If the disk is full, fclose may be the first call that fails: it writes the rest of the buffer.
    if (std::fclose(file) != 0 || !written) return cannot_write(path, std::strerror(written ? errno : failure));
    return {};
}

// Removes the temporary files that have not been renamed.
struct Temporaries {
    std::vector<std::string> paths;

    ~Temporaries() {
        std::error_code ignored;
        for (const std::string& path : paths) fs::remove(path, ignored);
    }
};

std::string escaped(std::string_view path) {
    std::string text;
    for (char c : path) {
        if (c == ' ' || c == '#') text += '\\';
        if (c == '$') text += '$';
        text += c;
    }
    return text;
}

}  // namespace

std::string commit(const OutputFiles& files) {
    Temporaries temporaries;
    const std::string suffix = ".tmp" + std::to_string(getpid());
    for (const OutputFile& file : files.files) {
        std::error_code failure;
        const fs::path folder = fs::path(file.path).parent_path();
        if (!folder.empty()) fs::create_directories(folder, failure);
        if (failure) return "cannot make the folder '" + folder.string() + "': " + failure.message();
        if (fs::is_directory(file.path)) return cannot_write(file.path, "it is a folder");
        temporaries.paths.push_back(file.path + suffix);
        if (std::string error = write_bytes(temporaries.paths.back(), file.bytes); !error.empty()) return error;
    }
    for (const OutputFile& file : files.files) {
        std::error_code failure;
        fs::rename(file.path + suffix, file.path, failure);
        if (failure) return cannot_write(file.path, failure.message());
    }
    temporaries.paths.clear();
    return {};
}

std::string replace_file(const std::string& path, std::string bytes) {
    std::error_code failure;
    const fs::path real = fs::canonical(path, failure);
    if (failure) return cannot_write(path, failure.message());
    const fs::perms permissions = fs::status(real, failure).permissions();
    OutputFiles files;
    files.add(real.string(), std::move(bytes));
    std::string error = commit(files);
    if (error.empty()) fs::permissions(real, permissions, failure);
    return error;
}

std::optional<std::string> read_file(const std::string& path, std::string& error) {
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

std::string stem(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    if (slash != path.npos) path.remove_prefix(slash + 1);
    for (std::string_view ending : {".graph.json", ".subgraph.json", ".lighting.json", ".scene.json", ".json"}) {
        if (path.size() > ending.size() && path.ends_with(ending)) {
            path.remove_suffix(ending.size());
            break;
        }
    }
    return std::string(path);
}

std::string join_path(std::string_view folder, std::string_view name) {
    if (folder.empty() || folder == ".") return std::string(name);
    return (fs::path(folder) / fs::path(name)).string();
}

std::string make_rule(std::string_view target, std::span<const std::string> dependencies) {
    std::string rule = escaped(target) + ":";
    for (const std::string& dependency : dependencies) rule += " \\\n  " + escaped(dependency);
    return rule + "\n";
}

}  // namespace patina::cli
