// Traces of graphs whose values are computed by hand; and the pixel that a trace explains equals the pixel that is
// drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "runtime/render/render_request.h"

namespace patina::runtime {
namespace {

constexpr int kSize = 32;

// --- the files

constexpr const char* kGraph = R"graph({
  "patina": 1, "workflow": "metallic-roughness", "lighting": "./steady.lighting.json",
  "properties": [ { "name": "_Scale", "type": "float", "default": 2 } ],
  "nodes": [
    { "id": "ramp", "expr": "@uv0.x * $_Scale" },
    { "id": "alias", "expr": "ramp" },
    { "id": "third", "expr": "$_Scale / 6" },
    { "id": "layers", "node": "./layers.subgraph.json", "in": { "x": "ramp" } },
    { "id": "spread", "node": "./spread.node.hlsl", "in": { "x": "ramp" } },
    { "id": "lean", "expr": "@positionOS.x * 3", "stage": "vertex" }
  ],
  "surface": { "baseColor": "= float3(ramp, layers.sum, 0.25)",
                     "roughness" : 0.5, "emission" : "= float3(lean * 0)"
}
})graph";
constexpr const char* kLayers = R"graph({
  "patina": 1, "kind": "subgraph",
  "inputs": [ { "name": "x", "type": "float" } ],
  "nodes": [ { "id": "half", "expr": "$x * 0.5" }, { "id": "deep", "node": "./deep.subgraph.json" } ],
  "outputs": { "sum": "= half + deep", "low": "= half < 0.25" }
})graph";
constexpr const char* kDeep = R"graph({
  "patina": 1, "kind": "subgraph",
  "nodes": [ { "id": "small", "expr": "0.0625" } ], "outputs": { "value": "= small * 2" }
})graph";
constexpr const char* kSpread = R"graph(/// Two outputs of one node.
[node("Test/Spread")]
float2 Spread(
    float x,         ///< a number
    out float rest,  ///< what is missing to 1
    out float3x3 m   ///< rows of it
) {
    rest = 1 - x;
    m = float3x3(x, 0, 0, 0, 2, 0, 0, 0, 3);
    return float2(x, -x);
}
)graph";
constexpr const char* kLighting = R"graph({
  "patina": 1, "kind": "lighting",
  "nodes": [
    { "id": "ndotl", "node": "NdotL" },
    { "id": "twice", "expr": "ndotl * 2" },
    { "id": "steady", "expr": "@surface.roughness * 4" },
    { "id": "unread", "expr": "1" }
  ],
  "direct": "= @surface.diffuseColor * twice * @light.color",
  "indirect": "= @surface.diffuseColor * steady",
  "final": "= @sum.direct + @sum.indirect"
})graph";
constexpr const char* kLeaf = R"graph({
  "patina": 1, "workflow": "unlit",
  "nodes": [ { "id": "hole", "expr": "@uv0.x - 0.5" } ],
  "surface": { "color": "#ffffff", "alpha": "= step(0, hole)",
                     "alphaClip" : 0.5
}
, "render" : {
    "surface" : "cutout"
}
})graph";

class TraceTest : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directories(folder_);
        write("test.graph.json", kGraph);
        write("layers.subgraph.json", kLayers);
        write("deep.subgraph.json", kDeep);
        write("spread.node.hlsl", kSpread);
        write("steady.lighting.json", kLighting);
        write("leaf.graph.json", kLeaf);
    }

    // A plane that fills the picture: 2 units high at distance 2 is a field of view of 2 atan(1/2). Two lights: along
    // the normal, and with a cosine of 0.8.
    RenderRequest request(const std::string& graph = "test.graph.json") const {
        RenderRequest made;
        made.graph = folder_ + graph;
        made.mesh = "plane";
        made.camera = "position=0,0,2 target=0,0,0 fov=53.13010235415598";
        made.size = kSize;
        made.samples = 1;
        made.lights = {"directional direction=0,0,1 color=1,0.5,0.25", "directional direction=0,0.6,0.8 color=0.5"};
        return made;
    }

    static TraceOutcome run(const RenderRequest& request, int x, int y, Precision precision = Precision::Float) {
        static const Compiler compiler;
        TraceOutcome outcome = trace(compiler, request, x, y, precision);
        EXPECT_TRUE(outcome.ok) << outcome.error;
        for (const Diagnostic& d : outcome.diagnostics) {
            if (d.severity == Severity::Error) ADD_FAILURE() << to_text(d);
        }
        return outcome;
    }

    static const TracedValue* find(const std::vector<TracedValue>& values, const std::string& graph,
                                   const std::string& node, const std::string& port = "out", int light = -1) {
        const auto found = std::find_if(values.begin(), values.end(), [&](const TracedValue& v) {
            return v.graph == graph && v.node == node && v.port == port && v.light == light;
        });
        return found == values.end() ? nullptr : &*found;
    }

    static void expect(const std::vector<TracedValue>& values, const std::string& graph, const std::string& node,
                       const std::string& port, const std::vector<double>& expected, int light = -1) {
        const TracedValue* value = find(values, graph, node, port, light);
        ASSERT_NE(value, nullptr) << graph << " " << node << "." << port << " light " << light;
        ASSERT_EQ(value->values.size(), expected.size()) << node << "." << port;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            EXPECT_NEAR(value->values[i], expected[i], 1e-5) << node << "." << port << " light " << light;
        }
    }

    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ + name) << text; }

    std::string folder_ = testing::TempDir() + "trace_test/";
};

// --- values

TEST_F(TraceTest, NodesOfTheMaterialAndItsSubgraphs) {
    const auto values = run(request(), 7, 20).trace.values;
    const double x = 2 * 7.5 / kSize;  // _Scale, and u in the middle of the pixel
    expect(values, "material", "ramp", "out", {x});
    expect(values, "material", "alias", "out", {x});
    expect(values, "material", "layers/half", "out", {x / 2});
    expect(values, "material", "layers/deep/small", "out", {0.0625});
    expect(values, "material", "layers/deep", "value", {0.125});
    expect(values, "material", "layers", "sum", {x / 2 + 0.125});
    expect(values, "material", "layers", "low", {1});
    EXPECT_EQ(find(values, "material", "layers", "low")->type, "bool");
    expect(values, "material", "spread", "out", {x, -x});
    expect(values, "material", "spread", "rest", {1 - x});
    expect(values, "material", "spread", "m", {x, 0, 0, 0, 2, 0, 0, 0, 3});
    expect(values, "material", "surface", "baseColor", {x, x / 2 + 0.125, 0.25});
    EXPECT_EQ(find(values, "material", "surface", "baseColor")->kind, TracedValue::Kind::Output);
}

TEST_F(TraceTest, APropertySetByTheRequestIsWhatTheNodesSee) {
    RenderRequest changed = request();
    changed.overrides["_Scale"] = "0.5";
    expect(run(changed, 7, 20).trace.values, "material", "ramp", "out", {0.5 * 7.5 / kSize});
}

// A dielectric keeps 1 - 0.04 of its base colour as diffuse albedo.
TEST_F(TraceTest, TheSetUpOfTheWorkflow) {
    const auto values = run(request(), 7, 20).trace.values;
    const double x = 2 * 7.5 / kSize;
    const std::vector<double> diffuse = {0.96 * x, 0.96 * (x / 2 + 0.125), 0.96 * 0.25};
    expect(values, "workflow", "setup", "diffuseColor", diffuse);
    expect(values, "workflow", "setup", "f0", {0.04, 0.04, 0.04});
    expect(values, "workflow", "surface", "diffuseColor", diffuse);
    expect(values, "workflow", "surface", "roughness", {0.5});
}

TEST_F(TraceTest, WhatChangesWithTheLightOnceALightAndTheRestOnce) {
    const PixelTrace traced = run(request(), 7, 20).trace;
    const std::vector<TracedValue>& values = traced.values;
    const double x = 2 * 7.5 / kSize, base[] = {x, x / 2 + 0.125, 0.25}, first[] = {1, 0.5, 0.25};
    expect(values, "lighting", "ndotl", "out", {1}, 0);
    expect(values, "lighting", "ndotl", "out", {0.8}, 1);
    expect(values, "lighting", "twice", "out", {1.6}, 1);
    expect(values, "lighting", "@light", "direction", {0, 0.6, 0.8}, 1);
    expect(values, "lighting", "@light", "color", {0.5, 0.5, 0.5}, 1);
    expect(values, "lighting", "steady", "out", {2});
    EXPECT_EQ(find(values, "lighting", "steady", "out", 0), nullptr);
    EXPECT_EQ(find(values, "lighting", "ndotl", "out"), nullptr);
    EXPECT_EQ(find(values, "lighting", "unread"), nullptr) << "nothing asks for it";
    std::vector<double> direct, indirect, final;
    for (int c = 0; c < 3; ++c) {
        direct.push_back(0.96 * base[c] * 2 * first[c]);
        indirect.push_back(0.96 * base[c] * 2);
        final.push_back(direct.back() + 0.96 * base[c] * 1.6 * 0.5 + indirect.back());
    }
    expect(values, "lighting", "direct", "out", direct, 0);
    expect(values, "lighting", "indirect", "out", indirect);
    expect(values, "lighting", "@sum", "indirect", indirect);
    expect(values, "lighting", "final", "out", final);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(traced.color[c], final[c], 1e-5);
}

TEST_F(TraceTest, WithoutLightsOnlyWhatNeedsNone) {
    RenderRequest dark = request();
    dark.lights = {"none"};
    const auto values = run(dark, 7, 20).trace.values;
    for (int light : {-1, 0}) EXPECT_EQ(find(values, "lighting", "ndotl", "out", light), nullptr);
    expect(values, "lighting", "steady", "out", {2});
    expect(values, "lighting", "@sum", "direct", {0, 0, 0});
}

// Every port once: a node that two outputs read, or that stands before the loop over lights, is not repeated.
TEST_F(TraceTest, EveryPortStandsOnce) {
    const auto values = run(request(), 7, 20).trace.values;
    for (const TracedValue& v : values) {
        const auto is_same = [&](const TracedValue& other) {
            return other.graph == v.graph && other.node == v.node && other.port == v.port && other.light == v.light;
        };
        EXPECT_EQ(std::count_if(values.begin(), values.end(), is_same), 1) << v.graph << " " << v.node << "." << v.port;
    }
}

// A pinned node has a value at each corner of the triangle, and the pixel sees what lies between them.
TEST_F(TraceTest, TheVertexStage) {
    const PixelTrace traced = run(request(), 7, 20).trace;
    double least = 1e9, most = -1e9;
    for (const std::vector<TracedValue>& corner : traced.corners) {
        const TracedValue* lean = find(corner, "material", "lean");
        ASSERT_NE(lean, nullptr);
        least = std::min(least, lean->values[0]);
        most = std::max(most, lean->values[0]);
        EXPECT_EQ(find(corner, "material", "ramp"), nullptr) << "it is computed in each pixel";
    }
    const double x = 3 * (2 * 7.5 / kSize - 1);  // the plane reaches from -1 to 1
    EXPECT_LE(least, x);
    EXPECT_GE(most, x);
    expect(traced.values, "material", "lean", "out", {x});
}

TEST_F(TraceTest, FloatRoundsAndDoubleDoesNot) {
    EXPECT_EQ(find(run(request(), 7, 20).trace.values, "material", "third")->values[0], double(1.0f / 3));
    EXPECT_EQ(find(run(request(), 7, 20, Precision::Double).trace.values, "material", "third")->values[0], 1.0 / 3);
}

TEST_F(TraceTest, PlacesAreThoseOfTheText) {
    const auto values = run(request(), 7, 20).trace.values;
    const TracedValue* half = find(values, "material", "layers/half");
    ASSERT_NE(half, nullptr);
    EXPECT_TRUE(half->file.ends_with("layers.subgraph.json")) << half->file;
    EXPECT_EQ(half->line, 4);
    EXPECT_EQ(half->column, 14);
}

// --- pixels

TEST_F(TraceTest, PixelsWithoutMaterial) {
    RenderRequest far = request();
    far.camera = "position=0,0,8 target=0,0,0 fov=53.13010235415598";
    const PixelTrace outside = run(far, 0, 0).trace;
    EXPECT_FALSE(outside.is_covered);
    EXPECT_TRUE(outside.values.empty());
    EXPECT_EQ(outside.color, (std::array<float, 4>{0.03f, 0.03f, 0.032f, 1})) << "the default background";

    const PixelTrace hole = run(request("leaf.graph.json"), 7, 20).trace;
    EXPECT_TRUE(hole.is_covered && hole.is_discarded);
    expect(hole.values, "material", "hole", "out", {7.5 / kSize - 0.5});
    EXPECT_EQ(hole.color, outside.color);
    EXPECT_FALSE(run(request("leaf.graph.json"), 20, 20).trace.is_discarded);
}

// In the picture of the same request, samples and all.
TEST_F(TraceTest, ThePixelIsTheOneThatIsDrawn) {
    RenderRequest ball = request();
    ball.mesh = "sphere";
    ball.camera = "";
    ball.samples = 3;
    ball.options.via = "cpu";
    const Compiler compiler;
    RenderMachine machine;
    const RenderOutcome drawn = render(compiler, ball, machine);
    ASSERT_TRUE(drawn.ok) << drawn.error;
    int at_edge = 0;
    for (int x = 0; x < kSize; ++x) {
        const PixelTrace traced = run(ball, x, 13).trace;
        for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(traced.color[c], drawn.image.at(x, 13)[c]) << "pixel " << x;
        at_edge += traced.is_covered && traced.color != traced.sample_color;
    }
    EXPECT_GT(at_edge, 0);
}

}  // namespace
}  // namespace patina::runtime
