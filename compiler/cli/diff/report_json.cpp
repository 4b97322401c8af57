#include "compiler/cli/diff/report.h"
#include "compiler/json/json_writer.h"

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

// A value as the graph has it.
void write_value(JsonWriter& json, std::string_view key, const std::string& value) {
    if (value.empty()) return;
    json.write_key(key);
    json.raw(value);
}

void write_location(JsonWriter& json, std::string_view key, const FileLocation& place) {
    if (place.line == 0) return;
    json.begin(key, '{');
    json.write("line", place.line);
    json.write("column", place.column);
    json.end();
}

void write_change(JsonWriter& json, const GraphChange& change) {
    json.begin('{');
    json.write("kind", word(change.kind));
    json.write("path", change.path);
    if (change.kind == GraphChangeKind::Renamed) {
        json.write("before", change.before);
        json.write("after", change.after);
    } else {
        write_value(json, "before", change.before);
        write_value(json, "after", change.after);
    }
    write_location(json, "beforePlace", change.before_location);
    write_location(json, "afterPlace", change.after_location);
    json.end();
}

void write_cost(JsonWriter& json, std::string_view key, const StageCost& cost) {
    const CostCounts total = cost.total();
    if (total.instructions == 0) return;
    json.begin(key, '{');
    for (const CostFigure& figure : kCostFigures) json.write(figure.name, total.*figure.count);
    json.write("perLight", cost.per_light.instructions);
    json.write("varyings", cost.varyings);
    json.write("registers", cost.registers);
    json.end();
}

void write_shader(JsonWriter& json, const ShaderChange& shader) {
    json.begin('{');
    if (!shader.pass.empty()) {
        json.write("pass", shader.pass);
        json.write("stage", to_string(shader.stage));
    }
    json.write("target", shader.target.name());
    json.write("kind", !shader.was_there ? "added" : !shader.is_there ? "removed" : "changed");
    if (shader.was_there && shader.is_there) {
        json.write("computesSame", shader.computes_same);
        json.write("changedLines", changed_lines(shader.lines));
    }
    write_cost(json, "before", shader.before);
    write_cost(json, "after", shader.after);
    json.end();
}

}  // namespace

std::string report_json(const DiffReport& report) {
    JsonWriter json(JsonWriter::Layout::Pages);
    json.begin('{');
    json.write("before", report.before);
    json.write("after", report.after);
    json.write("differs", report.differs());
    json.write("sameText", report.same_text);
    json.begin("changes", '[');
    for (const GraphChange& change : report.graph.changes) write_change(json, change);
    json.end();
    if (report.has_shaders) {
        json.begin("shaders", '[');
        for (const ShaderChange& shader : report.shaders) write_shader(json, shader);
        json.end();
    }
    if (report.picture) {
        json.begin("picture", '{');
        json.write("file", report.picture->path);
        json.write("share", report.picture->share);
        json.write("largest", report.picture->largest);
        json.end();
    }
    json.end();
    return json.take() + "\n";
}

}  // namespace patina::cli
