// What an importer describes becomes the text that a person would have written: fmt changes nothing, and it compiles.
#include "compiler/importers/graph_writer.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "compiler/importers/importer.h"
#include "patina/patina.h"

namespace patina::importers {
namespace {

GraphFile rust() {
    GraphFile graph{.comment = "From rust.gltf, material 2.\nIts occlusion is left out.",
                    .name = "rust",
                    .workflow = "metallic-roughness"};
    graph.properties.push_back({.name = "_Tint",
                                .type = "color",
                                .value = text("#b04020"),
                                .more = {{"label", text("Tint")}, {"group", text("Base")}},
                                .comment = "baseColorFactor"});
    graph.properties.push_back({.name = "_Amount", .type = "float", .value = number(0.1f)});
    graph.nodes.push_back({.id = "mask", .expression = "saturate($_Amount * 2)", .comment = "How much of it is rust"});
    graph.nodes.push_back({.id = "rusty",
                           .node = "Lerp",
                           .inputs = {{"to", list({number(0.5), number(0.25), number(0.0)})},
                                      {"from", text("$_Tint.rgb")},
                                      {"t", text("mask")}}});
    graph.surface = {{"roughness", number(0.5)}, {"baseColor", text("rusty")}};
    graph.more.push_back({"help", text("An \"old\" plate")});
    return graph;
}

TEST(GraphWriter, WritesWhatAPersonWould) {
    EXPECT_EQ(write_graph(rust()), R"json(// From rust.gltf, material 2.
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

TEST(GraphWriter, IsCanonicalAndCompiles) {
    const Compiler compiler;
    const std::string text = write_graph(rust());
    EXPECT_EQ(compiler.format("rust.graph.json", text).text, text);
    const Result result = compiler.compile_text("rust.graph.json", text);
    EXPECT_TRUE(result.ok && result.diagnostics.empty())
        << (result.diagnostics.empty() ? "" : to_text(result.diagnostics.front()));
}

TEST(GraphWriter, LeavesOutWhatHasNoValue) {
    GraphFile graph{.name = "plain", .workflow = "unlit"};
    graph.surface = {{"color", number(double(NAN))}, {"alpha", Value{}}};
    const std::string text = write_graph(graph);
    EXPECT_EQ(text.find("color"), text.npos);
    EXPECT_EQ(text.find("nodes"), text.npos);
    EXPECT_NE(text.find("\"surface\": {}"), text.npos);
}

TEST(GraphWriter, RefusesANameThatIsNoText) {
    EXPECT_EQ(write_graph({.name = "\xff", .workflow = "unlit"}), "");
    EXPECT_NE(write_graph({.name = "a\"b\\c", .workflow = "unlit"}), "");
}

TEST(Values, HaveTheFewestDigits) {
    EXPECT_EQ(number(0.1).json, "0.1");
    EXPECT_EQ(number(0.1f).json, "0.1");
    EXPECT_EQ(list(std::array<float, 3>{1, 0.2f, 0}).json, "[1, 0.2, 0]");
    EXPECT_EQ(flag(true).json, "true");
    EXPECT_EQ(text("a \"b\"").json, "\"a \\\"b\\\"\"");
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
