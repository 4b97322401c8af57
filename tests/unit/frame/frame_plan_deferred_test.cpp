// The order of a deferred frame: objects by lighting group, then each light once for each group.
#include <gtest/gtest.h>

#include "frame_plan_testing.h"
#include "runtime/frame/frame_plan.h"

namespace patina::runtime {
namespace {

std::vector<Pass> deferred_passes() {
    Pass gbuffer = forward_pass();
    gbuffer.name = "gbuffer";
    gbuffer.lights = PassLights::None;
    gbuffer.camera = PassCamera::Perspective;
    gbuffer.fallback = "forward";
    gbuffer.stencil = {.test = Compare::Always, .pass = StencilOp::Replace, .reference = StencilReference::Lighting};
    gbuffer.targets = {target_of("gbufferNormal", TargetFormat::Rgb10A2), target_of("color")};
    Pass sun = gbuffer;
    sun.name = "sun";
    sun.draws = PassDraws::Fullscreen;
    sun.each = PassEach::Light;
    sun.lights = PassLights::Directional;
    sun.stencil = {.test = Compare::Equal, .pass = StencilOp::Keep, .reference = StencilReference::Lighting};
    sun.targets = {target_of("color")};
    sun.blocks = {"Lights", "Camera"};
    sun.textures = {"normalTexture"};
    Pass local = sun;
    local.name = "local";
    local.draws = PassDraws::LightVolumes;
    local.lights = PassLights::Local;
    return {gbuffer, sun, local};
}

Reflection deferred() {
    Reflection reflection = reflection_of("deferred", deferred_passes());
    reflection.textures = {texture_of("normalTexture", "gbufferNormal")};
    return reflection;
}

TEST(DeferredFrame, LightsAreDrawnOnceForEachGroup) {
    Stage stage;
    stage.options.path = "deferred";
    stage.world.view.lights = {point_light({0, 3, 0}), {}, {}};
    std::size_t metal = stage.add_material(deferred());
    std::size_t toon = stage.add_material(deferred(), {{"sun", "toon"}, {"local", "toon"}});
    std::size_t stone = stage.add_material(deferred());  // lit as metal is
    std::size_t glass = stage.add_material(reflection_of("forward", {forward_pass(3000)}));
    std::size_t odd = stage.add_material(reflection_of("forward", {forward_pass()}));
    for (std::size_t material : {glass, odd, metal, toon, stone}) stage.add_object(material);
    Frame frame = stage.plan();
    EXPECT_EQ(stage.story(frame),
              "gbuffer 2 | gbuffer 3 | gbuffer 4 | sun screen | sun screen | sun screen | sun screen | "
              "local volume | local volume | forward 1 | forward 0");
    Ints stencil;
    for (const FrameStep& step : frame.steps) stencil.push_back(step.stencil_reference);
    EXPECT_EQ(stencil, (Ints{1, 2, 1, 1, 1, 2, 2, 1, 2, 0, 0}));
    EXPECT_EQ(lights_seen(frame.steps[3]), (Ints{1}));
    EXPECT_EQ(lights_seen(frame.steps[4]), (Ints{2}));
    EXPECT_EQ(lights_seen(frame.steps[7]), (Ints{0}));
    // The lighting passes read what the first has drawn.
    ASSERT_EQ(frame.steps[3].reads.size(), 1u);
    EXPECT_EQ(frame.steps[3].reads[0].texture, "normalTexture");
    EXPECT_EQ(&frame.targets[frame.steps[3].reads[0].target], target(frame, "gbufferNormal"));
    EXPECT_TRUE(frame.steps[0].reads.empty());
}

TEST(DeferredFrame, AMaterialThatItsLightingReadsIsAGroupOfItsOwn) {
    Stage stage;
    stage.world.view.lights = {{}};
    Reflection reading = deferred();
    for (Pass& pass : reading.passes)
        if (pass.name != "gbuffer") pass.blocks.push_back("Material");
    std::size_t first = stage.add_material(reading), second = stage.add_material(reading);
    std::size_t plain = stage.add_material(deferred());
    for (std::size_t material : {first, second, plain}) stage.add_object(material);
    Frame frame = stage.plan();
    EXPECT_EQ(stage.story(frame), "gbuffer 0 | gbuffer 1 | gbuffer 2 | sun screen | sun screen | sun screen");
    for (std::size_t i = 0; i < 3; i++) {
        EXPECT_EQ(frame.steps[i].stencil_reference, int(i) + 1);
        EXPECT_EQ(frame.steps[3 + i].stencil_reference, int(i) + 1);
        EXPECT_EQ(frame.steps[3 + i].reflection, stage.materials[i].reflection);
    }
}

TEST(DeferredFrame, ShadersAreToldApartBySpirvToo) {
    Stage stage;
    stage.world.view.lights = {{}};
    const std::vector<std::uint32_t> one = {1, 2, 3}, same = {1, 2, 3}, other = {1, 2, 4};
    for (const auto* spirv : {&one, &same, &other}) {
        std::size_t material = stage.add_material(deferred());
        for (auto& [name, pass] : stage.materials[material].passes) pass = {.stages = {.fragment_spirv = *spirv}};
        stage.add_object(material);
    }
    EXPECT_EQ(stage.story(), "gbuffer 0 | gbuffer 1 | gbuffer 2 | sun screen | sun screen");
}

TEST(DeferredFrame, AnUnlitMaterialIsNotLitByAnother) {
    Stage stage;
    stage.world.view.lights = {{}};
    Reflection unlit = deferred();
    unlit.passes.resize(1);
    stage.add_object(stage.add_material(unlit));
    stage.add_object(stage.add_material(deferred()));
    Frame frame = stage.plan();
    EXPECT_EQ(stage.story(frame), "gbuffer 0 | gbuffer 1 | sun screen");
    EXPECT_NE(frame.steps[0].stencil_reference, frame.steps[2].stencil_reference);
    EXPECT_EQ(frame.steps[1].stencil_reference, frame.steps[2].stencil_reference);
}

TEST(DeferredFrame, TakesGroupsAsFarAsTheStencilCounts) {
    Stage stage;
    stage.world.view.lights = {{}};
    for (int i = 0; i < 255; i++) stage.add_object(stage.add_material(deferred(), {{"sun", std::to_string(i)}}));
    EXPECT_EQ(stage.plan().steps.at(254).stencil_reference, 255);
    stage.add_object(stage.add_material(deferred(), {{"sun", "one more"}}));
    EXPECT_EQ(stage.error(), "the materials need more than 255 different lighting passes");
}

TEST(DeferredFrame, AVolumeStandsAroundItsLight) {
    Stage stage;
    stage.world.view.camera.position = {0, 0, 20};
    stage.world.view.lights = {point_light({1, 2, 3}, 4), point_light({0, 0, 19}, 4)};
    stage.add_object(stage.add_material(deferred()));
    Frame frame = stage.plan();
    ASSERT_EQ(stage.story(frame), "gbuffer 0 | local volume | local volume");
    std::vector<float> matrix = value(frame.steps[1], "objectToWorld");
    EXPECT_EQ(matrix, (std::vector<float>{4, 0, 0, 0, 0, 4, 0, 0, 0, 0, 4, 0, 1, 2, 3, 1}));
    // The camera is within the second light: its volume is all that is seen.
    EXPECT_EQ(value(frame.steps[2], "objectToWorld")[0], 1);
    EXPECT_EQ(frame.steps[2].mesh->vertices.size(), 8u);
}

TEST(DeferredFrame, AScreenPassWithoutStencilIsDrawnOnce) {
    Stage stage;
    stage.options.path = "deferred";
    stage.world.view.lights = {{}, {}};
    for (std::string path : {"deferred", "deferred", "other"}) {
        Reflection reflection = deferred();
        reflection.path = path;
        Pass bloom = reflection.passes[1];
        bloom.name = "bloom";
        bloom.each = PassEach::Once;
        bloom.stencil = {};
        reflection.passes.push_back(bloom);
        reflection.passes.erase(reflection.passes.begin() + 1);
        stage.add_object(stage.add_material(reflection, {{"local", std::to_string(stage.materials.size())}}));
    }
    Frame frame = stage.plan();
    EXPECT_EQ(stage.story(frame), "gbuffer 0 | gbuffer 1 | bloom screen | gbuffer 2");
    EXPECT_EQ(frame.steps[2].stencil_reference, 0);
    EXPECT_EQ(lights_seen(frame.steps[2]), (Ints{0, 1}));
}

TEST(DeferredFrame, AnOrthographicCameraNeedsTheFallback) {
    Stage stage;
    stage.add_object(stage.add_material(deferred()));
    EXPECT_EQ(path_for(stage.world.view.camera, stage.reflections[0]), "deferred");
    stage.world.view.camera.orthographic_height = 3;
    EXPECT_EQ(path_for(stage.world.view.camera, stage.reflections[0]), "forward");
    EXPECT_EQ(stage.error(),
              "pass 'gbuffer' of the material 'material 0' needs a perspective camera; compile it for the path "
              "'forward'");
    stage.reflections[0].passes[0].fallback = "";
    EXPECT_EQ(stage.error(), "pass 'gbuffer' of the material 'material 0' needs a perspective camera");
    EXPECT_EQ(path_for(stage.world.view.camera, reflection_of("forward", {forward_pass()})), "forward");
}

}  // namespace
}  // namespace patina::runtime
