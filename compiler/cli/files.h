// Reading and writing for the commands. Output is all or nothing: files are written under temporary names and renamed
// when all of them are there, so neither a failed graph nor a full disk leaves half a result. Pictures are written by
// runtime/picture.
//
//   OutputFiles files;
//   files.add("out/rust.forward.vert.glsl", text);
//   if (std::string error = commit(files); !error.empty()) complain(console, Complaint::CannotWrite, {error});
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace patina::cli {

struct OutputFile {
    std::string path;
    std::string bytes;
};
struct OutputFiles {
    std::vector<OutputFile> files;

    void add(std::string path, std::string bytes) { files.push_back({std::move(path), std::move(bytes)}); }
};

// Makes missing folders, writes everything, then renames. Returns nothing, or what is wrong; then no file is left.
std::string commit(const OutputFiles& files);

// Replaces one file and keeps its permissions; follows a symbolic link.
std::string replace_file(const std::string& path, std::string bytes);

// The text of a file, or nothing and `error`.
std::optional<std::string> read_file(const std::string& path, std::string& error);
std::string read_standard_input();

// By its name.
bool is_scene(std::string_view path);
// "art/rust.graph.json" -> "rust": what output files are named after.
std::string stem(std::string_view path);
// `folder`/`name`, or just the name in the current folder.
std::string join_path(std::string_view folder, std::string_view name);

// A rule in Makefile syntax, as ninja's `depfile` wants it: "target: a.json b.json".
std::string make_rule(std::string_view target, std::span<const std::string> dependencies);

}  // namespace patina::cli
