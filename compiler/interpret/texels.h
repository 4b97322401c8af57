// Texture reads, as Vulkan describes them ("Texel Input Operations"), on RGBA texels in linear floats: the filtered
// texels at one coordinate of a level, and the level for a footprint.
//
// Left out: anisotropy (a footprint that is longer than wide is sampled as a square, so such places are blurrier than
// on a GPU).
#pragma once

#include <array>
#include <cstddef>

#include "patina/interpret.h"

namespace patina::interpret {

using Texel = std::array<double, 4>;
using Direction = std::array<double, 3>;

// A texture and how it is read.
struct Reader {
    const TextureData& texture;
    Wrap wrap = Wrap::Repeat;
    bool is_linear = true;

    double last_level() const { return static_cast<double>(texture.levels.size() - 1); }
};

// The four floats of a texel that exists.
const float* texel_at(const TextureLevel& level, std::size_t x, std::size_t y, std::size_t layer = 0);

// Filtered within one layer, within a cube, and between the layers of a 3D texture.
Texel in_layer(const Reader& reader, double u, double v, double lod, std::size_t layer);
Texel in_cube(const Reader& reader, const Direction& direction, double lod);
Texel in_volume(const Reader& reader, const Direction& place, double lod);

// The level of detail of a footprint, from the derivatives of the place along the two axes of the screen.
double flat_level(const Reader& reader, std::array<double, 2> dx, std::array<double, 2> dy);
double cube_level(const Reader& reader, const Direction& direction, const Direction& dx, const Direction& dy);
double volume_level(const Reader& reader, const Direction& dx, const Direction& dy);

}  // namespace patina::interpret
