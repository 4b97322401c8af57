// Reflection probes of scenes: which ones an object reads, and what a mirror in a room shows. The room is a box whose
// picture holds, in each direction, the place on its walls that is seen there; so a mirror must show the place that the
// reflected ray meets, which the test computes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>

#include "runtime/lights/probe_choice.h"
#include "runtime/render/render_request.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;
constexpr double kPi = std::numbers::pi;

// --- the choice

const std::shared_ptr<const Environment> kAny = std::make_shared<const Environment>(constant_ambient(glm::vec3(1)));

Probe probe(float left, float right, float blend = 0, int importance = 1) {
    return {.environment = kAny,
            .box_min = {left, -1, -1},
            .box_max = {right, 1, 1},
            .blend = blend,
            .importance = importance};
}

TEST(ProbeChoice, CountsLessOutsideOfTheBox) {
    const Probe faded = probe(-1, 1, 4);
    EXPECT_EQ(weight_at(faded, {0.5f, 0, 0}), 1);
    EXPECT_EQ(weight_at(faded, {1, 1, 1}), 1);
    EXPECT_FLOAT_EQ(weight_at(faded, {2, 0, 0}), 0.75f);        // 1 of 4 metres
    EXPECT_FLOAT_EQ(weight_at(faded, {1.6f, 1.8f, 0}), 0.75f);  // 0.6 and 0.8
    EXPECT_EQ(weight_at(faded, {5, 0, 0}), 0);
    EXPECT_EQ(weight_at(faded, {9, 0, 0}), 0);
    EXPECT_EQ(weight_at(probe(-1, 1), {1.001f, 0, 0}), 0);
}

TEST(ProbeChoice, TakesTheTwoThatCountMost) {
    const std::vector<Probe> probes = {probe(-9, -1, 4), probe(1, 9, 4), probe(3, 4, 40)};
    // Nothing near.
    ProbeChoice made = choose_probes(std::span(probes).first(2), {0, 90, 0});
    EXPECT_EQ(made.first, nullptr);
    EXPECT_EQ(made.second, nullptr);
    // One, 3 of 4 metres from it: the rest is what is around.
    made = choose_probes(std::span(probes).first(1), {2, 0, 0});
    EXPECT_EQ(made.first, &probes[0]);
    EXPECT_EQ(made.second, nullptr);
    EXPECT_FLOAT_EQ(made.share, 0.25f);
    // Half way between two.
    made = choose_probes(std::span(probes).first(2), {0, 0, 0});
    EXPECT_FLOAT_EQ(made.share, 0.5f);
    // 0.5 and 1.5 metres from them: 0.875 and 0.625.
    made = choose_probes(std::span(probes).first(2), {0.5f, 0, 0});
    EXPECT_EQ(made.first, &probes[1]);
    EXPECT_EQ(made.second, &probes[0]);
    EXPECT_FLOAT_EQ(made.share, 0.875f / 1.5f);
    // Inside two boxes, the smaller one first.
    made = choose_probes(probes, {3.5f, 0, 0});
    EXPECT_EQ(made.first, &probes[2]);
    EXPECT_EQ(made.second, &probes[1]);
    EXPECT_FLOAT_EQ(made.share, 0.5f);
}

TEST(ProbeChoice, AMoreImportantProbeHidesOthers) {
    const std::vector<Probe> probes = {probe(-9, 9), probe(-1, 1, 2, 5)};
    ProbeChoice made = choose_probes(probes, {0, 0, 0});
    EXPECT_EQ(made.first, &probes[1]);
    EXPECT_EQ(made.share, 1);
    made = choose_probes(probes, {2.5f, 0, 0});  // 1.5 of 2 metres
    EXPECT_EQ(made.first, &probes[1]);
    EXPECT_EQ(made.second, &probes[0]);
    EXPECT_FLOAT_EQ(made.share, 0.25f);
}

// --- pictures

struct Folder {
    Folder() {
        std::string name = (fs::temp_directory_path() / "patina_probes_XXXXXX").string();
        path = mkdtemp(name.data());
        setenv("XDG_CACHE_HOME", path.c_str(), 1);
        write("mirror.graph.json", std::string(R"({ "patina": 1, "workflow": "metallic-smoothness",
            "lighting": "unity-brdf1", "surface": { "baseColor": [1, 1, 1], "metallic": 1, "smoothness": 1 } })"));
    }
    ~Folder() { fs::remove_all(path); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path / name) << text;
        return (path / name).string();
    }
    void write(const std::string& name, const Image& image) const {
        ASSERT_EQ(save_exr((path / name).string(), image), "");
    }
    fs::path path;
};

Image drawn(const std::string& scene, const std::string& via, const std::string& path = "forward", int width = 32,
            int height = 32) {
    static const Compiler compiler;
    static RenderMachine machine;
    RenderRequest request{.graph = scene, .size = width, .height = height, .samples = 1};
    request.options.path = path;
    request.options.via = via;
    request.options.validation = true;
    request.options.exact_textures = true;
    request.options.exact_targets = true;
    const RenderOutcome outcome = render(compiler, request, machine);
    for (const Diagnostic& d : outcome.diagnostics) ADD_FAILURE() << to_text(d);
    EXPECT_TRUE(outcome.ok) << outcome.error;
    return outcome.image;
}

void expect_near(const Image& image, int x, int y, glm::dvec3 wanted, double tolerance, const std::string& what) {
    const auto pixel = image.at(x, y);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(pixel[std::size_t(c)], wanted[c], tolerance)
            << what << " at " << x << ", " << y << ", channel " << c;
}

// The room, and where its picture was taken.
constexpr glm::dvec3 kLow(-3, -1, -2), kHigh(5, 4, 6), kTaken(0.5, 1.5, 1);

// Where a ray from inside the room meets a wall: the nearest of three planes.
glm::dvec3 wall_met(glm::dvec3 from, glm::dvec3 direction) {
    double nearest = std::numeric_limits<double>::max();
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(direction[axis]) < 1e-12) continue;
        const double wall = direction[axis] > 0 ? kHigh[axis] : kLow[axis];
        nearest = std::min(nearest, (wall - from[axis]) / direction[axis]);
    }
    return from + nearest * direction;
}
// A place as a colour, from 0 to 1 through the room.
glm::dvec3 color_of(glm::dvec3 place) {
    return (place - kLow) / (kHigh - kLow);
}

Image picture_of_room() {
    constexpr int kWidth = 1024;
    Image image = make_image(kWidth, kWidth / 2);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const double right = ((x + 0.5) / kWidth - 0.5) * 2 * kPi, down = (y + 0.5) / image.height * kPi;
            const glm::dvec3 d(std::sin(down) * std::sin(right), std::cos(down), -std::sin(down) * std::cos(right));
            const glm::dvec3 color = color_of(wall_met(kTaken, d));
            for (int c = 0; c < 3; ++c) image.at(x, y)[std::size_t(c)] = float(color[c]);
        }
    }
    return image;
}

// A square mirror of 2 metres that faces +z, and the camera 2 metres in front of it, which sees nothing else.
std::string room(glm::dvec3 mirror, const std::string& probe) {
    const auto list = [](glm::dvec3 v) {
        return "[" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + "]";
    };
    return R"({ "patina": 1, "kind": "scene", "ambient": "none", "camera": { "fov": 50, "position": )" +
           list(mirror + glm::dvec3(0, 0, 2)) + R"(, "target": )" + list(mirror) + R"( },
        "probes": [{ "environment": "room.exr", "position": )" +
           list(kTaken) + R"(,
                     "box": { "min": )" +
           list(kLow) + R"(, "max": )" + list(kHigh) + " }" + probe + R"( }],
        "materials": [{ "name": "mirror", "graph": "mirror.graph.json" }],
        "objects": [{ "id": "mirror", "mesh": "plane", "material": "mirror", "position": )" +
           list(mirror) + " }] }";
}

class Probes : public testing::TestWithParam<std::string> {};

TEST_P(Probes, AMirrorShowsTheWallsWhereTheyAre) {
    const Folder folder;
    folder.write("room.exr", picture_of_room());
    for (const glm::dvec3 mirror : {glm::dvec3(0, 1, 0), glm::dvec3(3, 2.5, 1.5), glm::dvec3(-2, 0, -1)}) {
        const Image image = drawn(folder.write("own.scene.json", room(mirror, "")), GetParam());
        const Image far_away =
            drawn(folder.write("own.scene.json", room(mirror, R"(, "boxProjection": false)")), GetParam());
        const double tangent = std::tan(25 * kPi / 180);
        for (int y = 1; y < 32; y += 5) {
            for (int x = 1; x < 32; x += 5) {
                const glm::dvec3 d = glm::normalize(
                    glm::dvec3((2 * (x + 0.5) / 32 - 1) * tangent, (1 - 2 * (y + 0.5) / 32) * tangent, -1));
                const glm::dvec3 place = mirror + glm::dvec3(0, 0, 2) + d * (2 / -d.z);
                const glm::dvec3 mirrored(d.x, d.y, -d.z);
                expect_near(image, x, y, color_of(wall_met(place, mirrored)), 0.012, "the wall");
                expect_near(far_away, x, y, color_of(wall_met(kTaken, mirrored)), 0.012, "far away");
            }
        }
    }
}

// Two probes of even colours, side by side, and an environment of a third colour.
std::string two_probes(double x, const std::string& first, const std::string& second) {
    const auto probe = [](const std::string& file, double left, double right, const std::string& rest) {
        return R"({ "environment": ")" + file + R"(", "box": { "min": [)" + std::to_string(left) +
               R"(, -5, -5], "max": [)" + std::to_string(right) + ", 5, 5] }" + rest + " }";
    };
    const std::string place = "[" + std::to_string(x) + ", 0, 0]";
    return R"({ "patina": 1, "kind": "scene", "ambient": "none", "environment": "around.exr",
        "camera": { "fov": 20, "position": [)" +
           std::to_string(x) + R"(, 0, 4], "target": )" + place + R"( },
        "probes": [)" +
           probe("first.exr", -8, -2, first) + ", " + probe("second.exr", 2, 8, second) + R"(],
        "materials": [{ "name": "mirror", "graph": "mirror.graph.json" }],
        "objects": [{ "id": "mirror", "mesh": "sphere", "material": "mirror", "position": )" +
           place + " }] }";
}

TEST_P(Probes, AreBlendedByTheirWeights) {
    const Folder folder;
    folder.write("first.exr", make_image(16, 8, 1, 0, 0.25f));
    folder.write("second.exr", make_image(16, 8, 0, 1, 0.5f));
    folder.write("around.exr", make_image(16, 8, 0, 0, 1));
    const glm::dvec3 first(1, 0, 0.25), second(0, 1, 0.5), around(0, 0, 1);
    const auto expect_ball = [&](double x, const std::string& a, const std::string& b, glm::dvec3 wanted) {
        const Image image = drawn(folder.write("own.scene.json", two_probes(x, a, b)), GetParam());
        expect_near(image, 16, 16, wanted, 2e-3, "x = " + std::to_string(x));
    };
    const std::string wide = R"(, "blend": 4)", narrow = R"(, "blend": 1)";
    expect_ball(0, wide, wide, (first + second) / 2.0);               // 2 metres from each
    expect_ball(-1, wide, wide, (3.0 * first + 1.0 * second) / 4.0);  // 1 and 3 metres: 0.75 and 0.25
    expect_ball(-5, wide, wide, first);
    expect_ball(0, narrow, narrow, around);
    expect_ball(1.5, narrow, narrow, (second + around) / 2.0);  // half a metre of one
    expect_ball(-1, wide, R"(, "blend": 4, "importance": 2)", 0.25 * second + 0.75 * first);
}

// The largest difference between a pixel and the one on its right.
double largest_step(const Image& image) {
    double largest = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x + 1 < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                largest = std::max(largest, double(std::abs(image.at(x + 1, y)[c] - image.at(x, y)[c])));
    return largest;
}

// The middle of a ball across the border of two rooms, where there is no wall. Left of it, reflected rays leave the
// right room through the border, right of it the left room. A smooth picture has a quarter of the step from pixel to
// pixel if its pixels are a quarter as wide. At a seam, the step stays.
TEST_P(Probes, FadeWithoutASeamAcrossTheirBorder) {
    const Folder folder;
    folder.write("room.exr", picture_of_room());
    const auto probe = [](double left, double right) {
        return R"({ "environment": "room.exr", "box": { "min": [)" + std::to_string(left) + R"(, -1, -2], "max": [)" +
               std::to_string(right) + R"(, 4, 6] }, "blend": 0.5 })";
    };
    const std::string scene = folder.write("own.scene.json", R"({ "patina": 1, "kind": "scene", "ambient": "none",
        "camera": { "fov": 1, "position": [1, 1, 5], "target": [1, 1, 0] }, "probes": [)" +
                                                                 probe(-3, 1) + ", " + probe(1, 5) + R"(],
        "materials": [{ "name": "mirror", "graph": "mirror.graph.json" }],
        "objects": [{ "id": "ball", "mesh": "sphere", "material": "mirror", "position": [1, 1, 0] }] })");
    const double coarse = largest_step(drawn(scene, GetParam(), "forward", 32, 32));
    const double fine = largest_step(drawn(scene, GetParam(), "forward", 128, 128));
    EXPECT_LT(fine, coarse / 2);
}

INSTANTIATE_TEST_SUITE_P(Ways, Probes, testing::Values("glsl", "hlsl", "cpu"));

// A G-buffer holds the reflections of probes: the passes of the whole screen do not know which object they light.
TEST(ProbesInScenes, AreTheSameAlongEveryPath) {
    const Folder folder;
    folder.write("room.exr", picture_of_room());
    folder.write("mirror.graph.json", std::string(R"({ "patina": 1, "workflow": "metallic-roughness",
        "lighting": "cook-torrance", "surface": { "baseColor": [0.9, 0.8, 0.7], "metallic": 1, "roughness": 0.2 } })"));
    const std::string scene = folder.write("own.scene.json", room({1, 1, 0}, ""));
    const Image forward = drawn(scene, "glsl");
    for (const std::string path : {"forward-add", "forward-directional", "deferred", "deferred-extended",
                                   "deferred-ldr", "deferred-shadowmask"}) {
        const Image other = drawn(scene, "glsl", path);
        for (int y = 2; y < 32; y += 9) {
            for (int x = 2; x < 32; x += 9) {
                const auto p = forward.at(x, y);
                expect_near(other, x, y, {p[0], p[1], p[2]}, 4e-3, path);
            }
        }
    }
}

}  // namespace
}  // namespace patina::runtime
