// What changed in meaning between two texts, and what is no change.
#include <gtest/gtest.h>

#include "patina/graph_diff.h"

namespace patina {
namespace {

constexpr const char* kBase = R"json({
  "patina": 1,
  "workflow": "metallic-roughness",
  "properties": [
    { "name": "_Amount", "type": "float", "default": 0.5 },
    { "name": "_Tint", "type": "color", "default": "#c9a27e" }
  ],
  "nodes": [
    { "id": "mask", "node": "GradientNoise", "in": { "uv": "@uv0", "scale": 4 } },
    { "id": "edge", "expr": "saturate(mask * $_Amount)" }
  ],
  "surface": { "baseColor": "#fc8", "roughness": "edge" }
}
)json";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    EXPECT_NE(text.find(from), text.npos) << from;
    for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

// "~ surface.roughness: 0.5 -> 0.7", a line for each change.
std::string changes(const std::string& before, const std::string& after) {
    const GraphDiff diff = diff_graphs({"old.json", before}, {"new.json", after});
    for (const Diagnostic& each : diff.diagnostics) ADD_FAILURE() << to_text(each);
    EXPECT_TRUE(diff.ok);
    std::string text;
    for (const GraphChange& change : diff.changes) {
        text += "+-~>o"[static_cast<int>(change.kind)];
        for (std::size_t i = 0; i < change.path.size(); ++i) text += (i > 0 ? "." : " ") + change.path[i];
        text += ": " + change.before + " -> " + change.after + "\n";
    }
    return text;
}

TEST(Diff, WhatIsNoChange) {
    EXPECT_EQ(changes(kBase, kBase), "");
    EXPECT_EQ(changes(kBase, replaced(kBase, "\n", " ")), "");
    EXPECT_EQ(changes(kBase, replaced(kBase, "\"nodes\": [", "// a comment\n\"nodes\": [ /* another */")), "");
    EXPECT_EQ(changes(kBase, replaced(kBase, "#fc8", "#ffcc88")), "");
    EXPECT_EQ(changes(kBase, replaced(kBase, "\"edge\" }", "\"= edge\" }")), "");
    EXPECT_EQ(changes(kBase, replaced(kBase, "mask * $_Amount", "mask*$_Amount")), "");
    EXPECT_EQ(changes(kBase, replaced(kBase, "0.5", "5e-1")), "");
    EXPECT_EQ(changes(kBase, replaced(kBase, "\"patina\": 1,", "\"patina\": 1, \"ui\": { \"mask\": [1, 2] },")), "");
    EXPECT_EQ(changes(kBase, replaced(kBase, R"("uv": "@uv0", "scale": 4)", R"("scale": 4, "uv": "@uv0")")), "");
    const std::string mask = R"(    { "id": "mask", "node": "GradientNoise", "in": { "uv": "@uv0", "scale": 4 } },)";
    std::string moved = replaced(kBase, mask + "\n", "");
    moved = replaced(moved, "  ],\n  \"surface\"", mask.substr(0, mask.size() - 1) + "\n  ],\n  \"surface\"");
    moved = replaced(moved, "$_Amount)\" }", "$_Amount)\" },");
    EXPECT_EQ(changes(kBase, moved), "");
}

TEST(Diff, ColoursByValue) {
    EXPECT_EQ(changes(kBase, replaced(kBase, "#c9a27e", "#C9A27E")), "");
    EXPECT_EQ(changes(replaced(kBase, "#c9a27e", "#fff"), replaced(kBase, "#c9a27e", "#FFFFFFff")), "");
    EXPECT_EQ(changes(kBase, replaced(kBase, "#c9a27e", "#c9a27f")),
              "~ properties._Tint.default: \"#c9a27e\" -> \"#c9a27f\"\n");
    // What is no colour is a text.
    const std::string label = replaced(kBase, "#c9a27e\"", "#c9a27e\", \"label\": \"#abc\"");
    EXPECT_EQ(changes(label, replaced(label, "#abc", "#ABC")), "~ properties._Tint.label: \"#abc\" -> \"#ABC\"\n");
    const std::string gradient = replaced(kBase, R"("type": "color", "default": "#c9a27e")",
                                          R"("type": "gradient", "default": { "colors": [[0, "#abc"], [1, "#fff"]] })");
    const std::string upper = replaced(gradient, "#abc", "#AABBCC");
    EXPECT_EQ(changes(gradient, upper), "");
    const std::string scene = R"({ "patina": 1, "kind": "scene", "camera": { "position": [0, 1, 5] },
  "lights": [ { "type": "directional", "direction": [0, 1, 0], "color": "#abc" } ], "objects": [] })";
    EXPECT_EQ(changes(scene, replaced(scene, "#abc", "#AABBCC")), "");
}

// 1 is an integer and 1.0 a float, which matters to what computes with both.
TEST(Diff, IntegersAreOtherValuesWhereTheirTypeCounts) {
    EXPECT_EQ(changes(kBase, replaced(kBase, "\"scale\": 4", "\"scale\": 4.0")), "~ nodes.mask.in.scale: 4 -> 4.0\n");
    const std::string bare = replaced(kBase, "\"edge\" }", "1 }");
    EXPECT_EQ(changes(bare, replaced(bare, "1 }", "1.0 }")), "");
    EXPECT_EQ(changes(bare, replaced(bare, "1 }", "\"= 1.0\" }")), "");
    EXPECT_EQ(changes(bare, replaced(bare, "1 }", "2.0 }")), "~ surface.roughness: 1 -> 2.0\n");
    const std::string list = replaced(kBase, "\"@uv0\"", "[1, 2]");
    EXPECT_EQ(changes(list, replaced(list, "[1, 2]", "[1.0, 2]")), "");
    const std::string halves = replaced(kBase, "mask * $_Amount", "mask * 0.25");
    EXPECT_EQ(changes(halves, replaced(halves, "0.25", "2.5e-1")), "");
    const std::string one = replaced(kBase, "\"default\": 0.5", "\"default\": 1");
    EXPECT_EQ(changes(one, replaced(one, "\"default\": 1 ", "\"default\": 1.0 ")), "");
}

TEST(Diff, ValuesLinksAndTypes) {
    EXPECT_EQ(changes(kBase, replaced(kBase, "\"scale\": 4", "\"scale\": 8")), "~ nodes.mask.in.scale: 4 -> 8\n");
    EXPECT_EQ(changes(kBase, replaced(kBase, "\"edge\" }", "\"mask\" }")),
              "~ surface.roughness: \"edge\" -> \"mask\"\n");
    EXPECT_EQ(changes(kBase, replaced(kBase, ", \"scale\": 4", "")), "- nodes.mask.in.scale: 4 -> \n");
    EXPECT_EQ(changes(kBase, replaced(kBase, "GradientNoise", "FractalNoise")),
              "~ nodes.mask.node: \"GradientNoise\" -> \"FractalNoise\"\n");
    EXPECT_EQ(changes(kBase, replaced(kBase, "mask * $_Amount", "mask + $_Amount")),
              "~ nodes.edge.expr: \"saturate(mask * $_Amount)\" -> \"saturate(mask + $_Amount)\"\n");
    EXPECT_EQ(changes(kBase, replaced(kBase, "metallic-roughness", "specular-glossiness")),
              "~ workflow: \"metallic-roughness\" -> \"specular-glossiness\"\n");
    EXPECT_EQ(changes(kBase, replaced(kBase, "0.5 }", "0.5, \"range\": [0, 1] }")),
              "+ properties._Amount.range:  -> [0, 1]\n");
}

TEST(Diff, ARenameIsOneChange) {
    EXPECT_EQ(changes(kBase, replaced(kBase, "mask", "rust")), "> nodes.rust: mask -> rust\n");
    EXPECT_EQ(changes(kBase, replaced(kBase, "_Amount", "_Rust")), "> properties._Rust: _Amount -> _Rust\n");
    EXPECT_EQ(changes(kBase, replaced(replaced(kBase, "mask", "rust"), "edge", "rim")),
              "> nodes.rust: mask -> rust\n> nodes.rim: edge -> rim\n");
    // What else changed has the new name.
    EXPECT_EQ(changes(kBase, replaced(replaced(kBase, "mask", "rust"), "\"edge\" }", "\"rust\" }")),
              "> nodes.rust: mask -> rust\n~ surface.roughness: \"edge\" -> \"rust\"\n");
    // Another property with the same declaration is another property.
    const std::string other = replaced(replaced(kBase, "_Amount\"", "_Other\""), "mask * $_Amount", "mask");
    EXPECT_EQ(changes(kBase, other).find('>' + std::string(" properties")), std::string::npos);
}

// The surface of a material has no names, as that of a lighting graph has: other values are no renames.
TEST(Diff, SurfacesWithOtherValues) {
    EXPECT_EQ(changes(kBase, replaced(kBase, R"("roughness": "edge")", R"("metallic": "edge", "occlusion": "edge")")),
              "- surface.roughness: \"edge\" -> \n+ surface.metallic:  -> \"edge\"\n"
              "+ surface.occlusion:  -> \"edge\"\n");
    // Names vanish and come in the graph's other lists.
    const std::string other = R"json({ "patina": 1, "workflow": "unlit",
  "properties": [ { "name": "_Power", "type": "float", "default": 2 } ],
  "nodes": [ { "id": "glow", "expr": "pow(@uv0.x, $_Power)" } ],
  "surface": { "color": "= float3(glow)", "alpha": 1 } })json";
    const std::string there = changes(kBase, other), back = changes(other, kBase);
    for (const char* part : {"- nodes.mask:", "+ nodes.glow:", "- surface.baseColor:", "+ surface.color:"})
        EXPECT_NE(there.find(part), std::string::npos) << there;
    for (const char* part : {"+ nodes.mask:", "- nodes.glow:", "+ surface.baseColor:", "- surface.color:"})
        EXPECT_NE(back.find(part), std::string::npos) << back;
    EXPECT_EQ(("\n" + there).find("\n>"), std::string::npos) << there;
}

TEST(Diff, TheOrderOfPropertiesIsAChange) {
    const std::string a = R"(    { "name": "_Amount", "type": "float", "default": 0.5 })",
                      b = R"(    { "name": "_Tint", "type": "color", "default": "#c9a27e" })";
    EXPECT_EQ(changes(kBase, replaced(kBase, a + ",\n" + b, b + ",\n" + a)),
              "o properties: [\"_Amount\", \"_Tint\"] -> [\"_Tint\", \"_Amount\"]\n");
}

TEST(Diff, PlacesAreThoseOfTheFiles) {
    const GraphDiff diff = diff_graphs({"old.json", kBase}, {"new.json", replaced(kBase, "mask", "a_longer_name")});
    ASSERT_EQ(diff.changes.size(), 1u);
    EXPECT_EQ(diff.changes[0].before_location.file, "old.json");
    EXPECT_EQ(diff.changes[0].before_location.line, 9);
    EXPECT_EQ(diff.changes[0].after_location.file, "new.json");
    EXPECT_EQ(diff.changes[0].after_location.line, 9);
}

TEST(Diff, AFileThatIsNewOrGone) {
    EXPECT_TRUE(changes("", kBase).starts_with("+ patina:  -> 1\n+ workflow:"));
    EXPECT_TRUE(changes(kBase, "").starts_with("- patina: 1 -> \n"));
    EXPECT_EQ(changes("", ""), "");
}

TEST(Diff, ScenesByTheirObjects) {
    const std::string base = R"({ "patina": 1, "kind": "scene", "camera": { "position": [0, 1, 5] },
  "lights": [ { "type": "directional", "direction": [0, 1, 0] } ],
  "materials": [ { "name": "red", "graph": "red.graph.json" } ],
  "objects": [ { "id": "ball", "mesh": "sphere", "material": "red" } ] })";
    EXPECT_EQ(changes(base, replaced(base, "\"sphere\"", "\"torus\"")),
              "~ objects.ball.mesh: \"sphere\" -> \"torus\"\n");
    // A light in front of another one leaves that one as it is.
    EXPECT_EQ(
        changes(base, replaced(base, "[ { \"type\": \"directional\"",
                               "[ { \"type\": \"point\", \"position\": [1, 1, 1] }, { \"type\": \"directional\"")),
        "+ lights.0:  -> { \"type\": \"point\", \"position\": [1, 1, 1] }\n");
}

TEST(Diff, ALightBehindAnotherOneIsAdded) {
    const std::string base = R"({ "patina": 1, "kind": "scene", "camera": { "position": [0, 1, 5] },
  "lights": [ { "type": "directional", "direction": [0, 1, 0] } ],
  "objects": [] })";
    const std::string point = R"({ "type": "point", "position": [1, 1, 1] })";
    EXPECT_EQ(changes(base, replaced(base, "[0, 1, 0] } ]", "[0, 1, 0] }, " + point + " ]")),
              "+ lights.1:  -> " + point + "\n");
}

TEST(Diff, WhatIsNoGraphSaysSo) {
    for (const std::string bad : {"{", "[]", "{ \"patina\": 2 }"}) {
        const GraphDiff diff = diff_graphs({"old.json", kBase}, {"new.json", bad});
        EXPECT_FALSE(diff.ok);
        ASSERT_FALSE(diff.diagnostics.empty());
        EXPECT_EQ(diff.diagnostics[0].file, "new.json");
    }
}

}  // namespace
}  // namespace patina
