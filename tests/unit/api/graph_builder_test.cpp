// Graphs that are built in code: the same shaders as those of a file, and diagnostics that name the node and the port.
#include "patina/graph_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "patina/patina.h"

namespace patina {
namespace {

const Compiler& compiler() {
    static const Compiler kCompiler;
    return kCompiler;
}

std::string said(const Result& result) {
    std::string all;
    for (const Diagnostic& diagnostic : result.diagnostics) all += to_text(diagnostic) + "\n";
    return all;
}

TEST(GraphBuilder, SaysWhichNumberIsNone) {
    for (const double none : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        GraphBuilder graph("x.graph.json");
        graph.set("workflow", "unlit").surface("alpha", none);
        const std::vector<Diagnostic> all = Compiler().compile(graph).diagnostics;
        ASSERT_EQ(all.size(), 1u);
        EXPECT_TRUE(all[0].message.ends_with(", not infinity or NaN")) << all[0].message;
        EXPECT_EQ(all[0].port, "alpha");
    }
}

TEST(GraphBuilder, HasComments) {
    GraphBuilder graph("rust.graph.json");
    graph.set("//", "From rust.gltf,\r\nmaterial 2").set("workflow", "unlit").set("//", "A plate").set("help", "old");
    graph.property("_Map", PropertyType::Texture2D, std::nullopt, {{"//", "Not found"}, {"usage", "data"}});
    graph.node("mask", "OneMinus", {{"value", 0.5}}, {{"//", "How much\nof it is rust"}});
    graph.surface("color", "mask");
    EXPECT_EQ(graph.text(), R"(// From rust.gltf,
// material 2
{
  "patina": 1,
  "workflow": "unlit",
  // A plate
  "help": "old",
  "properties": [
    // Not found
    { "name": "_Map", "type": "texture2d", "usage": "data" }
  ],
  "nodes": [
    // How much
    // of it is rust
    { "id": "mask", "node": "OneMinus", "in": { "value": 0.5 } }
  ],
  "surface": {
    "color": "mask"
  }
}
)");
    EXPECT_TRUE(compiler().compile(graph).ok) << said(compiler().compile(graph));
    // What is no text is no comment.
    graph.set("//", 3);
    EXPECT_NE(said(compiler().compile(graph)).find("[unknown-key]"), std::string::npos);
}

// An int has no exponent, however many zeros it has.
TEST(GraphBuilder, WritesWholeNumbersWithAllDigits) {
    EXPECT_EQ(GraphValue(100000).json(), "100000");
    EXPECT_EQ(GraphValue(-1e15).json(), "-1e+15");
    EXPECT_EQ(GraphValue(0.1f).json(), "0.1");
    EXPECT_EQ(GraphValue::list({true, "a\"b", GraphValue::object({{"k", 2.5}})}).json(),
              R"([true, "a\"b", { "k": 2.5 }])");
}

TEST(GraphBuilder, MakesWhatTheFileMakes) {
    GraphBuilder graph("rust.graph.json");
    graph.set("workflow", "metallic-roughness").set("lighting", "unity-brdf1");
    graph.set("render", GraphValue::object({{"surface", "cutout"}, {"cull", "off"}}));
    graph.property("_Tint", PropertyType::Color, "#c9a27e", {{"label", "Tint"}});
    graph.property("_Amount", PropertyType::Float, 0.5, {{"range", GraphValue::list({0, 1})}});
    graph.property("_Map", PropertyType::Texture2D, "white", {{"tiling", true}});
    const GraphNode texel = graph.node("texel", "SampleTexture2D", {{"texture", "$_Map"}});
    const GraphNode mask = graph.expression("mask", "smoothstep(0, $_Amount, texel.a)");
    const GraphNode mixed =
        graph.node("mixed", "Lerp", {{"from", GraphValue::list({0.25, 0.5, 1})}, {"to", texel["rgb"]}, {"t", mask}});
    graph.surface("baseColor", "= mixed * $_Tint.rgb").surface("roughness", mask).surface("alpha", texel["a"]);
    graph.vertex("positionOS", "= @positionOS * 1.5");
    const Result built = compiler().compile(graph);
    ASSERT_TRUE(built.ok) << said(built) << graph.text();

    const Result read = compiler().compile_text("rust.graph.json", R"json({
        "patina": 1, "workflow": "metallic-roughness", "lighting": "unity-brdf1",
        "render": { "surface": "cutout", "cull": "off" },
        "properties": [ { "name": "_Tint", "type": "color", "default": "#c9a27e", "label": "Tint" },
                        { "name": "_Amount", "type": "float", "default": 0.5, "range": [0, 1] },
                        { "name": "_Map", "type": "texture2d", "default": "white", "tiling": true } ],
        "nodes": [ { "id": "texel", "node": "SampleTexture2D", "in": { "texture": "$_Map" } },
                   { "id": "mask", "expr": "smoothstep(0, $_Amount, texel.a)" },
                   { "id": "mixed", "node": "Lerp", "in": { "from": [0.25, 0.5, 1], "to": "texel.rgb", "t": "mask" } } ],
        "surface": { "baseColor": "= mixed * $_Tint.rgb", "roughness": "mask", "alpha": "texel.a" },
        "vertex": { "positionOS": "= @positionOS * 1.5" } })json");
    ASSERT_TRUE(read.ok) << said(read);
    EXPECT_EQ(built.reflection.to_json(), read.reflection.to_json());
    ASSERT_EQ(built.shaders.size(), read.shaders.size());
    for (std::size_t i = 0; i < read.shaders.size(); ++i) EXPECT_EQ(built.shaders[i].text, read.shaders[i].text);
    EXPECT_EQ(mixed.id, "mixed");
}

TEST(GraphBuilder, MakesSubGraphs) {
    GraphBuilder part("part.subgraph.json");
    part.set("kind", "subgraph").input("scale", "float", {{"default", 4}});
    part.output("value", part.expression("wave", "sin(@uv0.x * $scale)"));
    GraphBuilder graph("whole.graph.json");
    graph.set("workflow", "unlit");
    graph.surface("color", graph.node("part", "./part.subgraph.json", {{"scale", 8}}));
    CompileOptions options;
    options.files.read = [&](const std::string& path) {
        return path == part.path() ? std::optional(part.text()) : std::nullopt;
    };
    const Result result = compiler().compile(graph, options);
    EXPECT_TRUE(result.ok) << said(result);
    EXPECT_EQ(result.dependencies, (std::vector<std::string>{"whole.graph.json", "part.subgraph.json"}));
}

// One mistake, and where the diagnostic says it is.
struct Mistake {
    const char* what;
    void (*make)(GraphBuilder&);
    const char *code, *node, *port;
};

TEST(GraphBuilder, DiagnosticsNameTheNodeAndThePort) {
    const Mistake mistakes[] = {
        {"a node that is not there", [](GraphBuilder& g) { g.surface("color", g.node("n", "Lrep")); }, "unknown-node",
         "n", ""},
        {"an input that is not there",
         [](GraphBuilder& g) {
             g.surface("color", g.node("n", "Lerp", {{"c", 1}}));
         },
         "unknown-port", "n", "c"},
        {"a link to nothing",
         [](GraphBuilder& g) {
             g.surface("color", g.node("n", "Sine", {{"angle", "none"}}));
         },
         "dangling-link", "n", "angle"},
        {"a bad link",
         [](GraphBuilder& g) {
             g.surface("color", g.node("n", "Sine", {{"angle", "a b"}}));
         },
         "bad-character", "n", "angle"},
        {"a vector of five",
         [](GraphBuilder& g) {
             g.surface("color", g.node("n", "Sine", {{"angle", GraphValue::list({1, 2, 3, 4, 5})}}));
         },
         "wrong-json-type", "n", "angle"},
        {"no number",
         [](GraphBuilder& g) {
             g.surface("color", g.node("n", "Sine", {{"angle", std::nan("")}}));
         },
         "wrong-json-type", "n", "angle"},
        {"a number that no float holds",
         [](GraphBuilder& g) {
             g.surface("color", g.node("n", "Sine", {{"angle", std::numeric_limits<double>::max()}}));
         },
         "bad-number", "n", "angle"},
        {"an id twice",
         [](GraphBuilder& g) {
             g.expression("n", "1");
             g.surface("color", g.expression("n", "2"));
         },
         "duplicate-id", "n", ""},
        {"a bad id", [](GraphBuilder& g) { g.surface("color", g.expression("1n", "2")); }, "bad-identifier", "1n", ""},
        {"an expression that ends too early", [](GraphBuilder& g) { g.surface("color", g.expression("n", "1 +")); },
         "syntax", "n", ""},
        {"an unknown key",
         [](GraphBuilder& g) {
             g.surface("color", g.expression("n", "1", {{"stagee", "vertex"}}));
         },
         "unknown-key", "n", ""},
        {"an input twice",
         [](GraphBuilder& g) {
             g.surface("color", g.node("n", "Sine", {{"angle", 1}, {"angle", 2}}));
         },
         "duplicate-key", "n", "angle"},
        {"a cycle", [](GraphBuilder& g) { g.surface("color", g.expression("n", "n + 1")); }, "cycle", "n", ""},
        {"an unknown surface input", [](GraphBuilder& g) { g.surface("colour", 1); }, "unknown-surface-input",
         "surface", "colour"},
        {"a bad colour", [](GraphBuilder& g) { g.surface("color", "#12"); }, "bad-color", "surface", "color"},
        {"a type that does not fit",
         [](GraphBuilder& g) {
             g.surface("alpha", GraphValue::list({1, 2}));
         },
         "type-mismatch", "surface", "alpha"},
        {"a bad vertex output", [](GraphBuilder& g) { g.vertex("positionOS", "@uv9"); }, "unknown-semantic", "vertex",
         "positionOS"},
        {"a default of another type", [](GraphBuilder& g) { g.property("_A", PropertyType::Float, "red"); },
         "wrong-json-type", "properties", "_A"},
        {"a property twice",
         [](GraphBuilder& g) {
             g.property("_A", PropertyType::Float, 1);
             g.property("_A", PropertyType::Float, 2);
         },
         "duplicate-id", "properties", "_A"},
        {"a texture that is not there",
         [](GraphBuilder& g) { g.property("_A", PropertyType::Texture2D, "./none.png"); }, "missing-file", "properties",
         "_A"},
    };
    for (const Mistake& mistake : mistakes) {
        SCOPED_TRACE(mistake.what);
        GraphBuilder graph("test.graph.json");
        graph.set("workflow", "unlit");
        mistake.make(graph);
        const Result result = compiler().compile(graph);
        EXPECT_FALSE(result.ok);
        ASSERT_FALSE(result.diagnostics.empty());
        const Diagnostic& first = result.diagnostics[0];
        EXPECT_EQ(first.code, mistake.code) << said(result);
        EXPECT_EQ(first.node, mistake.node) << said(result);
        EXPECT_EQ(first.port, mistake.port) << said(result);
    }
}

TEST(GraphBuilder, TextThatIsNotUtf8NamesItsPlace) {
    GraphBuilder graph("test.graph.json");
    graph.set("workflow", "unlit");
    graph.surface("color", graph.node("n", "Sine", {{"angle", "\xff"}}));
    const Result result = compiler().compile(graph);
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].code, "not-utf8");
    EXPECT_EQ(result.diagnostics[0].node, "n");
    EXPECT_EQ(result.diagnostics[0].port, "angle");
}

TEST(GraphBuilder, AFloatHasItsFewestDigits) {
    GraphBuilder graph("test.graph.json");
    graph.set("workflow", "unlit").set("meta", GraphValue::list({0.1f, 0.1, 1.0f / 3, 1.0 / 3, 7}));
    EXPECT_NE(graph.text().find("[0.1, 0.1, 0.33333334, 0.3333333333333333, 7]"), std::string::npos) << graph.text();
}

TEST(GraphBuilder, TextsAreQuoted) {
    GraphBuilder graph("test.graph.json");
    graph.set("workflow", "unlit").set("help", "a \"quoted\"\nline \\ and a tab\t");
    EXPECT_NE(graph.text().find(R"("help": "a \"quoted\"\nline \\ and a tab\t")"), std::string::npos) << graph.text();
    const Compiler::Formatted formatted = compiler().format("test.graph.json", graph.text());
    EXPECT_TRUE(formatted.ok);
}

}  // namespace
}  // namespace patina
