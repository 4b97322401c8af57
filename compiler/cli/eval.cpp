// patina eval: what one node computes, by the CPU reference.
#include <fmt/format.h>

#include <memory>

#include "compiler/cli/commands.h"
#include "compiler/cli/json_numbers.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::string node;
    std::vector<std::string> values;
    bool single = false;
    bool json = false;
};

std::vector<std::pair<std::string, std::string>> split(const std::vector<std::string>& values) {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const std::string& value : values) {
        const std::size_t equals = value.find('=');
        pairs.emplace_back(value.substr(0, equals), value.substr(equals + 1));
    }
    return pairs;
}

std::string as_text(const EvalOutput& output) {
    std::string text;
    for (double value : output.values) text += (text.empty() ? "" : ", ") + fmt::format("{:.9g}", value);
    return text;
}

std::string as_json(const std::vector<EvalOutput>& outputs) {
    rapidjson::StringBuffer buffer;
    JsonWriter writer(buffer);
    writer.StartObject();
    for (const EvalOutput& output : outputs) {
        writer.Key(output.name.c_str());
        write_numbers(writer, output.values);
    }
    writer.EndObject();
    return std::string(buffer.GetString()) + "\n";
}

Exit evaluate(const Console& console, const Arguments& arguments) {
    const Compiler compiler;
    const EvalResult result = compiler.evaluate(arguments.node, split(arguments.values), arguments.single);
    report(console, result.diagnostics);
    if (!result.ok) return Exit::Wrong;
    if (arguments.json) {
        print(as_json(result.outputs));
    } else if (result.outputs.size() == 1) {
        print(as_text(result.outputs.front()) + "\n");
    } else {
        for (const EvalOutput& output : result.outputs) print(output.name + " = " + as_text(output) + "\n");
    }
    return Exit::Ok;
}

}  // namespace

void add_eval(Program& program) {
    CLI::App& command = add_command(
        program, "eval", "Compute one node on the CPU",
        {"patina eval Lerp from=0 to=10 t=0.25", "patina eval NdotL normal=0,0,1 light_dir=0,0.6,0.8",
         "patina eval DistributionGGX ndoth=0.9 alpha=0.25 --json", "patina eval wave.node.hlsl uv=0.5,0.5"});
    auto arguments = std::make_shared<Arguments>();
    command.add_option("NODE", arguments->node, "A node of the library, or the file of one (.node.hlsl)")
        ->required()
        ->type_name(" ");
    command
        .add_option("NAME=VALUE", arguments->values, "Inputs as a graph writes them: 0.5, 0,0,1, #ff8800, true, a word")
        ->type_name(" ")
        ->check([](const std::string& word) {
            return word.find('=') != word.npos && word.front() != '=' ? std::string()
                                                                      : "'" + word + "' is not of the form name=value";
        });
    command.add_flag("--float", arguments->single, "Compute in 32-bit float, as a GPU does; default: double");
    command.add_flag("--json", arguments->json, "Print every output by name with all digits");
    set_work(program, command, [arguments](const Console& console) { return evaluate(console, *arguments); });
}

}  // namespace patina::cli
