// How a material uses its sub-graphs: one that several nodes use becomes a function (graph_scope_subgraph.cpp). Each
// graph is walked once, however often it is used.
//
//   const AllSubgraphUses uses = subgraph_uses(material);
//   uses.at(&stripes).sites    // 2
#pragma once

#include <set>

#include "compiler/resolve/material.h"

namespace patina::lower {

struct SubgraphUses {
    std::size_t sites = 0;                       // nodes that use it, in all graphs of the material
    std::set<std::string, std::less<>> given{};  // the inputs that some node gives a value
    bool has_pinned_node = false;                // "stage": "vertex", in it or in a sub-graph of it
    bool has_linked_defaults = false;            // the default of an input reads a property or another input
};
using AllSubgraphUses = std::map<const resolve::CheckedGraph*, SubgraphUses>;

AllSubgraphUses subgraph_uses(const resolve::Material& material);
// True if the input has its default wherever the sub-graph is used, and that needs nothing from there.
bool is_never_given(const SubgraphUses& uses, const format::Input& input);

}  // namespace patina::lower
