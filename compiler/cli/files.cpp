#include "compiler/cli/files.h"

#include <algorithm>
#include <filesystem>

#include "compiler/base/disk/disk.h"

namespace patina::cli {
namespace {

namespace fs = std::filesystem;

std::string escaped(std::string_view path) {
    std::string text;
    for (char c : path) {
        if (c == ' ' || c == '#') text += '\\';
        if (c == '$') text += '$';
        text += c;
    }
    return text;
}

bool has_line_break(std::string_view path) {
    return path.find('\n') != path.npos;
}

runtime::Failure no_rule(std::string_view path) {
    std::string shown;
    for (const char c : path) shown += c == '\n' ? std::string("\\n") : std::string(1, c);
    return {"--depfile: there is a line break in the name '" + shown +
            "', which make and Ninja cannot read: rename it, or leave out --depfile"};
}

}  // namespace

std::optional<std::string> read_file(const std::string& path, std::string& error) {
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

runtime::Outcome<std::string> make_rule(std::string_view target, std::span<const std::string> dependencies) {
    if (has_line_break(target)) return no_rule(target);
    if (const auto odd = std::ranges::find_if(dependencies, has_line_break); odd != dependencies.end())
        return no_rule(*odd);
    std::string rule = escaped(target) + ":";
    for (const std::string& dependency : dependencies) rule += " \\\n  " + escaped(dependency);
    rule += "\n";
    for (const std::string& dependency : dependencies) rule += escaped(dependency) + ":\n";
    return rule;
}

}  // namespace patina::cli
