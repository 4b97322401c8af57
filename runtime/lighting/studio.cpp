#include "runtime/lighting/studio.h"

#include <cmath>

namespace patina::runtime {
namespace {

// A window of light, seen from the middle of the room.
struct SoftBox {
    glm::vec3 forward, right, up;  // to its middle, and along its sides
    float width, height;           // half of each, at a distance of 1
    glm::vec3 light;               // radiance
};
constexpr float kSoftness = 0.12f;  // of a box's edge, at a distance of 1

SoftBox soft_box(glm::vec3 towards, float width, float height, glm::vec3 light) {
    glm::vec3 forward = glm::normalize(towards), right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), forward));
    return {forward, right, glm::cross(forward, right), width, height, light};
}

glm::vec3 box_light(const SoftBox& box, glm::vec3 direction) {
    float depth = glm::dot(direction, box.forward);
    if (depth <= 0.05f) return glm::vec3(0);
    auto inside = [&](float at, float half) {
        return 1 - glm::smoothstep(half - kSoftness / 2, half + kSoftness / 2, std::abs(at));
    };
    float across = inside(glm::dot(direction, box.right) / depth, box.width);
    if (across == 0) return glm::vec3(0);
    return box.light * (across * inside(glm::dot(direction, box.up) / depth, box.height));
}

}  // namespace

glm::vec3 studio_radiance(glm::vec3 direction) {
    static const SoftBox kBoxes[] = {
        soft_box({-0.75f, 0.75f, 0.7f}, 0.42f, 0.42f, {1.12f, 1.08f, 1.02f}),
        soft_box({1, 0.15f, 0.35f}, 0.16f, 0.55f, {0.37f, 0.43f, 0.54f}),
        soft_box({0.5f, 0.55f, -0.9f}, 0.6f, 0.14f, {0.82f, 0.82f, 0.82f}),
    };
    const glm::vec3 sky(0.112f, 0.126f, 0.147f), horizon(0.048f, 0.048f, 0.05f), ground(0.022f, 0.02f, 0.018f);
    float up = direction.y;
    glm::vec3 sum = up > 0 ? glm::mix(horizon, sky, std::sqrt(up)) : glm::mix(horizon, ground, std::sqrt(-up));
    for (const SoftBox& box : kBoxes) sum += box_light(box, direction);
    return sum;
}

}  // namespace patina::runtime
