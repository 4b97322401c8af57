// Merges of graphs in which one side gave a name to another thing.
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
