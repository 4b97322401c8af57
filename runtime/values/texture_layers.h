// The layers of textures that are more than one flat picture, cut out of one picture.
//
//   Outcome<std::vector<Image>> faces = cube_faces(image, "sky.hdr");
//   Outcome<std::vector<Image>> layers = grid_layers(image, {4, 2}, "leaves.png");   // eight, row by row
#pragma once

#include <array>
#include <string>
#include <vector>

#include "runtime/outcome.h"
#include "runtime/picture/image.h"

namespace patina::runtime {

inline constexpr int kMostLayers = 2048;  // what every device of Vulkan's roadmap profile has

// Linear picture of all directions (lighting/panorama.h) -> the six faces of a cube, in the order of TextureData.
Outcome<std::vector<Image>> cube_faces(Image image, const std::string& name);
// Columns and rows of equal layers, from the upper left. The picture must divide without rest.
Outcome<std::vector<Image>> grid_layers(const Image& image, std::array<int, 2> grid, const std::string& name);

}  // namespace patina::runtime
