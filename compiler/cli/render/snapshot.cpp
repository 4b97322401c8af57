// patina snapshot: renders a folder's graphs and scenes and compares them with the references next to them.
#include "runtime/snapshot/snapshot.h"

#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <optional>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/outputs.h"
#include "runtime/snapshot/report_data.h"
#include "runtime/snapshot/report_page.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::string folder;
    std::vector<std::string> update;  // absent, empty (all), or one case
    std::vector<std::string> tolerance;
    std::string shard, page, junit;
    bool json = false;
    runtime::SnapshotOptions options;

    // What goes to standard output in place of a line for each case; empty: these lines.
    std::vector<std::string> printed() const {
        std::vector<std::string> names;
        if (json) names.emplace_back("--json");
        if (is_standard_output(page)) names.emplace_back("--report " + page);
        if (is_standard_output(junit)) names.emplace_back("--junit " + junit);
        return names;
    }
};

// The result of a case, with its figures if two pictures were compared.
std::string line_of(const runtime::SnapshotCase& result) {
    std::string line = fmt::format("{:<8} {}", runtime::to_string(result.state), result.name);
    if (result.gates.empty() || result.state == runtime::SnapshotState::Updated) return line;
    std::string figures;
    for (const runtime::Gate& gate : result.gates) figures += (figures.empty() ? "" : ", ") + runtime::to_text(gate);
    return line + "  (" + figures + ")";
}

void print_case(const Console& console, const runtime::SnapshotCase& result, bool has_line) {
    report(console, result.diagnostics);
    if (has_line) say(console, line_of(result));
    if (result.message.empty()) return;
    Diagnostic diagnostic = complaint(Complaint::Snapshot, {result.message});
    diagnostic.file = result.file;
    const auto note = [&](const char* what, const std::string& text) {
        if (text.empty()) return;
        Diagnostic& added = diagnostic.notes.emplace_back();
        added.severity = Severity::Note;
        added.message = std::string(what) + ": " + text;
    };
    note("received", result.received);
    if (!result.difference.empty()) note("reference", result.reference);
    note("difference", result.difference);
    if (result.other_driver)
        note("the limits are wider, because another driver drew the reference",
             result.then.device + (result.then.driver.empty() ? "" : ", " + result.then.driver));
    report(console, {&diagnostic, 1});
}

void warn_of_orphans(const Console& console, const runtime::SnapshotReport& result) {
    for (const std::string& orphan : result.orphans) {
        Diagnostic warning =
            complaint(Complaint::Snapshot, {"no graph, scene or snapshot file has this reference: remove it"});
        warning.severity = Severity::Warning;
        warning.file = orphan;
        report(console, {&warning, 1});
    }
}

std::string summary(const runtime::SnapshotReport& result) {
    std::string line;
    for (const auto state : {runtime::SnapshotState::Passed, runtime::SnapshotState::Updated,
                             runtime::SnapshotState::Failed, runtime::SnapshotState::Missing}) {
        const std::size_t count = result.count(state);
        if (count > 0) line += fmt::format("{}{} {}", line.empty() ? "" : ", ", count, runtime::to_string(state));
    }
    return line.empty() ? "no case in this shard" : line;
}

// The page and the file for a build server, also if cases fail: that is when they are wanted.
bool write_reports(const Console& console, const Arguments& arguments, const runtime::SnapshotReport& result) {
    Outputs outputs(console);
    const auto write = [&](const std::string& path, auto make) {
        if (path.empty()) return true;
        OutputFiles file;
        file.add(path, make(result, arguments.folder));
        if (!outputs.write(arguments.folder, file)) return false;
        if (arguments.printed().empty()) say(console, file);
        return true;
    };
    const bool has_page = write(arguments.page, runtime::report_page);
    return write(arguments.junit, runtime::report_junit) && has_page;
}

Exit compare(const Console& console, Arguments& arguments) {
    const Compiler compiler;
    arguments.options.keeps_pictures = !arguments.page.empty();
    arguments.options.on_case = [&](const runtime::SnapshotCase& each, std::size_t index, std::size_t count) {
        print_case(console, each, arguments.printed().empty());
        if (index + 1 < count) show_progress(console, index + 1, count, "");
    };
    const runtime::SnapshotReport result = runtime::run_snapshots(compiler, arguments.folder, arguments.options);
    end_progress(console);
    if (!result.error.empty()) {
        complain(console, Complaint::Snapshot, {result.error});
        return Exit::Wrong;
    }
    warn_of_orphans(console, result);
    if (arguments.json) print(runtime::report_json(result));
    if (arguments.printed().empty()) say(console, summary(result));
    Exit exit = result.ok() ? Exit::Ok : Exit::Wrong;
    if (!write_reports(console, arguments, result)) exit = Exit::Wrong;
    for (const runtime::SnapshotCase& each : result.cases)
        if (each.missing_machine) exit = Exit::Machine;
    return exit;
}

// --- words of the command line

std::optional<double> number_of(const std::string& word) {
    double value = 0;
    const char* end = word.data() + word.size();
    const auto [next, error] = std::from_chars(word.data(), end, value);
    return error == std::errc{} && next == end ? std::optional(value) : std::nullopt;
}

std::string check_tolerance_word(const std::string& word) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const runtime::ToleranceKey* key = runtime::find_tolerance_key(name);
    if (!key) {
        std::vector<std::string> names;
        for (const runtime::ToleranceKey& each : runtime::tolerance_keys()) names.emplace_back(each.name);
        return fmt::format("there is no tolerance '{}'; {}", name, suggestion(name, names));
    }
    const std::optional<double> value = equals == std::string::npos ? std::nullopt : number_of(word.substr(equals + 1));
    if (!value) return fmt::format("'{}' is not of the form NAME=NUMBER, such as share=0.01", word);
    return runtime::check_tolerance(*key, *value);
}

void take_tolerance(Arguments& arguments) {
    for (const std::string& word : arguments.tolerance) {
        const std::size_t equals = word.find('=');
        arguments.options.tolerance[word.substr(0, equals)] = number_of(word.substr(equals + 1)).value_or(0);
    }
}

// "2/5", or throws.
runtime::Shard read_shard(const std::string& word) {
    runtime::Shard shard;
    const char* end = word.data() + word.size();
    const auto [slash, first] = std::from_chars(word.data(), end, shard.index);
    bool is_good = first == std::errc{} && slash != end && *slash == '/';
    if (is_good) {
        const auto [last, second] = std::from_chars(slash + 1, end, shard.count);
        is_good = second == std::errc{} && last == end && shard.index >= 1 && shard.index <= shard.count;
    }
    if (!is_good) throw CLI::ValidationError("--shard", "'" + word + "' is not a part of several, such as 2/5");
    return shard;
}

void add_outputs(CLI::App& command, Arguments& arguments) {
    command
        .add_option("--received", arguments.options.received_dir,
                    "Folder for NAME.received.png and NAME.difference.png of the cases that fail; default: received")
        ->type_name("DIR")
        ->check(is_folder_name);
    command
        .add_option("--report", arguments.page,
                    "Write a page with the pictures, their differences, the shaders' differences and costs: one file "
                    "that needs no other")
        ->type_name("FILE.html");
    command.add_option("--junit", arguments.junit, "Write the results as JUnit XML, for build servers")
        ->type_name("FILE.xml");
    command.add_flag("--json", arguments.json, "Print the results as JSON");
}

}  // namespace

void add_snapshot(Program& program) {
    CLI::App& command = add_command(
        program, "snapshot",
        {"patina snapshot art", "patina snapshot art --only metal/rust --received build/received",
         "patina snapshot art --update metal/rust    # its picture becomes the reference",
         "patina snapshot art --report report.html --junit results.xml", "patina snapshot art --shard 2/5 --json",
         "patina snapshot art --tolerance share=0.01,perceptual=0.02"});
    add_pixels_option(program, command);
    auto arguments = std::make_shared<Arguments>();
    runtime::SnapshotOptions& options = arguments->options;
    command
        .add_option("DIR", arguments->folder,
                    "Folder with graphs, scenes and NAME.snapshot.json files, each with its reference picture "
                    "NAME.reference.png; its sub-folders are searched, too")
        ->required()
        ->type_name(" ");
    CLI::Option* update =
        command
            .add_option("--update", arguments->update,
                        "Replace the references that differ, and make missing ones: of all cases, or of one")
            ->type_name("[CASE]")
            ->expected(0, 1);
    command.add_option("--only", options.only, "Run one case, or all pictures of one snapshot file")->type_name("CASE");
    add_words_option(command, "--tolerance", arguments->tolerance,
                     "Limits that replace those of the files: pixel, share, average, tile, perceptual, otherDriver",
                     check_tolerance_word)
        ->type_name("NAME=NUMBER");
    add_outputs(command, *arguments);
    command.add_option("--jobs", options.jobs, "Run N cases at once; default: one for each core, at most 4")
        ->type_name("N")
        ->check(CLI::Range(1, 256));
    command.add_option("--shard", arguments->shard, "Run the I-th of N equal parts of the cases, on one of N machines")
        ->type_name("I/N");
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
        // Without a case, CLI11 gives an empty word.
        if (!arguments->update.empty() && !arguments->update.front().empty()) {
            if (!arguments->options.only.empty())
                throw CLI::ValidationError("--update", "a case here, or in --only: not both");
            arguments->options.only = arguments->update.front();
        }
        take_tolerance(*arguments);
        if (const std::vector<std::string> printed = arguments->printed(); printed.size() > 1)
            throw CLI::ValidationError(printed[0], "and " + printed[1] + " both print to standard output");
        if (!arguments->shard.empty()) arguments->options.shard = read_shard(arguments->shard);
    });

    set_work(program, command, [arguments](const Console& console) {
        const std::vector<std::string> printed = arguments->printed();
        if (is_mixed(console, !printed.empty(), printed.empty() ? "" : printed.front())) return Exit::Usage;
        return compare(console, *arguments);
    });
}

}  // namespace patina::cli
