// patina import: what other programs made, as a graph and its textures.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/files.h"
#include "runtime/lighting/merl.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::vector<std::string> files;
    std::string folder;
};

std::string graph_of(const std::string& name) {
    return fmt::format(R"({{
  "patina": 1,
  "kind": "material",
  "name": "{0}",
  "workflow": "metallic-roughness",
  "lighting": {{ "use": "merl", "in": {{ "_Table": "./{0}.exr" }} }},
  "surface": {{}}
}}
)",
                       name);
}

// A name that is safe inside a JSON string.
bool is_plain(const std::string& name) {
    return std::none_of(name.begin(), name.end(),
                        [](char c) { return c == '"' || c == '\\' || static_cast<unsigned char>(c) < 0x20; });
}

Exit import_table(const Console& console, const Arguments& arguments, const std::string& file) {
    namespace fs = std::filesystem;
    const std::string name = fs::path(file).stem().string();
    if (!file.ends_with(".binary")) {
        complain(console, "unknown-format", fmt::format("cannot import '{}': only MERL tables (.binary) so far", file));
        return Exit::Wrong;
    }
    if (!is_plain(name)) {
        complain(console, "unknown-format", fmt::format("'{}' cannot be the name of a graph", name));
        return Exit::Wrong;
    }
    const runtime::Outcome<runtime::MerlTable> table = runtime::read_merl(file);
    if (!table) {
        complain(console, "cannot-import", table.error);
        return Exit::Wrong;
    }
    const fs::path folder = arguments.folder.empty() ? fs::path(file).parent_path() : fs::path(arguments.folder);
    const std::string picture = (folder / (name + ".exr")).string(), graph = (folder / (name + ".graph.json")).string();
    std::error_code failure;
    for (const std::string& path : {picture, graph}) {
        if (!fs::exists(path, failure)) continue;
        complain(console, "cannot-write", fmt::format("'{}' exists already; it may hold work of yours", path));
        return Exit::Wrong;
    }
    // The graph last: where it is, its table is.
    const bool is_new_folder = !folder.empty() && !fs::exists(folder, failure);
    if (!folder.empty()) fs::create_directories(folder, failure);
    std::string error = runtime::save_exr(picture, runtime::as_texture(table.value));
    if (error.empty()) {
        OutputFiles files;
        files.add(graph, graph_of(name));
        error = commit(files);
        if (!error.empty()) fs::remove(picture, failure);
    }
    if (!error.empty()) {
        if (is_new_folder) fs::remove(folder, failure);  // if there is nothing in it
        complain(console, "cannot-write", error);
        return Exit::Wrong;
    }
    print(picture + "\n" + graph + "\n");
    return Exit::Ok;
}

Exit import_files(const Console& console, const Arguments& arguments) {
    Exit exit = Exit::Ok;
    for (const std::string& file : arguments.files) exit = worse(exit, import_table(console, arguments, file));
    return exit;
}

}  // namespace

void add_import(Program& program) {
    CLI::App& command =
        add_command(program, "import", kImportSummary,
                    {"patina import gold-paint.binary          # gold-paint.exr and gold-paint.graph.json beside it",
                     "patina import *.binary -o measured && patina render measured/gold-paint.graph.json"});
    auto arguments = std::make_shared<Arguments>();
    command.add_option("FILES", arguments->files, "Measured BRDFs in the form of the MERL database (.binary)")
        ->required()
        ->type_name(" ");
    command.add_option("-o,--output", arguments->folder, "Folder to write to; default: beside each file")
        ->type_name("DIR");
    set_work(program, command, [arguments](const Console& console) { return import_files(console, *arguments); });
}

}  // namespace patina::cli
