#include "compiler/cli/compile/depfile.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace patina::cli {
namespace {

namespace fs = std::filesystem;

// Ninja writes to the folder that it runs in after its last command.
constexpr const char* kNinjaFiles[] = {"build.ninja", ".ninja_log", ".ninja_lock"};

// Both take a plain colon for the end of the targets.
std::string escaped(std::string_view path) {
    std::string text;
    for (char c : path) {
        if (c == ' ' || c == '#' || c == ':') text += '\\';
        if (c == '$') text += '$';
        text += c;
    }
    return text;
}

bool has_line_break(std::string_view path) {
    return path.find('\n') != path.npos;
}

// Ninja reads no escaped colon in front of a space: there the backslash stands for itself.
bool ends_in_colon(std::string_view path) {
    return path.ends_with(':');
}

runtime::Failure no_rule(std::string_view path) {
    std::string shown;
    for (const char c : path) shown += c == '\n' ? std::string("\\n") : std::string(1, c);
    return {fmt::format("--depfile: {} the name '{}', which {} cannot read: rename it, or leave out --depfile",
                        has_line_break(path) ? "there is a line break in" : "a colon ends", shown,
                        has_line_break(path) ? "make and Ninja" : "Ninja")};
}

// Without symbolic links.
fs::path folder_itself(const fs::path& folder) {
    std::error_code ignored;
    return fs::canonical(folder.empty() ? "." : folder, ignored);
}

bool is_of_ninja(const fs::path& folder) {
    std::error_code ignored;
    return std::ranges::any_of(kNinjaFiles, [&](const char* name) { return fs::exists(folder / name, ignored); });
}

// The nearest folder that is there, of the folder of a file.
fs::path nearest(fs::path folder) {
    std::error_code ignored;
    while (!folder.empty() && !fs::is_directory(folder, ignored) && folder.has_relative_path())
        folder = folder.parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

}  // namespace

runtime::Outcome<std::string> make_rule(std::string_view target, std::span<const std::string> dependencies) {
    if (has_line_break(target)) return no_rule(target);
    for (const std::string& dependency : dependencies)
        if (has_line_break(dependency) || ends_in_colon(dependency)) return no_rule(dependency);
    std::string rule = escaped(target) + ":";
    for (const std::string& dependency : dependencies) rule += " \\\n  " + escaped(dependency);
    rule += "\n";
    for (const std::string& dependency : dependencies) rule += escaped(dependency) + ":\n";
    return rule;
}

std::vector<std::string> folders_to_watch(std::span<const std::string> missing, std::span<const std::string> searched,
                                          std::span<const std::string> written) {
    std::set<fs::path> folders;
    for (const std::string& file : missing) folders.insert(fs::path(file).parent_path());
    std::map<fs::path, std::string> wanted;  // as they are named, by what they are
    const auto add = [&](const fs::path& folder) { wanted.try_emplace(folder_itself(folder), folder.string()); };
    for (const fs::path& folder : folders) add(nearest(folder));
    for (const std::string& folder : searched) add(folder);
    for (const std::string& folder : written) wanted.erase(folder_itself(folder));
    std::vector<std::string> names;
    for (const auto& [folder, name] : wanted)
        if (!folder.empty() && !is_of_ninja(folder)) names.push_back(ends_in_colon(name) ? name + "/" : name);
    return names;
}

}  // namespace patina::cli
