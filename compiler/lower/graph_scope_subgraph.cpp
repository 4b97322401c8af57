// Nodes that are sub-graphs: their nodes are emitted where they are used, under an id path.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/lower/lowering.h"

namespace patina::graph {

using emit::Typed;
using ir::Type;
using ir::Value;

void GraphScope::fill_inputs(GraphScope& inner, const Node& node, const Graph& subgraph) {
    for (const Input& input : subgraph.inputs) {
        const auto port = std::find_if(node.inputs.begin(), node.inputs.end(),
                                       [&](const PortValue& p) { return p.name == input.name; });
        const Type type = input_type(lowering_, input);
        if (type.is_error()) continue;
        const std::string what = fmt::format("the input '{}'", input.name);
        if (port != node.inputs.end()) {
            inner.set_input(input.name, value_as(*port, type, what, input.type == "color"));
        } else if (input.value) {
            inner.set_input(input.name, inner.value_as(*input.value, type, what, input.type == "color"));
        } else {
            lowering_.session.diagnostics.report(Code::MissingInput, node.type_span, input.name, node.type);
            inner.set_input(input.name, {});
        }
    }
}

// The outputs of a sub-graph node that are emitted here.
std::vector<bool> GraphScope::read_of_outputs(std::uint32_t index) const {
    const std::vector<PortValue>& outputs = graph_.nodes[index].subgraph->graph->outputs;
    const auto read = read_outputs_.find(index);
    std::vector<bool> marks(outputs.size(), !scope_.in_vertex_stage || read == read_outputs_.end());
    if (marks.empty() || marks[0]) return marks;
    for (std::string_view name : read->second) {
        const auto output =
            std::find_if(outputs.begin(), outputs.end(), [&](const PortValue& p) { return p.name == name; });
        // The node itself, or a swizzle of its only output.
        if (output == outputs.end()) return std::vector<bool>(outputs.size(), true);
        marks[static_cast<std::size_t>(output - outputs.begin())] = true;
    }
    return marks;
}

Typed GraphScope::subgraph_node(std::uint32_t index) {
    const CheckedGraph& subgraph = *graph_.nodes[index].subgraph;
    GraphScope inner(lowering_, subgraph, *scope_.builder, scope_.in_vertex_stage);
    inner.outer_ = this;
    inner.outer_node_ = index;
    fill_inputs(inner, graph_.graph->nodes[index], *subgraph.graph);
    const std::vector<bool> read = read_of_outputs(index);
    std::vector<PortValue> roots;
    for (std::size_t i = 0; i < read.size(); ++i) {
        if (!read[i] || !subgraph.graph->outputs[i].value) continue;
        roots.push_back(subgraph.graph->outputs[i]);
        inner.announce(*roots.back().value);
    }
    inner.emit_nodes(subgraph.reachable(roots));
    needs_quad_ = needs_quad_ || inner.needs_quad_;
    std::vector<Value> values;
    ir::Struct made{.name = file_stem(subgraph.graph->path) + "Outputs", .members = {}};
    const std::vector<PortValue>& declared = subgraph.graph->outputs;
    const bool is_shown = !declared.empty() && declared.back().name == kShown;
    emit::Outputs outputs{.names = {}, .has_primary = declared.size() == (is_shown ? 2 : 1)};
    for (std::size_t i = 0; i < read.size(); ++i) {
        const PortValue& port = subgraph.graph->outputs[i];
        if (!port.value) return {};
        if (!read[i]) {
            values.push_back(scope_.builder->constant(ir::kFloat, {0}));
            made.members.push_back({port.name, ir::kFloat});
            outputs.names.push_back(port.name);
            continue;
        }
        Typed value = emit::primary(lowering_.emitter, inner.value(*port.value), inner.scope_, port.value_span);
        if (value.literal)
            value = emit::convert(lowering_.emitter, value, ir::kFloat, scope_, port.value_span, "the output");
        if (!value.ok()) return {};
        scope_.builder->name(value.value, lowering_.out.module.intern(port.name));  // only if it has no name yet
        values.push_back(value.value);
        made.members.push_back({port.name, value.type});
        outputs.names.push_back(port.name);
    }
    ir::Module& module = lowering_.out.module;
    module.structs.push_back(std::move(made));
    const Type type = Type::structure(static_cast<std::uint32_t>(module.structs.size() - 1));
    return {.value = scope_.builder->construct(type, values),
            .type = type,
            .outputs = emit::keep(lowering_.emitter, std::move(outputs))};
}

}  // namespace patina::graph
