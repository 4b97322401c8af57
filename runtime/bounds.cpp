#include "runtime/bounds.h"

#include <algorithm>

namespace patina::runtime {

Sphere world_bounds(const Mesh& mesh, const glm::mat4& object_to_world) {
    if (mesh.vertices.empty()) return {.center = glm::vec3(object_to_world[3])};
    auto place = [&](const Vertex& vertex) { return glm::vec3(object_to_world * glm::vec4(vertex.position, 1)); };

    glm::vec3 lowest = place(mesh.vertices.front()), highest = lowest;
    for (const Vertex& vertex : mesh.vertices) {
        lowest = glm::min(lowest, place(vertex));
        highest = glm::max(highest, place(vertex));
    }
    Sphere sphere{.center = (lowest + highest) / 2.0f};
    for (const Vertex& vertex : mesh.vertices)
        sphere.radius = std::max(sphere.radius, glm::distance(sphere.center, place(vertex)));
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
