// The mip levels of a texture, box-filtered in linear light.
//
//   TextureData data{.levels = mip_chain(image)};
#pragma once

#include <span>
#include <vector>

#include "patina/interpret.h"
#include "runtime/picture/image.h"

namespace patina::runtime {

// Linear image -> all levels down to 1 x 1. A level is half the size of the one before, rounded down. Each texel
// averages the area that it covers, so odd sizes keep the mean, too.
std::vector<TextureLevel> mip_chain(Image linear);
// The same of each layer of an array or each face of a cube; all have one size.
std::vector<TextureLevel> mip_chain(std::span<const Image> layers);
// Of a 3D texture, whose layers are halved, too.
std::vector<TextureLevel> volume_mip_chain(std::span<const Image> layers);

}  // namespace patina::runtime
