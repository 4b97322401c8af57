// patina import: materials of other programs become graphs and their textures. The formats are in the list of
// compiler/importers; this file knows none of them.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "compiler/base/disk/disk.h"
#include "compiler/cli/commands/commands.h"
#include "compiler/cli/failures/failures.h"
#include "compiler/cli/outputs.h"
#include "compiler/importers/importer.h"
#include "compiler/importers/source_text.h"
#include "compiler/json/json_writer.h"

namespace patina::cli {
namespace {

namespace fs = std::filesystem;
using importers::Imported;
using importers::Importer;
using importers::printable;
using importers::Remark;

struct Arguments {
    std::vector<std::string> files;
    std::string folder;
    std::vector<std::string> include_dirs;
    bool shows_remarks = false, json = false, allows_refused = false;
};

importers::Source source_of(const std::string& path) {
    return {.path = path, .start = read_beginning(path, importers::kStart).bytes.value_or("")};
}

bool makes_pictures(const std::string& path) {
    const Importer* const importer = importers::importer_of(source_of(path));
    return importer && importer->makes_pictures;
}

// "measured BRDFs (.binary); glTF (.gltf, .glb)"
std::string formats() {
    std::string text;
    for (const Importer& importer : importers::importers())
        text += (text.empty() ? "" : "; ") + std::string(importer.reads);
    return text;
}

void report_refused(const Console& console, const std::string& file, std::span<const Remark> remarks) {
    for (const Remark& remark : remarks) {
        if (remark.kind != Remark::Kind::LeftOut) continue;
        Diagnostic warning = complaint(Complaint::NotImported, {printable(remark.part), printable(remark.text)});
        warning.severity = Severity::Warning;
        warning.file = remark.file.empty() ? file : remark.file;
        warning.line = remark.line;
        warning.column = remark.column;
        report(console, {&warning, 1});
    }
}

// As wide as it looks: {fmt} gives a wide character two columns.
std::string padded(std::string_view text, std::size_t width) {
    return fmt::format("{:<{}}", text, width);
}
// The columns of the text, but at most as many as `most`.
std::size_t columns(std::string_view text, std::size_t most) {
    return most - (padded(text, most).size() - text.size());
}

// What became of each part. Refused parts come first; parts of one state keep the order of the file.
//
//   rock.mtlx
//     12  refused      curve 'c'   a graph has no curves
//      3  approximate  input 'x'   ...
void print_table(const Console& console, const std::string& file, std::vector<const Remark*> rows) {
    constexpr std::size_t kWidestPart = 50;
    std::ranges::stable_sort(rows, {}, [](const Remark* each) {
        return std::tuple(-static_cast<int>(each->kind), each->line == 0, each->line, each->column);
    });
    std::size_t state_width = 0, part_width = 0, line_width = 1;
    for (const Remark* each : rows) {
        state_width = std::max(state_width, importers::to_string(each->kind).size());
        part_width = std::max(part_width, columns(printable(each->part), kWidestPart));
        line_width = std::max(line_width, std::to_string(each->line).size());
    }
    print(heading(console, file) + "\n");
    for (const Remark* each : rows) {
        const std::string_view color = each->kind == Remark::Kind::LeftOut   ? "\033[31m"
                                       : each->kind == Remark::Kind::Changed ? "\033[33m"
                                                                             : "";
        std::string state = padded(importers::to_string(each->kind), state_width);
        if (console.output_colors && !color.empty()) state = fmt::format("{}{}\033[0m", color, state);
        print(fmt::format("  {:>{}}  {}  {}  {}\n", each->line > 0 ? std::to_string(each->line) : "", line_width, state,
                          padded(printable(each->part), part_width), printable(each->text)));
    }
}

// One table for the file, and one for each other file that it uses.
void print_tables(const Console& console, const std::string& file, std::span<const Remark> remarks) {
    std::vector<std::string> files = {""};  // in the order in which the remarks name them
    std::unordered_map<std::string, std::vector<const Remark*>> rows;
    for (const Remark& each : remarks) {
        const auto [found, is_new] = rows.try_emplace(each.file);
        if (is_new && !each.file.empty()) files.push_back(each.file);
        found->second.push_back(&each);
    }
    for (const std::string& other : files)
        print_table(console, printable(other.empty() ? file : other), std::move(rows[other]));
}

// What was written, and the remarks, as one JSON object on a line, or with a line for each remark.
std::string json_of(const std::string& file, std::span<const std::string> written, std::span<const Remark> remarks,
                    bool has_lines = false) {
    std::string text = "{\"file\": " + json_text(file) + ", \"written\": [";
    for (std::size_t i = 0; i < written.size(); ++i) text += (i > 0 ? ", " : "") + json_text(written[i]);
    text += "], \"parts\": [";
    for (std::size_t i = 0; i < remarks.size(); ++i) {
        const Remark& remark = remarks[i];
        text +=
            fmt::format("{}{}{{\"part\": {}, \"state\": {}, \"text\": {}", i > 0 ? "," : "",
                        has_lines ? "\n  "
                        : i > 0   ? " "
                                  : "",
                        json_text(remark.part), json_text(importers::to_string(remark.kind)), json_text(remark.text));
        if (!remark.file.empty()) text += ", \"file\": " + json_text(remark.file);
        if (remark.line > 0) text += fmt::format(", \"line\": {}, \"column\": {}", remark.line, remark.column);
        text += "}";
    }
    return text + (has_lines ? "\n]}\n" : "]}\n");
}

// "12 parts: 10 exact, 1 approximate, 1 refused"
std::string summary_of(std::span<const Remark> remarks) {
    std::string text = fmt::format("{} parts", remarks.size());
    for (const Remark::Kind kind : {Remark::Kind::Taken, Remark::Kind::Changed, Remark::Kind::LeftOut})
        text += fmt::format("{} {} {}", kind == Remark::Kind::Taken ? ":" : ",",
                            std::ranges::count(remarks, kind, &Remark::kind), importers::to_string(kind));
    return text;
}

// All files of an import, or what is wrong. The graphs come last: if a graph is there, its textures are, too.
runtime::Outcome<OutputFiles> files_of(const Imported& made, const fs::path& folder, PictureEncoder encode) {
    OutputFiles files;
    const auto path_of = [&](const std::string& name) { return (folder / name).string(); };
    for (const importers::PictureFile& picture : made.pictures) {
        runtime::Outcome<std::string> bytes = encode(picture.name, picture.linear);
        if (!bytes) return runtime::Failure{"cannot write '" + path_of(picture.name) + "': " + bytes.error};
        files.add(path_of(picture.name), std::move(bytes.value));
    }
    for (const importers::BinaryFile& copy : made.copies) files.add(path_of(copy.name), copy.bytes);
    for (const importers::TextFile& graph : made.graphs) files.add(path_of(graph.name), graph.text);
    return files;
}

// The file is there already, as it would be written: several imports share it, such as a sub-graph of two graphs.
bool is_there(const runtime::OutputFile& file) {
    return read_disk(file.path, file.bytes.size(), anywhere()).bytes == file.bytes;
}

Exit import_file(const Console& console, const Arguments& arguments, const std::string& file, PictureEncoder encode) {
    const importers::Source source = source_of(file);
    const Importer* importer = importers::importer_of(source);
    if (!importer) {
        complain(console, Complaint::UnknownFormat, {file, formats()});
        return Exit::Wrong;
    }
    const fs::path folder = arguments.folder.empty() ? fs::path(file).parent_path() : fs::path(arguments.folder);
    Imported made = importers::read_verified(*importer, source,
                                             {.folder = folder.string(), .include_dirs = arguments.include_dirs});
    if (!made.error.empty()) {
        const Diagnostic wrong =
            importers::cannot_import(file, importers::why_unreadable(file).value_or(std::move(made.error)));
        report(console, {&wrong, 1});
        return Exit::Wrong;
    }
    if (importer->keeps_report) {
        std::vector<std::string> names;
        for (const importers::TextFile& graph : made.graphs) names.push_back(graph.name);
        made.graphs.push_back({.name = fs::path(file).stem().string() + ".import.json",
                               .text = json_of(fs::path(file).filename().string(), names, made.remarks, true)});
    }
    runtime::Outcome<OutputFiles> files = files_of(made, folder, encode);
    if (!files) {
        complain(console, Complaint::CannotWrite, {files.error});
        return Exit::Wrong;
    }
    // An import that would write nothing has been made before.
    if (!std::ranges::all_of(files.value.files, is_there)) std::erase_if(files.value.files, is_there);
    for (const runtime::OutputFile& each : files.value.files) {
        if (!is_taken(each.path)) continue;
        complain(console, Complaint::FileExists, {each.path});
        return Exit::Wrong;
    }
    if (!Outputs(console).write(file, files.value)) return Exit::Wrong;
    const Exit exit = made.has_refused && !arguments.allows_refused ? Exit::Wrong : Exit::Ok;
    if (arguments.json) {
        std::vector<std::string> written;
        for (const runtime::OutputFile& each : files.value.files) written.push_back(each.path);
        print(json_of(file, written, made.remarks));
        return exit;
    }
    // The table says what is refused, too.
    if (!arguments.shows_remarks || console.json) report_refused(console, file, made.remarks);
    if (arguments.shows_remarks) {
        print_tables(console, file, made.remarks);
        print(summary_of(made.remarks) + "\n");
    }
    say(console, files.value);
    return exit;
}

}  // namespace

void add_import(Program& program) {
    std::vector<std::string_view> examples;
    for (const Importer& importer : importers::importers()) examples.push_back(importer.example);
    examples.push_back("patina import *.binary -o measured && patina render measured/gold-paint.graph.json");
    examples.push_back("patina import upload/wood.mtlx --root upload -o wood");
    CLI::App& command = add_command(program, "import", examples);
    auto arguments = std::make_shared<Arguments>();
    command.add_option("FILES", arguments->files, "Files to import: " + formats())->required()->type_name(" ");
    command.add_option("-o,--output", arguments->folder, "Folder to write to; default: the folder of each file")
        ->type_name("DIR")
        ->check(is_folder_name);
    command
        .add_option("-I,--include", arguments->include_dirs,
                    "Folder to search for files that the imported ones name; default: the folder of each file")
        ->type_name("DIR")
        ->check(is_folder)
        ->allow_extra_args(false);
    command.add_flag("--allow-refused", arguments->allows_refused,
                     "Exit with 0, even if a graph has a constant instead of a refused part");
    command.add_flag("--report", arguments->shows_remarks,
                     "Print what became of each part of the files: exact, approximate or refused, and why");
    command.add_flag("--json", arguments->json, "Print the same as JSON, one object a file, instead of warnings");
    add_root_option(command);
    set_work(program, command, [arguments, &program](const Console& console) {
        if (is_mixed(console, arguments->json, "--json")) return Exit::Usage;
        if (!program.encode_picture && std::ranges::any_of(arguments->files, makes_pictures))
            return turn_into(Home::Render, program.argv);
        Exit exit = Exit::Ok;
        for (std::size_t i = 0; i < arguments->files.size(); ++i) {
            show_progress(console, i, arguments->files.size(), arguments->files[i]);
            const std::string& file = arguments->files[i];
            exit = worse(exit, guarded(console, file,
                                       [&] { return import_file(console, *arguments, file, program.encode_picture); }));
        }
        return exit;
    });
}

}  // namespace patina::cli
