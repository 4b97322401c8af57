// The words that may stand at keys with a fixed choice, and what each means. The reader looks them up, and the JSON
// Schema and the messages list them.
//
//   "wrap": "mirror"  ->  Wrap::Mirror
#pragma once

#include <array>
#include <string_view>

#include "compiler/format/graph.h"
#include "compiler/format/keys.h"
#include "patina/scene.h"

namespace patina::graph {

template <class E>
struct Word {
    std::string_view text;
    E value;
};

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

template <class E, std::size_t N>
constexpr std::string_view text_of(const std::array<Word<E>, N>& words, E value) {
    for (const Word<E>& word : words) {
        if (word.value == value) return word.text;
    }
    return {};
}

inline constexpr std::array kFileKinds = {
    Word<ObjectKind>{"material", ObjectKind::Material}, Word<ObjectKind>{"subgraph", ObjectKind::Subgraph},
    Word<ObjectKind>{"lighting", ObjectKind::Lighting}, Word<ObjectKind>{"workflow", ObjectKind::Workflow},
    Word<ObjectKind>{"scene", ObjectKind::Scene},
};

inline constexpr std::array kPrecisions = {
    Word<Precision>{"float", Precision::Float},
    Word<Precision>{"half", Precision::Half},
};

inline constexpr std::array kPropertyTypes = {
    Word<PropertyType>{"float", PropertyType::Float},         Word<PropertyType>{"float2", PropertyType::Float2},
    Word<PropertyType>{"float3", PropertyType::Float3},       Word<PropertyType>{"float4", PropertyType::Float4},
    Word<PropertyType>{"color", PropertyType::Color},         Word<PropertyType>{"int", PropertyType::Int},
    Word<PropertyType>{"bool", PropertyType::Bool},           Word<PropertyType>{"enum", PropertyType::Enum},
    Word<PropertyType>{"texture2d", PropertyType::Texture2D},
};

inline constexpr std::array kTextureUsages = {
    Word<TextureUsage>{"color", TextureUsage::Color},
    Word<TextureUsage>{"data", TextureUsage::Data},
    Word<TextureUsage>{"normal", TextureUsage::Normal},
};

inline constexpr std::array<std::string_view, 4> kDefaultTextures = {"white", "black", "gray", "bump"};

inline constexpr std::array kBindings = {
    Word<Binding>{"uniform", Binding::Uniform},
    Word<Binding>{"specialization", Binding::Specialization},
    Word<Binding>{"variant", Binding::Variant},
    Word<Binding>{"instance", Binding::Instance},
};

inline constexpr std::array kWraps = {
    Word<Wrap>{"repeat", Wrap::Repeat},
    Word<Wrap>{"clamp", Wrap::Clamp},
    Word<Wrap>{"mirror", Wrap::Mirror},
};

inline constexpr std::array kFilters = {
    Word<Filter>{"linear", Filter::Linear},
    Word<Filter>{"nearest", Filter::Nearest},
};

inline constexpr std::array kNodeStages = {
    Word<NodeStage>{"fragment", NodeStage::Fragment},
    Word<NodeStage>{"vertex", NodeStage::Vertex},
};

inline constexpr std::array kSurfaceKinds = {
    Word<SurfaceKind>{"opaque", SurfaceKind::Opaque},     Word<SurfaceKind>{"cutout", SurfaceKind::Cutout},
    Word<SurfaceKind>{"fade", SurfaceKind::Fade},         Word<SurfaceKind>{"transparent", SurfaceKind::Transparent},
    Word<SurfaceKind>{"additive", SurfaceKind::Additive}, Word<SurfaceKind>{"multiply", SurfaceKind::Multiply},
};

inline constexpr std::array kCulls = {
    Word<Cull>{"back", Cull::Back},
    Word<Cull>{"front", Cull::Front},
    Word<Cull>{"off", Cull::Off},
};

inline constexpr std::array kCompares = {
    Word<Compare>{"never", Compare::Never},
    Word<Compare>{"less", Compare::Less},
    Word<Compare>{"equal", Compare::Equal},
    Word<Compare>{"lessEqual", Compare::LessEqual},
    Word<Compare>{"greater", Compare::Greater},
    Word<Compare>{"notEqual", Compare::NotEqual},
    Word<Compare>{"greaterEqual", Compare::GreaterEqual},
    Word<Compare>{"always", Compare::Always},
};

inline constexpr std::array kStencilOps = {
    Word<StencilOp>{"keep", StencilOp::Keep},
    Word<StencilOp>{"zero", StencilOp::Zero},
    Word<StencilOp>{"replace", StencilOp::Replace},
    Word<StencilOp>{"increment", StencilOp::Increment},
    Word<StencilOp>{"decrement", StencilOp::Decrement},
    Word<StencilOp>{"invert", StencilOp::Invert},
    Word<StencilOp>{"incrementWrap", StencilOp::IncrementWrap},
    Word<StencilOp>{"decrementWrap", StencilOp::DecrementWrap},
};

inline constexpr std::array kLightTypes = {
    Word<SceneLightType>{"directional", SceneLightType::Directional},
    Word<SceneLightType>{"point", SceneLightType::Point},
    Word<SceneLightType>{"spot", SceneLightType::Spot},
};

inline constexpr std::array kRenderModes = {
    Word<SceneRenderMode>{"auto", SceneRenderMode::Auto},
    Word<SceneRenderMode>{"important", SceneRenderMode::Important},
    Word<SceneRenderMode>{"notImportant", SceneRenderMode::NotImportant},
};

inline constexpr std::array kEnvironments = {
    Word<SceneEnvironment>{"studio", SceneEnvironment::Studio},
    Word<SceneEnvironment>{"none", SceneEnvironment::None},
};

inline constexpr std::array kFogModes = {
    Word<SceneFogMode>{"linear", SceneFogMode::Linear},
    Word<SceneFogMode>{"exp", SceneFogMode::Exponential},
    Word<SceneFogMode>{"exp2", SceneFogMode::ExponentialSquared},
};

inline constexpr std::array kMixingModes = {
    Word<SceneMixing>{"shadowMask", SceneMixing::ShadowMask},
    Word<SceneMixing>{"distanceShadowMask", SceneMixing::DistanceShadowMask},
    Word<SceneMixing>{"subtractive", SceneMixing::Subtractive},
};

inline constexpr std::array kLightmapEncodings = {
    Word<SceneLightmapEncoding>{"hdr", SceneLightmapEncoding::Hdr},
    Word<SceneLightmapEncoding>{"rgbm", SceneLightmapEncoding::Rgbm},
    Word<SceneLightmapEncoding>{"dldr", SceneLightmapEncoding::DoubleLdr},
};

// What an input of a sub-graph, a workflow or a lighting model may be.
inline constexpr std::array<std::string_view, 8> kInputTypes = {"float", "float2", "float3", "float4",
                                                                "color", "int",    "bool",   "texture2d"};

}  // namespace patina::graph
