// patina check: everything that compile does, and both other compilers, but nothing is written. A node file is read,
// and its test lines are run.
#include <memory>

#include "compiler/base/text.h"
#include "compiler/cli/commands.h"
#include "patina/validate.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::vector<std::string> graphs;
    std::vector<std::string> include_dirs;
    PathOptions path;
};

bool check_graph(const Console& console, const Compiler& compiler, const Arguments& arguments,
                 const std::string& graph) {
    CompileOptions options;
    options.include_dirs = arguments.include_dirs;
    options.accept_parts = true;
    options.path = arguments.path.path;
    options.switches = arguments.path.switches();
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

std::string written(const std::vector<double>& values) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : ", ") + shortest(value);
    return values.size() == 1 ? text : "(" + text + ")";
}

bool check_node_file(const Console& console, const Compiler& compiler, const Arguments& arguments,
                     const std::string& file) {
    CompileOptions options;
    options.include_dirs = arguments.include_dirs;
    const NodeFileResult result = compiler.check_node_file(file, options);
    report(console, result.diagnostics);
    bool ok = result.ok;
    for (const NodeTest& test : result.tests) {
        if (passed(test)) continue;
        ok = false;
        Diagnostic failure;
        failure.code = "failed-test";
        failure.message = test.text + ": it is " + written(test.actual);
        failure.file = test.file;
        failure.line = test.line;
        failure.column = 1;
        failure.node = test.node;
        report(console, std::span(&failure, 1));
    }
    return ok;
}

}  // namespace

void add_check(Program& program) {
    CLI::App& command = add_command(program, "check", "Look for mistakes in graphs; writes nothing",
                                    {"patina check rust.graph.json", "patina check art/*.graph.json --quiet",
                                     "patina check rust.graph.json --diagnostics=json", "patina check wave.node.hlsl"});
    auto arguments = std::make_shared<Arguments>();
    command.add_option("GRAPH", arguments->graphs, "Graphs (JSON), and files of nodes (.node.hlsl)")
        ->required()
        ->type_name(" ");
    add_path_options(command, arguments->path);
    add_include_option(command, arguments->include_dirs);

    set_work(program, command, [arguments](const Console& console) {
        const Compiler compiler;
        Exit exit = Exit::Ok;
        for (std::size_t i = 0; i < arguments->graphs.size(); ++i) {
            const std::string& graph = arguments->graphs[i];
            show_progress(console, i, arguments->graphs.size(), graph);
            const bool ok = graph.ends_with(".hlsl") ? check_node_file(console, compiler, *arguments, graph)
                                                     : check_graph(console, compiler, *arguments, graph);
            if (ok) say(console, graph + ": ok");
            if (!ok) exit = Exit::Wrong;
        }
        return exit;
    });
}

}  // namespace patina::cli
