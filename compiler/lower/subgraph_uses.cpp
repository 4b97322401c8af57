#include "compiler/lower/subgraph_uses.h"

#include <algorithm>

namespace patina::lower {
namespace {

using nodelang::Expr;

bool reads_property(const Expr& expr) {
    return expr.kind == Expr::Kind::Property ||
           std::any_of(expr.args.begin(), expr.args.end(), [](const Expr* each) { return reads_property(*each); });
}

bool has_linked_defaults(const format::Graph& graph) {
    return std::any_of(graph.inputs.begin(), graph.inputs.end(),
                       [](const format::Input& input) { return input.value && reads_property(*input.value); });
}

// True if the graph pins a node to the vertex stage, itself or in a sub-graph.
bool visit(const resolve::CheckedGraph& graph, AllSubgraphUses& all) {
    bool has_pinned_node = false;
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        const format::Node& node = graph.graph->nodes[i];
        has_pinned_node |= node.stage == format::NodeStage::Vertex;
        const resolve::CheckedGraph* inside = graph.nodes[i].subgraph;
        if (!inside) continue;
        const auto [found, is_new] = all.try_emplace(inside);
        SubgraphUses& uses = found->second;
        ++uses.sites;
        for (const format::PortValue& port : node.inputs) uses.given.insert(port.name);
        if (is_new) {
            uses.has_pinned_node = visit(*inside, all);
            uses.has_linked_defaults = has_linked_defaults(*inside->graph);
        }
        has_pinned_node |= uses.has_pinned_node;
    }
    return has_pinned_node;
}

}  // namespace

AllSubgraphUses subgraph_uses(const resolve::Material& material) {
    AllSubgraphUses all;
    for (const resolve::CheckedGraph* graph : {material.graph, material.workflow, material.lighting}) {
        if (graph) visit(*graph, all);
    }
    return all;
}

bool is_never_given(const SubgraphUses& uses, const format::Input& input) {
    return input.value && !uses.has_linked_defaults && !uses.given.contains(input.name);
}

}  // namespace patina::lower
