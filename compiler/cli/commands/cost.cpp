// patina cost: what the shaders of graphs cost, by pass and by node.
#include "patina/cost.h"

#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/inputs.h"
#include "compiler/cli/pages/cost_page.h"

namespace patina::cli {
namespace {

struct Arguments {
    InputArguments inputs;
    std::vector<std::string> include_dirs;
    PathOptions path;
    std::string lighting;
    bool json = false;
};

// What is found out about a graph before anything is printed.
struct Measured {
    std::vector<Diagnostic> diagnostics{};
    MaterialCost cost{};
};

Measured measure(const Compiler& compiler, const Arguments& arguments, const std::string& graph) {
    CompileOptions options;
    options.targets = {Target::Glsl};
    options.include_dirs = arguments.include_dirs;
    options.path = arguments.path.path;
    options.switches = arguments.path.switches();
    options.lighting = arguments.lighting;
    options.accept_parts = true;
    Result result = compiler.compile_file(graph, options);
    Measured made{.diagnostics = std::move(result.diagnostics)};
    if (!result.ok) return made;
    made.cost = measure_cost(result);
    made.diagnostics.insert(made.diagnostics.end(), made.cost.diagnostics.begin(), made.cost.diagnostics.end());
    return made;
}

Exit measure_all(const Console& console, const Arguments& arguments) {
    const auto inputs = find_inputs(console, arguments.inputs, {".graph.json"});
    if (!inputs) return Exit::Wrong;
    const Compiler compiler;
    std::string between = arguments.json ? "[\n" : "";
    const Exit exit = work_on(
        console, *inputs, arguments.inputs.jobs,
        [&](const Input& input) { return measure(compiler, arguments, input.path); },
        [&](const Input& input, const Measured& made) {
            report(console, made.diagnostics);
            if (!made.cost.ok) return Exit::Wrong;
            print(between + (arguments.json ? to_json(made.cost, input.path) : cost_page(made.cost, input.path)));
            between = arguments.json ? ",\n" : "\n";
            return Exit::Ok;
        });
    if (arguments.json) print(between == "[\n" ? "[]\n" : "\n]\n");
    return exit;
}

}  // namespace

void add_cost(Program& program) {
    CLI::App& command =
        add_command(program, "cost",
                    {"patina cost rust.graph.json", "patina cost rust.graph.json --path deferred -D shadows",
                     "patina cost rust.graph.json --lighting unity-brdf3   # what would another model cost?",
                     "patina cost art --json > costs.json"});
    auto arguments = std::make_shared<Arguments>();
    add_input_options(command, arguments->inputs, "Graphs (JSON)");
    command
        .add_option("--lighting", arguments->lighting,
                    "A lighting model ('patina models' lists them) or a lighting graph, in place of the graph's own")
        ->type_name("MODEL");
    add_path_options(command, arguments->path);
    add_include_option(command, arguments->include_dirs);
    command.add_flag("--json", arguments->json, "Print everything as JSON");
    set_check(command, [arguments] { require_inputs(arguments->inputs); });
    set_work(program, command, [arguments](const Console& console) { return measure_all(console, *arguments); });
}

}  // namespace patina::cli
