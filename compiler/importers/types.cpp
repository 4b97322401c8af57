#include "compiler/importers/types.h"

#include <algorithm>

namespace patina::importers::terms {

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

}  // namespace patina::importers::terms
