// What the writer, the reader and the schema know of values whose JSON is not simply that of a member.
#pragma once

#include "patina/reflection.h"

namespace patina::reflection {

// How many numbers a property's default has.
constexpr std::size_t component_count(PropertyType type) {
    switch (type) {
        case PropertyType::Color:
        case PropertyType::Float4: return 4;
        case PropertyType::Float3: return 3;
        case PropertyType::Float2: return 2;
        case PropertyType::Float:
        case PropertyType::Int:
        case PropertyType::Bool:
        case PropertyType::Enum:
        case PropertyType::Texture2D:
        case PropertyType::TextureCube:
        case PropertyType::Texture2DArray:
        case PropertyType::Texture3D: break;
    }
    return 1;
}

// A word, or the path of a file.
inline std::string default_text(const Texture& texture) {
    return texture.default_texture == TextureDefault::File ? texture.default_file
                                                           : std::string(to_string(texture.default_texture));
}

}  // namespace patina::reflection
