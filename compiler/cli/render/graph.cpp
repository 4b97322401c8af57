// patina graph: a graph's nodes and links as a drawing.
#include <fmt/format.h>

#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/outputs.h"
#include "patina/output_name.h"
#include "runtime/page/drawing.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::string graph, output;
    CompileOptions options;
};

Exit draw_graph(const Console& console, const Arguments& arguments) {
    if (is_mixed(console, is_standard_output(arguments.output), "-o " + arguments.output)) return Exit::Usage;
    const Compiler compiler;
    const GraphView view = view_graph(compiler, arguments.graph, arguments.options);
    report(console, view.diagnostics);
    if (!view.ok) return Exit::Wrong;
    const std::string path = arguments.output.empty() ? output_name(arguments.graph) + ".svg" : arguments.output;
    std::string text;
    if (path.ends_with(".dot")) {
        text = runtime::dot_of(view);
    } else {
        runtime::Drawing drawing = runtime::draw(view);
        if (!drawing.error.empty()) {
            complain(console, Complaint::CannotRender,
                     {fmt::format("cannot draw '{}': {}; a .dot file is for another program", arguments.graph,
                                  drawing.error)});
            return Exit::Wrong;
        }
        text = std::move(drawing.svg);
    }
    OutputFiles files;
    files.add(path, std::move(text));
    Outputs outputs(console);
    if (!outputs.write(arguments.graph, files, view.dependencies)) return Exit::Wrong;
    say(console, files);
    return Exit::Ok;
}

}  // namespace

void add_graph(Program& program) {
    CLI::App& command =
        add_command(program, "graph",
                    {"patina graph rust.graph.json -o rust.svg", "patina graph toon.lighting.json -o toon.svg",
                     "patina graph rust.graph.json -o rust.dot"});
    auto arguments = std::make_shared<Arguments>();
    command.add_option("GRAPH", arguments->graph, "A material graph, a sub-graph, a lighting graph or a workflow")
        ->required()
        ->type_name(" ");
    command
        .add_option("-o,--output", arguments->output,
                    "An .svg file, a .dot file for Graphviz, or - for SVG on standard output; default: NAME.svg")
        ->type_name("OUT");
    add_include_option(command, arguments->options.include_dirs);
    set_check(command, [arguments] {
        const std::string& output = arguments->output;
        if (!output.empty() && !is_standard_output(output) && !is_stream(output) && !output.ends_with(".svg") &&
            !output.ends_with(".dot"))
            throw CLI::ValidationError("--output", "'" + output + "' is not an .svg file or a .dot file");
    });
    set_work(program, command, [arguments](const Console& console) { return draw_graph(console, *arguments); });
}

}  // namespace patina::cli
