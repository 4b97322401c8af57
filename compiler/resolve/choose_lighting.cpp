// The lighting that the caller of the compiler chooses: another model, and values of the model's variants.
#include "compiler/resolve/material.h"

namespace patina::resolve {

void choose_lighting(Session& session, format::Graph& graph) {
    if (session.options.lighting.empty()) return;
    const std::uint32_t base = session.sources.add("lighting", session.options.lighting);
    const Span span{base, base + static_cast<std::uint32_t>(session.options.lighting.size())};
    const Span own = graph.lighting.span;
    const format::LightingUse chosen{
        .use = session.options.lighting, .span = span, .inputs = {}, .inlined = nullptr, .present = true};
    for (format::ExtraPass& pass : graph.passes) {
        if (pass.graph->lighting.span == own) pass.graph->lighting = chosen;
    }
    graph.lighting = chosen;
}

std::optional<double> chosen_value(Session& session, const Material& material, const format::Property& variant) {
    if (material.property_index.contains(variant.name)) return {};  // the name means the material's own property
    std::optional<double> value;
    for (const auto& [name, word] : session.options.switches) {
        if (name == variant.name) value = keyword_value(session, variant, word);
    }
    return value;
}

}  // namespace patina::resolve
