// Lowers the two functions between a material and its lighting: the surface that the graph computes, and the lighting
// surface that its workflow computes from that.
#include <algorithm>
#include <array>

#include "compiler/lower/lowering.h"

namespace patina::lower {

using emit::Typed;
using ir::Type;
using ir::Value;
using nodelang::FunctionDecl;

Typed as_color(Lowering& lowering, Typed value, GraphScope& scope, Span span) {
    ir::Builder& b = *scope.scope().builder;
    value = emit::primary(lowering.emitter, value, scope.scope(), span);
    if (!value.ok()) return {};
    if (!value.type.is_numeric() || value.type.is_matrix()) {
        lowering.session.diagnostics.report(Code::TypeMismatch, span, "the previewed port",
                                            lowering.out.module.type_name(value.type), "a number or vector");
        return {};
    }
    Value v = value.value;
    if (value.type.scalar != ir::Scalar::Float) v = b.convert(v, ir::Scalar::Float);
    if (value.type.is_scalar()) v = b.splat(v, 3);
    if (value.type.width() == 2) v = b.construct(ir::kFloat3, std::array{v, b.constant(ir::kFloat, {0})});
    if (value.type.width() == 4) v = b.swizzle(v, std::array{0u, 1u, 2u});
    return {.value = v, .type = ir::kFloat3};
}

namespace {

// The value of one surface input: as the graph sets it, or converted from an alternative input, or its default.
Typed surface_value(Lowering& lowering, GraphScope& scope, std::span<const format::Input* const> inputs,
                    const format::Input& input, Type type) {
    const std::vector<format::PortValue>& ports = lowering.material.graph->graph->surface;
    const resolve::Material& material = lowering.material;
    const bool shows_input = material.is_preview && !material.shown_value.value && !material.shows_all_light;
    for (const format::PortValue& port : ports) {
        if (!shows_input) lowering.session.diagnostics.set_context("surface", port.name);
        if (port.name == input.name) {
            if (!port.value) return {};
            if (shows_input) return as_color(lowering, scope.value(*port.value), scope, port.value_span);
            return scope.value_as(port, type, fmt::format("the surface input '{}'", port.name));
        }
        for (const format::Input* other : inputs) {
            if (other->name != port.name || other->gives != input.name || !other->as) continue;
            const Typed given =
                scope.value_as(port, input_type(lowering, *other), fmt::format("the surface input '{}'", port.name));
            if (!given.ok()) return {};
            scope.set_input(other->name, given);
            return scope.value_as(*other->as, type, fmt::format("the surface input '{}'", port.name));
        }
    }
    lowering.session.diagnostics.set_context({}, {});
    if (!input.value) {
        const Span span = lowering.material.graph->graph->span;
        lowering.session.diagnostics.report(Code::MissingInput, span, input.name, "the surface");
        return {};
    }
    return scope.value_as(*input.value, type, fmt::format("the default of '{}'", input.name));
}

// The nodes that are emitted for the pixel: nodes that the surface reads without an interpolator, and unread nodes, so
// that their errors are found.
std::vector<bool> pixel_nodes(const resolve::CheckedGraph& graph) {
    std::vector<bool> pixel(graph.nodes.size(), false), vertex = graph.reachable(graph.graph->vertex);
    const auto walk = [&](std::vector<std::uint32_t> work, std::vector<bool>& seen, bool stop_at_interpolators) {
        while (!work.empty()) {
            const std::uint32_t at = work.back();
            work.pop_back();
            if (seen[at]) continue;
            seen[at] = true;
            if (stop_at_interpolators && graph.graph->nodes[at].stage == format::NodeStage::Vertex) continue;
            work.insert(work.end(), graph.nodes[at].reads.begin(), graph.nodes[at].reads.end());
        }
    };
    std::vector<std::uint32_t> roots;
    for (const format::PortValue& port : graph.graph->surface) {
        if (port.value) resolve::collect_reads(*port.value, graph, roots);
    }
    walk(roots, pixel, true);
    for (std::uint32_t i = 0; i < graph.nodes.size(); ++i) {
        if (graph.graph->nodes[i].stage == format::NodeStage::Vertex) walk({i}, vertex, false);
    }
    for (std::size_t i = 0; i < pixel.size(); ++i) pixel[i] = pixel[i] || !vertex[i];
    return pixel;
}

// The place of the value that a surface input gets.
Span span_of(std::span<const format::PortValue> ports, const format::Input& input) {
    const auto port = std::find_if(ports.begin(), ports.end(), [&](const auto& p) { return p.name == input.name; });
    return port == ports.end() ? input.name_span : port->name_span;
}

}  // namespace

// surface(): all values that the workflow and the lighting model take from the graph, in one struct.
ir::FunctionId lower_surface(Lowering& lowering, std::vector<const format::Input*>& members) {
    ir::Module& module = lowering.out.module;
    const resolve::CheckedGraph& graph = *lowering.material.graph;
    ir::Function function{};
    function.name = "surface";
    // Passes share one function for the surface, of the workflow's set-up and the graph.
    function.always_inline = lowering.out.keeps_functions;
    ir::Builder builder(module, function, lowering.emitter.options);
    GraphScope scope(lowering, graph, builder, false);
    scope.emit_nodes(pixel_nodes(graph));

    ir::Struct made{.name = "Surface", .members = {}};
    std::vector<Value> values;
    bool good = true;
    const std::vector<const format::Input*> inputs = lowering.material.surface_inputs();
    for (const format::Input* input : inputs) {
        if (!input->gives.empty()) continue;
        const Type type = input_type(lowering, *input);
        const Typed value = surface_value(lowering, scope, inputs, *input, type);
        good = good && value.ok();
        scope.watch(ir::Probe::Kind::Output, "surface", input->name, value, span_of(graph.graph->surface, *input));
        made.members.push_back({input->name, type});
        values.push_back(value.value);
        members.push_back(input);
    }
    lowering.session.diagnostics.set_context({}, {});
    if (!good) return {};
    module.structs.push_back(std::move(made));
    function.result = Type::structure(static_cast<std::uint32_t>(module.structs.size() - 1));
    builder.ret(builder.construct(function.result, values));
    return add_function(module, std::move(function));
}

// lightingSurface(): the workflow's set-up, over the surface.
ir::FunctionId lower_setup(Lowering& lowering, const FunctionDecl& slot, ir::FunctionId surface,
                           std::span<const format::Input* const> members) {
    ir::Module& module = lowering.out.module;
    const resolve::CheckedGraph& workflow = *lowering.material.workflow;
    ir::Function function{};
    function.name = slot.name;
    function.comment = nodelang::first_sentence(slot.doc);
    function.always_inline = !lowering.out.keeps_functions;
    ir::Builder builder(module, function, lowering.emitter.options);
    GraphScope scope(lowering, workflow, builder, false);
    const Value inputs = builder.call(surface, {});
    builder.name(inputs, module.intern("material"));
    for (std::uint32_t i = 0; i < members.size(); ++i) {
        const Value member = builder.extract(inputs, i);
        scope.set_input(members[i]->name, {.value = member, .type = builder.type(member)});
    }
    scope.emit_nodes(workflow.reachable(workflow.graph->surface));
    const Type type = emit::type(lowering.emitter, slot.result, scope.scope());
    if (type.is_error()) return {};
    std::vector<Value> values;
    for (const ir::Member& member : std::vector<ir::Member>(module.structs[type.ref].members)) {
        const auto port = std::find_if(workflow.graph->surface.begin(), workflow.graph->surface.end(),
                                       [&](const format::PortValue& p) { return p.name == member.name; });
        Typed value;
        if (port != workflow.graph->surface.end()) {
            value = scope.value_as(*port, member.type, fmt::format("'{}'", member.name));
        } else {
            const auto input = std::find_if(members.begin(), members.end(),
                                            [&](const format::Input* i) { return i->name == member.name; });
            if (input == members.end()) {
                lowering.session.diagnostics.report(Code::MissingInput, workflow.graph->span, member.name,
                                                    workflow.graph->name);
                return {};
            }
            const Value own = builder.extract(inputs, static_cast<std::uint32_t>(input - members.begin()));
            value = {.value = own, .type = member.type};
        }
        if (!value.ok()) return {};
        builder.name(value.value, module.intern(member.name));
        scope.watch(ir::Probe::Kind::Output, "surface", member.name, value,
                    port == workflow.graph->surface.end() ? workflow.graph->span : port->name_span);
        values.push_back(value.value);
    }
    function.result = type;
    builder.ret(builder.construct(type, values));
    return add_function(module, std::move(function));
}

}  // namespace patina::lower
