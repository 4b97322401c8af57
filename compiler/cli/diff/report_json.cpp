#include "compiler/cli/diff/report.h"
#include "compiler/json/memory/json_memory.h"

namespace patina::cli {
namespace {

std::string_view word(GraphChangeKind kind) {
    switch (kind) {
        case GraphChangeKind::Added: return "added";
        case GraphChangeKind::Removed: return "removed";
        case GraphChangeKind::Changed: return "changed";
        case GraphChangeKind::Renamed: return "renamed";
        case GraphChangeKind::Reordered: return "reordered";
    }
    return {};
}

void write(JsonPages& writer, const char* key, std::string_view text) {
    writer.Key(key);
    writer.String(text.data(), static_cast<rapidjson::SizeType>(text.size()));
}

void write_count(JsonPages& writer, const char* key, std::size_t count) {
    writer.Key(key);
    writer.Uint64(count);
}

// A value as the graph has it.
void write_value(JsonPages& writer, const char* key, const std::string& json) {
    if (json.empty()) return;
    writer.Key(key);
    writer.RawValue(json.data(), json.size(), rapidjson::kObjectType);
}

void write_place(JsonPages& writer, const char* key, const FilePlace& place) {
    if (place.line == 0) return;
    writer.Key(key);
    writer.StartObject();
    writer.Key("line");
    writer.Int(place.line);
    writer.Key("column");
    writer.Int(place.column);
    writer.EndObject();
}

void write_change(JsonPages& writer, const GraphChange& change) {
    writer.StartObject();
    write(writer, "kind", word(change.kind));
    writer.Key("path");
    writer.StartArray();
    for (const std::string& part : change.path) writer.String(part.c_str());
    writer.EndArray();
    if (change.kind == GraphChangeKind::Renamed) {
        write(writer, "before", change.before);
        write(writer, "after", change.after);
    } else {
        write_value(writer, "before", change.before);
        write_value(writer, "after", change.after);
    }
    write_place(writer, "beforePlace", change.before_place);
    write_place(writer, "afterPlace", change.after_place);
    writer.EndObject();
}

void write_cost(JsonPages& writer, const char* key, const StageCost& cost) {
    const CostCounts total = cost.total();
    if (total.instructions == 0) return;
    writer.Key(key);
    writer.StartObject();
    for (const CostFigure& figure : kCostFigures) write_count(writer, figure.name, total.*figure.count);
    write_count(writer, "perLight", cost.per_light.instructions);
    write_count(writer, "varyings", cost.varyings);
    write_count(writer, "registers", cost.registers);
    writer.EndObject();
}

void write_shader(JsonPages& writer, const ShaderChange& shader) {
    writer.StartObject();
    if (!shader.pass.empty()) {
        write(writer, "pass", shader.pass);
        write(writer, "stage", to_string(shader.stage));
    }
    write(writer, "target", shader.target.name());
    write(writer, "kind", !shader.was_there ? "added" : !shader.is_there ? "removed" : "changed");
    if (shader.was_there && shader.is_there) {
        writer.Key("computesSame");
        writer.Bool(shader.computes_same);
        write_count(writer, "changedLines", changed_lines(shader.lines));
    }
    write_cost(writer, "before", shader.before);
    write_cost(writer, "after", shader.after);
    writer.EndObject();
}

}  // namespace

std::string report_json(const DiffReport& report) {
    JsonBuffer buffer;
    JsonPages writer(buffer);
    writer.SetIndent(' ', 2);
    writer.StartObject();
    write(writer, "before", report.before);
    write(writer, "after", report.after);
    writer.Key("differs");
    writer.Bool(report.differs());
    writer.Key("sameText");
    writer.Bool(report.same_text);
    writer.Key("changes");
    writer.StartArray();
    for (const GraphChange& change : report.graph.changes) write_change(writer, change);
    writer.EndArray();
    if (report.has_shaders) {
        writer.Key("shaders");
        writer.StartArray();
        for (const ShaderChange& shader : report.shaders) write_shader(writer, shader);
        writer.EndArray();
    }
    if (report.picture) {
        writer.Key("picture");
        writer.StartObject();
        write(writer, "file", report.picture->path);
        writer.Key("share");
        writer.Double(report.picture->share);
        writer.Key("largest");
        writer.Double(report.picture->largest);
        writer.EndObject();
    }
    writer.EndObject();
    return std::string(buffer.GetString(), buffer.GetSize()) + "\n";
}

}  // namespace patina::cli
