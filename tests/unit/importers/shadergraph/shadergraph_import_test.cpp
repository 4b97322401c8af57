// Shader graphs of Unity: what they become, in both layouts: values, keywords, sub-graphs, functions, and settings.
#include "tests/unit/importers/shadergraph/shadergraph_import.h"

#include <gtest/gtest.h>

#include <set>

#include "compiler/importers/terms.h"

namespace patina::importers {
namespace {

constexpr std::string_view kPainted = R"({
  "patina": 1,
  "kind": "material",
  "name": "x",
  "workflow": "unlit",
  "properties": [
    { "name": "_Tint", "type": "color", "default": "#ff8000", "label": "Tint" },
    { "name": "_MainTex", "type": "texture2d", "default": "white", "label": "MainTex" },
    { "name": "_Wear", "type": "float", "default": 0.25, "range": [0, 1], "label": "Wear" }
  ],
  "nodes": [
    { "id": "mainTex", "node": "SampleTexture2D", "in": { "texture": "$_MainTex" } }
  ],
  "surface": { "color": "= lerp(mainTex * $_Tint, 0.5, $_Wear).rgb" },
  "ui": { "nodes": { "mainTex": [0, 0] } }
}
)";

TEST(ShaderGraphImport, BothLayoutsBecomeTheSameGraph) {
    const Imported made = import_graph(painted());
    EXPECT_EQ(text_of(made), kPainted);
    EXPECT_EQ(text_of(import_shadergraph(painted().old_layout())), kPainted);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    EXPECT_FALSE(made.has_refused);
    expect_compiles(made, "painted");
    // It is as `patina fmt` leaves it.
    EXPECT_EQ(compiler().format("x.graph.json", text_of(made)).text, kPainted);
}

TEST(ShaderGraphImport, EachPartHasARemark) {
    const Imported made = import_graph(painted());
    std::multiset<std::string> parts;
    for (const Remark& each : made.remarks) parts.insert(each.part);
    for (const char* part : {"property 'Tint'", "property 'MainTex'", "property 'Wear'", "node 'Property' (Tint)",
                             "node 'Multiply'", "node 'Lerp'", "node 'Sample Texture 2D'", "block 'BaseColor'",
                             "setting 'Surface Type'", "target 'UniversalTarget'"})
        EXPECT_EQ(parts.count(part), 1u) << part;
    for (const Remark& each : made.remarks) {
        if (each.part == "node 'Multiply'") {
            EXPECT_GT(each.line, 1);
        }
    }
}

// --- values

std::string surface_of(const Imported& made) {
    const std::string& text = text_of(made);
    const std::size_t begin = text.find("\"surface\"");
    return begin == text.npos ? text : text.substr(begin, text.find('\n', begin) - begin);
}

// The smallest vector decides, and numbers fit it.
TEST(ShaderGraphImport, DynamicVectorsTakeTheSmallestOne) {
    ShaderGraphText graph{
        .nodes = {{.id = "a", .kind = "PositionNode", .slots = {out(0, "Vector3")}, .more = R"("m_Space":2)"},
                  {.id = "b", .kind = "UVNode", .slots = {out(0, "Vector4")}, .more = R"("m_OutputChannel":0)"},
                  {.id = "sum", .kind = "AddNode", .slots = {{0}, {1}, out(2)}}},
        .edges = {{"a", 0, "sum", 0}, {"b", 0, "sum", 1}, {"sum", 2, "BaseColor"}}};
    const Imported made = import_graph(graph);
    EXPECT_NE(surface_of(made).find("= @positionWS + float3(uv, 0)"), std::string::npos) << text_of(made);
    expect_compiles(made, "sum");
}

TEST(ShaderGraphImport, CoordinatesCountFromTheBottom) {
    const NodeText noise{.id = "n",
                         .kind = "NoiseNode",
                         .slots = {{.id = 0, .kind = "UV"}, {1, "Vector1", true, "5.0"}, out(2, "Vector1")},
                         .more = R"("m_HashType":0)",
                         .version = 1,
                         .name = "Simple Noise"};
    const Imported made = import_graph(one_node(noise, 2));
    EXPECT_NE(text_of(made).find(R"x("expr": "float2(@uv0.x, 1 - @uv0.y)")x"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find(R"("in": { "uv": "uv", "scale": 5 })"), std::string::npos) << text_of(made);
    expect_compiles(made, "noise");
}

TEST(ShaderGraphImport, ConversionsAreThoseOfEdges) {
    using namespace terms;
    const Term two = link("a", Type::Float2), four = link("b", Type::Float4), one = link("c", Type::Float),
               flag = link("d", Type::Bool);
    EXPECT_EQ(converted(two, Type::Float3).text(), "float3(a, 0)");
    EXPECT_EQ(converted(two, Type::Float4).text(), "float4(a, 0, 1)");
    EXPECT_EQ(converted(link("a", Type::Float3), Type::Float4).text(), "float4(a, 1)");
    EXPECT_EQ(converted(four, Type::Float2).text(), "b.xy");
    EXPECT_EQ(converted(one, Type::Float3).text(), "float3(c)");
    EXPECT_EQ(converted(one, Type::Float3, true).text(), "c");
    EXPECT_EQ(converted(flag, Type::Float).text(), "float(d)");
    EXPECT_EQ(converted(four, Type::Bool).text(), "b.x != 0");
    EXPECT_EQ(swizzled(converted(two, Type::Float4), "xy").text(), "a");
    EXPECT_EQ(swizzled(swizzled(four, "zyx"), "xz").text(), "b.zx");
    EXPECT_EQ(converted(link("t", Type::Texture2D), Type::Float).type, Type::None);
}

TEST(ShaderGraphImport, BracketsStandWhereTheyAreNeeded) {
    const auto chain = [](const char* outer, const char* inner) {
        ShaderGraphText graph{
            .properties = {{.id = "p", .kind = "Vector3", .name = "P", .value = R"({"x":1.0})"}},
            .nodes = {{.id = "a", .kind = "PropertyNode", .slots = {out(0, "Vector3")}, .property = "p"},
                      {.id = "in", .kind = inner, .slots = {{0}, {1}, out(2)}},
                      {.id = "out", .kind = outer, .slots = {{0}, {1}, out(2)}}},
            .edges = {{"a", 0, "in", 0},
                      {"a", 0, "in", 1},
                      {"a", 0, "out", 0},
                      {"in", 2, "out", 1},
                      {"out", 2, "BaseColor"}}};
        const Imported made = import_graph(graph);
        expect_compiles(made, outer);
        return surface_of(made);
    };
    EXPECT_NE(chain("SubtractNode", "SubtractNode").find("= $_P - ($_P - $_P)"), std::string::npos);
    EXPECT_NE(chain("DivideNode", "DivideNode").find("= $_P / ($_P / $_P)"), std::string::npos);
    EXPECT_NE(chain("AddNode", "DivideNode").find("= $_P + $_P / $_P"), std::string::npos);
    EXPECT_NE(chain("DivideNode", "AddNode").find("= $_P / ($_P + $_P)"), std::string::npos);
    EXPECT_NE(chain("MaximumNode", "AddNode").find("= max($_P, $_P + $_P)"), std::string::npos);
}

// --- graphs read as a person wrote them

ShaderGraphText position_into(NodeText node, int input, int output) {
    ShaderGraphText graph = one_node(std::move(node), output);
    graph.nodes.push_back({.id = "p", .kind = "PositionNode", .slots = {out(0, "Vector3")}, .more = R"("m_Space":2)"});
    graph.edges.push_back({"p", 0, graph.nodes[0].id, input});
    return graph;
}

TEST(ShaderGraphImport, WhatChangesNothingIsNotWritten) {
    const std::string zero = R"({"x":0.0,"y":0.0,"z":0.0,"w":0.0})", one = R"({"x":1.0,"y":1.0,"z":1.0,"w":1.0})",
                      matrix_one = R"({"e00":1.0,"e01":1.0,"e02":1.0,"e03":1.0})";
    const NodeText nodes[] = {
        {.id = "n", .kind = "AddNode", .slots = {{0}, {.id = 1, .value = zero}, out(2)}},
        {.id = "n", .kind = "SubtractNode", .slots = {{0}, {.id = 1, .value = zero}, out(2)}},
        {.id = "n", .kind = "DivideNode", .slots = {{0}, {.id = 1, .value = one}, out(2)}},
        {.id = "n",
         .kind = "MultiplyNode",
         .slots = {{0, "DynamicValue"},
                   {.id = 1, .kind = "DynamicValue", .value = matrix_one},
                   out(2, "DynamicValue")}},
        {.id = "n", .kind = "ChannelMaskNode", .slots = {{0}, out(2)}, .more = R"("m_ChannelMask":-1)"},
        {.id = "n", .kind = "PreviewNode", .slots = {{0}, out(2)}}};
    for (const NodeText& each : nodes) {
        NodeText node = each;
        const bool is_one_input = node.slots.size() == 2;
        if (is_one_input) node.slots[1].id = 1;
        const Imported made = import_graph(position_into(node, 0, is_one_input ? 1 : 2));
        EXPECT_NE(text_of(made).find(R"("color": "@positionWS")"), std::string::npos) << node.kind << text_of(made);
    }
    // But what subtracts or divides something is.
    const Imported other = import_graph(
        position_into({.id = "n", .kind = "SubtractNode", .slots = {{.id = 0, .value = zero}, {1}, out(2)}}, 1, 2));
    EXPECT_NE(text_of(other).find(R"("color": "= 0 - @positionWS")"), std::string::npos) << text_of(other);
}

TEST(ShaderGraphImport, InputsThatAreTheDefaultAreNotWritten) {
    const NodeText remap{.id = "n",
                         .kind = "RemapNode",
                         .slots = {{0},
                                   {.id = 1, .kind = "Vector2", .value = R"({"x":-1.0,"y":1.0})"},
                                   {.id = 2, .kind = "Vector2", .value = R"({"x":0.0,"y":2.0})"},
                                   out(3)}};
    const Imported made = import_graph(position_into(remap, 0, 3));
    EXPECT_NE(text_of(made).find(R"("in": { "value": "@positionWS", "outMax": 2 })"), std::string::npos)
        << text_of(made);
    expect_compiles(made, "remap");
}

TEST(ShaderGraphImport, ComponentsThatAreTogetherAgainAreASwizzle) {
    const auto combined = [](std::vector<int> order, int output) {
        ShaderGraphText graph{
            .properties = {{.id = "p", .kind = "Vector4", .name = "P", .value = R"({"x":1.0})"}},
            .nodes = {{.id = "a", .kind = "PropertyNode", .slots = {out(0, "Vector4")}, .property = "p"},
                      {.id = "s",
                       .kind = "SplitNode",
                       .slots = {{0}, out(1, "Vector1"), out(2, "Vector1"), out(3, "Vector1"), out(4, "Vector1")}},
                      {.id = "c",
                       .kind = "CombineNode",
                       .slots = {{0, "Vector1"},
                                 {1, "Vector1"},
                                 {2, "Vector1"},
                                 {3, "Vector1"},
                                 out(4, "Vector4"),
                                 out(5, "Vector3"),
                                 out(6, "Vector2")}}},
            .edges = {{"a", 0, "s", 0}, {"c", output, "BaseColor"}}};
        for (std::size_t i = 0; i < order.size(); ++i)
            if (order[i] > 0) graph.edges.push_back({"s", order[i], "c", static_cast<int>(i)});
        const Imported made = import_graph(graph);
        expect_compiles(made, "combined");
        return surface_of(made);
    };
    EXPECT_NE(combined({1, 2, 3}, 5).find(R"("$_P.xyz")"), std::string::npos) << combined({1, 2, 3}, 5);
    EXPECT_NE(combined({3, 2, 1}, 5).find(R"("$_P.zyx")"), std::string::npos);
    EXPECT_NE(combined({1, 2, 0}, 5).find(R"x("= float3($_P.xy, 0)")x"), std::string::npos) << combined({1, 2, 0}, 5);
}

TEST(ShaderGraphImport, ARedirectKeepsTheNameOfItsValue) {
    ShaderGraphText graph = painted();
    graph.nodes.push_back({.id = "r", .kind = "RedirectNodeData", .slots = {{0}, out(1)}, .name = "Redirect Node"});
    graph.nodes.push_back({.id = "sum", .kind = "AddNode", .slots = {{0}, {1}, out(2)}});
    graph.edges.back() = {"mix", 3, "r", 0};
    graph.edges.insert(graph.edges.end(), {{"r", 1, "sum", 0}, {"r", 1, "sum", 1}, {"sum", 2, "BaseColor"}});
    const Imported made = import_graph(graph);
    EXPECT_NE(text_of(made).find(R"("id": "lerp")"), std::string::npos) << text_of(made);
    EXPECT_EQ(text_of(made).find("redirect"), std::string::npos) << text_of(made);
}

TEST(ShaderGraphImport, HalfIsKept) {
    const Imported made = import_graph(
        position_into({.id = "n", .kind = "AbsoluteNode", .slots = {{0}, out(1)}, .more = R"("m_Precision":2)"}, 0, 1));
    EXPECT_NE(text_of(made).find(R"x({ "id": "absoluteNode", "expr": "abs(@positionWS)", "precision": "half" })x"),
              std::string::npos)
        << text_of(made);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
}

// --- textures

TEST(ShaderGraphImport, HowANormalIsSampledAndDecodedCombine) {
    const auto sampled = [](const char* settings) {
        const NodeText sample{.id = "n",
                              .kind = "SampleTexture2DNode",
                              .slots = {{.id = 1, .kind = "Texture2DInput", .more = R"("m_Texture":{})"},
                                        {.id = 2, .kind = "UV"},
                                        {3, "SamplerState"},
                                        {20, "Vector1", true, "3.0", "LOD"},
                                        {21, "Vector1", true, "-1.0", "Bias"},
                                        out(0, "Vector4")},
                              .more = settings,
                              .name = "Sample"};
        const Imported made = import_graph(one_node(sample, 0));
        EXPECT_FALSE(made.has_refused) << settings;
        expect_compiles(made, settings);
        return text_of(made);
    };
    const std::string level = sampled(R"("m_TextureType":1,"m_MipSamplingMode":1)"),
                      bias = sampled(R"("m_TextureType":1,"m_MipSamplingMode":3)"),
                      object = sampled(R"("m_TextureType":1,"m_NormalMapSpace":1,"m_MipSamplingMode":1)"),
                      plain = sampled(R"("m_TextureType":1,"m_MipSamplingMode":0)");
    EXPECT_NE(level.find(R"("node": "SampleTexture2DLevel")"), std::string::npos) << level;
    EXPECT_NE(level.find(R"("level": 3)"), std::string::npos) << level;
    EXPECT_NE(level.find(R"("node": "UnpackNormal")"), std::string::npos) << level;
    EXPECT_NE(bias.find(R"("bias": -1)"), std::string::npos) << bias;
    EXPECT_NE(bias.find(R"("node": "UnpackNormal")"), std::string::npos) << bias;
    EXPECT_NE(object.find(R"("level": 3)"), std::string::npos) << object;
    EXPECT_NE(object.find(".rgb * 2 - 1"), std::string::npos) << object;
    EXPECT_NE(object.find(R"("usage": "data")"), std::string::npos) << object;
    EXPECT_NE(plain.find(R"("node": "SampleNormalMap")"), std::string::npos) << plain;
    EXPECT_NE(plain.find(R"("usage": "normal")"), std::string::npos) << plain;
}

// Unity counts the rows of pixels from the bottom.
TEST(ShaderGraphImport, DitherCountsRowsFromTheBottom) {
    const Imported made =
        import_graph(one_node({.id = "n", .kind = "DitherNode", .slots = {{0}, {1, "ScreenPosition"}, out(2)}}, 2));
    EXPECT_NE(text_of(made).find("= float2(@fragCoord.x, @screenSize.y - @fragCoord.y)"), std::string::npos)
        << text_of(made);
}

// --- gradients and matrices

constexpr const char* kSunset =
    R"({"serializedVersion":"2","key0":{"r":1.0,"g":0.0,"b":0.0,"a":1.0},"key1":{"r":0.5,"g":0.5,"b":1.0,"a":0.25},"ctime0":0,"ctime1":65535,"atime0":0,"atime1":65535,"m_Mode":0,"m_NumColorKeys":2,"m_NumAlphaKeys":2})";

ShaderGraphText sunset(const std::string& value) {
    return {.properties = {{.id = "g", .kind = "Gradient", .name = "Sunset", .value = value}},
            .nodes = {{.id = "a", .kind = "PropertyNode", .slots = {out(0, "Gradient")}, .property = "g"},
                      {.id = "s",
                       .kind = "SampleGradient",
                       .slots = {{0, "GradientInput"}, {.id = 1, .kind = "Vector1", .value = "0.5"}, out(2, "Vector4")},
                       .name = "Sample Gradient"}},
            .edges = {{"a", 0, "s", 0}, {"s", 2, "BaseColor"}}};
}

TEST(ShaderGraphImport, GradientsAreProperties) {
    const Imported made = import_graph(sunset(kSunset));
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    EXPECT_NE(text_of(made).find(R"x("colors": [[0, [1, 0, 0]], [1, [0.5, 0.5, 1]]], "alphas": [[0, 1], [1, 0.25]])x"),
              std::string::npos)
        << text_of(made);
    EXPECT_NE(text_of(made).find(R"("in": { "gradient": "$_Sunset", "time": 0.5 })"), std::string::npos)
        << text_of(made);
    EXPECT_NE(surface_of(made).find("= SrgbToLinear(sampleGradient.rgb)"), std::string::npos) << surface_of(made);
    expect_compiles(made, "gradient");
    // Fixed: each colour begins one per cent late. Perceptual: the keys are linear, and so is what comes of them.
    std::string fixed = kSunset, perceptual = kSunset;
    fixed.replace(fixed.find("\"m_Mode\":0"), 10, "\"m_Mode\":1");
    perceptual.replace(perceptual.find("\"m_Mode\":0"), 10, "\"m_Mode\":2");
    EXPECT_NE(text_of(import_graph(sunset(fixed))).find(R"([[0.01, [1, 0, 0]], [1, [0.5, 0.5, 1]]])"),
              std::string::npos)
        << text_of(import_graph(sunset(fixed)));
    const std::string text = text_of(import_graph(sunset(perceptual)));
    EXPECT_NE(text.find("[1, [0.21404114, 0.21404114, 1]]"), std::string::npos) << text;
    EXPECT_NE(text.find(R"("color": "sampleGradient.rgb")"), std::string::npos) << text;
}

TEST(ShaderGraphImport, MatricesAreProperties) {
    const ShaderGraphText graph{
        .properties =
            {{.id = "m", .kind = "Matrix3", .name = "Turn", .value = R"({"e00":0.0,"e01":1.0,"e10":-1.0,"e22":1.0})"}},
        .nodes = {{.id = "a", .kind = "PropertyNode", .slots = {out(0, "Matrix3")}, .property = "m"},
                  {.id = "p", .kind = "PositionNode", .slots = {out(0, "Vector3")}, .more = R"("m_Space":2)"},
                  {.id = "n",
                   .kind = "MultiplyNode",
                   .slots = {{0, "DynamicValue"}, {1, "DynamicValue"}, out(2, "DynamicValue")}}},
        .edges = {{"a", 0, "n", 0}, {"p", 0, "n", 1}, {"n", 2, "BaseColor"}}};
    const Imported made = import_graph(graph);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    EXPECT_NE(text_of(made).find(R"("type": "float3x3", "default": [[0, 1, 0], [-1, 0, 0], [0, 0, 1]])"),
              std::string::npos)
        << text_of(made);
    EXPECT_NE(surface_of(made).find("= mul($_Turn, @positionWS)"), std::string::npos) << surface_of(made);
    expect_compiles(made, "matrix");
}

// --- keywords, sub-graphs, functions

TEST(ShaderGraphImport, ASampleIsCalledAsItsTextureIsShownIfUnityMadeTheOtherName) {
    ShaderGraphText graph = painted();
    graph.properties[1].name = "Main Texture";
    graph.properties[1].reference = "Texture2D_12AF58EE";
    EXPECT_NE(text_of(import_graph(graph)).find(R"("id": "mainTexture")"), std::string::npos)
        << text_of(import_graph(graph));
    graph.properties[1].reference = "_Wood";
    EXPECT_NE(text_of(import_graph(graph)).find(R"("id": "wood")"), std::string::npos) << text_of(import_graph(graph));
}

TEST(ShaderGraphImport, KeywordsAreVariants) {
    ShaderGraphText graph{
        .keywords =
            {{.id = "mud",
              .kind = "",
              .name = "Mud",
              .value = "1",
              .more = R"("m_KeywordType":0,"m_IsEditable":true)",
              .reference = "_MUD"},
             {.id = "q",
              .kind = "",
              .name = "Quality",
              .value = "1",
              .more =
                  R"("m_KeywordType":1,"m_IsEditable":true,"m_Entries":[{"id":4,"displayName":"Low","referenceName":"LOW"},{"id":7,"displayName":"As Built","referenceName":"HIGH"}])",
              .reference = "_QUALITY"}},
        .nodes = {{.id = "a",
                   .kind = "KeywordNode",
                   .slots = {out(0), {.id = 1, .value = R"({"x":1.0})"}, {.id = 2}},
                   .property = "mud"},
                  {.id = "b",
                   .kind = "KeywordNode",
                   .slots = {out(0), {.id = 4}, {.id = 7, .value = R"({"x":0.5})"}},
                   .property = "q"},
                  {.id = "sum", .kind = "AddNode", .slots = {{0}, {1}, out(2)}}},
        .edges = {{"a", 0, "sum", 0}, {"b", 0, "sum", 1}, {"sum", 2, "BaseColor"}}};
    const Imported made = import_graph(graph);
    EXPECT_NE(text_of(made).find(R"("name": "_MUD", "type": "bool", "default": true, "as": "variant")"),
              std::string::npos)
        << text_of(made);
    // Unity's symbols are made of the reference names. What an inspector shows is a help.
    EXPECT_NE(text_of(made).find(R"("values": ["LOW", "HIGH"])"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find(R"("help": "HIGH is As Built")"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find("$_QUALITY == LOW ? 0 : 0.5"), std::string::npos) << text_of(made);
    expect_compiles(made, "keywords");
    CompileOptions options;
    options.targets = compiler().targets("unity");
    const Result unity = compiler().compile_text("x.graph.json", text_of(made), options);
    bool has_symbol = false;
    for (const Shader& each : unity.shaders)
        has_symbol |= each.text.find("_QUALITY_LOW _QUALITY_HIGH") != std::string::npos;
    EXPECT_TRUE(has_symbol);
}

TEST(ShaderGraphImport, SubgraphsAreFoundByGuid) {
    save_shader_graph("Doubled.shadersubgraph", doubled().new_layout(), kGuid);
    const Imported made = import_graph(user(kGuid));
    EXPECT_NE(text_of(made).find(R"("node": "./Doubled.subgraph.json")"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find(R"("inValueConnected": true)"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find(R"("mode": 1)"), std::string::npos) << text_of(made);
    const std::string& sub = text_of(made, "Doubled.subgraph.json");
    EXPECT_NE(sub.find(R"("kind": "subgraph")"), std::string::npos);
    EXPECT_NE(sub.find("$mode == 0 ? $inValue : $inValue * 2"), std::string::npos) << sub;
    EXPECT_NE(sub.find("$inValueConnected ?"), std::string::npos) << sub;
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    // Its parts have its file and their places in it.
    std::size_t of_subgraph = 0;
    for (const Remark& each : made.remarks) {
        EXPECT_TRUE(each.file.empty() || (each.file == "Doubled.shadersubgraph" && each.line > 0)) << each.part;
        of_subgraph += !each.file.empty();
    }
    EXPECT_GE(of_subgraph, 5u);
    expect_compiles(made, "sub-graph");
    // Nothing is connected, so the branch for that case counts.
    const Imported open = import_graph(user(kGuid, false));
    EXPECT_EQ(text_of(open).find("inValueConnected"), std::string::npos) << text_of(open);
    expect_compiles(open, "open sub-graph");
}

TEST(ShaderGraphImport, InputsOfASubgraphThatHaveItsDefaultsAreLeftOut) {
    save_shader_graph("Doubled.shadersubgraph", doubled().new_layout(), kGuid);
    ShaderGraphText graph = user(kGuid, false);
    graph.nodes[1].slots[0].value = R"({"x":1.0,"y":2.0,"z":3.0})";
    EXPECT_EQ(text_of(import_graph(graph)).find("inValue"), std::string::npos) << text_of(import_graph(graph));
    graph.nodes[1].slots[0].value = R"({"x":1.0,"y":2.0,"z":3.5})";
    EXPECT_NE(text_of(import_graph(graph)).find(R"("inValue": [1, 2, 3.5], "mode": 1)"), std::string::npos)
        << text_of(import_graph(graph));
    graph.nodes[1].more.replace(graph.nodes[1].more.find("Twice"), 5, "Once");
    EXPECT_EQ(text_of(import_graph(graph)).find("mode"), std::string::npos) << text_of(import_graph(graph));
}

TEST(ShaderGraphImport, SubgraphsAreFoundByName) {
    save_shader_graph("Doubled.shadersubgraph", doubled().new_layout());
    const Imported made = import_graph(user(kGuid));
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("no file has its GUID"), std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    expect_compiles(made, "by name");
}

TEST(ShaderGraphImport, AMissingSubgraphIsRefusedAndSeen) {
    const Imported made = import_graph(user(kGuid));
    EXPECT_TRUE(made.has_refused);
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find(std::string("has the GUID ") + kGuid), std::string::npos);
    EXPECT_NE(text_of(made).find(R"x("expr": "float3(1, 0, 1)")x"), std::string::npos) << text_of(made);
    expect_compiles(made, "magenta");
}

TEST(ShaderGraphImport, ASubgraphThatUsesItselfIsRefused) {
    ShaderGraphText circle = user(kGuid);
    circle.edges = {{"sub", 1, "output", 1}};
    circle.outputs = {{.id = 1, .kind = "Vector3", .name = "Result"}};
    save_shader_graph("Doubled.shadersubgraph", circle.new_layout(), kGuid);
    const Imported made = import_graph(user(kGuid));
    EXPECT_EQ(made.error, "");
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find("uses itself"), std::string::npos);
}

// --- settings

TEST(ShaderGraphImport, SettingsBecomeTheRenderState) {
    struct Case {
        const char *target, *material, *expected;
    };
    const Case cases[] = {
        {R"("m_SurfaceType":0,"m_RenderFace":2)", "UniversalUnlitSubTarget", ""},
        {R"("m_SurfaceType":1,"m_AlphaMode":0)", "UniversalUnlitSubTarget", R"("surface": "fade")"},
        {R"("m_SurfaceType":1,"m_AlphaMode":1)", "UniversalUnlitSubTarget", R"("surface": "transparent")"},
        {R"("m_SurfaceType":1,"m_AlphaMode":2)", "UniversalUnlitSubTarget", R"("surface": "additive")"},
        {R"("m_SurfaceType":1,"m_AlphaMode":3)", "UniversalUnlitSubTarget", R"("surface": "multiply")"},
        {R"("m_AlphaClip":true)", "UniversalUnlitSubTarget", R"("surface": "cutout")"},
        {R"("m_RenderFace":0)", "UniversalUnlitSubTarget", R"("cull": "off")"},
        {R"("m_RenderFace":1)", "UniversalUnlitSubTarget", R"("cull": "front")"},
        {R"("m_TwoSided":true)", "UniversalUnlitSubTarget", R"("cull": "off")"},
        {R"("m_ZWriteControl":2)", "UniversalUnlitSubTarget", R"("depthWrite": false)"},
        {R"("m_ZTestMode":8)", "UniversalUnlitSubTarget", R"("depthTest": "always")"},
        {R"("m_SurfaceType":0)", "UniversalSpriteUnlitSubTarget", R"("surface": "fade", "cull": "off")"},
    };
    for (const Case& each : cases) {
        ShaderGraphText graph = painted();
        graph.target = each.target;
        graph.material = each.material;
        const Imported made = import_graph(graph);
        const std::string text = text_of(made);
        const std::string expected = each.expected;
        EXPECT_NE(text.find(expected), std::string::npos) << each.target << text;
        EXPECT_EQ(text.find("\"render\"") == std::string::npos, expected.empty()) << text;
        expect_compiles(made, each.target);
    }
}

// A graph whose materials choose the kind of the surface has the inputs of all kinds.
TEST(ShaderGraphImport, MaterialsChangeTheSettings) {
    struct Case {
        const char *target, *material, *expected, *lost;
    };
    const std::string lost_of_lit = "materials cannot change the workflow, nor reject shadows";
    const Case cases[] = {
        {R"("m_SurfaceType":0)", "UniversalUnlitSubTarget", R"({ "materialOverride": true })", ""},
        {R"("m_SurfaceType":1,"m_AlphaMode":2,"m_RenderFace":1,"m_ZWriteControl":1,"m_ZTestMode":8)",
         "UniversalUnlitSubTarget",
         R"({
    "surface": "additive",
    "cull": "front",
    "depthWrite": true,
    "depthTest": "always",
    "materialOverride": true
  })",
         "alpha changes the colour, whichever blending a material chooses"},
        {R"("m_AlphaClip":true)", "BuiltInLitSubTarget", R"({ "surface": "cutout", "materialOverride": true })", ""},
        {R"("m_SurfaceType":1)", "UniversalLitSubTarget", R"({ "surface": "fade", "materialOverride": true })",
         lost_of_lit.c_str()},
        {R"("m_SurfaceType":1,"m_AlphaClip":true)", "UniversalUnlitSubTarget",
         R"({ "surface": "fade", "materialOverride": true })", "materials cannot turn off alpha clipping"},
        {R"("m_SurfaceType":0)", "UniversalSpriteUnlitSubTarget", R"({ "surface": "fade", "cull": "off" })",
         "materials cannot change the graph's settings"},
    };
    for (const Case& each : cases) {
        ShaderGraphText graph = painted();
        graph.target = std::string(R"("m_AllowMaterialOverride":true,)") + each.target;
        graph.material = each.material;
        graph.blocks.push_back({"SurfaceDescription.Alpha", "Vector1", "0.75"});
        graph.blocks.push_back({"SurfaceDescription.AlphaClipThreshold", "Vector1", "0.25"});
        std::string source = graph.new_layout();
        const std::string target = "UniversalTarget";
        if (graph.material.starts_with("BuiltIn")) source.replace(source.find(target), target.size(), "BuiltInTarget");
        const Imported made = import_shadergraph(source);
        const std::string text = text_of(made), lost = each.lost;
        EXPECT_NE(text.find(std::string(R"("render": )") + each.expected), std::string::npos) << each.target << text;
        const std::string changed = remarks(made, Remark::Kind::Changed);
        EXPECT_EQ(changed.find("Allow Material Override") == changed.npos, lost.empty()) << changed;
        EXPECT_NE(changed.find(lost), std::string::npos) << changed;
        if (text.find("materialOverride") != std::string::npos) {
            EXPECT_NE(text.find(R"("alphaClip": 0.25)"), std::string::npos) << text;
            EXPECT_NE(text.find("0.75"), std::string::npos) << text;
        }
        expect_compiles(made, each.target);
    }
}

TEST(ShaderGraphImport, LitMaterialsTakeTheirWorkflow) {
    ShaderGraphText graph = painted();
    graph.material = "UniversalLitSubTarget";
    graph.blocks.push_back({"SurfaceDescription.Metallic", "Vector1", "1.0"});
    graph.blocks.push_back({"SurfaceDescription.Smoothness", "Vector1", "0.75"});
    graph.blocks.push_back({"SurfaceDescription.Specular", "ColorRGB"});
    graph.blocks.push_back({"SurfaceDescription.Occlusion", "Vector1", "1.0"});
    Imported made = import_graph(graph);
    EXPECT_NE(text_of(made).find(R"("workflow": "metallic-smoothness")"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find(R"("metallic": 1)"), std::string::npos) << text_of(made);
    EXPECT_EQ(text_of(made).find("occlusion"), std::string::npos) << "its default is not written";
    EXPECT_EQ(text_of(made).find("specular\":"), std::string::npos) << "the target does not have it";
    expect_compiles(made, "lit");
    graph.material_settings = R"("m_WorkflowMode":0)";
    made = import_graph(graph);
    EXPECT_NE(text_of(made).find(R"("workflow": "specular-glossiness")"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find(R"("glossiness": 0.75)"), std::string::npos) << text_of(made);
    expect_compiles(made, "specular");
}

// The high-definition target has blocks that no workflow has.
TEST(ShaderGraphImport, BlocksWithoutAnInputAreSaid) {
    std::string text = painted().new_layout();
    for (const auto& [from, to] : {std::pair<std::string, std::string>{"UniversalTarget", "HDTarget"},
                                   {"UniversalUnlitSubTarget", "HDLitSubTarget"}})
        for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
            text.replace(at, from.size(), to);
    for (std::size_t at = 0; (at = text.find("SurfaceDescription.BaseColor", at)) != text.npos; at += 10)
        text.replace(at, 28, "SurfaceDescription.BentNormal");
    const Imported made = import_shadergraph(text);
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("block 'BentNormal': the workflow has no such input"),
              std::string::npos)
        << remarks(made, Remark::Kind::Changed) << remarks(made, Remark::Kind::Taken);
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("the workflow 'metallic-smoothness'"), std::string::npos);
}

TEST(ShaderGraphImport, GroupsAndNotesAreKept) {
    ShaderGraphText graph = painted();
    graph.nodes[3].group = "g";
    graph.more_of_graph = R"("m_GroupDatas":[{"m_Id":"g"}],"m_StickyNoteDatas":[{"m_Id":"n"}])";
    graph.more_objects = R"x(

{"m_SGVersion":0,"m_Type":"UnityEditor.ShaderGraph.GroupData","m_ObjectId":"g","m_Title":"Paint"}

{"m_SGVersion":0,"m_Type":"UnityEditor.ShaderGraph.StickyNoteData","m_ObjectId":"n","m_Title":"Careful","m_Content":"wet","m_Position":{"x":1.0,"y":2.0,"width":30.0,"height":40.0}})x";
    const Imported made = import_graph(graph);
    EXPECT_NE(text_of(made).find("// Paint\n"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find(R"({ "title": "Paint", "nodes": ["mainTex"] })"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find(R"("title": "Careful", "text": "wet", "at": [1, 2], "size": [30, 40])"),
              std::string::npos)
        << text_of(made);
    expect_compiles(made, "notes");
}

TEST(ShaderGraphImport, AnEntryThatADropdownDoesNotHaveIsSaid) {
    save_shader_graph("Doubled.shadersubgraph", doubled().new_layout(), kGuid);
    ShaderGraphText graph = user(kGuid);
    std::string& node = graph.nodes[1].more;
    node.replace(node.find("Twice"), 5, "Nope");
    const Imported made = import_graph(graph);
    EXPECT_NE(remarks(made, Remark::Kind::Changed)
                  .find("the dropdown 'mode' of the sub-graph has no entry 'Nope': it keeps its default"),
              std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    EXPECT_EQ(remarks(import_graph(user(kGuid)), Remark::Kind::Changed), "");
    expect_compiles(made, "no such entry");
}

}  // namespace
}  // namespace patina::importers
