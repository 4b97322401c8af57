#include "compiler/cli/cost/report.h"
#include "compiler/json/memory/json_memory.h"

namespace patina::cli {
namespace {

constexpr unsigned kVersion = 1;  // changes if a program that reads the text must change

void write(JsonPages& writer, const char* key, std::string_view text) {
    writer.Key(key);
    writer.String(text.data(), static_cast<rapidjson::SizeType>(text.size()));
}

void write(JsonPages& writer, const char* key, std::uint32_t count) {
    writer.Key(key);
    writer.Uint(count);
}

void write(JsonPages& writer, const char* key, const CostCounts& counts) {
    writer.Key(key);
    writer.StartObject();
    for (const CostFigure& figure : kCostFigures) write(writer, figure.name, counts.*figure.count);
    writer.EndObject();
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

void write(JsonPages& writer, const char* key, const MeasuredStage& stage) {
    writer.Key(key);
    writer.StartObject();
    write(writer, "once", stage.cost.once);
    write(writer, "perLight", stage.cost.per_light);
    write(writer, "varyings", stage.cost.varyings);
    write(writer, "registers", stage.cost.registers);
    writer.Key("shares");
    writer.StartArray();
    for (const CostShare& share : stage.shares) {
        writer.StartObject();
        write(writer, "part", word(share.part));
        if (share.part == CostShare::Part::Node) write(writer, "node", share.node);
        write(writer, "once", share.once);
        write(writer, "perLight", share.per_light);
        writer.EndObject();
    }
    writer.EndArray();
    writer.EndObject();
}

}  // namespace

std::string report_json(std::span<const CostReport> reports) {
    JsonBuffer buffer;
    JsonPages writer(buffer);
    writer.SetIndent(' ', 2);
    writer.StartObject();
    write(writer, "patinaCost", kVersion);
    writer.Key("graphs");
    writer.StartArray();
    for (const CostReport& report : reports) {
        writer.StartObject();
        write(writer, "graph", report.graph);
        writer.Key("passes");
        writer.StartArray();
        for (const MeasuredPass& pass : report.passes) {
            writer.StartObject();
            write(writer, "name", pass.name);
            write(writer, "vertex", pass.vertex);
            write(writer, "fragment", pass.fragment);
            write(writer, "uniformBytes", pass.cost.uniform_bytes);
            writer.EndObject();
        }
        writer.EndArray();
        writer.EndObject();
    }
    writer.EndArray();
    writer.EndObject();
    return std::string(buffer.GetString(), buffer.GetSize()) + "\n";
}

}  // namespace patina::cli
