#include "runtime/scene/scene.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <numbers>

#include "runtime/lighting/studio_lights.h"

namespace patina::runtime {

std::vector<Light> default_lights() {
    std::vector<Light> lights;
    for (const StudioLight& each : kStudioLights)
        lights.push_back({.direction = {each.direction[0], each.direction[1], each.direction[2]},
                          .color = {each.color[0], each.color[1], each.color[2]}});
    return lights;
}

Camera default_camera(std::string_view mesh) {
    // A cube shows three faces and a torus its roundness; the others are met head-on, so that pictures compare easily.
    glm::vec3 towards_camera(0, 0, 1);
    if (mesh == "cube") towards_camera = {0.65f, 0.55f, 1};
    if (mesh == "torus") towards_camera = {0.25f, 0.45f, 1};
    std::optional<Mesh> made = make_mesh(mesh);
    float radius = made ? bounding_radius(*made) : 1;
    // A square that faces the camera is framed by its sides: a circle around it would leave room to spare.
    if (mesh == "plane") radius /= std::numbers::sqrt2_v<float>;

    Camera camera;
    float margin = 1.12f;
    camera.position = glm::normalize(towards_camera) * (margin * radius / std::sin(glm::radians(camera.fov) / 2));
    return camera;
}

bool is_time(double seconds) {
    return std::abs(seconds) <= double(std::numeric_limits<float>::max());  // false for NaN
}

Scene default_scene(std::string_view mesh) {
    return {.mesh = make_mesh(mesh).value_or(Mesh{}),
            .camera = default_camera(mesh),
            .lights = default_lights(),
            .ambient = studio_environment()->ambient(),
            .environment = studio_environment()};
}

Scene fullscreen_scene(int width, int height) {
    return {.mesh = make_fullscreen(),
            .camera = {.clip_space = true},
            .width = width,
            .height = height,
            .background = glm::vec4(0)};
}

double exposure_for(const Scene& scene) {
    constexpr double kBrightest = 0.68;  // as in the studio
    const float intensity = scene.picture_intensity.value_or(0);
    if (intensity <= 0 || !scene.lights.empty()) return 0;
    if (scene.ambient.coefficients != scene.environment->ambient().coefficients) return 0;
    const double largest = largest_irradiance(scene.ambient) / intensity;
    return largest > 0 ? std::floor(std::log2(kBrightest / largest) * 100) / 100 : 0;
}

glm::mat4 world_to_view(const Camera& camera) {
    if (camera.clip_space) return glm::mat4(1);
    // Straight up or down, "up" is the way that was forward.
    const bool is_along_view = glm::cross(camera.target - camera.position, camera.up) == glm::vec3(0);
    return glm::lookAtRH(camera.position, camera.target, is_along_view ? glm::vec3(0, 0, -1) : camera.up);
}

glm::mat4 view_to_clip(const Camera& camera, float aspect) {
    if (camera.clip_space) return glm::mat4(1);
    const bool is_symmetric = camera.clip_depth == ClipDepth::Symmetric;
    // Swapped planes give 1 at the near one and 0 at the far one.
    const bool is_reversed = camera.clip_depth == ClipDepth::Reversed;
    const float at_zero = is_reversed ? camera.far_plane : camera.near_plane;
    const float at_one = is_reversed ? camera.near_plane : camera.far_plane;
    if (camera.orthographic_height) {
        float half = *camera.orthographic_height / 2;
        return (is_symmetric ? glm::orthoRH_NO<float> : glm::orthoRH_ZO<float>)(-half * aspect, half * aspect, -half,
                                                                                half, at_zero, at_one);
    }
    return (is_symmetric ? glm::perspectiveRH_NO<float> : glm::perspectiveRH_ZO<float>)(glm::radians(camera.fov),
                                                                                        aspect, at_zero, at_one);
}

}  // namespace patina::runtime
