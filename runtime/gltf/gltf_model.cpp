#include "runtime/gltf/gltf_model.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <map>

#include "runtime/gltf/gltf_file.h"
#include "runtime/gltf/gltf_mesh.h"
#include "runtime/gltf/gltf_numbers.h"

namespace patina::runtime {
namespace {

glm::mat4 transform_of(const tinygltf::Node& node) {
    if (node.matrix.size() == 16) return glm::mat4(glm::make_mat4(node.matrix.data()));
    glm::dmat4 made(1);
    if (node.translation.size() == 3) made = glm::translate(made, glm::make_vec3(node.translation.data()));
    if (node.rotation.size() == 4) {
        const auto& r = node.rotation;
        const glm::dquat turn(r[3], r[0], r[1], r[2]);
        if (glm::length(turn) > 0) made *= glm::mat4_cast(glm::normalize(turn));
    }
    if (node.scale.size() == 3) made = glm::scale(made, glm::make_vec3(node.scale.data()));
    return glm::mat4(made);
}

class Reading {
public:
    explicit Reading(const tinygltf::Model& file) : file_(file) {}

    Outcome<GltfModel> run() {
        places_.assign(file_.nodes.size(), glm::mat4(1));
        const std::vector<int> roots = roots_of_scene();
        std::vector<std::pair<int, glm::mat4>> open;
        // Joints may lie outside of the scene, so all nodes have a place.
        for (const int root : all_roots()) open.emplace_back(root, glm::mat4(1));
        for (std::size_t i = 0; i < open.size(); ++i) {
            const auto [index, parent] = open[i];
            const tinygltf::Node& node = file_.nodes[static_cast<std::size_t>(index)];
            places_[static_cast<std::size_t>(index)] = parent * transform_of(node);
            for (const int child : node.children) open.emplace_back(child, places_[static_cast<std::size_t>(index)]);
        }
        std::vector<int> shown(roots.rbegin(), roots.rend());
        while (!shown.empty()) {
            const int index = shown.back();
            shown.pop_back();
            if (std::string error = show(static_cast<std::size_t>(index)); !error.empty()) return Failure{error};
            const std::vector<int>& children = file_.nodes[static_cast<std::size_t>(index)].children;
            shown.insert(shown.end(), children.rbegin(), children.rend());
        }
        return std::move(made_);
    }

    std::string name_of(std::size_t node) const {
        const std::string& name = file_.nodes[node].name;
        return name.empty() ? "node " + std::to_string(node) : name;
    }

private:
    std::vector<int> all_roots() const {
        std::vector<bool> is_child(file_.nodes.size());
        for (const tinygltf::Node& node : file_.nodes) {
            for (const int child : node.children) is_child[static_cast<std::size_t>(child)] = true;
        }
        std::vector<int> roots;
        for (std::size_t i = 0; i < is_child.size(); ++i) {
            if (!is_child[i]) roots.push_back(static_cast<int>(i));
        }
        return roots;
    }

    // A file without scenes shows all of its nodes.
    std::vector<int> roots_of_scene() const {
        if (file_.scenes.empty()) return all_roots();
        return file_.scenes[static_cast<std::size_t>(std::max(file_.defaultScene, 0))].nodes;
    }

    std::string show(std::size_t index) {
        const tinygltf::Node& node = file_.nodes[index];
        if (node.camera >= 0) add_camera(index, file_.cameras[static_cast<std::size_t>(node.camera)]);
        if (const auto found = node.extensions.find("KHR_lights_punctual"); found != node.extensions.end())
            add_light(index, file_.lights[static_cast<std::size_t>(found->second.Get("light").GetNumberAsInt())]);
        return node.mesh < 0 ? std::string() : add_parts(index);
    }

    std::string add_parts(std::size_t index) {
        const tinygltf::Node& node = file_.nodes[index];
        const tinygltf::Mesh& mesh = file_.meshes[static_cast<std::size_t>(node.mesh)];
        // The place of a skinned mesh's own node has no meaning: its joints say where it is.
        const std::vector<glm::mat4> joints = node.skin < 0 ? std::vector<glm::mat4>() : joints_of(node.skin);
        const std::vector<double>& weights = node.weights.empty() ? mesh.weights : node.weights;
        for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
            const tinygltf::Primitive& primitive = mesh.primitives[i];
            const std::string where = "meshes[" + std::to_string(node.mesh) + "].primitives[" + std::to_string(i) + "]";
            if (!has_triangles(primitive)) {
                made_.left_out.push_back(where + ": points and lines are not drawn");
                continue;
            }
            const bool is_own = !joints.empty() || !node.weights.empty();
            std::shared_ptr<const Mesh> known = is_own ? nullptr : known_[{node.mesh, static_cast<int>(i)}];
            if (!known) {
                Outcome<Mesh> read = primitive_mesh(file_, where, primitive, weights, joints);
                if (!read) return read.error;
                known = std::make_shared<const Mesh>(std::move(read.value));
                if (!is_own) known_[{node.mesh, static_cast<int>(i)}] = known;
            }
            made_.parts.push_back({.node = name_of(index),
                                   .mesh = known,
                                   .object_to_world = joints.empty() ? places_[index] : glm::mat4(1),
                                   .material = primitive.material < 0
                                                   ? std::nullopt
                                                   : std::optional(static_cast<std::size_t>(primitive.material))});
        }
        return {};
    }

    std::vector<glm::mat4> joints_of(int index) const {
        const tinygltf::Skin& skin = file_.skins[static_cast<std::size_t>(index)];
        std::vector<glm::mat4> made;
        Numbers inverse;
        if (skin.inverseBindMatrices >= 0) inverse = numbers_of(file_, skin.inverseBindMatrices);
        for (std::size_t i = 0; i < skin.joints.size(); ++i) {
            const glm::mat4 bind = inverse.values.empty() ? glm::mat4(1) : glm::make_mat4(&inverse.values[16 * i]);
            made.push_back(places_[static_cast<std::size_t>(skin.joints[i])] * bind);
        }
        return made;
    }

    void add_camera(std::size_t index, const tinygltf::Camera& camera) {
        ModelCamera& made = made_.cameras.emplace_back();
        made.node = name_of(index);
        made.camera_to_world = places_[index];
        made.is_orthographic = camera.type == "orthographic";
        made.fov = glm::degrees(static_cast<float>(camera.perspective.yfov));
        made.height = 2 * std::abs(static_cast<float>(camera.orthographic.ymag));
        made.near_plane =
            static_cast<float>(made.is_orthographic ? camera.orthographic.znear : camera.perspective.znear);
        made.far_plane = static_cast<float>(made.is_orthographic ? camera.orthographic.zfar : camera.perspective.zfar);
    }

    void add_light(std::size_t index, const tinygltf::Light& light) {
        ModelLight& made = made_.lights.emplace_back();
        made.node = name_of(index);
        made.kind = light.type == "directional" ? ModelLight::Kind::Directional
                    : light.type == "spot"      ? ModelLight::Kind::Spot
                                                : ModelLight::Kind::Point;
        made.light_to_world = places_[index];
        if (light.color.size() == 3) made.color = glm::make_vec3(light.color.data());
        made.intensity = static_cast<float>(light.intensity);
        made.range = static_cast<float>(light.range);
        made.inner_angle = glm::degrees(static_cast<float>(light.spot.innerConeAngle));
        made.outer_angle = glm::degrees(static_cast<float>(light.spot.outerConeAngle));
    }

    const tinygltf::Model& file_;
    std::vector<glm::mat4> places_;                                     // of the nodes, in the world
    std::map<std::pair<int, int>, std::shared_ptr<const Mesh>> known_;  // by mesh and primitive
    GltfModel made_;
};

void append(const Mesh& part, const glm::mat4& place, Mesh& whole) {
    const auto first = static_cast<std::uint32_t>(whole.vertices.size());
    const glm::mat3 turn(place);
    const bool is_mirrored = glm::determinant(turn) < 0;
    const glm::mat3 cofactors(glm::cross(turn[1], turn[2]), glm::cross(turn[2], turn[0]), glm::cross(turn[0], turn[1]));
    const auto unit = [](const glm::vec3& v, const glm::vec3& otherwise) {
        const float length = glm::length(v);
        return length > 0 ? v / length : otherwise;
    };
    for (Vertex vertex : part.vertices) {
        vertex.position = glm::vec3(place * glm::vec4(vertex.position, 1));
        vertex.normal = unit((is_mirrored ? -1.0f : 1.0f) * (cofactors * vertex.normal), vertex.normal);
        vertex.tangent = glm::vec4(unit(turn * glm::vec3(vertex.tangent), glm::vec3(vertex.tangent)),
                                   is_mirrored ? -vertex.tangent.w : vertex.tangent.w);
        whole.vertices.push_back(vertex);
    }
    for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
        const std::uint32_t a = part.indices[i], b = part.indices[i + 1], c = part.indices[i + 2];
        whole.indices.insert(whole.indices.end(),
                             {first + a, first + (is_mirrored ? c : b), first + (is_mirrored ? b : c)});
    }
}

// The nodes at and below the one of that name; nothing if there is none.
std::optional<std::vector<bool>> below(const tinygltf::Model& file, const std::string& name, const Reading& names) {
    std::vector<bool> made(file.nodes.size());
    std::vector<int> open;
    for (std::size_t i = 0; i < file.nodes.size(); ++i) {
        if (names.name_of(i) == name) open.push_back(static_cast<int>(i));
    }
    if (open.empty()) return {};
    while (!open.empty()) {
        const auto index = static_cast<std::size_t>(open.back());
        open.pop_back();
        made[index] = true;
        open.insert(open.end(), file.nodes[index].children.begin(), file.nodes[index].children.end());
    }
    return made;
}

}  // namespace

Outcome<GltfModel> read_model(const std::string& path) {
    Outcome<tinygltf::Model> file = open_gltf(path);
    if (!file) return Failure{file.error};
    Outcome<GltfModel> model = Reading(file.value).run();
    if (!model) return Failure{path + ": " + model.error};
    return model;
}

Outcome<Mesh> read_mesh(const std::string& path, const std::string& node) {
    Outcome<tinygltf::Model> file = open_gltf(path);
    if (!file) return Failure{file.error};
    Reading reading(file.value);
    Outcome<GltfModel> model = reading.run();
    if (!model) return Failure{path + ": " + model.error};
    const auto wanted = node.empty() ? std::nullopt : below(file.value, node, reading);
    std::string names;
    for (std::size_t i = 0; i < file.value.nodes.size() && names.size() < 200; ++i)
        names += (names.empty() ? "" : ", ") + reading.name_of(i);
    if (!node.empty() && !wanted) return Failure{path + " has no node '" + node + "'; there are: " + names};
    Mesh whole;
    for (const ModelPart& part : model.value.parts) {
        bool is_wanted = !wanted;
        for (std::size_t i = 0; wanted && i < wanted->size(); ++i)
            is_wanted = is_wanted || ((*wanted)[i] && reading.name_of(i) == part.node);
        if (is_wanted) append(*part.mesh, part.object_to_world, whole);
    }
    if (whole.indices.empty()) return Failure{path + (node.empty() ? "" : "#" + node) + " has no triangles"};
    return whole;
}

bool is_model_name(std::string_view name) {
    const std::string_view file = name.substr(0, name.find('#'));
    return file.ends_with(".glb") || file.ends_with(".gltf");
}

}  // namespace patina::runtime
