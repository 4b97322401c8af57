// A matt plane that fills the picture, for pictures that formulas give pixel by pixel.
//
//   World world = matt_plane();
//   world.view.lights = {{.direction = {0, 0, 1}, .color = glm::vec3(2)}};
//   expect_everywhere(draw(world, {.path = "forward"}), [](int, int) { return glm::dvec3(2 * kDiffuse); });
#pragma once

#include <glm/glm.hpp>

#include "paths/drawing/drawing.h"

namespace patina::paths {

inline constexpr int kSide = 16;  // pixels of the picture along each axis
// What the workflow leaves of a base colour of a half: 1 - 0.04 of it is diffuse.
inline constexpr double kDiffuse = 0.5 * 0.96;

// Where the centre of a column or row of pixels lies on the plane, -1 to 1 to the right or upwards.
double right(int x);
double up(int y);

// A lambert material with a base colour of a half; its file.
std::string matt();

// From -1 to 1 in x and y, facing +z, of `segments` squares along each side; seen from 4 m: all of it is 4 m away along
// the camera's axis. There are no lights.
World matt_plane(int segments = 8);
// The same, a little larger, with a vertex at the centre of every pixel: what is interpolated is exact there.
World matt_plane_of_pixels();

// Red, green and blue of all pixels, or of those that `counts` names; above 1 the tolerance is relative.
void expect_everywhere(const Image& image, const std::function<glm::dvec3(int x, int y)>& expected,
                       double tolerance = 2e-3, const std::function<bool(int x, int y)>& counts = {});

}  // namespace patina::paths
