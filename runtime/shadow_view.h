// The shadow maps of a frame: what each light that casts sees, and where in the atlas it is drawn. The atlas is a
// square of 2 x 2 tiles. Around a map kShadowMargin texels of its tile stay empty, so that a filter that wide reads
// "lit" beyond the map, and never the neighbour.
//
//   ShadowView map = directional_shadow(light, casters, everything, {.number = 0, .atlas_size = 2048});
//   view_to_clip and world_to_view are the caster pass's; map.world_to_shadow and map.tile are for who reads it.
#pragma once

#include <span>

#include "runtime/bounds.h"
#include "runtime/frame.h"
#include "runtime/view.h"

namespace patina::runtime {

inline constexpr std::size_t kMostShadowMaps = 4;
inline constexpr int kShadowMargin = 4;  // texels: 5 x 5 taps of a bilinear filter reach 3
inline constexpr int kSmallestShadowAtlas = 64;

struct ShadowTile {
    int number = 0;         // of the map: 0 to 3, in rows from the top left of the atlas
    int atlas_size = 2048;  // texels along a side, even, kSmallestShadowAtlas or more
};

struct ShadowView {
    View view{};                   // the light's, with its biases
    glm::mat4 world_to_shadow{1};  // world -> clip of the map: x and y -1 to 1, y up, z 0 near to 1 far
    glm::vec4 tile{1, 1, 0, 0};    // uv of the map, 0 to 1 from the top left -> uv of the atlas: scale xy, offset zw
    FrameArea area{};              // the same in texels of the atlas
    float strength = 1;            // 0 to 1: how dark
};

// Covers the casters' spheres as seen along the light. The map moves by whole texels when the casters move, and its
// texels stay as large while the radius of all of them changes little: edges of shadows do not crawl. Depth covers
// `everything`, so that what lies before or behind the casters gets a depth from 0 to 1 too. A texel's size in metres
// is the same everywhere, and so is the normal bias.
ShadowView directional_shadow(const Light& light, std::span<const Sphere> casters, std::span<const Sphere> everything,
                              const ShadowTile& tile);

// Covers the spot's outer cone (up to kWidestSpot degrees) as far as its range. A texel grows with distance; the normal
// bias is that of the range, where it is largest.
ShadowView spot_shadow(const Light& light, const ShadowTile& tile);

}  // namespace patina::runtime
