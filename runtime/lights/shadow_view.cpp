#include "runtime/lights/shadow_view.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace patina::runtime {
namespace {

// The part of the tile within its margin, still without a view.
ShadowView in_tile(const Light& light, const ShadowTile& tile) {
    int side = tile.atlas_size / 2, width = side - 2 * kShadowMargin;
    int x = tile.number % 2 * side + kShadowMargin, y = tile.number / 2 * side + kShadowMargin;
    return {.tile = glm::vec4(width, width, x, y) / float(tile.atlas_size),
            .area = {.x = x, .y = y, .width = width, .height = width},
            .strength = light.shadow.strength};
}

// `texel`: its size in metres where w of clip space is 1; it grows with w.
void set_biases(ShadowView& map, const LightShadow& shadow, float texel) {
    map.view.bias = shadow.bias;
    map.view.normal_bias = shadow.normal_bias * texel;
    // d metres nearer to the light, z of clip space is less by k d where w is 1 everywhere (k = 1 / (far - near)), and
    // by k d / w where depth is k' - k / w (k = near far / (far - near)): d grows with w, and what is taken off does
    // not.
    glm::mat4 nearer = map.view.view_to_clip;
    nearer[3][2] -= kShadowLookupBias * texel * (map.view.is_parallel ? -nearer[2][2] : -nearer[3][2]);
    map.world_to_shadow = nearer * map.view.world_to_view;
}

// Up to the next of 16 steps between powers of two.
float rounded_up(float size) {
    float step = std::exp2(std::floor(std::log2(size))) / 16;
    return std::ceil(size / step) * step;
}

}  // namespace

ShadowView directional_shadow(const Light& light, std::span<const ShadowObject> objects, const View& camera,
                              std::optional<float> shadow_distance, const ShadowTile& tile) {
    ShadowView map = in_tile(light, tile);
    View& view = map.view;
    view.is_parallel = true;
    view.forward = -glm::normalize(light.direction);
    view.world_to_view = world_to_light(light);

    const Extent extent = shadowed_extent(view.world_to_view, objects, camera, shadow_distance);
    const glm::vec2 size = extent.highest - extent.lowest;
    // Around it the filter's reach; and snapping moves the map by up to one texel.
    const float texels = float(map.area.width - 2 * kShadowReach - 2);
    const float texel = 2 * rounded_up(std::max({size.x / 2, size.y / 2, 1e-3f})) / texels;
    const glm::vec2 middle = glm::floor(glm::vec2(extent.lowest + extent.highest) / (2 * texel)) * texel;
    const float half = texel * float(map.area.width) / 2;
    // Space for the biases, and for rounding of points on a plane.
    const float room = 0.01f * (extent.highest.z - extent.lowest.z) + light.shadow.bias +
                       (light.shadow.normal_bias + kShadowLookupBias) * texel;
    const float nearest = extent.highest.z + room, farthest = extent.lowest.z - room;
    view.view_to_clip =
        glm::orthoRH_ZO(middle.x - half, middle.x + half, middle.y - half, middle.y + half, -nearest, -farthest);
    view.position = glm::inverse(view.world_to_view) * glm::vec4(middle, nearest, 1);
    set_biases(map, light.shadow, texel);
    return map;
}

ShadowView spot_shadow(const Light& light, const ShadowTile& tile) {
    const float angle = glm::radians(std::min(light.outer_angle, kWidestSpot));
    const float nearest = std::max(std::min(0.05f, light.range / 10), light.range / 1000);
    ShadowView map = in_tile(light, tile);
    View& view = map.view;
    view.position = light.position;
    view.forward = glm::normalize(light.direction);
    view.world_to_view = world_to_light(light);
    view.view_to_clip = glm::perspectiveRH_ZO(2 * angle, 1.0f, nearest, light.range);
    set_biases(map, light.shadow, 2 * std::tan(angle) / float(map.area.width));
    return map;
}

}  // namespace patina::runtime
