// Merges of graphs in which one side gave a name to another thing.
#include "patina/graph_diff.h"
#include "tests/unit/edit/merge_fixture.h"

namespace patina {
namespace {

// Two nodes and two properties of one kind.
struct Pairs {
    std::string a = "a", b = "b", p = "_P", q = "_Q", roughness = "0.5";

    std::string text() const {
        std::string text = R"json({ "patina": 1, "workflow": "metallic-roughness",
  "properties": [
    { "name": "<p>", "type": "float", "default": 0.25 },
    { "name": "<q>", "type": "float", "default": 0.75 }
  ],
  "nodes": [
    { "id": "<a>", "node": "GradientNoise", "in": { "scale": 4 } },
    { "id": "<b>", "node": "FractalNoise", "in": { "scale": 9 } }
  ],
  "surface": {
    "baseColor": "= float3(<a>, <b>, 0)",
    "emission": "= float3($<p>, $<q>, 0)",
    "roughness": <roughness>
  }
}
)json";
        text = replaced(replaced(replaced(replaced(text, "<a>", a), "<b>", b), "<p>", p), "<q>", q);
        return replaced(text, "<roughness>", roughness);
    }
};

void expect_conflict_both_ways(const Pairs& one, const Pairs& other, const std::string& name) {
    static const Compiler compiler;
    for (const bool swaps : {false, true}) {
        const std::string ours = swaps ? other.text() : one.text(), theirs = swaps ? one.text() : other.text();
        const MergeResult merged = merge_graphs(compiler, {"base.json", Pairs{}.text()}, {"ours.json", ours},
                                                {"theirs.json", theirs}, {.path = "merged.graph.json"});
        EXPECT_EQ(merged.state, MergeState::Conflicts) << merged.text;
        std::string said;
        for (const Diagnostic& each : merged.diagnostics) said += to_text(each) + "\n";
        const char* parts[] = {"' names another thing in ", "note: ours: ", "note: theirs: ", name.c_str()};
        for (const char* part : parts) EXPECT_NE(said.find(part), said.npos) << part << "\nin\n" << said;
    }
}

TEST_F(Merges, ANameThatIsUsedAgainIsNoRename) {
    Pairs reads, takes;
    reads.a = "m", reads.roughness = R"("m")";
    takes.a = "n", takes.b = "a";
    expect_conflict_both_ways(reads, takes, "renames 'nodes.a' to 'm'");
    Pairs reads_property, takes_property;
    reads_property.p = "_M", reads_property.roughness = R"("$_M")";
    takes_property.p = "_N", takes_property.q = "_P";
    expect_conflict_both_ways(reads_property, takes_property, "renames 'properties._Q' to '_P'");
    // Both rename the node whose name another one gets.
    reads.roughness = "0.5";
    expect_conflict_both_ways(reads, takes, "renames 'nodes.b' to 'a'");
}

TEST_F(Merges, ANewReaderOfANameThatIsUsedAgain) {
    Pairs reads, moves;
    reads.roughness = R"("b")";
    moves.a = "b", moves.b = "c";
    expect_conflict_both_ways(reads, moves, "renames 'nodes.a' to 'b'");
    moves.b = "a";
    expect_conflict_both_ways(reads, moves, "renames 'nodes.b' to 'a'");
    reads.roughness = R"("$_Q")";
    Pairs properties;
    properties.p = "_Q", properties.q = "_R";
    expect_conflict_both_ways(reads, properties, "renames 'properties._P' to '_Q'");
    properties.q = "_P";
    expect_conflict_both_ways(reads, properties, "renames 'properties._Q' to '_P'");
}

// Who swaps two properties that are declared alike leaves a trace only where they are read.
TEST_F(Merges, SwappedPropertiesThatAreDeclaredAlike) {
    const auto alike = [](const Pairs& pairs) { return replaced(pairs.text(), "0.75", "0.25"); };
    Pairs reads, swaps;
    reads.roughness = R"("$_Q")";
    swaps.p = "_Q", swaps.q = "_P";
    expect_conflict(alike({}), alike(reads), alike(swaps),
                    {"'properties._Q' names another thing in theirs", "ours: changes 'surface.roughness'",
                     "theirs: changes 'surface.emission'"});
    swaps.q = "_R";
    expect_conflict(alike({}), alike(reads), alike(swaps), {"'properties._Q' names another thing in theirs"});
}

TEST_F(Merges, WhatDoesNotTouchASwapIsClean) {
    Pairs swaps;
    swaps.a = "b", swaps.b = "a", swaps.p = "_Q", swaps.q = "_P";
    Pairs rough;
    rough.roughness = "0.7";
    Pairs both = swaps;
    both.roughness = "0.7";
    expect_clean(Pairs{}.text(), swaps.text(), rough.text(), both.text());
    expect_clean(Pairs{}.text(), swaps.text(), both.text(), both.text());
    EXPECT_EQ(merge(Pairs{}.text(), rough.text(), swaps.text()).state, MergeState::Clean);
}

// --- readers of a name belong to its conflict

constexpr const char* kNames = R"json({ "patina": 1, "workflow": "metallic-roughness",
  "properties": [
    { "name": "_Amount", "type": "float", "default": 0.5 }
  ],
  "nodes": [
    // base noise
    { "id": "noise", "node": "FractalNoise", "in": { "scale": 12 } },
    { "id": "mask", "expr": "saturate(noise * $_Amount)" },
    { "id": "wear", "node": "Lerp", "in": { "from": 0.1, "to": 0.9, "t": "mask" } }
  ],
  "surface": {
    "baseColor": "= float3(mask)",
    "roughness": "wear",
    "metallic": 0
  }
}
)json";

std::string with_line(const std::string& text, const std::string& before, const std::string& line) {
    return replaced(text, before, line + before);
}

// Who takes one side of each conflict gets a graph that means what that side means, and sees each comment once.
void expect_whole_sides(const std::string& base, const std::string& one, const std::string& other,
                        const std::string& message) {
    static const Compiler compiler;
    for (const bool swaps : {false, true}) {
        const std::string &ours = swaps ? other : one, &theirs = swaps ? one : other;
        const MergeResult merged = merge_graphs(compiler, {"base.json", base}, {"ours.json", ours},
                                                {"theirs.json", theirs}, {.path = "merged.graph.json"});
        EXPECT_EQ(merged.state, MergeState::Conflicts) << merged.text;
        std::string said;
        for (const Diagnostic& each : merged.diagnostics) said += to_text(each) + "\n";
        EXPECT_NE(said.find(message), said.npos) << message << "\nin\n" << said;
        for (const bool is_ours : {true, false}) {
            const std::string taken = Merges::side_of(merged.text, is_ours);
            const GraphDiff diff = diff_graphs({"side.json", is_ours ? ours : theirs}, {"taken.json", taken});
            EXPECT_TRUE(diff.ok && diff.changes.empty()) << "side of " << (is_ours ? "ours" : "theirs") << " of\n"
                                                         << merged.text;
            const std::size_t comment = taken.find("// base noise");
            EXPECT_EQ(comment, taken.rfind("// base noise")) << taken;
        }
    }
}

TEST_F(Merges, TheReadersOfANameThatBothSidesTake) {
    const std::string base = kNames;
    // One side renames a node, and the other one adds a node of this name.
    const std::string renames = replaced(base, "noise\"", "grain\""),
                      renames_reader = replaced(renames, "saturate(noise", "saturate(grain");
    const std::string grain = "    { \"id\": \"grain\", \"node\": \"GradientNoise\", \"in\": { \"scale\": 3 } },\n";
    const std::string adds = with_line(base, "    { \"id\": \"wear\"", grain);
    const std::string reads = replaced(adds, "\"metallic\": 0", "\"metallic\": \"grain\"");
    expect_whole_sides(base, renames_reader, reads, "both sides add 'nodes.grain'");
    // It also reads the old name in one more place.
    expect_whole_sides(base, renames_reader, replaced(reads, "\"to\": 0.9", "\"to\": \"noise\""),
                       "both sides add 'nodes.grain'");
    // Both add a node.
    const std::string other =
        replaced(replaced(replaced(adds, "GradientNoise", "Voronoi"), "0.1", "\"= grain\""), "// base noise", "// X");
    expect_whole_sides(base, replaced(other, "// X", "// base noise"), reads, "both sides add 'nodes.grain'");
    // Both rename the node, and one of them adds a node with the other one's name.
    const std::string dirt =
        replaced(with_line(renames_reader, "    { \"id\": \"wear\"", replaced(grain, "grain", "dirt")),
                 "\"metallic\": 0", "\"metallic\": \"dirt\"");
    const std::string renames_to_dirt = replaced(renames_reader, "grain", "dirt");
    expect_whole_sides(base, dirt, renames_to_dirt, "both sides add 'nodes.dirt'");
}

TEST_F(Merges, TheReadersOfANameThatOneSideRemoves) {
    const std::string base = kNames;
    const std::string removes = replaced(
        replaced(base, "    { \"id\": \"mask\", \"expr\": \"saturate(noise * $_Amount)\" },\n", ""), "mask", "noise");
    expect_whole_sides(base, replaced(base, "mask", "cover"), removes, "renames 'nodes.mask', which");
    expect_whole_sides(base, replaced(base, "saturate(", "sqrt("), removes, "removes 'nodes.mask', which");
    // It is renamed and changed, which is a removal.
    const std::string renames =
        replaced(replaced(replaced(base, "noise\"", "grain\""), "(noise", "(grain"), "12", "14");
    expect_whole_sides(base, renames, replaced(base, "12", "13"), "removes 'nodes.noise', which");
}

// Other values are no other things: what reads them stays as it is.

TEST_F(Merges, ReadersOfNodesWhoseValuesOrKindsChange) {
    const std::string base = Pairs{}.text(),
                      nodes[] = {
                          replaced(base, "4 }", "9 }"), replaced(base, "FractalNoise", "GradientNoise"),
                          replaced(replaced(replaced(base, "GradientNoise", "X"), "FractalNoise", "GradientNoise"), "X",
                                   "FractalNoise"),
                          replaced(replaced(replaced(base, "0.25", "X"), "0.75", "0.25"), "X", "0.75")};
    for (const std::string& changed : nodes) {
        for (const std::string read : {"\"a\"", "\"b\"", "\"$_P\""}) {
            Pairs reads;
            reads.roughness = read;
            expect_clean(base, changed, reads.text(), replaced(changed, "0.5", read));
            expect_clean(base, reads.text(), changed, replaced(changed, "0.5", read));
        }
    }
}

}  // namespace
}  // namespace patina
