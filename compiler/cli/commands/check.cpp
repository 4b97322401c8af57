// patina check: compiles a graph and has glslang and spirv-val check the shaders, but writes nothing. A node file is
// read and its test lines are run. A pass file is read and compiled for a small material. A scene is read, and
// everything in it is checked, but nothing is drawn.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/cost/foreign.h"
#include "compiler/cli/files.h"
#include "compiler/cli/inputs.h"
#include "patina/cost.h"
#include "patina/validate.h"

namespace patina::cli {
namespace {

constexpr const char* kAnyMaterial = "material.graph.json";

struct Arguments {
    InputArguments inputs;
    std::vector<std::string> include_dirs;
    PathOptions path;
    bool without_validation = false;
    std::optional<std::uint32_t> max_instructions, max_textures;
};

// What is found out about a file before anything is printed.
struct Checked {
    std::vector<Diagnostic> diagnostics{};
    bool ok = false;
};

void validate_shaders(const Arguments& arguments, const Result& result, Checked& checked) {
    if (arguments.without_validation) return;
    for (const Shader& shader : result.shaders) {
        const Validated validated = validate(shader);
        checked.diagnostics.insert(checked.diagnostics.end(), validated.diagnostics.begin(),
                                   validated.diagnostics.end());
        checked.ok &= validated.ok;
    }
}

Budget budget_of(const Arguments& arguments) {
    Budget budget;
    if (arguments.max_instructions) budget.instructions = {.most = *arguments.max_instructions};
    if (arguments.max_textures) budget.textures = {.most = *arguments.max_textures};
    return budget;
}

// The limits of the graph, and those of the command line.
void check_budgets(const Arguments& arguments, const std::string& graph, const Result& result, Checked& checked) {
    const Budget asked = budget_of(arguments);
    if (!checked.ok || !(result.budget.has_limits() || asked.has_limits())) return;
    const std::vector<MeasuredPass> passes = measure(result);
    std::vector<Diagnostic> found = refusals(result, passes);
    std::ranges::move(over_budget(passes, result.budget), std::back_inserter(found));
    for (Diagnostic& each : over_budget(passes, asked)) {
        each.file = graph;
        each.message += ", from the command line";
        found.push_back(std::move(each));
    }
    checked.ok &= found.empty();
    checked.diagnostics.insert(checked.diagnostics.end(), found.begin(), found.end());
}

// The same for a material of a scene; it reports what is over.
bool is_in_budget(const Console& console, const Arguments& arguments, const std::string& graph, const Result& result) {
    Checked checked{.ok = result.ok};
    check_budgets(arguments, graph, result, checked);
    report(console, checked.diagnostics);
    return checked.ok;
}

CompileOptions options_of(const Arguments& arguments) {
    CompileOptions options;
    options.include_dirs = arguments.include_dirs;
    options.request = CompileOptions::Passes{.path = arguments.path.path};
    options.switches = arguments.path.switches();
    return options;
}

// The error for a sub-graph or a lighting graph, which compiles only as a part of a material.
Checked part_without_budget(Result result) {
    Diagnostic note;
    note.severity = Severity::Note;
    note.message =
        "a budget is for materials: check this file without --max-instructions and --max-textures, or check a material "
        "that uses it";
    result.diagnostics.front().notes.push_back(std::move(note));
    return {.diagnostics = std::move(result.diagnostics), .ok = false};
}

// Compiles a graph and validates its shaders. A part of a material in a folder or a list has no budget, because its
// cost depends on the material that uses it.
Checked check_graph(const Compiler& compiler, const Arguments& arguments, const Input& input) {
    CompileOptions options = options_of(arguments);
    Result result = compile_if_foreign(compiler, input.path, options);
    const bool is_material = result.ok;
    if (!is_material) {
        options.accept_parts = true;
        Result part = compile_if_foreign(compiler, input.path, std::move(options));
        if (part.ok && input.from == Input::From::CommandLine && budget_of(arguments).has_limits())
            return part_without_budget(std::move(result));
        result = std::move(part);
    }
    Checked checked{.diagnostics = result.diagnostics, .ok = result.ok};
    validate_shaders(arguments, result, checked);
    if (is_material) check_budgets(arguments, input.path, result, checked);
    return checked;
}

// A pass file by itself, compiled for the smallest material. Messages about that material are left out.
Checked check_pass_file(const Compiler& compiler, const Arguments& arguments, const std::string& file) {
    CompileOptions options = options_of(arguments);
    options.request = CompileOptions::Passes{.path = file};
    const Result result =
        compiler.compile_text(kAnyMaterial, R"({ "patina": 1, "workflow": "metallic-roughness" })", options);
    Checked checked{.ok = true};
    for (const Diagnostic& diagnostic : result.diagnostics) {
        if (diagnostic.file == kAnyMaterial) continue;
        checked.diagnostics.push_back(diagnostic);
        checked.ok &= diagnostic.severity != Severity::Error;
    }
    validate_shaders(arguments, result, checked);
    return checked;
}

std::string as_text(const std::vector<double>& values) {
    const std::string text = fmt::format("{}", fmt::join(values, ", "));
    return values.size() == 1 ? text : "(" + text + ")";
}

Checked check_node_file(const Compiler& compiler, const Arguments& arguments, const std::string& file) {
    CompileOptions options;
    options.include_dirs = arguments.include_dirs;
    const NodeFileResult result = compiler.check_node_file(file, options);
    Checked checked{.diagnostics = result.diagnostics, .ok = result.ok};
    for (const NodeTest& test : result.tests) {
        if (passed(test)) continue;
        checked.ok = false;
        Diagnostic failure = complaint(Complaint::FailedTest, {test.text, as_text(test.actual)});
        failure.file = test.file;
        failure.line = test.line;
        failure.column = 1;
        failure.node = test.node;
        checked.diagnostics.push_back(std::move(failure));
    }
    return checked;
}

Checked check_file(const Compiler& compiler, const Arguments& arguments, const Input& input) {
    if (input.path.ends_with(".pass.hlsl")) return check_pass_file(compiler, arguments, input.path);
    if (input.path.ends_with(".hlsl")) return check_node_file(compiler, arguments, input.path);
    return check_graph(compiler, arguments, input);
}

}  // namespace

void add_check(Program& program) {
    CLI::App& command = add_command(
        program, "check",
        {"patina check rust.graph.json", "patina check art/*.graph.json --quiet",
         "patina check rust.graph.json --diagnostics=json", "patina check wave.node.hlsl",
         "patina check mine.pass.hlsl", "patina check upload/rust.graph.json --root upload",
         "patina check art --jobs 4 --no-validate", "patina check art --max-instructions 600 --max-textures 8"});
    add_pixels_option(program, command);
    const CLI::Range is_count(std::uint32_t{0}, std::numeric_limits<std::uint32_t>::max());
    auto arguments = std::make_shared<Arguments>();
    add_input_options(command, arguments->inputs,
                      "Graphs and scenes (JSON), and files of nodes (.node.hlsl) and of passes (.pass.hlsl)");
    command.add_flag("--no-validate", arguments->without_validation,
                     "Do not check the shaders with glslang and spirv-val, which takes most of the time");
    command
        .add_option(
            "--max-instructions", arguments->max_instructions,
            "Fail if a stage of any pass has more SPIR-V instructions than N with one light; 'patina cost' shows them")
        ->type_name("N")
        ->check(is_count);
    command
        .add_option("--max-textures", arguments->max_textures,
                    "Fail if a stage of any pass reads textures more than N times with one light")
        ->type_name("N")
        ->check(is_count);
    add_path_options(command, arguments->path);
    add_include_option(command, arguments->include_dirs);

    set_check(command, [arguments] { require_inputs(arguments->inputs); });

    set_work(program, command, [arguments, check_scene = program.check_scene](const Console& console) {
        const Inputs inputs =
            find_inputs(console, arguments->inputs,
                        {".graph.json", ".scene.json", ".subgraph.json", ".lighting.json", ".node.hlsl", ".pass.hlsl"});
        const Compiler compiler;
        const Exit exit = work_on(
            console, inputs.files, arguments->inputs.jobs,
            [&](const Input& input) {
                return is_scene(input.path) ? Checked{} : check_file(compiler, *arguments, input);
            },
            [&](const Input& input, Checked& checked) {
                name_graph(checked.diagnostics, input.path);
                report(console, checked.diagnostics);
                if (is_scene(input.path))  // which prints what it finds
                    checked.ok = check_scene(console, compiler, input.path, options_of(*arguments),
                                             [&](const std::string& graph, const Result& result) {
                                                 return is_in_budget(console, *arguments, graph, result);
                                             });
                if (checked.ok) say(console, input.path + ": ok");
                return checked.ok ? Exit::Ok : Exit::Wrong;
            });
        return worse(inputs.exit, exit);
    });
}

}  // namespace patina::cli
