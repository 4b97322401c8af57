// Tangents that are computed for a mesh: those of the built-in meshes, which are known in closed form, and the rules of
// MikkTSpace for what is between triangles.
#include "runtime/mesh/tangents.h"

#include <gtest/gtest.h>

#include <cmath>

namespace patina::runtime {
namespace {

Mesh without_tangents(Mesh mesh) {
    for (Vertex& vertex : mesh.vertices) vertex.tangent = glm::vec4(0);
    return mesh;
}

// The average over the triangles around is the tangent of the surface. Along a seam of the texture only one side has
// triangles, and their chord is off by half of one of 192 segments.
TEST(Tangents, OfTheBuiltInMeshesAreTheirOwn) {
    for (const std::string_view name : {"sphere", "plane", "cube", "capsule", "torus"}) {
        const Mesh known = make_mesh(name).value();
        const Mesh made = with_tangents(without_tangents(known));
        ASSERT_EQ(made.indices.size(), known.indices.size()) << name;
        double worst = 1;
        for (std::size_t i = 0; i < known.indices.size(); ++i) {
            const Vertex &a = known.vertices[known.indices[i]], &b = made.vertices[made.indices[i]];
            ASSERT_EQ(a.position, b.position);
            ASSERT_EQ(a.tangent.w, b.tangent.w) << name;
            EXPECT_NEAR(glm::length(glm::vec3(b.tangent)), 1, 1e-5) << name;
            EXPECT_NEAR(glm::dot(glm::vec3(b.tangent), b.normal), 0, 1e-5) << name;
            // At the poles, where each column has a vertex of its own, one triangle alone says it.
            const bool is_pole = std::abs(b.normal.y) > 0.9999f;
            if (!is_pole) worst = std::min(worst, double(glm::dot(glm::vec3(a.tangent), glm::vec3(b.tangent))));
        }
        EXPECT_GT(worst, std::cos(1.001 * std::acos(-1.0) / 192)) << name;
    }
}

Mesh mesh_of(std::vector<Vertex> vertices, std::vector<std::uint32_t> indices) {
    return {.vertices = std::move(vertices), .indices = std::move(indices)};
}
Vertex flat(float x, float y, float u, float v) {
    return {.position = {x, y, 0}, .normal = {0, 0, 1}, .tangent = glm::vec4(0), .uv0 = {u, v}};
}

// u grows to the right and v downwards: the bitangent, up in the picture, is cross(normal, tangent).
TEST(Tangents, FollowTheTexture) {
    const Mesh upright = with_tangents(mesh_of({flat(0, 0, 0, 1), flat(1, 0, 1, 1), flat(1, 1, 1, 0)}, {0, 1, 2}));
    for (const Vertex& v : upright.vertices) EXPECT_EQ(v.tangent, glm::vec4(1, 0, 0, 1));
    // A quarter turn: u grows upwards, v to the right.
    const Mesh turned = with_tangents(mesh_of({flat(0, 0, 0, 0), flat(1, 0, 0, 1), flat(1, 1, 1, 1)}, {0, 1, 2}));
    for (const Vertex& v : turned.vertices) EXPECT_EQ(v.tangent, glm::vec4(0, 1, 0, 1));
    const Mesh mirrored = with_tangents(mesh_of({flat(0, 0, 1, 1), flat(1, 0, 0, 1), flat(1, 1, 0, 0)}, {0, 1, 2}));
    for (const Vertex& v : mirrored.vertices) EXPECT_EQ(v.tangent, glm::vec4(-1, 0, 0, -1));
}

// Two halves with mirrored textures meet in an edge: its vertices have the same uv0, and become two each.
TEST(Tangents, AreNotAveragedWithThoseOfAMirroredTexture) {
    const Mesh made = with_tangents(
        mesh_of({flat(-1, 0, 1, 1), flat(0, 0, 0, 1), flat(0, 1, 0, 0), flat(1, 0, 1, 1)}, {0, 1, 2, 1, 3, 2}));
    EXPECT_EQ(made.vertices.size(), 6u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(made.vertices[made.indices[i]].tangent, glm::vec4(-1, 0, 0, -1)) << i;
    for (std::size_t i = 3; i < 6; ++i) EXPECT_EQ(made.vertices[made.indices[i]].tangent, glm::vec4(1, 0, 0, 1)) << i;
}

// Two triangles of the same area have 90 and 45 degrees at the first vertex. In the first u grows along (1, 0). In the
// second, (0, 1) is (0, 1) in the texture and (-1, 1) is (-1, 2), upwards: u grows along (1, 1).
TEST(Tangents, AreAveragedByAngle) {
    const Mesh made = with_tangents(
        mesh_of({flat(0, 0, 0, 0), flat(1, 0, 1, 0), flat(0, 1, 0, -1), flat(-1, 1, -1, -2)}, {0, 1, 2, 0, 2, 3}));
    ASSERT_EQ(made.vertices.size(), 4u);
    const double x = 2 + std::sqrt(0.5), y = std::sqrt(0.5);  // in units of 45 degrees
    const glm::vec4 first = made.vertices[made.indices[0]].tangent;
    EXPECT_NEAR(first.x, x / std::hypot(x, y), 1e-6);
    EXPECT_NEAR(first.y, y / std::hypot(x, y), 1e-6);
    EXPECT_EQ(first.w, 1);
    EXPECT_EQ(made.vertices[made.indices[1]].tangent, glm::vec4(1, 0, 0, 1));
    EXPECT_NEAR(made.vertices[made.indices[5]].tangent.y, std::sqrt(0.5), 1e-6);
}

// What has no area, or no texture, still has a frame.
TEST(Tangents, AlwaysExist) {
    const Mesh no_texture = with_tangents(mesh_of({flat(0, 0, 0, 0), flat(1, 0, 0, 0), flat(0, 1, 0, 0)}, {0, 1, 2}));
    const Mesh no_area = with_tangents(mesh_of({flat(0, 0, 0, 0), flat(0, 0, 1, 0), flat(0, 0, 0, 1)}, {0, 1, 2}));
    for (const Mesh* mesh : {&no_texture, &no_area}) {
        ASSERT_EQ(mesh->indices.size(), 3u);
        for (const Vertex& v : mesh->vertices) {
            EXPECT_FLOAT_EQ(glm::length(glm::vec3(v.tangent)), 1);
            EXPECT_FLOAT_EQ(glm::dot(glm::vec3(v.tangent), v.normal), 0);
        }
    }
    EXPECT_TRUE(with_tangents({}).vertices.empty());
}

}  // namespace
}  // namespace patina::runtime
