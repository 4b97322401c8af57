// patina merge: the three-way merge of graphs, also as git's merge driver.
#include <fmt/format.h>

#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/files.h"
#include "compiler/cli/outputs.h"
#include "patina/graph_merge.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::string base, ours, theirs, output = "-", name;
    MergeOptions options;
};

constexpr Exit kConflicts = Exit::Wrong;
constexpr Exit kTrouble = Exit::Usage;

std::optional<MergeInput> read_side(const Console& console, const std::string& path, std::string name) {
    std::string error;
    std::optional<std::string> text = read_file(path, error);
    if (!text) {
        complain(console, Complaint::CannotRead, {path, error});
        return std::nullopt;
    }
    return MergeInput{.name = std::move(name), .text = std::move(*text)};
}

// What to do with a file that cannot be merged as a graph. As git's driver, the command has its name.
std::string advice(const Arguments& arguments) {
    if (arguments.name.empty())
        return fmt::format("nothing is merged; 'git merge-file {} {} {}' merges the files as text", arguments.ours,
                           arguments.base, arguments.theirs);
    return fmt::format(
        "git keeps OURS, without markers; to merge it as text: git -c merge.patina.driver='git merge-file %A %O %B' "
        "checkout --merge -- {}",
        arguments.name);
}

Exit merge(const Console& console, const Arguments& arguments) {
    if (is_mixed(console, is_standard_output(arguments.output), "the merged graph")) return kTrouble;
    // git's files have names that say nothing.
    const auto name_of = [&](const std::string& path, const char* side) {
        return arguments.name.empty() ? path : arguments.name + " (" + side + ")";
    };
    const std::optional<MergeInput> base = read_side(console, arguments.base, name_of(arguments.base, "base"));
    const std::optional<MergeInput> ours = read_side(console, arguments.ours, name_of(arguments.ours, "ours"));
    const std::optional<MergeInput> theirs = read_side(console, arguments.theirs, name_of(arguments.theirs, "theirs"));
    if (!base || !ours || !theirs) return kTrouble;

    MergeOptions options = arguments.options;
    options.path = arguments.name.empty() ? arguments.ours : arguments.name;
    const Compiler compiler;
    MergeResult merged = merge_graphs(compiler, *base, *ours, *theirs, options);
    if (merged.state == MergeState::Unreadable && !merged.diagnostics.empty()) {
        Diagnostic& note = merged.diagnostics.back().notes.emplace_back();
        note.severity = Severity::Note;
        note.message = advice(arguments);
    }
    report(console, merged.diagnostics);
    if (merged.state == MergeState::Unreadable) return kTrouble;
    OutputFiles files;
    files.add(arguments.output, merged.text);
    if (!Outputs(console).write(arguments.ours, files) || output_failed()) return kTrouble;
    return merged.state == MergeState::Clean ? Exit::Ok : kConflicts;
}

}  // namespace

void add_merge(Program& program) {
    CLI::App& command =
        add_command(program, "merge",
                    {"patina merge base.graph.json ours.graph.json theirs.graph.json -o rust.graph.json",
                     "git config merge.patina.driver 'patina merge %O %A %B -o %A --name %P --marker-size %L'",
                     "echo '*.graph.json merge=patina' >> .gitattributes",
                     "Exit codes: 0 clean, and the result compiles; 1 conflicts; 2 trouble, and nothing is written"});
    auto arguments = std::make_shared<Arguments>();
    command
        .add_option("BASE", arguments->base,
                    "The version from which both sides were made; an empty file: there is none")
        ->required()
        ->type_name(" ");
    command.add_option("OURS", arguments->ours, "One side; its text stays where nothing changed")
        ->required()
        ->type_name(" ");
    command.add_option("THEIRS", arguments->theirs, "The other side")->required()->type_name(" ");
    command
        .add_option("-o,--output", arguments->output,
                    "The merged graph, with conflict markers; default: standard output")
        ->type_name("OUT");
    command
        .add_option("--name", arguments->name,
                    "The graph's own path, for messages and for the files that it names; default: OURS")
        ->type_name("PATH");
    command.add_option("--marker-size", arguments->options.marker_size, "Length of the conflict markers; default: 7")
        ->type_name("N")
        ->check(CLI::Range(1, 1000));
    add_include_option(command, arguments->options.compile.include_dirs);
    set_work(program, command, [arguments](const Console& console) { return merge(console, *arguments); });
}

}  // namespace patina::cli
