// patina check: compiles a graph and has glslang and spirv-val check the shaders, but writes nothing. A node file is
// read and its test lines are run. A pass file is read and compiled for a small material. A scene is read, and
// everything in it is checked, but nothing is drawn.
#include <fmt/format.h>

#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/files.h"
#include "patina/validate.h"

namespace patina::cli {
namespace {

constexpr const char* kAnyMaterial = "material.graph.json";

struct Arguments {
    std::vector<std::string> graphs;
    std::vector<std::string> include_dirs;
    PathOptions path;
};

// Compiles a graph and validates its shaders. The result is not ok if either fails.
Result check_shaders(const Console& console, const Compiler& compiler, const std::string& graph,
                     const CompileOptions& options) {
    Result result = compiler.compile_file(graph, options);
    report(console, result.diagnostics);
    for (const Shader& shader : result.shaders) {
        const Validated validated = validate(shader);
        report(console, validated.diagnostics);
        result.ok &= validated.ok;
    }
    return result;
}

CompileOptions options_of(const Arguments& arguments) {
    CompileOptions options;
    options.include_dirs = arguments.include_dirs;
    options.path = arguments.path.path;
    options.switches = arguments.path.switches();
    return options;
}

bool check_graph(const Console& console, const Compiler& compiler, const Arguments& arguments,
                 const std::string& graph) {
    CompileOptions options = options_of(arguments);
    options.accept_parts = true;
    return check_shaders(console, compiler, graph, options).ok;
}

// A pass file by itself, compiled for the smallest material. Messages about that material are left out.
bool check_pass_file(const Console& console, const Compiler& compiler, const Arguments& arguments,
                     const std::string& file) {
    CompileOptions options = options_of(arguments);
    options.path = file;
    const Result result =
        compiler.compile_text(kAnyMaterial, R"({ "patina": 1, "workflow": "metallic-roughness" })", options);
    bool ok = true;
    for (const Diagnostic& diagnostic : result.diagnostics) {
        if (diagnostic.file == kAnyMaterial) continue;
        report(console, std::span(&diagnostic, 1));
        ok &= diagnostic.severity != Severity::Error;
    }
    for (const Shader& shader : result.shaders) {
        const Validated validated = validate(shader);
        report(console, validated.diagnostics);
        ok &= validated.ok;
    }
    return ok;
}

std::string as_text(const std::vector<double>& values) {
    const std::string text = fmt::format("{}", fmt::join(values, ", "));
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
        Diagnostic failure = complaint(Complaint::FailedTest, {test.text, as_text(test.actual)});
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
    CLI::App& command = add_command(program, "check",
                                    {"patina check rust.graph.json", "patina check art/*.graph.json --quiet",
                                     "patina check rust.graph.json --diagnostics=json", "patina check wave.node.hlsl",
                                     "patina check mine.pass.hlsl"});
    auto arguments = std::make_shared<Arguments>();
    command
        .add_option("GRAPH", arguments->graphs,
                    "Graphs and scenes (JSON), and files of nodes (.node.hlsl) and of passes (.pass.hlsl)")
        ->required()
        ->type_name(" ");
    add_path_options(command, arguments->path);
    add_include_option(command, arguments->include_dirs);

    set_work(program, command, [arguments, check_scene = program.check_scene](const Console& console) {
        const Compiler compiler;
        Exit exit = Exit::Ok;
        for (std::size_t i = 0; i < arguments->graphs.size(); ++i) {
            const std::string& graph = arguments->graphs[i];
            show_progress(console, i, arguments->graphs.size(), graph);
            const auto check = graph.ends_with(".pass.hlsl") ? check_pass_file
                               : graph.ends_with(".hlsl")    ? check_node_file
                                                             : check_graph;
            const bool ok = is_scene(graph) ? check_scene(console, compiler, graph, options_of(*arguments))
                                            : check(console, compiler, *arguments, graph);
            if (ok) say(console, graph + ": ok");
            if (!ok) exit = Exit::Wrong;
        }
        return exit;
    });
}

}  // namespace patina::cli
