#include "compiler/importers/shadergraph/values/types.h"

#include <algorithm>

namespace patina::importers::shadergraph {
namespace {

struct Row {
    std::string_view kind;
    SlotType type;
};
constexpr Row kSlots[] = {
    {"Boolean", {Type::Bool}},
    {"Vector1", {Type::Float}},
    {"Vector2", {Type::Float2}},
    {"Vector3", {Type::Float3}},
    {"Vector4", {Type::Float4}},
    {"ColorRGB", {Type::Float3}},
    {"ColorRGBA", {Type::Float4}},
    {"DefaultVector2", {Type::Float2}},
    {"DefaultVector4", {Type::Float4}},
    {"UV", {Type::Float2}},
    {"Normal", {Type::Float3}},
    {"Tangent", {Type::Float3}},
    {"Bitangent", {Type::Float3}},
    {"Position", {Type::Float3}},
    {"ViewDirection", {Type::Float3}},
    {"ScreenPosition", {Type::Float4}},
    {"VertexColor", {Type::Float4}},
    {"DynamicVector", {Type::Float, Dynamic::Vector}},
    {"DynamicValue", {Type::Float, Dynamic::Value}},
    {"DynamicMatrix", {Type::Matrix2, Dynamic::Matrix}},
    {"Matrix2", {Type::Matrix2}},
    {"Matrix3", {Type::Matrix3}},
    {"Matrix4", {Type::Matrix4}},
    {"Texture2D", {Type::Texture2D}},
    {"Texture2DInput", {Type::Texture2D}},
    {"Texture2DArray", {Type::Texture2DArray}},
    {"Texture2DArrayInput", {Type::Texture2DArray}},
    {"Texture3D", {Type::Texture3D}},
    {"Texture3DInput", {Type::Texture3D}},
    {"Cubemap", {Type::Cubemap}},
    {"CubemapInput", {Type::Cubemap}},
    {"SamplerState", {Type::Sampler}},
    {"Gradient", {Type::Gradient}},
    {"GradientInput", {Type::Gradient}},
    {"PropertyConnectionState", {Type::Connection}},
    {"VirtualTexture", {Type::VirtualTexture}},
    {"VirtualTextureInput", {Type::VirtualTexture}},
};

}  // namespace

SlotType type_of_slot(std::string_view kind) {
    const auto found = std::ranges::find(kSlots, kind, &Row::kind);
    return found == std::end(kSlots) ? SlotType{} : found->type;
}

Type type_of_property(std::string_view kind) {
    if (kind == "Color") return Type::Float4;
    if (kind == "Keyword" || kind == "Dropdown") return Type::None;
    return type_of_slot(kind).type;
}

bool is_vector(Type type) {
    return type >= Type::Float && type <= Type::Float4;
}

bool is_matrix(Type type) {
    return type >= Type::Matrix2 && type <= Type::Matrix4;
}

bool is_texture(Type type) {
    return type >= Type::Texture2D && type <= Type::Cubemap;
}

bool is_value(Type type) {
    return type >= Type::Bool && type <= Type::Matrix4;
}

std::size_t width(Type type) {
    if (is_vector(type)) return static_cast<std::size_t>(type) - static_cast<std::size_t>(Type::Float) + 1;
    if (is_matrix(type)) return static_cast<std::size_t>(type) - static_cast<std::size_t>(Type::Matrix2) + 2;
    return type == Type::Bool ? 1 : 0;
}

Type vector_type(std::size_t count) {
    return static_cast<Type>(static_cast<std::size_t>(Type::Float) + std::clamp<std::size_t>(count, 1, 4) - 1);
}

Type matrix_type(std::size_t rows) {
    return static_cast<Type>(static_cast<std::size_t>(Type::Matrix2) + std::clamp<std::size_t>(rows, 2, 4) - 2);
}

std::string_view word(Type type) {
    switch (type) {
        case Type::Bool: return "bool";
        case Type::Float: return "float";
        case Type::Float2: return "float2";
        case Type::Float3: return "float3";
        case Type::Float4: return "float4";
        case Type::Matrix2: return "float2x2";
        case Type::Matrix3: return "float3x3";
        case Type::Matrix4: return "float4x4";
        case Type::Texture2D: return "Texture2D";
        case Type::Texture2DArray: return "Texture2DArray";
        case Type::Texture3D: return "Texture3D";
        case Type::Cubemap: return "TextureCube";
        case Type::Sampler: return "SamplerState";
        case Type::Gradient: return "Gradient";
        case Type::Connection: return "connection";
        case Type::VirtualTexture: return "virtual texture";
        case Type::None: break;
    }
    return "nothing";
}

// Numbers fit everything; of the vectors, the smallest one decides.
Type dynamic_vector(std::span<const Type> connected) {
    Type made = Type::Float;
    for (const Type each : connected)
        if (is_vector(each) && each != Type::Float) made = made == Type::Float ? each : std::min(made, each);
    return made;
}

Type dynamic_matrix(std::span<const Type> connected) {
    Type made = Type::None;
    for (const Type each : connected)
        if (is_matrix(each)) made = made == Type::None ? each : std::min(made, each);
    return made == Type::None ? Type::Matrix2 : made;
}

}  // namespace patina::importers::shadergraph
