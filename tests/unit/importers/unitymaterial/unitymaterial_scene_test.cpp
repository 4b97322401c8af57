// Materials of Unity whose shader is a shader graph: the graph, and a scene with the values of the material.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/importers/shadergraph/shadergraph_writer.h"
#include "tests/unit/importers/unitymaterial/unitymaterial_check.h"

namespace patina::importers {
namespace {

constexpr const char* kGraph = "2123456789abcdef0123456789abcdef";
constexpr const char* kBrick = "0123456789abcdef0123456789abcdef";

// A graph with a property of each kind, which it need not read.
ShaderGraphText graph() {
    return {.properties = {
                {.id = "tint", .kind = "Color", .name = "Tint", .value = R"({"r":1.0,"g":0.5019608,"b":0.0,"a":1.0})"},
                {.id = "glow",
                 .kind = "Color",
                 .name = "Glow",
                 .value = R"({"r":1.0,"g":1.0,"b":1.0,"a":1.0})",
                 .more = R"("m_ColorMode":1)"},
                {.id = "main",
                 .kind = "Texture2D",
                 .name = "MainTex",
                 .value = R"({"m_SerializedTexture":"","m_Guid":""})"},
                {.id = "wear", .kind = "Vector1", .name = "Wear", .value = "0.25"},
                {.id = "wind", .kind = "Vector2", .name = "Wind", .value = R"({"x":0.0,"y":0.0,"z":0.0,"w":0.0})"},
                {.id = "old", .kind = "Boolean", .name = "Old", .value = "false"}}};
}

MaterialText material() {
    return {.shader = fmt::format("{{fileID: -6465566751694194690, guid: {}, type: 3}}", kGraph),
            .textures = {{"_MainTex", kBrick}},
            .numbers = {{"_Wear", "0.75"}, {"_Old", "1"}, {"_QueueOffset", "0"}},
            .colors = {{"_Tint", "{r: 0, g: 0.5019608, b: 1, a: 1}"},
                       {"_Glow", "{r: 4, g: 2, b: 0.5, a: 1}"},
                       {"_Wind", "{r: 1, g: 2, b: 0, a: 0}"}}};
}

constexpr std::string_view kScene = R"({
  "patina": 1,
  "kind": "scene",
  "name": "x",
  "camera": { "position": [0, 0, 5] },
  "lights": [
    { "type": "directional", "direction": [-0.6, 0.8, 0.8], "color": [0.41, 0.395, 0.375] },
    { "type": "directional", "direction": [0.9, 0.1, 0.5], "color": [0.042, 0.053, 0.07] },
    { "type": "directional", "direction": [0.5, 0.5, -0.8], "color": [0.155, 0.155, 0.155] }
  ],
  "materials": [
    {
      "name": "x",
      "graph": "Rock.graph.json",
      "set": {
        "_Tint": "#0080ff",
        "_Glow": [4, 2, 0.5],
        "_MainTex": "./brick.png",
        "_Wear": 0.75,
        "_Wind": [1, 2],
        "_Old": true
      }
    }
  ],
  "objects": [
    { "id": "ball", "mesh": "sphere", "material": "x" }
  ]
}
)";

TEST(UnityMaterialOfAGraph, BecomesAScene) {
    const MaterialFolder folder;
    folder.save("Rock.shadergraph", graph().new_layout(), kGraph);
    folder.save("brick.png", "", kBrick);
    const Imported made = import_in(folder, material());
    EXPECT_EQ(file_of(made, "x.scene.json"), kScene);
    EXPECT_EQ(made.scene, "x.scene.json");
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    const std::string taken = remarks(made, Remark::Kind::Taken);
    EXPECT_NE(taken.find("shader 'Rock.shadergraph': 'x.scene.json', a scene"), std::string::npos) << taken;
    EXPECT_NE(taken.find("property '_Wear': the value of '_Wear' in the scene"), std::string::npos) << taken;
    EXPECT_NE(taken.find("properties _QueueOffset: not read by this shader"), std::string::npos) << taken;
    const auto of_graph = std::ranges::find(made.remarks, "property 'Wear'", &Remark::part);
    ASSERT_NE(of_graph, made.remarks.end()) << taken;
    EXPECT_EQ(of_graph->file, "Rock.shadergraph");
    EXPECT_GT(of_graph->line, 0);
    EXPECT_GT(of_graph->column, 0);
    expect_compiles(made, "graph", "Rock.graph.json");
}

TEST(UnityMaterialOfAGraph, ValuesOfTheGraphAreNotRepeated) {
    const MaterialFolder folder;
    folder.save("Rock.shadergraph", graph().new_layout(), kGraph);
    MaterialText same = material();
    same.textures.clear();
    same.numbers = {{"_Wear", "0.25"}, {"_Old", "0"}};
    same.colors = {{"_Tint", "{r: 1, g: 0.5019608, b: 0, a: 1}"}};
    const Imported made = import_in(folder, same);
    EXPECT_EQ(file_of(made, "x.scene.json").find("\"set\""), std::string::npos) << file_of(made, "x.scene.json");
}

TEST(UnityMaterialOfAGraph, KeywordsAreVariants) {
    const MaterialFolder folder;
    ShaderGraphText text = graph();
    text.keywords.push_back({.id = "mud",
                             .kind = "",
                             .name = "Mud",
                             .value = "0",
                             .more = R"("m_KeywordType":0,"m_KeywordDefinition":0,"m_IsEditable":true)",
                             .reference = "_MUD"});
    text.keywords.push_back({.id = "sky",
                             .kind = "",
                             .name = "Sky",
                             .value = "0",
                             .more = R"("m_KeywordType":1,"m_KeywordDefinition":0,"m_IsEditable":true,)"
                                     R"("m_Entries":[{"id":1,"displayName":"Sun","referenceName":"SUN"},)"
                                     R"({"id":2,"displayName":"Heavy Rain","referenceName":"WET"}])",
                             .reference = "_SKY"});
    folder.save("Rock.shadergraph", text.new_layout(), kGraph);
    MaterialText on = material();
    on.keywords = {"_MUD", "_SKY_WET", "_SKY_SNOW"};
    const Imported made = import_in(folder, on);
    const std::string scene = file_of(made, "x.scene.json");
    EXPECT_NE(scene.find("\"_MUD\": true"), std::string::npos) << scene;
    EXPECT_NE(scene.find("\"_SKY\": \"WET\""), std::string::npos) << scene;
    std::string keywords;
    for (const Remark& each : made.remarks)
        if (each.file.empty() && each.part.starts_with("keyword")) keywords += each.part + ": " + each.text + "\n";
    EXPECT_EQ(keywords,
              "keyword '_MUD': the value of '_MUD'\nkeyword '_SKY_WET': the value of '_SKY'\n"
              "keywords _SKY_SNOW: not read by this shader\n");
    const std::string off = file_of(import_in(folder, material()), "x.scene.json");
    EXPECT_EQ(off.find("_MUD"), std::string::npos) << off;
}

// A switch with a value for each instance is a number, not a keyword.
TEST(UnityMaterialOfAGraph, ValuesForEachInstanceAreNumbers) {
    const MaterialFolder folder;
    ShaderGraphText source = graph();
    source.properties.back().more = R"("m_GPUInstanced":true)";
    folder.save("Rock.shadergraph", source.new_layout(), kGraph);
    const Imported made = import_in(folder, material());
    EXPECT_NE(file_of(made, "x.scene.json").find("\"_Old\": true"), std::string::npos);
}

TEST(UnityMaterialOfAGraph, AGraphThatIsThereIsUsed) {
    const MaterialFolder folder;
    folder.save("Rock.shadergraph", graph().new_layout(), kGraph);
    folder.save("Rock.graph.json",
                R"({ "patina": 1, "workflow": "unlit", "properties": [ { "name": "_Wear", "type": "float" } ] })");
    const Imported made = import_in(folder, material());
    ASSERT_EQ(made.graphs.size(), 1u) << made.error;
    EXPECT_NE(file_of(made, "x.scene.json").find("\"_Wear\": 0.75"), std::string::npos);
    EXPECT_EQ(file_of(made, "x.scene.json").find("_Tint"), std::string::npos);
    folder.save("Rock.graph.json", "{");
    EXPECT_NE(import_in(folder, material()).error.find("'Rock.graph.json' in the output folder is not a graph"),
              std::string::npos);
}

// Where the graph lets materials change its settings, the material has a graph of its own.
TEST(UnityMaterialOfAGraph, TheStateIsTheMaterials) {
    struct Case {
        std::vector<ValueText> numbers;
        const char *render, *changed;
    };
    const Case cases[] = {
        {{}, nullptr, ""},
        {{{"_Surface", "0"}, {"_AlphaClip", "0"}, {"_Cull", "2"}, {"_ZWrite", "1"}, {"_ZTest", "4"}}, nullptr, ""},
        {{{"_Surface", "1"}, {"_Blend", "0"}, {"_ZWrite", "0"}}, R"("surface": "fade", "materialOverride": true)", ""},
        {{{"_Surface", "1"}, {"_Blend", "1"}, {"_ZWrite", "1"}, {"_Cull", "0"}, {"_ZTest", "8"}},
         R"("surface": "transparent", "cull": "off", "depthWrite": true, "depthTest": "always", "materialOverride": true)",
         ""},
        {{{"_Surface", "1"}, {"_Blend", "2"}, {"_ZWrite", "0"}},
         R"("surface": "additive", "materialOverride": true)",
         "'_Blend'"},
        {{{"_AlphaClip", "1"}, {"_Cull", "1"}},
         R"("surface": "cutout", "cull": "front", "materialOverride": true)",
         ""},
        {{{"_Surface", "1"}, {"_AlphaClip", "1"}, {"_ZWrite", "0"}},
         R"("surface": "fade", "materialOverride": true)",
         "'_AlphaClip'"},
    };
    for (const Case& each : cases) {
        const MaterialFolder folder;
        ShaderGraphText source = graph();
        source.target = R"("m_AllowMaterialOverride":true)";
        folder.save("Rock.shadergraph", source.new_layout(), kGraph);
        MaterialText chosen = material();
        chosen.textures.clear();
        chosen.numbers = each.numbers;
        const Imported made = import_in(folder, chosen);
        const std::string scene = file_of(made, "x.scene.json");
        EXPECT_NE(file_of(made, "Rock.graph.json").find(R"("render": { "materialOverride": true })"),
                  std::string::npos);
        const std::string changed = remarks(made, Remark::Kind::Changed);
        EXPECT_EQ(changed.empty(), *each.changed == '\0') << changed;
        EXPECT_NE(changed.find(each.changed), std::string::npos) << changed;
        if (!each.render) {
            EXPECT_NE(scene.find(R"("graph": "Rock.graph.json")"), std::string::npos) << scene;
            continue;
        }
        EXPECT_NE(scene.find(R"("graph": "x.graph.json")"), std::string::npos) << scene;
        std::string text;  // on one line
        for (const char c : file_of(made, "x.graph.json"))
            if (c != '\n' && (c != ' ' || !text.ends_with(' '))) text += c;
        EXPECT_NE(text.find(each.render), std::string::npos) << text;
        expect_compiles(made, each.render, "x.graph.json");
    }
}

TEST(UnityMaterialOfAGraph, ABrokenGraphIsAnError) {
    const MaterialFolder folder;
    folder.save("Rock.shadergraph", "{", kGraph);
    const Imported made = import_in(folder, material());
    EXPECT_NE(made.error.find("Rock.shadergraph:1:"), std::string::npos) << made.error;
    EXPECT_TRUE(made.graphs.empty());
}

}  // namespace
}  // namespace patina::importers
