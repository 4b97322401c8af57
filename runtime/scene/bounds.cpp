#include "runtime/scene/bounds.h"

#include <algorithm>

namespace patina::runtime {

std::vector<glm::vec3> bounding_points(const Mesh& mesh, const std::optional<Bounds>& bounds) {
    std::vector<glm::vec3> points;
    for (const Vertex& vertex : mesh.vertices) points.push_back(vertex.position);
    if (points.empty()) points.emplace_back(0);
    if (!bounds) return points;
    glm::vec3 lowest = points.front(), highest = lowest;
    for (glm::vec3 point : points) {
        lowest = glm::min(lowest, point);
        highest = glm::max(highest, point);
    }
    lowest -= float(bounds->margin);
    highest += float(bounds->margin);
    for (int i = 0; bounds->box && i < 3; i++) {
        lowest[i] = float((*bounds->box)[0][std::size_t(i)]);
        highest[i] = float((*bounds->box)[1][std::size_t(i)]);
    }
    points.clear();
    for (int corner = 0; corner < 8; corner++)
        points.emplace_back(corner & 1 ? highest.x : lowest.x, corner & 2 ? highest.y : lowest.y,
                            corner & 4 ? highest.z : lowest.z);
    return points;
}

Sphere world_bounds(const Mesh& mesh, const glm::mat4& object_to_world, const std::optional<Bounds>& bounds) {
    std::vector<glm::vec3> points = bounding_points(mesh, bounds);
    for (glm::vec3& point : points) point = glm::vec3(object_to_world * glm::vec4(point, 1));
    glm::vec3 lowest = points.front(), highest = lowest;
    for (glm::vec3 point : points) {
        lowest = glm::min(lowest, point);
        highest = glm::max(highest, point);
    }
    Sphere sphere{.center = (lowest + highest) / 2.0f};
    for (glm::vec3 point : points) sphere.radius = std::max(sphere.radius, glm::distance(sphere.center, point));
    return sphere;
}

Sphere bounds_of(std::span<const Sphere> spheres) {
    if (spheres.empty()) return {};
    glm::vec3 lowest = spheres.front().center, highest = lowest;
    for (const Sphere& sphere : spheres) {
        lowest = glm::min(lowest, sphere.center - sphere.radius);
        highest = glm::max(highest, sphere.center + sphere.radius);
    }
    Sphere all{.center = (lowest + highest) / 2.0f};
    for (const Sphere& sphere : spheres)
        all.radius = std::max(all.radius, glm::distance(all.center, sphere.center) + sphere.radius);
    return all;
}

}  // namespace patina::runtime
