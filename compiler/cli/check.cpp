// patina check: everything that compile does, and both other compilers, but nothing is written. A node file is read,
// and its test lines are run; a scene is read, and its materials are checked.
#include <algorithm>
#include <map>
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

// Compiles a graph and has its shaders proved. The result is not ok if either fails.
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

// Whether the graph has every property that the scene gives a value to.
bool check_set(const Console& console, const SceneMaterial& material, const Reflection& reflection) {
    std::vector<std::string> names;
    for (const Property& property : reflection.properties) names.push_back(property.name);
    for (const Texture& texture : reflection.textures) {
        if (!texture.tiling.empty()) names.push_back(texture.name + "_ST");
    }
    bool ok = true;
    for (const SceneValue& value : material.set) {
        if (std::ranges::find(names, value.property) != names.end()) continue;
        ok = false;
        Diagnostic unknown = diagnostic_at(value.property_place, "unknown-property",
                                           "'" + material.graph.path + "' has no property '" + value.property + "'");
        if (std::string advice = suggestion(value.property, names); !advice.empty()) {
            Diagnostic& note = unknown.notes.emplace_back();
            note.severity = Severity::Note;
            note.message = std::move(advice);
        }
        report(console, std::span(&unknown, 1));
    }
    return ok;
}

bool check_scene(const Console& console, const Compiler& compiler, const Arguments& arguments,
                 const std::string& scene) {
    const CompileOptions options = options_of(arguments);
    const SceneResult read = compiler.read_scene(scene, options);
    report(console, read.diagnostics);
    bool ok = read.ok;
    std::map<std::string, Result> checked;  // several materials may be of one graph
    for (const SceneMaterial& material : read.scene.materials) {
        if (material.graph.path.empty()) continue;
        auto found = checked.find(material.graph.path);
        if (found == checked.end()) {
            Result result = check_shaders(console, compiler, material.graph.path, options);
            found = checked.emplace(material.graph.path, std::move(result)).first;
        }
        ok &= found->second.ok && check_set(console, material, found->second.reflection);
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
    command.add_option("GRAPH", arguments->graphs, "Graphs and scenes (JSON), and files of nodes (.node.hlsl)")
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
            const auto check = graph.ends_with(".hlsl")         ? check_node_file
                               : graph.ends_with(".scene.json") ? check_scene
                                                                : check_graph;
            const bool ok = check(console, compiler, *arguments, graph);
            if (ok) say(console, graph + ": ok");
            if (!ok) exit = Exit::Wrong;
        }
        return exit;
    });
}

}  // namespace patina::cli
