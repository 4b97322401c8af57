// Which light reaches an object in which way, and a light as spherical harmonics.
#include "runtime/lights/light_split.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace patina::runtime {
namespace {

using Indices = std::vector<std::size_t>;
using enum LightImportance;

Light point_at(float distance, LightImportance importance = Auto, glm::vec3 color = glm::vec3(1)) {
    return {
        .kind = LightKind::Point, .position = {distance, 0, 0}, .color = color, .range = 50, .importance = importance};
}

Light sun(float brightness, LightImportance importance = Auto) {
    return {.color = glm::vec3(brightness), .importance = importance};
}

Light spot_at(float distance, glm::vec3 direction = {-1, 0, 0}) {
    Light light = point_at(distance);
    light.kind = LightKind::Spot;
    light.direction = direction;
    return light;
}

// Lights A, B, C ... of the same kind, each farther away than the one before.
std::vector<Light> row_of_lights(int count) {
    std::vector<Light> lights;
    for (int i = 0; i < count; i++) lights.push_back(point_at(2 + float(i)));
    return lights;
}

const Sphere kBall{.radius = 1};

TEST(LightSplit, EightLightsOfTheManualAreFourAndFour) {
    LightSplit split = split_lights(row_of_lights(8), kBall, 4);
    EXPECT_EQ(split.main, std::nullopt);
    EXPECT_EQ(split.further, (Indices{0, 1, 2, 3}));  // A to D
    EXPECT_EQ(split.vertex, (Indices{4, 5, 6, 7}));   // E to H; in the manual D to G
    EXPECT_TRUE(split.sh.empty());                    // in the manual G and H

    split = split_lights(row_of_lights(10), kBall, 4);
    EXPECT_EQ(split.further, (Indices{0, 1, 2, 3}));
    EXPECT_EQ(split.vertex, (Indices{4, 5, 6, 7}));
    EXPECT_EQ(split.sh, (Indices{8, 9}));
}

TEST(LightSplit, GoesByBrightnessAtTheObject) {
    // A light at a distance of 9 from the nearest point of the ball is 81 times weaker than one at 1, or somewhat more.
    std::vector<Light> lights = {point_at(2), point_at(10, Auto, glm::vec3(100)), point_at(10, Auto, glm::vec3(70))};
    EXPECT_EQ(split_lights(lights, kBall, 3).further, (Indices{1, 0, 2}));
    // Green is brighter than blue.
    lights = {point_at(2, Auto, {0, 0, 1}), point_at(2, Auto, {0, 1, 0}), point_at(2, Auto, {1, 0, 0})};
    EXPECT_EQ(split_lights(lights, kBall, 3).further, (Indices{1, 2, 0}));
}

TEST(LightSplit, EquallyBrightLightsKeepTheOrderOfTheScene) {
    std::vector<Light> lights(12, point_at(3));
    LightSplit split = split_lights(lights, kBall, 3);
    EXPECT_EQ(split.further, (Indices{0, 1, 2}));
    EXPECT_EQ(split.vertex, (Indices{3, 4, 5, 6}));
    EXPECT_EQ(split.sh, (Indices{7, 8, 9, 10, 11}));
}

TEST(LightSplit, MainIsTheBrightestDirectionalWhateverTheCount) {
    std::vector<Light> lights = {sun(1), point_at(2), sun(3), sun(3)};
    LightSplit split = split_lights(lights, kBall, 0);
    EXPECT_EQ(split.main, 2u);
    EXPECT_TRUE(split.further.empty());
    EXPECT_EQ(split.vertex, (Indices{1}));
    EXPECT_EQ(split.sh, (Indices{3, 0}));
}

TEST(LightSplit, TheCountHoldsMainAndImportantLightsToo) {
    std::vector<Light> lights = {sun(1), point_at(2), point_at(3), point_at(9, Important), point_at(4)};
    LightSplit split = split_lights(lights, kBall, 3);
    EXPECT_EQ(split.main, 0u);
    EXPECT_EQ(split.further, (Indices{1, 3}));  // the third is the sun
    EXPECT_EQ(split.vertex, (Indices{2, 4}));
}

TEST(LightSplit, ImportantLightsArePerPixelBeyondTheCount) {
    std::vector<Light> lights(5, point_at(3, Important));
    lights.push_back(point_at(1.5f));
    LightSplit split = split_lights(lights, kBall, 2);
    EXPECT_EQ(split.further, (Indices{0, 1, 2, 3, 4}));
    EXPECT_EQ(split.vertex, (Indices{5}));
}

TEST(LightSplit, NotImportantLightsAreNeverPerPixelButTheMainOne) {
    std::vector<Light> lights = {sun(9, NotImportant), point_at(2, NotImportant), point_at(3), sun(1, NotImportant)};
    for (int count : {0, 2, 8}) {
        LightSplit split = split_lights(lights, kBall, count);
        EXPECT_EQ(split.main, 0u);
        EXPECT_EQ(split.further, count == 0 ? Indices{} : Indices{2});
        EXPECT_EQ(split.vertex, count == 0 ? (Indices{1, 2}) : Indices{1});
        EXPECT_EQ(split.sh, (Indices{3}));
    }
}

TEST(LightSplit, SpotsAreNeverPerVertex) {
    std::vector<Light> lights = {spot_at(2), point_at(3), spot_at(4)};
    LightSplit split = split_lights(lights, kBall, 0);
    EXPECT_EQ(split.vertex, (Indices{1}));
    EXPECT_EQ(split.sh, (Indices{0, 2}));
    EXPECT_EQ(split_lights(lights, kBall, 2).further, (Indices{0, 1}));
}

TEST(LightSplit, LightsOutOfReachAreInNoGroup) {
    Light far = point_at(51.5f, Important), near = point_at(50.5f);
    Light away = spot_at(3, {1, 0, 0}), past = spot_at(3, {0, 1, 0});
    std::vector<Light> lights = {far, near, away, past};
    LightSplit split = split_lights(lights, kBall, 4);
    EXPECT_EQ(split.further, (Indices{1}));
    EXPECT_TRUE(split.vertex.empty());
    EXPECT_TRUE(split.sh.empty());
}

TEST(LightSplit, OrderOfSlotsIsMainDirectionalRest) {
    std::vector<Light> lights = {point_at(1), sun(1), spot_at(2), sun(2), sun(3, NotImportant)};
    EXPECT_EQ(light_order(lights), (Indices{4, 1, 3, 0, 2}));
}

// lightAt() of nodes/stage/lights.node.hlsl in double.
double attenuation_at(const Light& light, glm::dvec3 place) {
    glm::dvec3 way = glm::dvec3(light.position) - place;
    double squared = glm::dot(way, way), ratio = squared / (double(light.range) * light.range);
    double window = std::clamp(1 - ratio * ratio, 0.0, 1.0), result = window * window / std::max(squared, 0.0001);
    if (light.kind != LightKind::Spot) return result;
    double inner = std::cos(glm::radians(double(light.inner_angle)));
    double outer = std::cos(glm::radians(double(light.outer_angle)));
    double cosine = -glm::dot(glm::normalize(glm::dvec3(light.direction)), glm::normalize(way));
    double cone = std::clamp((cosine - outer) / std::max(inner - outer, 0.001), 0.0, 1.0);
    return result * cone * cone;
}

TEST(Attenuation, OfAPointIsTheClosedForm) {
    Light light = point_at(2);
    light.range = 4;
    EXPECT_NEAR(attenuation_within(light, {}), 0.2197265625, 1e-7);  // (1 - (1/2)^4)^2 / 4
    light.position.x = 3;                                            // the ball's nearest point is as far
    EXPECT_NEAR(attenuation_within(light, kBall), 0.2197265625, 1e-7);
    EXPECT_EQ(attenuation_within(sun(1), kBall), 1);
}

TEST(Attenuation, WithinASphereIsNoLessThanAnywhereInIt) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> number(-1, 1);
    auto vector = [&] { return glm::vec3(number(random), number(random), number(random)); };
    int reached = 0;
    for (int i = 0; i < 20000; i++) {
        Light light{.kind = i % 2 ? LightKind::Point : LightKind::Spot,
                    .position = 3.0f * vector(),
                    .direction = vector(),
                    .range = 2,
                    .outer_angle = 25};
        Sphere sphere{.center = vector(), .radius = 0.5f + 0.5f * number(random)};
        glm::vec3 inside = vector();
        if (glm::length(inside) > 1 || glm::length(light.direction) < 0.1f) continue;
        double there = attenuation_at(light, glm::dvec3(sphere.center + sphere.radius * inside));
        reached += there > 0;
        EXPECT_LE(there, attenuation_within(light, sphere) * (1 + 1e-4)) << i;
    }
    EXPECT_GT(reached, 200);
}

// E / pi: Ramamoorthi and Hanrahan 2001.
glm::vec3 irradiance(const SphericalHarmonics& sh, glm::vec3 normal) {
    constexpr float kBands[] = {1, 2.0f / 3, 2.0f / 3, 2.0f / 3, 0.25f, 0.25f, 0.25f, 0.25f, 0.25f};
    std::array<float, 9> basis = spherical_harmonics_basis(glm::normalize(normal));
    glm::vec3 sum(0);
    for (std::size_t i = 0; i < 9; i++) sum += sh.coefficients[i] * (basis[i] * kBands[i]);
    return sum;
}

TEST(LightAsSphericalHarmonics, IsTheLightWhereItIsFaced) {
    const glm::vec3 color(1, 2, 0.5f);
    for (glm::vec3 direction : {glm::vec3(0, 0, 1), glm::vec3(1, -2, 2) / 3.0f, glm::vec3(-0.6f, 0.8f, 0)}) {
        SphericalHarmonics sh;
        add_light(sh, direction, color);
        glm::vec3 aside = glm::cross(direction, glm::vec3(0.48f, 0.6f, 0.64f));
        for (int c = 0; c < 3; c++) {
            EXPECT_NEAR(irradiance(sh, direction)[c], color[c], 1e-5);
            // 1/16 and 3/32 of what nine coefficients make 17/16 of (Sloan 2008).
            EXPECT_NEAR(irradiance(sh, -direction)[c], color[c] / 17, 1e-5);
            EXPECT_NEAR(irradiance(sh, aside)[c], color[c] * 3 / 34, 1e-5);
        }
    }
}

TEST(LightAsSphericalHarmonics, MeanIsAQuarterTimesTheScale) {
    // The mean of max(n.l, 0) over the sphere is 1/4; the scale is 16/17.
    SphericalHarmonics sh;
    add_light(sh, glm::vec3(2, 3, 6) / 7.0f, glm::vec3(1));
    double sum = 0;
    constexpr int kRows = 200, kColumns = 32;
    for (int row = 0; row < kRows; row++) {
        double z = (row + 0.5) / kRows * 2 - 1, radius = std::sqrt(1 - z * z);
        for (int column = 0; column < kColumns; column++) {
            double angle = 2 * std::numbers::pi * (column + 0.5) / kColumns;
            sum += irradiance(sh, {radius * std::cos(angle), radius * std::sin(angle), z}).x;
        }
    }
    EXPECT_NEAR(sum / (kRows * kColumns), 4.0 / 17, 1e-5);
}

TEST(LightAsSphericalHarmonics, PointIsSeenFromTheObjectsMiddle) {
    Light light = point_at(0);
    light.position = {1, 2, 5};
    light.range = 4;
    light.color = {2, 1, 1};
    SphericalHarmonics sh;
    add_light(sh, light, {.center = {1, 2, 3}, .radius = 0.5f});
    EXPECT_NEAR(irradiance(sh, {0, 0, 1}).x, 2 * 0.2197265625, 1e-5);

    // From inside, it is as far as the surface.
    sh = {};
    add_light(sh, light, {.center = {1, 2, 4.5f}, .radius = 2});
    EXPECT_NEAR(irradiance(sh, {0, 0, 1}).y, 0.2197265625, 1e-5);
    // In the very middle it has no direction.
    sh = {};
    add_light(sh, light, {.center = light.position, .radius = 2});
    EXPECT_NEAR(irradiance(sh, {0, 0, 1}).y, 0.2197265625 * 4 / 17, 1e-5);
    EXPECT_NEAR(irradiance(sh, {0, 0, -1}).y, 0.2197265625 * 4 / 17, 1e-5);
}

TEST(LightAsSphericalHarmonics, SpotCountsAsItsConeSays) {
    // acos(0.8) from the axis: a quarter of the light, between cosines of 0.9 and 0.7.
    Light light = spot_at(2, {-0.8f, 0.6f, 0});
    light.range = 4;
    light.inner_angle = float(glm::degrees(std::acos(0.9)));
    light.outer_angle = float(glm::degrees(std::acos(0.7)));
    SphericalHarmonics sh;
    add_light(sh, light, kBall);
    EXPECT_NEAR(irradiance(sh, {1, 0, 0}).x, 0.2197265625 / 4, 1e-5);
    light.direction = {0, 1, 0};
    sh = {};
    add_light(sh, light, kBall);
    EXPECT_EQ(sh.coefficients[0].x, 0);
}

}  // namespace
}  // namespace patina::runtime
