// Views of a scene as matrices: its camera, or a light while its shadow map is drawn; and the view space of a light.
// The conventions of clip space are those of scene.h.
//
//   View view = camera_view(scene);   glm::vec4 clip = view.view_to_clip * view.world_to_view * position;
#pragma once

#include <glm/glm.hpp>

#include "runtime/scene/scene.h"

namespace patina::runtime {

// Degrees from a spot's axis up to which a flat picture (cookie, shadow map) holds its cone: wider ones are cut there.
inline constexpr float kWidestSpot = 85;

struct View {
    glm::mat4 world_to_view{1}, view_to_clip{1};
    glm::vec3 position{0};        // world space
    glm::vec3 forward{0, 0, -1};  // unit
    bool is_parallel = false;     // orthographic, or clip space as it is
    float near_plane = 0, far_plane = 1;
    float bias = 0;         // a light's: metres that casters are moved away from it
    float normal_bias = 0;  // a light's: metres times w of clip space that casters are shrunk by, along their normals
};

View camera_view(const Scene& scene);

// View space of a light: it looks along -z, and +y is as much upwards as that allows. A directional light is at the
// world's origin. A point light looks where its `direction` points, like a spot.
glm::mat4 world_to_light(const Light& light);

// World -> texture coordinates of the light's cookie, after division by w: 0 to 1 from the top left, as the light sees
// the picture upright. A spot's picture fills the square around its outer cone, and w is the distance along the axis. A
// directional light's picture spans `cookie_size` metres around the world's origin and repeats, with w 1.
glm::mat4 world_to_cookie(const Light& light);

// Only these kinds have cookies that are pictures.
bool has_cookie(const Light& light);

}  // namespace patina::runtime
