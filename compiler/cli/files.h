// Reading files, and the names and rules that commands make of their paths. outputs.h writes files.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "runtime/outcome.h"

namespace patina::cli {

// The text of a file, at most 64 MiB of it, or nothing and `error`. "-" is standard input.
std::optional<std::string> read_file(const std::string& path, std::string& error);

// By its name.
bool is_scene(std::string_view path);
// `folder`/`name`, or just the name in the current folder.
std::string join_path(std::string_view folder, std::string_view name);

// A rule in Makefile syntax, as make's `include` and ninja's `depfile` want it: "target: a.json b.json". Each
// dependency has an empty rule of its own, so that make goes on when one of them has been removed. A failure: a rule
// cannot hold one of the names.
runtime::Outcome<std::string> make_rule(std::string_view target, std::span<const std::string> dependencies);

}  // namespace patina::cli
