// The studio that lights pictures by default: a dim room with a sky above and three soft boxes, a large one at the
// upper left front, a tall cool one on the right and a strip behind. With the default lights, a white Lambert surface
// stays below 1 in every direction, so that its form is visible.
#pragma once

#include <glm/glm.hpp>

namespace patina::runtime {

inline constexpr int kStudioSize = 256;  // texels along a face of its map

// Radiance from a unit direction.
glm::vec3 studio_radiance(glm::vec3 direction);

}  // namespace patina::runtime
