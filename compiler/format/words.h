// What only the readers of graphs and passes know of words: those that only a graph has, and what others call a word
// of ours. The words that the reflection and scenes have, too, are in patina/words.h.
//
//   meant_by("incrSat", texts<StencilOp>())  ->  "increment"
#pragma once

#include <array>
#include <string_view>

#include "compiler/format/graph.h"
#include "compiler/format/keys.h"
#include "patina/words.h"

namespace patina::graph {

// What others call a word of ours: where a message suggests one, it is the one that is meant.
struct Synonym {
    std::string_view theirs, ours;
};
inline constexpr std::array kSynonyms = {
    // comparisons of ShaderLab, OpenGL and Direct3D
    Synonym{"lequal", "lessEqual"},
    Synonym{"gequal", "greaterEqual"},
    Synonym{"le", "lessEqual"},
    Synonym{"ge", "greaterEqual"},
    Synonym{"lt", "less"},
    Synonym{"gt", "greater"},
    Synonym{"eq", "equal"},
    Synonym{"ne", "notEqual"},
    // what becomes of the stencil: incrSat, INCR_SAT
    Synonym{"incr", "increment"},
    Synonym{"decr", "decrement"},
    Synonym{"incrsat", "increment"},
    Synonym{"decrsat", "decrement"},
    Synonym{"incrwrap", "incrementWrap"},
    Synonym{"decrwrap", "decrementWrap"},
    // and of Metal and WebGPU: incrementClamp, increment-clamp
    Synonym{"incrementclamp", "increment"},
    Synonym{"decrementclamp", "decrement"},
    // stages
    Synonym{"pixel", "fragment"},
    // culling and surfaces
    Synonym{"none", "off"},
    Synonym{"mask", "cutout"},
    Synonym{"alphatest", "cutout"},
    Synonym{"alphaclip", "cutout"},
    Synonym{"blend", "fade"},
    Synonym{"premultiplied", "transparent"},
    Synonym{"premultiply", "transparent"},
    Synonym{"add", "additive"},
    Synonym{"multiplicative", "multiply"},
    Synonym{"modulate", "multiply"},
};

// The words of an enum without their values, as messages list them.
template <HasWords E>
constexpr std::array<std::string_view, kWords<E>.size()> texts() {
    std::array<std::string_view, kWords<E>.size()> made{};
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = kWords<E>[i].text;
    return made;
}

inline constexpr std::array<std::string_view, 4> kDefaultTextures = {"white", "black", "gray", "bump"};

// What an input of a sub-graph, a workflow or a lighting model may be.
inline constexpr std::array<std::string_view, 8> kInputTypes = {"float", "float2", "float3", "float4",
                                                                "color", "int",    "bool",   "texture2d"};

}  // namespace patina::graph

namespace patina {

// The words that only graphs have.
template <>
inline constexpr auto kWords<graph::ObjectKind> = std::to_array<Word<graph::ObjectKind>>({
    {"material", graph::ObjectKind::Material},
    {"subgraph", graph::ObjectKind::Subgraph},
    {"lighting", graph::ObjectKind::Lighting},
    {"workflow", graph::ObjectKind::Workflow},
    {"scene", graph::ObjectKind::Scene},
});

template <>
inline constexpr auto kWords<graph::Precision> = std::to_array<Word<graph::Precision>>({
    {"float", graph::Precision::Float},
    {"half", graph::Precision::Half},
});

template <>
inline constexpr auto kWords<graph::NodeStage> = std::to_array<Word<graph::NodeStage>>({
    {"fragment", graph::NodeStage::Fragment},
    {"vertex", graph::NodeStage::Vertex},
});

}  // namespace patina
