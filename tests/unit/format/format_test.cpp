// The canonical text: what it looks like, that it is a fixed point, and that it says the same as before.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "compiler/format/canonical_form.h"
#include "compiler/json/json_text.h"

namespace patina::format {

using namespace json;
namespace {

std::string format(const std::string& text) {
    SourceMap sources;
    Diagnostics diagnostics;
    const FormattedText formatted = format_graph(sources, sources.add("t.graph.json", text), diagnostics);
    EXPECT_EQ(formatted.ok, !diagnostics.has_errors());
    EXPECT_TRUE(formatted.ok || formatted.text.empty());
    return formatted.ok ? formatted.text : "error: " + diagnostics.records().front().message;
}

// Formats, and checks that doing so again changes nothing.
std::string settled(const std::string& text) {
    const std::string once = format(text);
    EXPECT_EQ(format(once), once) << text;
    return once;
}

TEST(Format, PutsKeysInTheOrderOfTheFormat) {
    EXPECT_EQ(
        settled(R"({"surface":{"roughness":1,"baseColor":"#fff"},"nodes":[{"in":{"b":2,"a":1},"node":"Add","id":"x"}],
                         "workflow":"unlit","patina":1,"name":"N","zzz":0,"aaa":0})"),
        R"({
  "patina": 1,
  "name": "N",
  "workflow": "unlit",
  "nodes": [
    { "id": "x", "node": "Add", "in": { "b": 2, "a": 1 } }
  ],
  "surface": { "roughness": 1, "baseColor": "#fff" },
  "zzz": 0,
  "aaa": 0
}
)");
}

// Short objects stay on one line, and a sampler may be a name.
TEST(Format, KeepsTheKeysOfTextures) {
    EXPECT_EQ(settled(R"({"patina":1,"properties":[
        {"sampler":"trilinearRepeat","swizzle":"bgra","type":"texture2d","name":"_A"},
        {"sampler":{"filter":"nearest","wrap":"clamp"},"handedness":"directx","usage":"normal","type":"texture2d","name":"_B"}]})"),
              R"({
  "patina": 1,
  "properties": [
    { "name": "_A", "type": "texture2d", "swizzle": "bgra", "sampler": "trilinearRepeat" },
    {
      "name": "_B",
      "type": "texture2d",
      "usage": "normal",
      "handedness": "directx",
      "sampler": { "wrap": "clamp", "filter": "nearest" }
    }
  ]
}
)");
}

TEST(Format, OrdersAScene) {
    EXPECT_EQ(settled(R"({"objects":[{"material":"m","mesh":"cube","id":"o"}],
 // seen from the front
 "camera":{"fov":30,"position":[0,1,5]},
 "lights":[{"shadow":{"bias":0.1,"strength":1},"direction":[0,1,0],"type":"directional"}], // the sun
 "materials":[{"set":{"_B":1,"_A":2},"graph":"m.graph.json","name":"m"}],
 "ambient":{"ground":0,"sky":1},"kind":"scene","patina":1})"),
              R"({
  "patina": 1,
  "kind": "scene",
  // seen from the front
  "camera": { "position": [0, 1, 5], "fov": 30 },
  "ambient": { "sky": 1, "ground": 0 },
  "lights": [
    { "type": "directional", "direction": [0, 1, 0], "shadow": { "strength": 1, "bias": 0.1 } }
  ], // the sun
  "materials": [
    { "name": "m", "graph": "m.graph.json", "set": { "_B": 1, "_A": 2 } }
  ],
  "objects": [
    { "id": "o", "mesh": "cube", "material": "m" }
  ]
}
)");
}

TEST(Format, KnowsTheOrderOfEachKindOfFile) {
    EXPECT_EQ(settled(R"({"direct":0,"surface":[{"type":"float","name":"rim"}],"kind":"lighting","patina":1})"), R"({
  "patina": 1,
  "kind": "lighting",
  "surface": [
    { "name": "rim", "type": "float" }
  ],
  "direct": 0
}
)");
    EXPECT_EQ(settled(R"({"lighting":{"in":{},"use":"lambert"},"patina":1})"), R"({
  "patina": 1,
  "lighting": { "use": "lambert", "in": {} }
}
)");
}

TEST(Format, BreaksWhatDoesNotFit) {
    const std::string port = "\"" + std::string(60, 'p') + "\": ";
    // 2 spaces, "surface": {, 62 + 2 of the key, the number, " }" and room for a comma make 110.
    const std::string fits = "\"surface\": { " + port + std::string(110 - 1 - 2 - 13 - port.size() - 2, '1') + " }";
    EXPECT_EQ(settled("{" + fits + "}"), "{\n  " + fits + "\n}\n");
    const std::string digits = std::string(110 - 2 - 13 - port.size() - 2, '1');
    EXPECT_EQ(settled("{\"surface\":{" + port + digits + "}}"),
              "{\n  \"surface\": {\n    " + port + digits + "\n  }\n}\n");
}

TEST(Format, KeepsCommentsAndBlankLines) {
    EXPECT_EQ(settled("// head\n\n\n{ \"nodes\": [ // all\n{\"id\":\"a\"} , // first\n\n\n/* two\n   lines */ "
                      "{\"id\":\"b\"}\n// end\n], \"patina\": 1 /* v */ } // tail\n"),
              R"(// head

{
  "patina": 1, /* v */
  "nodes": [
    // all
    { "id": "a" }, // first

    /* two
   lines */
    { "id": "b" }
    // end
  ]
}
// tail
)");
}

TEST(Format, KeepsTheValueAndTheKindOfNumbers) {
    EXPECT_EQ(canonical_number("0.50"), "0.5");
    EXPECT_EQ(canonical_number("1.00"), "1.0");  // 1 would be a whole number
    EXPECT_EQ(canonical_number("1.50E+02"), "1.5e2");
    EXPECT_EQ(canonical_number("2e-07"), "2e-7");
    EXPECT_EQ(canonical_number("3e0"), "3.0");
    EXPECT_EQ(canonical_number("1.5e0"), "1.5");
    EXPECT_EQ(canonical_number("-0"), "-0");
    EXPECT_EQ(canonical_number("1000"), "1000");
    EXPECT_EQ(canonical_number("0.1000000000000000055511151231257827"), "0.1000000000000000055511151231257827");
}

TEST(Format, EscapesNoMoreThanNeeded) {
    EXPECT_EQ(settled("{\"name\":\"\\u0041\\/\\u00e9\\t\\u0001\\\"\\\\\"}"),
              "{\n  \"name\": \"A/\xC3\xA9\\t\\u0001\\\"\\\\\"\n}\n");
}

TEST(Format, WritesNothingAfterAnError) {
    EXPECT_EQ(format("{ \"a\": 1 \"b\" }").substr(0, 19), "error: broken JSON:");
    EXPECT_EQ(format("{ \"a\": 1, \"a\": 2 }"), "error: the key 'a' appears twice");
    EXPECT_EQ(format(""), "error: the file is empty");
}

// --- random texts

// A JSON text with odd white space, comments and trailing commas wherever they may stand.
class RandomText {
public:
    explicit RandomText(unsigned seed) : random_(seed) {}
    std::string file() { return gap() + value(0, true) + gap(); }

private:
    unsigned pick(unsigned count) { return std::uniform_int_distribution<unsigned>(0, count - 1)(random_); }
    std::string gap() {
        static const char* const kGaps[] = {
            "", "", "", " ", "\n", "\n\n", "\n \n\n", "/* b */", "// l\n", " /* 1\n 2 */ ", "\t// x \r\n"};
        std::string text = kGaps[pick(11)];
        if (pick(8) == 0) text += gap();
        return text;
    }
    std::string value(int depth, bool container) {
        static const char* const kScalars[] = {
            "null", "true",   "1.50",     "-2e+3",       "\"\\u0041b\"", "\"= a /* b */\"",
            "12",   "\"//\"", "\"\\\"\"", "0.1250e-0010"};
        const bool nested = container || (depth < 4 && pick(3) == 0);
        if (!nested) return kScalars[pick(10)];
        static const char* const kKeys[] = {"nodes",      "patina", "name", "in",     "id",
                                            "properties", "kind",   "x",    "surface"};
        const bool is_object = depth == 0 || pick(2) == 0;
        const unsigned count = pick(6);
        std::string text(1, is_object ? '{' : '[');
        for (unsigned i = 0; i < count; ++i) {
            text += gap();
            if (is_object) text += fmt::format("\"{}{}\"", kKeys[pick(9)], i) + gap() + ":" + gap();
            text += value(depth + 1, false) + gap();
            if (i + 1 < count || pick(3) == 0) text += ",";
        }
        return text + gap() + (is_object ? '}' : ']');
    }
    std::mt19937 random_;
};

std::unique_ptr<Json> parse(const std::string& text) {
    SourceMap sources;
    Diagnostics diagnostics;
    std::unique_ptr<Json> json = parse_json(sources, sources.add("t.json", text), diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.records().front().message << "\n" << text;
    return json;
}

// Equal but for the order of keys.
bool same(const Json& a, const Json& b) {
    if (a.kind != b.kind || a.boolean != b.boolean || a.number != b.number || a.string != b.string) return false;
    if (a.elements.size() != b.elements.size() || a.members.size() != b.members.size()) return false;
    for (std::size_t i = 0; i < a.elements.size(); ++i) {
        if (!same(a.elements[i], b.elements[i])) return false;
    }
    return std::all_of(a.members.begin(), a.members.end(), [&](const JsonMember& member) {
        const Json* other = b.find(member.key);
        return other && same(member.value, *other);
    });
}

std::size_t count_comments(std::string_view text) {
    std::size_t count = 0;
    for (const std::string_view mark : {"/* b */", "// l\n", "/* 1\n 2 */", "// x\n", "// x \r\n"}) {
        for (std::size_t at = text.find(mark); at != std::string_view::npos; at = text.find(mark, at + 1)) ++count;
    }
    return count;
}

TEST(Format, IsAFixedPointThatSaysTheSame) {
    for (unsigned seed = 0; seed < 3000; ++seed) {
        const std::string text = RandomText(seed).file();
        const std::string once = settled(text);
        const std::unique_ptr<Json> before = parse(text), after = parse(once);
        ASSERT_TRUE(before && after);
        ASSERT_TRUE(same(*before, *after)) << text << "\n---\n" << once;
        ASSERT_EQ(count_comments(text), count_comments(once)) << text << "\n---\n" << once;
        if (HasFailure()) break;
    }
}

}  // namespace
}  // namespace patina::format
