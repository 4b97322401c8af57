// The words that only the readers of graphs and passes use, and the synonyms that other programs have for our words.
// The words that the reflection and scenes share are in patina/words.h.
//
//   meant_by("incrSat", texts<StencilOp>())  ->  "increment"
#pragma once

#include <array>
#include <string_view>

#include "compiler/base/diagnostics.h"
#include "compiler/format/graph.h"
#include "compiler/format/keys.h"
#include "patina/reflection.h"
#include "patina/words.h"

namespace patina::format {

// A word of another program or API, and our word for it, which a message then suggests.
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
    // stencil operations: incrSat, INCR_SAT
    Synonym{"incr", "increment"},
    Synonym{"decr", "decrement"},
    Synonym{"incrsat", "increment"},
    Synonym{"decrsat", "decrement"},
    Synonym{"incrwrap", "incrementWrap"},
    Synonym{"decrwrap", "decrementWrap"},
    // those of Metal and WebGPU: incrementClamp, increment-clamp
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
    // samplers of Unity and of Direct3D
    Synonym{"pointrepeat", "nearestRepeat"},
    Synonym{"pointclamp", "nearestClamp"},
    Synonym{"pointmirror", "nearestMirror"},
    Synonym{"linearrepeat", "trilinearRepeat"},
    Synonym{"linearclamp", "trilinearClamp"},
    Synonym{"linearmirror", "trilinearMirror"},
    Synonym{"bilinearrepeat", "trilinearRepeat"},
    Synonym{"bilinearclamp", "trilinearClamp"},
    Synonym{"bilinearmirror", "trilinearMirror"},
};

// The texts of an enum's words, as messages list them.
template <HasWords E>
constexpr std::array<std::string_view, kWords<E>.size()> texts() {
    std::array<std::string_view, kWords<E>.size()> made{};
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = kWords<E>[i].text;
    return made;
}

inline constexpr std::array<std::string_view, 4> kDefaultTextures = {"white", "black", "gray", "bump"};

// The names of samplers, as messages list them.
inline constexpr auto kSamplerNames = [] {
    std::array<std::string_view, kNamedSamplers.size()> names{};
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = kNamedSamplers[i].name;
    return names;
}();

// Reports a word that is the name of no sampler (read_texture_keys.cpp).
void report_no_sampler(Diagnostics& diagnostics, Span span, std::string_view word);

// The types that an input of a sub-graph, a workflow or a lighting model can have.
// As everywhere, "color" has alpha; "color3" has none.
inline constexpr std::array<std::string_view, 18> kInputTypes = {
    "float", "float2",    "float3",      "float4",         "color",     "color3",
    "int",   "bool",      "float2x2",    "float3x3",       "float4x4",  "gradient",
    "curve", "texture2d", "textureCube", "texture2dArray", "texture3d", "sampler"};

// The texture type of a property or an input, from the word of its type; nothing if it is no texture.
constexpr std::optional<PropertyType> texture_type(std::string_view word) {
    const std::optional<PropertyType> type = from_word<PropertyType>(word);
    return type && is_texture(*type) ? type : std::nullopt;
}

}  // namespace patina::format

namespace patina {

// Words that only graphs use.
template <>
inline constexpr auto kWords<format::ObjectKind> = std::to_array<Word<format::ObjectKind>>({
    {"material", format::ObjectKind::Material},
    {"subgraph", format::ObjectKind::Subgraph},
    {"lighting", format::ObjectKind::Lighting},
    {"workflow", format::ObjectKind::Workflow},
    {"scene", format::ObjectKind::Scene},
});

template <>
inline constexpr auto kWords<format::Precision> = std::to_array<Word<format::Precision>>({
    {"float", format::Precision::Float},
    {"half", format::Precision::Half},
});

template <>
inline constexpr auto kWords<format::GradientBlend> = std::to_array<Word<format::GradientBlend>>({
    {"linear", format::GradientBlend::Linear},
    {"fixed", format::GradientBlend::Fixed},
    {"perceptual", format::GradientBlend::Perceptual},
});

template <>
inline constexpr auto kWords<format::NodeStage> = std::to_array<Word<format::NodeStage>>({
    {"fragment", format::NodeStage::Fragment},
    {"vertex", format::NodeStage::Vertex},
});

}  // namespace patina
