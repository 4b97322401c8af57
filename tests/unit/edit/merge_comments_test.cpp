// Whose comments a merge has, and whose text if one side changed nothing.
#include "tests/unit/edit/merge_fixture.h"

namespace patina {
namespace {

// If both changed a comment, that of OURS stays. Who loses comments of THEIRS is told.
TEST_F(Merges, CommentsOfTheirs) {
    const Lines base;
    Lines ours = base, theirs = base;
    ours.nodes = replaced(base.nodes, "// How much rust there is.", "// How rusty it is.");
    theirs.nodes = replaced(base.nodes, "// How much rust there is.", "// Rust, see the ticket.");
    theirs.surface = replaced(base.surface, "0.5", "0.7");
    Lines both = ours;
    both.surface = theirs.surface;
    const MergeResult merged = merge(base.text(), ours.text(), theirs.text());
    EXPECT_EQ(merged.state, MergeState::Clean);
    EXPECT_EQ(merged.text, both.text());
    ASSERT_EQ(merged.diagnostics.size(), 1u);
    EXPECT_EQ(merged.diagnostics[0].severity, Severity::Note);
    EXPECT_EQ(merged.diagnostics[0].file, "theirs.json");
    EXPECT_EQ(merged.diagnostics[0].line, 10);
    EXPECT_NE(merged.diagnostics[0].message.find("lacks 1 of theirs: // Rust, see the ticket."), std::string::npos)
        << merged.diagnostics[0].message;
    // Comments that both have, and those of a node that THEIRS adds, are in the merge.
    ours = theirs;
    ours.surface = base.surface;
    theirs.nodes += "    , // Dust.\n    { \"id\": \"dust\", \"expr\": \"mask * 2\" }\n";
    const MergeResult with_node = merge(base.text(), ours.text(), theirs.text());
    EXPECT_TRUE(with_node.diagnostics.empty()) << to_text(with_node.diagnostics[0]);
    EXPECT_NE(with_node.text.find("// Dust."), std::string::npos) << with_node.text;
}

TEST_F(Merges, CommentsThatOnlyTheirsChanged) {
    const Lines base;
    Lines ours = base, theirs = base, both = base;
    ours.surface = both.surface = replaced(base.surface, "0.5", "0.7");
    const auto expect_of_theirs = [&](const std::string& from, const std::string& to) {
        theirs.nodes = both.nodes = replaced(base.nodes, from, to);
        expect_clean(base.text(), ours.text(), theirs.text(), both.text());
        expect_clean(theirs.text(), both.text(), base.text(), ours.text());  // and back
    };
    expect_of_theirs("// How much rust there is.", "// Rust.\n\n    // See the ticket.");
    expect_of_theirs("4 } },", "4 } }, // soft");
    expect_of_theirs("_Amount)\" }", "_Amount)\" } // the last one");
    expect_of_theirs("    { \"id\": \"edge\"", "    /* hard */\n    { \"id\": \"edge\"");
    const std::string top = "// Rust\n// of a gate\n";
    expect_clean(base.text(), ours.text(), top + base.text(), top + ours.text());
    expect_clean(top + base.text(), top + ours.text(), base.text(), ours.text());
    // One whose place in OURS has no line of its own is told.
    theirs = base;
    theirs.surface = replaced(base.surface, "\"roughness\"", "\n// wet\n\"roughness\"");
    const MergeResult merged = merge(base.text(), ours.text(), theirs.text());
    EXPECT_EQ(merged.text, ours.text());
    ASSERT_EQ(merged.diagnostics.size(), 1u);
    EXPECT_NE(merged.diagnostics[0].message.find("lacks 1 of theirs: // wet"), std::string::npos);
}

TEST_F(Merges, OfOneSideThatChangedNothingTheOtherIsWhole) {
    const std::string base = Lines{}.text(),
                      theirs = "{\"workflow\":\"unlit\" /* a */, \"patina\":1,\r\n\"surface\":{}}";
    expect_clean(base, base, theirs, theirs);
    expect_clean(base, theirs, base, theirs);
    expect_clean(base, theirs, theirs, theirs);
    // What does not compile is said all the same.
    const std::string broken = replaced(base, "roughness\": 0.5", "roughness\": \"nothing\"");
    for (const bool swaps : {false, true}) {
        const MergeResult merged = merge(base, swaps ? broken : base, swaps ? base : broken);
        EXPECT_EQ(merged.text, broken);
        EXPECT_EQ(merged.state, MergeState::Conflicts);
    }
}

}  // namespace
}  // namespace patina
