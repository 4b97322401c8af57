// Reading files, and the names that commands make of their paths. outputs.h writes files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace patina::cli {

// The text of a file, or nothing and `error`.
std::optional<std::string> read_file(const std::string& path, std::string& error);
std::string read_standard_input();

// By its name.
bool is_scene(std::string_view path);
// `folder`/`name`, or just the name in the current folder.
std::string join_path(std::string_view folder, std::string_view name);

}  // namespace patina::cli
