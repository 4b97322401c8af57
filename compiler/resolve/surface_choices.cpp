// "materialOverride" in an engine whose file holds all variants: three properties choose the kind of the surface and
// whether it is clipped. Their names and values are those of Unity's own materials.
#include "compiler/format/words.h"
#include "compiler/resolve/material.h"

namespace patina::resolve {
namespace {

Span opening(const format::RenderState& render) {
    return {render.span.begin, render.span.begin + 1};
}

format::Property choice(std::string_view name, std::string_view label, double value,
                        const format::RenderState& render) {
    format::Property made;
    made.name = std::string(name);
    made.label = std::string(label);
    made.group = "Surface";
    made.type = PropertyType::Bool;
    made.value = {value};
    made.binding = Binding::Variant;
    made.span = made.name_span = made.label_span = made.group_span = made.binding_span = opening(render);
    return made;
}

void add(Session& session, format::Graph& graph, format::Property made) {
    for (const format::Property& property : graph.properties) {
        if (property.name != made.name) continue;
        session.diagnostics.report(Code::DuplicateId, property.name_span, "property", property.name)
            .note(made.name_span, "'materialOverride' declares the first");
        return;
    }
    graph.properties.push_back(std::move(made));
}

}  // namespace

void add_surface_choices(Session& session, format::Graph& graph) {
    format::RenderState& render = graph.render;
    for (format::ExtraPass& pass : graph.passes) {
        format::RenderState& own = pass.graph->render;
        if (own.allows_override && own.span != render.span)
            session.diagnostics.report(Code::NoEffect, opening(own), "materialOverride",
                                       "a material can change only its main surface");
    }
    const bool has_keywords = session.engine.variants == engines::Variants::Keywords;
    render.is_overridable = render.allows_override && has_keywords && !session.request.preview;
    if (!render.is_overridable) return;
    const auto first = std::begin(kBlendingKinds), end = std::end(kBlendingKinds);
    const auto kind = std::find_if(first, end, [&](const BlendingKind& each) { return each.kind == render.surface; });
    add(session, graph, choice(kTransparentChoice, "Transparent", kind != end, render));
    format::Property blend =
        choice(kBlendChoice, "Blending", kind == end ? 0 : static_cast<double>(kind - first), render);
    blend.type = PropertyType::Enum;
    for (const BlendingKind& each : kBlendingKinds) {
        blend.values.emplace_back(each.word);
        blend.value_spans.push_back(opening(render));
    }
    add(session, graph, std::move(blend));
    add(session, graph, choice(kClipChoice, "Alpha Clipping", render.surface == SurfaceKind::Cutout, render));
}

}  // namespace patina::resolve
