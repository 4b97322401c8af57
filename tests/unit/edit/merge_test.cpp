// What a merge takes from each side, and what it calls a conflict. Each case is a base and what both sides wrote.
#include "tests/unit/edit/merge_fixture.h"

namespace patina {
namespace {

TEST_F(Merges, TwoValuesOfOneLine) {
    const Lines base;
    Lines ours = base, theirs = base, both = base;
    ours.nodes = replaced(base.nodes, "\"scale\": 4", "\"scale\": 8");
    theirs.nodes = replaced(base.nodes, "@uv0", "= @uv0 * 2");
    both.nodes = replaced(ours.nodes, "@uv0", "= @uv0 * 2");
    expect_clean(base.text(), ours.text(), theirs.text(), both.text());
    expect_clean(base.text(), theirs.text(), ours.text(), both.text());
}

TEST_F(Merges, NodesThatBothAddInOnePlace) {
    const Lines base;
    Lines ours = base, theirs = base, both = base;
    const std::string a = "    { \"id\": \"a\", \"expr\": \"mask * 2\" }\n";
    const std::string b = "    // b\n    { \"id\": \"b\", \"expr\": \"edge * 3\" }\n";
    const std::string with_comma = replaced(base.nodes, "$_Amount)\" }\n", "$_Amount)\" },\n");
    ours.nodes = with_comma + a;
    theirs.nodes = with_comma + b;
    both.nodes = with_comma + replaced(a, " }\n", " },\n") + b;
    expect_clean(base.text(), ours.text(), theirs.text(), both.text());
}

TEST_F(Merges, CommentsAndOrderOfOursStay) {
    const Lines base;
    Lines ours = base, theirs = base;
    ours.nodes = R"json(    // The edge comes first here.
    { "id": "edge", "expr": "saturate(mask * $_Amount)" }, // it is soft
    { "id": "mask", "node": "GradientNoise", "in": { "uv": "@uv0", "scale": 4 } }
)json";
    theirs.nodes = replaced(base.nodes, "\"scale\": 4", "\"scale\": 8");
    theirs.surface = replaced(base.surface, "0.5", "0.7");
    Lines both = ours;
    both.nodes = replaced(ours.nodes, "\"scale\": 4", "\"scale\": 8");
    both.surface = theirs.surface;
    expect_clean(base.text(), ours.text(), theirs.text(), both.text());
}

TEST_F(Merges, AKeyInFrontOfOneWithoutASpace) {
    const Lines base;
    Lines ours = base, theirs = base, both = base;
    ours.more = R"(, "budget": {"maxInstructions": 500})";
    theirs.more = R"(, "budget": {"maxTextures": 5})";
    both.more = R"(, "budget": { "maxTextures": 5, "maxInstructions": 500})";
    expect_clean(base.text(), ours.text(), theirs.text(), both.text());
}

TEST_F(Merges, AFileThatIsNotInCanonicalFormKeepsItsLayout) {
    const std::string base = R"({"patina":1,"workflow":"unlit",
     "surface":{"color":[1, 0, 0],   "alpha":0.5} })";
    expect_clean(base, replaced(base, "0.5", "0.25"), replaced(base, "[1, 0, 0]", "[0, 1, 0]"),
                 replaced(replaced(base, "0.5", "0.25"), "[1, 0, 0]", "[0, 1, 0]"));
}

TEST_F(Merges, ARenameGoesToWhatTheOtherSideWrote) {
    const Lines base;
    Lines ours = base, theirs = base;
    ours.nodes = replaced(base.nodes, "mask", "rust");
    theirs.nodes = replaced(base.nodes, "\"scale\": 4", "\"scale\": 8");
    theirs.surface += R"(, "occlusion": "= 1 - mask * 0.5")";
    Lines both = ours;
    both.nodes = replaced(ours.nodes, "\"scale\": 4", "\"scale\": 8");
    both.surface = replaced(theirs.surface, "mask", "rust");
    expect_clean(base.text(), ours.text(), theirs.text(), both.text());
    // And into the text of OURS, if THEIRS renamed.
    expect_clean(base.text(), theirs.text(), ours.text(), both.text());
}

TEST_F(Merges, ARenamedPropertyIsReadByItsNewName) {
    const Lines base;
    const std::string ours = replaced(base.text(), "_Amount", "_Rust");
    Lines theirs = base;
    theirs.surface = replaced(base.surface, "0.5", "\"$_Amount\"");
    expect_clean(base.text(), ours, theirs.text(), replaced(theirs.text(), "_Amount", "_Rust"));
    expect_clean(base.text(), theirs.text(), ours, replaced(theirs.text(), "_Amount", "_Rust"));
}

TEST_F(Merges, TheOrderOfPropertiesIsAChange) {
    const Lines base;
    Lines ours = base, theirs = base;
    theirs.properties = R"(    { "name": "_Tint", "type": "color", "default": "#c9a27e" },
    { "name": "_Amount", "type": "float", "default": 0.5 }
)";
    ours.surface = replaced(base.surface, "0.5", "0.7");
    Lines both = ours;
    both.properties = theirs.properties;
    expect_clean(base.text(), ours.text(), theirs.text(), both.text());
}

TEST_F(Merges, WaysOfWritingOneValueAreNoChange) {
    const Lines base;
    Lines ours = base, theirs = base;
    ours.nodes = replaced(base.nodes, "saturate(mask * $_Amount)", "saturate( mask*$_Amount )");
    theirs.nodes = replaced(base.nodes, "saturate(mask * $_Amount)", "saturate(mask * 2)");
    expect_clean(base.text(), ours.text(), theirs.text(), theirs.text());
}

TEST_F(Merges, ColoursAndNumbersByValue) {
    const Lines base;
    Lines ours = base, theirs = base;
    ours.properties = replaced(base.properties, "#c9a27e", "#C9A27E");
    theirs.properties = replaced(base.properties, "#c9a27e", "#ffffff");
    expect_clean(base.text(), ours.text(), theirs.text(), theirs.text());
    ours = base;
    theirs = base;
    ours.surface += R"(, "metallic": 1)";
    theirs.surface += R"(, "metallic": 1.0)";
    expect_clean(base.text(), ours.text(), theirs.text(), ours.text());
}

TEST_F(Merges, EndsOfLinesAndOfTheFileStay) {
    const Lines base;
    Lines theirs = base;
    theirs.surface = replaced(base.surface, "0.5", "0.7");
    const std::string ours = replaced(base.text(), "\n", "\r\n");
    expect_clean(base.text(), ours, theirs.text(), replaced(theirs.text(), "\n", "\r\n"));
    const auto cut = [](std::string text) { return text.substr(0, text.size() - 1); };
    expect_clean(base.text(), cut(base.text()), theirs.text(), cut(theirs.text()));
}

TEST_F(Merges, WhatEditorsKeepIsNoConflict) {
    Lines base, ours, theirs;
    base.more = ",\n  \"ui\": { \"mask\": [0, 0], \"edge\": [1, 0] }";
    ours.more = ",\n  \"ui\": { \"mask\": [5, 0], \"edge\": [1, 0] }";
    theirs.more = ",\n  \"ui\": { \"mask\": [7, 0], \"edge\": [9, 9] }";
    Lines both;
    both.more = ",\n  \"ui\": { \"mask\": [5, 0], \"edge\": [9, 9] }";
    expect_clean(base.text(), ours.text(), theirs.text(), both.text());
}

TEST_F(Merges, BothAddTheFile) {
    Lines ours, theirs;
    theirs.surface += R"(, "metallic": 1)";
    expect_clean("", ours.text(), theirs.text(), theirs.text());
    theirs.surface = replaced(theirs.surface, "0.5", "0.7");
    expect_conflict("", ours.text(), theirs.text(), {"both sides add 'surface.roughness'", "0.5", "0.7"});
}

// --- conflicts

TEST_F(Merges, BothChangeOneValue) {
    const Lines base;
    Lines ours = base, theirs = base;
    ours.nodes = replaced(base.nodes, "\"scale\": 4", "\"scale\": 8");
    theirs.nodes = replaced(base.nodes, "\"scale\": 4", "\"scale\": 2");
    theirs.surface = replaced(base.surface, "0.5", "0.7");
    const MergeResult merged =
        expect_conflict(base.text(), ours.text(), theirs.text(),
                        {"ours.json:10:", "both sides change 'nodes.mask.in.scale'", "ours: changes", "from 4 to 8",
                         "theirs.json:10:", "theirs: changes", "from 4 to 2"});
    const std::string line = R"(    { "id": "mask", "node": "GradientNoise", "in": { "uv": "@uv0", "scale": 2 } },)";
    EXPECT_EQ(merged.text,
              replaced(theirs.text(), line + "\n",
                       "<<<<<<< ours\n" + replaced(line, "2 }", "8 }") + "\n=======\n" + line + "\n>>>>>>> theirs\n"));
}

TEST_F(Merges, OneRemovesWhatTheOtherChanges) {
    const Lines base;
    Lines removed = base, changed = base;
    removed.nodes = R"json(    { "id": "edge", "expr": "saturate($_Amount)" }
)json";
    changed.nodes = replaced(base.nodes, "\"scale\": 4", "\"scale\": 8");
    expect_conflict(base.text(), removed.text(), changed.text(),
                    {"ours removes 'nodes.mask', which theirs changes", "ours: removes", "theirs: changes"});
    expect_conflict(base.text(), changed.text(), removed.text(),
                    {"theirs removes 'nodes.mask', which ours changes", "theirs: removes", "ours: changes"});
}

// One side renames the input 'k' of a sub-graph in both files, and the other one changes its value.
TEST_F(Merges, AnInputIsRenamedInAnotherFileAndChanged) {
    const auto graph = [](const std::string& node, const std::string& in) {
        return "{\n  \"patina\": 1,\n  \"workflow\": \"unlit\",\n  \"nodes\": [\n    { \"id\": \"n\", \"node\": \"" +
               node + "\", \"in\": { " + in + " } }\n  ],\n  \"surface\": { \"color\": \"n\" }\n}\n";
    };
    const auto file = [&](const std::string& in) { return graph("./gain.subgraph.json", in); };
    const std::string base = file("\"k\": 2"), changed = file("\"k\": 3"), renamed = file("\"gain\": 2");
    const MergeResult theirs = merge(base, changed, renamed), ours = merge(base, renamed, changed);
    for (const MergeResult& each : {theirs, ours}) {
        EXPECT_EQ(each.state, MergeState::Conflicts);
        ASSERT_FALSE(each.diagnostics.empty());
    }
    EXPECT_EQ(side_of(theirs.text, true), changed) << theirs.text;
    EXPECT_EQ(side_of(theirs.text, false), renamed) << theirs.text;
    EXPECT_EQ(side_of(ours.text, true), renamed) << ours.text;
    EXPECT_EQ(side_of(ours.text, false), changed) << ours.text;
    const std::string said = to_text(theirs.diagnostics.front());
    for (const char* part :
         {"theirs removes 'nodes.n.in.k', which ours changes", "from 2 to 3", "theirs: adds 'nodes.n.in.gain': 2"})
        EXPECT_NE(said.find(part), said.npos) << said;
    // What nobody changes goes along, and a node of the library has the same inputs for both sides.
    EXPECT_EQ(merge(base, file("\"k\": 2, \"more\": 1"), renamed).text, file("\"gain\": 2, \"more\": 1"));
    const auto library = [&](const std::string& in) { return graph("Remap", "\"value\": 2, " + in); };
    const MergeResult both = merge(library("\"inMax\": 2"), library("\"inMax\": 3"), library("\"outMax\": 2"));
    EXPECT_EQ(side_of(both.text, true), library("\"outMax\": 2, \"inMax\": 3"));
}

TEST_F(Merges, OneRemovesWhatTheOtherUses) {
    const Lines base;
    Lines removed = base, uses = base;
    removed.nodes = R"json(    { "id": "edge", "expr": "saturate($_Amount)" }
)json";
    uses.surface += R"(, "metallic": "mask")";
    expect_conflict(base.text(), removed.text(), uses.text(),
                    {"'mask'", "ours: removes 'nodes.mask'", "theirs: adds 'surface.metallic'"});
    expect_conflict(base.text(), uses.text(), removed.text(),
                    {"'mask'", "theirs: removes 'nodes.mask'", "ours: adds 'surface.metallic'"});
}

TEST_F(Merges, BothAddOneIdWithOtherContents) {
    const Lines base;
    Lines ours = base, theirs = base;
    ours.nodes =
        replaced(base.nodes, "$_Amount)\" }\n", "$_Amount)\" },\n    { \"id\": \"x\", \"expr\": \"mask * 2\" }\n");
    ours.surface += R"(, "metallic": "x")";
    theirs.nodes =
        replaced(base.nodes, "$_Amount)\" }\n", "$_Amount)\" },\n    { \"id\": \"x\", \"expr\": \"$_Tint.rgb\" }\n");
    theirs.surface += R"(, "emission": "x")";
    expect_conflict(base.text(), ours.text(), theirs.text(), {"both sides add 'nodes.x'", "mask * 2", "$_Tint.rgb"});
}

TEST_F(Merges, BothRenameOneNode) {
    const Lines base;
    Lines ours = base, theirs = base;
    ours.nodes = replaced(base.nodes, "mask", "rust");
    theirs.nodes = replaced(base.nodes, "mask", "dirt");
    theirs.surface += R"(, "metallic": "dirt")";
    const MergeResult merged =
        expect_conflict(base.text(), ours.text(), theirs.text(),
                        {"both sides rename 'nodes.mask'", "calls it 'rust'", "calls it 'dirt'"});
    EXPECT_NE(side_of(merged.text, true).find(R"("metallic": "rust")"), std::string::npos);
    EXPECT_EQ(side_of(merged.text, false), theirs.text());
}

TEST_F(Merges, ARenameToANameThatTheOtherSideTakes) {
    const Lines base;
    Lines ours = base, theirs = base;
    ours.nodes = replaced(base.nodes, "mask", "rust");
    theirs.nodes =
        replaced(base.nodes, "$_Amount)\" }\n", "$_Amount)\" },\n    { \"id\": \"rust\", \"expr\": \"$_Tint.r\" }\n");
    theirs.surface += R"(, "metallic": "rust")";
    expect_conflict(
        base.text(), ours.text(), theirs.text(),
        {"both sides add 'nodes.rust'", "ours: renames 'nodes.mask' to 'rust'", "theirs: adds 'nodes.rust'"});
    expect_conflict(base.text(), theirs.text(), ours.text(), {"theirs: renames 'nodes.mask' to 'rust'"});
}

TEST_F(Merges, ACycleThatBothMake) {
    const Lines base;
    Lines ours = base, theirs = base;
    ours.nodes = replaced(base.nodes, "\"scale\": 4", "\"scale\": \"= 4 + other\"");
    const std::string other = "    { \"id\": \"other\", \"expr\": \"$_Amount * 2\" }\n";
    Lines with_other = base;
    with_other.nodes = replaced(base.nodes, "$_Amount)\" }\n", "$_Amount)\" },\n" + other);
    ours.nodes = replaced(ours.nodes, "$_Amount)\" }\n", "$_Amount)\" },\n" + other);
    theirs.nodes = replaced(with_other.nodes, "$_Amount * 2", "mask * 2");
    expect_conflict(with_other.text(), ours.text(), theirs.text(),
                    {"cycle", "ours: changes 'nodes.mask.in.scale'", "theirs: changes 'nodes.other.expr'"});
}

TEST_F(Merges, ATypeThatTheOtherSideReliesOn) {
    const Lines base;
    Lines ours = base, theirs = base;
    ours.properties = replaced(base.properties, R"("type": "float", "default": 0.5)",
                               R"("type": "float3", "default": [0.5, 0.5, 0.5])");
    ours.nodes = replaced(base.nodes, "$_Amount", "$_Amount.x");
    theirs.surface = replaced(base.surface, "0.5", "\"$_Amount\"");
    expect_conflict(base.text(), ours.text(), theirs.text(),
                    {"float3", "ours: changes 'properties._Amount", "theirs: changes 'surface.roughness'"});
}

TEST_F(Merges, AnotherNodeWithOtherPorts) {
    const Lines base;
    Lines ours = base, theirs = base;
    ours.nodes =
        replaced(base.nodes, R"("node": "GradientNoise", "in": { "uv": "@uv0", "scale": 4 })", R"("expr": "@uv0.x")");
    theirs.nodes = replaced(base.nodes, "\"scale\": 4", "\"scale\": 8");
    expect_conflict(base.text(), ours.text(), theirs.text(), {"ours removes 'nodes.mask.in', which theirs changes"});
}

TEST_F(Merges, TheSidesOfANodeThatBecameAnotherOneAreWhole) {
    Lines base;
    const std::string lone = "    { \"id\": \"lone\", \"expr\": \"$_Tint.r\" },\n";
    const std::string mask = R"("node": "GradientNoise", "in": { "uv": "@uv0", "scale": 4 })";
    Lines ours = base, theirs = base;
    base.nodes = lone + base.nodes;
    ours.nodes = replaced(base.nodes, mask, R"("expr": "lone * 2")");
    const MergeResult merged =
        expect_conflict(base.text(), ours.text(), theirs.text(),
                        {"'lone'", "theirs: removes 'nodes.lone'", "ours: adds 'nodes.mask.expr'"});
    EXPECT_EQ(side_of(merged.text, true), ours.text());
    EXPECT_NE(side_of(merged.text, false).find(mask), std::string::npos) << merged.text;
}

TEST_F(Merges, BothPutPropertiesIntoAnotherOrder) {
    Lines base;
    const std::string a = R"(    { "name": "_A", "type": "float" })", b = R"(    { "name": "_B", "type": "float" })",
                      c = R"(    { "name": "_C", "type": "float" })", d = R"(    { "name": "_Amount", "type": "float" },
    { "name": "_Tint", "type": "color" })";
    const auto with = [&](const std::string& x, const std::string& y, const std::string& z) {
        Lines lines;
        lines.properties = x + ",\n" + y + ",\n" + z + ",\n" + d + "\n";
        return lines.text();
    };
    const MergeResult merged = expect_conflict(with(a, b, c), with(b, a, c), with(c, b, a),
                                               {"both sides put 'properties' into another order"});
    EXPECT_EQ(side_of(merged.text, true), with(b, a, c));
    EXPECT_EQ(side_of(merged.text, false), with(c, b, a));
    expect_clean(with(a, b, c), with(c, a, b), with(c, a, b), with(c, a, b));
}

TEST_F(Merges, ASideThatDoesNotCompileIsMergedAndLeftToRepair) {
    const Lines base;
    Lines ours = base, theirs = base;
    ours.surface += R"(, "metallic": "nothing")";
    theirs.surface = replaced(base.surface, "0.5", "0.7");
    const MergeResult merged = merge(base.text(), ours.text(), theirs.text());
    EXPECT_EQ(merged.state, MergeState::Conflicts);
    EXPECT_EQ(merged.text, replaced(ours.text(), "0.5,", "0.7,"));
    ASSERT_EQ(merged.diagnostics.size(), 1u);
    EXPECT_EQ(merged.diagnostics[0].code, "dangling-link");
}

TEST_F(Merges, AFileThatIsNotThereYetIsAWarning) {
    const Lines base;
    Lines ours = base, theirs = base;
    ours.surface = replaced(base.surface, "0.5", "0.7");
    theirs.nodes = replaced(base.nodes, "$_Amount)\" }\n",
                            "$_Amount)\" },\n    { \"id\": \"s\", \"node\": \"./new.subgraph.json\" }\n");
    const MergeResult merged = merge(base.text(), ours.text(), theirs.text());
    EXPECT_EQ(merged.state, MergeState::Clean);
    ASSERT_FALSE(merged.diagnostics.empty());
    EXPECT_EQ(merged.diagnostics[0].code, "missing-file");
    EXPECT_EQ(merged.diagnostics[0].severity, Severity::Warning);
}

TEST_F(Merges, ALightingGraphThatIsNotThereYetIsAWarning) {
    const Lines base;
    Lines ours = base, theirs = base;
    ours.surface = replaced(base.surface, "0.5", "0.7");
    theirs.more = ",\n  \"lighting\": \"./new.lighting.json\"";
    const MergeResult merged = merge(base.text(), ours.text(), theirs.text());
    EXPECT_EQ(merged.state, MergeState::Clean);
    ASSERT_FALSE(merged.diagnostics.empty());
    EXPECT_EQ(merged.diagnostics[0].severity, Severity::Warning);
}

TEST_F(Merges, WhatIsNoGraphIsNotTouched) {
    const Lines base;
    for (const std::string bad : {"", "{", "[]", "{ \"patina\": 1, \"kind\": \"engine\" }", "{ \"patina\": 2 }"}) {
        const MergeResult theirs = merge(base.text(), base.text(), bad);
        EXPECT_EQ(theirs.state, MergeState::Unreadable) << bad;
        EXPECT_EQ(theirs.text, base.text());
        ASSERT_FALSE(theirs.diagnostics.empty());
        EXPECT_EQ(theirs.diagnostics[0].file, "theirs.json");
        EXPECT_EQ(merge(base.text(), bad, base.text()).text, bad);
        if (!bad.empty()) {
            EXPECT_EQ(merge(bad, base.text(), base.text()).state, MergeState::Unreadable) << bad;
        }
    }
}

// --- other kinds of files

TEST_F(Merges, ScenesByTheirObjects) {
    const std::string base = R"({
  "patina": 1,
  "kind": "scene",
  "camera": { "position": [0, 1, 5] },
  "lights": [
    { "type": "directional", "direction": [0, 1, 0] },
    { "type": "point", "position": [1, 1, 1], "intensity": 2 }
  ],
  "materials": [
    { "name": "red", "graph": "red.graph.json" }
  ],
  "objects": [
    { "id": "ball", "mesh": "sphere", "material": "red" }
  ]
}
)";
    const std::string ours = replaced(base, R"("intensity": 2)", R"("intensity": 3)");
    const std::string theirs =
        replaced(replaced(base, "[0, 1, 0]", "[1, 1, 0]"), R"("mesh": "sphere")", R"("mesh": "torus")");
    expect_clean(base, ours, theirs, replaced(theirs, R"("intensity": 2)", R"("intensity": 3)"));
    // An object with a material that the other side removes.
    const std::string without = replaced(replaced(base, "    { \"name\": \"red\", \"graph\": \"red.graph.json\" }\n",
                                                  "    { \"name\": \"blue\", \"graph\": \"blue.graph.json\" }\n"),
                                         "\"material\": \"red\"", "\"material\": \"blue\"");
    const std::string uses =
        replaced(base, "\"material\": \"red\" }\n",
                 "\"material\": \"red\" },\n    { \"id\": \"ring\", \"mesh\": \"torus\", \"material\": \"red\" }\n");
    const MergeResult merged = merge(base, without, uses);
    EXPECT_EQ(merged.state, MergeState::Conflicts);
    ASSERT_FALSE(merged.diagnostics.empty());
    const std::string said = to_text(merged.diagnostics[0]);
    EXPECT_NE(said.find("objects.ring"), said.npos) << said;
    EXPECT_NE(said.find("materials.red"), said.npos) << said;
}

TEST_F(Merges, SubgraphsAndLightingGraphs) {
    const std::string sub = R"({
  "patina": 1,
  "kind": "subgraph",
  "inputs": [
    { "name": "height", "type": "float", "default": 0.5 },
    { "name": "level", "type": "float", "default": 0.5 }
  ],
  "outputs": { "amount": "= $height * $level" }
}
)";
    expect_clean(sub, replaced(sub, "level", "rust"), replaced(sub, "$height * $level", "$height + $level"),
                 replaced(replaced(sub, "$height * $level", "$height + $level"), "level", "rust"));
    const std::string lighting = R"({
  "patina": 1,
  "kind": "lighting",
  "surface": [
    { "name": "rim", "type": "float", "default": 0.3 }
  ],
  "nodes": [
    { "id": "ndotl", "node": "NdotL" }
  ],
  "direct": "= ndotl * @light.radiance * @surface.rim"
}
)";
    expect_clean(lighting, replaced(lighting, "0.3", "0.4"), replaced(lighting, "@light.radiance", "@light.color"),
                 replaced(replaced(lighting, "0.3", "0.4"), "@light.radiance", "@light.color"));
}

// What the other side adds reads the input by its new name, whichever side renamed it.
TEST_F(Merges, ARenamedInputOfASubgraph) {
    const std::string base = R"({
  "patina": 1,
  "kind": "subgraph",
  "inputs": [
    { "name": "level", "type": "float", "default": 0.5 },
    { "name": "other", "type": "float", "default": 0.5 }
  ],
  "nodes": [
    { "id": "half", "expr": "$level * 0.5" }
  ],
  "outputs": { "amount": "half" }
}
)";
    const std::string renamed = replaced(base, "level", "rust");
    const std::string more = replaced(base, R"("half" })", R"("half", "raw": "$level" })");
    ASSERT_NE(more, base);
    expect_clean(base, renamed, more, replaced(more, "level", "rust"));
    expect_clean(base, more, renamed, replaced(more, "level", "rust"));
}

TEST_F(Merges, ARenamedInputOfALightingGraph) {
    const std::string base = R"json({
  "patina": 1,
  "kind": "lighting",
  "surface": [
    { "name": "rim", "type": "float3", "default": 0.3 },
    { "name": "wrap", "type": "float", "default": 0.3 }
  ],
  "nodes": [
    { "id": "ndotl", "node": "NdotL" },
    { "id": "wrapped", "expr": "saturate(ndotl + @surface.wrap)" }
  ],
  "direct": "= wrapped * @light.radiance * @surface.rim.g"
}
)json";
    const auto with_name = [](const std::string& text, const std::string& name) {
        return replaced(replaced(text, "\"rim\"", "\"" + name + "\""), "@surface.rim", "@surface." + name);
    };
    const std::string renamed = with_name(base, "edge");
    const std::string more =
        replaced(base, "rim.g\"\n", "rim.g\",\n  \"indirect\": \"= @surface.diffuseColor * @surface.rim\"\n");
    ASSERT_NE(more, base);
    expect_clean(base, renamed, more, with_name(more, "edge"));
    expect_clean(base, more, renamed, with_name(more, "edge"));

    const MergeResult twice = merge(base, renamed, with_name(base, "border"));
    EXPECT_EQ(twice.state, MergeState::Conflicts);
    ASSERT_FALSE(twice.diagnostics.empty());
    EXPECT_EQ(twice.diagnostics.front().message, "both sides rename 'surface.rim'");
}

// A node and a property may have the name of an input: each is read in its own way.
TEST_F(Merges, OnlyWhatReadsTheInputIsRenamed) {
    const std::string base = R"json({
  "patina": 1,
  "kind": "lighting",
  "properties": [
    { "name": "rim", "type": "float", "default": 1 }
  ],
  "surface": [
    { "name": "rim", "type": "float", "default": 0.3 }
  ],
  "nodes": [
    { "id": "rim", "expr": "@surface.rim * $rim" }
  ],
  "direct": "= rim * @light.radiance"
}
)json";
    const auto renamed = [](const std::string& text) {
        return replaced(
            replaced(text, R"("rim", "type": "float", "default": 0.3)", R"("edge", "type": "float", "default": 0.3)"),
            "@surface.rim", "@surface.edge");
    };
    const std::string more = replaced(base, "radiance\"", "radiance * @surface.rim * $rim\"");
    ASSERT_NE(more, base);
    expect_clean(base, renamed(base), more, renamed(more));
    expect_clean(base, more, renamed(base), renamed(more));
}

}  // namespace
}  // namespace patina
