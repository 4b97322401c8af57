// The same picture along every path that computes light per pixel: forward is the measure. The bound is a step of a
// picture of bytes on every pixel, in linear floats.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <string_view>

#include "paths/drawing/drawing.h"
#include "runtime/scene/world_file.h"

namespace patina::paths {
namespace {

constexpr int kAllLights = 16;

glm::mat4 ball_at(float x, float y, float z, float radius) {
    return glm::scale(glm::translate(glm::mat4(1), {x, y, z}), glm::vec3(radius));
}

// The proof scene, with as many pixel lights as it has lights.
World scene() {
    World world = proof_world();
    world.pixel_light_count = kAllLights;
    return world;
}

World scene_and_metals() {
    return proof_scene_and_metals();
}

World scene_in_fog() {
    World world = proof_scene_and_metals();
    world.view.fog = {.mode = FogMode::ExponentialSquared, .color = {0.3f, 0.4f, 0.5f}, .density = 0.1f};
    return world;
}

// Stripes that the sun and the green spot shine through.
World scene_with_cookies() {
    World world = scene();
    Image stripes = runtime::make_image(8, 8, 1, 1, 1);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) stripes.at(x, y)[0] = x % 4 < 2 ? 1 : 0.25f;
    auto cookie = std::make_shared<const TextureData>(TextureData{
        .levels = runtime::mip_chain(stripes), .sampler = {.wrap = Wrap::Repeat, .filter = Filter::Linear}});
    world.view.lights[4].cookie = cookie;
    return world;
}

// Inside the volumes of the warm lamp and of the spot from the right.
World scene_from_within() {
    World world = scene();
    world.view.camera.position = {-0.6f, 1.2f, 2.9f};
    world.view.camera.fov = 70;
    return world;
}

World scene_of_the_fewest_lights() {
    World world = scene();
    world.view.lights.resize(1);
    return world;
}

std::string lacquer_of(const char* surface, const char* alpha) {
    return written(std::string(surface) + ".graph.json",
                   std::string(R"({ "patina": 1, "workflow": "metallic-roughness", "lighting": "unity-brdf1",
 "surface": { "baseColor": [0.7, 0.2, 0.3], "roughness": 0.4, "emission": [0.02, 0.05, 0.1], "alpha": )") +
                       alpha + R"( }, "render": { "surface": ")" + surface + R"(" } })");
}

// A ball of such a surface in front of the others.
World scene_behind(const char* surface) {
    World world = scene();
    add_object(world, lacquer_of(surface, "0.6"), "sphere", 0, ball_at(0.2f, 0.9f, 2.6f, 0.6f));
    return world;
}

// What 2^-light in ten bits holds: no more than half a step of 1 / 1023 says.
Image as_logarithmic(Image image) {
    for (float& number : image.pixels) number = std::min(number, float(std::log2(2 * 1023.0)));
    return image;
}

struct Case {
    const char* name;
    World (*make)();
};
void PrintTo(const Case& of, std::ostream* out) {
    *out << of.name;
}

class SamePicture : public testing::TestWithParam<Case> {};

TEST_P(SamePicture, BaseAndAddDeferredAndExtended) {
    const World world = GetParam().make();
    const Image forward = draw(world, {.path = "forward", .exact_targets = true});
    EXPECT_GT(lit_pixels(forward), forward.width * forward.height / 4);
    for (const char* path : {"forward-add", "forward-directional", "deferred", "deferred-extended", "deferred-ldr"}) {
        SCOPED_TRACE(path);
        const bool is_logarithmic = std::string_view(path) == "deferred-ldr";
        const Image expected = is_logarithmic ? as_logarithmic(forward) : forward;
        const Image other = draw(world, {.path = path, .exact_targets = true});
        const Image got = is_logarithmic ? as_logarithmic(other) : other;  // some of it may have gone the forward path
        EXPECT_SAME_PICTURE(expected, got);
        std::printf("%-12s %-19s %s\n", GetParam().name, path, to_text(difference(expected, got)).c_str());
    }
}

INSTANTIATE_TEST_SUITE_P(Of, SamePicture,
                         testing::Values(Case{"TheProofScene", scene}, Case{"MetalsBefore", scene_and_metals},
                                         Case{"Fog", scene_in_fog}, Case{"Cookies", scene_with_cookies},
                                         Case{"CameraInVolumes", scene_from_within},
                                         Case{"OneLight", scene_of_the_fewest_lights}),
                         [](const auto& info) { return std::string(info.param.name); });

// Surfaces that blend as Unity's fade and transparent ones do take additive passes.
TEST(BaseAndAdd, SurfacesThatBlend) {
    for (const char* surface : {"fade", "transparent"}) {
        SCOPED_TRACE(surface);
        const World world = scene_behind(surface);
        const Image forward = draw(world, {.path = "forward"}), parts = draw(world, {.path = "forward-add"});
        EXPECT_SAME_PICTURE(forward, parts);
        const Image deferred = draw(world, {.path = "deferred", .exact_targets = true});
        EXPECT_SAME_PICTURE(forward, deferred);
    }
}

// Others have the base pass alone, and a warning says so: of their lights the main one is left.
TEST(BaseAndAdd, SurfacesThatBlendOtherwiseHaveTheMainLightOnly) {
    for (const char* surface : {"additive", "multiply"}) {
        SCOPED_TRACE(surface);
        World world = scene_behind(surface);
        world.objects.erase(world.objects.begin(), world.objects.end() - 1);
        world.view.background = glm::vec4(0.5f);  // something to multiply
        const Drawn parts = drawn(world, {.path = "forward-add"});
        // Their alpha has no effect, either.
        EXPECT_EQ(parts.codes(), (std::vector<std::string>{"pass-left-out", "no-effect"}));
        const Image all = draw(world, {.path = "forward"});
        World main_only = world;
        main_only.view.lights.resize(1);
        EXPECT_SAME_PICTURE(parts.image, draw(main_only, {.path = "forward"}));
        EXPECT_GT(difference(parts.image, all).largest, 5 * kStep);
    }
}

// With fewer pixel lights the others are vertex lights and harmonics: near, but not the same.
TEST(BaseAndAdd, FewPixelLightsAreAnotherPicture) {
    World world = scene();
    const Image forward = draw(world, {.path = "forward"});
    world.pixel_light_count = 1;
    EXPECT_GT(difference(forward, draw(world, {.path = "forward-add"})).largest, 5 * kStep);
}

// --- what is drawn deferred

// The path that a material of the proof scene is compiled for.
std::string path_of(const World& world, const std::string& material, const std::string& path) {
    for (const runtime::WorldMaterial& one : world.materials)
        if (one.name == material) return compiled(one.graph, path).reflection.path;
    return "no such material";
}

TEST(Deferred, TakesAllButToonAndDisney) {
    const World world = scene();
    for (const runtime::WorldMaterial& material : world.materials) {
        const bool is_toon = material.name == "toon", is_disney = material.name == "lacquer";
        EXPECT_EQ(path_of(world, material.name, "deferred"), is_toon || is_disney ? "forward" : "deferred")
            << material.name;
        EXPECT_EQ(path_of(world, material.name, "deferred-extended"), is_disney ? "forward" : "deferred-extended")
            << material.name;
        EXPECT_EQ(path_of(world, material.name, "deferred-ldr"), is_toon || is_disney ? "forward" : "deferred-ldr")
            << material.name;
    }
}

// What mirrors the surroundings is added by a pass of its own where the G-buffer knows all that it takes. Unity's
// models ask for oneMinusReflectivity, which it does not: there the pass that fills the G-buffer does it. A model that
// carries its own surroundings ("cl-pbr-specular") mirrors nothing of the scene's, so it has no such pass.
TEST(Deferred, MirrorsTheSurroundingsAfterTheLights) {
    const World world = proof_scene_and_metals();
    for (const runtime::WorldMaterial& material : world.materials) {
        const Result result = compiled(material.graph, "deferred");
        const std::string& model = result.reflection.lighting;
        const bool has_own_pass = model == "cook-torrance" || model == "blinn-phong";
        EXPECT_EQ(find_pass(result, "deferred-reflections") != nullptr, has_own_pass) << model;
    }
}

TEST(Deferred, AParallelCameraFallsBackToForward) {
    World world = scene();
    world.view.camera.orthographic_height = 4.5f;
    const Image forward = draw(world, {.path = "forward"});
    EXPECT_GT(lit_pixels(forward), forward.width * forward.height / 4);
    const Drawn deferred = drawn(world, {.path = "deferred"});
    EXPECT_EQ(deferred.image.pixels, forward.pixels);
    EXPECT_EQ(deferred.codes(), std::vector<std::string>{"path-refused"});
    int of_the_camera = 0;
    for (const Diagnostic& diagnostic : deferred.diagnostics)
        of_the_camera += diagnostic.message.find("needs a perspective camera") != std::string::npos;
    EXPECT_EQ(of_the_camera, 1);  // not of each material
}

// --- a lighting graph of one's own, with a ramp texture and an input of its own

World ramp_scene() {
    World world = scene();
    world.objects.erase(world.objects.begin() + 1, world.objects.end());  // the floor stays
    world.view.lights[0].shadow.casts = true;
    const std::string graph = "tests/paths/data/ramp.graph.json";
    add_object(world, graph, "sphere", 0, ball_at(-1.2f, 0.8f, 0.6f, 0.8f));
    add_object(world, graph, "torus", 0, ball_at(1, 0.9f, 0.4f, 0.8f),
               {{"_Cloth", "#3f7fd0"}, {"_Sheen", "1.4"}, {"_Ramp", "tests/paths/data/ramp_cold.png"}});
    return world;
}

TEST(OwnLighting, IsTheSameInForwardAddAndDeferred) {
    const World world = ramp_scene();
    const Image forward = draw(world, {.path = "forward", .exact_targets = true});
    for (const char* path : {"forward-add", "deferred-extended"}) {
        SCOPED_TRACE(path);
        const Drawn other = drawn(world, {.path = path, .exact_targets = true});
        EXPECT_EQ(other.codes(), std::vector<std::string>{});
        EXPECT_SAME_PICTURE(forward, other.image);
    }
}

// The scene that the README shows. Its ramps have hard edges, and a position that depth gives back may fall on their
// other side: in one pixel of ten thousand at most.
TEST(OwnLighting, IsTheSameInTheShownScene) {
    runtime::WorldFile file = runtime::read_world(compiler(), "examples/scenes/ramps.scene.json", {});
    ASSERT_TRUE(file.ok);
    World& world = file.world;
    world.view.samples = 1;
    world.pixel_light_count = 16;
    const Image forward = draw(world, {.path = "forward", .exact_targets = true});
    EXPECT_SAME_PICTURE(forward, draw(world, {.path = "forward-add", .exact_targets = true}));
    const Image deferred = draw(world, {.path = "deferred-extended", .exact_targets = true});
    int others = 0;
    for (int i = 0; i < forward.width * forward.height; ++i)
        others += apart(forward, deferred, i % forward.width, i / forward.width) > kStep;
    EXPECT_LE(others, forward.width * forward.height / 10'000);
    std::printf("%d of %d pixels\n", others, forward.width * forward.height);
}

TEST(OwnLighting, IsDrawnDeferredByItsOwnPasses) {
    const Result result = compiled("tests/paths/data/ramp.graph.json", "deferred-extended");
    ASSERT_TRUE(result.ok);
    EXPECT_EQ(result.reflection.path, "deferred-extended");
    const Pass* pass = find_pass(result, "extended-directional");
    ASSERT_TRUE(pass);
    EXPECT_TRUE(has(pass->textures, "_Ramp"));
    EXPECT_FALSE(has(pass->textures, "_Weave"));  // of the surface, which is in the G-buffer by now
    // What it declares takes part: without it the picture is another.
    World plain = ramp_scene();
    for (runtime::WorldMaterial& material : plain.materials)
        if (material.graph.ends_with("ramp.graph.json")) material.overrides["_Sheen"] = "0";
    const RenderOptions options{.path = "deferred-extended", .exact_targets = true};
    EXPECT_GT(difference(draw(plain, options), draw(ramp_scene(), options)).largest, 5 * kStep);
    // Unity's own layout has no room for it.
    EXPECT_EQ(compiled("tests/paths/data/ramp.graph.json", "deferred").reflection.path, "forward");
}

}  // namespace
}  // namespace patina::paths
