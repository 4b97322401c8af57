// Reading and writing for the commands. Output is all or nothing: a set of files is written under temporary names and
// renamed once everything is there, so neither a failed graph nor a full disk leaves half a result. Not for pictures.
//
//   OutputFiles files;
//   files.add("out/rust.forward.vert.glsl", text);
//   if (std::string error = commit(files); !error.empty()) complain(console, "cannot-write", error);
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

// Makes missing folders, writes everything, then renames. Empty, or what went wrong; then nothing is left behind.
std::string commit(const OutputFiles& files);

// Replaces one file, through a symbolic link if it is one, and keeps its permissions.
std::string replace_file(const std::string& path, std::string bytes);

// A whole file, or nothing and `error`. "-" is not special.
std::optional<std::string> read_file(const std::string& path, std::string& error);
std::string read_standard_input();

// "art/rust.graph.json" -> "rust": what output files are named after.
std::string stem(std::string_view path);
// `folder`/`name`, or just the name in the current folder.
std::string join_path(std::string_view folder, std::string_view name);

// A rule in Makefile syntax, as ninja's `depfile` wants it: "target: a.json b.json".
std::string make_rule(std::string_view target, std::span<const std::string> dependencies);

}  // namespace patina::cli
