// Graphs that nobody would write: 5 to 30 nodes of the library, expressions, functions in node files and sub-graphs
// that several nodes use, from a seed (the same for one compiler: the order in which a C++ expression throws the dice
// is its own). Values stay small and away from what has no answer (division by zero, roots of negative numbers), so
// that most pixels can be compared.
//
// Each graph has noisy twins: the same but for every intermediate value, which is off by about as much as a GPU may be.
// How far a twin's result is from the graph's own says how exact a GPU's result can be expected to be.
//
//   RandomGraph graph = random_graph(compiler, 17);
//   bench.compile(graph.exact.json, graph.exact.files);
#pragma once

#include <map>
#include <string>
#include <vector>

#include "patina/patina.h"

namespace patina::witness {

struct GraphText {
    std::string json;
    std::map<std::string, std::string> files;  // node files and sub-graphs that it names, by name
};

struct RandomGraph {
    GraphText exact;
    std::vector<GraphText> twins;
    bool uses_half = false;
};

// Rows of texels that a graph reads for each of its own rows: texel (x, y + 8 j) for pixel (x, y) of 8 x 8.
inline constexpr int kSide = 8;
inline constexpr int kLayers = 4;

RandomGraph random_graph(const Compiler& compiler, unsigned seed);

}  // namespace patina::witness
