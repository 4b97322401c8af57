#include "compiler/api/dumps.h"

#include <fmt/format.h>

#include "compiler/link/dumps.h"

namespace patina {

// Dumps the resolved graph; each node comes after those that it reads.
void dump_graph(Result& result, const resolve::Session& session, const resolve::Material& material) {
    if (!link::wants_dump(session.options, "graph")) return;
    const resolve::CheckedGraph& checked = *material.graph;
    const format::Graph& graph = *checked.graph;
    std::string text = fmt::format("{}: {}, lit by {}\n", graph.name, graph.workflow, material.lighting_name);
    for (const resolve::MaterialProperty& entry : material.properties) {
        text += fmt::format("property {} {}\n", to_string(entry.property->type), entry.property->name);
    }
    const auto ports = [&](std::span<const format::PortValue> values) {
        for (const format::PortValue& port : values) {
            text += fmt::format("    {} = {}\n", port.name, session.sources.text(port.value_span));
        }
    };
    for (const std::uint32_t index : checked.order) {
        const format::Node& node = graph.nodes[index];
        text += node.is_expression ? fmt::format("{} = {}\n", node.id, session.sources.text(node.expr->span))
                                   : fmt::format("{} = {}\n", node.id, node.type);
        ports(node.inputs);
        for (const std::uint32_t read : checked.nodes[index].reads) {
            text += "    <- " + graph.nodes[read].id + "\n";
        }
    }
    if (!graph.vertex.empty()) text += "vertex\n";
    ports(graph.vertex);
    text += "surface\n";
    ports(graph.surface);
    result.dumps.push_back({.stage = "graph", .text = std::move(text)});
}

}  // namespace patina
