// Meshes that enclose everything that a light reaches, so that a lighting pass is drawn only where the light can
// matter. They are closed, and front faces are counter-clockwise from outside, as in every mesh.
//
//   LightVolume volume = light_volume(light);   // mesh * object_to_world
#pragma once

#include <glm/glm.hpp>

#include "runtime/mesh/mesh.h"
#include "runtime/scene/view.h"

namespace patina::runtime {

struct LightVolume {
    const Mesh* mesh = nullptr;  // lives as long as the program
    glm::mat4 object_to_world{1};
};

// Of a point light: a round body that holds the sphere of its range. Of a spot: a pyramid around its outer cone as far
// as its range, or the round body if the cone is wide. A directional light has none: null.
LightVolume light_volume(const Light& light);

// The volume reaches before the near plane or behind the far one: some of it would be clipped.
bool is_clipped(const LightVolume& volume, const View& view);

// All that the view sees, as a volume of world space a little inside the near and the far plane: for a volume that is
// clipped.
Mesh view_volume(const View& view);

// Of 80 triangles, around the unit sphere.
Mesh make_ball_hull();
// Point at the origin, base at z = 1, around the cone whose base there has a radius of 1.
Mesh make_cone_hull();

}  // namespace patina::runtime
