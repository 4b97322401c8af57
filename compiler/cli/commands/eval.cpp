// patina eval: computes one node, one expression or one lighting model with the CPU interpreter.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/eval/sweep.h"
#include "compiler/json/json_writer.h"
#include "patina/name_value.h"
#include "runtime/lighting/model.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::vector<std::string> words;  // the node, unless there is a model; then NAME=VALUE
    std::string model, workflow = "metallic-roughness";
    bool single = false;
    bool json = false;
};

std::string as_text(const EvalOutput& output) {
    std::string text;
    for (double value : output.values) {
        if (std::isnan(value)) value = std::abs(value);  // its sign says nothing
        text += (text.empty() ? "" : ", ") + fmt::format("{:.9g}", value);
    }
    return text;
}

std::string as_json(const std::vector<EvalOutput>& outputs) {
    JsonWriter json;
    json.begin('{');
    for (const EvalOutput& output : outputs) json.write_numbers(output.name, output.values);
    json.end();
    return json.take() + "\n";
}

// --- one evaluation: its outputs, or nothing after a message

using Outputs = std::optional<std::vector<EvalOutput>>;

Outputs evaluate_node(const Console& console, const Arguments& arguments, const Compiler& compiler,
                      const std::string& node, const Values& values) {
    EvalResult result = compiler.evaluate(node, values, arguments.single);
    report(console, result.diagnostics);
    if (!result.ok) return {};
    return std::move(result.outputs);
}

// "0,0,1", or "#ff8800": linear, with a fourth number if the text has an opacity. Nothing if the text is neither.
std::optional<std::vector<double>> read_values(const Compiler& compiler, const std::string& text) {
    if (!text.starts_with('#')) return runtime::read_numbers(text);
    const std::pair<std::string, std::string> color{"value", text};
    EvalResult result = compiler.evaluate("Constant", {&color, 1}, false);
    if (!result.ok) return {};
    return std::move(result.outputs.front().values);
}

// The same, and "[[1,0],[0,1]]", which has the name as well.
std::optional<NamedValue> read_named(const Compiler& compiler, const std::string& name, const std::string& text) {
    if (text.starts_with("[[")) {
        EvalResult result = compiler.evaluate_expression(text, {});
        if (!result.ok) return {};
        return NamedValue{.name = name, .values = std::move(result.outputs.front().values), .is_matrix = true};
    }
    std::optional<std::vector<double>> numbers = read_values(compiler, text);
    if (!numbers || numbers->empty() || numbers->size() > 4) return {};
    return NamedValue{.name = name, .values = std::move(*numbers)};
}

// "= pow(x, 2.2)" over the values by their names.
Outputs evaluate_expression(const Console& console, const Arguments& arguments, const Compiler& compiler,
                            const std::string& expression, const Values& values) {
    std::vector<NamedValue> names;
    for (const auto& [name, text] : values) {
        std::optional<NamedValue> named = read_named(compiler, name, text);
        if (!named) {
            complain(console, Complaint::NotNumbers, {name, text});
            return {};
        }
        names.push_back(std::move(*named));
    }
    EvalResult result = compiler.evaluate_expression(expression, names, arguments.single);
    report(console, result.diagnostics);
    if (!result.ok) return {};
    return std::move(result.outputs);
}

// "0,0,1", "#ff8800", or one number for all three; nothing if the text is none of them.
std::optional<runtime::Triple> read_triple(const Compiler& compiler, const std::string& text) {
    const std::optional<std::vector<double>> numbers = read_values(compiler, text);
    if (!numbers || (numbers->size() != 1 && numbers->size() != 3)) return {};
    return runtime::Triple{numbers->front(), numbers->size() == 3 ? (*numbers)[1] : numbers->front(), numbers->back()};
}

Outputs evaluate_model(const Console& console, const Arguments& arguments, const Compiler& compiler,
                       const Values& values) {
    runtime::ModelChoice choice{.model = arguments.model, .workflow = arguments.workflow};
    runtime::ModelPoint point;
    runtime::ModelLight light;
    const std::map<std::string, runtime::Triple*> triples = runtime::named_inputs(point, light);
    std::set<std::string> given;
    for (const auto& [name, text] : values) {
        if (!given.insert(name).second) {
            complain(console, Complaint::GivenTwice, {name});
            return {};
        }
        const auto triple = triples.find(name);
        if (triple == triples.end()) {
            choice.values.emplace_back(name, text);
            continue;
        }
        const std::optional<runtime::Triple> numbers = read_triple(compiler, text);
        const bool is_direction = name.size() == 1;
        if (!numbers || (is_direction && *numbers == runtime::Triple{})) {
            complain(console, Complaint::NotThreeNumbers,
                     {name, text, is_direction ? ", at least one of them not 0" : ""});
            return {};
        }
        *triple->second = *numbers;
    }
    runtime::Model model(compiler, choice, arguments.single ? Precision::Float : Precision::Double);
    report(console, model.diagnostics());
    if (!model.ok()) return {};
    const runtime::Triple color = model.color(point, light);
    return std::vector<EvalOutput>{{.name = "out", .type = "float3", .values = {color.begin(), color.end()}}};
}

// --- the command

void print_outputs(const Arguments& arguments, const std::vector<EvalOutput>& outputs) {
    if (arguments.json) {
        print(as_json(outputs));
    } else if (outputs.size() == 1) {
        print(as_text(outputs.front()) + "\n");
    } else {
        for (const EvalOutput& output : outputs) print(output.name + " = " + as_text(output) + "\n");
    }
}

Exit evaluate(const Console& console, const Arguments& arguments) {
    const bool is_node = arguments.model.empty();
    std::string node;
    Values values;
    for (const std::string& word : arguments.words) {
        if (is_node && node.empty() && values.empty() && word.starts_with('=')) {
            node = word;
        } else if (const auto [name, value] = split_name_value(word); value && !name.empty()) {
            values.emplace_back(name, *value);
        } else if (is_node && node.empty() && values.empty()) {
            node = word;
        } else {
            complain(console, Complaint::NotNameAndValue, {word});
            return Exit::Usage;
        }
    }
    if (is_node && node.empty()) {
        complain(console, Complaint::NothingToEvaluate, {});
        return Exit::Usage;
    }
    std::string error;
    const std::vector<Axis> axes = axes_of(values, error);
    if (!error.empty()) {
        complain(console, Complaint::BadValue, {error});
        return Exit::Usage;
    }
    const Compiler compiler;
    const auto evaluate_at = [&](const Values& at) {
        if (!arguments.model.empty()) return evaluate_model(console, arguments, compiler, at);
        if (node.starts_with('=')) return evaluate_expression(console, arguments, compiler, node.substr(1), at);
        return evaluate_node(console, arguments, compiler, node, at);
    };
    std::vector<SweepRow> rows = rows_of(values, axes);
    for (SweepRow& row : rows) {
        Outputs outputs = evaluate_at(row.values);
        if (!outputs) return Exit::Wrong;
        row.outputs = std::move(*outputs);
    }
    if (axes.empty()) {
        print_outputs(arguments, rows.front().outputs);
    } else {
        print(arguments.json ? sweep_json(axes, rows) : sweep_csv(axes, rows));
    }
    return Exit::Ok;
}

}  // namespace

void add_eval(Program& program) {
    CLI::App& command = add_command(
        program, "eval",
        {"patina eval Lerp from=0 to=10 t=0.25", "patina eval NdotL normal=0,0,1 lightDir=0,0.6,0.8",
         "patina eval DistributionGGX ndoth=0.9 alpha=0.25 --json",
         "patina eval DistributionGGX ndoth=0..1:101 alpha=0.25 >ggx.csv", "patina eval wave.node.hlsl uv=0.5,0.5",
         "patina eval --model unity-brdf1 n=0,0,1 l=0,0.6,0.8 v=0,0,1 baseColor=1,0.8,0.2 metallic=1",
         "patina eval --model phong --workflow specular-glossiness l=1,0,1 v=-1,0,1 _Normalization=Classic",
         "patina eval --model upload/cel.lighting.json --root upload l=1,0,1", "patina eval '= pow(0.5, 2.2)'",
         "patina eval '= smoothstep(0, 1, x)' x=0..1:11", "patina eval '= mul(m, v)' 'm=[[1,2],[3,4]]' v=1,0"});
    auto arguments = std::make_shared<Arguments>();
    command
        .add_option("NODE NAME=VALUE", arguments->words,
                    "A node of the library or its file (.node.hlsl), and its inputs as a graph writes them: 0.5, "
                    "0,0,1, #ff8800, [[1,0],[0,1]], true, a word. Or an expression, '= x * 2', and the values of its "
                    "names. FROM..TO:COUNT makes a table")
        ->type_name(" ");
    CLI::Option* model = command.add_option(
        "--model", arguments->model,
        "Compute the light that reaches the viewer from one light of E/pi = 1, by a lighting model or its file. "
        "Inputs: n, l, v, t (normal, direction to the light, direction to the viewer, tangent); light, ambient (E/pi), "
        "environment (radiance); the inputs of the surface and of the model");
    command
        .add_option("--workflow", arguments->workflow,
                    "The workflow that describes the surface of --model; default: metallic-roughness")
        ->needs(model);
    command.add_flag("--float", arguments->single, "Compute in 32-bit float, as a GPU does; default: double");
    command.add_flag("--json", arguments->json, "Print every output with its name and all digits");
    add_root_option(command);
    set_work(program, command, [arguments](const Console& console) { return evaluate(console, *arguments); });
}

}  // namespace patina::cli
