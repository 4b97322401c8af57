#include "compiler/cli/inputs.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

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

std::vector<Input> inputs_among(const std::vector<std::string>& files, const std::string& folder,
                                std::initializer_list<std::string_view> endings) {
    std::vector<Input> inputs;
    for (const std::string& file : files) {
        if (has_ending(file, endings))
            inputs.push_back({.path = file, .folder = folder_below(file, folder), .from = Input::From::Folder});
    }
    return inputs;
}

void add_folder(const Console& console, const std::string& folder, std::initializer_list<std::string_view> endings,
                Inputs& inputs) {
    runtime::FolderContents below = runtime::look_below(folder);
    const std::vector<Input> files = inputs_among(below.files, folder, endings);
    if (below.unread.empty() && files.empty())
        below.unread.push_back({.path = folder, .why = "there is no graph in it"});
    for (const runtime::UnreadFolder& unread : below.unread) {
        complain(console, Complaint::CannotRead, {unread.path, unread.why});
        inputs.exit = Exit::Wrong;
    }
    inputs.files.insert(inputs.files.end(), files.begin(), files.end());
    inputs.folders.insert(inputs.folders.end(), below.folders.begin(), below.folders.end());
}

void add_list(const Console& console, const std::string& list, Inputs& inputs) {
    std::string error;
    const std::optional<std::string> text = read_file(list, error);
    if (!text) {
        complain(console, Complaint::CannotRead, {list, error});
        inputs.exit = Exit::Wrong;
        return;
    }
    // With NUL bytes, names may have line breaks: 'git ls-files -z'.
    const char ending = text->find('\0') == text->npos ? '\n' : '\0';
    for (std::size_t begin = 0; begin < text->size();) {
        const std::size_t end = std::min(text->find(ending, begin), text->size());
        std::string path = text->substr(begin, end - begin);
        if (ending == '\n' && path.ends_with('\r')) path.pop_back();
        if (!path.empty())
            inputs.files.push_back({.path = path, .folder = folder_below(path, "."), .from = Input::From::List});
        begin = end + 1;
    }
}

}  // namespace

void add_input_options(CLI::App& command, InputArguments& arguments, const std::string& what) {
    command.add_option("GRAPH", arguments.words, what + ", and folders, which mean all in them and below")
        ->type_name(" ");
    command
        .add_option("--files", arguments.list,
                    "Also use the files in this list: one a line, or with a NUL byte after each, as git's -z writes "
                    "them; -: read the list from standard input")
        ->type_name("LIST");
    command.add_option("--jobs", arguments.jobs, "Work on N files at once; default: one for each core")
        ->type_name("N")
        ->check(CLI::Range(1, 256));
}

void require_inputs(const InputArguments& arguments) {
    if (arguments.words.empty() && arguments.list.empty())
        throw CLI::ValidationError("GRAPH", "name a graph or a folder, or a list of graphs with --files");
}

std::vector<Input> inputs_below(const std::string& folder, std::initializer_list<std::string_view> endings) {
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) return {};
    return inputs_among(runtime::look_below(folder).files, folder, endings);
}

Inputs find_inputs(const Console& console, const InputArguments& arguments,
                   std::initializer_list<std::string_view> endings) {
    Inputs inputs;
    for (const std::string& word : arguments.words) {
        std::error_code ignored;
        if (!fs::is_directory(word, ignored))
            inputs.files.push_back({.path = word, .from = Input::From::CommandLine});
        else
            add_folder(console, word, endings, inputs);
    }
    if (!arguments.list.empty()) add_list(console, arguments.list, inputs);
    take_out_repeated(inputs.files);
    return inputs;
}

void take_out_repeated(std::vector<Input>& inputs) {
    std::map<fs::path, fs::path> folders;  // without symbolic links
    std::set<fs::path> seen;
    std::erase_if(inputs, [&](const Input& input) {
        const fs::path path = input.path;
        const auto [folder, is_new] = folders.try_emplace(path.parent_path());
        std::error_code ignored;
        if (is_new) folder->second = fs::canonical(path.has_parent_path() ? folder->first : ".", ignored);
        return !seen.insert(folder->second.empty() ? path : folder->second / path.filename()).second;
    });
}

Exit take_out_equal_outputs(const Console& console, std::vector<Input>& inputs, std::string_view ending,
                            std::string_view verb) {
    std::map<std::string, std::vector<std::size_t>> by_folder;
    for (std::size_t i = 0; i < inputs.size(); ++i) by_folder[inputs[i].folder].push_back(i);
    std::vector<bool> is_out(inputs.size());
    for (const auto& [folder, indices] : by_folder) {
        std::vector<std::string> graphs;
        for (const std::size_t i : indices) graphs.push_back(inputs[i].path);
        for (const EqualOutputs& equal : find_equal_outputs(graphs, ending, verb)) {
            const std::size_t first = indices[equal.first], second = indices[equal.second];
            const auto is_named = [](const Input& input) { return input.from == Input::From::CommandLine; };
            if (is_named(inputs[first]) && is_named(inputs[second])) throw CLI::ValidationError("GRAPH", equal.why);
            complain(console, Complaint::EqualOutputs, {equal.why});
            is_out[first] = is_out[second] = true;
        }
    }
    std::vector<Input> kept;
    for (std::size_t i = 0; i < inputs.size(); ++i)
        if (!is_out[i]) kept.push_back(std::move(inputs[i]));
    const bool are_all = kept.size() == inputs.size();
    inputs = std::move(kept);
    return are_all ? Exit::Ok : Exit::Wrong;
}

void name_graph(std::vector<Diagnostic>& diagnostics, const std::string& graph) {
    for (Diagnostic& each : diagnostics)
        if (each.file.empty()) each.file = graph;
}

}  // namespace patina::cli
