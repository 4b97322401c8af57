// The JSON reader: every value knows its place, comments are kept, and broken text is refused with words that help.
#include "compiler/json/json.h"

#include <gtest/gtest.h>

#include <cmath>

namespace patina::json {
namespace {

struct Parsed {
    SourceMap sources;
    Diagnostics diagnostics;
    std::uint32_t base = 0;
    std::unique_ptr<Json> root;

    explicit Parsed(std::string text) {
        base = sources.add("t.json", std::move(text));
        root = parse_json(sources, base, diagnostics);
    }
    std::string_view text(Span span) const { return sources.text(span); }
    // "line:column message" of the first complaint.
    std::string complaint() const {
        if (diagnostics.records().empty()) return "none";
        const DiagnosticRecord& record = diagnostics.records().front();
        const Position at = sources.resolve(record.span.begin);
        return fmt::format("{}:{} {}", at.line, at.column, record.message);
    }
    Code code() const { return diagnostics.records().front().code; }
};

TEST(Json, ReadsEveryKindOfValue) {
    const Parsed p(R"({ "a": null, "b": true, "c": -1.5e2, "d": "x", "e": [1, 2], "f": {} })");
    ASSERT_TRUE(p.root) << p.complaint();
    ASSERT_EQ(p.root->members.size(), 6u);
    EXPECT_EQ(p.root->find("a")->kind, Json::Kind::Null);
    EXPECT_TRUE(p.root->find("b")->boolean);
    EXPECT_EQ(p.root->find("c")->number, -150.0);
    EXPECT_EQ(p.root->find("d")->string, "x");
    EXPECT_EQ(p.root->find("e")->elements.at(1).number, 2.0);
    EXPECT_EQ(p.root->find("f")->kind, Json::Kind::Object);
    EXPECT_EQ(p.root->find("g"), nullptr);
}

TEST(Json, SpansCoverExactlyTheToken) {
    const Parsed p("{ // c\n  \"key\" /* c */ : \"v\\n\",\"n\":  -12.50 ,\n \"o\":{ \"i\":[ true,[ ] ] } }");
    ASSERT_TRUE(p.root) << p.complaint();
    EXPECT_EQ(p.text(p.root->members[0].key_span), "key");
    EXPECT_EQ(p.text(p.root->members[0].value.span), "\"v\\n\"");
    EXPECT_EQ(p.text(p.root->members[1].value.span), "-12.50");
    EXPECT_EQ(p.text(p.root->members[2].value.span), "{ \"i\":[ true,[ ] ] }");
    const Json& inner = *p.root->members[2].value.find("i");
    EXPECT_EQ(p.text(inner.span), "[ true,[ ] ]");
    EXPECT_EQ(p.text(inner.elements[0].span), "true");
    EXPECT_EQ(p.text(inner.elements[1].span), "[ ]");
    EXPECT_EQ(p.root->span.begin, p.base);
    EXPECT_EQ(p.text(p.root->span).back(), '}');
}

TEST(Json, NumbersAreRoundedCorrectly) {
    // Exact halfway and boundary cases of binary64, from the definition of the format.
    const Parsed p("[0.1, 9007199254740993, 2.2250738585072011e-308, 1.7976931348623157e308, -0.0]");
    ASSERT_TRUE(p.root) << p.complaint();
    EXPECT_EQ(p.root->elements[0].number, 0x1.999999999999ap-4);
    EXPECT_EQ(p.root->elements[1].number, 0x1p53);  // a tie, to even
    EXPECT_EQ(p.root->elements[2].number, 0x0.fffffffffffffp-1022);
    EXPECT_EQ(p.root->elements[3].number, 0x1.fffffffffffffp+1023);
    EXPECT_TRUE(std::signbit(p.root->elements[4].number));
}

TEST(Json, NumbersBeyondTheEnds) {
    const std::string zeros(330, '0');
    const Parsed p("[0e75, -0E+99, 1e-400, 0." + zeros + "1, 0." + zeros + "5e331, 4e-400]");
    ASSERT_TRUE(p.root);
    const double expected[] = {0, 0, 0, 0, 5, 0};
    for (std::size_t i = 0; i < std::size(expected); ++i) EXPECT_EQ(p.root->elements[i].number, expected[i]) << i;
    const std::string large[] = {"1e400", "-1e400", "1" + zeros, "1" + zeros + "e-9", "0.01e999999999999"};
    for (const std::string& each : large) EXPECT_FALSE(Parsed("[" + each + "]").root) << each;
}

TEST(Json, OffsetsLeadThroughEscapes) {
    const Parsed plain(R"(["abc"])");
    EXPECT_TRUE(string_offsets(plain.root->elements[0], plain.sources).empty());

    // a, \n, U+00E9 as an escape (2 bytes of UTF-8), U+1F600 as a surrogate pair (4 bytes), U+00E9 as itself, z
    const Parsed p("[\"a\\n\\u00e9\\ud83d\\ude00\xC3\xA9z\"]");
    ASSERT_TRUE(p.root) << p.complaint();
    const Json& string = p.root->elements[0];
    EXPECT_EQ(string.string, "a\n\xC3\xA9\xF0\x9F\x98\x80\xC3\xA9z");
    const std::uint32_t start = string.span.begin + 1;
    const std::vector<std::uint32_t> expected = {start,     start + 1, start + 3,  start + 3,  start + 9,  start + 9,
                                                 start + 9, start + 9, start + 21, start + 22, start + 23, start + 24};
    EXPECT_EQ(string_offsets(string, p.sources), expected);
}

TEST(Json, CommentsStayWithWhatTheyStandAt) {
    const Parsed p(R"(// head
{
  // before a
  "a": 1, // behind a
  /* before */ "b" /* inside */ : 2,

  // last
} // tail
// end
)");
    ASSERT_TRUE(p.root) << p.complaint();
    ASSERT_TRUE(p.root->comments);
    EXPECT_EQ(p.root->comments->before, std::vector<std::string>{"// head"});
    EXPECT_EQ(p.root->comments->trailing, "// tail\n// end");
    EXPECT_EQ(p.root->comments->end, (std::vector<std::string>{"", "// last"}));
    const Json& a = *p.root->find("a");
    EXPECT_EQ(a.comments->before, std::vector<std::string>{"// before a"});
    EXPECT_EQ(a.comments->trailing, "// behind a");
    EXPECT_EQ(p.root->find("b")->comments->before, (std::vector<std::string>{"/* before */", "/* inside */"}));
}

TEST(Json, AcceptsTrailingCommasAndAByteOrderMark) {
    const Parsed p("\xEF\xBB\xBF{ \"a\": [1, 2,], }");
    ASSERT_TRUE(p.root) << p.complaint();
    EXPECT_EQ(p.root->find("a")->elements.size(), 2u);
    EXPECT_EQ(p.text(p.root->members[0].key_span), "a");
}

struct Broken {
    const char* text;
    const char* complaint;
};

TEST(Json, SaysWhatIsWrongAndWhere) {
    const Broken cases[] = {
        {" ", "1:2 broken JSON: the file ends before its first '{'"},
        {"{\"a\": 1\n \"b\": 2}", "1:8 broken JSON: a ',' is missing after this value"},
        {"{\"a\" 1}", "1:2 broken JSON: a ':' and a value are missing after this key"},
        {"{\"a\" = 1}", "1:6 broken JSON: write ':' between a key and its value, not '='"},
        {"{a: 1}", "1:2 broken JSON: a key in double quotes is needed here, not 'a'"},
        {"{\"a\": 1,, }", "1:9 broken JSON: there is an extra ',' here"},
        {"{\"a\": }", "1:7 broken JSON: a value is missing before this '}'"},
        {"{\"a\": 1]", "1:8 broken JSON: a ']' cannot close a '{'"},
        {"{\"a\": 1;}", "1:8 broken JSON: expected ',' or '}' after a value, not ';'"},
        {"[1, 2", "1:6 broken JSON: the file ends before a closing ']'"},
        {"{} {}", "1:4 broken JSON: there is text after the end of the JSON value"},
        {"{\"a\": NaN}", "1:7 broken JSON: 'NaN' is not a JSON number: write a finite number"},
        {"{\"a\": -Infinity}", "1:7 broken JSON: '-Infinity' is not a JSON number: write a finite number"},
        {"{\"a\": 1e999}", "1:7 broken JSON: the number '1e999' is too large"},
        {"{\"a\": 01}", "1:7 broken JSON: '01' is not a JSON number: leave out the leading zero"},
        {"{\"a\": 0x10}", "1:7 broken JSON: '0x10' is not a JSON number"},
        {"{\"a\": .5}", "1:7 broken JSON: '.5' needs a digit before its point"},
        {"{\"a\": 5.}", "1:7 broken JSON: '5.' needs a digit after its point"},
        {"{\"a\": True}", "1:7 broken JSON: 'True' is not a value: write true"},
        {"{\"a\": rust}", "1:7 broken JSON: 'rust' is not a value: put text in double quotes"},
        {"{\"a\": 'x'}", "1:7 broken JSON: write a string in double quotes: \"...\""},
        {"{\"a\": \"x\n\"}", "1:7 broken JSON: the string is not closed: a '\"' is missing"},
        {"{\"a\": \"C:\\dir\"}", "1:10 broken JSON: there is no escape '\\d': write a backslash as '\\\\'"},
        {"{\"a\": \"\\ud800\"}", "1:8 broken JSON: this is half of a surrogate pair without the other half"},
        {"{\"a\": \"\\udc00\"}", "1:7 broken JSON: the string holds half of a surrogate pair"},
        {"{\"a\": \"\\u0000\"}", "1:7 broken JSON: a string cannot hold the character \\u0000"},
        {"{ /* \n }", "1:3 broken JSON: the comment is not closed: a '*/' is missing"},
        {"{ / }", "1:3 broken JSON: a '/' is not allowed here: a comment starts with '//' or '/*'"},
    };
    for (const Broken& broken : cases) {
        const Parsed p(broken.text);
        EXPECT_EQ(p.complaint(), broken.complaint) << broken.text;
        EXPECT_FALSE(p.root) << broken.text;
        EXPECT_EQ(p.diagnostics.records().size(), 1u) << broken.text;
    }
}

TEST(Json, PointsToTheBracketThatIsOpen) {
    const Parsed p("{ \"a\": [1,\n 2");
    ASSERT_EQ(p.diagnostics.records().size(), 1u);
    ASSERT_EQ(p.diagnostics.records()[0].notes.size(), 1u);
    EXPECT_EQ(p.sources.resolve(p.diagnostics.records()[0].notes[0].span.begin).column, 8);
}

TEST(Json, ReportsEveryDuplicateAndKeepsTheFirst) {
    const Parsed p(R"({ "a": 1, "a": 2, "b": { "c": 3, "c": [4] } })");
    ASSERT_TRUE(p.root);
    ASSERT_EQ(p.diagnostics.records().size(), 2u);
    EXPECT_EQ(p.code(), Code::DuplicateKey);
    EXPECT_EQ(p.complaint(), "1:12 the key 'a' appears twice");
    EXPECT_EQ(p.sources.resolve(p.diagnostics.records()[0].notes.at(0).span.begin).column, 4);
    EXPECT_EQ(p.root->find("a")->number, 1.0);
    EXPECT_EQ(p.root->find("b")->find("c")->number, 3.0);
}

TEST(Json, FindsDuplicatesInALargeObject) {
    std::string text = "{";
    for (int i = 0; i < 50'000; ++i) text += fmt::format("\"k{}\":1,", i);
    const Parsed p(text + "\"k49999\":2,\"k3\":2}");
    ASSERT_EQ(p.diagnostics.records().size(), 2u);
    EXPECT_EQ(p.root->members.size(), 50'000u);
}

TEST(Json, RefusesWhatIsNotText) {
    EXPECT_EQ(Parsed("").code(), Code::EmptyFile);
    const Parsed latin1("{ \"a\": \"caf\xE9\" }");
    EXPECT_EQ(latin1.code(), Code::NotUtf8);
    EXPECT_EQ(latin1.complaint(), "1:12 the text is not UTF-8: byte 12 is 0xe9");
    EXPECT_EQ(Parsed("// \xFF\n{}").code(), Code::NotUtf8);  // in a comment, too
    EXPECT_EQ(Parsed(std::string("{}\0{}", 5)).code(), Code::BadJson);
}

TEST(Json, LimitsDepth) {
    const std::string open(kMaxJsonDepth, '['), close(kMaxJsonDepth, ']');
    EXPECT_TRUE(Parsed(open + close).root);
    const Parsed deeper("[" + open + close + "]");
    EXPECT_EQ(deeper.code(), Code::TooDeep);
    EXPECT_FALSE(deeper.root);
}

TEST(Json, RefusesSixtyFourMebibytesOfBrackets) {
    const Parsed deep(std::string(kMaxJsonBytes, '['));
    EXPECT_EQ(deep.code(), Code::TooDeep);
    EXPECT_EQ(Parsed(std::string(kMaxJsonBytes + 1, '[')).code(), Code::TooLarge);
}

TEST(Json, LimitsTheNumberOfItems) {
    std::string many = "[";
    for (std::size_t i = 0; i < kMaxJsonItems; ++i) many += "0,";
    EXPECT_EQ(Parsed(many + "]").code(), Code::TooMany);
    // Comments on one line are the costly ones: each could belong to the value before all of them.
    std::string comments = "[1,";
    for (std::size_t i = 0; i < kMaxJsonItems; ++i) comments += "/**/";
    EXPECT_EQ(Parsed(comments + "2]").code(), Code::TooMany);
}

}  // namespace
}  // namespace patina::json
