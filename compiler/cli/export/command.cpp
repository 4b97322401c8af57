// patina export: a graph as a document that other programs read.
#include <filesystem>
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/files.h"
#include "compiler/cli/outputs.h"
#include "patina/export_mtlx.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::string graph, output;
    std::vector<std::string> include_dirs;
    bool mtlx = false;
};

Exit write_mtlx(const Console& console, const Arguments& arguments) {
    const Compiler compiler;
    MtlxOptions options;
    options.include_dirs = arguments.include_dirs;
    if (!is_standard_output(arguments.output))
        options.folder = std::filesystem::path(arguments.output).parent_path().string();
    const MtlxExport made = export_mtlx(compiler, arguments.graph, options);
    report(console, made.diagnostics);
    if (!made.ok) return Exit::Wrong;
    OutputFiles files;
    files.add(arguments.output, made.text);
    if (!Outputs(console).write(arguments.graph, files, made.dependencies)) return Exit::Wrong;
    say(console, files);
    return Exit::Ok;
}

}  // namespace

void add_export(Program& program) {
    CLI::App& command = add_command(program, "export",
                                    {"patina export rust.graph.json --mtlx -o rust.mtlx",
                                     "patina export rust.graph.json --mtlx -o -    # prints it"});
    auto arguments = std::make_shared<Arguments>();
    command.add_option("GRAPH", arguments->graph, "Material graph (JSON)")->required()->type_name(" ");
    command.add_flag("--mtlx", arguments->mtlx, "Write a MaterialX document")->required();
    command.add_option("-o,--output", arguments->output, "File to write; - prints it")->required()->type_name("FILE");
    add_include_option(command, arguments->include_dirs);
    set_work(program, command, [arguments](const Console& console) { return write_mtlx(console, *arguments); });
}

}  // namespace patina::cli
