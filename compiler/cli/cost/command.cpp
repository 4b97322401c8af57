// patina cost: measures the shaders of graphs, pass by pass, and the share of each node.
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/cost/foreign.h"
#include "compiler/cli/cost/report.h"
#include "compiler/cli/inputs.h"

namespace patina::cli {
namespace {

struct Arguments {
    InputArguments inputs;
    std::vector<std::string> include_dirs;
    PathOptions path;
    bool json = false;
};

struct Measured {
    CostReport report{};
    std::vector<Diagnostic> diagnostics{};
    bool ok = false;
};

Measured measure_graph(const Compiler& compiler, const Arguments& arguments, const std::string& graph) {
    CompileOptions options;
    options.targets = {Target::Glsl};
    options.include_dirs = arguments.include_dirs;
    options.request = CompileOptions::Passes{.path = arguments.path.path};
    options.switches = arguments.path.switches();
    Result result = compile_if_foreign(compiler, graph, options);
    name_graph(result.diagnostics, graph);
    Measured made{.report = {.graph = graph}, .diagnostics = result.diagnostics, .ok = result.ok};
    if (!result.ok) return made;
    made.report.passes = measure(result);
    const std::vector<Diagnostic> refused = refusals(result, made.report.passes);
    made.ok = refused.empty();
    made.diagnostics.insert(made.diagnostics.end(), refused.begin(), refused.end());
    return made;
}

}  // namespace

void add_cost(Program& program) {
    CLI::App& command = add_command(
        program, "cost",
        {"patina cost rust.graph.json", "patina cost art --path all", "patina cost rust.graph.json --json > cost.json",
         "patina check rust.graph.json --max-instructions 400   # fails if it costs more"});
    auto arguments = std::make_shared<Arguments>();
    add_input_options(command, arguments->inputs, "Material graphs (JSON)");
    command.add_flag("--json", arguments->json, "Print it as JSON");
    add_path_options(command, arguments->path);
    add_include_option(command, arguments->include_dirs);
    set_check(command, [arguments] { require_inputs(arguments->inputs); });

    set_work(program, command, [arguments](const Console& console) {
        if (is_mixed(console, arguments->json, "--json")) return Exit::Usage;
        const Inputs inputs = find_inputs(console, arguments->inputs, {".graph.json"});
        const Compiler compiler;
        std::vector<CostReport> reports;
        bool is_first = true;
        const Exit exit = work_on(
            console, inputs.files, arguments->inputs.jobs,
            [&](const Input& input) { return measure_graph(compiler, *arguments, input.path); },
            [&](const Input&, Measured& made) {
                report(console, made.diagnostics);
                if (!made.ok) return Exit::Wrong;
                if (arguments->json) {
                    reports.push_back(std::move(made.report));
                    return Exit::Ok;
                }
                print((is_first ? "" : "\n") + report_text(made.report, console));
                is_first = false;
                return Exit::Ok;
            });
        if (arguments->json) print(report_json(reports));
        return worse(inputs.exit, exit);
    });
}

}  // namespace patina::cli
