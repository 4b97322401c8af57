// Shader graphs of Unity that are broken, hostile or of another time: each is refused at its place, or imported with a
// remark.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <regex>

#include "tests/unit/importers/shadergraph/shadergraph_import.h"

namespace patina::importers {
namespace {

TEST(BrokenShaderGraph, BrokenFilesAreReportedAtTheirPlace) {
    const std::string good = painted().new_layout();
    EXPECT_TRUE(std::regex_search(import_shadergraph(good.substr(0, good.size() - 10)).error,
                                  std::regex("x\\.shadergraph:[0-9]+:[0-9]+: ")));
    EXPECT_NE(import_shadergraph("").error.find("the file is empty"), std::string::npos);
    EXPECT_NE(import_shadergraph("nonsense").error.find("x.shadergraph:1:1: "), std::string::npos);
    EXPECT_NE(import_shadergraph("\n{}").error.find("x.shadergraph:2:1: it is no shader graph"), std::string::npos);
    const std::string old = R"({"m_SerializableNodes":[]})";
    EXPECT_NE(import_shadergraph(old).error.find(":1:24: it has neither a master node"), std::string::npos);
    EXPECT_NE(import_shadergraph(old + "\n{}").error.find(":2:1: objects follow the graph"), std::string::npos);
    EXPECT_NE(import_shadergraph(good + "\n\n<<<<<<< HEAD\n").error.find("begins with '{'"), std::string::npos);
    std::string nan = good;
    nan.replace(nan.find("0.25"), 4, "NaN");
    EXPECT_TRUE(std::regex_search(import_shadergraph(nan).error, std::regex("x\\.shadergraph:[0-9]+:[0-9]+: ")))
        << import_shadergraph(nan).error;
    EXPECT_NE(import_shadergraph(std::string(5000, '{') + good).error, "");
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
    graph.edges.push_back({"a", 0, "mix", 99});
    graph.edges.push_back({"a", 0, "nobody", 1});
    const Imported made = import_graph(graph);
    EXPECT_TRUE(made.has_refused);
    const std::string refused = remarks(made, Remark::Kind::LeftOut);
    for (const char* each :
         {"edge from the node 'nobody' (slot 0) to 'Lerp' (S1): the node at its beginning does not exist\n",
          "edge from 'Property' (slot 99) to 'Lerp' (S1): the slot at its beginning does not exist\n",
          "edge from 'Property' (S0) to 'Lerp' (slot 99): the slot at its end does not exist\n",
          "edge from 'Property' (S0) to the node 'nobody' (slot 1): the node at its end does not exist\n"})
        EXPECT_NE(refused.find(each), std::string::npos) << each << "\n" << refused;
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("a second value for 'S1': the first one counts"),
              std::string::npos);
    EXPECT_NE(text_of(made).find("not imported: the node at its beginning does not exist"), std::string::npos)
        << text_of(made);
    expect_compiles(made, "missing");
}

// `text` with the first `from` replaced.
std::string with(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(BrokenShaderGraph, LostObjectsAreRefused) {
    // A constant that is seen stands for what reads them.
    const std::string text = painted().new_layout(), old = painted().old_layout();
    const std::pair<std::string, const char*> broken[] = {
        {with(text, R"("m_ObjectId":"product")", R"("m_ObjectId":"other")"),
         "a node: the file has no object 'product'\n"},
        {with(text, R"("m_ObjectId":"mix.2")", R"("m_ObjectId":"other")"),
         "node 'Lerp': the file does not have its slot 'mix.2' ("},
        {with(text, R"("m_ObjectId":"wear")", R"("m_ObjectId":"other")"),
         "a property: the file has no object 'wear'\n"},
        {with(text, R"("m_ObjectId":"wear")", R"("m_ObjectId":"other")"),
         "node 'Property': the graph does not have its property\n"},
        {with(text, R"("m_ObjectId":"BaseColor.0")", R"("m_ObjectId":"other")"),
         "block 'BaseColor': the file does not have its slot\n"},
        {with(old, R"(\"m_GuidSerialized\":\"product\")", R"(\"m_GuidSerialized\":product)"),
         "a node: its JSON cannot be read\n"},
        {with(old, R"(\"m_GuidSerialized\":\"product\")", R"(\"m_GuidSerialized\":product)"),
         "edge from the node 'product' (slot 2) to 'Lerp' (S0): the node at its beginning does not exist\n"},
        {with(old, R"(\\\"x\\\":0.5)", R"(\\\"x\\\":NaN)"), "node 'Lerp': the JSON of its slot cannot be read (1:"}};
    for (const auto& [file, reason] : broken) {
        const Imported made = import_shadergraph(file);
        EXPECT_TRUE(made.has_refused) << reason;
        EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find(reason), std::string::npos)
            << reason << "\n"
            << remarks(made, Remark::Kind::LeftOut) << made.error;
        expect_compiles(made, reason);
    }
}

// A value that is there and cannot be taken is said with its place, and with what is taken.
TEST(BrokenShaderGraph, WrongValuesAreSaid) {
    ShaderGraphText graph = painted();
    graph.target = R"("m_SurfaceType":1,"m_AlphaMode":0,"m_RenderFace":2,"m_ZTestMode":4)";
    graph.nodes.back().more = R"("m_DrawState":{"m_Position":{"x":1.0,"y":2.0}})";
    graph.properties.push_back({.id = "ramp",
                                .kind = "Gradient",
                                .name = "Ramp",
                                .value = R"({"m_Mode":0,"m_NumColorKeys":2,"m_NumAlphaKeys":2})"});
    const std::string text = graph.new_layout(), old = graph.old_layout();
    struct {
        const char *from, *to, *said;
    } const values[] = {
        {R"("m_Value":0.25)", R"("m_Value":"NaN")",
         R"(property 'Wear': .*'m_Value' \(\d+:\d+\) is "NaN", not a number: 0 is taken)"},
        {R"("m_Value":0.25)", R"("m_Value":null)", R"(property 'Wear': .*'m_Value' \(\d+:\d+\) is null, not a number)"},
        {R"("m_Value":0.25)", R"("m_Value":{"x":[]})", R"(property 'Wear': .* is an object, not a number: 0 is taken)"},
        {R"("m_Value":0.25)", R"("m_Value":1e308)", R"(property 'Wear': .* is 1e\+308, not a number of 32 bits)"},
        {R"("x":0.5,"y":0.5)", R"("x":[],"y":0.5)",
         R"(node 'Lerp': .*'m_Value.x' \(\d+:\d+\) is a list, not a number)"},
        {R"("m_RangeValues":{"x":0.0,"y":1.0})", R"("m_RangeValues":3)",
         R"(property 'Wear': .*'m_RangeValues' \(\d+:\d+\) is 3, not an object)"},
        {R"({"x":0.0,"y":1.0})", R"({"x":1.0,"y":0.0})",
         R"(property 'Wear': .*its range begins at 1 and ends at 0: it has none)"},
        {R"("m_FloatType":1)", R"("m_FloatType":7)",
         R"(property 'Wear': .* is 7, not a number from 0 to 3: 0 is taken)"},
        {R"("m_Value":0.25,"m_FloatType":1)", R"("m_Value":3e9,"m_FloatType":2)",
         R"(property 'Wear': .*its default is 3000000000, )"},
        {R"("m_SurfaceType":1)", R"("m_SurfaceType":"glass")",
         R"(setting 'Surface Type': 'opaque': 'm_SurfaceType' \(\d+:\d+\) is "glass", not a whole number: 0 is taken)"},
        {R"("m_SurfaceType":1)", R"("m_SurfaceType":17)",
         R"(setting 'Surface Type': .*is 17, not a number from 0 to 1: 0 is taken)"},
        {R"("m_AlphaMode":0)", R"("m_AlphaMode":9)",
         R"(setting 'Blending Mode': .*is 9, not a number from 0 to 3: 0 is taken)"},
        {R"("m_RenderFace":2)", R"("m_RenderFace":-1)",
         R"(setting 'Render Face': .*is -1, not a number from 0 to 2: 2 is taken)"},
        {R"("m_ZTestMode":4)", R"("m_ZTestMode":[])", R"('m_ZTestMode' \(\d+:\d+\) is a list, not a whole number)"},
        {R"("m_Mode":0)", R"("m_Mode":7)", R"(property 'Ramp': .*is 7, not a number from 0 to 2: 0 is taken)"},
        {R"("m_NumColorKeys":2)", R"("m_NumColorKeys":200)",
         R"(property 'Ramp': .*is 200, not a number from 1 to 8: 8 is taken)"},
        {R"({"x":1.0,"y":2.0})", R"({"x":1e308,"y":[]})",
         R"(node 'Lerp': .*m_Position.x' .* is 1e\+308, not .*m_Position.y' .* is a list)"},
        {R"("m_SlotType":0)", R"("m_SlotType":5)", R"(node 'Sample Texture 2D': .*is 5, not a number from 0 to 1)"}};
    for (const auto& each : values) {
        const Imported made = import_shadergraph(with(text, each.from, each.to));
        EXPECT_TRUE(std::regex_search(remarks(made, Remark::Kind::Changed), std::regex(each.said)))
            << each.to << "\n"
            << remarks(made, Remark::Kind::Changed) << made.error;
        EXPECT_FALSE(made.has_refused) << each.to;
        expect_compiles(made, each.to);
    }
    const Imported made = import_shadergraph(with(old, R"(\"m_AlphaMode\":0)", R"(\"m_AlphaMode\":9)"));
    EXPECT_TRUE(std::regex_search(remarks(made, Remark::Kind::Changed),
                                  std::regex(R"('m_AlphaMode' \(1:\d+\) is 9, not a number from 0 to 3)")))
        << remarks(made, Remark::Kind::Changed);
}

// Without its lists and ids, nothing of the graph is known.
TEST(BrokenShaderGraph, BrokenListsAndIdsAreErrors) {
    const std::string text = painted().new_layout(), old = painted().old_layout();
    const std::pair<std::string, const char*> broken[] = {
        {with(text, R"("m_Edges":[{)", R"("m_Edges":7,"more":[{)"), R"(:1:\d+: 'm_Edges' is 7, not a list)"},
        {with(text, R"("m_Nodes":[)", R"("m_Nodes":"x","more":[)"), R"(:1:\d+: 'm_Nodes' is "x", not a list)"},
        {with(text, R"("m_Nodes":[{"m_Id":"a"})", R"("m_Nodes":[5)"), R"(:1:\d+: 'a node' is 5, not a reference)"},
        {with(text, R"("m_Id":0,"m_DisplayName")", R"("m_Id":"four","m_DisplayName")"),
         R"(:\d+:\d+: 'm_Id' is "four", not a whole number)"},
        {with(text, R"("m_SlotId":0)", R"("m_SlotId":99999999999999999999)"),
         R"(SlotId' is 1e\+20, not a whole number)"},
        {with(old, R"("m_SerializableEdges":[)", R"("m_SerializableEdges":{},"more":[)"),
         R"(:1:\d+: 'm_SerializableEdges' is an object, not a list)"}};
    for (const auto& [file, said] : broken)
        EXPECT_TRUE(std::regex_search(import_shadergraph(file).error, std::regex(said)))
            << said << "\n"
            << import_shadergraph(file).error;
}

TEST(BrokenShaderGraph, NewerVersionsAreSaid) {
    ShaderGraphText graph = painted();
    graph.nodes.back().version = 7;
    const Imported made = import_shadergraph(with(graph.new_layout(), R"("m_SGVersion":3)", R"("m_SGVersion":9)"));
    const std::string changed = remarks(made, Remark::Kind::Changed);
    EXPECT_NE(changed.find("the file: it is of version 9; 3 is the newest that is known: read as that\n"),
              std::string::npos)
        << changed;
    EXPECT_NE(changed.find("it is of version 7; 0 is the newest that is known: read as that\n"), std::string::npos)
        << changed;
    EXPECT_EQ(remarks(import_graph(painted()), Remark::Kind::Changed), "");
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
         "line 1 of its code: expected a condition with fewer levels"},
        {R"(#if 1\nOut = A;)", "line 1 of its code: expected '#endif' after this, not the end of the file"},
        {R"(Out = A;\n#endif)", "line 2 of its code: expected '#if' before this, not '#endif'"},
        {R"(Out = A;\n#if UNITY_VERSION >= 202210\nOut = 1;\n#endif)",
         "line 2 of its code: expected a macro whose value is known here, or 'defined(...)', not 'UNITY_VERSION', in "
         "'#if UNITY_VERSION >= 202210'"},
        {R"(#if ENGINE_HAS(B)\nOut = A;\n#endif)",
         "line 1 of its code: expected a macro that is defined here, not 'ENGINE_HAS'"},
        {R"(\n\nOut = A;\n/* all that follows)", "line 4 of its code: expected '*/' after this"},
        {R"(Out = A;\n}\nvoid Other(out float Out) {\nOut = 1;)", "line 2 of its code: a '}' closes nothing"},
        {R"(Out = A;\nif (B > 1) {)", "line 2 of its code: expected '}', not the end of the file"},
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
                                                       {"LOOP", false},
                                                       {"ON || MODE < 0", true},
                                                       {"-1 < 0", true}};
    for (const auto& [condition, holds] : conditions) {
        const Imported made = import_graph(one_node(
            custom(fmt::format(
                R"(#define MODE TWO\n#define TWO 2\n#define ON 1\n#define LOOP BACK\n#define BACK LOOP\n#if {}\nOut = A * 7;\n#else\nOut = A;\n#endif)",
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

// What a refused node reads stays in the graph, so that its author can put a node of his own in its place.
TEST(BrokenShaderGraph, WhatARefusedNodeReadsIsKept) {
    ShaderGraphText graph = painted();
    graph.nodes.push_back(
        {.id = "u", .kind = "NodeOfTheFuture", .slots = {{0}, {1}, {2}, out(3)}, .name = "Future", .group = "g"});
    graph.nodes[4].group = "g";
    graph.more_of_graph = R"("m_GroupDatas":[{"m_Id":"g"}])";
    graph.more_objects =
        R"({"m_Type":"UnityEditor.ShaderGraph.GroupData","m_ObjectId":"g","m_Title":"Where all is mixed"})";
    graph.edges = {{"b", 0, "sample", 1}, {"sample", 0, "product", 0}, {"a", 0, "product", 1}, {"product", 2, "u", 0},
                   {"c", 0, "u", 1},      {"u", 3, "BaseColor"}};
    const Imported made = import_graph(graph);
    const std::string& text = text_of(made);
    EXPECT_NE(text.find("SampleTexture2D"), std::string::npos) << text;
    EXPECT_NE(text.find(R"({ "id": "multiply", "expr": "mainTex * $_Tint" })"), std::string::npos) << text;
    EXPECT_NE(text.find("It read S0 = multiply, S1 = $_Wear"), std::string::npos) << text;
    EXPECT_NE(text.find("// Where all is mixed"), std::string::npos) << text;
    EXPECT_NE(remarks(made, Remark::Kind::Taken).find("node 'Multiply': the node 'multiply'"), std::string::npos)
        << remarks(made, Remark::Kind::Taken);
    EXPECT_NE(remarks(made, Remark::Kind::Taken).find("node 'Lerp': nothing reads it"), std::string::npos);
    EXPECT_EQ(text.find("lerp"), std::string::npos) << text;
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
        const Imported made = import_shadergraph(text);
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

TEST(BrokenShaderGraph, AnOutputThatIsNotKnownIsSaid) {
    const Imported made =
        import_graph(one_node({.id = "it", .kind = "AbsoluteNode", .slots = {{0}, out(1), out(7)}}, 7));
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("its output 'S7' is none that this importer knows"),
              std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    expect_compiles(made, "an unknown output");
}

}  // namespace
}  // namespace patina::importers
