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
