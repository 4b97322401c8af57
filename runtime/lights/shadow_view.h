// The shadow maps of a frame: the view of each light that casts shadows, and its tile in the atlas. The atlas is a
// square of 2 x 2 tiles. kShadowMargin texels around each map stay empty, so that a filter of that width reads "lit"
// outside the map, and never the neighbour.
//
//   ShadowView map = directional_shadow(light, objects, camera_view(scene), {}, {.number = 0, .atlas_size = 2048});
//   view_to_clip and world_to_view are the caster pass's; map.world_to_shadow and map.tile are for who reads it.
//
// A surface must not shadow itself anywhere within the filter's reach. The tent of the shadow function weights texels
// whose centres are less than R = 3 texels from the point, along x and along y (2.5 of the tent and half a texel). On a
// plane the depths of the two differ by at most R (|dz/dx| + |dz/dy|) <= 2 R max(|dz/dx|, |dz/dy|), z in depth and x
// and y in texels. For light at the angle theta to the normal, |grad z| is a texel's size times tan theta. The slope
// bias of the rasteriser is a multiple of just this maximum, in the depths of the map. With the factor 2 R = 6, a plane
// has no shadow of itself for every direction and distance of the light. For a spot, too: its depths after division by
// w are linear across a plane, and a texel grows with the distance by itself. The caster pass states that factor. Bends
// between texels and rounding are left: for these, shadows are read kShadowLookupBias texels nearer to the light. The
// light's own biases come on top.
#pragma once

#include <optional>
#include <span>

#include "runtime/lights/shadow_fit.h"
#include "runtime/picture/image.h"
#include "runtime/scene/view.h"

namespace patina::runtime {

inline constexpr std::size_t kMostShadowMaps = 4;
inline constexpr int kShadowMargin = 4;        // texels: 5 x 5 taps of a bilinear filter reach 3
inline constexpr int kShadowReach = 3;         // texels: how far from a point along x and y the filter reads
inline constexpr float kShadowLookupBias = 1;  // texels, as large as they are where the point is
inline constexpr int kSmallestShadowAtlas = 64;

struct ShadowTile {
    int number = 0;         // of the map: 0 to 3, in rows from the top left of the atlas
    int atlas_size = 2048;  // texels along a side, even, kSmallestShadowAtlas or more
};

struct ShadowView {
    View view{};                   // the light's, with its biases
    glm::mat4 world_to_shadow{1};  // world -> clip of the map: x and y -1 to 1, y up, z 0 near to 1 far, biased
    glm::vec4 tile{1, 1, 0, 0};    // uv of the map, 0 to 1 from the top left -> uv of the atlas: scale xy, offset zw
    PixelArea area{};              // the same in texels of the atlas
    float strength = 1;            // 0 to 1: how dark
};

// Covers shadowed_extent() and the filter's reach around it. The map moves by whole texels, and its texels keep their
// size while its content changes little. So edges of shadows do not crawl while the camera stands still. A texel's size
// in metres is the same everywhere, and so is the normal bias.
ShadowView directional_shadow(const Light& light, std::span<const ShadowObject> objects, const View& camera,
                              std::optional<float> shadow_distance, const ShadowTile& tile);

// Covers the spot's outer cone (up to kWidestSpot degrees) as far as its range. A texel and the normal bias grow with
// the distance along the axis. Objects nearer to the light than 5 cm, or than a thousandth of a long range, cast no
// shadow: otherwise float depths could not distinguish a texel at the range.
ShadowView spot_shadow(const Light& light, const ShadowTile& tile);

}  // namespace patina::runtime
