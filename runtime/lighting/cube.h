// The texels of a cube map as directions of the world (Vulkan, "Cube Map Face Selection"): faces in the order +X, -X,
// +Y, -Y, +Z, -Z, rows from the top of the stored face.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace patina::runtime {

// The unit direction through a place on a face. `s`, `t`: to the right and down, from -1 to 1.
inline glm::vec3 cube_direction(int face, float s, float t) {
    const glm::vec3 directions[6] = {{1, -t, -s}, {-1, -t, s}, {s, 1, t}, {s, -1, -t}, {s, -t, 1}, {-s, -t, -1}};
    return glm::normalize(directions[face]);
}
// The same through the middle of a texel.
inline glm::vec3 cube_direction(int face, int x, int y, int size) {
    return cube_direction(face, 2 * (float(x) + 0.5f) / float(size) - 1, 2 * (float(y) + 0.5f) / float(size) - 1);
}

// Where a direction meets the cube: the face, and the place on it from 0 to 1.
struct CubePlace {
    int face = 0;
    float u = 0, v = 0;
};
inline CubePlace cube_place(glm::vec3 d) {
    glm::vec3 size = glm::abs(d);
    auto place = [](int face, float s, float t, float major) -> CubePlace {
        return {face, 0.5f * (s / major + 1), 0.5f * (t / major + 1)};
    };
    if (size.z >= size.x && size.z >= size.y)
        return d.z >= 0 ? place(4, d.x, -d.y, size.z) : place(5, -d.x, -d.y, size.z);
    if (size.y >= size.x) return d.y >= 0 ? place(2, d.x, d.z, size.y) : place(3, d.x, -d.z, size.y);
    return d.x >= 0 ? place(0, -d.z, -d.y, size.x) : place(1, d.z, -d.y, size.x);
}

// Steradians that a texel covers, to the first order in its size.
inline float cube_solid_angle(int x, int y, int size) {
    float s = 2 * (float(x) + 0.5f) / float(size) - 1, t = 2 * (float(y) + 0.5f) / float(size) - 1;
    return 4 / float(size * size) / std::pow(1 + s * s + t * t, 1.5f);
}

}  // namespace patina::runtime
