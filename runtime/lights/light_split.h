// The room `lights`: which objects a light of a scene reaches, and its view for the shadow map. It knows neither
// values of materials nor passes.
//
// Splits the lights of an object if a rendering path cannot compute all of them per pixel: the main light, further
// lights per pixel, lights per vertex, and the rest as spherical harmonics. It follows the rules of Unity's forward
// path (Manual, "Forward Rendering Rendering Path Details"):
//
//   1. the brightest directional light is the main one and always per pixel, whatever its render mode; the others are
//      taken by decreasing brightness at the object, and the scene's order where they are as bright
//   2. all lights that are "important" are per pixel, lights that are "not important" never
//   3. as long as the main and the important lights are fewer than the pixel light count, the next ones are per pixel
//   4. of the remaining lights, the first four point lights are per vertex; the others, and all spots and directional
//      lights, are spherical harmonics
//
// One rule differs. In Unity, the last light of a group is also the first of the next group, and its share moves
// between them with the object (A-D, D-G, G-H of eight lights). Here each light is in one group (A-D, E-H). So the
// groups add up to the result of one loop over all lights. Spots are never per vertex, because Unity's vertex lights of
// the forward path are only point lights (Shade4PointLights).
//
//   LightSplit split = split_lights(scene.lights, world_bounds(mesh, matrix), world.pixel_light_count);
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "runtime/scene/bounds.h"
#include "runtime/scene/scene.h"

namespace patina::runtime {

inline constexpr std::size_t kMostVertexLights = 4;

// Indices of lights of the scene; one that is in no group does not reach the object.
struct LightSplit {
    std::optional<std::size_t> main{};   // directional
    std::vector<std::size_t> further{};  // per pixel, the brightest first
    std::vector<std::size_t> vertex{};   // at most kMostVertexLights points, the brightest first
    std::vector<std::size_t> sh{};
};
LightSplit split_lights(std::span<const Light> lights, const Sphere& object, int pixel_light_count);

// The brightest directional light; the first of several that are as bright.
std::optional<std::size_t> main_light(std::span<const Light> lights);

// All lights in the order for shaders: the main one, the other directional ones, then the rest in the scene's order.
std::vector<std::size_t> light_order(std::span<const Light> lights);

// The most of a light that arrives anywhere in a sphere, as distance and cone leave it: `lightAt` of
// nodes/stage/lights.node.hlsl, with the nearest distance and the angle nearest to the axis. 0: out of reach.
float attenuation_within(const Light& light, const Sphere& sphere);

// Adds a light as the object's middle sees it, or its surface where the light is inside: spherical harmonics know no
// place. Its attenuation there is the light's own.
void add_light(SphericalHarmonics& sum, const Light& light, const Sphere& object);

}  // namespace patina::runtime
