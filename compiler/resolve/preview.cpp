// A preview: the material becomes one that shows a value. It is, in this order:
//   mask.amount, layers/mask      a port of the graph, or inside one of its sub-graphs
//   roughness                     a surface input that the graph sets
//   surface.roughness             the same, even if there is a node "roughness"
//   lighting/fresnel              a port of the lighting graph
//   PASS/...                      any of these, of an extra pass
//   f0, metallic                  what lighting reads of the surface, or an input that the graph leaves unset
#include <algorithm>

#include "compiler/nodelang/parse.h"
#include "compiler/resolve/material.h"

namespace patina::resolve {
namespace {

using nodelang::Expr;

constexpr std::string_view kLighting = "lighting", kSurface = "surface.";

template <class List, class Id>
auto find_named(const List& list, std::string_view name, Id id) {
    return std::find_if(list.begin(), list.end(), [&](const auto& each) { return id(each) == name; });
}

bool has_node(const format::Graph& graph, std::string_view id) {
    return find_named(graph.nodes, id, [](const format::Node& node) -> std::string_view { return node.id; }) !=
           graph.nodes.end();
}

// If the value is of an extra pass, what that draws becomes the graph's own.
void enter_pass(format::Graph& graph, Shown& shown) {
    const std::string_view name = shown.head().text;
    if (name.size() == shown.text.size() || has_node(graph, name)) return;
    const auto found =
        find_named(graph.passes, name, [](const format::ExtraPass& pass) -> std::string_view { return pass.name; });
    if (found == graph.passes.end()) return;
    const std::shared_ptr<format::Graph> pass = found->graph;
    graph.workflow = pass->workflow;
    graph.workflow_span = pass->workflow_span;
    graph.lighting = pass->lighting;
    graph.vertex = pass->vertex;
    graph.surface = pass->surface;
    graph.render = pass->render;
    shown = shown.inside(name);
}

// The value covers what is behind it: it is not blended, and the depth and stencil buffers have no effect.
void draw_solid(format::Graph& graph) {
    format::RenderState render;
    render.cull = graph.render.cull;
    render.bounds = graph.render.bounds;
    render.span = graph.render.span;
    graph.render = render;
    graph.passes.clear();
}

// The lighting is left out; the caller may still give its variants values.
void note_unused_variants(Session& session, const format::Graph& graph, Material& material) {
    const CheckedGraph* workflow = session.options.switches.empty() ? nullptr : find_workflow(session, graph);
    if (!workflow) return;
    std::string name;
    const CheckedGraph* lighting = find_lighting(session, graph, lighting_of(graph, *workflow->graph), name);
    if (!lighting) return;
    for (const format::Property& property : lighting->graph->properties) {
        if (property.binding == Binding::Variant) material.unused_variants.insert(property.name);
    }
}

// Shows a value that needs no lighting, with the first workflow that can show a single value.
bool show_unlit(Session& session, format::Graph& graph, const Expr* value, Material& material) {
    note_unused_variants(session, graph, material);
    for (const auto& [name, workflow] : session.library.workflows) {
        if (!workflow.get() || workflow.get()->preview_input.empty()) continue;
        graph.workflow = name;
        graph.lighting = {};
        draw_solid(graph);
        graph.surface.clear();
        graph.surface.push_back({.name = workflow.get()->preview_input,
                                 .name_span = value->span,
                                 .value_span = value->span,
                                 .value = value});
        return true;
    }
    return false;
}

// Shows a value that the lighting graph can read, in place of its outputs.
bool show_lit(format::Graph& graph, const Expr* value, Material& material) {
    if (!value) return false;
    draw_solid(graph);
    material.shown_value = {
        .name = std::string(kLighting), .name_span = value->span, .value_span = value->span, .value = value};
    return true;
}

// Names the members of the lighting surface, and the model's own inputs.
bool is_member_of_surface(Session& session, const format::Graph& graph, const format::Graph& workflow,
                          std::string_view name) {
    for (const paths::SlotDecl& slot : session.paths->slots) {
        if (!slot.function->params.empty()) continue;
        const nodelang::StructDecl* surface = session.declarations->structure(slot.function->result.name);
        if (!surface) continue;
        const auto found = find_named(surface->members, name, [](const auto& m) -> std::string_view { return m.name; });
        if (found != surface->members.end()) return true;
    }
    std::string ignored;
    const CheckedGraph* lighting = find_lighting(session, graph, lighting_of(graph, workflow), ignored);
    return lighting && find_named(lighting->graph->inputs, name, [](const format::Input& i) -> std::string_view {
                           return i.name;
                       }) != lighting->graph->inputs.end();
}

// Another output of the lighting graph than a node's: the sum that it computes.
const Expr* output_of(const format::Graph& lighting, std::string_view name) {
    const auto found =
        find_named(lighting.outputs, name, [](const format::PortValue& port) -> std::string_view { return port.name; });
    return found == lighting.outputs.end() || has_node(lighting, name) ? nullptr : found->value;
}

// A slot that passes call with the sums of the others, and that a lighting graph need not set.
bool is_sum(Session& session, std::string_view name) {
    const paths::SlotDecl* slot = session.paths->slot(name);
    return slot && !slot->is_derived() && slot->function->has_body && slot->function->params.size() > 1;
}

bool show_lighting(Session& session, format::Graph& graph, const format::Graph& workflow, const Shown& port,
                   Material& material) {
    std::string ignored;
    const CheckedGraph* lighting = find_lighting(session, graph, lighting_of(graph, workflow), ignored);
    if (!lighting) return false;
    if (const Expr* output = output_of(*lighting->graph, port.text)) return show_lit(graph, output, material);
    if (is_sum(session, port.text) && !has_node(*lighting->graph, port.text)) {
        draw_solid(graph);
        return material.shows_all_light = true;
    }
    material.shown_in_lighting = port;
    return show_lit(graph, parse_shown(session, port), material);
}

}  // namespace

bool make_preview(Session& session, format::Graph& graph, std::string_view preview, Material& material, Shown& shown) {
    shown.base = session.sources.add("preview", std::string(preview));
    shown.text = session.sources.file_text(shown.base);
    enter_pass(graph, shown);
    const std::string_view id = shown.text.substr(0, shown.text.find_first_of("./"));
    const bool is_input = shown.text.starts_with(kSurface) && !has_node(graph, id);
    const std::string_view name = is_input ? shown.text.substr(kSurface.size()) : shown.text;
    if (is_input || !has_node(graph, id)) {
        const auto set = find_named(graph.surface, name,
                                    [](const format::PortValue& port) -> std::string_view { return port.name; });
        if (set != graph.surface.end() && set->value) {
            const Expr* value = set->value;
            shown = {};
            return show_unlit(session, graph, value, material);
        }
        const auto known = session.library.workflows.find(graph.workflow);
        const format::Graph* workflow = known == session.library.workflows.end() ? nullptr : known->second.get().get();
        if (workflow && workflow->is_lit()) {
            if (shown.head().text == kLighting && shown.head().text.size() < shown.text.size()) {
                const Shown port = shown.inside(kLighting);
                shown = {};
                return show_lighting(session, graph, *workflow, port, material);
            }
            if (!is_input && is_member_of_surface(session, graph, *workflow, name)) {
                const std::uint32_t base = session.sources.add("preview", "@surface." + std::string(name));
                shown = {};
                return show_lit(graph,
                                nodelang::parse_link({.text = session.sources.file_text(base), .base = base},
                                                     session.ast, session.diagnostics),
                                material);
            }
        }
        if (workflow) {
            const auto unset = find_named(workflow->inputs, name,
                                          [](const format::Input& input) -> std::string_view { return input.name; });
            if (unset != workflow->inputs.end() && unset->value) {
                shown = {};
                return show_unlit(session, graph, unset->value, material);
            }
        }
    }
    const Expr* value = parse_shown(session, shown);
    if (!value || !show_unlit(session, graph, value, material)) return false;
    return true;
}

}  // namespace patina::resolve
