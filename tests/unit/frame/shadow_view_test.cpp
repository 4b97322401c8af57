// Shadow maps hold what casts, stay still, and are where the atlas says; cookies lie as their light looks.
#include "runtime/lights/shadow_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "runtime/scene/bounds.h"

namespace patina::runtime {
namespace {

glm::vec3 on_map(const ShadowView& map, glm::vec3 position) {
    glm::vec4 clip = map.world_to_shadow * glm::vec4(position, 1);
    return glm::vec3(clip) / clip.w;
}

// From the middle of the map, right and up.
glm::vec2 in_texels(const ShadowView& map, glm::vec3 position) {
    return glm::vec2(on_map(map, position)) * (float(map.area.width) / 2);
}

std::vector<glm::vec3> around(const Sphere& sphere, int count) {
    std::mt19937 random(11);
    std::normal_distribution<float> number;
    std::vector<glm::vec3> points;
    for (int i = 0; i < count; i++) {
        float x = number(random), y = number(random), z = number(random);
        points.push_back(sphere.center + sphere.radius * glm::normalize(glm::vec3(x, y, z)));
    }
    return points;
}

constexpr float kLargest = 1e-4f;  // of a clip space of 2, or of a texel

// Objects that are balls of points.
struct Balls {
    explicit Balls(const std::vector<Sphere>& balls, bool casts = true) { add(balls, casts); }
    void add(const std::vector<Sphere>& balls, bool casts) {
        for (const Sphere& ball : balls) {
            Mesh& mesh = meshes.emplace_back();
            for (glm::vec3 point : around(ball, 300)) mesh.vertices.emplace_back().position = point;
            objects.push_back({.mesh = &mesh, .casts = casts});
        }
    }
    std::deque<Mesh> meshes{};
    std::vector<ShadowObject> objects{};
};

// It sees all of the small scenes here.
View far_away() {
    Scene scene;
    scene.camera = {.position = {0, 0, 60}};
    return camera_view(scene);
}

const std::vector<Sphere> kCasters = {{{0, 0, 0}, 1}, {{4, 1, -2}, 0.5f}, {{-1, 3, 2}, 0.75f}};
const Sphere kReceiver{{0, -6, 0}, 8};

TEST(DirectionalShadow, HoldsTheCasters) {
    Balls balls(kCasters);
    balls.add({kReceiver}, false);
    for (glm::vec3 direction : {glm::vec3(-0.5f, 2, 1), glm::vec3(0, 3, 0), glm::vec3(1, -0.2f, 0)}) {
        ShadowView map = directional_shadow({.direction = direction}, balls.objects, far_away(), {}, {});
        for (const ShadowObject& object : balls.objects) {
            for (const Vertex& vertex : object.mesh->vertices) {
                const glm::vec3 at = on_map(map, vertex.position);
                if (object.casts) {
                    // The filter reads three texels further.
                    EXPECT_LE(std::max(std::abs(at.x), std::abs(at.y)), 1 - 6.0f / float(map.area.width) + kLargest);
                }
                EXPECT_GT(at.z, 0);
                EXPECT_LT(at.z, 1);
                // It stands before all of them.
                EXPECT_GT(glm::dot(vertex.position - map.view.position, map.view.forward), 0);
            }
        }
        EXPECT_TRUE(map.view.is_parallel);
        EXPECT_NEAR(glm::dot(map.view.forward, glm::normalize(direction)), -1, 1e-6);
    }
}

TEST(DirectionalShadow, DepthGrowsAwayFromTheLight) {
    const Balls balls(kCasters);
    Light light{.direction = {0, 1, 0.5f}};
    ShadowView map = directional_shadow(light, balls.objects, far_away(), {}, {});
    EXPECT_LT(on_map(map, light.direction).z, on_map(map, -light.direction).z);
    // Along the light nothing moves on the map.
    EXPECT_NEAR(on_map(map, light.direction).x, on_map(map, -light.direction).x, 1e-5);
    EXPECT_NEAR(on_map(map, light.direction).y, on_map(map, -light.direction).y, 1e-5);
    EXPECT_GT(on_map(map, {0, 1, 0}).y, on_map(map, {0, 0, 0}).y);  // y is up
}

TEST(DirectionalShadow, MovesByWholeTexels) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(-1, 1);
    Light light{.direction = {0.3f, 1, 0.7f}};
    const glm::vec3 still(0.3f, -0.2f, 0.4f);
    Balls balls(kCasters);
    ShadowView first = directional_shadow(light, balls.objects, far_away(), {}, {.atlas_size = 1024});
    bool has_moved = false;
    for (int i = 0; i < 50; i++) {
        float x = number(random), y = number(random), z = number(random);
        for (ShadowObject& ball : balls.objects) ball.object_to_world[3] = {x, y, z, 1};
        ShadowView map = directional_shadow(light, balls.objects, far_away(), {}, {.atlas_size = 1024});
        for (int axis = 0; axis < 2; axis++) {
            float shift = in_texels(map, still)[axis] - in_texels(first, still)[axis];
            EXPECT_NEAR(shift, std::round(shift), 2e-3) << i;
            has_moved |= std::abs(shift) > 10;
        }
    }
    EXPECT_TRUE(has_moved);
}

// What a texel is across, at a place in the map's view.
float texel_at(const ShadowView& map, float distance) {
    const glm::mat4 to_world = glm::inverse(map.view.world_to_view);
    const auto place = [&](float x) { return glm::vec3(to_world * glm::vec4(x, 0, -distance, 1)); };
    return 1 / (in_texels(map, place(1)).x - in_texels(map, place(0)).x);
}
// The clip space that the caster draws into.
float drawn_depth(const ShadowView& map, float distance) {
    const glm::vec4 clip = map.view.view_to_clip * glm::vec4(0, 0, -distance, 1);
    return clip.z / clip.w;
}
float looked_up_depth(const ShadowView& map, float distance) {
    return on_map(map, glm::vec3(glm::inverse(map.view.world_to_view) * glm::vec4(0, 0, -distance, 1))).z;
}

TEST(DirectionalShadow, BiasesAreInTexels) {
    const Balls balls(kCasters);
    Light light{.direction = {0, 0, 1}, .shadow = {.casts = true, .bias = 0.02f, .normal_bias = 3}};
    ShadowView map = directional_shadow(light, balls.objects, far_away(), {}, {.atlas_size = 512});
    EXPECT_NEAR(in_texels(map, {map.view.normal_bias, 0, 0}).x - in_texels(map, {0, 0, 0}).x, 3, 1e-3);
    EXPECT_EQ(map.view.bias, 0.02f);
    EXPECT_NEAR(looked_up_depth(map, 2), drawn_depth(map, 2 - texel_at(map, 2)), 1e-6);
}

TEST(DirectionalShadow, TexelsAreAsFineAsTheCastersAllow) {
    // 16 steps to a power of two lose at most 1/16, snapping two texels, the filter three on each side.
    const Mesh ball = make_sphere(0.9f);
    const ShadowObject object{.mesh = &ball, .object_to_world = glm::translate(glm::mat4(1), {2, 2, 2})};
    Light light{.direction = {0, 0, 1}};
    ShadowView map = directional_shadow(light, std::span(&object, 1), far_away(), {}, {.atlas_size = 1024});
    float across = in_texels(map, {2.9f, 2, 2}).x - in_texels(map, {1.1f, 2, 2}).x;
    EXPECT_LE(across, 504 - 8);
    EXPECT_GE(across, (504 - 8) * 15.0f / 16);
}

// A ball of 1 m at the origin, above a floor of 600 m that faces up; the light comes from above.
class Fit : public testing::Test {
protected:
    glm::vec2 size(const View& camera, std::optional<float> farthest = {}) const {
        const Extent extent = shadowed_extent(world_to_light({.direction = {0, 1, 0}}), objects, camera, farthest);
        return extent.highest - extent.lowest;
    }
    Mesh ball_mesh = make_sphere(1), floor_mesh = make_plane(600);
    ShadowObject ball{.mesh = &ball_mesh};
    ShadowObject floor{.mesh = &floor_mesh,
                       .object_to_world = glm::translate(glm::mat4(1), {0, -1, 0}) *
                                          glm::rotate(glm::mat4(1), glm::radians(-90.0f), {1, 0, 0})};
    std::vector<ShadowObject> objects = {floor, ball};
};

TEST_F(Fit, AFloorCountsWhereThingsAreBehindIt) {
    EXPECT_NEAR(glm::distance(size(far_away()), {2, 2}), 0, kLargest);
    objects[0].object_to_world[3].y = 0;  // it cuts the ball
    EXPECT_NEAR(glm::distance(size(far_away()), {2, 2}), 0, kLargest);
    ShadowObject cellar{.mesh = &floor_mesh, .object_to_world = floor.object_to_world};
    cellar.object_to_world[3].y = -4;
    objects.push_back(cellar);
    EXPECT_GT(std::min(size(far_away()).x, size(far_away()).y), 30);
}

TEST_F(Fit, AFloorThatIsMovedIsNotFlat) {
    objects[0].moves_vertices = true;
    EXPECT_GT(std::min(size(far_away()).x, size(far_away()).y), 30);
}

// A box says where it can be: as the vertices of a mesh that has these corners would.
TEST(DirectionalShadow, GoesByTheBoundsOfTheMaterial) {
    const Mesh ball = *make_mesh("sphere", 24);
    const glm::mat4 turned = glm::rotate(glm::mat4(1), 0.5f, glm::vec3(0, 0, 1));
    const Bounds box{.box = std::array<std::array<double, 3>, 2>{{{-2, -1, 0}, {3, 1, 0.5}}}};
    Mesh corners;
    for (int i = 0; i < 8; i++)
        corners.vertices.emplace_back().position = {i & 1 ? 3 : -2, i & 2 ? 1 : -1, i & 4 ? 0.5f : 0};
    const glm::mat4 light = glm::lookAt(glm::vec3(3, 10, 4), glm::vec3(0), glm::vec3(0, 1, 0));
    const auto extent_of = [&](const Mesh& mesh, std::optional<Bounds> bounds) {
        const ShadowObject object{.mesh = &mesh, .object_to_world = turned, .moves_vertices = true, .bounds = bounds};
        return shadowed_extent(light, std::span(&object, 1), far_away(), {});
    };
    const Extent said = extent_of(ball, box), expected = extent_of(corners, {});
    EXPECT_EQ(said.lowest, expected.lowest);
    EXPECT_EQ(said.highest, expected.highest);
    // 0.25 m around the ball of radius 1: a cube of 2.5 m, whose corners are 1.25 sqrt(3) from its middle.
    const Sphere sphere = world_bounds(ball, glm::translate(glm::mat4(1), {1, 2, 3}), Bounds{.margin = 0.25});
    EXPECT_NEAR(sphere.radius, 1.25f * std::sqrt(3.0f), 1e-3f);
    EXPECT_NEAR(glm::distance(sphere.center, glm::vec3(1, 2, 3)), 0, 1e-5f);
}

TEST_F(Fit, AFloorAloneIsHeldWhole) {
    objects = {floor};
    EXPECT_NEAR(size(far_away()).x, 600, 1e-2);
}

TEST_F(Fit, WhatTheCameraDoesNotSeeIsCutOff) {
    objects[0].moves_vertices = true;
    // 4 m by 2 m of the floor.
    Scene scene;
    scene.width = 200, scene.height = 100;
    scene.camera = {.position = {0, 20, 0.001f}, .orthographic_height = 2};
    EXPECT_NEAR(glm::distance(size(camera_view(scene)), {4, 2}), 0, 1e-2);
    // Beside the ball: its shadow is not seen, but it still casts.
    scene.camera = {.position = {40, 1, 0}, .target = {40, 1, -50}, .fov = 90};
    const View aside = camera_view(scene);
    const Extent extent = shadowed_extent(world_to_light({.direction = {0, 1, 0}}), objects, aside, 30);
    EXPECT_NEAR(extent.highest.z, 1, kLargest);
    EXPECT_NEAR(extent.lowest.z, -1, kLargest);
    // 90 degrees across 100 rows: 30 m away the picture is 60 m high and 120 m wide.
    EXPECT_NEAR(extent.highest.x - extent.lowest.x, 120, 1e-2);
    EXPECT_NEAR(extent.highest.y - extent.lowest.y, 30, 0.1);
}

TEST(SpotShadow, CoversTheConeUpToTheRange) {
    Light light{.kind = LightKind::Spot,
                .position = {1, 5, 2},
                .direction = {0, -2, 0.5f},
                .range = 8,
                .inner_angle = 10,
                .outer_angle = 35};
    ShadowView map = spot_shadow(light, {});
    glm::vec3 axis = glm::normalize(light.direction);
    glm::vec3 aside = glm::normalize(glm::cross(axis, glm::vec3(1, 0, 0))), across = glm::cross(axis, aside);
    const glm::vec4 farthest =
        map.view.view_to_clip * map.view.world_to_view * glm::vec4(light.position + 8.0f * axis, 1);
    EXPECT_NEAR(farthest.z / farthest.w, 1, 1e-5);
    EXPECT_NEAR(glm::length(glm::vec2(on_map(map, light.position + 3.0f * axis))), 0, 1e-5);
    for (int i = 0; i < 12; i++) {
        float turn = float(i), angle = glm::radians(35.0f);
        glm::vec3 edge = axis * std::cos(angle) + (aside * std::cos(turn) + across * std::sin(turn)) * std::sin(angle);
        EXPECT_NEAR(glm::length(glm::vec2(on_map(map, light.position + 4.0f * edge))), 1, 1e-4);
        EXPECT_GT(on_map(map, light.position + 4.0f * edge).z, on_map(map, light.position + 3.0f * edge).z);
    }
    EXPECT_FALSE(map.view.is_parallel);
    EXPECT_EQ(map.view.position, light.position);
}

TEST(SpotShadow, BiasesAreInTexelsAtEveryDistance) {
    Light light{.kind = LightKind::Spot,
                .position = {0, 0, 0},
                .direction = {0, 0, -1},
                .outer_angle = 40,
                .shadow = {.casts = true, .normal_bias = 2}};
    for (float range : {6.0f, 200.0f, 900.0f}) {
        light.range = range;
        ShadowView map = spot_shadow(light, {.atlas_size = 512});
        for (float distance : {1.0f, 3.0f, 6.0f}) {
            const glm::vec3 moved(map.view.normal_bias * distance, 0, -distance);
            EXPECT_NEAR(in_texels(map, moved).x - in_texels(map, {0, 0, -distance}).x, 2, 1e-3);
            // One texel, but for its own share of the distance.
            const float texel = texel_at(map, distance);
            const float step = drawn_depth(map, distance) - drawn_depth(map, distance - texel);
            EXPECT_NEAR((drawn_depth(map, distance) - looked_up_depth(map, distance)) / step, 1, 2 * texel / distance);
        }
        const float close = std::max(0.06f, range / 500);
        EXPECT_LT(drawn_depth(map, close), 1);
        EXPECT_GT(drawn_depth(map, close), 0);  // it casts
    }
}

TEST(SpotShadow, IsFiniteForAnyCone) {
    Light light{.kind = LightKind::Spot, .direction = {0, -1, 0}, .outer_angle = 120};
    ShadowView map = spot_shadow(light, {});
    for (int c = 0; c < 4; c++)
        for (int r = 0; r < 4; r++) EXPECT_TRUE(std::isfinite(map.world_to_shadow[c][r]));
}

TEST(ShadowTile, MapsLieApartInTheAtlas) {
    Light light{.kind = LightKind::Spot, .direction = {0, -1, 0}, .outer_angle = 40};
    std::vector<std::vector<int>> owner(256, std::vector<int>(256, -1));
    for (int number = 0; number < 4; number++) {
        ShadowView map = spot_shadow(light, {.number = number, .atlas_size = 256});
        // The corners of the map in the atlas are those of the area.
        EXPECT_FLOAT_EQ(map.tile.z * 256, float(map.area.x));
        EXPECT_FLOAT_EQ(map.tile.w * 256, float(map.area.y));
        EXPECT_FLOAT_EQ((map.tile.z + map.tile.x) * 256, float(map.area.x + map.area.width));
        EXPECT_FLOAT_EQ((map.tile.w + map.tile.y) * 256, float(map.area.y + map.area.height));
        EXPECT_EQ(map.area.x >= 128, number == 1 || number == 3);
        EXPECT_EQ(map.area.y >= 128, number >= 2);
        // What a filter may read around it.
        for (int y = map.area.y - kShadowMargin; y < map.area.y + map.area.height + kShadowMargin; y++)
            for (int x = map.area.x - kShadowMargin; x < map.area.x + map.area.width + kShadowMargin; x++) {
                ASSERT_TRUE(x >= 0 && y >= 0 && x < 256 && y < 256);
                ASSERT_EQ(owner[y][x], -1);
                owner[y][x] = number;
            }
    }
}

glm::vec2 cookie_uv(const Light& light, glm::vec3 position) {
    glm::vec4 place = world_to_cookie(light) * glm::vec4(position, 1);
    return glm::vec2(place) / place.w;
}

TEST(Cookie, OfADirectionalLightSpansItsSize) {
    // Shining along -z: x is right and y is up in the picture, whose v grows downwards.
    Light light{.direction = {0, 0, 1}, .cookie_size = 4};
    EXPECT_NEAR(cookie_uv(light, {0, 0, 7}).x, 0.5, 1e-6);
    EXPECT_NEAR(cookie_uv(light, {2, 1, 0}).x, 1, 1e-6);
    EXPECT_NEAR(cookie_uv(light, {2, 1, 0}).y, 0.25, 1e-6);
    EXPECT_NEAR(cookie_uv(light, {-2, -2, -3}).x, 0, 1e-6);
    EXPECT_NEAR(cookie_uv(light, {-2, -2, -3}).y, 1, 1e-6);
}

TEST(Cookie, OfASpotFillsItsCone) {
    Light light{.kind = LightKind::Spot, .position = {1, 0, 5}, .direction = {0, 0, -1}, .outer_angle = 45};
    EXPECT_NEAR(cookie_uv(light, {1, 0, 2}).x, 0.5, 1e-6);
    EXPECT_NEAR(cookie_uv(light, {4, 0, 2}).x, 1, 1e-5);  // 3 in front, 3 to the right
    EXPECT_NEAR(cookie_uv(light, {1, 1.5f, 2}).y, 0.25, 1e-5);
    EXPECT_LT((world_to_cookie(light) * glm::vec4(1, 0, 6, 1)).w, 0);  // behind it
}

}  // namespace
}  // namespace patina::runtime
