#include "runtime/gltf/gltf_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <map>
#include <optional>
#include <set>
#include <tuple>

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

// Front faces stay counter-clockwise where an object is mirrored, as the specification demands.
void turn_round(Mesh& mesh) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
}

// In memory they are 1.5 GB. Primitives may share the numbers of the file, so a small file can have more.
constexpr std::size_t kMostVertices = std::size_t{1} << 24;

class ModelReading {
public:
    ModelReading(const tinygltf::Model& file, MeshDetail detail) : file_(file), detail_(detail) {}

    Outcome<GltfModel> run() {
        for (std::size_t i = 0; i < file_.nodes.size(); ++i) {
            made_.nodes.push_back({.name = name_of(i), .parent = {}});
            made_.nodes_by_name[made_.nodes.back().name].push_back(i);
        }
        for (std::size_t i = 0; i < file_.nodes.size(); ++i) {
            for (const int child : file_.nodes[i].children) made_.nodes[static_cast<std::size_t>(child)].parent = i;
        }
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
            ModelNode& node = made_.nodes[static_cast<std::size_t>(index)];
            node.first_part = made_.parts.size();
            if (std::string error = show(static_cast<std::size_t>(index)); !error.empty()) return Failure{error};
            node.part_count = made_.parts.size() - node.first_part;
            const std::vector<int>& children = file_.nodes[static_cast<std::size_t>(index)].children;
            shown.insert(shown.end(), children.rbegin(), children.rend());
        }
        return std::move(made_);
    }

private:
    std::string name_of(std::size_t node) const {
        const std::string& name = file_.nodes[node].name;
        return name.empty() ? "node " + std::to_string(node) : name;
    }

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
        if (node.camera >= 0) add_camera(index, static_cast<std::size_t>(node.camera));
        if (const auto found = node.extensions.find("KHR_lights_punctual"); found != node.extensions.end())
            add_light(index, static_cast<std::size_t>(found->second.Get("light").GetNumberAsInt()));
        return node.mesh < 0 ? std::string() : add_parts(index);
    }

    std::string add_parts(std::size_t index) {
        const tinygltf::Node& node = file_.nodes[index];
        const tinygltf::Mesh& mesh = file_.meshes[static_cast<std::size_t>(node.mesh)];
        // The place of a skinned mesh's own node has no meaning: its joints say where it is.
        const std::vector<glm::mat4> joints = node.skin < 0 ? std::vector<glm::mat4>() : joints_of(node.skin);
        const std::vector<double>& weights = node.weights.empty() ? mesh.weights : node.weights;
        const bool is_own = !joints.empty() || !node.weights.empty();
        const glm::mat4 place = joints.empty() ? places_[index] : glm::mat4(1);
        const bool is_mirrored = glm::determinant(glm::mat3(place)) < 0;
        if (is_own || counted_.emplace(node.mesh, is_mirrored).second) {
            for (const tinygltf::Primitive& each : mesh.primitives)
                vertices_ += has_triangles(each) ? vertices_of(each) : 0;
            if (vertices_ > kMostVertices)
                return fmt::format("meshes[{}]: with it the model has {} vertices, and the limit is {}", node.mesh,
                                   vertices_, kMostVertices);
        }
        for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
            const tinygltf::Primitive& primitive = mesh.primitives[i];
            const std::string where = "meshes[" + std::to_string(node.mesh) + "].primitives[" + std::to_string(i) + "]";
            if (!has_triangles(primitive)) {
                made_.left_out.push_back(where + ": points and lines are not drawn");
                continue;
            }
            std::shared_ptr<const Mesh> own;
            std::shared_ptr<const Mesh>& known = is_own ? own : known_[{node.mesh, static_cast<int>(i), is_mirrored}];
            if (!known) {
                Outcome<Mesh> read = primitive_mesh(file_, where, primitive, weights, joints, detail_);
                if (!read) return read.error;
                if (is_mirrored) turn_round(read.value);
                known = std::make_shared<const Mesh>(std::move(read.value));
            }
            made_.parts.push_back({.node = name_of(index),
                                   .node_index = index,
                                   .primitive = i,
                                   .mesh = known,
                                   .object_to_world = place,
                                   .material = primitive.material < 0
                                                   ? std::nullopt
                                                   : std::optional(static_cast<std::size_t>(primitive.material))});
        }
        return {};
    }

    // Without normals each corner of a triangle has a vertex of its own, and without tangents it may get one.
    std::size_t vertices_of(const tinygltf::Primitive& primitive) const {
        const auto count_of = [&](int accessor) { return file_.accessors[static_cast<std::size_t>(accessor)].count; };
        const std::size_t points = count_of(primitive.attributes.at("POSITION"));
        const bool keeps_points = primitive.attributes.contains("NORMAL") && primitive.attributes.contains("TANGENT");
        if (detail_ != MeshDetail::Whole || keeps_points) return points;
        const std::size_t listed = primitive.indices < 0 ? points : count_of(primitive.indices);
        const bool is_strip = primitive.mode != -1 && primitive.mode != TINYGLTF_MODE_TRIANGLES;
        return std::max(points, is_strip ? 3 * listed : listed);
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

    void add_camera(std::size_t index, std::size_t number) {
        const tinygltf::Camera& camera = file_.cameras[number];
        ModelCamera& made = made_.cameras.emplace_back();
        made.node = name_of(index);
        made.name = camera.name;
        made.index = number;
        made.camera_to_world = places_[index];
        made.is_orthographic = camera.type == "orthographic";
        made.fov = glm::degrees(static_cast<float>(camera.perspective.yfov));
        made.height = 2 * std::abs(static_cast<float>(camera.orthographic.ymag));
        made.near_plane =
            static_cast<float>(made.is_orthographic ? camera.orthographic.znear : camera.perspective.znear);
        made.far_plane = static_cast<float>(made.is_orthographic ? camera.orthographic.zfar : camera.perspective.zfar);
    }

    void add_light(std::size_t index, std::size_t number) {
        const tinygltf::Light& light = file_.lights[number];
        ModelLight& made = made_.lights.emplace_back();
        made.node = name_of(index);
        made.index = number;
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
    std::vector<glm::mat4> places_;  // of the nodes, in the world
    MeshDetail detail_;
    std::map<std::tuple<int, int, bool>, std::shared_ptr<const Mesh>> known_;  // by mesh, primitive and is_mirrored
    std::set<std::pair<int, bool>> counted_;                                   // by mesh and is_mirrored
    std::size_t vertices_ = 0;  // of all meshes so far; each use of one by a mirrored or bent node is another
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
    for (const std::uint32_t index : part.indices) whole.indices.push_back(first + index);
}

// "12", as it is written; nothing for "012" and "x".
std::optional<std::size_t> index_of_digits(std::string_view digits) {
    std::size_t number = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return digits == std::to_string(number) ? std::optional(number) : std::nullopt;
}

// The nodes with that name; if there are none, the node with that number, "node 3".
std::vector<std::size_t> nodes_named(const GltfModel& model, std::string_view name) {
    const auto found = model.nodes_by_name.find(std::string(name));
    if (found != model.nodes_by_name.end()) return found->second;
    const std::optional<std::size_t> number =
        name.starts_with("node ") ? index_of_digits(name.substr(5)) : std::nullopt;
    if (!number || *number >= model.nodes.size()) return {};
    return {*number};
}

// For each node, whether it is a node of `tops` or below one.
std::vector<bool> below(const GltfModel& model, const std::vector<std::size_t>& tops) {
    enum class State : std::uint8_t { Unknown, Not, Below };
    std::vector<State> states(model.nodes.size(), State::Unknown);
    for (const std::size_t top : tops) states[top] = State::Below;
    std::vector<std::size_t> path;
    for (std::size_t i = 0; i < states.size(); ++i) {
        std::optional<std::size_t> at = i;
        for (; at && states[*at] == State::Unknown; at = model.nodes[*at].parent) path.push_back(*at);
        const State found = at ? states[*at] : State::Not;
        for (const std::size_t each : path) states[each] = found;
        path.clear();
    }
    std::vector<bool> made(states.size());
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = states[i] == State::Below;
    return made;
}

}  // namespace

Outcome<GltfModel> model_of(const tinygltf::Model& file, MeshDetail detail) {
    return ModelReading(file, detail).run();
}

Outcome<GltfModel> read_model(const std::string& path) {
    Outcome<tinygltf::Model> file = open_gltf(path);
    if (!file) return Failure{file.error};
    Outcome<GltfModel> model = model_of(file.value);
    if (!model) return Failure{path + ": " + model.error};
    return model;
}

const ModelPart* find_part(const GltfModel& model, std::string_view name) {
    const std::size_t slash = name.rfind('/');
    if (slash == name.npos || !nodes_named(model, name).empty()) return nullptr;
    const std::vector<std::size_t> nodes = nodes_named(model, name.substr(0, slash));
    if (nodes.size() != 1) return nullptr;
    const std::optional<std::size_t> primitive = index_of_digits(name.substr(slash + 1));
    const ModelNode& owner = model.nodes[nodes[0]];
    for (std::size_t i = owner.first_part; i < owner.first_part + owner.part_count; ++i)
        if (model.parts[i].primitive == primitive) return &model.parts[i];
    return nullptr;
}

Outcome<Mesh> mesh_of(const GltfModel& model, const std::string& path, const std::string& node) {
    Mesh whole;
    if (const ModelPart* part = find_part(model, node)) {
        append(*part->mesh, part->object_to_world, whole);
        return whole;
    }
    std::vector<bool> wanted(model.nodes.size(), true);
    if (!node.empty()) {
        const std::vector<std::size_t> tops = nodes_named(model, node);
        if (tops.empty()) {
            std::string names;
            for (std::size_t i = 0; i < model.nodes.size() && names.size() < 200; ++i)
                names += (names.empty() ? "" : ", ") + model.nodes[i].name;
            return Failure{path + " has no node '" + node + "'; there are: " + names};
        }
        wanted = below(model, tops);
    }
    std::size_t count = 0;
    for (const ModelPart& part : model.parts) count += wanted[part.node_index] ? part.mesh->vertices.size() : 0;
    if (count > kMostVertices)
        return Failure{
            fmt::format("{}: as one mesh it has {} vertices, and the limit is {}", path, count, kMostVertices)};
    for (const ModelPart& part : model.parts) {
        if (wanted[part.node_index]) append(*part.mesh, part.object_to_world, whole);
    }
    if (whole.indices.empty()) return Failure{path + (node.empty() ? "" : "#" + node) + " has no triangles"};
    return whole;
}

Outcome<Mesh> read_mesh(const std::string& path, const std::string& node) {
    Outcome<GltfModel> model = read_model(path);
    if (!model) return Failure{model.error};
    return mesh_of(model.value, path, node);
}

bool is_model_name(std::string_view name) {
    const std::string_view file = name.substr(0, name.find('#'));
    return file.ends_with(".glb") || file.ends_with(".gltf");
}

}  // namespace patina::runtime
