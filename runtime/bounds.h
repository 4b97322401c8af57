// Spheres that hold objects: all that lights, shadow maps and the order of drawing need to know of a shape.
//
//   Sphere sphere = world_bounds(*object.mesh, object.object_to_world);
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "runtime/mesh.h"

namespace patina::runtime {

struct Sphere {
    glm::vec3 center{0};  // world space, metres
    float radius = 0;
};

// Holds every vertex; centred on the middle of their box, so it need not be the smallest. No vertices: a point at the
// object's origin.
Sphere world_bounds(const Mesh& mesh, const glm::mat4& object_to_world);

// Holds all of them, centred on the middle of their box. None: a point at the origin.
Sphere bounds_of(std::span<const Sphere> spheres);

}  // namespace patina::runtime
