#include "compiler/api/dumps.h"

#include <algorithm>

#include "compiler/ir/dump.h"

namespace patina {
namespace {

bool wants_dump(const CompileOptions& options, std::string_view stage) {
    return std::find(options.dump.begin(), options.dump.end(), stage) != options.dump.end();
}

}  // namespace

void dump_stage(Result& result, const CompileOptions& options, std::string_view name, const std::string& label,
                const ir::Module& module) {
    if (wants_dump(options, name)) result.dumps.push_back({.stage = label, .text = ir::dump(module)});
}

void dump_rates(Result& result, const CompileOptions& options, const std::string& label, const ir::Module& module) {
    if (!wants_dump(options, "rates")) return;
    std::string text;
    for (const ir::Function& function : module.functions) text += ir::dump(module, function, true) + "\n";
    result.dumps.push_back({.stage = label, .text = std::move(text)});
}

// What the graph says, resolved: each node after those that it reads.
void dump_graph(Result& result, const graph::Session& session, const graph::Material& material) {
    if (!wants_dump(session.options, "graph")) return;
    const graph::CheckedGraph& checked = *material.graph;
    const graph::Graph& graph = *checked.graph;
    std::string text = fmt::format("{}: {}, lit by {}\n", graph.name, graph.workflow, material.lighting_name);
    for (const graph::MaterialProperty& entry : material.properties) {
        text += fmt::format("property {} {}\n", to_string(entry.property->type), entry.property->name);
    }
    const auto ports = [&](std::span<const graph::PortValue> values) {
        for (const graph::PortValue& port : values) {
            text += fmt::format("    {} = {}\n", port.name, session.sources.text(port.value_span));
        }
    };
    for (const std::uint32_t index : checked.order) {
        const graph::Node& node = graph.nodes[index];
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
