// The graphs that a command works on: files, all that a folder holds, and those of a list. And the work on them, on
// several threads, with their results in order.
//
//   add_input_options(command, arguments->inputs, "Material graphs (JSON)");
//   const Inputs inputs = find_inputs(console, arguments.inputs, {".graph.json"});
//   work_on(console, inputs.files, jobs, [&](const Input& input) { return make(input); },
//           [&](const Input& input, Made& made) { return write(input, made); });
#pragma once

#include <exception>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/cli/failures/failures.h"
#include "compiler/cli/program.h"
#include "runtime/jobs/jobs.h"

namespace patina::cli {

struct Input {
    std::string path{};
    std::string folder{};  // below the folder of the outputs: "metal" for art/metal/rust.graph.json of the folder art
    // The command line is wrong if it names two files of one output.
    enum class From { CommandLine, List, Folder } from = From::CommandLine;
};

struct Inputs {
    std::vector<Input> files{};
    std::vector<std::string> folders{};  // that were searched for them; a file that is added to one is a new input
    Exit exit = Exit::Ok;                // Wrong: some were not found
};

struct InputArguments {
    std::vector<std::string> words{};  // files and folders
    std::string list{};                // --files
    int jobs = 0;                      // --jobs; 0: one for each core
};

// The files and folders, --files and --jobs. `what` says which files.
void add_input_options(CLI::App& command, InputArguments& arguments, const std::string& what);
// Throws the usage error if neither a file nor a list is given.
void require_inputs(const InputArguments& arguments);

// Of folders: the files with one of the endings, in order. A list or a folder that cannot be read, or holds no such
// file, is reported; the other inputs are there. A file that is named twice is there once, where it was named first.
Inputs find_inputs(const Console& console, const InputArguments& arguments,
                   std::initializer_list<std::string_view> endings);

// The files of a folder and below it. None if it is no folder. Folders that cannot be read are left out.
std::vector<Input> inputs_below(const std::string& folder, std::initializer_list<std::string_view> endings);

// Leaves one of those that are the same file. A symbolic link to a file is a file of its own.
void take_out_repeated(std::vector<Input>& inputs);

// Removes inputs that would write the same file, and reports them. Throws the usage error if the command line names
// both.
Exit take_out_equal_outputs(const Console& console, std::vector<Input>& inputs, std::string_view ending,
                            std::string_view verb);

// Errors without a location in a file, such as -D with a name that this graph does not have, get the graph as their
// file.
void name_graph(std::vector<Diagnostic>& diagnostics, const std::string& graph);

// `make` runs on several threads; `finish`, which prints and writes, on one at a time and in the inputs' order. The
// exit code is the greatest one that `finish` returns. An exception for one input is reported for it, and the work on
// the other inputs continues.
template <class Make, class Finish>
Exit work_on(const Console& console, const std::vector<Input>& inputs, int jobs, const Make& make,
             const Finish& finish) {
    using Made = decltype(make(inputs.front()));
    std::vector<std::optional<Made>> made(inputs.size());
    std::vector<std::exception_ptr> failures(inputs.size());
    Exit exit = Exit::Ok;
    runtime::in_order(
        inputs.size(), jobs,
        [&]() -> runtime::Work {
            return [&](std::size_t i) {
                try {
                    made[i].emplace(make(inputs[i]));
                } catch (...) {
                    failures[i] = std::current_exception();
                }
            };
        },
        [&](std::size_t i) {
            exit = worse(exit, guarded(console, inputs[i].path, [&] {
                             if (failures[i]) std::rethrow_exception(failures[i]);
                             show_progress(console, i, inputs.size(), inputs[i].path);
                             return finish(inputs[i], *made[i]);
                         }));
            made[i].reset();
        });
    return exit;
}

}  // namespace patina::cli
