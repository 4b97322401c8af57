// Shadow maps hold what casts, stay still, and are where the atlas says; cookies lie as their light looks.
#include "runtime/shadow_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

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

const std::vector<Sphere> kCasters = {{{0, 0, 0}, 1}, {{4, 1, -2}, 0.5f}, {{-1, 3, 2}, 0.75f}};
const std::vector<Sphere> kEverything = {kCasters[0], kCasters[1], kCasters[2], {{0, -6, 0}, 8}};

TEST(DirectionalShadow, HoldsTheCasters) {
    for (glm::vec3 direction : {glm::vec3(-0.5f, 2, 1), glm::vec3(0, 3, 0), glm::vec3(1, -0.2f, 0)}) {
        ShadowView map = directional_shadow({.direction = direction}, kCasters, kEverything, {});
        for (const Sphere& sphere : kCasters)
            for (glm::vec3 point : around(sphere, 300)) {
                EXPECT_LE(std::abs(on_map(map, point).x), 1);
                EXPECT_LE(std::abs(on_map(map, point).y), 1);
            }
        for (const Sphere& sphere : kEverything)
            for (glm::vec3 point : around(sphere, 300)) {
                EXPECT_GT(on_map(map, point).z, 0);
                EXPECT_LT(on_map(map, point).z, 1);
            }
        EXPECT_TRUE(map.view.is_parallel);
        EXPECT_NEAR(glm::dot(map.view.forward, glm::normalize(direction)), -1, 1e-6);
        // It stands before all of them.
        for (const Sphere& sphere : kEverything)
            EXPECT_GT(glm::dot(sphere.center - map.view.position, map.view.forward), sphere.radius);
    }
}

TEST(DirectionalShadow, DepthGrowsAwayFromTheLight) {
    Light light{.direction = {0, 1, 0.5f}};
    ShadowView map = directional_shadow(light, kCasters, kEverything, {});
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
    ShadowView first = directional_shadow(light, kCasters, kCasters, {.atlas_size = 1024});
    bool has_moved = false;
    for (int i = 0; i < 50; i++) {
        std::vector<Sphere> moved = kCasters;
        float x = number(random), y = number(random), z = number(random);
        for (Sphere& sphere : moved) sphere.center += glm::vec3(x, y, z);
        ShadowView map = directional_shadow(light, moved, moved, {.atlas_size = 1024});
        for (int axis = 0; axis < 2; axis++) {
            float shift = in_texels(map, still)[axis] - in_texels(first, still)[axis];
            EXPECT_NEAR(shift, std::round(shift), 2e-3) << i;
            has_moved |= std::abs(shift) > 10;
        }
    }
    EXPECT_TRUE(has_moved);
}

TEST(DirectionalShadow, NormalBiasIsInTexels) {
    Light light{.direction = {0, 0, 1}, .shadow = {.casts = true, .bias = 0.02f, .normal_bias = 3}};
    ShadowView map = directional_shadow(light, kCasters, kEverything, {.atlas_size = 512});
    EXPECT_NEAR(in_texels(map, {map.view.normal_bias, 0, 0}).x - in_texels(map, {0, 0, 0}).x, 3, 1e-3);
    EXPECT_EQ(map.view.bias, 0.02f);
}

TEST(DirectionalShadow, TexelsAreAsFineAsTheCastersAllow) {
    // One ball of 1 m: 16 steps to a power of two lose at most 1/16, snapping two texels.
    const Sphere ball{{2, 2, 2}, 0.9f};
    Light light{.direction = {0, 0, 1}};
    ShadowView map = directional_shadow(light, std::span(&ball, 1), std::span(&ball, 1), {.atlas_size = 1024});
    float across = in_texels(map, {2.9f, 2, 2}).x - in_texels(map, {1.1f, 2, 2}).x;
    EXPECT_LE(across, 504 - 2);
    EXPECT_GE(across, (504 - 2) * 15.0f / 16);
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
    EXPECT_NEAR(on_map(map, light.position + 8.0f * axis).z, 1, 1e-5);
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

TEST(SpotShadow, NormalBiasIsThatOfTheRange) {
    Light light{.kind = LightKind::Spot,
                .position = {0, 0, 0},
                .direction = {0, 0, -1},
                .range = 6,
                .outer_angle = 40,
                .shadow = {.casts = true, .normal_bias = 2}};
    ShadowView map = spot_shadow(light, {.atlas_size = 512});
    EXPECT_NEAR(in_texels(map, {map.view.normal_bias, 0, -6}).x - in_texels(map, {0, 0, -6}).x, 2, 1e-3);
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
