// Promises of runtime/mesh/mesh.h that shading depends on, checked on every mesh.
#include "runtime/mesh/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <tuple>

namespace patina::runtime {
namespace {

class EveryMesh : public testing::TestWithParam<std::string_view> {
protected:
    Mesh mesh = make_mesh(GetParam()).value();
};

template <class Visit>
void for_each_triangle(const Mesh& mesh, Visit visit) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        visit(mesh.vertices[mesh.indices[i]], mesh.vertices[mesh.indices[i + 1]], mesh.vertices[mesh.indices[i + 2]]);
}

glm::vec3 face_normal(const Vertex& a, const Vertex& b, const Vertex& c) {
    return glm::normalize(glm::cross(b.position - a.position, c.position - a.position));
}

// Change of `attribute` over a triangle along the plane's axes: how its position moves per unit of u and of v.
struct Gradient {
    glm::vec3 along_u, along_v;
    bool is_defined;
};
Gradient position_gradient(const Vertex& a, const Vertex& b, const Vertex& c) {
    glm::vec2 d1 = b.uv0 - a.uv0, d2 = c.uv0 - a.uv0;
    glm::vec3 e1 = b.position - a.position, e2 = c.position - a.position;
    float determinant = d1.x * d2.y - d1.y * d2.x;
    return {(e1 * d2.y - e2 * d1.y) / determinant, (e2 * d1.x - e1 * d2.x) / determinant, determinant != 0};
}

TEST_P(EveryMesh, FramesAreOrthonormal) {
    ASSERT_FALSE(mesh.vertices.empty());
    for (const Vertex& v : mesh.vertices) {
        EXPECT_NEAR(glm::length(v.normal), 1, 1e-5);
        EXPECT_NEAR(glm::length(glm::vec3(v.tangent)), 1, 1e-5);
        EXPECT_NEAR(glm::dot(v.normal, glm::vec3(v.tangent)), 0, 1e-5);
        EXPECT_EQ(std::abs(v.tangent.w), 1);
        EXPECT_GE(v.uv0.x, 0);
        EXPECT_LE(v.uv0.x, 1);
        EXPECT_GE(v.uv0.y, 0);
        EXPECT_LE(v.uv0.y, 1);
    }
}

TEST_P(EveryMesh, WindingIsCounterClockwiseFromOutside) {
    for_each_triangle(mesh, [](const Vertex& a, const Vertex& b, const Vertex& c) {
        glm::vec3 normal = face_normal(a, b, c);
        for (const Vertex* v : {&a, &b, &c}) EXPECT_GT(glm::dot(normal, v->normal), 0.9f);
    });
}

TEST_P(EveryMesh, TangentFollowsUAndBitangentFollowsUp) {
    std::size_t checked = 0;
    for_each_triangle(mesh, [&](const Vertex& a, const Vertex& b, const Vertex& c) {
        Gradient gradient = position_gradient(a, b, c);
        if (!gradient.is_defined) return;
        checked++;
        glm::vec3 tangent = glm::normalize(glm::vec3(a.tangent + b.tangent + c.tangent));
        glm::vec3 bitangent = glm::cross(glm::normalize(a.normal + b.normal + c.normal), tangent) * a.tangent.w;
        EXPECT_GT(glm::dot(tangent, glm::normalize(gradient.along_u)), 0.9f);
        EXPECT_GT(glm::dot(bitangent, glm::normalize(-gradient.along_v)), 0.9f);
    });
    EXPECT_GE(checked, mesh.indices.size() / 3 - 2);
}

INSTANTIATE_TEST_SUITE_P(Meshes, EveryMesh, testing::ValuesIn(mesh_names().begin(), mesh_names().end()),
                         [](const auto& info) { return std::string(info.param); });

class ClosedMesh : public EveryMesh {};

// Each edge is walked once in each direction once vertices at one place count as one: seams meet exactly.
TEST_P(ClosedMesh, HasNoHoles) {
    using Place = std::tuple<float, float, float>;
    std::map<std::pair<Place, Place>, int> walks;
    auto place = [](const Vertex& v) { return Place{v.position.x, v.position.y, v.position.z}; };
    for_each_triangle(mesh, [&](const Vertex& a, const Vertex& b, const Vertex& c) {
        walks[{place(a), place(b)}]++;
        walks[{place(b), place(c)}]++;
        walks[{place(c), place(a)}]++;
    });
    for (const auto& [edge, count] : walks) {
        auto back = walks.find({edge.second, edge.first});
        ASSERT_NE(back, walks.end());
        EXPECT_EQ(count, 1);
        EXPECT_EQ(back->second, 1);
    }
}

// The divergence theorem: a closed mesh that faces outward has the volume of its solid, and not minus that.
TEST_P(ClosedMesh, HasTheVolumeOfItsSolid) {
    const double pi = std::acos(-1.0);
    const std::map<std::string_view, double> volumes = {
        {"sphere", 4 * pi / 3},
        {"cube", 1.5 * 1.5 * 1.5},
        {"capsule", pi * 0.6 * 0.6 * 1 + 4 * pi / 3 * 0.6 * 0.6 * 0.6},
        {"torus", 2 * pi * pi * 0.75 * 0.32 * 0.32},
    };
    double volume = 0;
    for_each_triangle(mesh, [&](const Vertex& a, const Vertex& b, const Vertex& c) {
        volume += glm::dot(a.position, glm::cross(b.position, c.position)) / 6;
    });
    double expected = volumes.at(GetParam());
    EXPECT_NEAR(volume, expected, 0.01 * expected);
}

INSTANTIATE_TEST_SUITE_P(Meshes, ClosedMesh, testing::Values("sphere", "cube", "capsule", "torus"),
                         [](const auto& info) { return std::string(info.param); });

// Where normals are known in closed form.
TEST(Sphere, NormalIsThePosition) {
    for (const Vertex& v : make_sphere(1, 32, 16).vertices) EXPECT_LT(glm::length(v.normal - v.position), 1e-6);
}

TEST(Sphere, EveryColumnHasItsOwnPole) {
    Mesh sphere = make_sphere(1, 16, 8);
    for (int i = 0; i < 16; i++) {
        const Vertex& pole = sphere.vertices[i];
        EXPECT_EQ(pole.position, glm::vec3(0, 1, 0));
        EXPECT_LT(glm::length(glm::vec3(pole.tangent) - glm::vec3(sphere.vertices[17 + i].tangent)), 1e-6);
    }
}

TEST(Sphere, MiddleOfTheTextureFacesTheCamera) {
    for (const Vertex& v : make_sphere(2, 32, 16).vertices)
        if (v.uv0 == glm::vec2(0.5f, 0.5f)) {
            EXPECT_LT(glm::length(v.position - glm::vec3(0, 0, 2)), 1e-6);
            EXPECT_LT(glm::length(glm::vec3(v.tangent) - glm::vec3(1, 0, 0)), 1e-6);
            return;
        }
    FAIL() << "no vertex has uv 0.5, 0.5";
}

TEST(Torus, LiesOnItsSurface) {
    for (const Vertex& v : make_torus(0.75f, 0.32f, 32, 16).vertices) {
        float across = std::hypot(v.position.x, v.position.y) - 0.75f;
        EXPECT_NEAR(std::hypot(across, v.position.z), 0.32f, 1e-6);
    }
}

TEST(Capsule, TextureRunsAtAnEvenPace) {
    // Half of the outline's length is at the middle of the straight part.
    for (const Vertex& v : make_capsule(0.6f, 1, 32, 8).vertices) {
        if (std::abs(v.position.y) > 0.5f) continue;
        float total = 2 * 0.6f * std::acos(0.0f) + 1;
        EXPECT_NEAR(v.uv0.y, 0.5f - v.position.y / total, 1e-5);
    }
}

TEST(Fullscreen, PutsTheTexturesTopLeftAtTheTopLeft) {
    for (const Vertex& v : make_fullscreen().vertices)
        EXPECT_EQ(v.uv0, glm::vec2(v.position.x * 0.5f + 0.5f, 0.5f - v.position.y * 0.5f));
}

// A sphere of flat cells loses volume by the square of their size, so twice the segments lose a quarter.
TEST(Segments, RefineASphere) {
    const double solid = 4 * std::acos(-1.0) / 3;
    const auto lost = [&](int segments) {
        double volume = 0;
        for_each_triangle(*make_mesh("sphere", segments), [&](const Vertex& a, const Vertex& b, const Vertex& c) {
            volume += glm::dot(a.position, glm::cross(b.position, c.position)) / 6;
        });
        return solid - volume;
    };
    for (const int segments : {16, 32, 64}) {
        EXPECT_GT(lost(segments), 0);
        EXPECT_NEAR(lost(segments) / lost(2 * segments), 4, 0.1) << segments;
    }
}

TEST(Segments, AreThoseOfThePreviewUnlessSaid) {
    const std::map<std::string_view, int> usual = {
        {"sphere", 192}, {"plane", 128}, {"cube", 48}, {"capsule", 192}, {"torus", 192}};
    for (const auto& [name, segments] : usual) {
        EXPECT_EQ(make_mesh(name, segments)->indices, make_mesh(name)->indices) << name;
        EXPECT_GT(make_mesh(name, 2 * segments)->indices.size(), 3 * make_mesh(name)->indices.size()) << name;
    }
}

// As coarse as can be, a mesh is still closed, or whole.
TEST(Segments, ThreeMakeAMesh) {
    for (std::string_view name : mesh_names()) EXPECT_GE(make_mesh(name, 3)->indices.size(), 3u * 4) << name;
}

TEST(MeshNames, AreTheMeshesThatExist) {
    for (std::string_view name : mesh_names()) EXPECT_TRUE(make_mesh(name).has_value()) << name;
    EXPECT_FALSE(make_mesh("teapot").has_value());
    EXPECT_FALSE(make_mesh("").has_value());
}

TEST(BoundingRadius, IsTheFarthestVertex) {
    EXPECT_NEAR(bounding_radius(make_sphere(3)), 3, 1e-5);
    EXPECT_NEAR(bounding_radius(make_cube(2)), std::sqrt(3.0), 1e-5);
    EXPECT_EQ(bounding_radius(Mesh{}), 0);
}

}  // namespace
}  // namespace patina::runtime
