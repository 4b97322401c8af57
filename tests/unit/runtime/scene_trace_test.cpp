// Traces and previews in scenes: which object they are about, and that their numbers are those of the picture.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "runtime/render/render_request.h"

namespace patina::runtime {
namespace {

// Each object has a value of its own. The plane "wall" fills the picture; "ball" is before its left half, "pane" before
// its right half, "dots" before its lower half. All face the camera, which sees 2 x 2 metres.
constexpr const char* kScene = R"json({
  "patina": 1, "kind": "scene",
  "camera": { "position": [0, 0, 4], "orthographic": 2 },
  "fog": { "mode": "exp", "density": 0.5, "color": [1, 0, 0] },
  "background": [0, 1, 0],
  "lights": [
    { "type": "point", "position": [0, 0, 2] },
    { "type": "directional", "direction": [-1, 0, 1], "shadow": true }
  ],
  "materials": [
    { "name": "stone", "graph": "stone.graph.json", "set": { "_Level": 0.75 } },
    { "name": "shiny", "graph": "shiny.graph.json", "set": { "_Shine": 3, "_Level": 0.5 } },
    { "name": "glass", "graph": "glass.graph.json" },
    { "name": "dotted", "graph": "dotted.graph.json" },
    { "name": "holed", "graph": "holed.graph.json" },
    { "name": "lens", "graph": "lens.graph.json" }
  ],
  "objects": [
    { "id": "wall", "mesh": "plane", "material": "stone", "position": [0, 0, -1], "scale": 2 },
    { "id": "ball", "mesh": "plane", "material": "shiny", "position": [-0.5, 0.5, 0], "scale": 0.4 },
    { "id": "pane", "mesh": "plane", "material": "glass", "position": [0.5, 0.5, 0.5], "scale": 0.4 },
    { "id": "dots", "mesh": "plane", "material": "dotted", "position": [0, -0.5, 0],
      "instances": [ { "position": [-0.75, 0, 0], "scale": 0.2, "set": { "_Shade": 0.25 } },
                     { "position": [-0.25, 0, 0], "scale": 0.2, "set": { "_Shade": 0.5 } } ] },
    { "id": "grid", "mesh": "plane", "material": "holed", "position": [0.25, -0.5, 0], "scale": 0.2 },
    { "id": "lens", "mesh": "plane", "material": "lens", "position": [0.75, -0.5, 0], "scale": 0.2 }
  ]
})json";

struct Text {
    const char *name, *text;
};
constexpr Text kFiles[] = {
    {"room.scene.json", kScene},
    {"stone.graph.json", R"json({ "patina": 1, "workflow": "metallic-roughness",
        "properties": [ { "name": "_Level", "type": "float", "default": 0 } ],
        "nodes": [ { "id": "grain", "expr": "$_Level * 2" }, { "id": "lit", "expr": "@light.shadow" } ],
        "surface": { "baseColor": "= float3(grain) * lit" } })json"},
    {"shiny.graph.json", R"json({ "patina": 1, "workflow": "metallic-roughness", "lighting": "./shiny.lighting.json",
        "properties": [ { "name": "_Level", "type": "float", "default": 0 } ],
        "nodes": [ { "id": "paint", "expr": "$_Level * 0.5" } ], "surface": { "baseColor": "= float3(paint)" } })json"},
    {"shiny.lighting.json", R"json({ "patina": 1, "kind": "lighting",
        "properties": [ { "name": "_Shine", "type": "float", "default": 1 } ],
        "nodes": [ { "id": "lit", "expr": "saturate(dot(@surface.normalWS, @light.direction)) * $_Shine" } ],
        "direct": "= @surface.diffuseColor * lit * @light.color * @light.attenuation * @light.shadow" })json"},
    {"glass.graph.json", R"json({ "patina": 1, "workflow": "unlit",
        "nodes": [ { "id": "tint", "expr": "float3(0.5, 0.25, 0.125)" } ],
        "surface": { "color": "tint", "alpha": 0.5 }, "render": { "surface": "fade" } })json"},
    {"dotted.graph.json", R"json({ "patina": 1, "workflow": "unlit",
        "properties": [ { "name": "_Shade", "type": "float", "default": 0, "as": "instance" } ],
        "nodes": [ { "id": "mine", "expr": "$_Shade * 2" } ], "surface": { "color": "= float3(mine)" } })json"},
    {"holed.graph.json", R"json({ "patina": 1, "workflow": "unlit",
        "nodes": [ { "id": "hole", "expr": "step(@uv0.x, 0.5)" } ],
        "surface": { "color": 1, "alpha": "hole", "alphaClip": 0.5 }, "render": { "surface": "cutout" } })json"},
    {"lens.graph.json", R"json({ "patina": 1, "workflow": "unlit",
        "nodes": [ { "id": "behind", "node": "SceneColor" } ], "surface": { "color": "= behind * 0.5" } })json"},
};

constexpr int kSize = 40;

class SceneTraceTest : public testing::Test {
protected:
    void SetUp() override {
        std::string name = (std::filesystem::temp_directory_path() / "patina_trace_XXXXXX").string();
        folder_ = mkdtemp(name.data());
        for (const Text& file : kFiles) std::ofstream(folder_ / file.name) << file.text;
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    RenderRequest request(const std::string& scene = "") const {
        return {.graph = scene.empty() ? (folder_ / "room.scene.json").string() : scene,
                .size = kSize,
                .samples = 1,
                .options = {.via = "cpu"}};
    }

    TraceOutcome at(int x, int y, const std::string& object = "") const {
        RenderRequest wanted = request();
        wanted.object = object;
        TraceOutcome traced = trace(compiler_, wanted, x, y, Precision::Float);
        EXPECT_TRUE(traced.ok) << traced.error;
        return traced;
    }

    RenderOutcome preview(const std::string& port, const std::string& object = "", const std::string& via = "cpu",
                          const std::string& path = "forward") const {
        RenderRequest wanted = request();
        wanted.object = object;
        wanted.options.preview = port;
        wanted.options.via = via;
        wanted.options.path = path;
        RenderMachine machine;
        RenderOutcome drawn = render(compiler_, wanted, machine);
        EXPECT_TRUE(drawn.ok) << drawn.error;
        return drawn;
    }

    static double value_of(const TraceOutcome& traced, const std::string& node) {
        for (const TracedValue& value : traced.trace.values)
            if (value.node == node) return value.values.front();
        ADD_FAILURE() << "no value of " << node;
        return 0;
    }

    Compiler compiler_;
    std::filesystem::path folder_;
};

// --- traces

TEST_F(SceneTraceTest, TheFrontMostObjectIsTracedBlendedOnesAmongThem) {
    const TraceOutcome ball = at(10, 10), pane = at(30, 10), wall = at(20, 10);
    EXPECT_EQ(ball.object, "ball");
    EXPECT_EQ(ball.material, "shiny");
    EXPECT_TRUE(ball.graph.ends_with("shiny.graph.json"));
    EXPECT_FLOAT_EQ(float(value_of(ball, "paint")), 0.25f);
    EXPECT_EQ(pane.object, "pane");
    EXPECT_EQ(pane.seen, (std::vector<std::string>{"pane", "wall"}));
    EXPECT_FLOAT_EQ(float(value_of(wall, "grain")), 1.5f);
}

TEST_F(SceneTraceTest, ANamedObjectIsTracedThoughOthersAreBeforeIt) {
    const TraceOutcome through = at(30, 10, "wall"), behind = at(10, 10, "wall"), away = at(10, 10, "pane");
    EXPECT_EQ(through.object, "wall");
    EXPECT_FALSE(through.trace.is_hidden);
    EXPECT_TRUE(behind.trace.is_hidden);
    EXPECT_EQ(behind.seen, std::vector<std::string>{"ball"});
    EXPECT_FLOAT_EQ(float(value_of(behind, "grain")), 1.5f);
    EXPECT_FALSE(away.trace.is_covered);
}

TEST_F(SceneTraceTest, AnInstanceHasItsOwnValues) {
    const TraceOutcome first = at(5, 30), second = at(15, 30);
    EXPECT_EQ(first.trace.instance, 0u);
    EXPECT_EQ(second.trace.instance, 1u);
    EXPECT_EQ(first.instances, 2u);
    EXPECT_EQ(value_of(first, "mine"), 0.5);
    EXPECT_EQ(value_of(second, "mine"), 1.0);
}

// The shaders begin with the directional light; the scene's second light is that.
TEST_F(SceneTraceTest, LightsHaveTheNumbersOfTheScene) {
    const TraceOutcome ball = at(10, 10);
    for (const TracedValue& value : ball.trace.values) {
        if (value.node != "@light" || value.port != "direction" || value.light != 1) continue;
        EXPECT_NEAR(value.values[0], -std::sqrt(0.5), 1e-6);
        EXPECT_NEAR(value.values[2], std::sqrt(0.5), 1e-6);
        return;
    }
    ADD_FAILURE() << "no light 1";
}

// With shadows, fog, blending, instances, holes, and an object that reads the picture behind it.
TEST_F(SceneTraceTest, ThePixelIsTheOneThatIsDrawn) {
    RenderMachine machine;
    for (const std::string& scene : {std::string(), std::string("examples/scenes/glass.scene.json")}) {
        RenderRequest wanted = request(scene);
        wanted.samples = 2;
        const RenderOutcome drawn = render(compiler_, wanted, machine);
        ASSERT_TRUE(drawn.ok) << drawn.error;
        for (int y : scene.empty() ? std::vector<int>{10, 30} : std::vector<int>{22}) {
            for (int x = 3; x < kSize; x += scene.empty() ? 8 : 16) {
                const TraceOutcome traced = trace(compiler_, wanted, x, y, Precision::Float);
                for (std::size_t c = 0; c < 4; ++c)
                    EXPECT_EQ(traced.trace.color[c], drawn.image.at(x, y)[c]) << scene << " " << x << "," << y;
            }
        }
    }
}

// --- previews

TEST_F(SceneTraceTest, APreviewShowsTheValuesOfOneObjectAndFadesTheOthers) {
    for (const char* via : {"cpu", "glsl"}) {
        for (const char* path : {"forward", "deferred"}) {
            const RenderOutcome drawn = preview("grain", "", via, path);
            EXPECT_EQ(drawn.values.low, 1.5) << "no fog, no light, no glass";
            EXPECT_EQ(drawn.values.high, 1.5);
            const auto pixel = [&](int x, int y) { return drawn.image.at(x, y); };
            EXPECT_EQ(pixel(20, 10)[0], 1.5f);
            EXPECT_EQ(pixel(30, 10)[0], 1.5f) << "glass hides nothing";
            EXPECT_LT(pixel(10, 10)[0], 0.5f) << "the ball hides the wall";
            EXPECT_EQ(pixel(10, 10)[0], pixel(10, 10)[2]) << "and is grey";
            EXPECT_EQ(pixel(27, 30)[0], 1.5f) << "through the hole of a cutout";
            EXPECT_NE(pixel(23, 30)[0], 1.5f);
        }
    }
}

// Its own lighting graph's property means nothing to a preview; it is set all the same.
TEST_F(SceneTraceTest, APreviewKeepsTheValuesThatTheSceneSets) {
    EXPECT_EQ(preview("paint").values.high, 0.25);
    const RenderOutcome dots = preview("mine");
    EXPECT_EQ(dots.values.low, 0.5);
    EXPECT_EQ(dots.values.high, 1.0);
    EXPECT_EQ(dots.image.at(5, 30)[0], 0.5f);
    EXPECT_EQ(preview("tint").image.at(30, 10)[1], 0.25f) << "a blended object is shown as if it were opaque";
}

// The ball's shadow on the wall is behind the pane.
TEST_F(SceneTraceTest, APreviewReadsTheShadows) {
    EXPECT_EQ(value_of(at(30, 10, "wall"), "lit"), 0);
    const RenderOutcome drawn = preview("lit", "wall");
    EXPECT_EQ(drawn.image.at(30, 10)[0], 0.0f);
    EXPECT_EQ(drawn.image.at(20, 2)[0], 1.0f);
}

// What a node reads of the picture behind its object is there.
TEST_F(SceneTraceTest, APreviewReadsThePictureBehind) {
    const TraceOutcome traced = at(35, 30);
    ASSERT_EQ(traced.object, "lens");
    const RenderOutcome drawn = preview("behind");
    EXPECT_NEAR(drawn.image.at(35, 30)[0], value_of(traced, "behind"), 1e-6);
    EXPECT_GT(drawn.image.at(35, 30)[0], 0.1f);
}

TEST_F(SceneTraceTest, WithoutABackgroundOnlyTheObjectIsThere) {
    RenderRequest wanted = request();
    wanted.options.preview = "paint";
    wanted.background = "none";
    RenderMachine machine;
    const RenderOutcome drawn = render(compiler_, wanted, machine);
    ASSERT_TRUE(drawn.ok) << drawn.error;
    EXPECT_EQ(drawn.image.at(10, 10)[3], 1.0f);
    EXPECT_EQ(drawn.image.at(20, 10)[3], 0.0f);
}

}  // namespace
}  // namespace patina::runtime
