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

TEST(BrokenShaderGraph, AnInputOfAnUnknownClassIsAConstant) {
    ShaderGraphText graph = painted();
    graph.nodes.back().slots[1].kind = "Future";
    Imported made = import_graph(graph);
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("the input 'S1' is of the class 'Future'"), std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    expect_compiles(made, "an unknown slot");

    graph = painted();
    graph.properties[0].kind = "Future";
    made = import_graph(graph);
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("the graph has no such property"), std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    expect_compiles(made, "an unknown property");

    made = import_graph(one_node({.id = "g",
                                  .kind = "SampleGradient",
                                  .slots = {{.id = 0, .kind = "Vector1", .value = "0.5"},
                                            {.id = 1, .kind = "Vector1", .value = "0.5"},
                                            out(2, "Vector4")}},
                                 2));
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("it has no slot for its gradient"), std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    expect_compiles(made, "a number as a gradient");
}

// The surface has inputs of its own types, whatever the file says of its blocks.
TEST(BrokenShaderGraph, BlocksHaveTheTypesOfTheSurface) {
    for (const std::string kind :
         {"UV", "Position", "ScreenPosition", "Vector1", "Boolean", "SamplerState", "Future"}) {
        ShaderGraphText graph;
        graph.blocks = {{"SurfaceDescription.BaseColor", kind}, {"SurfaceDescription.Alpha", kind}};
        if (kind == "Vector1") graph.blocks[0].value = graph.blocks[1].value = "0.5";
        graph.target = R"("m_SurfaceType":1)";
        const Imported made = import_graph(graph);
        expect_compiles(made, kind);
        if (kind == "SamplerState") {
            EXPECT_NE(remarks(made, Remark::Kind::Changed).find("it takes float3 and has SamplerState"),
                      std::string::npos)
                << remarks(made, Remark::Kind::Changed);
        }
    }
}

// Slots of other types than the node has: what that gives is no graph, so the node is refused with the reason.
TEST(BrokenShaderGraph, WhatWouldBeNoGraphIsRefused) {
    ShaderGraphText graph = doubled();
    graph.nodes.push_back({.id = "size",
                           .kind = "Vector2Node",
                           .slots = {{.id = 1, .kind = "Vector1", .value = "0.5"},
                                     {.id = 2, .kind = "Vector1", .value = "0.25"},
                                     out(0, "Vector2")}});
    graph.nodes.push_back({.id = "uv", .kind = "UVNode", .slots = {out(0, "Vector4")}});
    graph.nodes.push_back({.id = "sum", .kind = "AddNode", .slots = {{0, "Vector4"}, {1}, out(2)}, .name = "Sum"});
    graph.edges.push_back({"uv", 0, "sum", 0});
    graph.edges.push_back({"size", 0, "sum", 1});
    graph.edges[5] = {"sum", 2, "output", 1};
    Imported made = import_graph(graph);
    EXPECT_TRUE(made.has_refused);
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut)
                  .find("'outputs.result': the graph would not be valid: '+' cannot be applied to float4 and float2"),
              std::string::npos)
        << remarks(made, Remark::Kind::LeftOut) << made.error;
    EXPECT_NE(text_of(made, "x.subgraph.json").find("{ \"result\": \"= float3(1, 0, 1)\" }"), std::string::npos)
        << text_of(made, "x.subgraph.json");

    // In the input of a node, and in an expression that two others read.
    const ShaderGraphText outer{
        .nodes = {{.id = "noise",
                   .kind = "NoiseNode",
                   .slots = {{0, "Vector2"}, {.id = 1, .kind = "Vector1", .value = "5.0"}, out(2, "Vector1")},
                   .name = "Noise"}}};
    graph.nodes.push_back(outer.nodes[0]);
    graph.outputs.clear();
    graph.dropdowns.clear();
    graph.edges = {{"uv", 0, "sum", 0}, {"size", 0, "sum", 1}, {"sum", 2, "noise", 0}, {"noise", 2, "BaseColor"}};
    made = import_graph(graph);
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find("node 'Noise': the graph would not be valid: '+' cannot"),
              std::string::npos)
        << remarks(made, Remark::Kind::LeftOut);
    expect_compiles(made, "a sum of two sizes as an input");

    graph.edges.push_back({"sum", 2, "BaseColor"});
    graph.edges[3] = {"noise", 2, "Alpha"};
    graph.blocks.push_back({"SurfaceDescription.Alpha", "Vector1", "1.0"});
    graph.target = R"("m_SurfaceType":1)";
    made = import_graph(graph);
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find("node 'Sum': the graph would not be valid: '+' cannot"),
              std::string::npos)
        << remarks(made, Remark::Kind::LeftOut);
    expect_compiles(made, "a sum of two sizes that is read twice");

    graph.edges = {{"uv", 0, "sum", 0}, {"size", 0, "sum", 1}, {"sum", 2, "BaseColor"}};
    made = import_graph(graph);
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find("cannot be applied to float4 and float2"), std::string::npos)
        << remarks(made, Remark::Kind::LeftOut);
    expect_compiles(made, "a sum of two sizes");
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
        if (!made.error.empty()) continue;
        ++imported;
        // A sub-graph alone is no material.
        if (made.graphs.back().name.ends_with(".graph.json") && imported % 4 == 0) {
            EXPECT_TRUE(compiled(made, made.graphs.back().name).ok) << text;
        }
    }
    EXPECT_GT(imported, 500u);
}

}  // namespace
}  // namespace patina::importers
