#include "compiler/cli/inputs.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "compiler/cli/files.h"
#include "runtime/files/find_files.h"

namespace patina::cli {
namespace {

namespace fs = std::filesystem;

// The folder of a path that lies below another one, or nothing.
std::string folder_below(const fs::path& path, const fs::path& root) {
    const fs::path folder = path.lexically_normal().lexically_relative(root.lexically_normal()).parent_path();
    const bool is_outside = folder.is_absolute() || (!folder.empty() && *folder.begin() == "..");
    return is_outside || folder == "." ? std::string() : folder.string();
}

bool has_ending(const std::string& path, std::initializer_list<std::string_view> endings) {
    return std::ranges::any_of(endings, [&](std::string_view ending) { return path.ends_with(ending); });
}

bool add_folder(const Console& console, const std::string& folder, std::initializer_list<std::string_view> endings,
                std::vector<Input>& inputs) {
    const runtime::Outcome<std::vector<std::string>> files = runtime::files_below(folder);
    const std::size_t before = inputs.size();
    for (const std::string& file : files.value)
        if (has_ending(file, endings)) inputs.push_back({.path = file, .folder = folder_below(file, folder)});
    if (inputs.size() > before) return true;
    complain(console, Complaint::CannotRead, {folder, files ? "there is no graph in it" : files.error});
    return false;
}

bool add_list(const Console& console, const std::string& list, std::vector<Input>& inputs) {
    std::string error;
    const std::optional<std::string> text = list == "-" ? read_standard_input() : read_file(list, error);
    if (!text) {
        complain(console, Complaint::CannotRead, {list, error});
        return false;
    }
    for (std::size_t begin = 0; begin < text->size();) {
        const std::size_t end = std::min(text->find('\n', begin), text->size());
        std::string path = text->substr(begin, end - begin);
        if (path.ends_with('\r')) path.pop_back();
        if (!path.empty()) inputs.push_back({.path = path, .folder = folder_below(path, ".")});
        begin = end + 1;
    }
    return true;
}

}  // namespace

void add_input_options(CLI::App& command, InputArguments& arguments, const std::string& what) {
    command.add_option("GRAPH", arguments.words, what + ", and folders, which stand for all in them and below")
        ->type_name(" ");
    command
        .add_option("--files", arguments.list,
                    "Also take the files that this file lists, one a line; -: the list comes from standard input")
        ->type_name("LIST");
    command.add_option("--jobs", arguments.jobs, "Work on N files at once; default: one for each core")
        ->type_name("N")
        ->check(CLI::Range(1, 256));
}

void require_inputs(const InputArguments& arguments) {
    if (arguments.words.empty() && arguments.list.empty())
        throw CLI::ValidationError("GRAPH", "name a graph or a folder, or a list of graphs with --files");
}

std::optional<std::vector<Input>> find_inputs(const Console& console, const InputArguments& arguments,
                                              std::initializer_list<std::string_view> endings) {
    std::vector<Input> inputs;
    for (const std::string& word : arguments.words) {
        std::error_code ignored;
        if (!fs::is_directory(word, ignored))
            inputs.push_back({.path = word});
        else if (!add_folder(console, word, endings, inputs))
            return std::nullopt;
    }
    if (!arguments.list.empty() && !add_list(console, arguments.list, inputs)) return std::nullopt;
    return inputs;
}

void refuse_equal_outputs(const std::vector<Input>& inputs, std::string_view ending, std::string_view verb) {
    std::map<std::string, std::vector<std::string>> by_folder;
    for (const Input& input : inputs) by_folder[input.folder].push_back(input.path);
    for (const auto& [folder, graphs] : by_folder) refuse_equal_outputs(graphs, ending, verb);
}

}  // namespace patina::cli
