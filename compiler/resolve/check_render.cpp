// Warns of settings of a material without effect: lighting with a workflow that has none, alpha on an opaque surface, a
// cut-off without cutout, a stencil that neither tests nor writes. If the graph itself sets an opaque surface, there is
// no warning for alpha and the cut-off. Such a material often shares its inputs with similar materials of other kinds.
// A graph whose materials choose the kind needs the inputs of all.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/format/clipped_blend.h"
#include "compiler/resolve/material.h"

namespace patina::resolve {
namespace {

using nodelang::Expr;

bool reads_surface(const Expr& expr, std::string_view member) {
    if (expr.kind == Expr::Kind::Member && expr.text == member && expr.args[0]->kind == Expr::Kind::Semantic &&
        expr.args[0]->text == "surface")
        return true;
    return std::any_of(expr.args.begin(), expr.args.end(),
                       [&](const Expr* argument) { return reads_surface(*argument, member); });
}

bool reads_surface(const format::Graph& lighting, std::string_view member) {
    const auto reads = [&](const format::PortValue& port) { return port.value && reads_surface(*port.value, member); };
    return std::any_of(lighting.outputs.begin(), lighting.outputs.end(), reads) ||
           std::any_of(lighting.nodes.begin(), lighting.nodes.end(), [&](const format::Node& node) {
               return (node.expr && reads_surface(*node.expr, member)) ||
                      std::any_of(node.inputs.begin(), node.inputs.end(), reads);
           });
}

void warn_of_alpha(Session& session, const format::Graph& graph, const format::PortValue& port) {
    const format::RenderState& render = graph.render;
    if (render.allows_override || format::is_clipped_blend(graph)) return;
    std::string_view why, advice;
    switch (render.surface) {
        case SurfaceKind::Opaque:
            if (render.surface_span) return;
            why = "the surface is opaque by default";
            advice = R"(set "render": { "surface": "cutout" }, "fade" or "transparent", or "opaque" to keep it opaque)";
            break;
        case SurfaceKind::Additive:
            why = "an additive surface adds its whole colour";
            advice = "multiply the colour by it";
            break;
        case SurfaceKind::Multiply:
            why = "a multiplying surface multiplies by its whole colour";
            advice = "blend between white and the colour by it";
            break;
        case SurfaceKind::Cutout:
        case SurfaceKind::Fade:
        case SurfaceKind::Transparent: return;
    }
    session.diagnostics.report(Code::NoEffect, port.name_span, port.name, why).note(std::string(advice));
}

void warn_of_cut_off(Session& session, const format::RenderState& render, const format::PortValue& port) {
    if (render.surface != SurfaceKind::Opaque || render.surface_span || render.allows_override) return;
    session.diagnostics.report(Code::NoEffect, port.name_span, port.name, "the surface is opaque by default");
}

// `outer`: the material of an extra pass, whose lighting the pass may have inherited.
void warn_of_lighting(Session& session, const format::Graph& graph, const format::Graph* outer) {
    const auto found = session.library.workflows.find(graph.workflow);
    const format::Graph* workflow = found == session.library.workflows.end() ? nullptr : found->second.get().get();
    const format::LightingUse& use = graph.lighting;
    if (!workflow || workflow->is_lit() || !use.present) return;
    const bool is_same = !use.inlined && use.use == workflow->lighting.use;
    if (is_same || (outer && outer->lighting.present && outer->lighting.span == use.span)) return;
    session.diagnostics
        .report(Code::NoEffect, use.inlined ? Span{use.span.begin, use.span.begin + 1} : use.span, "lighting",
                fmt::format("the workflow '{}' has no lighting", graph.workflow))
        .note("remove it, or choose a workflow with lighting");
}

// `lighting`: a graph that may read the inputs, too; null if it is not known. `outer`: the graph whose inputs have been
// reported already.
void warn_of(Session& session, const format::Graph& graph, const format::Graph* lighting, const format::Graph* outer) {
    for (const format::PortValue& port : graph.surface) {
        if (outer && std::any_of(outer->surface.begin(), outer->surface.end(),
                                 [&](const format::PortValue& other) { return other.value == port.value; }))
            continue;
        if (lighting && reads_surface(*lighting, port.name)) continue;
        if (port.name == "alpha") warn_of_alpha(session, graph, port);
        if (port.name == "alphaClip") warn_of_cut_off(session, graph.render, port);
    }
    const std::optional<format::StencilState>& stencil = graph.render.stencil;
    const bool is_told = stencil && outer && outer->render.stencil && outer->render.stencil->span == stencil->span;
    if (stencil && !is_told && stencil->test == Compare::Always && !stencil->changes())
        session.diagnostics.report(
            Code::NoEffect, stencil->span, "stencil",
            "its 'test' always passes, and 'pass', 'fail' and 'depthFail' keep the stored value");
}

}  // namespace

void warn_unheeded(Session& session, const Material& material) {
    const format::Graph& own = *material.graph->graph;
    warn_of_lighting(session, own, nullptr);
    for (const format::ExtraPass& pass : own.passes) warn_of_lighting(session, *pass.graph, &own);
    // The caller of functions decides about alpha, and a user's own passes may use every input.
    if (session.request.functions || session.request.path.ends_with(".pass.hlsl")) return;
    warn_of(session, own, material.lighting ? material.lighting->graph.get() : nullptr, nullptr);
    for (const format::ExtraPass& pass : own.passes) warn_of(session, *pass.graph, nullptr, &own);
}

}  // namespace patina::resolve
