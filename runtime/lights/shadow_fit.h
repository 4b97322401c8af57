// The part of a scene that the shadow map of a directional light must contain: the visible points where one object can
// shadow another, or itself.
//
//   std::vector<ShadowObject> objects = {{.mesh = &ball, .object_to_world = turn}};
//   Extent extent = shadowed_extent(world_to_light(sun), objects, camera_view(scene), 30);
#pragma once

#include <optional>
#include <span>

#include "patina/reflection.h"
#include "runtime/mesh/mesh.h"
#include "runtime/scene/view.h"

namespace patina::runtime {

struct ShadowObject {
    const Mesh* mesh = nullptr;
    glm::mat4 object_to_world{1};
    bool casts = true;               // others only receive
    bool moves_vertices = false;     // its material does: a flat mesh need not be flat
    std::optional<Bounds> bounds{};  // within which it does
};

struct Extent {
    glm::vec3 lowest{0}, highest{0};  // view space of the light, whose z grows towards it; metres
};

// x and y: the casters as the light sees them, cut by the part of the camera's view that contains objects. This part
// ends at `farthest` metres along its axis (nothing: at its far plane). Nothing that is shadowed and seen lies outside,
// because a shadow falls along the light, within its caster's outline. A flat caster, such as a floor, counts only
// where there are objects behind it: on itself it throws no shadow. If no shadow is seen at all, it is that of all
// casters. z: all objects, so that those outside of the camera's view still cast into it.
Extent shadowed_extent(const glm::mat4& world_to_light, std::span<const ShadowObject> objects, const View& camera,
                       std::optional<float> farthest);

}  // namespace patina::runtime
