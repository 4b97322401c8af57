// The warnings for a picture of a single material: nothing of it is visible, or its numbers are not finite.
#include "runtime/render/render_request.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace patina::runtime {
namespace {

std::vector<std::string> codes_of(const std::string& graph) {
    const Compiler compiler;
    RenderMachine machine;
    const RenderOutcome outcome =
        render(compiler, {.graph = graph, .size = 24, .samples = 2, .options = {.via = "cpu"}}, machine);
    EXPECT_TRUE(outcome.ok) << outcome.error;
    std::vector<std::string> codes;
    for (const Diagnostic& diagnostic : outcome.diagnostics) codes.push_back(diagnostic.code);
    return codes;
}

// The balloon's material lifts it above what the camera sees; a glow is seen before nothing, too.
TEST(RenderRequest, AnEmptyPictureIsReported) {
    const std::string folder = "examples/surfaces/";
    EXPECT_EQ(codes_of(folder + "balloon.graph.json"), std::vector<std::string>{"nothing-seen"});
    for (const char* seen : {"halo.graph.json", "facets.graph.json", "balloon.scene.json"})
        EXPECT_EQ(codes_of(folder + seen), std::vector<std::string>{}) << seen;
}

// A graph of the test's own, in a folder that is gone afterwards.
struct OwnGraph {
    explicit OwnGraph(const std::string& text) {
        std::string name = (std::filesystem::temp_directory_path() / "patina_request_XXXXXX").string();
        folder = mkdtemp(name.data());
        path = folder / "own.graph.json";
        std::ofstream(path) << text;
    }
    ~OwnGraph() { std::filesystem::remove_all(folder); }
    std::filesystem::path folder, path;
};

// A render target of the rendering path, as it is when the picture is done: here the normal, as the G-buffer holds it.
TEST(RenderRequest, ShowsATargetOfAPass) {
    const OwnGraph graph(R"({ "patina": 1, "workflow": "metallic-roughness", "surface": { "roughness": 0.25 } })");
    const Compiler compiler;
    RenderMachine machine;
    RenderRequest request{.graph = graph.path.string(),
                          .size = 33,
                          .samples = 1,
                          .camera = "position=0,0,4 target=0,0,0 fov=20",
                          .options = {.path = "deferred", .preview = "gbuffer/gbufferNormal", .via = "cpu"}};
    const RenderOutcome normal = render(compiler, request, machine);
    ASSERT_TRUE(normal.ok) << normal.error;
    const auto pixel = normal.image.at(16, 16);
    for (const auto& [channel, value] : {std::pair(0u, 0.5f), {1u, 0.5f}, {2u, 1.0f}, {3u, 1.0f}})
        EXPECT_NEAR(pixel[channel], value, 0.02f) << channel;
    request.options.preview = "gbuffer/gbufferSpecular";
    EXPECT_NEAR(render(compiler, request, machine).image.at(16, 16)[0], 0.04f, 0.004f);  // the f0 of a dielectric
    request.options.preview = "gbuffer/color";
    EXPECT_NE(render(compiler, request, machine).error.find("is the picture: leave out --node"), std::string::npos);
    request.options.preview = "gbuffer/gbufferNormals";
    const RenderOutcome misspelt = render(compiler, request, machine);
    ASSERT_EQ(misspelt.diagnostics.size(), 1u);
    ASSERT_FALSE(misspelt.diagnostics[0].notes.empty());
    EXPECT_EQ(misspelt.diagnostics[0].notes.back().message,
              "the targets of the pass 'gbuffer' are 'gbufferDiffuse', 'gbufferSpecular', 'gbufferNormal'");
}

// The node that divides by zero is reported, not the one that reads it. The left half of the plane is finite.
constexpr const char* kDivides = R"json({
  "patina": 1, "workflow": "unlit",
  "nodes": [
    { "id": "mask", "expr": "step(0.5, @uv0.x)" },
    { "id": "share", "expr": "mask / (1 - mask)" },
    { "id": "half", "expr": "share * 0.5 - 0.25" }
  ],
  "surface": { "color": "half" }
})json";

TEST(RenderRequest, PixelsThatAreNotFiniteAreCountedAndTracedToTheirNode) {
    const OwnGraph graph(kDivides);
    const Compiler compiler;
    RenderMachine machine;
    const RenderOutcome outcome = render(
        compiler, {.graph = graph.path.string(), .mesh = "plane", .size = 24, .samples = 1, .options = {.via = "cpu"}},
        machine);
    ASSERT_TRUE(outcome.ok) << outcome.error;
    ASSERT_EQ(outcome.diagnostics.size(), 1u);
    const Diagnostic& warning = outcome.diagnostics[0];
    EXPECT_EQ(warning.code, "pixels-not-finite");
    EXPECT_EQ(warning.node, "share");
    EXPECT_EQ(warning.line, 5);
    EXPECT_NE(warning.message.find("of 576 pixels are not finite"), std::string::npos) << warning.message;
    EXPECT_NE(warning.message.find("'share.out' is inf there"), std::string::npos) << warning.message;
    EXPECT_GT(outcome.values.not_finite, 100u);
    EXPECT_LT(outcome.values.not_finite, 288u);
}

// White keeps its form in the default light: a matt surface that reflects all light stays below 1 wherever it faces,
// and its lit side is at least twice as bright as the side in the shade.
TEST(RenderRequest, TheDefaultLightLeavesFormToWhite) {
    const OwnGraph graph(R"({ "patina": 1, "workflow": "metallic-roughness", "lighting": "lambert",
        "surface": { "baseColor": 1, "roughness": 1 } })");
    const Compiler compiler;
    for (const char* mesh : {"sphere", "plane", "cube", "capsule", "torus"}) {
        RenderMachine machine;
        const RenderOutcome outcome =
            render(compiler,
                   {.graph = graph.path.string(), .mesh = mesh, .size = 64, .samples = 1, .options = {.via = "glsl"}},
                   machine);
        ASSERT_TRUE(outcome.ok) << outcome.error;
        float least = 1, most = 0;
        const Scene scene;
        for (int y = 0; y < 64; y++) {
            for (int x = 0; x < 64; x++) {
                const auto pixel = outcome.image.at(x, y);
                if (pixel[1] == scene.background.g) continue;
                most = std::max({most, pixel[0], pixel[1], pixel[2]});
                least = std::min(least, pixel[1]);
            }
        }
        EXPECT_LT(most, 0.7) << mesh;
        EXPECT_GT(most, 0.4) << mesh;
        if (std::string_view(mesh) != "plane") {
            EXPECT_LT(least, 0.5 * most) << mesh;
        }
    }
}

// Wherever a model brings light of its own, as half Lambert does, there is room for it: only highlights clip.
TEST(RenderRequest, TheExamplesOfTheSourcesCanBeRead) {
    const Compiler compiler;
    RenderMachine machine;
    int drawn = 0;
    for (const auto& file : std::filesystem::directory_iterator("examples/sources")) {
        if (!file.path().string().ends_with(".graph.json")) continue;
        const RenderOutcome outcome = render(
            compiler, {.graph = file.path().string(), .size = 64, .samples = 1, .options = {.via = "glsl"}}, machine);
        ASSERT_TRUE(outcome.ok) << file.path() << outcome.error;
        int clipped = 0;
        for (int y = 0; y < 64; y++) {
            for (int x = 0; x < 64; x++) {
                const auto pixel = outcome.image.at(x, y);
                if (std::max({pixel[0], pixel[1], pixel[2]}) >= 1) ++clipped;
            }
        }
        EXPECT_LT(clipped, 64 * 64 / 100) << file.path();
        ++drawn;
    }
    EXPECT_GE(drawn, 19);
}

// A mirror before the camera shows what is behind the camera, with right and left as they are there: the picture's
// edges, here red at the left one, where somebody who turns round to the left looks, and green at the right one.
TEST(RenderRequest, AMirrorShowsThePictureOfTheSurroundings) {
    const OwnGraph graph(R"json({ "patina": 1, "workflow": "metallic-smoothness", "lighting": "unity-brdf1",
        "surface": { "baseColor": [1, 1, 1], "metallic": 1, "smoothness": 1 } })json");
    setenv("XDG_CACHE_HOME", graph.folder.c_str(), 1);
    Image picture = make_image(64, 32, 0, 0, 0.25f);
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 16; ++x) picture.at(x, y)[0] = 0.5f, picture.at(63 - x, y)[1] = 0.5f;
    }
    const std::string file = (graph.folder / "around.exr").string();
    ASSERT_EQ(save_exr(file, picture), "");
    const Compiler compiler;
    RenderMachine machine;
    const auto drawn = [&](const std::string& environment, const char* via) {
        RenderOutcome outcome = render(compiler,
                                       {.graph = graph.path.string(),
                                        .mesh = "plane",
                                        .size = 33,
                                        .samples = 1,
                                        .lights = {"none"},
                                        .environment = environment,
                                        .options = {.via = via}},
                                       machine);
        EXPECT_TRUE(outcome.ok) << outcome.error;
        return std::move(outcome.image);
    };
    for (const char* via : {"cpu", "glsl"}) {
        const Image image = drawn(file, via);
        // The camera looks along -z, so what it sees left of its axis is reflected to its left: -x.
        EXPECT_NEAR(image.at(10, 16)[0], 0.5, 0.02) << via;
        EXPECT_NEAR(image.at(10, 16)[1], 0, 0.02) << via;
        EXPECT_NEAR(image.at(22, 16)[1], 0.5, 0.02) << via;
        EXPECT_NEAR(image.at(22, 16)[2], 0.25, 0.02) << via;
        // A half turn puts the middle of the picture there, where there is neither.
        const Image turned = drawn(file + " rotation=180 intensity=2", via);
        EXPECT_NEAR(turned.at(10, 16)[0], 0, 0.02) << via;
        EXPECT_NEAR(turned.at(10, 16)[2], 0.5, 0.02) << via;
    }
    const RenderOutcome none =
        render(compiler, {.graph = graph.path.string(), .environment = "none.hdr", .options = {.via = "cpu"}}, machine);
    EXPECT_FALSE(none.ok);
    EXPECT_EQ(none.error, "there is no file 'none.hdr'");
}

TEST(RenderRequest, APixelOfALargePictureIsTraced) {
    const OwnGraph graph(kDivides);
    const Compiler compiler;
    const TraceOutcome outcome =
        trace(compiler, {.graph = graph.path.string(), .mesh = "plane", .size = 8192, .samples = 16}, 4096, 4096,
              Precision::Float);
    EXPECT_TRUE(outcome.ok) << outcome.error;
    EXPECT_TRUE(outcome.trace.is_covered);
}

TEST(RenderRequest, APreviewShowsItsRangeAndWhatIsNotFinite) {
    const OwnGraph graph(kDivides);
    const Compiler compiler;
    for (const char* via : {"cpu", "glsl"}) {
        RenderMachine machine;
        const RenderOutcome outcome = render(compiler,
                                             {.graph = graph.path.string(),
                                              .mesh = "plane",
                                              .size = 64,
                                              .samples = 1,
                                              .range = DataRange{.low = -0.25, .high = 0.25},
                                              .options = {.preview = "half", .via = via}},
                                             machine);
        ASSERT_TRUE(outcome.ok) << outcome.error;
        EXPECT_EQ(outcome.values.low, -0.25);
        EXPECT_EQ(outcome.values.high, -0.25);
        const auto pixel = [&](int x, int y) {
            std::array<float, 3> color{};
            std::copy_n(outcome.image.at(x, y).begin(), 3, color.begin());
            return color;
        };
        const Scene scene;
        EXPECT_EQ(pixel(0, 0)[1], scene.background.g);                          // beside the plane
        EXPECT_NEAR(srgb_encode(pixel(26, 32)[2]), 192 / 255.0, 0.002) << via;  // the lower end of the range is blue
        const std::array<float, 3> magenta = {1, 0, 1}, black = {0, 0, 0};
        EXPECT_EQ(pixel(36, 32), magenta) << via;
        EXPECT_EQ(pixel(36, 40), black) << via;
    }
}

}  // namespace
}  // namespace patina::runtime
