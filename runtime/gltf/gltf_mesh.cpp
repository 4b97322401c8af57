#include "runtime/gltf/gltf_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "runtime/gltf/gltf_numbers.h"
#include "runtime/mesh/tangents.h"

namespace patina::runtime {
namespace {

using Attributes = std::map<std::string, int>;

std::optional<int> find(const Attributes& attributes, const std::string& name) {
    const auto found = attributes.find(name);
    return found == attributes.end() ? std::nullopt : std::optional(found->second);
}

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// The corners of all triangles, three each. A strip turns every second one round.
std::vector<std::uint32_t> triangles_of(const std::vector<std::uint32_t>& corners, int mode) {
    if (mode == TINYGLTF_MODE_TRIANGLES || mode == -1)
        return {corners.begin(), corners.end() - static_cast<std::ptrdiff_t>(corners.size() % 3)};
    std::vector<std::uint32_t> made;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
            made.insert(made.end(), {corners[0], corners[i - 1], corners[i]});
        else
            made.insert(made.end(), {corners[i - 2], corners[i - 1 + i % 2], corners[i - i % 2]});
    }
    return made;
}

// Every triangle with vertices of its own, and its own normal.
Mesh flat(const Mesh& mesh) {
    Mesh made;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.vertices[mesh.indices[i]].position;
        const glm::vec3 normal = glm::cross(mesh.vertices[mesh.indices[i + 1]].position - a,
                                            mesh.vertices[mesh.indices[i + 2]].position - a);
        const float length = glm::length(normal);
        for (std::size_t k = 0; k < 3; ++k) {
            made.indices.push_back(static_cast<std::uint32_t>(made.vertices.size()));
            made.vertices.push_back(mesh.vertices[mesh.indices[i + k]]);
            made.vertices.back().normal = length > 0 ? normal / length : glm::vec3(0, 0, 1);
        }
    }
    return made;
}

class Reading {
public:
    Reading(const tinygltf::Model& model, const tinygltf::Primitive& primitive)
        : model_(model), primitive_(primitive), attributes_(primitive.attributes) {}

    Outcome<Mesh> run(const std::string& where, const std::vector<double>& weights,
                      const std::vector<glm::mat4>& joints, MeshDetail detail) {
        const std::vector<glm::vec3> positions = vectors<3>(model_, attributes_.at("POSITION"));
        mesh_.vertices.resize(positions.size());
        for (std::size_t i = 0; i < positions.size(); ++i) mesh_.vertices[i].position = positions[i];
        std::vector<std::uint32_t> corners;
        if (primitive_.indices >= 0) corners = indices_of(model_, primitive_.indices);
        for (const std::uint32_t corner : corners) {
            if (corner >= positions.size())
                return Failure{where + ".indices: vertex " + std::to_string(corner) + ", and there are " +
                               std::to_string(positions.size())};
        }
        const bool is_whole = detail == MeshDetail::Whole;
        const bool has_normals = is_whole && has("NORMAL"), has_tangents = has_normals && has("TANGENT");
        if (is_whole) {
            if (primitive_.indices < 0) {
                corners.resize(positions.size());
                std::iota(corners.begin(), corners.end(), 0u);
            }
            mesh_.indices = triangles_of(corners, primitive_.mode);
            take_attributes();
        }
        morph(weights, is_whole);
        if (!joints.empty()) {
            if (std::string error = bend(where, joints); !error.empty()) return Failure{error};
        }
        for (const Vertex& vertex : mesh_.vertices) {
            if (!is_finite(vertex.position)) return Failure{where + ".attributes.POSITION: a number is not finite"};
        }
        if (!is_whole) return std::move(mesh_);
        if (!has_normals) mesh_ = flat(mesh_);
        make_units();
        if (!has_tangents) mesh_ = with_tangents(mesh_);
        return std::move(mesh_);
    }

private:
    bool has(const std::string& name) const { return find(attributes_, name).has_value(); }

    template <int N, class Set>
    void take(const std::string& name, const Set& set, float missing = 0) {
        const std::optional<int> accessor = find(attributes_, name);
        if (!accessor) return;
        const auto values = vectors<N>(model_, *accessor, missing);
        for (std::size_t i = 0; i < std::min(values.size(), mesh_.vertices.size()); ++i)
            set(mesh_.vertices[i], values[i]);
    }

    // A tangent without a normal has no meaning.
    void take_attributes() {
        take<2>("TEXCOORD_0", [](Vertex& v, const glm::vec2& uv) { v.uv0 = v.uv1 = v.uv2 = v.uv3 = uv; });
        take<2>("TEXCOORD_1", [](Vertex& v, const glm::vec2& uv) { v.uv1 = uv; });
        take<2>("TEXCOORD_2", [](Vertex& v, const glm::vec2& uv) { v.uv2 = uv; });
        take<2>("TEXCOORD_3", [](Vertex& v, const glm::vec2& uv) { v.uv3 = uv; });
        take<4>(
            "COLOR_0", [](Vertex& v, const glm::vec4& color) { v.color = color; }, 1);
        take<3>("NORMAL", [](Vertex& v, const glm::vec3& normal) { v.normal = normal; });
        if (!has("NORMAL")) return;
        take<4>("TANGENT", [](Vertex& v, const glm::vec4& tangent) {
            v.tangent = {glm::vec3(tangent), tangent.w < 0 ? -1 : 1};
        });
    }

    void morph(const std::vector<double>& weights, bool is_whole) {
        for (std::size_t t = 0; t < std::min(weights.size(), primitive_.targets.size()); ++t) {
            const auto weight = static_cast<float>(weights[t]);
            if (weight == 0) continue;
            const auto add = [&](const std::string& name, const auto& to) {
                const std::optional<int> accessor = find(primitive_.targets[t], name);
                if (!accessor) return;
                const std::vector<glm::vec3> moves = vectors<3>(model_, *accessor);
                for (std::size_t i = 0; i < std::min(moves.size(), mesh_.vertices.size()); ++i)
                    to(mesh_.vertices[i], weight * moves[i]);
            };
            add("POSITION", [](Vertex& v, const glm::vec3& by) { v.position += by; });
            if (!is_whole) continue;
            add("NORMAL", [](Vertex& v, const glm::vec3& by) { v.normal += by; });
            add("TANGENT", [](Vertex& v, const glm::vec3& by) { v.tangent += glm::vec4(by, 0); });
        }
    }

    // Up to eight joints for each vertex, in two attributes.
    std::string bend(const std::string& where, const std::vector<glm::mat4>& joints) {
        std::vector<glm::mat4> sums(mesh_.vertices.size(), glm::mat4(0));
        bool is_bound = false;
        for (const char* set : {"0", "1"}) {
            const auto joint = find(attributes_, std::string("JOINTS_") + set);
            const auto weight = find(attributes_, std::string("WEIGHTS_") + set);
            if (!joint || !weight) continue;
            is_bound = true;
            const std::vector<glm::vec4> which = vectors<4>(model_, *joint), share = vectors<4>(model_, *weight);
            for (std::size_t i = 0; i < sums.size(); ++i) {
                for (int k = 0; k < 4; ++k) {
                    if (share[i][k] == 0) continue;
                    // An accessor of floats can hold any number.
                    const float index = which[i][k];
                    if (!(index >= 0 && index < static_cast<float>(joints.size())))
                        return where + ".attributes.JOINTS_" + set + ": joint " + fmt::format("{}", index) +
                               ", and the skin has " + std::to_string(joints.size());
                    sums[i] += share[i][k] * joints[static_cast<std::size_t>(index)];
                }
            }
        }
        if (!is_bound) return {};
        for (std::size_t i = 0; i < sums.size(); ++i) {
            Vertex& vertex = mesh_.vertices[i];
            const glm::mat3 turn(sums[i]);
            vertex.position = glm::vec3(sums[i] * glm::vec4(vertex.position, 1));
            // The cofactors: the inverse transpose times the determinant, which also exists for a flat matrix.
            const glm::mat3 cofactors(glm::cross(turn[1], turn[2]), glm::cross(turn[2], turn[0]),
                                      glm::cross(turn[0], turn[1]));
            vertex.normal = cofactors * vertex.normal;
            vertex.tangent = glm::vec4(turn * glm::vec3(vertex.tangent), vertex.tangent.w);
        }
        return {};
    }

    // Quantised and morphed vectors are not quite of length 1. What has no direction gets one.
    void make_units() {
        for (Vertex& vertex : mesh_.vertices) {
            const float length = glm::length(vertex.normal);
            vertex.normal = length > 0 && std::isfinite(length) ? vertex.normal / length : glm::vec3(0, 0, 1);
            const glm::vec3 tangent(vertex.tangent);
            const float extent = glm::length(tangent);
            if (extent > 0 && std::isfinite(extent))
                vertex.tangent = glm::vec4(tangent / extent, vertex.tangent.w);
            else
                vertex.tangent = glm::vec4(1, 0, 0, 1);
        }
    }

    const tinygltf::Model& model_;
    const tinygltf::Primitive& primitive_;
    const Attributes& attributes_;
    Mesh mesh_;
};

}  // namespace

bool has_triangles(const tinygltf::Primitive& primitive) {
    return primitive.mode == -1 || primitive.mode == TINYGLTF_MODE_TRIANGLES ||
           primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP || primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

Outcome<Mesh> primitive_mesh(const tinygltf::Model& model, const std::string& where,
                             const tinygltf::Primitive& primitive, const std::vector<double>& weights,
                             const std::vector<glm::mat4>& joints, MeshDetail detail) {
    return Reading(model, primitive).run(where, weights, joints, detail);
}

}  // namespace patina::runtime
