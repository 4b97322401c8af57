// The surroundings as the background of a picture: each pixel shows what is in the direction of its ray, which the test
// works out by itself. The pictures of the surroundings are the test's own.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "runtime/render/render_request.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

// A folder of the test's own, gone afterwards, with the cache in it.
struct Folder {
    Folder() {
        std::string name = (fs::temp_directory_path() / "patina_background_XXXXXX").string();
        path = mkdtemp(name.data());
        setenv("XDG_CACHE_HOME", path.c_str(), 1);
    }
    ~Folder() { fs::remove_all(path); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path / name) << text;
        return (path / name).string();
    }
    std::string write(const std::string& name, const Image& image) const {
        EXPECT_EQ(save_exr((path / name).string(), image), "");
        return (path / name).string();
    }
    fs::path path;
};

constexpr const char* kUnlit = R"({ "patina": 1, "workflow": "unlit", "surface": { "color": 0.5 } })";

Image drawn(RenderRequest request, const std::string& via) {
    static const Compiler compiler;
    static RenderMachine machine;
    if (request.size == RenderRequest{}.size) request.size = 32;
    request.samples = 1;
    request.lights = {"none"};
    request.options.via = via;
    request.options.validation = true;
    request.options.exact_textures = true;
    const RenderOutcome outcome = render(compiler, request, machine);
    for (const Diagnostic& d : outcome.diagnostics) ADD_FAILURE() << to_text(d);
    EXPECT_TRUE(outcome.ok) << outcome.error;
    return outcome.image;
}

std::array<double, 3> pixel(const Image& image, int x, int y) {
    const auto p = image.at(x, y);
    return {double(p[0]), double(p[1]), double(p[2])};
}

void expect_near(std::array<double, 3> got, glm::dvec3 wanted, double tolerance, const std::string& what) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[std::size_t(c)], wanted[c], tolerance) << what << ", channel " << c;
}

// The faces of a strip: right, left, up, down, ahead, behind.
constexpr std::array<glm::dvec3, 6> kColors = {
    {{0.9, 0.1, 0.1}, {0.1, 0.8, 0.1}, {0.1, 0.1, 0.7}, {0.6, 0.6, 0.1}, {0.1, 0.5, 0.5}, {0.4, 0.1, 0.4}}};
constexpr std::array<glm::dvec3, 6> kAxes = {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, -1}, {0, 0, 1}}};

Image six_colors() {
    constexpr int kSide = 64;
    Image image = make_image(6 * kSide, kSide);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < 6 * kSide; ++x)
            for (int c = 0; c < 3; ++c) image.at(x, y)[std::size_t(c)] = float(kColors[std::size_t(x / kSide)][c]);
    return image;
}

// Equirectangular; the colour of a direction is the direction, from 0 to 1.
Image directions() {
    constexpr int kWidth = 512;
    constexpr double kPi = std::numbers::pi;
    Image image = make_image(kWidth, kWidth / 2);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const double right = ((x + 0.5) / kWidth - 0.5) * 2 * kPi, down = (y + 0.5) / image.height * kPi;
            const glm::dvec3 d(std::sin(down) * std::sin(right), std::cos(down), -std::sin(down) * std::cos(right));
            for (int c = 0; c < 3; ++c) image.at(x, y)[std::size_t(c)] = float((d[c] + 1) / 2);
        }
    }
    return image;
}
glm::dvec3 color_of(glm::dvec3 direction) {
    return (glm::normalize(direction) + 1.0) / 2.0;
}

// The direction of a pixel's ray: the camera looks along `forward`, which is not vertical. `fov`: degrees, vertical.
glm::dvec3 ray(glm::dvec3 forward, double fov, int width, int height, int x, int y) {
    const double tangent = std::tan(fov / 2 * std::numbers::pi / 180);
    const glm::dvec3 ahead = glm::normalize(forward);
    const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(0, 1, 0)));
    const glm::dvec3 up = glm::cross(right, ahead);
    const double s = (2 * (x + 0.5) / width - 1) * tangent * width / height;
    const double t = (1 - 2 * (y + 0.5) / height) * tangent;
    return glm::normalize(ahead + right * s + up * t);
}

std::string camera(glm::dvec3 position, glm::dvec3 target, const std::string& rest) {
    std::string text;
    for (const auto& [name, v] : {std::pair("position", position), std::pair("target", target)})
        text +=
            std::string(name) + "=" + std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z) + " ";
    return text + rest;
}

class Background : public testing::TestWithParam<std::string> {};

// The camera stands outside of the ball and looks away from it.
TEST_P(Background, EachAxisShowsItsFace) {
    const Folder folder;
    RenderRequest request{.graph = folder.write("grey.graph.json", std::string(kUnlit)),
                          .environment = folder.write("six.exr", six_colors()),
                          .background = "env"};
    for (std::size_t i = 0; i < 6; ++i) {
        request.camera = camera(5.0 * kAxes[i], 6.0 * kAxes[i], "fov=60");
        const Image image = drawn(request, GetParam());
        expect_near(pixel(image, 16, 16), kColors[i], 2e-3, "axis " + std::to_string(i));
        expect_near(pixel(image, 0, 16), kColors[i], 2e-3, "the left of axis " + std::to_string(i));
    }
    // 120 degrees: ahead in the middle, its neighbours at the edges.
    request.camera = camera({0, 0, -5}, {0, 0, -6}, "fov=120");
    const Image wide = drawn(request, GetParam());
    expect_near(pixel(wide, 31, 16), kColors[0], 2e-3, "right");
    expect_near(pixel(wide, 0, 16), kColors[1], 2e-3, "left");
    expect_near(pixel(wide, 16, 0), kColors[2], 2e-3, "up");
    expect_near(pixel(wide, 16, 31), kColors[3], 2e-3, "down");
}

// Every pixel, with a camera that looks along no axis, in a picture that is not square.
TEST_P(Background, EachPixelShowsTheDirectionOfItsRay) {
    const Folder folder;
    RenderRequest request{.graph = folder.write("grey.graph.json", std::string(kUnlit)),
                          .size = 48,
                          .height = 32,
                          .environment = folder.write("directions.exr", directions()),
                          .camera = camera({3, 2, 4}, {5, 3, 7}, "fov=70"),
                          .background = "env"};
    const auto expect_rays = [&](double fov, double turn, double factor) {
        const Image image = drawn(request, GetParam());
        const double angle = turn * std::numbers::pi / 180;
        for (int y = 0; y < 32; y += 3) {
            for (int x = 0; x < 48; x += 3) {
                const glm::dvec3 d = ray({2, 1, 3}, fov, 48, 32, x, y);
                // What was in the direction e before the picture was turned by `turn` is in d now.
                const glm::dvec3 e(std::cos(angle) * d.x - std::sin(angle) * d.z, d.y,
                                   std::sin(angle) * d.x + std::cos(angle) * d.z);
                expect_near(pixel(image, x, y), factor * color_of(e), 0.01 * factor,
                            std::to_string(x) + ", " + std::to_string(y));
            }
        }
    };
    expect_rays(70, 0, 1);
    const std::string file = request.environment;
    request.environment = file + " rotation=90 intensity=2";
    expect_rays(70, 90, 2);
    request.environment = file;
    request.camera = camera({3, 2, 4}, {5, 3, 7}, "orthographic=0.5");
    expect_rays(30, 0, 1);
}

// Lines of four pixels of the picture stay lines, with sharp edges.
TEST_P(Background, IsAsSharpAsThePicture) {
    const Folder folder;
    constexpr int kWidth = 2048;
    Image image = make_image(kWidth, kWidth / 2);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < kWidth; ++x)
            for (int c = 0; c < 3; ++c) image.at(x, y)[std::size_t(c)] = float(x % 8 < 4);
    RenderRequest request{
        .graph = folder.write("grey.graph.json", std::string(kUnlit)),
        .size = 64,
        .environment = folder.write("lines.exr", image),
        .camera = camera({0, 0, -5}, {0, 0, -6}, "fov=5.625"),  // 32 pixels of the picture, four lines of each
        .background = "env"};
    const Image seen = drawn(request, GetParam());
    int dark = 0, bright = 0;
    for (int x = 0; x < 64; ++x) {
        const double value = pixel(seen, x, 32)[0];
        dark += value < 0.05;
        bright += value > 0.95;
    }
    // Half of each line at least is as it is in the picture.
    EXPECT_GE(dark, 16);
    EXPECT_GE(bright, 16);
}

// A point of the ball mirrors what a camera that looks in the direction of the reflection has behind everything.
TEST_P(Background, AMirrorShowsTheBackgroundOfItsDirection) {
    const Folder folder;
    RenderRequest request{
        .graph =
            folder.write("mirror.graph.json",
                         std::string(R"({ "patina": 1, "workflow": "metallic-smoothness", "lighting": "unity-brdf1",
                                  "surface": { "baseColor": [1, 1, 1], "metallic": 1, "smoothness": 1 } })")),
        .size = 64,
        .environment = folder.write("directions.exr", directions()),
        .camera = camera({0, 0, 4}, {0, 0, 0}, "fov=30"),
        .background = "env"};
    const Image ball = drawn(request, GetParam());
    for (const auto& [x, y] : {std::pair(20, 24), std::pair(45, 30), std::pair(33, 50)}) {
        const glm::dvec3 eye(0, 0, 4), d = ray({0, 0, -1}, 30, 64, 64, x, y);
        const double b = glm::dot(eye, d), t = -b - std::sqrt(b * b - 15);  // |eye + t d| = 1
        const glm::dvec3 normal = eye + t * d, mirrored = glm::reflect(d, normal);
        RenderRequest other = request;
        other.camera = camera(10.0 * mirrored, 11.0 * mirrored, "fov=5");
        const Image behind = drawn(other, GetParam());
        const std::array<double, 3> seen = pixel(behind, 32, 32);
        expect_near(seen, color_of(mirrored), 0.01, "the background");
        // The ball is a mesh of flat triangles with smooth normals.
        expect_near(pixel(ball, x, y), {seen[0], seen[1], seen[2]}, 0.015, "the ball");
    }
}

// Glass that bends nothing and reflects nothing, over the whole picture: what it lets through is the background.
TEST_P(Background, WhatIsBehindReadsIt) {
    const Folder folder;
    RenderRequest request{.graph = folder.write("grey.graph.json", std::string(kUnlit)),
                          .environment = folder.write("directions.exr", directions()),
                          .camera = camera({0, 0, 5}, {0, 0, 9}, "fov=40"),
                          .background = "env"};
    const Image empty = drawn(request, GetParam());
    request.graph = folder.write("glass.graph.json", std::string(R"({ "patina": 1, "workflow": "unlit",
        "render": { "cull": "off" }, "surface": { "color": "@sceneColor" } })"));
    request.mesh = "cube";
    request.camera = camera({0, 0, 0}, {0, 0, 4}, "fov=40");  // inside the cube
    EXPECT_EQ(drawn(request, GetParam()).pixels, empty.pixels);
}

// Nobody asked for a background: glass shows the picture that lights it, and all else stands before the plain colour.
TEST_P(Background, GlassShowsAPictureByItself) {
    const Folder folder;
    const std::string glass = R"({ "patina": 1, "workflow": "unlit",
        "surface": { "color": "= float3(0.5, 1, 1) * @sceneColor" } })";
    RenderRequest request{.graph = folder.write("glass.graph.json", glass),
                          .environment = folder.write("directions.exr", directions()),
                          .camera = camera({0, 0, 5}, {0, 0, 0}, "fov=30")};
    request.exposure = 0;
    const auto with = [&](const std::string& background) {
        RenderRequest one = request;
        one.background = background;
        return drawn(one, GetParam());
    };
    EXPECT_EQ(with("").pixels, with("env").pixels);
    expect_near(pixel(with("0.25"), 16, 16), {0.125, 0.25, 0.25}, 1e-4, "a background that is asked for");
    request.environment = "studio";
    expect_near(pixel(with(""), 16, 16), {0.015, 0.03, 0.032}, 1e-4, "no picture is around");
    request.environment = folder.write("directions.exr", directions());
    request.graph = folder.write("grey.graph.json", std::string(kUnlit));
    expect_near(pixel(with(""), 0, 0), {0.03, 0.03, 0.032}, 1e-4, "behind an opaque ball");
}

// The mean of each pixel's neighbourhood: half way between two faces, both have the same share, by symmetry.
TEST_P(Background, BlurIsEven) {
    const Folder folder;
    RenderRequest request{.graph = folder.write("grey.graph.json", std::string(kUnlit)),
                          .size = 33,
                          .environment = folder.write("six.exr", six_colors()),
                          .camera = camera({5, 0, -5}, {6, 0, -6}, "fov=100"),
                          .background = "blur"};
    const Image image = drawn(request, GetParam());
    // Red is 0.9 at the right and 0.1 ahead; green is 0.1 and 0.5. As much of the one is lost as of the other.
    const std::array<double, 3> middle = pixel(image, 16, 16);
    EXPECT_NEAR((middle[0] - middle[1]), (0.9 - 0.1) / 2 + (0.1 - 0.5) / 2, 0.02);
    const double step = std::abs(pixel(image, 17, 16)[0] - pixel(image, 15, 16)[0]);
    EXPECT_LT(step, 0.25);  // 0.8 where it is sharp
    request.background = "env";
    const Image sharp = drawn(request, GetParam());
    EXPECT_NEAR(std::abs(pixel(sharp, 18, 16)[0] - pixel(sharp, 14, 16)[0]), 0.8, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(Ways, Background, testing::Values("glsl", "hlsl", "cpu"));

// Exposure and tone curves are applied to the picture, so they see the background, too. Paths and tiles change nothing.
TEST(BackgroundInScenes, IsTheSameAlongEveryPathAndInTiles) {
    const Folder folder;
    folder.write("directions.exr", directions());
    folder.write("matt.graph.json", std::string(R"({ "patina": 1, "workflow": "metallic-roughness",
        "lighting": "cook-torrance", "surface": { "baseColor": [0.5, 0.2, 0.1], "roughness": 0.4 } })"));
    const std::string scene = folder.write("own.scene.json", std::string(R"({ "patina": 1, "kind": "scene",
        "camera": { "position": [0, 0, 4], "fov": 60 }, "environment": "directions.exr", "background": "env",
        "materials": [{ "name": "matt", "graph": "matt.graph.json" }],
        "objects": [{ "id": "ball", "mesh": "sphere", "material": "matt" }] })"));
    RenderRequest request{.graph = scene};
    const auto along = [&](const std::string& path, const std::string& via) {
        RenderRequest one = request;
        one.options.path = path;
        return drawn(one, via);
    };
    const Image forward = along("forward", "glsl");
    expect_near(pixel(forward, 1, 1), color_of(ray({0, 0, -1}, 60, 32, 32, 1, 1)), 0.01, "behind the ball");
    for (const std::string path : {"forward-add", "vertex", "deferred", "deferred-extended", "deferred-ldr"}) {
        const Image other = along(path, "glsl");
        for (const auto& [x, y] : {std::pair(1, 1), std::pair(30, 3), std::pair(2, 29), std::pair(16, 1)}) {
            const auto p = pixel(forward, x, y);
            expect_near(pixel(other, x, y), {p[0], p[1], p[2]}, 1e-3, path);
        }
    }
    const Image on_cpu = along("deferred", "cpu");
    for (const auto& [x, y] : {std::pair(1, 1), std::pair(30, 3)}) {
        const auto p = pixel(forward, x, y);
        expect_near(pixel(on_cpu, x, y), {p[0], p[1], p[2]}, 1e-3, "deferred on the CPU");
    }
    RenderRequest in_tiles = request;
    in_tiles.size = 128;
    const Image whole = drawn(in_tiles, "cpu");
    in_tiles.options.most_target_bytes = 100'000;
    EXPECT_EQ(drawn(in_tiles, "cpu").pixels, whole.pixels);
}

// A preview of a node: the value where the object is, the surroundings elsewhere.
TEST(BackgroundInScenes, APreviewHasIt) {
    const Folder folder;
    RenderRequest request{.graph = folder.write("half.graph.json", std::string(R"({ "patina": 1, "workflow": "unlit",
                              "nodes": [{ "id": "half", "expr": "0.25 + 0.25" }], "surface": { "color": "half" } })")),
                          .environment = folder.write("six.exr", six_colors()),
                          .camera = camera({0, 0, 4}, {0, 0, 0}, "fov=60"),
                          .background = "env"};
    request.options.preview = "half";
    const Image image = drawn(request, "glsl");
    expect_near(pixel(image, 16, 16), glm::dvec3(0.5), 1e-3, "the node");
    expect_near(pixel(image, 1, 1), kColors[4], 2e-3, "ahead");
}

}  // namespace
}  // namespace patina::runtime
