// What an importer describes becomes the text that a person would have written: fmt changes nothing, and it compiles.
#include "compiler/importers/imported_graph.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "compiler/importers/importer.h"
#include "patina/patina.h"

namespace patina::importers {
namespace {

ImportedGraph rust() {
    ImportedGraph graph("rust");
    graph.comment = "From rust.gltf, material 2.\nIts occlusion is left out.";
    graph.workflow = "metallic-roughness";
    graph.properties.push_back({.name = "_Tint",
                                .type = "color",
                                .value = "#b04020",
                                .more = {{"label", "Tint"}, {"group", "Base"}},
                                .comment = "baseColorFactor"});
    graph.properties.push_back({.name = "_Amount", .type = "float", .value = 0.1f});
    graph.nodes.push_back({.id = "mask", .expression = "saturate($_Amount * 2)", .comment = "How much of it is rust"});
    graph.nodes.push_back(
        {.id = "rusty",
         .node = "Lerp",
         .inputs = {{"to", GraphValue::list({0.5, 0.25, 0})}, {"from", "$_Tint.rgb"}, {"t", "mask"}}});
    graph.surface = {{"roughness", 0.5}, {"baseColor", "rusty"}};
    graph.more.push_back({"help", "An \"old\" plate"});
    return graph;
}

TEST(ImportedGraph, IsWrittenAsAPersonWould) {
    EXPECT_EQ(rust().text(), R"json(// From rust.gltf, material 2.
// Its occlusion is left out.
{
  "patina": 1,
  "kind": "material",
  "name": "rust",
  "help": "An \"old\" plate",
  "workflow": "metallic-roughness",
  "properties": [
    // baseColorFactor
    { "name": "_Tint", "type": "color", "default": "#b04020", "label": "Tint", "group": "Base" },
    { "name": "_Amount", "type": "float", "default": 0.1 }
  ],
  "nodes": [
    // How much of it is rust
    { "id": "mask", "expr": "saturate($_Amount * 2)" },
    { "id": "rusty", "node": "Lerp", "in": { "to": [0.5, 0.25, 0], "from": "$_Tint.rgb", "t": "mask" } }
  ],
  "surface": { "roughness": 0.5, "baseColor": "rusty" }
}
)json");
}

TEST(ImportedGraph, IsCanonicalAndCompiles) {
    const Compiler compiler;
    const std::string text = rust().text();
    EXPECT_EQ(compiler.format("rust.graph.json", text).text, text);
    const Result result = compiler.compile_text("rust.graph.json", text);
    EXPECT_TRUE(result.ok && result.diagnostics.empty())
        << (result.diagnostics.empty() ? "" : to_text(result.diagnostics.front()));
}

TEST(ImportedGraph, LeavesOutWhatHasNoValue) {
    ImportedGraph graph("plain");
    graph.workflow = "unlit";
    graph.surface = {{"color", NAN}};
    const std::string text = graph.text();
    EXPECT_EQ(text.find("color"), text.npos);
    EXPECT_EQ(text.find("nodes"), text.npos);
    EXPECT_NE(text.find("\"surface\": {}"), text.npos);
}

TEST(ImportedGraph, RefusesANameThatIsNoText) {
    EXPECT_EQ(ImportedGraph("\xff").text(), "");
    EXPECT_NE(ImportedGraph("a\"b\\c").text(), "");
}

TEST(ImportedGraph, IsNotWrittenWithATypeThatIsNone) {
    ImportedGraph graph("plain");
    graph.workflow = "unlit";
    graph.properties.push_back({.name = "_A", .type = "flaot"});
    EXPECT_EQ(graph.text(), "");
    graph.properties[0].type = "float";
    EXPECT_NE(graph.text(), "");
}

TEST(ImportedGraph, NamesAnExpressionOnce) {
    ImportedGraph graph("names");
    const terms::Term sum = terms::expression("$_A + $_B", terms::Type::Float3);
    const auto id = [&] { return graph.ids.unique("sum", ""); };
    EXPECT_EQ(graph.named(sum, id, {3}).text(), "sum");
    EXPECT_EQ(graph.named(terms::swizzled(sum, "x"), id, {4}).text(), "sum.x");
    ASSERT_EQ(graph.nodes.size(), 1u);
    EXPECT_EQ(graph.nodes[0].expression, "$_A + $_B");
    EXPECT_EQ(graph.owners["sum"], std::set<std::size_t>{3});
    EXPECT_EQ(graph.outcomes[3].where, "the node 'sum'");
}

// A scalar that a colour is added to, a node that no library has, and an output of the vertex stage.
TEST(ImportedGraph, PutsConstantsWhereTheCompilerRefuses) {
    ImportedGraph graph("wrong");
    graph.workflow = "metallic-roughness";
    graph.add({.id = "sum", .expression = "nothing + 1"}, {5});
    graph.types["sum"] = terms::Type::Float3;
    graph.surface = {{"baseColor", "sum"}, {"roughness", "@noSuchValue"}};
    graph.vertex = {{"positionOS", "= @positionOS + missing"}};
    std::vector<std::string> places;
    const std::string error = graph.refuse_invalid(
        {}, [&](const Diagnostic& wrong, const std::string&) { places.push_back(wrong.node + "." + wrong.port); });
    EXPECT_EQ(error, "");
    EXPECT_EQ(places, (std::vector<std::string>{"vertex.positionOS", "surface.roughness"}));
    EXPECT_EQ(graph.outcomes[5].kind, Remark::Kind::LeftOut);
    EXPECT_EQ(graph.nodes[0].expression, "float3(1, 0, 1)");
    EXPECT_NE(graph.text().find("not imported: the graph would not be valid: "), std::string::npos);
    const Result result = Compiler().compile_text("wrong.graph.json", graph.text());
    EXPECT_TRUE(result.ok) << to_text(result.diagnostics.front());
}

TEST(ImportedGraph, IsAnErrorWhereNoConstantCanBe) {
    ImportedGraph graph("x");
    graph.workflow = "metallic-roughness";
    graph.nodes.push_back({.id = "moved", .node = "TilingOffset", .inputs = {{"tiling", "= @uv0 + nobody"}}});
    graph.surface = {{"roughness", "moved.x"}, {"metallic", "= nothing * 2"}};
    std::string said;
    const auto refused = [&] {
        return graph.refuse_invalid({}, [&](const Diagnostic& wrong, const std::string& reason) {
            said += fmt::format("{}.{}: {}\n", wrong.node, wrong.port, reason);
        });
    };
    EXPECT_EQ(refused(), "");
    for (const char* part : {"moved.tiling: the graph would not be valid: ", "surface.metallic: "})
        EXPECT_NE(said.find(part), std::string::npos) << part << "\n" << said;
    EXPECT_EQ(graph.nodes[0].inputs[0].value, GraphValue(1));
    EXPECT_EQ(graph.surface[0].value, GraphValue("moved.x"));
    said.clear();
    EXPECT_EQ(refused(), "");
    EXPECT_EQ(said, "");
    // No constant can stand for a property.
    graph.properties.push_back({.name = "_Count", .type = "int", .value = 0.5});
    const std::string error = refused();
    EXPECT_NE(error.find("would not be valid: the default of an int must be a whole number"), std::string::npos)
        << error;
}

TEST(Importers, WriteNothingThatTheCompilerRefuses) {
    const auto importer = [](Imported (*read)(const Source&, const Options&)) {
        return Importer{.name = "test",
                        .reads = "",
                        .example = "",
                        .makes_pictures = false,
                        .recognises = [](const Source&) { return true; },
                        .read = read};
    };
    constexpr const char* kGraph = R"({ "patina": 1, "workflow": "unlit", "surface": {} })";
    constexpr const char* kScene = R"({ "patina": 1, "kind": "scene", "name": "s", "camera": { "position": [0, 0, 5] },
        "materials": [{ "name": "m", "graph": "m.graph.json" }], "objects": [{ "id": "o", "mesh": "sphere", "material": "m" }] })";
    const auto right = importer([](const Source&, const Options&) {
        return Imported{.graphs = {{"m.graph.json", kGraph}, {"s.scene.json", kScene}}};
    });
    EXPECT_EQ(read_verified(right, {.path = "x", .start = {}}, {}).error, "");
    const auto lacks_graph = importer([](const Source&, const Options&) {
        return Imported{.graphs = {{"s.scene.json", kScene}}};
    });
    const Imported lacking = read_verified(lacks_graph, {.path = "x", .start = {}}, {});
    EXPECT_NE(lacking.error.find("x: 's.scene.json' would not be valid: "), std::string::npos) << lacking.error;
    EXPECT_TRUE(lacking.graphs.empty());
    const auto is_wrong = importer([](const Source&, const Options&) {
        return Imported{
            .graphs = {{"m.graph.json", R"({ "patina": 1, "workflow": "unlit", "surface": { "no": 1 } })"}}};
    });
    EXPECT_NE(read_verified(is_wrong, {.path = "x", .start = {}}, {}).error.find("'m.graph.json' would not be valid"),
              std::string::npos);
}

TEST(Importers, HaveNamesAndRecogniseTheirFilesAlone) {
    for (const Importer& importer : importers()) {
        EXPECT_FALSE(importer.name.empty() || importer.reads.empty());
        EXPECT_TRUE(importer.example.starts_with("patina import ")) << importer.name;
    }
    EXPECT_EQ(importer_of({.path = "rust.graph.json", .start = "{"}), nullptr);
    const Importer* table = importer_of({.path = "gold-paint.binary", .start = {}});
    ASSERT_NE(table, nullptr);
    EXPECT_EQ(table->name, "merl");
}

}  // namespace
}  // namespace patina::importers
