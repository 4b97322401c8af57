// A glTF file as what it shows: meshes at their places in the default scene, cameras and lights. Skins and morph
// targets are in their rest pose: the joints where the nodes are, the weights that the file states.
//
//   Outcome<GltfModel> model = read_model("chair.glb");
//   Outcome<Mesh> seat = read_mesh("chair.glb", "Seat");
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/mesh/mesh.h"
#include "runtime/outcome.h"

namespace patina::runtime {

struct ModelPart {
    std::string node;                  // its name; "node 3" if it has none
    std::shared_ptr<const Mesh> mesh;  // shared by nodes that show the same primitive
    glm::mat4 object_to_world{1};
    std::optional<std::size_t> material;  // index into the file's materials
};

struct ModelCamera {
    std::string node;
    glm::mat4 camera_to_world{1};         // it looks along its -z, with y up
    float fov = 0;                        // degrees, vertical; of a perspective camera
    float height = 0;                     // world units; of an orthographic one
    float near_plane = 0, far_plane = 0;  // far: 0 if there is none
    bool is_orthographic = false;
};

// KHR_lights_punctual. Intensities are in candela, or lux for directional lights.
struct ModelLight {
    enum class Kind { Directional, Point, Spot };
    std::string node;
    Kind kind = Kind::Point;
    glm::mat4 light_to_world{1};  // it shines along its -z
    glm::vec3 color{1};           // linear
    float intensity = 1;
    float range = 0;                          // metres; 0: without end
    float inner_angle = 0, outer_angle = 45;  // degrees from the axis
};

struct GltfModel {
    std::vector<ModelPart> parts;
    std::vector<ModelCamera> cameras;
    std::vector<ModelLight> lights;
    std::vector<std::string> left_out;  // what the file has and is not read, in words
};

// Errors name the file and the place in it.
Outcome<GltfModel> read_model(const std::string& path);

// One mesh of all that the file shows, or of one node and what is below it, in the space of the file's scene. Materials
// are not told apart. Without triangles or without the node it is a failure that names the nodes.
Outcome<Mesh> read_mesh(const std::string& path, const std::string& node = {});

// True for the name of a file of this format, with a node or without: "chair.glb", "chair.gltf#Seat".
bool is_model_name(std::string_view name);

}  // namespace patina::runtime
