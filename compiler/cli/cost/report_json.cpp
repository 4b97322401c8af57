#include "compiler/cli/cost/report.h"
#include "compiler/json/json_writer.h"

namespace patina::cli {
namespace {

constexpr unsigned kVersion = 1;  // changes if a program that reads the text must change

void write(JsonWriter& json, std::string_view key, const CostCounts& counts) {
    json.begin(key, '{');
    for (const CostFigure& figure : kCostFigures) json.write(figure.name, counts.*figure.count);
    json.end();
}

std::string_view word(CostShare::Part part) {
    switch (part) {
        case CostShare::Part::Node: return "node";
        case CostShare::Part::Surface: return "surface";
        case CostShare::Part::Lighting: return "lighting";
        case CostShare::Part::Pass: return "pass";
    }
    return {};
}

void write(JsonWriter& json, std::string_view key, const MeasuredStage& stage) {
    json.begin(key, '{');
    write(json, "once", stage.cost.once);
    write(json, "perLight", stage.cost.per_light);
    json.write("varyings", stage.cost.varyings);
    json.write("registers", stage.cost.registers);
    json.begin("shares", '[');
    for (const CostShare& share : stage.shares) {
        json.begin('{');
        json.write("part", word(share.part));
        if (share.part == CostShare::Part::Node) json.write("node", share.node);
        write(json, "once", share.once);
        write(json, "perLight", share.per_light);
        json.end();
    }
    json.end();
    json.end();
}

}  // namespace

std::string report_json(std::span<const CostReport> reports) {
    JsonWriter json(JsonWriter::Layout::Pages);
    json.begin('{');
    json.write("patinaCost", kVersion);
    json.begin("graphs", '[');
    for (const CostReport& report : reports) {
        json.begin('{');
        json.write("graph", report.graph);
        json.begin("passes", '[');
        for (const MeasuredPass& pass : report.passes) {
            json.begin('{');
            json.write("name", pass.name);
            write(json, "vertex", pass.vertex);
            write(json, "fragment", pass.fragment);
            json.write("uniformBytes", pass.cost.uniform_bytes);
            json.end();
        }
        json.end();
        json.end();
    }
    json.end();
    json.end();
    return json.take() + "\n";
}

}  // namespace patina::cli
