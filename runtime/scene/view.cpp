#include "runtime/scene/view.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace patina::runtime {

View camera_view(const Scene& scene) {
    const Camera& camera = scene.camera;
    return {.world_to_view = world_to_view(camera),
            .view_to_clip = view_to_clip(camera, float(scene.width) / float(scene.height)),
            .position = camera.position,
            .forward = glm::normalize(camera.target - camera.position),
            .is_parallel = camera.orthographic_height.has_value() || camera.clip_space,
            .near_plane = camera.near_plane,
            .far_plane = camera.far_plane};
}

glm::mat4 world_to_light(const Light& light) {
    bool is_directional = light.kind == LightKind::Directional;
    glm::vec3 forward = is_directional ? -light.direction : light.direction;
    glm::vec3 eye = is_directional ? glm::vec3(0) : light.position;
    return world_to_view(Camera{.position = eye, .target = eye + glm::normalize(forward)});
}

glm::mat4 world_to_cookie(const Light& light) {
    glm::mat4 to_clip(1);
    if (light.kind == LightKind::Directional) {
        to_clip = glm::scale(glm::mat4(1), glm::vec3(2 / light.cookie_size, 2 / light.cookie_size, 1));
    } else {
        float side = 1 / std::tan(glm::radians(std::min(light.outer_angle, kWidestSpot)));
        to_clip[0][0] = to_clip[1][1] = side;
        to_clip[2][3] = -1;  // w: how far in front
        to_clip[3][3] = 0;
    }
    glm::mat4 to_uv = glm::translate(glm::mat4(1), {0.5f, 0.5f, 0}) * glm::scale(glm::mat4(1), {0.5f, -0.5f, 1});
    return to_uv * to_clip * world_to_light(light);
}

bool has_cookie(const Light& light) {
    return light.cookie && light.kind != LightKind::Point;
}

}  // namespace patina::runtime
