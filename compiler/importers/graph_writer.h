// Writes a graph file as a person would: canonical key order and layout (`patina fmt` changes nothing), comments where
// the author of the graph wants them, and nothing that says only what is the default. It knows the grammar of values,
// but not which nodes or inputs exist: `patina check` finds what is wrong with the graph.
//
//   GraphFile graph{.name = "rust", .workflow = "metallic-roughness"};
//   graph.properties.push_back({.name = "_Tint", .type = "color", .value = text("#b04020")});
//   graph.nodes.push_back({.id = "mask", .node = "Noise", .inputs = {{"scale", number(4)}}});
//   graph.surface.push_back({"baseColor", text("$_Tint.rgb")});
//   std::string json = write_graph(graph);
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace patina::importers {

// A value as the graph format writes it. Made by the functions below.
struct Value {
    std::string json{};  // empty: no value, and the key is left out
};
struct Member {
    std::string key;
    Value value;
    std::string comment{};  // lines above it
};

Value number(double value);  // the fewest digits: 0.1; infinities and NaN have no JSON: no value
Value number(float value);   // the fewest digits that are this float
Value flag(bool value);
// A word, a colour, a file, or a link or expression: "linear", "#ff8800", "./rust.png", "mask.r", "= 1 - mask".
Value text(std::string_view value);
Value list(std::span<const double> numbers);
Value list(std::span<const float> numbers);
Value list(std::span<const Value> values);
Value list(std::initializer_list<Value> values);
Value object(std::span<const Member> members);

struct GraphProperty {
    std::string name, type;      // "_Tint", "color"
    Value value{};               // "default"
    std::vector<Member> more{};  // further keys: "usage", "range", "sampler", "label", ...
    std::string comment{};
};
struct GraphNode {
    std::string id;
    std::string node{};            // a library node or a file; or
    std::string expression{};      // an expression in its place: "mask * 2"
    std::vector<Member> inputs{};  // "in"
    std::vector<Member> more{};    // further keys: "stage", "precision", "note"
    std::string comment{};
};

// Lines of comments are plain text: write_graph adds the "// ".
struct GraphFile {
    std::string comment{};  // above the graph: where it came from
    std::string name{};
    std::string kind = "material";
    std::string workflow{};
    std::string lighting{};  // a model's name or file; empty: the workflow's own
    std::vector<Member> lighting_inputs{};
    std::vector<GraphProperty> properties{};
    std::vector<GraphNode> nodes{};
    std::vector<Member> surface{};
    std::vector<Member> more{};  // further keys of the file: "help", "vertex", "render", "outputs", "meta", ...
};

// Empty if the text cannot be JSON: a name or comment is not UTF-8.
std::string write_graph(const GraphFile& graph);
std::string in_canonical_form(std::string text);  // of a graph or a scene

// Lights of a scene: those of `patina render`, whose studio lights what has none.
Value default_lights();

// A scene: `members` are all keys but "patina" and "kind".
std::string write_scene(std::string_view comment, std::span<const Member> members);

}  // namespace patina::importers
