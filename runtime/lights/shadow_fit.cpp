#include "runtime/lights/shadow_fit.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "runtime/scene/bounds.h"

namespace patina::runtime {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr Extent kNothing{glm::vec3(kInfinity), glm::vec3(-kInfinity)};
constexpr float kFlat = 1e-5f;  // of an object's size: less is rounding

using Corners = std::array<glm::vec3, 8>;

bool is_empty(const Extent& extent) {
    return extent.lowest.x > extent.highest.x || extent.lowest.y > extent.highest.y;
}

void include(Extent& extent, const Extent& other) {
    extent.lowest = glm::min(extent.lowest, other.lowest);
    extent.highest = glm::max(extent.highest, other.highest);
}

void include(Extent& extent, glm::vec3 point) {
    include(extent, {point, point});
}

Extent common_part(const Extent& a, const Extent& b) {
    return {glm::max(a.lowest, b.lowest), glm::min(a.highest, b.highest)};
}

glm::vec3 moved(const glm::mat4& transform, glm::vec3 point) {
    return glm::vec3(transform * glm::vec4(point, 1));
}

Corners corners_of(const Extent& box) {
    Corners corners{};
    for (std::size_t i = 0; i < corners.size(); i++)
        corners[i] = {i & 1 ? box.highest.x : box.lowest.x, i & 2 ? box.highest.y : box.lowest.y,
                      i & 4 ? box.highest.z : box.lowest.z};
    return corners;
}

// An object as the light sees it.
struct Placed {
    bool casts = true;
    bool is_flat = false;
    Extent extent = kNothing;
    Corners corners{};           // of its own box
    glm::vec3 towards_light{0};  // flat: the unit normal on the light's side
    float size = 0;              // of its box
};

Placed placed(const ShadowObject& object, const glm::mat4& world_to_light) {
    const glm::mat4 to_light = world_to_light * object.object_to_world;
    Placed made{.casts = object.casts};
    Extent own = kNothing;
    for (glm::vec3 point : bounding_points(*object.mesh, object.bounds)) {
        include(own, point);
        include(made.extent, moved(to_light, point));
    }
    made.corners = corners_of(own);
    const glm::vec3 size = own.highest - own.lowest;
    const int thin = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
    for (glm::vec3& corner : made.corners) corner = moved(to_light, corner);
    made.size = glm::distance(made.corners.front(), made.corners.back());
    if ((object.moves_vertices && !object.bounds) || size[thin] > kFlat * glm::length(size)) return made;

    const glm::vec3 normal = glm::cross(glm::vec3(to_light[(thin + 1) % 3]), glm::vec3(to_light[(thin + 2) % 3]));
    if (!(glm::length(normal) > 0)) return made;
    made.is_flat = true;
    made.towards_light = glm::normalize(normal.z < 0 ? -normal : normal);
    return made;
}

// Some of the object may lie behind the flat caster.
bool is_behind(const Placed& object, const Placed& flat) {
    const float plane = glm::dot(flat.corners.front(), flat.towards_light);
    return std::any_of(object.corners.begin(), object.corners.end(), [&](glm::vec3 corner) {
        return glm::dot(corner, flat.towards_light) < plane - kFlat * flat.size;
    });
}

Extent where_shadows_can_be(std::span<const Placed> objects) {
    Extent all = kNothing;
    for (const Placed& caster : objects) {
        if (!caster.casts) continue;
        if (!caster.is_flat) {
            include(all, caster.extent);
            continue;
        }
        for (const Placed& object : objects) {
            if (&object == &caster || !is_behind(object, caster)) continue;
            const Extent both = common_part(caster.extent, object.extent);
            if (!is_empty(both)) include(all, both);
        }
    }
    return all;
}

// The camera's view between its near and its far plane, or as much of it as has objects.
Extent seen_extent(const glm::mat4& world_to_light, std::span<const Placed> objects, const View& camera,
                   std::optional<float> farthest) {
    const glm::mat4 clip_to_view = glm::inverse(camera.view_to_clip);
    const glm::mat4 view_to_light = world_to_light * glm::inverse(camera.world_to_view);
    const glm::mat4 light_to_view = glm::inverse(view_to_light);
    float nearest_object = kInfinity, farthest_object = -kInfinity;  // along the camera's axis
    for (const Placed& object : objects) {
        for (glm::vec3 corner : object.corners) {
            const float depth = -moved(light_to_view, corner).z;
            nearest_object = std::min(nearest_object, depth);
            farthest_object = std::max(farthest_object, depth);
        }
    }
    if (farthest) farthest_object = std::min(farthest_object, *farthest);

    Extent seen = kNothing;
    for (float x : {-1.0f, 1.0f}) {
        for (float y : {-1.0f, 1.0f}) {
            const glm::vec4 near_corner = clip_to_view * glm::vec4(x, y, 0, 1);
            const glm::vec4 far_corner = clip_to_view * glm::vec4(x, y, 1, 1);
            const glm::vec3 first = glm::vec3(near_corner) / near_corner.w, last = glm::vec3(far_corner) / far_corner.w;
            for (float depth : {nearest_object, farthest_object}) {
                const float share = std::clamp((-depth - first.z) / (last.z - first.z), 0.0f, 1.0f);
                include(seen, moved(view_to_light, glm::mix(first, last, share)));
            }
        }
    }
    return seen;
}

}  // namespace

Extent shadowed_extent(const glm::mat4& world_to_light, std::span<const ShadowObject> objects, const View& camera,
                       std::optional<float> farthest) {
    std::vector<Placed> all;
    Extent everything = kNothing, casters = kNothing;
    for (const ShadowObject& object : objects) {
        all.push_back(placed(object, world_to_light));
        include(everything, all.back().extent);
        if (object.casts) include(casters, all.back().extent);
    }
    if (is_empty(casters)) return {};
    Extent extent = common_part(where_shadows_can_be(all), seen_extent(world_to_light, all, camera, farthest));
    if (is_empty(extent)) extent = casters;
    extent.lowest.z = everything.lowest.z;
    extent.highest.z = everything.highest.z;
    return extent;
}

}  // namespace patina::runtime
