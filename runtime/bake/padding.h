// Fills the texels between the charts of a texture, so that filters and mip levels read no foreign colour at a seam.
// source: Danielsson, "Euclidean Distance Mapping", Computer Graphics and Image Processing 14, 1980
//
//   const std::vector<std::uint32_t> from = nearest_covered(covered, width, height);
//   fill(image, from);
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/picture/image.h"

namespace patina::runtime {

// For each texel, the index of the nearest covered texel, or nearly the nearest; a covered texel has its own index.
// `covered`: row by row, not 0 where the mesh is; at least one is. The distance is exact but for rare texels
// (Danielsson's 8SED).
std::vector<std::uint32_t> nearest_covered(const std::vector<std::uint8_t>& covered, int width, int height);

// Copies to each texel what `from` says.
void fill(Image& image, const std::vector<std::uint32_t>& from);

}  // namespace patina::runtime
