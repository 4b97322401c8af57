// The place from which a thing is seen whole: a little from above and from the right.
//
//   const Framing framing = framing_of(middle, radius, 30);
//   Camera camera{.position = framing.position, .target = framing.target};
#pragma once

#include <glm/glm.hpp>

namespace patina::runtime {

struct Framing {
    glm::vec3 position{0, 0, 4}, target{0};
    float near_plane = 0.05f, far_plane = 100;
};

// `radius`: of a sphere around `middle` that holds the thing; 0 counts as 1. `fov`: the camera's, vertical, in degrees.
Framing framing_of(const glm::vec3& middle, float radius, float fov);

}  // namespace patina::runtime
