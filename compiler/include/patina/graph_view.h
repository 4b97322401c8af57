// A graph as boxes and lines, for drawings: what its file says, with the types that its values have.
//
//   patina::GraphView view = patina::view_graph(compiler, "rust.graph.json");
//   for (const patina::GraphEdge& edge : view.edges) draw(view.boxes[edge.from], view.boxes[edge.to]);
#pragma once

#include "patina/patina.h"

namespace patina {

struct GraphPort {
    std::string name;
    std::string type;  // "float3"; if the graph does not compile: as it is declared, "floatN", or empty
    // Of an input that is set to something else than a node: "0.5", "@uv0", "mask.r". Of one that is not set: the
    // semantic that it reads by default.
    std::string value;
};
// A node; or a list of values that the graph gives to something: "surface", "vertex", "outputs".
struct GraphBox {
    std::string id;     // of the node; else the key of the list, or "pass outline"
    std::string title;  // the node's type, or "= expression"
    std::string note;
    bool is_node = true;
    std::vector<GraphPort> inputs, outputs;
};
// From an output of a box to an input: indices.
struct GraphEdge {
    std::size_t from = 0, from_port = 0, to = 0, to_port = 0;
};
struct GraphView {
    bool ok = false;
    std::string name, kind;  // "material", "subgraph", "lighting", "workflow"
    std::vector<GraphBox> boxes;
    std::vector<GraphEdge> edges;  // each once
    std::vector<Diagnostic> diagnostics;
    std::vector<std::string> dependencies;  // files that were read
};
// Of the options, only `include_dirs`, `files` and `limits` count. A file of every kind of graph.
PATINA_API GraphView view_graph(const Compiler& compiler, const std::string& path, const CompileOptions& options = {});

}  // namespace patina
