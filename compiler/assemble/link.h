// Lowered functions + a pass -> two whole stages. Semantics become parameters, and each entry function works out their
// values by their recipes: from vertex attributes, interpolated, or in the pixel. The vertex stage computes exactly
// what the fragment stage still reads.
//
//   Linked linked = link(lowered);
//   ir::Module fragment = link_fragment(linked, lowered, pass);
//   ir::Module vertex = link_vertex(linked, lowered, pass, fragment);
#pragma once

#include "compiler/graph/lower.h"

namespace patina::assemble {

// The lowered module with every `semantic` instruction turned into a parameter, handed down from the entry.
struct Linked {
    ir::Module module;
    std::vector<std::vector<ir::SemanticId>> needs;  // by function: its last parameters
};
Linked link(const graph::Lowered& lowered);

ir::Module link_fragment(const Linked& linked, const graph::Lowered& lowered, const graph::LoweredPass& pass,
                         ir::BuildOptions options);
// `fragment`: the finished fragment stage; its inputs that are no builtins are what the vertex stage hands over, and
// are given their locations here.
ir::Module link_vertex(const Linked& linked, const graph::Lowered& lowered, const graph::LoweredPass& pass,
                       ir::Module& fragment, ir::BuildOptions options);

}  // namespace patina::assemble
