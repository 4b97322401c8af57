// The texels of a cube map as directions of the world (Vulkan, "Cube Map Face Selection"): faces in the order +X, -X,
// +Y, -Y, +Z, -Z, rows from the top as the face is stored.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace patina::runtime {

// The unit direction through the middle of a texel.
inline glm::vec3 cube_direction(int face, int x, int y, int size) {
    float s = 2 * (float(x) + 0.5f) / float(size) - 1, t = 2 * (float(y) + 0.5f) / float(size) - 1;
    const glm::vec3 directions[6] = {{1, -t, -s}, {-1, -t, s}, {s, 1, t}, {s, -1, -t}, {s, -t, 1}, {-s, -t, -1}};
    return glm::normalize(directions[face]);
}

// Steradians that a texel covers, to the first order in its size.
inline float cube_solid_angle(int x, int y, int size) {
    float s = 2 * (float(x) + 0.5f) / float(size) - 1, t = 2 * (float(y) + 0.5f) / float(size) - 1;
    return 4 / float(size * size) / std::pow(1 + s * s + t * t, 1.5f);
}

}  // namespace patina::runtime
