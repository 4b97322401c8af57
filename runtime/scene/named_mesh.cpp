#include "runtime/scene/named_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/gltf/gltf_model.h"
#include "runtime/mesh/framing.h"

namespace patina::runtime {

Outcome<Mesh> mesh_named(const std::string& name, int segments) {
    if (is_model_name(name)) {
        if (segments != 0)
            return Failure{"the mesh of a file has the triangles of the file: segments are of built-in meshes"};
        const std::size_t sharp = name.find('#');
        return read_mesh(name.substr(0, sharp), sharp == name.npos ? "" : name.substr(sharp + 1));
    }
    if (std::optional<Mesh> mesh = make_mesh(name, segments)) return std::move(*mesh);
    std::string names;
    for (std::string_view each : mesh_names()) names += (names.empty() ? "" : ", ") + std::string(each);
    return Failure{"there is no mesh '" + name + "'; there are: " + names + ", and files: model.glb, model.gltf#Node"};
}

Camera camera_for(const std::string& name, const Mesh& mesh) {
    if (!is_model_name(name)) return default_camera(name);
    glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
    for (const Vertex& vertex : mesh.vertices) {
        low = glm::min(low, vertex.position);
        high = glm::max(high, vertex.position);
    }
    const glm::vec3 middle = (low + high) / 2.0f;
    float radius = 0;
    for (const Vertex& vertex : mesh.vertices) radius = std::max(radius, glm::length(vertex.position - middle));
    Camera camera;
    const Framing framing = framing_of(middle, radius, camera.fov);
    camera.target = framing.target;
    camera.position = framing.position;
    camera.near_plane = framing.near_plane;
    camera.far_plane = framing.far_plane;
    return camera;
}

}  // namespace patina::runtime
