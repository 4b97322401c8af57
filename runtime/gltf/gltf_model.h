// The content of a glTF file: meshes with their positions in the default scene, cameras and lights. Skins and morph
// targets are in their rest pose: the joints where the nodes are, the weights that the file states.
//
//   Outcome<GltfModel> model = read_model("chair.glb");
//   Outcome<Mesh> seat = read_mesh("chair.glb", "Seat");
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "runtime/mesh/mesh.h"
#include "runtime/outcome.h"

namespace tinygltf {
class Model;
}

namespace patina::runtime {

// What is read of a mesh. Places: the positions of the vertices and nothing else, without triangles.
enum class MeshDetail { Whole, Places };

struct ModelPart {
    std::string node;                           // its name; "node 3" if it has none
    std::size_t node_index = 0, primitive = 0;  // in the file; the latter of the node's mesh
    std::shared_ptr<const Mesh> mesh;           // shared by nodes that show the same primitive
    glm::mat4 object_to_world{1};               // may mirror: then the mesh's triangles are turned round
    std::optional<std::size_t> material;        // index into the file's materials
};

struct ModelCamera {
    std::string node, name;               // the node's; the camera's own, which may be empty
    std::size_t index = 0;                // in the file's cameras
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
    std::size_t index = 0;  // in the file's lights
    Kind kind = Kind::Point;
    glm::mat4 light_to_world{1};  // it shines along its -z
    glm::vec3 color{1};           // linear
    float intensity = 1;
    float range = 0;                          // metres; 0: without end
    float inner_angle = 0, outer_angle = 45;  // degrees from the axis
};

struct ModelNode {
    std::string name;                            // "node 3" if it has none
    std::optional<std::size_t> parent;           // index of a node
    std::size_t first_part = 0, part_count = 0;  // in GltfModel::parts
};

struct GltfModel {
    std::vector<ModelNode> nodes;  // all of the file
    std::unordered_map<std::string, std::vector<std::size_t>> nodes_by_name;
    std::vector<ModelPart> parts;
    std::vector<ModelCamera> cameras;
    std::vector<ModelLight> lights;
    std::vector<std::string> left_out;  // what the file has and is not read, in words
};

// Errors name the file and the place in it.
Outcome<GltfModel> read_model(const std::string& path);
// Of a file that has been opened (gltf_file.h); errors name the place in it.
Outcome<GltfModel> model_of(const tinygltf::Model& file, MeshDetail detail = MeshDetail::Whole);

// One mesh of everything that the file shows, or of one node with all nodes below it, in the space of the file's scene.
// Materials are not distinguished. "Seat/1" is primitive 1 of the node alone, and "node 3/0" that of a node by its
// number. Without triangles or without the node it is a failure that names the nodes. `path`: for messages.
Outcome<Mesh> mesh_of(const GltfModel& model, const std::string& path, const std::string& node = {});
Outcome<Mesh> read_mesh(const std::string& path, const std::string& node = {});
// The primitive of one node, "Seat/1", in the mesh's own space; null: the name means something else, or nothing.
const ModelPart* find_part(const GltfModel& model, std::string_view name);

// True for the name of a file of this format, with a node or without: "chair.glb", "chair.gltf#Seat".
bool is_model_name(std::string_view name);

}  // namespace patina::runtime
