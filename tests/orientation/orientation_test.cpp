// The conventions of docs/conventions.md, seen in pictures whose values are worked out by hand: which way textures,
// normal maps, lights, handedness and the camera go, through GLSL, HLSL and the CPU.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>

#include "runtime/render/render_request.h"

namespace patina::runtime {
namespace {

constexpr int kSize = 32;

RenderOutcome draw(RenderRequest request, const std::string& via) {
    static const Compiler compiler;
    static RenderMachine machine;
    request.size = kSize;
    request.samples = 1;
    request.options.via = via;
    request.options.validation = true;
    request.options.exact_textures = true;
    // Straight at the plane, so that it fills the picture: 2 units high at distance 2 is a field of view of 2
    // atan(1/2).
    if (request.mesh == "plane" && request.camera.empty())
        request.camera = "position=0,0,2 target=0,0,0 fov=53.13010235415598";
    request.ambient = "0";
    RenderOutcome outcome = render(compiler, request, machine);
    for (const Diagnostic& d : outcome.diagnostics) ADD_FAILURE() << to_text(d);
    EXPECT_TRUE(outcome.ok) << outcome.error;
    return outcome;
}

std::array<float, 3> pixel(const Image& image, int x, int y) {
    const std::span<const float> p = image.at(x, y);
    return {p[0], p[1], p[2]};
}

void expect_color(const Image& image, int x, int y, std::array<double, 3> expected, const std::string& what) {
    const std::array<float, 3> got = pixel(image, x, y);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(got[i], expected[i], 2e-3) << what << " channel " << i;
}

class Orientation : public testing::TestWithParam<std::string> {};

// A 2 x 2 texture: red at the top left, green at the top right, blue at the bottom left, white at the bottom right.
std::string corners() {
    const std::string path = testing::TempDir() + "corners.png";
    Image image = make_image(2, 2, 1, 1, 1);
    const auto paint = [&](int x, int y, std::array<float, 3> color) {
        for (std::size_t i = 0; i < 3; ++i) image.at(x, y)[i] = color[i];
    };
    paint(0, 0, {1, 0, 0});
    paint(1, 0, {0, 1, 0});
    paint(0, 1, {0, 0, 1});
    EXPECT_EQ(save_png_as_is(path, image), "");
    return path;
}

TEST_P(Orientation, TextureNormalMapAndLight) {
    const double root = std::sqrt(0.5);
    RenderRequest request;
    request.graph = "tests/orientation/orientation.graph.json";
    request.mesh = "plane";
    request.overrides["_Corners"] = corners();
    // N.L for a light along +x, +y and +z: flat (0,0,1), bent to +u = +x, lifted to up = +y.
    struct Case {
        const char* light;
        double top_left, top_right, bottom_left, bottom_right;
    };
    for (const Case& c :
         {Case{"1,0,0", 0, 0, root, 0}, Case{"0,1,0", 0, root, 0, 0}, Case{"0,0,1", 1, root, root, 1}}) {
        request.lights = {"directional direction=" + std::string(c.light) + " intensity=1"};
        const RenderOutcome outcome = draw(request, GetParam());
        if (!outcome.ok) return;
        const int near = kSize / 4, far = kSize * 3 / 4;
        expect_color(outcome.image, near, near, {c.top_left, 0, 0}, "top left");
        expect_color(outcome.image, far, near, {0, c.top_right, 0}, "top right");
        expect_color(outcome.image, near, far, {0, 0, c.bottom_left}, "bottom left");
        expect_color(outcome.image, far, far, {c.bottom_right, c.bottom_right, c.bottom_right}, "bottom right");
    }
}

// Four layers of one colour: red, green, blue, white. Their picture is asymmetric in both directions.
TEST_P(Orientation, CubesArraysAndVolumes) {
    RenderRequest request;
    request.graph = "tests/orientation/layers.graph.json";
    request.mesh = "plane";
    request.overrides["_Layers"] = request.overrides["_Volume"] = corners();
    // A strip of faces: right red, left green, up blue, down white, ahead yellow, behind black.
    const std::string strip = testing::TempDir() + "strip.png";
    Image faces = make_image(6, 1);
    const std::array<std::array<float, 3>, 6> colors = {
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {1, 1, 0}, {0, 0, 0}}};
    for (int i = 0; i < 6; ++i) std::copy_n(colors[std::size_t(i)].begin(), 3, faces.at(i, 0).begin());
    ASSERT_EQ(save_png_as_is(strip, faces), "");
    request.overrides["_Sky"] = strip;
    struct Case {
        const char *direction, *index, *depth;
        std::array<double, 3> sky, layer, fog;
    };
    for (const Case& c : {Case{"1,0,0", "0", "0", {1, 0, 0}, {1, 0, 0}, {1, 0, 0}},
                          Case{"-3,1,1", "1.4", "0.25", {0, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}},
                          Case{"0,1,0", "1.6", "0.5", {0, 0, 1}, {0, 0, 1}, {0, 0.5, 0.5}},
                          Case{"0,-2,1", "7", "0.625", {1, 1, 1}, {1, 1, 1}, {0, 0, 1}},
                          Case{"0,0,-1", "-4", "0.75", {1, 1, 0}, {1, 0, 0}, {0.5, 0.5, 1}},
                          Case{"0,0,1", "2", "1", {0, 0, 0}, {0, 0, 1}, {1, 1, 1}}}) {
        request.overrides["_Direction"] = c.direction;
        request.overrides["_Index"] = c.index;
        request.overrides["_Depth"] = c.depth;
        const RenderOutcome outcome = draw(request, GetParam());
        if (!outcome.ok) return;
        expect_color(outcome.image, kSize / 6, kSize / 4, c.sky, std::string("sky ") + c.direction);
        expect_color(outcome.image, kSize / 6, kSize * 3 / 4, c.sky, std::string("level 0 of the sky ") + c.direction);
        expect_color(outcome.image, kSize / 2, kSize / 2, c.layer, std::string("layer ") + c.index);
        expect_color(outcome.image, kSize * 5 / 6, kSize / 2, c.fog, std::string("depth ") + c.depth);
    }
}

// Seen from behind, a two-sided plane is the same sheet: its frame is turned as a whole, and a bump is a dent.
TEST_P(Orientation, TheBackIsTheFrontReversed) {
    const double root = std::sqrt(0.5);
    RenderRequest request;
    request.graph = "tests/orientation/back.graph.json";
    request.mesh = "plane";
    request.camera = "position=0,0,-2 target=0,0,0 fov=53.13010235415598";
    request.overrides["_Corners"] = corners();
    // As in TextureNormalMapAndLight, with each light on the other side; left and right are exchanged.
    struct Case {
        const char* light;
        double top_left, top_right, bottom_left, bottom_right;
    };
    for (const Case& c :
         {Case{"-1,0,0", 0, 0, root, 0}, Case{"0,-1,0", 0, root, 0, 0}, Case{"0,0,-1", 1, root, root, 1}}) {
        request.lights = {"directional direction=" + std::string(c.light) + " intensity=1"};
        const RenderOutcome outcome = draw(request, GetParam());
        if (!outcome.ok) return;
        const int near = kSize / 4, far = kSize * 3 / 4;
        expect_color(outcome.image, far, near, {c.top_left, 0, 0}, "top left");
        expect_color(outcome.image, near, near, {0, c.top_right, 0}, "top right");
        expect_color(outcome.image, far, far, {0, 0, c.bottom_left}, "bottom left");
        expect_color(outcome.image, near, far, {c.bottom_right, c.bottom_right, c.bottom_right}, "bottom right");
    }
}

// A pinned value is computed once, from the mesh as it is: what moved the vertices does not count again.
TEST_P(Orientation, PinnedValuesAreOfTheMeshAsItIs) {
    RenderRequest request;
    request.graph = "tests/orientation/pinned.graph.json";
    request.mesh = "plane";
    const RenderOutcome outcome = draw(request, GetParam());
    if (!outcome.ok) return;
    // The plane is moved half a unit up; its middle, where the mesh's y is 0, stands a quarter of the picture higher.
    EXPECT_NEAR(pixel(outcome.image, kSize / 2, kSize / 4)[0], 0.5, 0.04);
    EXPECT_NEAR(pixel(outcome.image, kSize / 2, kSize / 2)[0], 0.25, 0.04);
}

// The view space of a preview: x to the right, y up, and the part nearest to the camera in the middle.
TEST_P(Orientation, WorldAxesOnTheSphere) {
    RenderRequest request;
    request.graph = "tests/orientation/normal.graph.json";
    request.camera = "position=0,0,4 target=0,0,0 fov=40";
    const RenderOutcome outcome = draw(request, GetParam());
    if (!outcome.ok) return;
    const std::array<float, 3> middle = pixel(outcome.image, kSize / 2, kSize / 2);
    EXPECT_GT(middle[2], 0.99);
    EXPECT_GT(pixel(outcome.image, kSize * 3 / 4, kSize / 2)[0], 0.5) << "+x is to the right";
    EXPECT_GT(pixel(outcome.image, kSize / 2, kSize / 4)[1], 0.5) << "+y is up";
}

// A spot above the plane's upper right corner lights that corner only, and a point light falls off with the square.
TEST_P(Orientation, PointAndSpotLights) {
    RenderRequest request;
    request.graph = "tests/orientation/white.graph.json";
    request.mesh = "plane";
    request.lights = {"point position=0,0,1 intensity=1 range=1000"};
    RenderOutcome outcome = draw(request, GetParam());
    if (!outcome.ok) return;
    // At the pixel (24, 16), 1/16 off its corner: distance^2 = 1 + r^2, N.L = 1 / d, so E/pi = 1 / d^3.
    const double x = (24 + 0.5) / 16 - 1, y = 1 - (16 + 0.5) / 16;
    const double d = std::sqrt(1 + x * x + y * y);
    EXPECT_NEAR(pixel(outcome.image, 24, 16)[0], 1 / (d * d * d), 2e-3);
    request.lights = {"spot position=0.5,0.5,1 direction=0,0,-1 intensity=1 range=1000 inner=10 outer=12"};
    outcome = draw(request, GetParam());
    if (!outcome.ok) return;
    EXPECT_GT(pixel(outcome.image, 24, 8)[0], 0.9) << "upper right";
    EXPECT_EQ(pixel(outcome.image, 8, 8)[0], 0) << "upper left";
    EXPECT_EQ(pixel(outcome.image, 24, 24)[0], 0) << "lower right";
}

INSTANTIATE_TEST_SUITE_P(Via, Orientation, testing::Values("glsl", "hlsl", "cpu"));

}  // namespace
}  // namespace patina::runtime
