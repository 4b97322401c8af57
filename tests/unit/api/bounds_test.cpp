// A few lines can stand for work without end. It ends with an error at its place, or when the program says so.
#include <gtest/gtest.h>

#include <algorithm>

#include "patina/patina.h"
#include "tests/unit/api/large_texts.h"

namespace patina {
namespace {

constexpr const char* kGraph = R"json({ "patina": 1, "workflow": "unlit",
    "nodes": [ { "id": "a", "node": "./f.node.hlsl" } ], "surface": { "color": "= a" } })json";

CompileOptions with_file(std::string text) {
    CompileOptions options;
    options.files.read = [text = std::move(text)](const std::string& path) {
        return path == "f.node.hlsl"    ? std::optional(text)
               : path == "g.graph.json" ? std::optional<std::string>(kGraph)
                                        : std::nullopt;
    };
    return options;
}

void expect_one(const std::vector<Diagnostic>& diagnostics, std::string_view code, std::string_view message, int line) {
    ASSERT_EQ(diagnostics.size(), 1u) << said(diagnostics);
    EXPECT_EQ(diagnostics[0].code, code);
    EXPECT_NE(diagnostics[0].message.find(message), std::string::npos) << diagnostics[0].message;
    EXPECT_EQ(diagnostics[0].line, line) << said(diagnostics);
}

TEST(Bounds, CallsThatDoubleAreTooMany) {
    const CompileOptions few = with_file(doubling(12) + node("return h0(uv.x);"));
    EXPECT_TRUE(compiler().compile_text("g.graph.json", kGraph, few).ok);
    const CompileOptions many = with_file(doubling(30) + node("return h0(uv.x);"));
    const Result result = compiler().compile_text("g.graph.json", kGraph, many);
    EXPECT_FALSE(result.ok);
    ASSERT_FALSE(result.diagnostics.empty());
    EXPECT_EQ(result.diagnostics[0].code, "too-many") << said(result.diagnostics);
    EXPECT_EQ(result.diagnostics[0].file, "f.node.hlsl");
    const NodeFileResult checked = compiler().check_node_file("f.node.hlsl", many);
    EXPECT_FALSE(checked.ok);
    EXPECT_EQ(checked.diagnostics[0].code, "too-many") << said(checked.diagnostics);
}

TEST(Bounds, BodiesThatAreWrittenOutAreCounted) {
    const CompileOptions options = with_file(doubling(30, "[inline] ") + node("return h0(uv.x);"));
    const Result result = compiler().compile_text("g.graph.json", kGraph, options);
    EXPECT_FALSE(result.ok);
    ASSERT_EQ(result.diagnostics.size(), 1u) << said(result.diagnostics);
    EXPECT_EQ(result.diagnostics[0].code, "over-budget") << said(result.diagnostics);
}

TEST(Bounds, LoopsThatAreWrittenOutAreMeasuredBeforeTheyAre) {
    const std::string text = node(R"(float s = uv.x;
[unroll] for (int i = 0; i < 1024; i++) {
    [unroll] for (int j = 0; j < 1024; j++) { s = sin(s) * 1.5 + float(j); }
}
return s;)");
    const Result result = compiler().compile_text("g.graph.json", kGraph, with_file(text));
    expect_one(result.diagnostics, "over-budget", "more than the budget of 500000", 3);
    ASSERT_EQ(result.diagnostics[0].notes.size(), 1u);
    EXPECT_NE(result.diagnostics[0].notes[0].message.find("[unroll]"), std::string::npos);

    CompileOptions few =
        with_file(node("float s = uv.x; [unroll] for (int i = 0; i < 100; i++) { s = sin(s); } return s;"));
    EXPECT_TRUE(compiler().compile_text("g.graph.json", kGraph, few).ok);
    few.limits.instructions = 200;
    expect_one(compiler().compile_text("g.graph.json", kGraph, few).diagnostics, "over-budget", "200", 2);
}

TEST(Bounds, TestLinesEnd) {
    std::string body = "float s = uv.x; for (int i = 0; i < 2048; i++) { for (int j = 0; j < 2000; j++) {";
    for (int i = 0; i < 200; ++i) body += " s = s * 1.5 + 1;";
    body += " } } return s;";
    const NodeFileResult checked =
        compiler().check_node_file("f.node.hlsl", with_file(node(body, "/// F.\n/// test: F(float2(0, 0)) == 1\n")));
    EXPECT_FALSE(checked.ok);
    expect_one(checked.diagnostics, "over-budget", "steps of the interpreter", 2);
}

TEST(Bounds, AFunctionHasSoManyVariables) {
    std::string body = "float s = uv.x;";
    for (int i = 0; i < 5000; ++i) body += " float v" + std::to_string(i) + " = s;";
    const Result result = compiler().compile_text("g.graph.json", kGraph, with_file(node(body + " return s;")));
    EXPECT_FALSE(result.ok);
    ASSERT_FALSE(result.diagnostics.empty());
    EXPECT_EQ(result.diagnostics[0].message, "4097 variables of a function are too many: the limit is 4096");
}

std::string list(int count, const std::string& before, const std::string& after) {
    std::string text;
    for (int i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + before + std::to_string(i) + after;
    return text;
}

// Each is refused before anything looks for one of them among the others.
TEST(Bounds, ListsOfAGraphAreRefusedAtOnce) {
    const std::string surface = R"("surface": { "color": 0.5 } })", head = R"({ "patina": 1, "workflow": "unlit", )";
    const std::map<std::string, std::string> cases = {
        {"60000 properties",
         head + R"("properties": [ )" + list(60000, R"({ "name": "_p)", R"(", "type": "float" })") + " ], " + surface},
        {"2000 values of an enum", head + R"("properties": [ { "name": "_e", "type": "enum", "values": [ )" +
                                       list(2000, "\"V", "\"") + " ] } ], " + surface},
        {"2000 keys of 'in'", head + R"("nodes": [ { "id": "a", "node": "Lerp", "in": { )" +
                                  list(2000, "\"x", "\": 1") + " } } ], " + surface},
        {"2001 letters of a name",
         head + R"("nodes": [ { "id": "a)" + std::string(2000, 'b') + R"(", "expr": "1" } ], )" + surface},
    };
    for (const auto& [message, text] : cases) {
        const Result result = compiler().compile_text("g.graph.json", text);
        EXPECT_FALSE(result.ok);
        ASSERT_FALSE(result.diagnostics.empty()) << message;
        EXPECT_EQ(result.diagnostics[0].code, "too-many") << said(result.diagnostics);
        EXPECT_EQ(result.diagnostics[0].message.rfind(message + " are too many", 0), 0u) << said(result.diagnostics);
    }
}

// 24 names of a thousand letters in each of 200 messages would be megabytes.
TEST(Bounds, MessagesListNoLongNames) {
    std::string properties, nodes;
    for (int i = 0; i < 20; ++i)
        properties += (i > 0 ? ", " : "") + (R"({ "name": "_)" + std::string(900, 'a')) + std::to_string(i) +
                      R"(", "type": "float" })";
    for (int i = 0; i < 100; ++i)
        nodes += (i > 0 ? ", " : "") + (R"({ "id": "n)" + std::to_string(i)) + R"(", "expr": "$_zzz + )" +
                 std::to_string(i) + "\" }";
    const Result result = compiler().compile_text(
        "g.graph.json", R"({ "patina": 1, "workflow": "unlit", "properties": [ )" + properties + R"( ], "nodes": [ )" +
                            nodes + R"( ], "surface": { "color": "= )" + list(100, "n", "") + R"(" } })");
    EXPECT_FALSE(result.ok);
    for (const Diagnostic& each : result.diagnostics) EXPECT_LT(to_text(each).size(), 3000u);
}

TEST(Bounds, APassThatIsNamedTwiceIsMadeOnce) {
    CompileOptions options;
    options.request = CompileOptions::Passes{.only = std::vector<std::string>(1000, "forward")};
    options.targets = std::vector<Target>(1000, Target::Glsl);
    options.include_dirs = std::vector<std::string>(1000, "shaders");
    const Result result = compiler().compile_text(
        "g.graph.json", R"({ "patina": 1, "workflow": "unlit", "surface": { "color": 1 } })", options);
    ASSERT_TRUE(result.ok) << said(result.diagnostics);
    EXPECT_EQ(result.shaders.size(), 2u);
    EXPECT_EQ(result.reflection.passes.size(), 1u);
}

}  // namespace
}  // namespace patina
