// Gradients: properties, or constants at the port that reads them.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/importers/patterns.h"
#include "compiler/importers/shadergraph/graph_maker.h"

namespace patina::importers::shadergraph {
namespace {

int count_of(const Json* json, std::string_view key) {
    return whole_in(json, key, std::clamp(whole_of(json, key, 2), 1, 8), 1, 8);
}

}  // namespace

Gradient gradient_of(const Json* json) {
    Gradient made;
    for (int i = 0; i < count_of(json, "m_NumColorKeys"); ++i)
        made.colors.push_back({.time = number_of(json, fmt::format("ctime{}", i)) / 65535,
                               .value = vector_of(json, fmt::format("key{}", i), 3)});
    for (int i = 0; i < count_of(json, "m_NumAlphaKeys"); ++i) {
        const std::vector<double> key = vector_of(json, fmt::format("key{}", i), 4);
        made.alphas.push_back({.time = number_of(json, fmt::format("atime{}", i)) / 65535, .value = {key[3]}});
    }
    made.mode = whole_in(json, "m_Mode", 0, 0, 2);
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
    // What a new node has: from black to white, opaque.
    if (made->colors.empty()) made->colors = {{.time = 0, .value = {0, 0, 0}}, {.time = 1, .value = {1, 1, 1}}};
    if (made->alphas.empty()) made->alphas = {{.time = 0, .value = {1}}};
    made->mode = whole_in(json, "m_SerializableMode", 0, 0, 2);
    constexpr std::size_t kMostKeys = 8;
    const std::size_t most = std::max(made->colors.size(), made->alphas.size());
    if (most > kMostKeys)
        maker.approximate(node, fmt::format("it has {} keys, and a gradient at most {}: the last ones are left out",
                                            most, kMostKeys));
    Term term{.type = Type::Gradient};
    term.gradient = std::move(made);
    term.nodes = {node};
    maker.set(node, 0, std::move(term));
}

void make_sample_gradient(GraphMaker& maker, std::size_t node) {
    Term gradient = maker.input(node, 0);
    if (gradient.type != Type::Gradient) {
        maker.approximate(node, "it has no slot for its gradient: it is magenta");
        gradient = stand_in(Type::Gradient);
    }
    std::vector<Term> time = {maker.input(node, 1)};
    maker.shorten(node, time, 0);
    ImportedNode made{.id = {}, .node = "SampleGradient", .inputs = {{"gradient", gradient.value()}}};
    if (!time[0].is_constant() || time[0].numbers[0] != 0) made.inputs.push_back({"time", time[0].value()});
    const std::string id = maker.add_node(node, std::move(made));
    for (const Term& each : {gradient, time[0]}) maker.written(each, fmt::format("the node '{}'", id));
    Term whole = color_link(id);
    // The engine blends the colours as a picker shows them, and makes the result linear; but in OkLab, of linear
    // colours.
    if (!gradient.gradient || !gradient.gradient->is_perceptual()) {
        const Term parts[] = {terms::computed("SrgbToLinear(a.rgb)", {whole}, Type::Float3), swizzled(whole, "w")};
        whole = terms::vector_of(Type::Float4, parts);
    }
    maker.set(node, 2, whole);
}

}  // namespace patina::importers::shadergraph
