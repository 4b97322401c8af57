// The mapping from lighting terms to nodes (tests/terms/terms.json) as graphs: what tests/terms/terms.h computes
// with numbers, said once more with links, so that a GPU can compute it too. Used by terms_test.cpp.
//
//   TermGraph graph = term_graph(compiler, row, {1, 3});
//   bench.compile(graph.text);   // texel (x, y) of its data: input y of row x; pixel (x, y): part y of what comes out
#pragma once

#include "tests/terms/reference_values.h"
#include "witness/bench.h"

namespace patina::witness {

using Texel = std::array<double, 4>;

// Names in an expression, where they are neither members nor called, in other words.
std::string renamed(const std::string& expression, const std::map<std::string, std::string>& names);

// A row's inputs: what expressions call them and how a graph reads them.
struct RowInputs {
    std::vector<Texel> texels;                           // one input a texel, or a part of one
    std::map<std::string, std::string> names;            // "NoH" -> "t0.x"
    std::map<std::string, std::string> words;            // that choices are made by
    std::map<std::string, std::vector<double>> numbers;  // of `names`
};
RowInputs row_inputs(const reference::Json& row, const reference::Json& term);

// What a port is given by the term's "in": nothing, if its inputs are not there.
std::optional<std::string> port_text(const reference::Json& mapping, const reference::Json& term,
                                     const RowInputs& inputs);

// The graph of a term that is not a lighting model. `widths`: the width of each part of the result; empty: the graph is
// incomplete, and can only be compared with others.
std::string term_graph(const Compiler& compiler, const reference::Json& term, const RowInputs& inputs,
                       const std::vector<std::size_t>& widths);

}  // namespace patina::witness
