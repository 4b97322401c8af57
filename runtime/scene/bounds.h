// Bounding spheres of objects: the only shape information that lights, shadow maps and the drawing order need.
//
//   Sphere sphere = world_bounds(*object.mesh, object.object_to_world);
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "patina/reflection.h"
#include "runtime/mesh/mesh.h"

namespace patina::runtime {

struct Sphere {
    glm::vec3 center{0};  // world space, metres
    float radius = 0;
};

// Points that span everything that is drawn, in object space: the mesh's vertices; or, if the material declares bounds,
// the corners of that box. No vertices: the origin.
std::vector<glm::vec3> bounding_points(const Mesh& mesh, const std::optional<Bounds>& bounds = {});

// Holds all of these points; centred on the middle of their box, so it need not be the smallest.
Sphere world_bounds(const Mesh& mesh, const glm::mat4& object_to_world, const std::optional<Bounds>& bounds = {});

// Holds all of them, centred on the middle of their box. None: a point at the origin.
Sphere bounds_of(std::span<const Sphere> spheres);

}  // namespace patina::runtime
