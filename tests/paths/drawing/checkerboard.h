// A checkerboard whose colours are known, for what is drawn before it, and the light of a plane that is lit and seen
// along its normal.
//
//   World world = checkerboard();
//   add_object(world, "examples/surfaces/halo.graph.json", "plane", 1, glm::mat4(1));
//   expect_pixels(world, [](int x, int y) { return behind(x, y) + glow(uv_of(x, y)); });
#pragma once

#include <glm/glm.hpp>

#include "paths/drawing/drawing.h"

namespace patina::paths {

inline constexpr int kBoardPixels = 32;         // of the picture along each axis
inline const glm::dvec3 kSun(0.75, 0.5, 0.25);  // irradiance over pi, as lights are given

// Seen in parallel: a plane from -1 to 1 at z = 0 would fill the picture, and the board lies a metre behind it. The sun
// shines along the view, and nothing comes from around.
World checkerboard();
// What the board shows in a pixel, and where that plane would show its texture.
glm::dvec3 behind(int x, int y);
glm::dvec2 uv_of(int x, int y);

// Of a dielectric whose n, l, v and h are one direction: Disney's diffuse term is 1, Smith's visibility term 1/4,
// Unity's GGX a^2 / (pi (a^4 + 1e-7)), and Fresnel's is f0, which is 0.04.
inline constexpr double kF0 = 0.04;
double highlight(double smoothness);
glm::dvec3 scattered(const glm::dvec3& color);

// Red, green and blue of every pixel through GLSL, HLSL and the CPU; above 1 the tolerance is relative.
void expect_pixels(const World& world, const std::function<glm::dvec3(int x, int y)>& expected,
                   double tolerance = 1e-3);

}  // namespace patina::paths
