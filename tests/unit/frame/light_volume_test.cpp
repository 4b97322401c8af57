// Hulls of lights hold all that the light reaches, and face outwards.
#include "runtime/lights/light_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace patina::runtime {
namespace {

struct Face {
    glm::dvec3 a, b, c;
    glm::dvec3 normal() const { return glm::normalize(glm::cross(b - a, c - a)); }
};

std::vector<Face> faces(const Mesh& mesh, const glm::mat4& object_to_world) {
    auto place = [&](std::uint32_t i) { return glm::dvec3(object_to_world * glm::vec4(mesh.vertices[i].position, 1)); };
    std::vector<Face> result;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        result.push_back({place(mesh.indices[i]), place(mesh.indices[i + 1]), place(mesh.indices[i + 2])});
    return result;
}

// How far a point is outside; the shapes are convex. Metres.
double outside(const std::vector<Face>& hull, glm::dvec3 point) {
    double most = -1e9;
    for (const Face& face : hull) most = std::max(most, glm::dot(face.normal(), point - face.a));
    return most;
}

// The divergence theorem: positive where faces are counter-clockwise from outside, and no less than what is inside.
double volume(const std::vector<Face>& hull) {
    double sum = 0;
    for (const Face& face : hull) sum += glm::dot(face.a, glm::cross(face.b, face.c)) / 6;
    return sum;
}

// Every edge is there once in each direction.
void expect_closed(const Mesh& mesh) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); i++)
        edges.emplace_back(mesh.indices[i], mesh.indices[i % 3 == 2 ? i - 2 : i + 1]);
    std::sort(edges.begin(), edges.end());
    EXPECT_EQ(std::adjacent_find(edges.begin(), edges.end()), edges.end());
    for (auto [from, to] : edges) EXPECT_TRUE(std::binary_search(edges.begin(), edges.end(), std::pair(to, from)));
}

std::vector<glm::dvec3> directions(int count) {
    std::mt19937 random(3);
    std::normal_distribution<double> number;
    std::vector<glm::dvec3> result;
    for (int i = 0; i < count; i++) {
        // One at a time: the order in which arguments are computed is not fixed.
        double x = number(random), y = number(random), z = number(random);
        result.push_back(glm::normalize(glm::dvec3(x, y, z)));
    }
    return result;
}

TEST(LightVolume, OfAPointHoldsTheSphereOfItsRange) {
    Light light{.kind = LightKind::Point, .position = {3, -2, 5}, .range = 7};
    LightVolume made = light_volume(light);
    expect_closed(*made.mesh);
    EXPECT_EQ(made.mesh->indices.size(), 3 * 80u);
    std::vector<Face> hull = faces(*made.mesh, made.object_to_world);
    for (glm::dvec3 direction : directions(5000))
        EXPECT_LT(outside(hull, glm::dvec3(light.position) + 7.0 * direction), 0);
    // It is not much larger either.
    double ball = 4 * std::numbers::pi / 3 * 7 * 7 * 7;
    EXPECT_GT(volume(hull), ball);
    EXPECT_LT(volume(hull), 1.2 * ball);
}

TEST(LightVolume, OfASpotHoldsItsCone) {
    for (float angle : {5.0f, 30.0f, 59.0f, 61.0f, 89.0f, 120.0f}) {
        for (glm::dvec3 axis : {glm::dvec3(0, 0, 1), glm::dvec3(0, -3, 0), glm::dvec3(1, -2, -0.5)}) {
            Light light{
                .kind = LightKind::Spot, .position = {1, 2, 3}, .direction = axis, .range = 4, .outer_angle = angle};
            LightVolume made = light_volume(light);
            expect_closed(*made.mesh);
            std::vector<Face> hull = faces(*made.mesh, made.object_to_world);
            EXPECT_GT(volume(hull), 0);
            int inside = 0;
            double least = std::cos(glm::radians(double(angle)));
            for (glm::dvec3 direction : directions(3000)) {
                // Random directions in the cone: all of them, drawn towards the axis.
                glm::dvec3 drawn = glm::normalize(direction + glm::normalize(axis) * (angle < 10 ? 15.0 : 2.0));
                if (glm::dot(drawn, glm::normalize(axis)) < least) continue;
                inside++;
                for (double distance : {0.01, 1.0, 4.0})
                    EXPECT_LT(outside(hull, glm::dvec3(light.position) + distance * drawn), 1e-6) << angle;
            }
            EXPECT_GT(inside, 300) << angle;
        }
    }
}

TEST(LightVolume, ANarrowSpotIsMuchSmallerThanItsSphere) {
    Light light{.kind = LightKind::Spot, .position = {0, 0, 0}, .direction = {1, 1, 0}, .range = 3, .outer_angle = 20};
    LightVolume made = light_volume(light);
    double radius = 3 * std::tan(glm::radians(20.0)), cone = std::numbers::pi * radius * radius * 3 / 3;
    EXPECT_GT(volume(faces(*made.mesh, made.object_to_world)), cone);
    EXPECT_LT(volume(faces(*made.mesh, made.object_to_world)), 1.05 * cone);
}

TEST(LightVolume, DirectionalLightsHaveNone) {
    EXPECT_EQ(light_volume(Light{}).mesh, nullptr);
}

TEST(LightVolume, IsClippedWhereItReachesThroughAPlane) {
    Scene scene;  // at z = 4, looking along -z, planes at 0.05 and 100
    View view = camera_view(scene);
    auto at = [&](float z, float range) {
        return is_clipped(light_volume({.kind = LightKind::Point, .position = {0, 0, z}, .range = range}), view);
    };
    EXPECT_FALSE(at(0, 1));
    EXPECT_TRUE(at(3, 2));    // the camera is in it
    EXPECT_TRUE(at(-95, 2));  // the far plane cuts it
    EXPECT_FALSE(at(-90, 2));
}

TEST(ViewVolume, HoldsWhatTheCameraSees) {
    for (bool is_parallel : {false, true}) {
        Scene scene;
        scene.camera.position = {1, 2, 3};
        scene.camera.target = {0, 0.5f, -1};
        if (is_parallel) scene.camera.orthographic_height = 3;
        scene.width = 640;
        scene.height = 360;
        View view = camera_view(scene);
        Mesh mesh = view_volume(view);
        expect_closed(mesh);
        std::vector<Face> hull = faces(mesh, glm::mat4(1));
        EXPECT_GT(volume(hull), 0);
        glm::dmat4 to_world = glm::inverse(glm::dmat4(view.view_to_clip) * glm::dmat4(view.world_to_view));
        for (double x : {-1.0, 0.3, 1.0})
            for (double y : {-1.0, 0.2, 1.0})
                for (double z : {1e-3, 0.5, 0.999}) {
                    glm::dvec4 corner = to_world * glm::dvec4(x, y, z, 1);
                    EXPECT_LT(outside(hull, glm::dvec3(corner) / corner.w), 0) << x << " " << y << " " << z;
                }
        for (const Vertex& vertex : mesh.vertices) {
            glm::vec4 clip = view.view_to_clip * view.world_to_view * glm::vec4(vertex.position, 1);
            EXPECT_GT(clip.z, 0);
            EXPECT_LT(clip.z, clip.w);
        }
    }
}

}  // namespace
}  // namespace patina::runtime
