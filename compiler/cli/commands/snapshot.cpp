// patina snapshot: renders a folder's graphs and scenes and compares them with the pictures next to them.
#include "runtime/snapshot/snapshot.h"

#include <fmt/format.h>

#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/outputs.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::string folder;
    std::vector<std::string> update;  // absent, empty (all), or one case
    runtime::SnapshotOptions options;
};

// The result of a case, with the differences if two pictures were compared.
std::string line_of(const runtime::SnapshotCase& result) {
    const std::string line = fmt::format("{:<8} {}", runtime::to_string(result.state), result.name);
    const bool shows_figures = result.comparison && result.state != runtime::SnapshotState::Updated;
    if (!shows_figures) return line;
    return line + fmt::format("  ({:.3g} % of pixels differ, average error {:.2g})", 100 * result.comparison->share,
                              result.comparison->average);
}

void print_case(const Console& console, const runtime::SnapshotCase& result) {
    report(console, result.diagnostics);
    say(console, line_of(result));
    if (result.message.empty()) return;
    Diagnostic diagnostic = complaint(Complaint::Snapshot, {result.message});
    diagnostic.file = result.file;
    const auto note = [&](const char* what, const std::string& path) {
        if (path.empty()) return;
        Diagnostic& added = diagnostic.notes.emplace_back();
        added.severity = Severity::Note;
        added.message = std::string(what) + ": " + path;
    };
    note("received", result.received);
    if (!result.received.empty()) note("reference", result.reference);
    note("difference", result.difference);
    report(console, {&diagnostic, 1});
}

Exit compare(const Console& console, const Arguments& arguments) {
    const Compiler compiler;
    runtime::RenderMachine machine;
    const runtime::SnapshotReport result =
        runtime::run_snapshots(compiler, arguments.folder, arguments.options, machine);
    if (!result.error.empty()) complain(console, Complaint::Snapshot, {arguments.folder + ": " + result.error});
    Exit exit = result.ok() ? Exit::Ok : Exit::Wrong;
    for (const runtime::SnapshotCase& each : result.cases) {
        print_case(console, each);
        if (each.missing_machine) exit = Exit::Machine;
    }
    return exit;
}

}  // namespace

void add_snapshot(Program& program) {
    CLI::App& command = add_command(
        program, "snapshot",
        {"patina snapshot tests/graphs", "patina snapshot tests/graphs --only metal/rust --received build/received",
         "patina snapshot tests/graphs --update metal/rust    # its picture becomes the reference"});
    auto arguments = std::make_shared<Arguments>();
    runtime::SnapshotOptions& options = arguments->options;
    command
        .add_option("DIR", arguments->folder,
                    "Folder with NAME.snapshot.json files of graphs and scenes, each with its reference picture "
                    "NAME.reference.png; its sub-folders are searched, too")
        ->required()
        ->type_name(" ");
    CLI::Option* update =
        command
            .add_option("--update", arguments->update, "Replace the references that differ: of all cases, or of one")
            ->type_name("[CASE]")
            ->expected(0, 1);
    command.add_option("--only", options.only, "Run one case")->type_name("CASE");
    command
        .add_option("--received", options.received_dir,
                    "Folder for NAME.received.png and NAME.difference.png of the cases that fail; default: received")
        ->type_name("DIR")
        ->check(is_folder_name);
    command.add_option("--via", options.via, "Render all cases this way, instead of the way that their files name")
        ->type_name("glsl|hlsl|cpu")
        ->check(one_of("a way to render", {"glsl", "hlsl", "cpu"}));
    command
        .add_option("--device", options.device, "Use the GPU whose name contains NAME; default: the software renderer")
        ->type_name("NAME");
    command.add_flag("--vulkan-validation", options.validation, "Turn on the Khronos validation layer");
    add_include_option(command, options.include_dirs);
    set_check(command, [arguments, update] {
        arguments->options.update = update->count() > 0;
        if (!arguments->update.empty()) arguments->options.only = arguments->update.front();
    });

    set_work(program, command, [arguments](const Console& console) { return compare(console, *arguments); });
}

}  // namespace patina::cli
