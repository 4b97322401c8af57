// The fixed words of graphs, passes and scenes: an enum for each choice, and a table with the word of each value.
// Readers, writers, the reflection's JSON and the runtime all use these tables.
//
//   to_string(Compare::LessEqual)       // "lessEqual"
//   from_word<Compare>("lessEqual")     // Compare::LessEqual; nothing if there is no such word
//   for (const Word<Cull>& word : kWords<Cull>) ...
//
// A new word is a new enumerator and a row of its table. The order of a table is the order in which messages and the
// JSON Schema list the words.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace patina {

// A row of a table: how a value of an enum is written.
template <class E>
struct Word {
    std::string_view text;  // as files and messages have it: "lessEqual"
    E value;                // the value of the word
};

// Marks an enum without a table.
struct NoWords {};
// The table of an enum: a std::array of Word<E>.
template <class E>
inline constexpr NoWords kWords{};

// An enum with a table.
template <class E>
concept HasWords = requires {
    kWords<E>.size();
};

// The word of a value; empty for a value that stands for the absence of a word.
template <HasWords E>
constexpr std::string_view to_string(E value) {
    for (const Word<E>& word : kWords<E>) {
        if (word.value == value) return word.text;
    }
    return {};
}

// The value of a word; nothing if the table has no such word. Case counts.
template <HasWords E>
constexpr std::optional<E> from_word(std::string_view text) {
    for (const Word<E>& word : kWords<E>) {
        if (word.text == text) return word.value;
    }
    return std::nullopt;
}

// --- properties and textures

// The type of a property. A Color is four components, and linear; an Enum is the index of its word; a Gradient and a
// Curve are the rows of an array of 17 float4.
enum class PropertyType {
    Float,
    Float2,
    Float3,
    Float4,
    Color,
    Int,
    Bool,
    Enum,
    Float2x2,
    Float3x3,
    Float4x4,
    Gradient,
    Curve,
    Texture2D,
    TextureCube,
    Texture2DArray,
    Texture3D,
    Sampler
};
// True for the four types that are textures.
constexpr bool is_texture(PropertyType type) {
    return type >= PropertyType::Texture2D && type <= PropertyType::Texture3D;
}
// True for a matrix, a gradient and a curve, which are more than one vector.
constexpr bool is_array(PropertyType type) {
    return type >= PropertyType::Float2x2 && type <= PropertyType::Curve;
}
// How many numbers a value has: 4 for a colour; 1 for an enum, whose number is an index; 1 also for types without
// numbers.
constexpr std::size_t component_count(PropertyType type) {
    switch (type) {
        case PropertyType::Float2: return 2;
        case PropertyType::Float3: return 3;
        case PropertyType::Float4:
        case PropertyType::Color:
        case PropertyType::Float2x2: return 4;
        case PropertyType::Float3x3: return 9;
        case PropertyType::Float4x4: return 16;
        case PropertyType::Gradient:
        case PropertyType::Curve: return 68;
        case PropertyType::Float:
        case PropertyType::Int:
        case PropertyType::Bool:
        case PropertyType::Enum:
        case PropertyType::Texture2D:
        case PropertyType::TextureCube:
        case PropertyType::Texture2DArray:
        case PropertyType::Texture3D:
        case PropertyType::Sampler: break;
    }
    return 1;
}
template <>
inline constexpr auto kWords<PropertyType> = std::to_array<Word<PropertyType>>({
    {"float", PropertyType::Float},
    {"float2", PropertyType::Float2},
    {"float3", PropertyType::Float3},
    {"float4", PropertyType::Float4},
    {"color", PropertyType::Color},
    {"int", PropertyType::Int},
    {"bool", PropertyType::Bool},
    {"enum", PropertyType::Enum},
    {"float2x2", PropertyType::Float2x2},
    {"float3x3", PropertyType::Float3x3},
    {"float4x4", PropertyType::Float4x4},
    {"gradient", PropertyType::Gradient},
    {"curve", PropertyType::Curve},
    {"texture2d", PropertyType::Texture2D},
    {"textureCube", PropertyType::TextureCube},
    {"texture2dArray", PropertyType::Texture2DArray},
    {"texture3d", PropertyType::Texture3D},
    {"sampler", PropertyType::Sampler},
});

// When a property gets its value: when something is drawn; when a pipeline is made; when the graph is compiled; for
// each instance that is drawn.
enum class Binding { Uniform, Specialization, Variant, Instance };
template <>
inline constexpr auto kWords<Binding> = std::to_array<Word<Binding>>({
    {"uniform", Binding::Uniform},
    {"specialization", Binding::Specialization},
    {"variant", Binding::Variant},
    {"instance", Binding::Instance},
});

// What the texels of a texture hold. Color: sRGB, decoded when it is sampled. Data: linear. Normal: in tangent
// space, 2x - 1.
enum class TextureUsage { Color, Data, Normal };
template <>
inline constexpr auto kWords<TextureUsage> = std::to_array<Word<TextureUsage>>({
    {"color", TextureUsage::Color},
    {"data", TextureUsage::Data},
    {"normal", TextureUsage::Normal},
});

// The direction in which the green channel of a normal map grows: up in the picture (+y), as in OpenGL's maps and glTF,
// or down, as in DirectX's maps.
enum class Handedness { OpenGL, DirectX };
template <>
inline constexpr auto kWords<Handedness> = std::to_array<Word<Handedness>>({
    {"opengl", Handedness::OpenGL},
    {"directx", Handedness::DirectX},
});

// The value of a texture property that a material does not set: one texel, or a file. None: the texture is the
// engine's.
enum class TextureDefault { White, Black, Gray, Bump, File, None };
template <>
inline constexpr auto kWords<TextureDefault> = std::to_array<Word<TextureDefault>>({
    {"white", TextureDefault::White},
    {"black", TextureDefault::Black},
    {"gray", TextureDefault::Gray},
    {"bump", TextureDefault::Bump},
});

// How the texels of a texture are arranged: one image, the six faces of a cube, layers, or a volume.
enum class TextureDimension { Flat, Cube, Array, Volume };
template <>
inline constexpr auto kWords<TextureDimension> = std::to_array<Word<TextureDimension>>({
    {"2d", TextureDimension::Flat},
    {"cube", TextureDimension::Cube},
    {"2dArray", TextureDimension::Array},
    {"3d", TextureDimension::Volume},
});

// What is beyond the edges of a texture: the texture again, its outermost texels, or the texture mirrored.
enum class Wrap { Repeat, Clamp, Mirror };
template <>
inline constexpr auto kWords<Wrap> = std::to_array<Word<Wrap>>({
    {"repeat", Wrap::Repeat},
    {"clamp", Wrap::Clamp},
    {"mirror", Wrap::Mirror},
});

// What is between texels. Linear is trilinear. Nearest: the nearest texel of the nearest level.
enum class Filter { Linear, Nearest };
template <>
inline constexpr auto kWords<Filter> = std::to_array<Word<Filter>>({
    {"linear", Filter::Linear},
    {"nearest", Filter::Nearest},
});

// --- values in shaders

// A type of a value in shaders, spelled as in HLSL: a vector by its components, a matrix by rows and columns.
enum class ValueType {
    Float,
    Float2,
    Float3,
    Float4,
    Half,
    Half2,
    Half3,
    Half4,
    Int,
    Int2,
    Int3,
    Int4,
    Uint,
    Uint2,
    Uint3,
    Uint4,
    Bool,
    Bool2,
    Bool3,
    Bool4,
    Float2x2,
    Float3x3,
    Float4x4,
    Half2x2,
    Half3x3,
    Half4x4
};
template <>
inline constexpr auto kWords<ValueType> = std::to_array<Word<ValueType>>({
    {"float", ValueType::Float},       {"float2", ValueType::Float2},     {"float3", ValueType::Float3},
    {"float4", ValueType::Float4},     {"half", ValueType::Half},         {"half2", ValueType::Half2},
    {"half3", ValueType::Half3},       {"half4", ValueType::Half4},       {"int", ValueType::Int},
    {"int2", ValueType::Int2},         {"int3", ValueType::Int3},         {"int4", ValueType::Int4},
    {"uint", ValueType::Uint},         {"uint2", ValueType::Uint2},       {"uint3", ValueType::Uint3},
    {"uint4", ValueType::Uint4},       {"bool", ValueType::Bool},         {"bool2", ValueType::Bool2},
    {"bool3", ValueType::Bool3},       {"bool4", ValueType::Bool4},       {"float2x2", ValueType::Float2x2},
    {"float3x3", ValueType::Float3x3}, {"float4x4", ValueType::Float4x4}, {"half2x2", ValueType::Half2x2},
    {"half3x3", ValueType::Half3x3},   {"half4x4", ValueType::Half4x4},
});
// True for a type with columns.
constexpr bool is_matrix(ValueType type) {
    return type >= ValueType::Float2x2;
}
// True if the components are floating-point numbers, of 32 or 16 bits.
constexpr bool is_float(ValueType type) {
    return type <= ValueType::Half4 || is_matrix(type);
}
// Components of a vector; rows of a matrix, which has as many columns.
constexpr unsigned rows_of(ValueType type) {
    const auto index = static_cast<unsigned>(type);
    return is_matrix(type) ? (index - static_cast<unsigned>(ValueType::Float2x2)) % 3 + 2 : index % 4 + 1;
}

// --- the fixed-function state of a pass

// The stages of a pass.
enum class Stage { Vertex, Fragment };
template <>
inline constexpr auto kWords<Stage> = std::to_array<Word<Stage>>({
    {"vertex", Stage::Vertex},
    {"fragment", Stage::Fragment},
});

// How a surface covers what is behind it. Cutout: pixels with little alpha are not drawn. Fade: all of it is weighted
// by alpha. Transparent: only its diffuse colour is. Additive: it is added to what is behind it. Multiply: it is
// multiplied with that.
enum class SurfaceKind { Opaque, Cutout, Fade, Transparent, Additive, Multiply };
template <>
inline constexpr auto kWords<SurfaceKind> = std::to_array<Word<SurfaceKind>>({
    {"opaque", SurfaceKind::Opaque},
    {"cutout", SurfaceKind::Cutout},
    {"fade", SurfaceKind::Fade},
    {"transparent", SurfaceKind::Transparent},
    {"additive", SurfaceKind::Additive},
    {"multiply", SurfaceKind::Multiply},
});

// The faces that are not drawn. Front faces are counter-clockwise.
enum class Cull { Back, Front, Off };
template <>
inline constexpr auto kWords<Cull> = std::to_array<Word<Cull>>({
    {"back", Cull::Back},
    {"front", Cull::Front},
    {"off", Cull::Off},
});

// z / w of clip space at the near plane and at the far plane: 0 and 1, 1 and 0, or -1 and 1.
enum class ClipDepth { NearToFar, Reversed, Symmetric };
template <>
inline constexpr auto kWords<ClipDepth> = std::to_array<Word<ClipDepth>>({
    {"nearToFar", ClipDepth::NearToFar},
    {"reversed", ClipDepth::Reversed},
    {"symmetric", ClipDepth::Symmetric},
});

// Where texture coordinates of meshes, textures and the screen are (0, 0). Graphs count from the top.
enum class UvOrigin { Top, Bottom };
template <>
inline constexpr auto kWords<UvOrigin> = std::to_array<Word<UvOrigin>>({
    {"top", UvOrigin::Top},
    {"bottom", UvOrigin::Bottom},
});

// How a matrix lies in a uniform block.
enum class MatrixOrder { Columns, Rows };
template <>
inline constexpr auto kWords<MatrixOrder> = std::to_array<Word<MatrixOrder>>({
    {"columns", MatrixOrder::Columns},
    {"rows", MatrixOrder::Rows},
});

// Compares the new depth to the stored depth, or (reference & read mask) to the stored stencil.
enum class Compare { Never, Less, Equal, LessEqual, Greater, NotEqual, GreaterEqual, Always };
template <>
inline constexpr auto kWords<Compare> = std::to_array<Word<Compare>>({
    {"never", Compare::Never},
    {"less", Compare::Less},
    {"equal", Compare::Equal},
    {"lessEqual", Compare::LessEqual},
    {"greater", Compare::Greater},
    {"notEqual", Compare::NotEqual},
    {"greaterEqual", Compare::GreaterEqual},
    {"always", Compare::Always},
});

// What happens to a stencil. Increment and Decrement stop at 255 and at 0; IncrementWrap and DecrementWrap go on at the
// other end.
enum class StencilOp { Keep, Zero, Replace, Increment, Decrement, Invert, IncrementWrap, DecrementWrap };
template <>
inline constexpr auto kWords<StencilOp> = std::to_array<Word<StencilOp>>({
    {"keep", StencilOp::Keep},
    {"zero", StencilOp::Zero},
    {"replace", StencilOp::Replace},
    {"increment", StencilOp::Increment},
    {"decrement", StencilOp::Decrement},
    {"invert", StencilOp::Invert},
    {"incrementWrap", StencilOp::IncrementWrap},
    {"decrementWrap", StencilOp::DecrementWrap},
});

// The number that a stencil is compared with: the material's own number, which has no word; or a number that the
// materials of one lighting pass share.
enum class StencilReference { Own, Lighting };
template <>
inline constexpr auto kWords<StencilReference> = std::to_array<Word<StencilReference>>({
    {"lighting", StencilReference::Lighting},
});

// A blend factor: it multiplies the new pixel (source) or the target's value (destination) before the two are added.
enum class BlendFactor {
    One,
    Zero,
    SourceAlpha,
    OneMinusSourceAlpha,
    TargetAlpha,
    OneMinusTargetAlpha,
    SourceColor,
    TargetColor,
    OneMinusSourceColor,
    OneMinusTargetColor
};
template <>
inline constexpr auto kWords<BlendFactor> = std::to_array<Word<BlendFactor>>({
    {"one", BlendFactor::One},
    {"zero", BlendFactor::Zero},
    {"srcAlpha", BlendFactor::SourceAlpha},
    {"oneMinusSrcAlpha", BlendFactor::OneMinusSourceAlpha},
    {"dstAlpha", BlendFactor::TargetAlpha},
    {"oneMinusDstAlpha", BlendFactor::OneMinusTargetAlpha},
    {"srcColor", BlendFactor::SourceColor},
    {"dstColor", BlendFactor::TargetColor},
    {"oneMinusSrcColor", BlendFactor::OneMinusSourceColor},
    {"oneMinusDstColor", BlendFactor::OneMinusTargetColor},
});

// How a target holds a pixel. Depth (32-bit float, with 8 bits of stencil) is the format of depth targets only: a pass
// cannot ask for it.
enum class TargetFormat { Rgba8, Rgb10A2, Rgba16F, Rgba32F, R32F, Depth };
template <>
inline constexpr auto kWords<TargetFormat> = std::to_array<Word<TargetFormat>>({
    {"rgba8", TargetFormat::Rgba8},
    {"rgb10a2", TargetFormat::Rgb10A2},
    {"rgba16f", TargetFormat::Rgba16F},
    {"rgba32f", TargetFormat::Rgba32F},
    {"r32f", TargetFormat::R32F},
    {"depth", TargetFormat::Depth},
});

// --- what a pass draws

// What a pass draws: the objects of the scene; the whole picture; or a volume around each light of limited range.
enum class PassDraws { Objects, Fullscreen, LightVolumes };
template <>
inline constexpr auto kWords<PassDraws> = std::to_array<Word<PassDraws>>({
    {"objects", PassDraws::Objects},
    {"fullscreen", PassDraws::Fullscreen},
    {"light-volumes", PassDraws::LightVolumes},
});

// How often a pass draws. Light: once for each of its lights; each time, the pass has only this light.
enum class PassEach { Once, Light };
template <>
inline constexpr auto kWords<PassEach> = std::to_array<Word<PassEach>>({
    {"once", PassEach::Once},
    {"light", PassEach::Light},
});

// The lights that a pass gets. Main: the brightest directional light; the others come as vertex lights and in the
// ambient light. MainOnly: the same, without the others. Further: the lights per pixel, without the main light. Local:
// point and spot lights. Shadowed: lights that cast shadows; the pass draws their shadow maps.
enum class PassLights { All, Main, MainOnly, Further, Directional, Local, Shadowed, None };
template <>
inline constexpr auto kWords<PassLights> = std::to_array<Word<PassLights>>({
    {"all", PassLights::All},
    {"main", PassLights::Main},
    {"main-only", PassLights::MainOnly},
    {"further", PassLights::Further},
    {"directional", PassLights::Directional},
    {"local", PassLights::Local},
    {"shadowed", PassLights::Shadowed},
    {"none", PassLights::None},
});

// The cameras for which a pass works. With another camera, a material is drawn with the path's fallback.
enum class PassCamera { Any, Perspective };
template <>
inline constexpr auto kWords<PassCamera> = std::to_array<Word<PassCamera>>({
    {"any", PassCamera::Any},
    {"perspective", PassCamera::Perspective},
});

// --- scenes

// Where a light is: infinitely far away, at a point, or at a point within a cone.
enum class LightKind { Directional, Point, Spot };
template <>
inline constexpr auto kWords<LightKind> = std::to_array<Word<LightKind>>({
    {"directional", LightKind::Directional},
    {"point", LightKind::Point},
    {"spot", LightKind::Spot},
});

// How a light is computed in a rendering path that cannot compute every light per pixel.
enum class LightImportance { Auto, Important, NotImportant };
template <>
inline constexpr auto kWords<LightImportance> = std::to_array<Word<LightImportance>>({
    {"auto", LightImportance::Auto},
    {"important", LightImportance::Important},
    {"notImportant", LightImportance::NotImportant},
});

// The surroundings that mirrors reflect: the studio, or the ambient light.
enum class SceneEnvironment { Studio, None };
template <>
inline constexpr auto kWords<SceneEnvironment> = std::to_array<Word<SceneEnvironment>>({
    {"studio", SceneEnvironment::Studio},
    {"none", SceneEnvironment::None},
});

// What is behind everything: a colour, which has no word; the surroundings; the same out of focus.
enum class SceneBackdrop { Color, Environment, Blurred };
template <>
inline constexpr auto kWords<SceneBackdrop> = std::to_array<Word<SceneBackdrop>>({
    {"env", SceneBackdrop::Environment},
    {"blur", SceneBackdrop::Blurred},
});

// How fog gets denser with the distance: in proportion from a start to an end, as e^(-density distance), or as
// e^(-(density distance)^2). None: there is no fog; it has no word.
enum class FogMode { None, Linear, Exponential, ExponentialSquared };
template <>
inline constexpr auto kWords<FogMode> = std::to_array<Word<FogMode>>({
    {"linear", FogMode::Linear},
    {"exp", FogMode::Exponential},
    {"exp2", FogMode::ExponentialSquared},
});

// How shadows and lightmaps that were baked go together with the shadows of moving objects. ShadowMask: the darker of
// both. DistanceShadowMask: baked shadows where real-time ones have faded. Subtractive: lightmaps hold the main light,
// too.
enum class LightMixing { ShadowMask, DistanceShadowMask, Subtractive };
template <>
inline constexpr auto kWords<LightMixing> = std::to_array<Word<LightMixing>>({
    {"shadowMask", LightMixing::ShadowMask},
    {"distanceShadowMask", LightMixing::DistanceShadowMask},
    {"subtractive", LightMixing::Subtractive},
});

// How the texels of a lightmap hold light; pictures of 8 bits a channel are decoded from sRGB first. Hdr: as it is.
// Rgbm: with a factor in alpha; up to 5 in gamma space. DoubleLdr: half of it; up to 2 in gamma space.
enum class LightmapEncoding { Hdr, Rgbm, DoubleLdr };
template <>
inline constexpr auto kWords<LightmapEncoding> = std::to_array<Word<LightmapEncoding>>({
    {"hdr", LightmapEncoding::Hdr},
    {"rgbm", LightmapEncoding::Rgbm},
    {"dldr", LightmapEncoding::DoubleLdr},
});

}  // namespace patina
