// The engine values of camera, lights, shadow maps and fog.
#include "runtime/values/engine_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace patina::runtime {
namespace {

using Numbers = std::vector<double>;

Numbers numbers(const std::map<std::string, EngineValue>& values, const std::string& name) {
    auto found = values.find(name);
    if (found == values.end()) ADD_FAILURE() << "no value " << name;
    return found == values.end() ? Numbers{} : found->second.numbers;
}

glm::dmat4 matrix(const std::map<std::string, EngineValue>& values, const std::string& name, std::size_t index = 0) {
    Numbers all = numbers(values, name);
    glm::dmat4 result;
    for (std::size_t i = 0; i < 16; i++) result[int(i / 4)][int(i % 4)] = all.at(16 * index + i);
    return result;
}

TEST(EngineValues, ClipToWorldIsTheWayBack) {
    Scene scene = default_scene("cube");
    scene.width = 300;
    scene.height = 200;
    auto values = engine_values(scene);
    const glm::dvec4 place(0.3, -0.2, 0.7, 1);
    glm::dvec4 back = matrix(values, "clipToWorld") * (matrix(values, "worldToClip") * place);
    for (int i = 0; i < 3; i++) EXPECT_NEAR(back[i] / back.w, place[i], 1e-4);
}

TEST(EngineValues, LightsOfASingleDrawKnowTheirNumbers) {
    Scene scene;
    scene.lights = {{.kind = LightKind::Point, .position = {1, 2, 3}},
                    {.direction = {0, 5, 0}, .color = {8, 9, 10}},
                    {.direction = {1, 0, 0}, .color = {9, 10, 11}}};
    auto values = engine_values(scene);
    Numbers cone = numbers(values, "lightCone");
    EXPECT_EQ((Numbers{cone[2], cone[6], cone[10]}), (Numbers{2, 1, 0}));     // the brighter sun comes first
    EXPECT_EQ((Numbers{cone[3], cone[7], cone[11]}), (Numbers{-1, -1, -1}));  // no shadow map
    EXPECT_EQ(numbers(values, "lightCount"), Numbers{3});
    EXPECT_EQ(numbers(values, "shadowStrength"), (Numbers{0, 0, 0, 0}));
    EXPECT_EQ(numbers(values, "shadowTexel"), Numbers{1});
}

TEST(EngineValues, FogIsItsModeAndNumbers) {
    Scene scene;
    EXPECT_EQ(numbers(engine_values(scene), "fogSettings")[0], 0);
    scene.fog = {.mode = FogMode::ExponentialSquared, .color = {1, 2, 3}, .density = 0.5f, .start = 4, .end = 6};
    auto values = engine_values(scene);
    EXPECT_EQ(numbers(values, "fogSettings"), (Numbers{3, 0.5, 4, 6}));
    EXPECT_EQ(numbers(values, "fogColor")[2], 3);
    scene.fog.mode = FogMode::Linear;
    EXPECT_EQ(numbers(engine_values(scene), "fogSettings")[0], 1);
    scene.fog.mode = FogMode::Exponential;
    EXPECT_EQ(numbers(engine_values(scene), "fogSettings")[0], 2);
}

TEST(EngineValues, VertexLightsStandBehindTheOthers) {
    Scene scene;
    Light sun{.direction = {0, 1, 0}, .color = {9, 9, 9}};
    Light first{.kind = LightKind::Point, .position = {1, 2, 3}, .color = {4, 5, 6}, .range = 10};
    Light second{.kind = LightKind::Point, .position = {7, 8, 9}, .color = {1, 1, 2}, .range = 2};
    EngineScene seen{.scene = &scene,
                     .lights = {{.light = &sun, .index = 4}},
                     .vertex_lights = {{.light = &first, .index = 2}, {.light = &second, .index = 7}}};
    auto values = engine_values(seen);
    EXPECT_EQ(numbers(values, "lightCount"), Numbers{1});
    EXPECT_EQ(numbers(values, "vertexLightCount"), Numbers{2});
    EXPECT_EQ(numbers(values, "lightPosition"), (Numbers{0, 1, 0, 0, 1, 2, 3, 1, 7, 8, 9, 1}));
    EXPECT_EQ(numbers(values, "lightColor"), (Numbers{9, 9, 9, 10, 4, 5, 6, 10, 1, 1, 2, 2}));
}

TEST(EngineValues, FourLightsCountAtVerticesAndSlotsWithoutALightHaveNoShadowMap) {
    Scene scene;
    const Light light{.kind = LightKind::Point};
    EngineScene seen{.scene = &scene, .lights = {{.light = &light}}};
    for (std::size_t i = 0; i < 9; i++) {
        const double at_vertices = double(std::min<std::size_t>(seen.vertex_lights.size(), 4));
        auto values = engine_values(seen);
        EXPECT_EQ(numbers(values, "vertexLightCount"), Numbers{at_vertices});
        const Numbers cone = numbers(values, "lightCone");
        ASSERT_EQ(cone.size(), 4 * kMostLights);
        for (std::size_t slot = 0; slot < kMostLights; slot++) EXPECT_EQ(cone[4 * slot + 3], -1) << slot;
        seen.vertex_lights.push_back({.light = &light});
    }
    seen.lights.assign(kMostLights, {.light = &light, .shadow_map = 2});  // no slot is left
    auto values = engine_values(seen);
    EXPECT_EQ(numbers(values, "vertexLightCount"), Numbers{0});
    EXPECT_EQ(numbers(values, "lightCone").size(), 4 * kMostLights);
    EXPECT_EQ(numbers(values, "lightCone").back(), 2);
}

TEST(EngineValues, ShadowMapsAreMatrixTileAndStrength) {
    Scene scene;
    Light sun{.direction = {0, 1, 0}, .shadow = {.casts = true, .strength = 0.5f}};
    scene.camera = {.position = {0, 0, 60}};
    const Mesh mesh = make_sphere(2);
    const ShadowObject ball{.mesh = &mesh, .object_to_world = glm::translate(glm::mat4(1), {3, 0, 1})};
    const ShadowView map =
        directional_shadow(sun, std::span(&ball, 1), camera_view(scene), {}, {.number = 3, .atlas_size = 512});
    EngineScene seen{.scene = &scene,
                     .lights = {{.light = &sun, .index = 5, .shadow_map = 0}},
                     .shadow_maps = std::span(&map, 1),
                     .shadow_atlas_size = 512};
    auto values = engine_values(seen);
    EXPECT_EQ(numbers(values, "worldToShadow").size(), 64u);
    glm::dvec4 middle = matrix(values, "worldToShadow") * glm::dvec4(3, 0, 1, 1);
    EXPECT_NEAR(middle.x, 0, 0.01);
    EXPECT_NEAR(middle.y, 0, 0.01);
    EXPECT_EQ(numbers(values, "shadowStrength"), (Numbers{0.5, 0, 0, 0}));
    EXPECT_EQ(numbers(values, "shadowTexel")[0], 1.0 / 512);
    Numbers tile = numbers(values, "shadowTile");
    EXPECT_EQ(tile.size(), 16u);
    EXPECT_GT(tile[2], 0.5);  // the last tile is at the lower right
    EXPECT_GT(tile[3], 0.5);
    EXPECT_EQ(numbers(values, "lightCone")[2], 5);
    EXPECT_EQ(numbers(values, "lightCone")[3], 0);
}

TEST(EngineValues, OneCookieIsBound) {
    Scene scene;
    auto picture = std::make_shared<const TextureData>();
    Light point{.kind = LightKind::Point, .cookie = picture};  // would need a cube
    Light plain{};
    Light sun{.direction = {0, 0, 1}, .cookie = picture, .cookie_size = 8};
    Light other{.direction = {0, 1, 0}, .cookie = picture};
    EngineScene seen{.scene = &scene,
                     .lights = {{.light = &point}, {.light = &plain}, {.light = &sun}, {.light = &other}}};
    EXPECT_EQ(cookie_light(seen.lights), &sun);
    auto values = engine_values(seen);
    Numbers axis = numbers(values, "lightAxis");
    EXPECT_EQ((Numbers{axis[3], axis[7], axis[11], axis[15]}), (Numbers{0, 0, 1, 0}));
    glm::dvec4 uv = matrix(values, "worldToCookie") * glm::dvec4(2, 2, 0, 1);
    EXPECT_NEAR(uv.x / uv.w, 0.75, 1e-6);
    EXPECT_NEAR(uv.y / uv.w, 0.25, 1e-6);
}

TEST(EngineValues, LightsThatCastShadowsHaveChannelsOfMasks) {
    Scene scene;
    const Light plain{.color = {9, 9, 9}}, caster{.shadow = {.casts = true}};
    scene.lights = {plain, caster, plain, caster, caster};
    EngineScene seen{.scene = &scene,
                     .lights = {{.light = &scene.lights[4], .index = 4},
                                {.light = &scene.lights[0], .index = 0},
                                {.light = &scene.lights[1], .index = 1}},
                     .vertex_lights = {{.light = &scene.lights[3], .index = 3}}};
    EXPECT_EQ(numbers(engine_values(seen), "lightMask"), (Numbers{0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0}));
}

TEST(EngineValues, SubtractiveLightmapsHoldTheMainLight) {
    Scene scene;
    scene.lights = {{.color = {1, 1, 1}}, {.color = {2, 2, 2}}};
    EngineScene seen{.scene = &scene,
                     .lights = {{.light = &scene.lights[0], .index = 0}, {.light = &scene.lights[1], .index = 1}}};
    EXPECT_EQ(numbers(engine_values(seen), "mainLight"), Numbers{-1});
    scene.mixed_lighting = {.mode = LightMixing::Subtractive, .shadow_color = {1, 2, 3}};
    EXPECT_EQ(numbers(engine_values(seen), "mainLight"), Numbers{1});
    EXPECT_EQ(numbers(engine_values(seen), "shadowColor")[2], 3);
    seen.lights.pop_back();
    EXPECT_EQ(numbers(engine_values(seen), "mainLight"), Numbers{-1});
}

TEST(EngineValues, ShadowsFadeBeforeTheirDistance) {
    Scene scene;
    EXPECT_EQ(numbers(engine_values(scene), "shadowFade"), (Numbers{0, 0}));
    const auto fade = [&](double distance) {
        const Numbers line = numbers(engine_values(scene), "shadowFade");
        return line[0] * distance + line[1];
    };
    scene.mixed_lighting = {.shadow_distance = 50.0f};
    EXPECT_NEAR(fade(40), 0, 1e-6);
    EXPECT_NEAR(fade(50), 1, 1e-6);
    scene.mixed_lighting.shadow_fade = 4.0f;
    EXPECT_NEAR(fade(46), 0, 1e-6);
    EXPECT_NEAR(fade(48), 0.5, 1e-6);
}

TEST(EngineValues, AViewMayBeALights) {
    Scene scene;
    View view{.position = {1, 2, 3}, .forward = {0, -1, 0}, .is_parallel = true, .bias = 0.5f, .normal_bias = 0.25f};
    auto values = engine_values(EngineScene{.scene = &scene, .view = view});
    EXPECT_EQ(numbers(values, "cameraPositionWS"), (Numbers{1, 2, 3}));
    EXPECT_EQ(numbers(values, "cameraForwardWS"), (Numbers{0, -1, 0}));
    EXPECT_EQ(numbers(values, "viewIsOrthographic"), Numbers{1});
    EXPECT_EQ(numbers(values, "shadowBias"), Numbers{0.5});
    EXPECT_EQ(numbers(values, "shadowNormalBias"), Numbers{0.25});
    EXPECT_EQ(numbers(engine_values(scene), "shadowBias"), Numbers{0});
}

}  // namespace
}  // namespace patina::runtime
