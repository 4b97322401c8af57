// A graph that is built in code, with the keys and values of the graph format (docs/graph-format.md).
// Compiler::compile() finds errors as in a file, and the diagnostic names the node and the port.
//
//   patina::GraphBuilder graph("dots.graph.json");
//   graph.set("workflow", "metallic-roughness").set("lighting", "unity-brdf1");
//   graph.property("_Tint", patina::PropertyType::Color, "#c9a27e");
//   const patina::GraphNode noise = graph.node("noise", "GradientNoise", {{"scale", 8}});
//   graph.surface("baseColor", "= $_Tint.rgb * noise").surface("roughness", noise);
//   const patina::Result result = compiler.compile(graph);
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "patina/export.h"
#include "patina/words.h"

namespace patina {

struct GraphMember;

// A node of a graph that is being built. Used as a value, it is a link to the node's output.
struct GraphNode {
    std::string id;  // unique in the graph, or a link to a part of a node: "noise.rgb"

    // A link to another output or to components: noise["rgb"].
    GraphNode operator[](std::string_view part) const { return {id + "." + std::string(part)}; }
};

// A value as the format has it: a number, true or false, a text ("mask.r", "= 2 * mask", "@uv0", "$_Tint", "#ff8800",
// "./rust.png", a word), a list or an object.
class PATINA_API GraphValue {
public:
    // The kinds of JSON but null.
    enum class Kind { Number, Bool, Text, List, Object };

    // A number, or true or false. The format has no infinity and no NaN: both are errors of the graph.
    template <class T>
    requires std::is_arithmetic_v<T> GraphValue(T value)
        : kind_(std::is_same_v<T, bool> ? Kind::Bool : Kind::Number),
          number_(static_cast<double>(value)),
          is_float_(std::is_same_v<T, float>) {}
    // A text: a link, an expression, a property, a semantic, a colour, a file, a word.
    GraphValue(std::string text) : kind_(Kind::Text), text_(std::move(text)) {}
    // The same.
    GraphValue(std::string_view text) : GraphValue(std::string(text)) {}
    // The same, of a text that ends with a zero byte.
    GraphValue(const char* text) : GraphValue(std::string(text)) {}
    // A link to the node.
    GraphValue(const GraphNode& node) : GraphValue(node.id) {}
    // [0, 1]
    static GraphValue list(std::vector<GraphValue> items);
    // { "range": [0, 1] }
    static GraphValue object(std::vector<GraphMember> members);

    Kind kind() const { return kind_; }                              // which of the functions below have a value
    double number() const { return number_; }                        // also 1 for true
    bool is_float() const { return is_float_; }                      // of a number: 0.1f is written as 0.1
    const std::string& text() const { return text_; }                // of a text
    const std::vector<GraphValue>& items() const { return items_; }  // of a list; of an object: its values
    const std::vector<std::string>& keys() const { return keys_; }   // of an object, in the order of its values
    // As the format writes it: [0, 1].
    std::string json() const;

    // Whether both have one kind and one content. A float is no double: 0.1f is not 0.1.
    friend bool operator==(const GraphValue&, const GraphValue&) = default;

private:
    Kind kind_;
    double number_ = 0;
    bool is_float_ = false;
    std::string text_{};
    std::vector<GraphValue> items_{};
    std::vector<std::string> keys_{};
};

// A key of an object with its value; an input of a node with what it reads. Of a property, an input or a node, the key
// "//" is no key: its text is a comment above, which may have several lines.
struct GraphMember {
    std::string key;   // as the format spells it: "range", or the name of an input
    GraphValue value;  // of the key

    // Whether both have one key and one value.
    friend bool operator==(const GraphMember&, const GraphMember&) = default;
};
// An object, or a part of one, in its order.
using GraphMembers = std::vector<GraphMember>;

// A graph that grows by each call, in the order of the calls. A key, an input or an id that is set twice is an error of
// the graph. Only one thread at a time may use a builder.
class PATINA_API GraphBuilder {
public:
    // `path` names the graph in messages and output files; relative files are searched in its folder.
    explicit GraphBuilder(std::string path) : path_(std::move(path)) {}

    // A key of the graph itself: "workflow", "lighting", "render", "precision", "kind". The text of the key "//"
    // is a comment: above the graph if it is the first of all, else above the key that is set next.
    GraphBuilder& set(std::string key, GraphValue value);
    // A property of the material with its default, if it has one. `more`: further keys, as
    // {"range", GraphValue::list({0, 1})}.
    GraphBuilder& property(std::string name, PropertyType type, std::optional<GraphValue> value,
                           GraphMembers more = {});
    // An input of a sub-graph. `type`: "float3", "floatN". `more`: further keys, as {"default", 0.5}.
    GraphBuilder& input(std::string name, std::string type, GraphMembers more = {});
    // A node of the library, or of a file. `in`: its inputs. `more`: further keys, as {"stage", "vertex"}.
    GraphNode node(std::string id, std::string type, GraphMembers in = {}, GraphMembers more = {});
    // A node that is an expression over other nodes and properties: "mask * $_Tint.rgb".
    GraphNode expression(std::string id, std::string text, GraphMembers more = {});
    // Sets an input of the workflow's surface: "baseColor".
    GraphBuilder& surface(std::string input, GraphValue value);
    // Sets an output of the vertex stage: "positionOS".
    GraphBuilder& vertex(std::string output, GraphValue value);
    // Sets an output of a sub-graph. In a lighting graph, each output is a key of its own: set("direct", ...).
    GraphBuilder& output(std::string name, GraphValue value);

    const std::string& path() const { return path_; }  // the constructor's argument
    // The graph as a file: the lines and columns of diagnostics are in this text.
    std::string text() const;

    // A value of text(), and what diagnostics call it: the node and its port; or "surface", "vertex", "outputs",
    // "properties" or "inputs" and a name.
    struct ValuePlace {
        std::size_t begin = 0, end = 0;  // bytes of the text; `end` is behind the last
        std::string node, port;          // as in Diagnostic
    };
    // The same text. Appends the places of its values, each after those that it lies in.
    std::string text(std::vector<ValuePlace>& places) const;

private:
    std::string path_;
    GraphMembers keys_, surface_, vertex_, outputs_;
    std::vector<GraphMembers> properties_, inputs_, nodes_;
};

}  // namespace patina
