#include "runtime/lights/light_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace patina::runtime {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr float kRoom = 1.0005f;  // for what rounding does to a face that touches the sphere
constexpr int kConeSides = 16;
constexpr float kWidestCone = 60;  // degrees from the axis: beyond, the round body is the smaller one

Mesh mesh_of(std::span<const glm::vec3> positions, std::span<const Triangle> triangles) {
    Mesh mesh;
    for (const glm::vec3& position : positions)
        mesh.vertices.push_back({.position = position,
                                 .normal = glm::normalize(position + glm::vec3(0, 1e-6f, 0)),
                                 .tangent = {1, 0, 0, 1},
                                 .uv0 = glm::vec2(0)});
    for (const Triangle& triangle : triangles)
        mesh.indices.insert(mesh.indices.end(), triangle.begin(), triangle.end());
    return mesh;
}

// How far the plane of a face is from the origin.
float plane_distance(const std::vector<glm::vec3>& positions, const Triangle& face) {
    glm::vec3 a = positions[face[0]], b = positions[face[1]], c = positions[face[2]];
    return glm::dot(glm::normalize(glm::cross(b - a, c - a)), a);
}

// Each face in four, with the new corners on the sphere.
void subdivide(std::vector<glm::vec3>& positions, std::vector<Triangle>& faces) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    auto middle = [&](std::uint32_t a, std::uint32_t b) {
        auto [found, is_new] = middles.try_emplace(std::minmax(a, b), std::uint32_t(positions.size()));
        if (is_new) positions.push_back(glm::normalize(positions[a] + positions[b]));
        return found->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : faces) {
        std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    faces = std::move(finer);
}

}  // namespace

Mesh make_ball_hull() {
    const float g = std::numbers::phi_v<float>;
    std::vector<glm::vec3> positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                        {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    std::vector<Triangle> faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                   {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                   {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (glm::vec3& position : positions) position = glm::normalize(position);
    subdivide(positions, faces);

    float nearest = 1;
    for (const Triangle& face : faces) nearest = std::min(nearest, plane_distance(positions, face));
    for (glm::vec3& position : positions) position *= kRoom / nearest;
    return mesh_of(positions, faces);
}

Mesh make_cone_hull() {
    // A regular polygon around a circle.
    const float radius = kRoom / std::cos(std::numbers::pi_v<float> / kConeSides);
    std::vector<glm::vec3> positions = {{0, 0, 0}, {0, 0, kRoom}};
    std::vector<Triangle> faces;
    for (std::uint32_t i = 0; i < kConeSides; i++) {
        float angle = 2 * std::numbers::pi_v<float> * float(i) / kConeSides;
        positions.push_back(kRoom * glm::vec3(radius * std::cos(angle), radius * std::sin(angle), 1));
        std::uint32_t here = 2 + i, next = 2 + (i + 1) % kConeSides;
        faces.push_back({0, next, here});
        faces.push_back({1, here, next});
    }
    return mesh_of(positions, faces);
}

LightVolume light_volume(const Light& light) {
    static const Mesh kBall = make_ball_hull(), kCone = make_cone_hull();
    if (light.kind == LightKind::Directional) return {};
    glm::mat4 placed(1);
    placed[3] = glm::vec4(light.position, 1);
    if (light.kind == LightKind::Point || light.outer_angle > kWidestCone) {
        for (int i = 0; i < 3; i++) placed[i][i] = light.range;
        return {.mesh = &kBall, .object_to_world = placed};
    }
    const glm::vec3 axis = glm::normalize(light.direction);
    const glm::vec3 aside = std::abs(axis.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right = glm::normalize(glm::cross(aside, axis));
    const float radius = light.range * std::tan(glm::radians(light.outer_angle));
    placed[0] = glm::vec4(right * radius, 0);
    placed[1] = glm::vec4(glm::cross(axis, right) * radius, 0);
    placed[2] = glm::vec4(axis * light.range, 0);
    return {.mesh = &kCone, .object_to_world = placed};
}

bool is_clipped(const LightVolume& volume, const View& view) {
    const glm::mat4 to_clip = view.view_to_clip * view.world_to_view * volume.object_to_world;
    return std::any_of(volume.mesh->vertices.begin(), volume.mesh->vertices.end(), [&](const Vertex& vertex) {
        glm::vec4 clip = to_clip * glm::vec4(vertex.position, 1);
        return clip.z < 0 || clip.z > clip.w;
    });
}

Mesh view_volume(const View& view) {
    // Depths that rounding keeps inside, the second near the far plane of a perspective; sides that lose no pixel.
    constexpr float kNear = 1e-4f, kFar = 1 - 1e-6f, kSide = 1.01f;
    const glm::mat4 to_world = glm::inverse(view.view_to_clip * view.world_to_view);
    std::vector<glm::vec3> positions;
    for (float z : {kNear, kFar}) {
        for (auto [x, y] : {std::pair(-kSide, -kSide), {kSide, -kSide}, {kSide, kSide}, {-kSide, kSide}}) {
            glm::vec4 corner = to_world * glm::vec4(x, y, z, 1);
            positions.push_back(glm::vec3(corner) / corner.w);
        }
    }
    // The near face first, then the far one; counter-clockwise from outside.
    const std::array<Triangle, 12> faces = {{{0, 1, 2},
                                             {0, 2, 3},
                                             {5, 4, 7},
                                             {5, 7, 6},
                                             {4, 0, 3},
                                             {4, 3, 7},
                                             {1, 5, 6},
                                             {1, 6, 2},
                                             {3, 2, 6},
                                             {3, 6, 7},
                                             {4, 5, 1},
                                             {4, 1, 0}}};
    return mesh_of(positions, faces);
}

}  // namespace patina::runtime
