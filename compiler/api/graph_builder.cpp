// GraphBuilder: a graph in code becomes the text that its file would have. So the same reader checks both.
#include "patina/graph_builder.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "compiler/base/text.h"
#include "compiler/json/json_text.h"
#include "compiler/seam/seam.h"
#include "patina/patina.h"

namespace patina {
namespace {

// A text. Any other value of the key is refused by the reader, as an unknown key.
bool is_comment(const GraphMember& member) {
    return member.key == "//" && member.value.kind() == GraphValue::Kind::Text;
}

class Writer {
public:
    explicit Writer(std::vector<GraphBuilder::ValuePlace>& places) : places_(places) {}

    // The lines of a comment, each with a new line and the indent behind it.
    void comment(std::string_view lines, std::string_view indent) {
        for (std::string_view line : split(lines, "\n")) {
            if (line.ends_with('\r')) line.remove_suffix(1);
            text += fmt::format("// {}{}", line, indent);
        }
    }

    void key(std::string_view name, std::string_view lines = {}) {
        text += is_first_ ? "\n  " : ",\n  ";
        is_first_ = false;
        comment(lines, "\n  ");
        json::append_quoted(text, name);
        text += ": ";
    }

    // Nodes, properties or inputs, one a line; they name themselves by the value of their first key.
    void list(std::string_view name, const std::vector<GraphMembers>& items) {
        if (items.empty()) return;
        key(name);
        text += '[';
        for (std::size_t i = 0; i < items.size(); ++i) {
            text += i == 0 ? "\n    " : ",\n    ";
            for (const GraphMember& each : items[i])
                if (is_comment(each)) comment(each.value.text(), "\n    ");
            const std::string& own = items[i].front().value.text();
            if (name == "nodes")
                node(own, items[i]);
            else
                placed(name, own, [&] { members(items[i]); });
        }
        text += "\n  ]";
    }

    // "surface" and the like: one value a line.
    void ports(std::string_view name, const GraphMembers& ports) {
        if (ports.empty()) return;
        key(name);
        text += '{';
        for (std::size_t i = 0; i < ports.size(); ++i) {
            text += i == 0 ? "\n    " : ",\n    ";
            placed(name, ports[i].key, [&] { member(ports[i]); });
        }
        text += "\n  }";
    }

    void value(const GraphValue& value) {
        switch (value.kind()) {
            case GraphValue::Kind::Number: number(value); break;
            case GraphValue::Kind::Bool: text += value.number() != 0 ? "true" : "false"; break;
            case GraphValue::Kind::Text: json::append_quoted(text, value.text()); break;
            case GraphValue::Kind::List:
            case GraphValue::Kind::Object: items(value); break;
        }
    }

    std::string text{};

private:
    // JSON has no number that is not finite: the reader refuses null, and name_numbers() says what it was. An int has
    // no exponent.
    void number(const GraphValue& value) {
        constexpr double kWhole = 1e15;
        if (!std::isfinite(value.number()))
            text += "null";
        else if (value.is_float())
            text += shortest(static_cast<float>(value.number()));
        else if (std::abs(value.number()) < kWhole && std::trunc(value.number()) == value.number())
            text += fmt::format("{:.0f}", value.number());
        else
            text += shortest(value.number());
    }

    template <class Write>
    void placed(std::string_view node, std::string_view port, Write write) {
        const std::size_t index = places_.size();
        places_.push_back({.begin = text.size(), .end = 0, .node = std::string(node), .port = std::string(port)});
        write();
        places_[index].end = text.size();
    }

    // The first members are its id, and what it is.
    void node(const std::string& id, const GraphMembers& members) {
        placed(id, {}, [&] {
            text += "{ ";
            for (std::size_t i = 0; i < members.size(); ++i) {
                if (is_comment(members[i])) continue;
                if (i > 0) text += ", ";
                if (members[i].key == "in")
                    inputs(id, members[i].value);
                else
                    member(members[i]);
            }
            text += " }";
        });
    }
    void inputs(const std::string& id, const GraphValue& in) {
        text += "\"in\": { ";
        for (std::size_t i = 0; i < in.items().size(); ++i) {
            if (i > 0) text += ", ";
            placed(id, in.keys()[i], [&] { member({in.keys()[i], in.items()[i]}); });
        }
        text += " }";
    }

    void member(const GraphMember& member) {
        json::append_quoted(text, member.key);
        text += ": ";
        value(member.value);
    }
    void members(const GraphMembers& members) {
        text += "{ ";
        for (std::size_t i = 0; i < members.size(); ++i) {
            if (is_comment(members[i])) continue;
            if (i > 0) text += ", ";
            member(members[i]);
        }
        text += " }";
    }
    void items(const GraphValue& list) {
        const bool is_object = list.kind() == GraphValue::Kind::Object;
        text += is_object ? "{ " : "[";
        for (std::size_t i = 0; i < list.items().size(); ++i) {
            if (i > 0) text += ", ";
            if (is_object) {
                json::append_quoted(text, list.keys()[i]);
                text += ": ";
            }
            value(list.items()[i]);
        }
        text += is_object ? " }" : "]";
    }

    std::vector<GraphBuilder::ValuePlace>& places_;
    bool is_first_ = true;
};

GraphMembers with(GraphMembers members, GraphMembers more) {
    for (GraphMember& each : more) members.push_back(std::move(each));
    return members;
}

// The text has null for a number that is not finite, and for nothing else.
void name_numbers(std::string& message) {
    constexpr std::string_view kNull = ", not null";
    if (message.ends_with(kNull)) message.replace(message.size() - kNull.size(), kNull.size(), ", not infinity or NaN");
}

// The byte of the text at a line and a column, both from 1.
std::size_t offset_of(std::string_view text, int line, int column) {
    std::size_t at = 0;
    for (; line > 1; --line) at = text.find('\n', at) + 1;
    return at + static_cast<std::size_t>(column) - 1;
}

}  // namespace

std::string GraphValue::json() const {
    std::vector<GraphBuilder::ValuePlace> places;
    Writer writer(places);
    writer.value(*this);
    return std::move(writer.text);
}

GraphValue GraphValue::list(std::vector<GraphValue> items) {
    GraphValue made(0);
    made.kind_ = Kind::List;
    made.items_ = std::move(items);
    return made;
}

GraphValue GraphValue::object(std::vector<GraphMember> members) {
    GraphValue made(0);
    made.kind_ = Kind::Object;
    for (GraphMember& member : members) {
        made.keys_.push_back(std::move(member.key));
        made.items_.push_back(std::move(member.value));
    }
    return made;
}

GraphBuilder& GraphBuilder::set(std::string key, GraphValue value) {
    keys_.push_back({std::move(key), std::move(value)});
    return *this;
}

GraphBuilder& GraphBuilder::property(std::string name, PropertyType type, std::optional<GraphValue> value,
                                     GraphMembers more) {
    GraphMembers members = {{"name", std::move(name)}, {"type", to_string(type)}};
    if (value) members.push_back({"default", std::move(*value)});
    properties_.push_back(with(std::move(members), std::move(more)));
    return *this;
}

GraphBuilder& GraphBuilder::input(std::string name, std::string type, GraphMembers more) {
    inputs_.push_back(with({{"name", std::move(name)}, {"type", std::move(type)}}, std::move(more)));
    return *this;
}

GraphNode GraphBuilder::node(std::string id, std::string type, GraphMembers in, GraphMembers more) {
    GraphMembers members = {{"id", id}, {"node", std::move(type)}};
    if (!in.empty()) members.push_back({"in", GraphValue::object(std::move(in))});
    nodes_.push_back(with(std::move(members), std::move(more)));
    return {std::move(id)};
}

GraphNode GraphBuilder::expression(std::string id, std::string text, GraphMembers more) {
    nodes_.push_back(with({{"id", id}, {"expr", std::move(text)}}, std::move(more)));
    return {std::move(id)};
}

GraphBuilder& GraphBuilder::surface(std::string input, GraphValue value) {
    surface_.push_back({std::move(input), std::move(value)});
    return *this;
}

GraphBuilder& GraphBuilder::vertex(std::string output, GraphValue value) {
    vertex_.push_back({std::move(output), std::move(value)});
    return *this;
}

GraphBuilder& GraphBuilder::output(std::string name, GraphValue value) {
    outputs_.push_back({std::move(name), std::move(value)});
    return *this;
}

std::string GraphBuilder::text() const {
    std::vector<ValuePlace> places;
    return text(places);
}

std::string GraphBuilder::text(std::vector<ValuePlace>& places) const {
    Writer writer(places);
    std::string_view above;  // the comment above the next key
    if (!keys_.empty() && is_comment(keys_[0])) writer.comment(keys_[0].value.text(), "\n");
    writer.text += '{';
    writer.key("patina");
    writer.text += '1';
    for (const GraphMember& member : keys_) {
        if (is_comment(member)) {
            above = &member == &keys_[0] ? std::string_view() : std::string_view(member.value.text());
            continue;
        }
        writer.key(member.key, std::exchange(above, {}));
        writer.value(member.value);
    }
    writer.list("properties", properties_);
    writer.list("inputs", inputs_);
    writer.list("nodes", nodes_);
    writer.ports("vertex", vertex_);
    writer.ports("surface", surface_);
    writer.ports("outputs", outputs_);
    return writer.text + "\n}\n";
}

namespace {

Result compile_built(const Compiler& compiler, const GraphBuilder& graph, const CompileOptions& options) {
    std::vector<GraphBuilder::ValuePlace> places;
    const std::string text = graph.text(places);
    Result result = compiler.compile_text(graph.path(), text, options);
    for (Diagnostic& diagnostic : result.diagnostics) {
        name_numbers(diagnostic.message);
        if (diagnostic.file != graph.path()) continue;
        // A sub-graph is compiled as the node "part" of a material.
        if (options.accept_parts && diagnostic.node == "part") diagnostic.node.clear();
        if (options.accept_parts && diagnostic.node.starts_with("part/")) diagnostic.node.erase(0, 5);
        const bool is_known = !diagnostic.node.empty() && !diagnostic.port.empty();
        if (is_known || diagnostic.line == 0) continue;
        const std::size_t at = offset_of(text, diagnostic.line, diagnostic.column);
        // An inner place comes after the outer one.
        for (const GraphBuilder::ValuePlace& place : places) {
            if (at < place.begin || at >= place.end) continue;
            if (!diagnostic.node.empty() && diagnostic.node != place.node) continue;
            diagnostic.node = place.node;
            diagnostic.port = place.port;
        }
    }
    return result;
}

}  // namespace

Result Compiler::compile(const GraphBuilder& graph, const CompileOptions& options) const {
    return guarded<Result>(graph.path(), [&](Trail&) { return compile_built(*this, graph, options); });
}

}  // namespace patina
