// The order of a frame, and the values of each of its steps: one rendering path after the other.
#include "runtime/frame/frame_plan.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "frame_plan_testing.h"
#include "runtime/lights/light_split.h"

namespace patina::runtime {
namespace {

// --- forward

TEST(ForwardFrame, ObjectsComeByQueueThenInTheOrderOfTheScene) {
    Stage stage;
    std::size_t late = stage.add_material(reflection_of("forward", {forward_pass(2450)}));
    std::size_t early = stage.add_material(reflection_of("forward", {forward_pass(2000)}));
    for (std::size_t material : {late, early, late, early}) stage.add_object(material);
    EXPECT_EQ(stage.story(), "forward 1 | forward 3 | forward 0 | forward 2");
}

TEST(ForwardFrame, TargetsHaveTheSizeOfThePicture) {
    Stage stage;
    stage.world.view.width = 30;
    stage.world.view.height = 20;
    stage.world.view.samples = 4;
    stage.world.view.background = {1, 2, 3, 4};
    stage.add_object(stage.add_material(reflection_of("forward", {forward_pass()})));
    Frame frame = stage.plan();
    ASSERT_EQ(frame.targets.size(), 2u);
    EXPECT_EQ(frame.targets[frame.shown].name, "color");
    EXPECT_EQ(frame.targets[frame.shown].clear, glm::vec4(1, 2, 3, 4));
    EXPECT_EQ(frame.samples, 4);
    for (const FrameTarget& each : frame.targets) {
        EXPECT_EQ(each.width, 120);
        EXPECT_EQ(each.height, 80);
    }
    EXPECT_EQ(target(frame, "depth")->format, TargetFormat::Depth);
    EXPECT_EQ(target(frame, "depth")->clear.x, 1);
    const FrameStep& step = frame.steps.at(0);
    EXPECT_EQ(step.targets, (std::vector<std::size_t>{frame.shown}));
    EXPECT_EQ(&frame.targets[std::size_t(step.depth)], target(frame, "depth"));
    EXPECT_EQ(step.area.width, 0);
}

TEST(ForwardFrame, FormatsAreThoseOfThePassesOrFloat) {
    Stage stage;
    Pass pass = forward_pass();
    pass.targets.push_back(target_of("normals", TargetFormat::Rgb10A2));
    stage.add_object(stage.add_material(reflection_of("forward", {pass})));
    EXPECT_EQ(target(stage.plan(), "color")->format, TargetFormat::Rgba32F);
    EXPECT_EQ(target(stage.plan(), "normals")->format, TargetFormat::Rgb10A2);
    stage.options.shown_format.reset();
    EXPECT_EQ(target(stage.plan(), "color")->format, TargetFormat::Rgba16F);
    stage.options.exact = true;
    EXPECT_EQ(target(stage.plan(), "color")->format, TargetFormat::Rgba32F);
    EXPECT_EQ(target(stage.plan(), "normals")->format, TargetFormat::Rgba32F);
    EXPECT_EQ(target(stage.plan(), "depth")->format, TargetFormat::Depth);
}

TEST(ForwardFrame, AllLightsAreSeenMainFirst) {
    Stage stage;
    stage.world.view.lights = {
        point_light({3, 0, 0}), {.color = glm::vec3(1)}, {.color = glm::vec3(2)}, point_light({90, 0, 0}, 1)};
    stage.add_object(stage.add_material(reflection_of("forward", {forward_pass()})));
    Frame frame = stage.plan();
    EXPECT_EQ(lights_seen(frame.steps.at(0)), (Ints{2, 1, 0, 3}));
    EXPECT_EQ(value(frame.steps[0], "lightCone")[3], -1);  // no shadow map
}

TEST(ForwardFrame, AnObjectHasItsOwnMatrix) {
    Stage stage;
    stage.add_object(stage.add_material(reflection_of("forward", {forward_pass()})), {1, 2, 3}, 0.5f);
    std::vector<float> matrix = value(stage.plan().steps.at(0), "objectToWorld");
    EXPECT_EQ(matrix, (std::vector<float>{0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, 0.5f, 0, 1, 2, 3, 1}));
}

TEST(ForwardFrame, BlendedObjectsComeLastFarthestFirst) {
    for (bool is_parallel : {false, true}) {
        Stage stage;
        stage.world.view.camera.position = {0, 0, 10};
        if (is_parallel) stage.world.view.camera.orthographic_height = 5;
        std::size_t glass = stage.add_material(reflection_of("forward", {forward_pass(3000)}));
        std::size_t overlay = stage.add_material(reflection_of("forward", {forward_pass(4000)}));
        std::size_t solid = stage.add_material(reflection_of("forward", {forward_pass()}));
        stage.add_object(overlay, {0, 0, -50});
        stage.add_object(glass, {0, 0, 5});
        stage.add_object(glass, {0, 0, -5});
        stage.add_object(glass, {9, 0, 2});  // farther than the next, but not along the view
        stage.add_object(glass, {0, 0, 1});
        stage.add_object(solid);
        EXPECT_EQ(stage.story(), is_parallel ? "forward 5 | forward 2 | forward 4 | forward 3 | forward 1 | forward 0"
                                             : "forward 5 | forward 2 | forward 3 | forward 4 | forward 1 | forward 0");
    }
}

// --- forward-base and forward-add

std::vector<Pass> base_and_add(int queue = 2000) {
    Pass base = forward_pass(queue), add = forward_pass(queue);
    base.name = "base";
    base.lights = PassLights::Main;
    add.name = "add";
    add.each = PassEach::Light;
    add.lights = PassLights::Further;
    add.targets[0].blend.destination = BlendFactor::One;
    return {base, add};
}

TEST(AdditiveFrame, EachFurtherLightIsAStepOfItsOwn) {
    Stage stage;
    stage.world.view.lights = {point_light({0, 3, 0}), {}, point_light({0, 2, 0}), point_light({0, 99, 0}, 1)};
    std::size_t material = stage.add_material(reflection_of("forward", base_and_add()));
    stage.add_object(material);
    stage.add_object(material, {0, 97.5f, 0});
    Frame frame = stage.plan();
    // Pass by pass. The second object is out of reach of all but the sun and the last light.
    EXPECT_EQ(stage.story(frame), "base 0 | base 1 | add 0 | add 0 | add 1");
    EXPECT_EQ(lights_seen(frame.steps[0]), (Ints{1}));
    EXPECT_EQ(lights_seen(frame.steps[1]), (Ints{1}));
    EXPECT_EQ(lights_seen(frame.steps[2]), (Ints{2}));
    EXPECT_EQ(lights_seen(frame.steps[3]), (Ints{0}));
    EXPECT_EQ(lights_seen(frame.steps[4]), (Ints{3}));
}

TEST(AdditiveFrame, LightsOutOfReachAreSkippedWhateverLightsAPassWants) {
    Stage stage;
    stage.world.view.lights = {point_light({0, 99, 0}, 1), point_light({0, 2, 0}), {}};
    Pass pass = forward_pass();
    pass.each = PassEach::Light;
    stage.add_object(stage.add_material(reflection_of("forward", {pass})));
    Frame frame = stage.plan();
    ASSERT_EQ(stage.story(frame), "forward 0 | forward 0");
    EXPECT_EQ(lights_seen(frame.steps[0]), (Ints{2}));
    EXPECT_EQ(lights_seen(frame.steps[1]), (Ints{1}));
    stage.reflections[0].passes[0].lights = PassLights::Local;
    frame = stage.plan();
    ASSERT_EQ(stage.story(frame), "forward 0");
    EXPECT_EQ(lights_seen(frame.steps[0]), (Ints{1}));
    stage.reflections[0].passes[0].lights = PassLights::None;
    EXPECT_EQ(stage.story(), "");
}

TEST(AdditiveFrame, LightsThatAreLeftGoToTheBasePass) {
    Stage stage;
    for (int i = 0; i < 6; i++) {
        stage.world.view.lights.push_back(point_light({0, 2 + float(i), 0}));
        stage.world.view.lights.back().color = glm::vec3(1, 0, float(i));
    }
    stage.world.view.lights.push_back(point_light({0, 2, 0}));
    stage.world.view.lights.back().kind = LightKind::Spot;
    stage.world.view.lights.back().direction = {0, -3, 0};
    stage.world.view.lights.back().importance = LightImportance::NotImportant;
    stage.world.view.ambient = constant_ambient(glm::vec3(0.25f));
    stage.world.pixel_light_count = 1;
    stage.add_object(stage.add_material(reflection_of("forward", base_and_add())));
    Frame frame = stage.plan();
    EXPECT_EQ(stage.story(frame), "base 0 | add 0");
    EXPECT_EQ(lights_seen(frame.steps[0]), Ints{});
    std::vector<float> colors = value(frame.steps[0], "lightColor");
    LightSplit split = split_lights(stage.world.view.lights, {.radius = 1}, 1);
    ASSERT_EQ(split.vertex.size(), 4u);
    for (std::size_t i = 0; i < 4; i++) EXPECT_EQ(colors[4 * i + 2], float(split.vertex[i])) << i;
    // One point is left over, and the spot that is not important.
    SphericalHarmonics expected = stage.world.view.ambient;
    ASSERT_EQ(split.sh.size(), 2u);
    for (std::size_t i : split.sh) add_light(expected, stage.world.view.lights[i], {.radius = 1});
    std::vector<float> ambient = value(frame.steps[0], "ambientSH");
    for (std::size_t i = 0; i < 9; i++)
        for (int c = 0; c < 3; c++) EXPECT_NEAR(ambient[4 * i + std::size_t(c)], expected.coefficients[i][c], 1e-4);
    // The additive pass has neither.
    EXPECT_EQ(value(frame.steps[1], "vertexLightCount"), std::vector<float>{0});
    EXPECT_NEAR(value(frame.steps[1], "ambientSH")[8], 0, 1e-6);
}

TEST(AdditiveFrame, EveryLightThatReachesAnObjectIsSeenOnce) {
    std::mt19937 random(17);
    std::uniform_real_distribution<float> number(-6, 6);
    std::uniform_int_distribution<int> three(0, 2);
    for (int round = 0; round < 30; round++) {
        Stage stage;
        for (int i = 0; i < 14; i++) {
            float x = number(random), y = number(random), z = number(random);
            Light light = point_light({x, y, z}, 4);
            light.kind =
                std::array{LightKind::Point, LightKind::Spot, LightKind::Directional}[std::size_t(three(random))];
            light.importance = std::array{LightImportance::Auto, LightImportance::Important,
                                          LightImportance::NotImportant}[std::size_t(three(random))];
            light.direction = {y + 0.1f, z, x};
            stage.world.view.lights.push_back(light);
        }
        stage.world.pixel_light_count = 14;
        stage.add_object(stage.add_material(reflection_of("forward", base_and_add())));
        Frame frame = stage.plan();
        const auto is_directional = [](const Light& light) { return light.kind == LightKind::Directional; };
        const std::vector<Light>& all = stage.world.view.lights;  // of one brightness: the main one is the first
        const auto main = std::find_if(all.begin(), all.end(), is_directional);
        std::vector<int> count(14, 0);
        for (const FrameStep& step : frame.steps)
            for (int i : lights_seen(step)) count[std::size_t(i)]++;
        for (std::size_t i = 0; i < count.size(); i++) {
            const Light& light = stage.world.view.lights[i];
            bool reaches = attenuation_within(light, {.radius = 1.001f}) > 0;
            bool is_per_pixel = light.importance != LightImportance::NotImportant || all.begin() + int(i) == main;
            EXPECT_LE(count[i], reaches && is_per_pixel ? 1 : 0) << round << " " << i;
            if (attenuation_within(light, {.radius = 0.9f}) > 0 && is_per_pixel) {
                EXPECT_EQ(count[i], 1) << round;
            }
        }
    }
}

TEST(AdditiveFrame, ABlendedObjectIsFinishedBeforeTheNext) {
    Stage stage;
    stage.world.view.lights = {{}, point_light({0, 3, 0})};
    std::size_t material = stage.add_material(reflection_of("forward", base_and_add(3000)));
    stage.add_object(material, {0, 0, 2});
    stage.add_object(material, {0, 0, -2});
    EXPECT_EQ(stage.story(), "base 1 | add 1 | base 0 | add 0");
}

// --- shadows

std::vector<Pass> with_caster(std::vector<Pass> passes) {
    Pass caster = forward_pass();
    caster.name = "caster";
    caster.each = PassEach::Light;
    caster.lights = PassLights::Shadowed;
    caster.depth_target = "sunMap";
    caster.targets.clear();
    passes.insert(passes.begin(), caster);
    for (std::size_t i = 1; i < passes.size(); i++) passes[i].textures.push_back("sunMapTexture");
    return passes;
}

Reflection shadowed(std::vector<Pass> passes) {
    Reflection reflection = reflection_of("forward", with_caster(std::move(passes)));
    reflection.textures = {texture_of("sunMapTexture", "sunMap")};
    return reflection;
}

Light caster_light(Light light, float strength = 1) {
    light.shadow = {.casts = true, .strength = strength, .bias = 0.125f};
    return light;
}

TEST(ShadowFrame, EachLightThatCastsDrawsItsMapFirst) {
    Stage stage;
    Light spot = point_light({0, 8, 0});
    spot.kind = LightKind::Spot;
    spot.direction = {0, -1, 0};
    stage.world.view.lights = {point_light({0, 3, 0}), caster_light({}, 0.75f), caster_light(spot)};
    std::size_t solid = stage.add_material(shadowed({forward_pass()}));
    std::size_t glass = stage.add_material(shadowed({forward_pass(3000)}));
    std::size_t still = stage.add_material(reflection_of("forward", {forward_pass()}));
    stage.add_object(glass);
    stage.add_object(solid);
    stage.add_object(still);
    stage.add_object(solid, {40, 0, 0});  // out of the spot's reach
    Frame frame = stage.plan();
    EXPECT_EQ(stage.story(frame),
              "caster 0 | caster 1 | caster 3 | caster 0 | caster 1 | forward 1 | forward 2 | forward 3 | forward 0");

    const FrameTarget* atlas = target(frame, "sunMap");
    EXPECT_EQ(atlas->width, 2048);
    EXPECT_EQ(atlas->height, 2048);
    EXPECT_EQ(atlas->format, TargetFormat::Depth);
    EXPECT_EQ(atlas->clear.x, 1);
    const FrameStep &sun = frame.steps[0], &cone = frame.steps[3], &seen = frame.steps[5];
    EXPECT_TRUE(sun.targets.empty());
    EXPECT_EQ(&frame.targets[std::size_t(sun.depth)], atlas);
    EXPECT_LT(sun.area.x + sun.area.width, 1024);
    EXPECT_GT(cone.area.x, 1024);
    EXPECT_EQ(lights_seen(sun), (Ints{1}));
    EXPECT_EQ(lights_seen(cone), (Ints{2}));
    EXPECT_EQ(value(sun, "viewIsOrthographic")[0], 1);
    EXPECT_EQ(value(cone, "viewIsOrthographic")[0], 0);
    EXPECT_EQ(value(sun, "shadowBias")[0], 0.125f);
    EXPECT_NE(value(sun, "worldToClip"), value(seen, "worldToClip"));

    EXPECT_EQ(lights_seen(seen), (Ints{1, 0, 2}));
    std::vector<float> cones = value(seen, "lightCone");
    EXPECT_EQ((Ints{int(cones[3]), int(cones[7]), int(cones[11])}), (Ints{0, -1, 1}));
    EXPECT_EQ(value(seen, "shadowTexel")[0], 1.0f / 2048);
    EXPECT_EQ(value(seen, "shadowStrength"), (std::vector<float>{0.75f, 1, 0, 0}));
    EXPECT_EQ(value(seen, "shadowBias")[0], 0);
    ASSERT_EQ(seen.reads.size(), 1u);
    EXPECT_EQ(&frame.targets[seen.reads[0].target], atlas);
}

TEST(ShadowFrame, WithoutCastingLightsThereIsOneLitTexel) {
    Stage stage;
    stage.world.view.lights = {{}};
    stage.add_object(stage.add_material(shadowed({forward_pass()})));
    Frame frame = stage.plan();
    EXPECT_EQ(stage.story(frame), "forward 0");
    EXPECT_EQ(target(frame, "sunMap")->width, 1);
    EXPECT_EQ(target(frame, "sunMap")->format, TargetFormat::Depth);
    EXPECT_EQ(target(frame, "sunMap")->clear.x, 1);

    // The same where nobody casts a shadow: the only pass that names the map reads it.
    Stage glass;
    glass.world.view.lights = {caster_light({})};
    Reflection reflection = shadowed({forward_pass()});
    reflection.passes.erase(reflection.passes.begin());
    glass.add_object(glass.add_material(reflection));
    frame = glass.plan();
    EXPECT_EQ(target(frame, "sunMap")->width, 1);
    EXPECT_EQ(target(frame, "sunMap")->clear.x, 1);
    EXPECT_EQ(value(frame.steps[0], "lightCone")[3], -1);
}

TEST(ShadowFrame, RefusesWhatHasNoMap) {
    Stage stage;
    stage.add_object(stage.add_material(shadowed({forward_pass()})));
    stage.world.view.lights = std::vector<Light>(4, caster_light({}));
    EXPECT_EQ(stage.error(), "");
    stage.world.view.lights.push_back(caster_light({}));
    EXPECT_EQ(stage.error(), "more than 4 lights cast shadows");
    stage.world.view.lights = {{}, caster_light(point_light({0, 3, 0}))};
    EXPECT_EQ(stage.error(), "light 1 is a point light, which has no shadow map: only directional lights and spots do");
    stage.world.view.lights = {};
    stage.options.shadow_atlas_size = 63;
    EXPECT_EQ(stage.error(), "the shadow atlas must have an even number of texels along a side, 64 or more, not 63");
}

// --- scene colour and depth

TEST(ReadingFrame, ReadersOfTheirOwnTargetsComeAfterTheOpaque) {
    for (std::string read : {"color", "depth"}) {
        Stage stage;
        stage.options.path = "forward";
        Pass pass = forward_pass();
        pass.textures = {"scene"};
        Reflection reflection = reflection_of("forward", {pass});
        reflection.textures = {texture_of("scene", read)};
        std::size_t water = stage.add_material(reflection);
        std::size_t solid = stage.add_material(reflection_of("forward", {forward_pass(2450)}));
        std::size_t other = stage.add_material(reflection_of("vertex", {forward_pass()}));
        std::size_t glass = stage.add_material(reflection_of("forward", {forward_pass(3000)}));
        for (std::size_t material : {glass, water, other, solid}) stage.add_object(material);
        Frame frame = stage.plan();
        EXPECT_EQ(stage.story(frame), "forward 3 | forward 2 | forward 1 | forward 0");
        ASSERT_EQ(frame.steps[2].reads.size(), 1u);
        EXPECT_EQ(frame.targets[frame.steps[2].reads[0].target].name, read);
    }
}

TEST(ReadingFrame, WhatAnEarlierPassDrewIsReadInPlace) {
    // Depth and normals first, then a pass that reads the normals: no reason to wait for others.
    Stage stage;
    Pass first = forward_pass(), second = forward_pass();
    first.name = "normals";
    first.targets = {target_of("normals")};
    second.textures = {"normalsTexture"};
    Reflection reflection = reflection_of("forward", {first, second});
    reflection.textures = {texture_of("normalsTexture", "normals")};
    stage.add_object(stage.add_material(reflection));
    stage.add_object(stage.add_material(reflection_of("forward", {forward_pass(2450)})));
    EXPECT_EQ(stage.story(), "normals 0 | forward 0 | forward 1");
}

// --- textures of the engine

std::shared_ptr<const TextureData> texel(float red) {
    return std::make_shared<const TextureData>(
        TextureData{.levels = {{.width = 1, .height = 1, .texels = {red, 0, 0, 1}}}, .sampler = {}});
}

const LoadedTexture* bound(const FrameStep& step, const std::string& name) {
    const LoadedTexture* found = nullptr;
    for (const LoadedTexture& texture : step.textures)
        if (texture.name == name) {
            EXPECT_EQ(found, nullptr) << name << " is bound twice";
            found = &texture;
        }
    return found;
}

TEST(EngineTextures, LightmapsAreTheObjectsAndCookiesTheLights) {
    Stage stage;
    Pass pass = forward_pass();
    pass.each = PassEach::Light;
    pass.textures = {"_MainTex", "lightmapTexture", "lightCookie", "shadowMaskTexture"};
    Reflection reflection = reflection_of("forward", {pass});
    reflection.textures = {texture_of("_MainTex"), texture_of("lightmapTexture"), texture_of("lightCookie"),
                           texture_of("shadowMaskTexture"), texture_of("unread")};
    reflection.textures[0].is_material = true;
    std::size_t material = stage.add_material(reflection);
    const std::vector<LoadedTexture> own = {{.name = "_MainTex", .data = texel(0.5f)}};
    stage.materials[material].textures = own;
    stage.add_object(material);
    stage.add_object(material);
    const std::vector<std::vector<LoadedTexture>> of_objects = {{{.name = "lightmapTexture", .data = texel(0.25f)}}};
    stage.options.object_textures = of_objects;
    Light lamp = point_light({0, 3, 0});
    lamp.kind = LightKind::Spot;
    lamp.direction = {0, -1, 0};
    lamp.cookie = texel(0.75f);
    stage.world.view.lights = {{}, lamp};

    Frame frame = stage.plan();
    ASSERT_EQ(stage.story(frame), "forward 0 | forward 0 | forward 1 | forward 1");
    auto red = [&](std::size_t step, const std::string& name) {
        const LoadedTexture* texture = bound(frame.steps[step], name);
        return texture ? texture->data->levels[0].texels[0] : -1;
    };
    for (std::size_t step = 0; step < 4; step++) {
        EXPECT_EQ(red(step, "_MainTex"), 0.5f);
        EXPECT_EQ(red(step, "lightmapTexture"), step < 2 ? 0.25f : 1);
        EXPECT_EQ(red(step, "shadowMaskTexture"), 1);
        EXPECT_EQ(red(step, "lightCookie"), step % 2 ? 0.75f : 1);
        EXPECT_EQ(bound(frame.steps[step], "unread"), nullptr);
        EXPECT_EQ(value(frame.steps[step], "lightAxis")[3], step % 2 ? 1 : 0);
        // An object without a lightmap has no baked light: its factor is 0.
        EXPECT_EQ(value(frame.steps[step], "lightmapDecode"),
                  (step < 2 ? std::vector<float>{1, 1, 0, 0} : std::vector<float>{0, 1, 0, 0}));
    }
}

TEST(EngineTextures, LiveAsLongAsTheFrame) {
    Pass pass = forward_pass();
    pass.textures = {"lightmapTexture"};
    Reflection reflection = reflection_of("forward", {pass});
    reflection.textures = {texture_of("lightmapTexture")};
    Stage stage;
    stage.add_object(stage.add_material(reflection));
    Frame copy;
    {
        Frame frame = stage.plan();
        copy = frame;
    }
    EXPECT_EQ(bound(copy.steps.at(0), "lightmapTexture")->data->levels[0].texels, (std::vector<float>{1, 1, 1, 1}));
}

// --- mistakes

TEST(FramePlan, AnEmptyWorldIsItsBackground) {
    Frame frame = Stage{}.plan();
    EXPECT_TRUE(frame.steps.empty());
    ASSERT_EQ(frame.targets.size(), 1u);
    EXPECT_EQ(frame.targets[0].name, "color");
}

TEST(FramePlan, SaysWhatIsWrongAndWhere) {
    Stage stage;
    std::size_t material = stage.add_material(reflection_of("forward", {forward_pass()}));
    stage.add_object(material);
    Pass& pass = stage.reflections[0].passes[0];
    const std::string subject = "pass 'forward' of the material 'material 0' ";
    pass.draws = PassDraws::LightVolumes;
    EXPECT_EQ(stage.error(),
              subject + "draws light volumes, so its lights must be 'local': directional ones have no volume");
    pass.lights = PassLights::Shadowed;
    EXPECT_EQ(stage.error(), subject + "draws from the lights, so it must draw objects");
    pass = forward_pass();
    stage.materials[0].passes.clear();
    EXPECT_EQ(stage.error(), subject + "has no shaders");
    stage.materials[0].reflection = nullptr;
    EXPECT_EQ(stage.error(), "the material 'material 0' was not compiled");
}

TEST(FramePlan, RefusesAWorldThatDoesNotHoldTogether) {
    Stage stage;
    std::size_t material = stage.add_material(reflection_of("forward", {forward_pass()}));
    stage.add_object(material);
    stage.world.objects[0].material = 7;
    EXPECT_EQ(stage.error(), "the object 'object 0' has no material");
    stage.world.objects[0].mesh = nullptr;
    EXPECT_EQ(stage.error(), "the object 'object 0' has no mesh");
    stage.world.view.lights.resize(17);
    EXPECT_EQ(stage.error(), "the scene has 17 lights; a pass sees 16 at most");
    stage.world.materials.emplace_back();
    EXPECT_EQ(stage.error(), "1 materials were compiled, the scene has 2");
}

TEST(FramePlan, RefusesTargetsThatPassesSeeDifferently) {
    Stage stage;
    Pass pass = forward_pass();
    pass.targets.push_back(target_of("extra", TargetFormat::Rgba8));
    stage.add_object(stage.add_material(reflection_of("forward", {pass})));
    pass.targets[1].format = TargetFormat::R32F;
    stage.add_object(stage.add_material(reflection_of("forward", {pass})));
    EXPECT_EQ(
        stage.error(),
        "pass 'forward' of the material 'material 1' draws into the target 'extra' as r32f, but another pass as rgba8");
    stage.options.exact = true;
    EXPECT_EQ(stage.error(), "");

    Stage mixed;
    Reflection reflection = shadowed({forward_pass()});
    reflection.passes[0].depth_target = "depth";
    mixed.world.view.lights = {caster_light({})};
    mixed.add_object(mixed.add_material(reflection));
    EXPECT_EQ(mixed.error(),
              "pass 'forward' of the material 'material 0' and another pass draw into the target 'depth', one from a "
              "light and one from the camera");
}

}  // namespace
}  // namespace patina::runtime
