// patina check: everything that compile does, and both other compilers, but nothing is written.
#include <memory>

#include "compiler/cli/commands.h"
#include "patina/validate.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::vector<std::string> graphs;
    std::vector<std::string> include_dirs;
};

bool check_graph(const Console& console, const Compiler& compiler, const Arguments& arguments,
                 const std::string& graph) {
    CompileOptions options;
    options.include_dirs = arguments.include_dirs;
    const Result result = compiler.compile_file(graph, options);
    report(console, result.diagnostics);
    bool ok = result.ok;
    for (const Shader& shader : result.shaders) {
        const Validated validated = validate(shader);
        report(console, validated.diagnostics);
        ok &= validated.ok;
    }
    return ok;
}

}  // namespace

void add_check(Program& program) {
    CLI::App& command = add_command(program, "check", "Look for mistakes in graphs; writes nothing",
                                    {"patina check rust.graph.json", "patina check art/*.graph.json --quiet",
                                     "patina check rust.graph.json --diagnostics=json"});
    auto arguments = std::make_shared<Arguments>();
    command.add_option("GRAPH", arguments->graphs, "Graphs (JSON)")->required()->type_name(" ");
    add_include_option(command, arguments->include_dirs);

    set_work(program, command, [arguments](const Console& console) {
        const Compiler compiler;
        Exit exit = Exit::Ok;
        for (std::size_t i = 0; i < arguments->graphs.size(); ++i) {
            const std::string& graph = arguments->graphs[i];
            show_progress(console, i, arguments->graphs.size(), graph);
            const bool ok = check_graph(console, compiler, *arguments, graph);
            if (ok) say(console, graph + ": ok");
            if (!ok) exit = Exit::Wrong;
        }
        return exit;
    });
}

}  // namespace patina::cli
