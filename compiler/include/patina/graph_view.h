// A graph as boxes and lines, for drawings: the content of its file, with the types of its values.
//
//   patina::GraphView view = patina::view_graph(compiler, "rust.graph.json");
//   for (const patina::GraphEdge& edge : view.edges) draw(view.boxes[edge.from], view.boxes[edge.to]);
#pragma once

#include "patina/patina.h"

namespace patina {

// An input or an output of a box.
struct GraphPort {
    std::string name;  // "baseColor"; of an expression: "expr" and "out"
    std::string type;  // "float3"; if the graph does not compile: as it is declared, "floatN", or empty
    // Of an input that is set to something else than a node: "0.5", "@uv0", "mask.r". Of an input that is not set: its
    // default semantic.
    std::string value;
};
// A node; or a list of values that the graph sets: "surface", "vertex", "outputs".
struct GraphBox {
    std::string id;                          // of the node; else the key of the list, or "pass outline"
    std::string title;                       // the node's type, or "= expression"
    std::string note;                        // the node's key "note"
    bool is_node = true;                     // else a list of values
    std::vector<GraphPort> inputs, outputs;  // as they are declared; a list of values has no outputs
};
// A line from an output of a box to an input of another one.
struct GraphEdge {
    std::size_t from = 0, from_port = 0;  // indices into GraphView::boxes and its `outputs`
    std::size_t to = 0, to_port = 0;      // indices into GraphView::boxes and its `inputs`
};
// A graph for a drawing.
struct GraphView {
    bool ok = false;                        // there are no errors; else there are no boxes
    std::string name;                       // the graph's own, or that of its file
    std::string kind;                       // "material", "subgraph", "lighting", "workflow"
    std::vector<GraphBox> boxes;            // nodes in the order of the graph, then the lists of values
    std::vector<GraphEdge> edges;           // each once
    std::vector<Diagnostic> diagnostics;    // errors and warnings of the graph
    std::vector<std::string> dependencies;  // files that were read
    std::vector<std::string> missing;       // files that were searched for and do not exist, sorted
};
// Reads a graph of any kind and finds its types. Of the options, only `include_dirs`, `files` and `limits` count.
PATINA_API GraphView view_graph(const Compiler& compiler, const std::string& path, const CompileOptions& options = {});

}  // namespace patina
