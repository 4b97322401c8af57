// patina import: materials of other programs become graphs and their textures. The formats are in the list of
// compiler/importers; this file knows none of them.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/files.h"
#include "compiler/importers/importer.h"

namespace patina::cli {
namespace {

namespace fs = std::filesystem;
using importers::Imported;
using importers::Importer;
using importers::Remark;

struct Arguments {
    std::vector<std::string> files;
    std::string folder;
    bool shows_remarks = false;
};

importers::Source source_of(const std::string& path) {
    importers::Source source{.path = path, .start = std::string(importers::kStart, '\0')};
    std::ifstream file(path, std::ios::binary);
    file.read(source.start.data(), static_cast<std::streamsize>(source.start.size()));
    source.start.resize(static_cast<std::size_t>(file.gcount()));
    return source;
}

// "measured BRDFs (.binary); glTF (.gltf, .glb)"
std::string formats() {
    std::string text;
    for (const Importer& importer : importers::importers())
        text += (text.empty() ? "" : "; ") + std::string(importer.reads);
    return text;
}

void report_remarks(const Console& console, const Arguments& arguments, const std::string& file,
                    std::span<const Remark> remarks) {
    for (const Remark& remark : remarks) {
        if (remark.kind == Remark::Kind::LeftOut) {
            Diagnostic warning = complaint(Complaint::NotImported, {remark.part, remark.text});
            warning.severity = Severity::Warning;
            warning.file = file;
            warning.line = remark.line;
            warning.column = remark.column;
            report(console, {&warning, 1});
        }
        if (arguments.shows_remarks) {
            const std::string place =
                remark.line > 0 ? fmt::format("{}:{}:{}", file, remark.line, remark.column) : file;
            print(fmt::format("{}: {} {}: {}\n", place, importers::to_string(remark.kind), remark.part, remark.text));
        }
    }
}

// Writes everything or nothing; returns what is wrong. The graphs come last: if a graph is there, its textures are,
// too.
class Output {
public:
    explicit Output(fs::path folder) : folder_(std::move(folder)) {
        is_new_folder_ = !folder_.empty() && !fs::exists(folder_, ignored_);
    }

    std::string write(const Imported& made) {
        std::error_code failure;
        if (!folder_.empty()) fs::create_directories(folder_, failure);
        if (failure) return "cannot make the folder '" + folder_.string() + "': " + failure.message();
        std::string error;
        for (const importers::PictureFile& picture : made.pictures) {
            if (error = runtime::save_image(path_of(picture.name), picture.linear); !error.empty()) break;
            pictures_.push_back(path_of(picture.name));
        }
        if (error.empty()) {
            OutputFiles files;
            for (const importers::BinaryFile& copy : made.copies) files.add(path_of(copy.name), copy.bytes);
            for (const importers::TextFile& graph : made.graphs) files.add(path_of(graph.name), graph.text);
            error = commit(files);
        }
        if (!error.empty()) take_back();
        return error;
    }
    std::string path_of(const std::string& name) const { return (folder_ / name).string(); }

private:
    void take_back() {
        for (const std::string& picture : pictures_) fs::remove(picture, ignored_);
        if (is_new_folder_) fs::remove(folder_, ignored_);  // fails, as it should, if there is something in it
    }

    fs::path folder_;
    bool is_new_folder_ = false;
    std::vector<std::string> pictures_;
    std::error_code ignored_;
};

std::vector<std::string> names_of(const Imported& made) {
    std::vector<std::string> names;
    for (const importers::PictureFile& picture : made.pictures) names.push_back(picture.name);
    for (const importers::BinaryFile& copy : made.copies) names.push_back(copy.name);
    for (const importers::TextFile& graph : made.graphs) names.push_back(graph.name);
    return names;
}

Exit import_file(const Console& console, const Arguments& arguments, const std::string& file) {
    const importers::Source source = source_of(file);
    const Importer* importer = importers::importer_of(source);
    if (!importer) {
        complain(console, Complaint::UnknownFormat, {file, formats()});
        return Exit::Wrong;
    }
    const Imported made = importer->read(source, {});
    if (!made.error.empty()) {
        complain(console, Complaint::CannotImport, {made.error});
        return Exit::Wrong;
    }
    const fs::path folder = arguments.folder.empty() ? fs::path(file).parent_path() : fs::path(arguments.folder);
    const std::vector<std::string> names = names_of(made);
    for (const std::string& name : names) {
        std::error_code ignored;
        const std::string path = (folder / name).string();
        if (!fs::exists(path, ignored)) continue;
        complain(console, Complaint::FileExists, {path});
        return Exit::Wrong;
    }
    Output output(folder);
    if (const std::string error = output.write(made); !error.empty()) {
        complain(console, Complaint::CannotWrite, {error});
        return Exit::Wrong;
    }
    report_remarks(console, arguments, file, made.remarks);
    for (const std::string& name : names) say(console, output.path_of(name));
    return Exit::Ok;
}

}  // namespace

void add_import(Program& program) {
    std::vector<std::string_view> examples;
    for (const Importer& importer : importers::importers()) examples.push_back(importer.example);
    examples.push_back("patina import *.binary -o measured && patina render measured/gold-paint.graph.json");
    CLI::App& command = add_command(program, "import", examples);
    auto arguments = std::make_shared<Arguments>();
    command.add_option("FILES", arguments->files, "Files to import: " + formats())->required()->type_name(" ");
    command.add_option("-o,--output", arguments->folder, "Folder to write to; default: the folder of each file")
        ->type_name("DIR");
    command.add_flag("--report", arguments->shows_remarks,
                     "Print what became of each part of the files: taken, changed or left out");
    set_work(program, command, [arguments](const Console& console) {
        Exit exit = Exit::Ok;
        for (std::size_t i = 0; i < arguments->files.size(); ++i) {
            show_progress(console, i, arguments->files.size(), arguments->files[i]);
            exit = worse(exit, import_file(console, *arguments, arguments->files[i]));
        }
        return exit;
    });
}

}  // namespace patina::cli
