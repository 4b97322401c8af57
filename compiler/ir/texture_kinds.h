// The kinds of textures: their names in the node language, and the number of components of their coordinates.
//
//   texture_kind("Texture3D")->kind;                  // Kind::Texture3D
//   texture_kind(Kind::Texture2DArray)->coordinates;  // 3: u, v and the number of the layer
#pragma once

#include <string_view>

#include "compiler/ir/types.h"

namespace patina::ir {

struct TextureKind {
    Kind kind = Kind::Texture2D;
    std::string_view name{};   // in the node language and in HLSL
    unsigned coordinates = 2;  // numbers of a place in it
    unsigned derivatives = 2;  // numbers of the derivatives of a place: a layer has none
    bool has_rows = true;      // its second coordinate counts rows, which engines count from the top or the bottom
};
inline constexpr TextureKind kTextureKinds[] = {
    {.kind = Kind::Texture2D, .name = "Texture2D"},
    {.kind = Kind::TextureCube, .name = "TextureCube", .coordinates = 3, .derivatives = 3, .has_rows = false},
    {.kind = Kind::Texture2DArray, .name = "Texture2DArray", .coordinates = 3},
    {.kind = Kind::Texture3D, .name = "Texture3D", .coordinates = 3, .derivatives = 3},
};

// Null if it is none.
constexpr const TextureKind* texture_kind(Kind kind) {
    for (const TextureKind& each : kTextureKinds) {
        if (each.kind == kind) return &each;
    }
    return nullptr;
}
constexpr const TextureKind* texture_kind(std::string_view name) {
    for (const TextureKind& each : kTextureKinds) {
        if (each.name == name) return &each;
    }
    return nullptr;
}

}  // namespace patina::ir
