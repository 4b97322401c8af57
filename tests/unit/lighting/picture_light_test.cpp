// Surroundings from a picture as the light of a material: no other light unless it is asked for, and an exposure in
// which white stays below white. The pictures are the test's own, so that their light is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "runtime/picture/tone.h"
#include "runtime/render/render_request.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;
constexpr double kWhite = 0.96;  // what a base colour of 1 reflects diffusely: the rest is the f0 of a dielectric

struct PictureLight : testing::Test {
    PictureLight() {
        std::string name = (fs::temp_directory_path() / "patina_light_XXXXXX").string();
        path = mkdtemp(name.data());
        setenv("XDG_CACHE_HOME", path.c_str(), 1);
        request.graph = write("white.graph.json", R"({ "patina": 1, "workflow": "metallic-roughness",
            "lighting": "lambert", "surface": { "baseColor": [1, 1, 1] } })");
        request.size = 32;
        request.samples = 1;
        request.options.via = "cpu";
    }
    ~PictureLight() override { fs::remove_all(path); }

    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path / name) << text;
        return (path / name).string();
    }
    std::string write(const std::string& name, const Image& image) const {
        EXPECT_EQ(save_exr((path / name).string(), image), "");
        return (path / name).string();
    }
    // The same light from everywhere.
    std::string even(float light, const std::string& name = "even.exr") const {
        return write(name, make_image(16, 8, light, light, light));
    }

    RenderOutcome drawn() {
        RenderOutcome outcome = render(compiler, request, machine);
        for (const Diagnostic& d : outcome.diagnostics) ADD_FAILURE() << to_text(d);
        EXPECT_TRUE(outcome.ok) << outcome.error;
        return outcome;
    }
    float middle() { return drawn().image.at(16, 16)[0]; }

    const Compiler compiler;
    RenderMachine machine;
    RenderRequest request{};
    fs::path path;
};

TEST_F(PictureLight, IsAllTheLightThereIs) {
    request.environment = even(0.25f);
    EXPECT_NEAR(middle(), kWhite * 0.25, 1e-3);
    // A light that is asked for is added: it shines along the normal of the middle.
    request.lights = {"directional direction=0,0,1 intensity=0.5"};
    EXPECT_NEAR(middle(), kWhite * 0.75, 2e-3);
}

TEST_F(PictureLight, OtherSurroundingsKeepTheDefaultLights) {
    request.lights = {"none"};
    const float unlit = middle();
    request.lights.clear();
    const float lit = middle();
    EXPECT_GT(lit, unlit + 0.2f);
    request.environment = "studio";
    EXPECT_EQ(middle(), lit);
}

TEST_F(PictureLight, AScenesOwnLightsStay) {
    even(0.25f);
    const auto scene = [&](const std::string& rest) {
        return write("own.scene.json",
                     R"({ "patina": 1, "kind": "scene", "environment": "even.exr", "camera": { "position": [0, 0, 4] },
            "materials": [{ "name": "white", "graph": "white.graph.json" }],
            "objects": [{ "id": "ball", "mesh": "sphere", "material": "white" }])" +
                         rest + " }");
    };
    const std::string light = R"(, "lights": [{ "type": "directional", "direction": [0, 0, 1], "intensity": 0.5 }])";
    request.graph = scene("");
    EXPECT_NEAR(middle(), kWhite * 0.25, 1e-3);
    EXPECT_NEAR(drawn().exposure, std::log2(0.68 / 0.25), 0.01);
    request.graph = scene(light);
    EXPECT_NEAR(middle(), kWhite * 0.75, 2e-3);
    EXPECT_EQ(drawn().exposure, 0);
    request.environment = (path / "even.exr").string();
    EXPECT_NEAR(middle(), kWhite * 0.75, 2e-3);
    request.environment.clear();
    request.graph = scene("");
    request.ambient = "0.1";  // instead of the picture
    EXPECT_EQ(drawn().exposure, 0);
    request.ambient.clear();
    request.graph = scene(R"(, "ambient": { "sky": 0.1 })");
    EXPECT_EQ(drawn().exposure, 0);
}

TEST_F(PictureLight, ChoosesAnExposureFromThePicture) {
    request.environment = even(8);
    EXPECT_NEAR(drawn().exposure, std::log2(0.68 / 8), 0.01);
    EXPECT_LE(drawn().exposure, std::log2(0.68 / 8));
    // A factor that is asked for stays one.
    request.environment += " intensity=2";
    EXPECT_NEAR(drawn().exposure, std::log2(0.68 / 8), 0.01);
    request.environment = even(0.01f);
    EXPECT_NEAR(drawn().exposure, std::log2(68), 0.01);
    for (const std::string& text :
         {even(0, "black.exr"), even(8) + " intensity=0", std::string("studio"), std::string("none")}) {
        request.environment = text;
        EXPECT_EQ(drawn().exposure, 0) << text;
    }
    request.environment = even(8);
    request.lights = {"point position=1,2,3"};
    EXPECT_EQ(drawn().exposure, 0);
    request.lights = {"none"};
    EXPECT_LT(drawn().exposure, -3);
    request.options.preview = "baseColor";  // values, not light
    EXPECT_EQ(drawn().exposure, 0);
}

// A bright window at the upper right of a dark room: the ball is as bright as it can be, and nothing of it clips.
TEST_F(PictureLight, WhiteStaysBelowWhite) {
    Image image = make_image(128, 64, 0.05f, 0.04f, 0.03f);
    for (int y = 10; y < 22; ++y)
        for (int x = 80; x < 96; ++x)
            for (std::size_t c = 0; c < 3; ++c) image.at(x, y)[c] = 900;
    request.environment = write("window.exr", image);
    request.camera = "position=3,2.6,-2 target=0,0,0 fov=30";  // from the side of the window
    request.background = "none";
    const RenderOutcome outcome = drawn();
    const Image shown = toned(outcome.image, {.exposure = outcome.exposure});
    const float peak = *std::ranges::max_element(shown.pixels);
    EXPECT_LT(outcome.exposure, -2);
    EXPECT_GT(peak, 0.85f);
    EXPECT_LE(peak, 1.005f);
    EXPECT_FALSE(clipping(shown));
    EXPECT_TRUE(clipping(outcome.image));
}

// A background colour is what was asked for, in every exposure.
TEST_F(PictureLight, ABackgroundColorIsNotExposed) {
    request.environment = even(9);
    request.background = "#ff8040";
    const auto corner = [&](const std::string& via, std::optional<double> exposure) {
        request.options.via = via;
        request.exposure = exposure;
        const RenderOutcome outcome = drawn();
        EXPECT_EQ(outcome.exposure, exposure.value_or(outcome.exposure));
        const Image shown = toned(outcome.image, {.exposure = outcome.exposure});
        const float* pixel = shown.pixels.data();
        return std::array{pixel[0], pixel[1], pixel[2], pixel[3]};
    };
    const std::array<float, 4> orange = {1, 0.2158605f, 0.0512695f, 1};
    for (const std::string via : {"cpu", "glsl"}) {
        for (const std::optional<double> exposure : {std::optional<double>(), std::optional(0.0), std::optional(3.5)}) {
            const auto seen = corner(via, exposure);
            for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(seen[c], orange[c], 1e-5) << via;
        }
    }
    EXPECT_LT(drawn().exposure, 4);
    request.graph = write("white.scene.json", R"({ "patina": 1, "kind": "scene", "environment": "even.exr",
        "lights": [], "background": "#ff8040", "camera": { "position": [0, 0, 4], "target": [0, 0, 0] },
        "materials": [{ "name": "white", "graph": "white.graph.json" }],
        "objects": [{ "id": "ball", "mesh": "sphere", "material": "white" }] })");
    request.environment.clear();
    request.background.clear();
    const auto seen = corner("cpu", {});
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(seen[c], orange[c], 1e-5);
    EXPECT_LT(drawn().exposure, -2);
}

}  // namespace
}  // namespace patina::runtime
