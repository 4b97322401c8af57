#include "runtime/shadow_view.h"

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

void set_biases(View& view, const LightShadow& shadow, float texel_size) {
    view.bias = shadow.bias;
    view.normal_bias = shadow.normal_bias * texel_size;
}

// Up to the next of 16 steps between powers of two.
float rounded_up(float size) {
    float step = std::exp2(std::floor(std::log2(size))) / 16;
    return std::ceil(size / step) * step;
}

}  // namespace

ShadowView directional_shadow(const Light& light, std::span<const Sphere> casters, std::span<const Sphere> everything,
                              const ShadowTile& tile) {
    const Sphere all = bounds_of(casters);
    ShadowView map = in_tile(light, tile);
    // Snapping moves the map by up to one texel.
    const float texel = 2 * rounded_up(std::max(all.radius, 1e-3f)) / float(map.area.width - 2);
    View& view = map.view;
    set_biases(view, light.shadow, texel);
    view.is_parallel = true;
    view.forward = -glm::normalize(light.direction);
    view.world_to_view = world_to_light(light);

    auto seen = [&](glm::vec3 position) { return glm::vec3(view.world_to_view * glm::vec4(position, 1)); };
    const glm::vec3 center = seen(all.center);
    const glm::vec2 middle = glm::floor(glm::vec2(center) / texel) * texel;
    const float half = texel * float(map.area.width) / 2;
    float nearest = center.z + all.radius, farthest = center.z - all.radius;  // along z, which grows towards the light
    for (const Sphere& sphere : everything) {
        nearest = std::max(nearest, seen(sphere.center).z + sphere.radius);
        farthest = std::min(farthest, seen(sphere.center).z - sphere.radius);
    }
    // Room for the biases, and for what rounding does to a sphere that touches a plane.
    const float room = 0.01f * (nearest - farthest) + view.bias + view.normal_bias;
    nearest += room;
    farthest -= room;
    view.view_to_clip =
        glm::orthoRH_ZO(middle.x - half, middle.x + half, middle.y - half, middle.y + half, -nearest, -farthest);
    view.position = glm::inverse(view.world_to_view) * glm::vec4(middle, nearest, 1);
    map.world_to_shadow = view.view_to_clip * view.world_to_view;
    return map;
}

ShadowView spot_shadow(const Light& light, const ShadowTile& tile) {
    const float angle = glm::radians(std::min(light.outer_angle, kWidestSpot));
    ShadowView map = in_tile(light, tile);
    View& view = map.view;
    set_biases(view, light.shadow, 2 * std::tan(angle) * light.range / float(map.area.width));
    view.position = light.position;
    view.forward = glm::normalize(light.direction);
    view.world_to_view = world_to_light(light);
    view.view_to_clip = glm::perspectiveRH_ZO(2 * angle, 1.0f, std::min(0.05f, light.range / 10), light.range);
    map.world_to_shadow = view.view_to_clip * view.world_to_view;
    return map;
}

}  // namespace patina::runtime
