// Shader graphs of Unity that are broken, hostile or of another time: each is refused at its place, or imported with a
// remark.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <regex>

#include "tests/unit/importers/shadergraph_import.h"

namespace patina::importers {
namespace {

TEST(BrokenShaderGraph, BrokenFilesAreReportedAtTheirPlace) {
    const std::string good = painted().new_layout();
    EXPECT_TRUE(std::regex_search(import_text(good.substr(0, good.size() - 10)).error,
                                  std::regex("x\\.shadergraph:[0-9]+:[0-9]+: ")));
    EXPECT_NE(import_text("").error.find("the file is empty"), std::string::npos);
    EXPECT_NE(import_text("nonsense").error.find("x.shadergraph:1:1: "), std::string::npos);
    EXPECT_NE(import_text("{}").error.find("is no shader graph"), std::string::npos);
    EXPECT_NE(import_text(good + "\n\n<<<<<<< HEAD\n").error.find("begins with '{'"), std::string::npos);
    std::string nan = good;
    nan.replace(nan.find("0.25"), 4, "NaN");
    EXPECT_TRUE(std::regex_search(import_text(nan).error, std::regex("x\\.shadergraph:[0-9]+:[0-9]+: ")))
        << import_text(nan).error;
    EXPECT_NE(import_text(std::string(5000, '{') + good).error, "");
    ShaderGraphText twice = painted();
    twice.nodes.push_back(twice.nodes[0]);
    EXPECT_NE(import_graph(twice).error.find("a second object has the id"), std::string::npos);
    ShaderGraphText circle = painted();
    circle.edges.push_back({"mix", 3, "product", 0});
    circle.edges.erase(circle.edges.begin() + 1);
    EXPECT_NE(import_graph(circle).error.find("reads itself, through"), std::string::npos);
}

TEST(BrokenShaderGraph, WhatIsMissingIsSaid) {
    ShaderGraphText graph = painted();
    graph.edges.push_back({"nobody", 0, "mix", 1});
    graph.edges.push_back({"a", 99, "mix", 1});
    graph.nodes.push_back({.id = "u", .kind = "NodeOfTheFuture", .slots = {{0}, out(1)}, .name = "Future"});
    graph.edges.push_back({"u", 1, "mix", 1});
    const Imported made = import_graph(graph);
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("a node at its end does not exist"), std::string::npos);
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("the slot at its end does not exist"), std::string::npos);
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find("'NodeOfTheFuture' is no node"), std::string::npos);
    expect_compiles(made, "missing");
}

// Each level reads the one before it twice: what is noted of a value must not double with each.
TEST(BrokenShaderGraph, AChainThatReadsEachLinkTwiceIsShort) {
    ShaderGraphText graph;
    graph.nodes.push_back({.id = "uv", .kind = "UVNode", .slots = {{.id = 0, .kind = "Vector4", .is_input = false}}});
    std::string last = "uv";
    int slot = 0;
    for (int i = 0; i < 60; ++i) {
        const std::string split = fmt::format("split{}", i), combine = fmt::format("combine{}", i);
        graph.nodes.push_back({.id = split,
                               .kind = "SplitNode",
                               .slots = {{.id = 0, .kind = "DynamicVector"},
                                         {.id = 1, .kind = "Vector1", .is_input = false},
                                         {.id = 2, .kind = "Vector1", .is_input = false}}});
        graph.nodes.push_back({.id = combine,
                               .kind = "CombineNode",
                               .slots = {{.id = 0, .kind = "Vector1"},
                                         {.id = 1, .kind = "Vector1"},
                                         {.id = 6, .kind = "Vector2", .is_input = false}}});
        graph.edges.push_back({last, slot, split, 0});
        graph.edges.push_back({split, 1, combine, 0});
        graph.edges.push_back({split, 2, combine, 1});
        last = combine;
        slot = 6;
    }
    graph.edges.push_back({last, slot, "BaseColor"});
    const Imported made = import_graph(graph);
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    EXPECT_LT(made.graphs[0].text.size(), 20000u);
}

TEST(BrokenShaderGraph, CodeIsRefusedWithTheReasonAndTheLine) {
    const std::map<std::string, std::string> reasons = {
        {"#if " + std::string(400000, '!') + R"(A\nOut = A;\n#endif)",
         "line 1 of its code: its condition cannot be decided: it is too long"},
        {R"(#if 1\nOut = A;)", "line 1 of its code: it has an '#if' without its '#endif'"},
        {R"(Out = A;\n#endif)", "line 2 of its code: it has an '#endif' without its '#if'"},
        {R"(Out = A;\n#if UNITY_VERSION >= 202210\nOut = 1;\n#endif)",
         "line 2 of its code: its condition cannot be decided: it compares 'UNITY_VERSION', whose value only the "
         "engine "
         "knows"},
        {R"(#if ENGINE_HAS(B)\nOut = A;\n#endif)",
         "line 1 of its code: its condition cannot be decided: it asks the macro 'ENGINE_HAS', which only the engine "
         "has"},
        {R"(#define B C\n#define C B\n#if B\n#endif\nOut = A;)",
         "line 3 of its code: its condition cannot be decided: its macro"},
        {R"(\n\nOut = A;\n/* all that follows)", "line 4 of its code: a comment begins with '/*' and has no end"},
        {R"(Out = A;\n}\nvoid Other(out float Out) {\nOut = 1;)", "line 2 of its code: a '}' closes nothing"},
        {R"(Out = A;\nif (B > 1) {)", "line 2 of its code: a '}' is missing"},
        {R"(float3 C = A * B;)", "its code never assigns its output 'Out'"},
        {R"(if (Out.x == A.x) { A = Out; })", "its code never assigns its output 'Out'"}};
    for (const auto& [body, reason] : reasons) {
        const Imported made = import_graph(one_node(custom(body), 2));
        EXPECT_TRUE(made.has_refused) << reason;
        EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find(reason), std::string::npos)
            << reason << "\n"
            << remarks(made, Remark::Kind::LeftOut);
        expect_compiles(made, reason);
    }
}

TEST(BrokenShaderGraph, ASampleWithoutASlotForItsTextureIsWhite) {
    ShaderGraphText graph = painted();
    graph.edges.erase(graph.edges.begin());
    graph.nodes[3].slots.erase(graph.nodes[3].slots.begin());
    const Imported made = import_graph(graph);
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("the node has no slot for its Texture2D: it is white"),
              std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    expect_compiles(made, "no slot");
}

TEST(BrokenShaderGraph, ConditionsThatCanBeDecidedAre) {
    const std::pair<const char*, bool> conditions[] = {{"MODE == 2", true},
                                                       {"MODE != 2", false},
                                                       {"MODE > 1 && MODE <= 2", true},
                                                       {"(MODE + 1) * 2 == 6", true},
                                                       {"!defined(B)", true},
                                                       {"defined MODE", true},
                                                       {"SHADERGRAPH_PREVIEW == 1", false},
                                                       {"0x10 > 15", true},
                                                       {"SOMETHING", false},
                                                       {"ON || MODE < 0", true},
                                                       {"-1 < 0", true}};
    for (const auto& [condition, holds] : conditions) {
        const Imported made = import_graph(one_node(
            custom(fmt::format(
                R"(#define MODE TWO\n#define TWO 2\n#define ON 1\n#if {}\nOut = A * 7;\n#else\nOut = A;\n#endif)",
                condition)),
            2));
        EXPECT_FALSE(made.has_refused) << condition << remarks(made, Remark::Kind::LeftOut);
        EXPECT_EQ(text_of(made, "Glow.node.hlsl").find("* 7") != std::string::npos, holds) << condition;
    }
}

TEST(BrokenShaderGraph, NamesOfFilesStayShort) {
    const Imported made = import_graph(one_node(custom("Out = A * B;", std::string(100000, 'x')), 2));
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut).substr(0, 1000);
    for (const TextFile& each : made.graphs) EXPECT_LT(each.name.size(), 150u);
    expect_compiles(made, "a long name");
}

// What only a refused node would read is not left in the graph.
TEST(BrokenShaderGraph, NothingIsMadeForARefusedNode) {
    ShaderGraphText graph = painted();
    graph.nodes.push_back({.id = "u", .kind = "NodeOfTheFuture", .slots = {{0}, out(1)}, .name = "Future"});
    graph.edges = {{"b", 0, "sample", 1}, {"sample", 0, "u", 0}, {"u", 1, "BaseColor"}};
    const Imported made = import_graph(graph);
    EXPECT_EQ(text_of(made).find("SampleTexture2D"), std::string::npos) << text_of(made);
    EXPECT_NE(remarks(made, Remark::Kind::Taken).find("node 'Sample Texture 2D': only what is not imported reads it"),
              std::string::npos)
        << remarks(made, Remark::Kind::Taken);
    expect_compiles(made, "refused");
}

TEST(BrokenShaderGraph, AnEdgeOfTheWrongTypeGivesAConstant) {
    ShaderGraphText graph = painted();
    graph.edges[0] = {"c", 0, "sample", 1};
    const Imported made = import_graph(graph);
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("takes Texture2D and is connected to float"), std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    expect_compiles(made, "a number as a texture");
}

TEST(BrokenShaderGraph, HugeNumbersAreNumbers) {
    ShaderGraphText graph = painted();
    graph.properties[2].value = "1e300";
    EXPECT_EQ(import_graph(graph).error, "");
    expect_compiles(import_graph(graph), "huge");
}

// Whatever is changed in a file: it is imported or refused, and an import is a graph.
TEST(BrokenShaderGraph, MutationsDoNotCrash) {
    std::mt19937 random(19);
    const std::string seeds[] = {painted().new_layout(), painted().old_layout(), user(kGuid).new_layout(),
                                 doubled().new_layout()};
    std::size_t imported = 0;
    for (int i = 0; i < 4000; ++i) {
        std::string text = seeds[random() % 4];
        for (int edits = 1 + static_cast<int>(random() % 4); edits > 0; --edits) {
            const std::size_t at = random() % text.size(), count = 1 + random() % 12;
            switch (random() % 4) {
                case 0: text[at] = static_cast<char>(random() % 256); break;
                case 1: text.erase(at, count); break;
                case 2: text.insert(at, text.substr(random() % text.size(), count)); break;
                case 3:
                    text[std::min(text.find_first_of("0123456789", at), text.size() - 1)] =
                        static_cast<char>('0' + random() % 10);
                    break;
            }
        }
        const Imported made = import_text(text);
        EXPECT_EQ(made.error.empty(), !made.graphs.empty());
        if (made.error.empty()) ++imported;
    }
    EXPECT_GT(imported, 500u);
}

}  // namespace
}  // namespace patina::importers
