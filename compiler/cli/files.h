// Reading files, and the names that commands make of their paths. outputs.h writes files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace patina::cli {

// The text of a file, at most 64 MiB of it, or nothing and `error`. "-" is standard input.
std::optional<std::string> read_file(const std::string& path, std::string& error);

// By its name.
bool is_scene(std::string_view path);
// `folder`/`name`, or just the name in the current folder.
std::string join_path(std::string_view folder, std::string_view name);

}  // namespace patina::cli
