// Sampler states of shader graphs: nodes, properties, inputs of sub-graphs and parameters of custom functions.
#include "tests/unit/importers/shadergraph/shadergraph_import.h"

namespace patina::importers {
namespace {

SlotText picture() {
    return {.id = 1, .kind = "Texture2DInput", .more = R"("m_Texture":{})"};
}

NodeText sample(const std::string& id) {
    return {.id = id,
            .kind = "SampleTexture2DNode",
            .slots = {picture(), {.id = 2, .kind = "UV"}, {3, "SamplerState"}, out(0, "Vector4")},
            .name = "Sample"};
}

// One texture, read through its own sampler and through the one of a node.
ShaderGraphText through(const std::string& settings) {
    return {.properties = {{.id = "main",
                            .kind = "Texture2D",
                            .name = "MainTex",
                            .value = R"({"m_SerializedTexture":"","m_Guid":""})"}},
            .nodes = {{.id = "t", .kind = "PropertyNode", .slots = {out(0, "Texture2D")}, .property = "main"},
                      {.id = "s", .kind = "SamplerStateNode", .slots = {out(0, "SamplerState")}, .more = settings},
                      sample("a"),
                      sample("b"),
                      {.id = "sum", .kind = "AddNode", .slots = {{0}, {1}, out(2)}}},
            .edges = {{"t", 0, "a", 1},
                      {"t", 0, "b", 1},
                      {"s", 0, "b", 3},
                      {"a", 0, "sum", 0},
                      {"b", 0, "sum", 1},
                      {"sum", 2, "BaseColor"}}};
}

std::size_t count_of(const std::string& text, std::string_view part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(ShaderGraphSamplers, OfANodeAreNamedAtThePort) {
    const Imported made = import_graph(through(R"("m_filter":1,"m_wrap":1)"));
    EXPECT_EQ(count_of(text_of(made), "\"sampler\""), 1U) << text_of(made);
    EXPECT_NE(text_of(made).find(R"("sampler": "nearestClamp")"), std::string::npos) << text_of(made);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    EXPECT_NE(remarks(made, Remark::Kind::Taken).find("the sampler 'nearestClamp'"), std::string::npos)
        << remarks(made, Remark::Kind::Taken);
    expect_compiles(made, "a node");
}

struct State {
    const char *settings, *name, *difference;
};
constexpr State kStates[] = {
    {R"("m_filter":0,"m_wrap":0)", "trilinearRepeat", ""},
    {R"("m_filter":2,"m_wrap":2)", "trilinearMirror", ""},
    {R"("m_filter":1,"m_wrap":0,"m_aniso":3)", "nearestRepeat", ""},
    {R"("m_filter":0,"m_wrap":1,"m_aniso":2)", "anisotropic4Clamp", ""},
    {R"("m_filter":0,"m_wrap":1,"m_aniso":4)", "anisotropic16Clamp", ""},
    {R"("m_filter":0,"m_wrap":0,"m_aniso":1)", "anisotropic4Repeat", "its anisotropy is 4, not 2"},
    {R"("m_filter":0,"m_wrap":0,"m_aniso":3)", "anisotropic16Repeat", "its anisotropy is 16, not 8"},
    {R"("m_filter":1,"m_wrap":3)", "nearestMirror", "a texture is mirrored again and again, not once"},
};

TEST(ShaderGraphSamplers, HaveTheNearestName) {
    for (const State& state : kStates) {
        const Imported made = import_graph(through(state.settings));
        const std::string changed = remarks(made, Remark::Kind::Changed);
        EXPECT_NE(text_of(made).find(fmt::format(R"("sampler": "{}")", state.name)), std::string::npos)
            << state.settings << text_of(made);
        EXPECT_EQ(changed.empty(), std::string_view(state.difference).empty()) << state.settings << changed;
        EXPECT_NE(changed.find(state.difference), std::string::npos) << state.settings << changed;
        expect_compiles(made, state.settings);
    }
}

TEST(ShaderGraphSamplers, OfTheBlackboardAreProperties) {
    ShaderGraphText graph = through("");
    graph.properties.push_back(
        {.id = "how", .kind = "SamplerState", .name = "How", .value = R"({"m_filter":1,"m_wrap":2})"});
    graph.nodes[1] = {.id = "s", .kind = "PropertyNode", .slots = {out(0, "SamplerState")}, .property = "how"};
    const Imported made = import_graph(graph);
    EXPECT_NE(text_of(made).find(R"("type": "sampler", "default": "nearestMirror")"), std::string::npos)
        << text_of(made);
    EXPECT_NE(text_of(made).find(R"("sampler": "$)"), std::string::npos) << text_of(made);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    expect_compiles(made, "a property");
}

TEST(ShaderGraphSamplers, GoIntoSubGraphs) {
    ShaderGraphText sub = through("");
    sub.properties[0].more = R"("m_Guid":{"m_GuidSerialized":"guid-of-t"})";
    sub.properties.push_back({.id = "how",
                              .kind = "SamplerState",
                              .name = "How",
                              .value = R"({"m_filter":1,"m_wrap":1})",
                              .more = R"("m_Guid":{"m_GuidSerialized":"guid-of-s"})"});
    sub.nodes[1] = {.id = "s", .kind = "PropertyNode", .slots = {out(0, "SamplerState")}, .property = "how"};
    sub.edges.back() = {"sum", 2, "output", 1};
    sub.outputs = {{.id = 1, .kind = "Vector4", .name = "Result"}};
    const auto imported = [&](bool is_given) {
        ShaderGraphText graph{
            .nodes =
                {{.id = "s",
                  .kind = "SamplerStateNode",
                  .slots = {out(0, "SamplerState")},
                  .more = R"("m_filter":0,"m_wrap":2)"},
                 {.id = "sub",
                  .kind = "SubGraphNode",
                  .slots = {{.id = -1, .kind = "Texture2DInput", .more = R"("m_Texture":{})"},
                            {-2, "SamplerState"},
                            out(1, "Vector4")},
                  .more = fmt::format(
                      R"("m_SerializedSubGraph":"{{\"subGraph\":{{\"guid\":\"{}\"}}}}","m_PropertyGuids":["guid-of-t","guid-of-s"],"m_PropertyIds":[-1,-2])",
                      kGuid),
                  .name = "Twice"}},
            .edges = {{"sub", 1, "BaseColor"}}};
        if (is_given) graph.edges.push_back({"s", 0, "sub", -2});
        save_shader_graph("Twice.shadersubgraph", sub.new_layout(), kGuid);
        return import_graph(graph);
    };
    const Imported made = imported(true), left = imported(false);
    for (const Imported* each : {&made, &left}) {
        EXPECT_NE(text_of(*each, "Twice.subgraph.json").find(R"("type": "sampler", "default": "nearestClamp")"),
                  std::string::npos)
            << text_of(*each, "Twice.subgraph.json");
        EXPECT_EQ(remarks(*each, Remark::Kind::Changed), "");
        expect_compiles(*each, "a sub-graph");
    }
    EXPECT_NE(text_of(made).find(R"("how": "trilinearMirror")"), std::string::npos) << text_of(made);
    EXPECT_EQ(text_of(left).find("how"), std::string::npos) << text_of(left);
}

// The engine's coordinates count v from the bottom.
TEST(ShaderGraphSamplers, GoIntoCustomFunctions) {
    NodeText node = custom(R"(Out = SAMPLE_TEXTURE2D(T.tex, S.samplerstate, A.xy).rgb * B;)");
    node.slots.push_back({.id = 3, .kind = "Texture2DInput", .name = "T", .more = R"("m_Texture":{})"});
    node.slots.push_back({.id = 4, .kind = "SamplerState", .name = "S"});
    ShaderGraphText graph = one_node(node, 2);
    graph.nodes.push_back({.id = "s",
                           .kind = "SamplerStateNode",
                           .slots = {out(0, "SamplerState")},
                           .more = R"("m_filter":1,"m_wrap":0)"});
    const Imported open = import_graph(graph);
    graph.edges.push_back({"s", 0, "f", 4});
    const Imported made = import_graph(graph);
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    EXPECT_NE(text_of(made, "Glow.node.hlsl").find("Out = T.Sample(S, float2(0, 1) + float2(1, -1) * (A.xy)).rgb * B;"),
              std::string::npos)
        << text_of(made, "Glow.node.hlsl");
    EXPECT_NE(text_of(made).find(R"("S": "nearestRepeat")"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(open).find(R"("S": "trilinearRepeat")"), std::string::npos) << text_of(open);
    expect_compiles(made, "connected");
    expect_compiles(open, "open");
}

// A node of a sampler's name would hide it.
TEST(ShaderGraphSamplers, KeepTheirNames) {
    ShaderGraphText graph = through(R"("m_filter":1,"m_wrap":1)");
    graph.nodes[2].name = graph.nodes[3].name = "Nearest Clamp";
    const Imported made = import_graph(graph);
    EXPECT_EQ(text_of(made).find(R"("id": "nearestClamp")"), std::string::npos) << text_of(made);
    expect_compiles(made, "a name");
}

}  // namespace
}  // namespace patina::importers
