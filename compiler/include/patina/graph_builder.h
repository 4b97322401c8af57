// A graph that is built in code. It has the keys and values of the graph format (docs/graph-format.md), and everything
// else is as for a file: what can be wrong is found by Compiler::compile(), and the diagnostic names the node and the
// port.
//
//   patina::GraphBuilder graph("dots.graph.json");
//   graph.set("workflow", "metallic-roughness").set("lighting", "unity-brdf1");
//   graph.property("_Tint", patina::PropertyType::Color, "#c9a27e");
//   const patina::GraphNode noise = graph.node("noise", "GradientNoise", {{"scale", 8}});
//   graph.surface("baseColor", "= $_Tint.rgb * noise").surface("roughness", noise);
//   const patina::Result result = compiler.compile(graph);
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "patina/export.h"
#include "patina/words.h"

namespace patina {

struct GraphMember;

// A node of a graph that is being built. As a value it is a link to its output.
struct GraphNode {
    std::string id;

    // A link to another output or to components: noise["rgb"].
    GraphNode operator[](std::string_view part) const { return {id + "." + std::string(part)}; }
};

// A value as the format has it: a number, true or false, a text ("mask.r", "= 2 * mask", "@uv0", "$_Tint", "#ff8800",
// "./rust.png", a word), a list or an object.
class PATINA_API GraphValue {
public:
    enum class Kind { Number, Bool, Text, List, Object };

    template <class T>
    requires std::is_arithmetic_v<T> GraphValue(T value)
        : kind_(std::is_same_v<T, bool> ? Kind::Bool : Kind::Number), number_(static_cast<double>(value)) {}
    GraphValue(std::string text) : kind_(Kind::Text), text_(std::move(text)) {}
    GraphValue(std::string_view text) : GraphValue(std::string(text)) {}
    GraphValue(const char* text) : GraphValue(std::string(text)) {}
    GraphValue(const GraphNode& node) : GraphValue(node.id) {}
    static GraphValue list(std::vector<GraphValue> items);
    static GraphValue object(std::vector<GraphMember> members);

    Kind kind() const { return kind_; }
    double number() const { return number_; }  // also 1 for true
    const std::string& text() const { return text_; }
    const std::vector<GraphValue>& items() const { return items_; }  // of a list; of an object, the values
    const std::vector<std::string>& keys() const { return keys_; }   // of an object

private:
    Kind kind_;
    double number_ = 0;
    std::string text_{};
    std::vector<GraphValue> items_{};
    std::vector<std::string> keys_{};
};

struct GraphMember {
    std::string key;
    GraphValue value;
};
using GraphMembers = std::vector<GraphMember>;

class PATINA_API GraphBuilder {
public:
    // `path` names the graph in messages and output files; relative files are searched in its folder.
    explicit GraphBuilder(std::string path) : path_(std::move(path)) {}

    // A key of the graph itself: "workflow", "lighting", "render", "precision", "kind".
    GraphBuilder& set(std::string key, GraphValue value);
    // `more`: further keys of the property, as {"range", GraphValue::list({0, 1})}.
    GraphBuilder& property(std::string name, PropertyType type, GraphValue value, GraphMembers more = {});
    // Of a sub-graph.
    GraphBuilder& input(std::string name, std::string type, GraphMembers more = {});
    // A node of the library, or of a file. `in`: its inputs. `more`: further keys, as {"stage", "vertex"}.
    GraphNode node(std::string id, std::string type, GraphMembers in = {}, GraphMembers more = {});
    GraphNode expression(std::string id, std::string text, GraphMembers more = {});
    GraphBuilder& surface(std::string input, GraphValue value);
    GraphBuilder& vertex(std::string output, GraphValue value);
    // Of a sub-graph or a lighting graph.
    GraphBuilder& output(std::string name, GraphValue value);

    const std::string& path() const { return path_; }
    // The graph as a file: the lines and columns of diagnostics are in this text.
    std::string text() const;

    // A value of text(), and what diagnostics call it: the node and its port; or "surface", "vertex", "outputs",
    // "properties" or "inputs" and a name.
    struct Place {
        std::size_t begin = 0, end = 0;  // in the text
        std::string node, port;
    };
    std::string text(std::vector<Place>& places) const;

private:
    std::string path_;
    GraphMembers keys_, surface_, vertex_, outputs_;
    std::vector<GraphMembers> properties_, inputs_, nodes_;
};

}  // namespace patina
