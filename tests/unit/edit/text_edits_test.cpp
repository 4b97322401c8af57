// Edits change what they should and leave all other text as it was.
#include "compiler/edit/text_edits.h"

#include <gtest/gtest.h>

#include "compiler/json/json.h"

namespace patina::edit {

using namespace json;
namespace {

struct Parsed {
    explicit Parsed(std::string text) : base(sources.add("a.json", std::move(text))) {
        json = parse_json(sources, base, diagnostics);
    }
    SourceMap sources;
    Diagnostics diagnostics;
    std::uint32_t base;
    std::unique_ptr<Json> json;
};

// `added`: text of an object or array, whose children are added behind the child `after`.
std::string edited(const std::string& text, std::vector<std::size_t> removed, std::size_t after = NewChild::kFirst,
                   const std::string& added = "") {
    const Parsed old_text(text);
    const Parsed new_text(added.empty() ? "[]" : added);
    ChildEdits changes{.removed = std::move(removed), .added = {}};
    for (const JsonMember& member : new_text.json->members)
        changes.added.push_back({after, member.key, {member.value, new_text.sources}});
    for (const Json& element : new_text.json->elements)
        changes.added.push_back({after, "", {element, new_text.sources}});
    std::vector<TextEdit> edits;
    edit_children(old_text.sources, *old_text.json, changes, edits);
    const std::string made = apply(old_text.sources, old_text.base, std::move(edits));
    const Parsed again(made);
    EXPECT_TRUE(again.json != nullptr) << made;
    return made;
}

TEST(TextEdits, RemovesAChildWithItsLinesAndComments) {
    EXPECT_EQ(edited("{\n  \"a\": 1,\n  // about b\n  \"b\": 2, // behind b\n  \"c\": 3\n}\n", {1}),
              "{\n  \"a\": 1,\n  \"c\": 3\n}\n");
    EXPECT_EQ(edited("{\n  \"a\": 1, // behind a\n  \"b\": 2\n}\n", {1}), "{\n  \"a\": 1 // behind a\n}\n");
    EXPECT_EQ(edited("{\n  \"a\": 1,\n  \"b\": 2\n  // the end\n}\n", {1}), "{\n  \"a\": 1\n  // the end\n}\n");
}

TEST(TextEdits, KeepsOneOfTwoBlankLines) {
    EXPECT_EQ(edited("[\n  1,\n\n  2,\n\n  3\n]", {1}), "[\n  1,\n\n  3\n]");
    EXPECT_EQ(edited("[\n  1,\n\n  2\n]", {1}), "[\n  1\n]");
    EXPECT_EQ(edited("[\n  1,\n\n  2,\n  3\n]", {1}), "[\n  1,\n\n  3\n]");
}

TEST(TextEdits, RemovesOnOneLine) {
    EXPECT_EQ(edited(R"({ "a": 1, "b": 2, "c": 3 })", {0}), R"({ "b": 2, "c": 3 })");
    EXPECT_EQ(edited(R"({ "a": 1, "b": 2, "c": 3 })", {1}), R"({ "a": 1, "c": 3 })");
    EXPECT_EQ(edited(R"({ "a": 1, "b": 2, "c": 3 })", {2}), R"({ "a": 1, "b": 2 })");
    EXPECT_EQ(edited(R"({ "a": 1, "b": 2, "c": 3 })", {1, 2}), R"({ "a": 1 })");
    EXPECT_EQ(edited(R"({ "a": 1, /* b */ "b": 2 })", {1}), R"({ "a": 1 })");
    EXPECT_EQ(edited(R"({ "a": 1, "b": 2, "c": 3 })", {0, 1, 2}), R"({})");
    EXPECT_EQ(edited("[1,2,\n 3,4]", {1, 2}), "[1,\n 4]");
}

TEST(TextEdits, AddsALineWhereEachChildHasOne) {
    EXPECT_EQ(edited("{\n    \"a\": 1,\n    \"b\": 2\n}", {}, 0, R"({ "new": 1.50 })"),
              "{\n    \"a\": 1,\n    \"new\": 1.5,\n    \"b\": 2\n}");
    EXPECT_EQ(edited("{\n  \"a\": 1, // behind a\n  \"b\": 2 // behind b\n}", {}, 1, R"({ "new": 1 })"),
              "{\n  \"a\": 1, // behind a\n  \"b\": 2, // behind b\n  \"new\": 1\n}");
    EXPECT_EQ(edited("{\n  \"a\": 1\n}", {}, NewChild::kFirst, R"({ "x": 1, "y": 2 })"),
              "{\n  \"x\": 1,\n  \"y\": 2,\n  \"a\": 1\n}");
}

TEST(TextEdits, CommentsComeWithAnAddedChild) {
    EXPECT_EQ(edited("[\n  { \"id\": \"a\" }\n]", {}, 0, "[\n  // about b\n  { \"id\": \"b\" } // behind b\n]"),
              "[\n  { \"id\": \"a\" },\n  // about b\n  { \"id\": \"b\" } // behind b\n]");
}

TEST(TextEdits, AddsOnOneLine) {
    EXPECT_EQ(edited(R"({ "a": 1, "b": 2 })", {}, 0, R"({ "new": 1 })"), R"({ "a": 1, "new": 1, "b": 2 })");
    EXPECT_EQ(edited(R"({ "a": 1 })", {}, 0, R"({ "new": 1 })"), R"({ "a": 1, "new": 1 })");
    EXPECT_EQ(edited(R"({ "a": 1 })", {}, NewChild::kFirst, R"({ "new": 1 })"), R"({ "new": 1, "a": 1 })");
    EXPECT_EQ(edited("{}", {}, NewChild::kFirst, R"({ "new": 1 })"), R"({ "new": 1 })");
    EXPECT_EQ(edited("[]", {}, NewChild::kFirst, R"([{ "id": "a" }])"), "[\n  { \"id\": \"a\" }\n]");
    EXPECT_EQ(edited("[\n  // none yet\n]", {}, NewChild::kFirst, R"([{ "id": "a" }])"),
              "[\n  // none yet\n  { \"id\": \"a\" }\n]");
}

TEST(TextEdits, ReplacesAChildThatGoes) {
    EXPECT_EQ(edited("[\n  1,\n  2\n]", {1}, 1, "[3]"), "[\n  1,\n  3\n]");
    EXPECT_EQ(edited("[\n  1,\n  2\n]", {0, 1}, 1, "[3]"), "[\n  3\n]");
    EXPECT_EQ(edited(R"({ "a": 1, "b": 2 })", {0}, 0, R"({ "c": 3 })"), R"({ "c": 3, "b": 2 })");
}

TEST(TextEdits, ATrailingCommaStaysInUse) {
    EXPECT_EQ(edited("[\n  1,\n  2,\n]", {1}), "[\n  1,\n]");
    EXPECT_EQ(edited("[\n  1,\n  2,\n]", {}, 1, "[3]"), "[\n  1,\n  2,\n  3,\n]");
}

TEST(TextEdits, EveryChoiceOfChildrenReadsBack) {
    // Comments, blank lines and several children on a line.
    const std::string text =
        "[ // opens\n  1, /* one */\n\n  // two\n  2, 3,\n  4 /* four */,\n\n  5 // five\n  // end\n]";
    for (unsigned bits = 0; bits < 32; ++bits) {
        for (std::size_t after = 0; after <= 5; ++after) {
            std::vector<std::size_t> removed;
            std::vector<double> wanted;
            for (std::size_t i = 0; i <= 5; ++i) {
                if (i == after) wanted.push_back(9);
                if (i == 5) break;
                if ((bits >> i) & 1u) {
                    removed.push_back(i);
                } else {
                    wanted.push_back(static_cast<double>(i + 1));
                }
            }
            const std::string made = edited(text, removed, after == 0 ? NewChild::kFirst : after - 1, "[9]");
            const Parsed again(made);
            std::vector<double> numbers;
            for (const Json& element : again.json->elements) numbers.push_back(element.number);
            EXPECT_EQ(numbers, wanted) << made;
            EXPECT_NE(made.find("// end"), made.npos) << made;
            EXPECT_EQ(made.find("// two") != made.npos, ((bits >> 1) & 1u) == 0) << made;
        }
    }
}

TEST(TextEdits, ReplacesAValueAndKeepsItsComments) {
    const Parsed old_text("{\n  \"in\": { \"a\": 1 }, // note\n  \"b\": 2\n}");
    const Parsed new_text("{ \"a\": [ { \"x\": 1 } ] }");
    std::vector<TextEdit> edits;
    replace_value(old_text.sources, *old_text.json->find("in"), {*new_text.json, new_text.sources}, edits);
    EXPECT_EQ(apply(old_text.sources, old_text.base, edits),
              "{\n  \"in\": {\n    \"a\": [\n      { \"x\": 1 }\n    ]\n  }, // note\n  \"b\": 2\n}");
}

TEST(TextEdits, ReordersChildrenWithTheirComments) {
    const Parsed text("[\n  // first\n  1, // one\n  2,\n  3 // three\n]");
    std::vector<TextEdit> edits;
    reorder_children(text.sources, *text.json, {2, 1, 0}, edits);
    EXPECT_EQ(apply(text.sources, text.base, edits), "[\n  3, // three\n  2,\n  // first\n  1 // one\n]");
}

}  // namespace
}  // namespace patina::edit
