// Gradients: constants, because a graph has no gradient as a value. A node that samples one becomes a ramp.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/importers/shadergraph/graph_maker.h"

namespace patina::importers::shadergraph {
namespace {

GraphNode ramp(std::string_view kind, std::string_view value, const std::vector<Gradient::Key>& keys, int mode,
               const Term& at) {
    GraphNode made{.id = {}, .node = std::string(kind), .inputs = {{"position", at.value()}}};
    const std::size_t count = std::min<std::size_t>(keys.size(), 8);
    made.inputs.push_back({"keys", number_term(static_cast<double>(count)).value()});
    for (std::size_t i = 0; i < count; ++i) {
        made.inputs.push_back({fmt::format("{}{}", value, i), constant(keys[i].value).value()});
        made.inputs.push_back({fmt::format("at{}", i), number_term(keys[i].time).value()});
    }
    static constexpr std::string_view kModes[] = {"Blended", "FixedUnity", "Perceptual"};
    made.inputs.push_back({"mode", patina::importers::text(kModes[std::clamp(mode, 0, 2)])});
    return made;
}

}  // namespace

Gradient gradient_of(const Json* json) {
    Gradient made;
    for (int i = 0; i < std::clamp(whole_of(json, "m_NumColorKeys", 2), 1, 8); ++i)
        made.colors.push_back({.time = number_of(json, fmt::format("ctime{}", i)) / 65535,
                               .value = vector_of(json, fmt::format("key{}", i), 3)});
    for (int i = 0; i < std::clamp(whole_of(json, "m_NumAlphaKeys", 2), 1, 8); ++i) {
        const std::vector<double> key = vector_of(json, fmt::format("key{}", i), 4);
        made.alphas.push_back({.time = number_of(json, fmt::format("atime{}", i)) / 65535, .value = {key[3]}});
    }
    made.mode = whole_of(json, "m_Mode");
    return made;
}

void make_gradient(GraphMaker& maker, std::size_t node) {
    const Json* json = maker.node(node).json;
    auto made = std::make_shared<Gradient>();
    for (const Json& key : elements_of(json, "m_SerializableColorKeys")) {
        const std::vector<double> value = vector_of(&key, "", 4);
        made->colors.push_back({.time = value[3], .value = {value[0], value[1], value[2]}});
    }
    for (const Json& key : elements_of(json, "m_SerializableAlphaKeys")) {
        const std::vector<double> value = vector_of(&key, "", 2);
        made->alphas.push_back({.time = value[1], .value = {value[0]}});
    }
    made->mode = whole_of(json, "m_SerializableMode");
    Term term{.type = Type::Gradient};
    term.gradient = std::move(made);
    term.nodes = {node};
    maker.set(node, 0, std::move(term));
}

void make_sample_gradient(GraphMaker& maker, std::size_t node) {
    Term from = maker.input(node, 0);
    if (const auto linked = maker.linked_term(node, 0)) from = *linked;
    std::shared_ptr<const Gradient> colors = from.gradient;
    if (!colors || colors->colors.empty() || colors->alphas.empty()) {
        maker.refuse(node, "its gradient is not a constant of this graph: a graph has no gradients as values");
        return;
    }
    const Term time = maker.named(maker.input(node, 1));
    // The engine blends the colours as a picker shows them, and makes the result linear.
    const bool is_perceptual = colors->mode == 2;  // in OkLab, of linear colours
    std::vector<Gradient::Key> keys = colors->colors;
    if (is_perceptual)
        for (Gradient::Key& key : keys)
            for (double& each : key.value) each = linear(each);
    const std::string color = maker.add_node(node, ramp("ColorRamp", "color", keys, colors->mode, time));
    maker.written(time, fmt::format("the node '{}'", color));
    maker.written(from, fmt::format("the node '{}'", color));
    const bool is_opaque =
        std::ranges::all_of(colors->alphas, [](const Gradient::Key& key) { return key.value[0] == 1; });
    const std::string alpha =
        is_opaque
            ? "1"
            : maker.add_node(node, ramp("ValueRamp", "value", colors->alphas, colors->mode, time), color + "Alpha");
    const std::string rgb = is_perceptual ? color : fmt::format("SrgbToLinear({})", color);
    Term made = expression(fmt::format("float4({}, {})", rgb, alpha), Type::Float4);
    made.parts = {{rgb, 3}, {alpha, 1}};
    maker.set(node, 2, made);
}

}  // namespace patina::importers::shadergraph
