#include "compiler/importers/graph_writer.h"

#include <cmath>

#include "compiler/base/text.h"
#include "compiler/format/canonical_form.h"
#include "compiler/importers/source_text.h"
#include "compiler/json/json_text.h"
#include "runtime/lighting/studio_lights.h"

namespace patina::importers {
namespace {

std::string comment_line(std::string_view line) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    return printable(line);
}

// Text of one object or list, in any layout: format_graph lays it out and sorts its keys.
class Text {
public:
    explicit Text(char open) : close_(open == '{' ? '}' : ']') { out_ += open; }

    // Empty lines are left out.
    void comment(std::string_view lines) {
        for (const std::string_view line : split(lines, "\n")) out_ += "\n// " + comment_line(line);
        if (!lines.empty()) out_ += '\n';
    }
    void member(std::string_view key, const Value& value, std::string_view lines = {}) {
        if (value.json.empty()) return;
        separate();
        comment(lines);
        json::append_quoted(out_, key);
        out_ += ": " + value.json;
    }
    void members(std::span<const Member> members) {
        for (const Member& each : members) member(each.key, each.value, each.comment);
    }
    void element(const Value& value, std::string_view lines = {}) {
        separate();
        comment(lines);
        out_ += value.json;
    }
    Value value() const { return {out_ + close_}; }

private:
    void separate() {
        if (!is_first_) out_ += ", ";
        is_first_ = false;
    }

    std::string out_;
    char close_;
    bool is_first_ = true;
};

Value text_or_nothing(const std::string& word) {
    return word.empty() ? Value{} : text(word);
}

template <class Number>
Value list_of(std::span<const Number> numbers) {
    Text made('[');
    for (const Number each : numbers) made.element(number(each));
    return made.value();
}

Value property_value(const GraphProperty& property) {
    Text made('{');
    made.member("name", text(property.name));
    made.member("type", text(property.type));
    made.member("default", property.value);
    made.members(property.more);
    return made.value();
}

Value node_value(const GraphNode& node) {
    Text made('{');
    made.member("id", text(node.id));
    made.member("node", text_or_nothing(node.node));
    if (!node.inputs.empty()) made.member("in", object(node.inputs));
    made.member("expr", text_or_nothing(node.expression));
    made.members(node.more);
    return made.value();
}

Value lighting_value(const GraphFile& graph) {
    if (graph.lighting_inputs.empty()) return text_or_nothing(graph.lighting);
    Text made('{');
    made.member("use", text(graph.lighting));
    made.member("in", object(graph.lighting_inputs));
    return made.value();
}

// The comment above a file.
std::string head_of(std::string_view comment) {
    std::string head;
    for (const std::string_view line : split(comment, "\n")) head += "// " + comment_line(line) + "\n";
    return head;
}

std::string unformatted(const GraphFile& graph) {
    Text made('{');
    made.member("patina", number(1.0));
    made.member("kind", text(graph.kind));
    made.member("name", text_or_nothing(graph.name));
    made.member("workflow", text_or_nothing(graph.workflow));
    made.member("lighting", lighting_value(graph));
    if (!graph.properties.empty()) {
        Text properties('[');
        for (const GraphProperty& each : graph.properties) properties.element(property_value(each), each.comment);
        made.member("properties", properties.value());
    }
    if (!graph.nodes.empty()) {
        Text nodes('[');
        for (const GraphNode& each : graph.nodes) nodes.element(node_value(each), each.comment);
        made.member("nodes", nodes.value());
    }
    // A material says its surface, even if all of it is the default.
    if (graph.kind == "material" || !graph.surface.empty()) made.member("surface", object(graph.surface));
    made.members(graph.more);
    return head_of(graph.comment) + made.value().json;
}

}  // namespace

std::string in_canonical_form(std::string text) {
    SourceMap sources;
    Diagnostics diagnostics;
    const std::uint32_t begin = sources.add("graph", std::move(text));
    return format::format_graph(sources, begin, diagnostics).text;
}

Value number(double value) {
    return std::isfinite(value) ? Value{shortest(value)} : Value{};
}

Value number(float value) {
    return std::isfinite(value) ? Value{shortest(value)} : Value{};
}

Value flag(bool value) {
    return {value ? "true" : "false"};
}

Value text(std::string_view value) {
    Value made;
    json::append_quoted(made.json, value);
    return made;
}

Value list(std::span<const double> numbers) {
    return list_of(numbers);
}

Value list(std::span<const float> numbers) {
    return list_of(numbers);
}

Value list(std::span<const Value> values) {
    Text made('[');
    for (const Value& each : values) made.element(each);
    return made.value();
}

Value list(std::initializer_list<Value> values) {
    return list(std::span(values.begin(), values.size()));
}

Value object(std::span<const Member> members) {
    Text made('{');
    made.members(members);
    return made.value();
}

std::string write_graph(const GraphFile& graph) {
    return in_canonical_form(unformatted(graph));
}

Value default_lights() {
    std::vector<Value> lights;
    for (const runtime::StudioLight& each : runtime::kStudioLights)
        lights.push_back(object(std::vector<Member>{
            {"type", text("directional")}, {"direction", list(each.direction)}, {"color", list(each.color)}}));
    return list(lights);
}

std::string write_scene(std::string_view comment, std::span<const Member> members) {
    Text made('{');
    made.member("patina", number(1.0));
    made.member("kind", text("scene"));
    made.members(members);
    return in_canonical_form(head_of(comment) + made.value().json);
}

}  // namespace patina::importers
