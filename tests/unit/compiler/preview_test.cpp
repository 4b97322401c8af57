// What a preview shows: a node's port, a surface input, or a node inside a sub-graph. The values are constants, so that
// each can be read off the printed colour.
#include <gtest/gtest.h>

#include "patina/patina.h"

namespace patina {
namespace {

constexpr const char* kGraph = R"({
  "patina": 1,
  "workflow": "metallic-roughness",
  "nodes": [
    { "id": "half", "expr": "0.5" },
    { "id": "layers", "node": "./layers.subgraph.json", "in": { "x": "half" } },
    { "id": "again", "node": "./layers.subgraph.json", "in": { "x": 1 } }
  ],
  "surface": { "baseColor": "= layers.sum + again.sum", "roughness": 0.125 }
})";
constexpr const char* kLayers = R"({
  "patina": 1,
  "kind": "subgraph",
  "inputs": [ { "name": "x", "type": "float", "default": 0 } ],
  "nodes": [
    { "id": "quarter", "expr": "$x * 0.5" },
    { "id": "deep", "node": "./deep.subgraph.json" }
  ],
  "outputs": { "sum": "= quarter + deep" }
})";
constexpr const char* kDeep = R"({
  "patina": 1,
  "kind": "subgraph",
  "nodes": [ { "id": "small", "expr": "0.0625" } ],
  "outputs": { "value": "= small * 2" }
})";

Result preview(const std::string& port, const std::string& graph = kGraph) {
    CompileOptions options;
    options.request = CompileOptions::Preview{.port = port};
    options.targets = {Target::Glsl};
    options.files.read = [](const std::string& path) -> std::optional<std::string> {
        if (path.ends_with("layers.subgraph.json")) return kLayers;
        if (path.ends_with("deep.subgraph.json")) return kDeep;
        return {};
    };
    return Compiler().compile_text("test.graph.json", graph, options);
}

// The grey that the fragment stage writes.
std::string shown(const std::string& port, const std::string& graph = kGraph) {
    const Result result = preview(port, graph);
    if (!result.ok) return result.diagnostics.empty() ? "?" : result.diagnostics[0].message;
    const std::string& text = result.shaders.back().text;
    constexpr std::string_view kStart = "outColor = vec4(";
    const std::size_t at = text.find(kStart);
    if (at == text.npos) return text;
    return text.substr(at + kStart.size(), text.find(',', at) - at - kStart.size());
}

TEST(Preview, ShowsAPortOfTheGraph) {
    EXPECT_EQ(shown("half"), "0.5");
    EXPECT_EQ(shown("layers"), "0.375");  // 0.5 * 0.5 + 0.0625 * 2
    EXPECT_EQ(shown("roughness"), "0.125");
}

TEST(Preview, ShowsWhatIsInsideASubgraphAsItsNodeFeedsIt) {
    EXPECT_EQ(shown("layers/quarter"), "0.25");
    EXPECT_EQ(shown("again/quarter"), "0.5");
    EXPECT_EQ(shown("layers/deep"), "0.125");
    EXPECT_EQ(shown("layers/deep/small"), "0.0625");
}

// Another node, a pinned one and the material read outputs of the sub-graph while a node inside is shown.
TEST(Preview, ShowsWhatIsInsideASubgraphThatOthersRead) {
    constexpr const char* kReaders = R"({
  "patina": 1,
  "workflow": "unlit",
  "nodes": [
    { "id": "layers", "node": "./layers.subgraph.json", "in": { "x": 0.5 } },
    { "id": "moved", "node": "./layers.subgraph.json", "in": { "x": 3 }, "stage": "vertex" },
    { "id": "named", "expr": "layers.sum + moved.sum" },
    { "id": "alone", "expr": "layers + moved" }
  ],
  "surface": { "color": "= named + alone" }
})";
    EXPECT_EQ(shown("layers/quarter", kReaders), "0.25");
    EXPECT_EQ(shown("layers/deep/small", kReaders), "0.0625");
    EXPECT_EQ(shown("moved/quarter", kReaders), "1.5");
    EXPECT_EQ(shown("alone", kReaders), "2.0");  // 0.375 + 1.625
}

// The value covers what is behind it, whatever the material does.
TEST(Preview, IsNotBlended) {
    for (const char* surface : {"additive", "multiply", "fade", "transparent", "cutout"}) {
        SCOPED_TRACE(surface);
        const std::string graph = std::string(R"({ "patina": 1, "workflow": "unlit",
  "nodes": [ { "id": "half", "expr": "0.5" } ],
  "surface": { "color": "half", "alpha": 0.25 },
  "render": { "cull": "off", "depthTest": "greater", "depthWrite": false, "queue": 3100,
              "stencil": { "test": "equal", "reference": 3 }, "surface": ")") +
                                  surface + "\" } }";
        const Result result = preview("half", graph);
        ASSERT_TRUE(result.ok);
        ASSERT_EQ(result.reflection.passes.size(), 1u);
        const Pass& pass = result.reflection.passes[0];
        EXPECT_EQ(pass.targets[0].blend.source, BlendFactor::One);
        EXPECT_EQ(pass.targets[0].blend.destination, BlendFactor::Zero);
        EXPECT_EQ(pass.cull, Cull::Off);
        EXPECT_EQ(pass.depth_test, Compare::LessEqual);
        EXPECT_TRUE(pass.depth_write);
        EXPECT_EQ(pass.stencil.test, Compare::Always);
        EXPECT_EQ(shown("half", graph), "0.5");
    }
}

TEST(Preview, SaysWhatIsNotThere) {
    for (const char* port : {"layers/nothing", "nothing/quarter", "half/quarter", "layers/", "layers/quarter/x", "/x",
                             "layers.sum/quarter"}) {
        const Result result = preview(port);
        EXPECT_FALSE(result.ok) << port;
        ASSERT_FALSE(result.diagnostics.empty()) << port;
        EXPECT_EQ(result.diagnostics[0].file, "preview") << port;
    }
}

// What lighting reads of the surface, and inputs that the graph leaves to their defaults. A dielectric's f0 is 0.04.
TEST(Preview, ShowsEveryValueOfTheSurface) {
    EXPECT_TRUE(shown("alpha").starts_with("1.0")) << shown("alpha");  // vec4(1.0)
    const Result f0 = preview("f0");
    ASSERT_TRUE(f0.ok);
    EXPECT_NE(f0.shaders.back().text.find("0.04"), std::string::npos) << f0.shaders.back().text;
}

constexpr const char* kOwnLighting = R"({
  "patina": 1,
  "workflow": "metallic-roughness",
  "lighting": {
    "patina": 1,
    "kind": "lighting",
    "nodes": [
      { "id": "share", "expr": "0.375" },
      { "id": "layers", "node": "./layers.subgraph.json", "in": { "x": 1 } },
      { "id": "lit", "expr": "share * @light.radiance" }
    ],
    "direct": "= lit * layers.sum",
    "indirect": "= share"
  },
  "passes": [ { "name": "rim", "workflow": "unlit", "surface": { "color": 0.75 } } ],
  "surface": { "emission": 100 }
})";

// A value that does not depend on the light counts once, and nothing else is added to it.
TEST(Preview, ShowsValuesOfTheLightingGraph) {
    EXPECT_EQ(shown("lighting/share", kOwnLighting), "0.375");
    EXPECT_EQ(shown("lighting/layers/quarter", kOwnLighting), "0.5");
    EXPECT_EQ(shown("lighting/layers", kOwnLighting), "0.625");  // 1 * 0.5 + 0.0625 * 2
    EXPECT_EQ(shown("lighting/indirect", kOwnLighting), "0.375");
    const Result summed = preview("lighting/lit", kOwnLighting);
    ASSERT_TRUE(summed.ok);
    const std::string& text = summed.shaders.back().text;
    EXPECT_NE(text.find("for ("), std::string::npos) << text;
    EXPECT_EQ(text.find("100"), std::string::npos) << text;
}

// A value that reads the sums is computed after all lights, which are as in the picture.
TEST(Preview, ShowsWhatIsComputedAfterTheLights) {
    std::string graph = kOwnLighting;
    const std::string last = "\"indirect\": \"= share\"";
    graph.replace(graph.find(last), last.size(), "\"indirect\": \"= share\", \"final\": \"= dimmed + 0.25\"");
    const std::string node = "{ \"id\": \"share\"";
    graph.replace(graph.find(node), 0, "{ \"id\": \"dimmed\", \"expr\": \"@sum.direct * 0.875\" }, ");
    for (const std::string port : {"lighting/final", "lighting/dimmed"}) {
        const Result result = preview(port, graph);
        ASSERT_TRUE(result.ok) << port << ": " << result.diagnostics[0].message;
        const std::string& text = result.shaders.back().text;
        EXPECT_NE(text.find("0.875"), std::string::npos) << text;
        EXPECT_NE(text.find("for ("), std::string::npos) << text;
        EXPECT_EQ(text.find("0.25") != std::string::npos, port == "lighting/final") << text;
        EXPECT_EQ(text.find("100"), std::string::npos) << text;
    }
    // Without a 'final' of its own: all light, and the emission.
    const Result all = preview("lighting/final", kOwnLighting);
    ASSERT_TRUE(all.ok) << all.diagnostics[0].message;
    for (const char* part : {"100", "0.375", "for ("})
        EXPECT_NE(all.shaders.back().text.find(part), std::string::npos) << all.shaders.back().text;
}

TEST(Preview, ShowsValuesOfAnExtraPass) {
    EXPECT_EQ(shown("rim/color", kOwnLighting), "0.75");
}

TEST(Preview, ANodeComesBeforeOtherValuesOfItsName) {
    constexpr const char* kNamesakes = R"({
  "patina": 1, "workflow": "metallic-roughness",
  "nodes": [ { "id": "f0", "expr": "0.6875" }, { "id": "lighting", "node": "./deep.subgraph.json" } ],
  "surface": { "roughness": "= f0 * lighting" }
})";
    EXPECT_EQ(shown("f0", kNamesakes), "0.6875");
    EXPECT_EQ(shown("lighting/small", kNamesakes), "0.0625");
}

}  // namespace
}  // namespace patina
