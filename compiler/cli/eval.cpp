// patina eval: what one node computes, by the CPU reference.
#include <fmt/format.h>

#include <memory>

#include "compiler/cli/commands.h"
#include "compiler/cli/json_numbers.h"
#include "compiler/cli/sweep.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::string node;
    std::vector<std::string> values;
    bool single = false;
    bool json = false;
};

Values split(const std::vector<std::string>& values) {
    Values pairs;
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

void write_outputs(JsonWriter& writer, const std::vector<EvalOutput>& outputs) {
    for (const EvalOutput& output : outputs) {
        writer.Key(output.name.c_str());
        write_numbers(writer, output.values);
    }
}

std::string as_json(const std::vector<EvalOutput>& outputs) {
    rapidjson::StringBuffer buffer;
    JsonWriter writer(buffer);
    writer.StartObject();
    write_outputs(writer, outputs);
    writer.EndObject();
    return std::string(buffer.GetString()) + "\n";
}

// --- sweeps: a row for each combination

struct SweepRow {
    std::vector<double> at;  // by axis
    std::vector<EvalOutput> outputs;
};

// The outputs of vectors are columns of their own: "out.x", "out.y".
std::string as_csv(const std::vector<std::string>& names, const std::vector<SweepRow>& rows) {
    std::string text = fmt::format("{}", fmt::join(names, ","));
    for (const EvalOutput& output : rows.front().outputs) {
        const std::size_t count = output.values.size();
        for (std::size_t i = 0; i < count; ++i) {
            text += "," + output.name;
            if (count > 1) text += count <= 4 ? fmt::format(".{}", "xyzw"[i]) : fmt::format(".{}", i);
        }
    }
    text += "\n";
    for (const SweepRow& row : rows) {
        text += fmt::format("{}", fmt::join(row.at, ","));
        for (const EvalOutput& output : row.outputs) text += fmt::format(",{}", fmt::join(output.values, ","));
        text += "\n";
    }
    return text;
}

std::string as_json(const std::vector<std::string>& names, const std::vector<SweepRow>& rows) {
    rapidjson::StringBuffer buffer;
    JsonWriter writer(buffer);
    writer.StartArray();
    for (const SweepRow& row : rows) {
        writer.StartObject();
        for (std::size_t i = 0; i < names.size(); ++i) {
            writer.Key(names[i].c_str());
            write_number(writer, row.at[i]);
        }
        write_outputs(writer, row.outputs);
        writer.EndObject();
    }
    writer.EndArray();
    return std::string(buffer.GetString()) + "\n";
}

Exit sweep(const Console& console, const Arguments& arguments, const Compiler& compiler, const Values& values,
           const std::vector<Axis>& axes) {
    std::vector<std::string> names;
    for (const Axis& axis : axes) names.push_back(values[axis.index].first);
    std::vector<SweepRow> rows;
    for (const Values& point : combinations(values, axes)) {
        EvalResult result = compiler.evaluate(arguments.node, point, arguments.single);
        if (!result.ok || rows.empty()) report(console, result.diagnostics);
        if (!result.ok) return Exit::Wrong;
        SweepRow& row = rows.emplace_back(SweepRow{.at = {}, .outputs = std::move(result.outputs)});
        for (const Axis& axis : axes) row.at.push_back(std::stod(point[axis.index].second));
    }
    print(arguments.json ? as_json(names, rows) : as_csv(names, rows));
    return Exit::Ok;
}

Exit evaluate(const Console& console, const Arguments& arguments) {
    const Compiler compiler;
    const Values values = split(arguments.values);
    if (const std::vector<Axis> axes = axes_of(values); !axes.empty()) {
        return sweep(console, arguments, compiler, values, axes);
    }
    const EvalResult result = compiler.evaluate(arguments.node, values, arguments.single);
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

// Empty, or what is wrong with "name=value".
std::string check_value(const std::string& word) {
    const std::size_t equals = word.find('=');
    if (equals == word.npos || equals == 0) return "'" + word + "' is not of the form name=value";
    std::string error;
    numbers_of(std::string_view(word).substr(equals + 1), error);
    return error;
}

void complete(const Arguments& arguments) {
    double steps = 1;
    for (const Axis& axis : axes_of(split(arguments.values))) steps *= static_cast<double>(axis.numbers.size());
    if (steps > kMostSteps) {
        throw CLI::ValidationError("NAME=VALUE",
                                   fmt::format("the ranges have {:.0f} combinations, more than the {} that "
                                               "one table may have",
                                               steps, kMostSteps));
    }
}

}  // namespace

void add_eval(Program& program) {
    CLI::App& command = add_command(
        program, "eval", "Compute one node on the CPU",
        {"patina eval Lerp from=0 to=10 t=0.25", "patina eval DistributionGGX ndoth=0..1:101 alpha=0.25 >ggx.csv",
         "patina eval NdotL normal=0,0,1 light_dir=0,0.6,0.8",
         "patina eval DistributionGGX ndoth=0.9 alpha=0.25 --json", "patina eval wave.node.hlsl uv=0.5,0.5"});
    auto arguments = std::make_shared<Arguments>();
    command.add_option("NODE", arguments->node, "A node of the library, or the file of one (.node.hlsl)")
        ->required()
        ->type_name(" ");
    command
        .add_option("NAME=VALUE", arguments->values,
                    "Inputs as a graph writes them: 0.5, 0,0,1, #ff8800, true, a word; FROM..TO:COUNT makes a table")
        ->type_name(" ")
        ->check(check_value);
    command.add_flag("--float", arguments->single, "Compute in 32-bit float, as a GPU does; default: double");
    command.add_flag("--json", arguments->json, "Print every output by name with all digits");
    command.parse_complete_callback([arguments] { complete(*arguments); });
    set_work(program, command, [arguments](const Console& console) { return evaluate(console, *arguments); });
}

}  // namespace patina::cli
