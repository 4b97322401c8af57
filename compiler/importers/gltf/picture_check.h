// What kind of picture some bytes are, and whether its end is there. Pixels are not decoded: that would take longer
// than all else of an import.
#pragma once

#include <string>
#include <string_view>

namespace patina::importers::gltf {

struct PictureKind {
    std::string ending{};  // ".png", ".jpg", ".webp"
    std::string error{};   // "is a PNG file without its end"
};
PictureKind check_picture(std::string_view bytes);

}  // namespace patina::importers::gltf
