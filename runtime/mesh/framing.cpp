#include "runtime/mesh/framing.h"

#include <cmath>

namespace patina::runtime {

Framing framing_of(const glm::vec3& middle, float radius, float fov) {
    const float distance = 1.08f * (radius > 0 ? radius : 1) / std::sin(glm::radians(fov) / 2);
    return {.position = middle + glm::normalize(glm::vec3(0.45f, 0.3f, 1)) * distance,
            .target = middle,
            .near_plane = distance / 100,
            .far_plane = 4 * distance};
}

}  // namespace patina::runtime
