// What the blackboard of a shader graph says of its properties beside their types.
#include "tests/unit/importers/shadergraph/shadergraph_import.h"

namespace patina::importers {
namespace {

// A graph whose colour is the sum of the properties.
ShaderGraphText sum_of(std::vector<PropertyText> properties) {
    ShaderGraphText graph{.properties = std::move(properties)};
    std::string last;
    for (const PropertyText& each : graph.properties) {
        graph.nodes.push_back({.id = "p" + each.id,
                               .kind = "PropertyNode",
                               .slots = {out(0, each.kind == "Color" ? "Vector4" : each.kind)},
                               .property = each.id});
        const std::string sum = "s" + each.id;
        graph.nodes.push_back({.id = sum, .kind = "AddNode", .slots = {{0}, {1}, out(2)}});
        graph.edges.push_back({"p" + each.id, 0, sum, 0});
        if (!last.empty()) graph.edges.push_back({last, 2, sum, 1});
        last = sum;
    }
    graph.edges.push_back({last, 2, "BaseColor"});
    return graph;
}
PropertyText number_with(const std::string& more, const std::string& value = "0.25") {
    return {.id = "n", .kind = "Vector1", .name = "Wear", .value = value, .more = more};
}
Imported import_number(const std::string& more, const std::string& value = "0.25") {
    return import_graph(sum_of({number_with(more, value)}));
}

bool has(const Imported& made, const std::string& part) {
    return text_of(made).find(part) != std::string::npos;
}
bool says(const Imported& made, Remark::Kind kind, const std::string& part) {
    return remarks(made, kind).find(part) != std::string::npos;
}

TEST(ShaderGraphProperties, MayHaveAValueForEachInstance) {
    const Imported made = import_number(R"("overrideHLSLDeclaration":true,"hlslDeclarationOverride":3)");
    EXPECT_TRUE(has(made, R"("default": 0.25, "as": "instance")")) << text_of(made);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    EXPECT_TRUE(has(import_number(R"("m_GPUInstanced":true)"), R"("as": "instance")"));
    // Without the override, the number counts for nothing.
    EXPECT_FALSE(has(import_number(R"("overrideHLSLDeclaration":false,"hlslDeclarationOverride":3)"), "instance"));
    expect_compiles(made, "a number for each instance");
}

TEST(ShaderGraphProperties, OfATextureAreTheSameForAllInstances) {
    const Imported made =
        import_graph({.properties = {{.id = "t",
                                      .kind = "Texture2D",
                                      .name = "T",
                                      .value = "{}",
                                      .more = R"("overrideHLSLDeclaration":true,"hlslDeclarationOverride":3)"}}});
    EXPECT_TRUE(
        says(made, Remark::Kind::Changed, "property 'T': the property '_T': it has one value for all instances"))
        << remarks(made, Remark::Kind::Changed);
}

TEST(ShaderGraphProperties, ThatScriptsSetAreSaid) {
    EXPECT_TRUE(says(import_number(R"("overrideHLSLDeclaration":true,"hlslDeclarationOverride":1)"),
                     Remark::Kind::Changed, "it has one value for all materials"));
    EXPECT_TRUE(says(import_number(R"("overrideHLSLDeclaration":true,"hlslDeclarationOverride":0)"),
                     Remark::Kind::Changed, "the project's own code declares it"));
    EXPECT_TRUE(says(import_number(R"("m_GeneratePropertyBlock":false)"), Remark::Kind::Changed, "it is not exposed"));
    const Imported hidden = import_number(R"("m_GeneratePropertyBlock":true,"m_Hidden":true)");
    EXPECT_TRUE(says(hidden, Remark::Kind::Changed, "inspectors show it here, and do not in the engine"));
    const Imported picture = import_graph(sum_of({{.id = "t",
                                                   .kind = "Texture2D",
                                                   .name = "T",
                                                   .value = "{}",
                                                   .more = R"("m_GeneratePropertyBlock":true,"m_Hidden":true)"}}));
    EXPECT_TRUE(says(picture, Remark::Kind::Changed, "inspectors show it here, and do not in the engine"));
}

TEST(ShaderGraphProperties, SlidersOfWholeNumbersAreWhole) {
    const Imported made = import_number(R"("m_FloatType":1,"m_SliderType":2,"m_RangeValues":{"x":1.0,"y":8.0})", "3.0");
    EXPECT_TRUE(has(made, R"("type": "int", "default": 3, "range": [1, 8])")) << text_of(made);
    EXPECT_TRUE(has(made, "float($_Wear)")) << text_of(made);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    expect_compiles(made, "a whole number");
    EXPECT_TRUE(has(import_number(R"("m_FloatType":1,"m_SliderType":0,"m_RangeValues":{"x":1.0,"y":8.0})", "3.0"),
                    R"("type": "float", "default": 3, "range": [1, 8])"));
}

// An input of a sub-graph takes whatever number is connected.
TEST(ShaderGraphProperties, OfASubgraphThatAreWholeTakeAnyNumber) {
    ShaderGraphText inner = doubled();
    inner.properties[0].kind = "Vector1";
    inner.properties[0].value = "1.0";
    inner.properties[0].more += R"(,"m_FloatType":1,"m_SliderType":2,"m_RangeValues":{"x":0.0,"y":4.0})";
    save_shader_graph("Doubled.shadersubgraph", inner.new_layout(), kGuid);
    const Imported made = import_graph(user(kGuid));
    EXPECT_EQ(remarks(made, Remark::Kind::LeftOut), "");
    expect_compiles(made, "a whole input");
}

TEST(ShaderGraphProperties, OutsideOfTheirRangeAreSaid) {
    const Imported made = import_number(R"("m_FloatType":1,"m_RangeValues":{"x":0.0,"y":1.0})", "5.0");
    EXPECT_TRUE(has(made, R"("range": [0, 5])")) << text_of(made);
    EXPECT_TRUE(says(made, Remark::Kind::Changed, "its default 5 is outside of its range, 0 to 1"));
}

TEST(ShaderGraphProperties, ThatAreRenamedAreOnePart) {
    ShaderGraphText graph = sum_of({number_with("\"m_FloatType\":0")});
    for (const char* kind : {"Vector1", "Texture2D"}) {
        graph.properties[0].reference = "int";
        graph.properties[0].kind = kind;
        const Imported made = import_graph(graph);
        EXPECT_TRUE(says(made, Remark::Kind::Changed, "property 'Wear': the property 'intValue': the shader calls it"));
        EXPECT_FALSE(says(made, Remark::Kind::Taken, "property 'Wear'")) << kind;
    }
}

TEST(ShaderGraphProperties, OfAListKeepItsWords) {
    const Imported made =
        import_number(R"("m_FloatType":3,"m_EnumType":0,"m_EnumNames":["Low","High"],"m_EnumValues":[0,5])", "5.0");
    EXPECT_TRUE(has(made, R"("help": "0 is Low, 5 is High")")) << text_of(made);
    EXPECT_TRUE(says(made, Remark::Kind::Changed, "its help has the words of its list"));
    EXPECT_TRUE(says(import_number(R"("m_FloatType":3,"m_EnumType":1)"), Remark::Kind::Changed, "without the words"));
}

// --- keywords

PropertyText keyword_with(const std::string& more) {
    return {.id = "k",
            .kind = "",
            .name = "Wet",
            .value = "1",
            .more = R"("m_KeywordType":0,"m_IsEditable":true,)" + more,
            .reference = "_WET"};
}
// A keyword that chooses between 0.25 and 0.75 for these blocks.
Imported import_keyword(const std::string& more, const std::vector<std::string>& blocks) {
    ShaderGraphText graph{
        .keywords = {keyword_with(more)},
        .nodes = {{.id = "n",
                   .kind = "KeywordNode",
                   .slots = {out(0),
                             {.id = 1, .value = R"({"x":0.25,"y":0.25,"z":0.25,"w":0.25})"},
                             {.id = 2, .value = R"({"x":0.75,"y":0.75,"z":0.75,"w":0.75})"}},
                   .name = "Keyword",
                   .property = "k"}},
        .blocks = {{"VertexDescription.Position", "Position"}, {"SurfaceDescription.BaseColor", "ColorRGB"}}};
    for (const std::string& block : blocks) graph.edges.push_back({"n", 0, block});
    return import_graph(graph);
}

TEST(ShaderGraphProperties, KeywordsAreOffInOtherStages) {
    const std::string fragment = R"("m_KeywordStages":2)", vertex = R"("m_KeywordStages":1)";
    const Imported off = import_keyword(fragment, {"Position"});
    EXPECT_TRUE(has(off, R"j("positionOS": 0.75)j")) << text_of(off);
    EXPECT_TRUE(has(import_keyword(vertex, {"BaseColor"}), R"j("color": 0.75)j"));
    EXPECT_EQ(remarks(off, Remark::Kind::Changed), "");
    expect_compiles(off, "a keyword that is off");
    // It cannot be both: one node gives its value to both stages.
    const Imported both = import_keyword(fragment, {"Position", "BaseColor"});
    EXPECT_TRUE(says(both, Remark::Kind::Changed, "node 'Keyword' (Wet): ")) << remarks(both, Remark::Kind::Changed);
    EXPECT_TRUE(says(both, Remark::Kind::Changed, "the vertex stage, too, has the keyword"));
    EXPECT_TRUE(
        says(import_keyword(vertex, {"Position", "BaseColor"}), Remark::Kind::Changed, "the fragment stage, too"));
    for (const char* stages : {"\"m_KeywordStages\":63", "\"m_KeywordStages\":3", "\"m_KeywordScope\":0"}) {
        const Imported all = import_keyword(stages, {"Position", "BaseColor"});
        EXPECT_TRUE(has(all, "$_WET ? ")) << text_of(all);
        EXPECT_EQ(remarks(all, Remark::Kind::Changed), "");
    }
    EXPECT_TRUE(has(import_keyword(fragment, {"BaseColor"}), "$_WET ? "));
}

TEST(ShaderGraphProperties, KeywordsSayWhoSetsThem) {
    const std::string hidden = R"("m_GeneratePropertyBlock":false)";
    const Imported engine = import_keyword(R"("m_KeywordDefinition":2,)" + hidden, {"BaseColor"});
    EXPECT_TRUE(says(engine, Remark::Kind::Changed, "the engine sets it; here it is a variant with a default\n"))
        << remarks(engine, Remark::Kind::Changed);
    EXPECT_FALSE(says(engine, Remark::Kind::Changed, "scripts"));
    EXPECT_TRUE(says(import_keyword(R"("m_KeywordDefinition":1,)" + hidden, {"BaseColor"}), Remark::Kind::Changed,
                     "it is not exposed: scripts or the engine set it"));
}

TEST(ShaderGraphProperties, KeysBeyondTheEighthAreSaid) {
    for (const int count : {8, 10}) {
        std::string keys;
        for (int i = 0; i < count; ++i)
            keys += fmt::format(R"({}{{"x":1.0,"y":0.0,"z":0.0,"w":{}}})", i == 0 ? "" : ",", i / 10.0);
        ShaderGraphText graph{.nodes = {{.id = "g",
                                         .kind = "GradientNode",
                                         .slots = {out(0, "Gradient")},
                                         .more = fmt::format(R"("m_SerializableColorKeys":[{}])", keys)},
                                        {.id = "s",
                                         .kind = "SampleGradient",
                                         .slots = {{.id = 0, .kind = "GradientInput", .value = "{}"},
                                                   {.id = 1, .kind = "Vector1", .value = "0.5"},
                                                   out(2, "Vector4")}}},
                              .edges = {{"g", 0, "s", 0}, {"s", 2, "BaseColor"}}};
        EXPECT_EQ(says(import_graph(graph), Remark::Kind::Changed, "it has 10 keys"), count == 10);
    }
}

TEST(ShaderGraphProperties, TheGraphMayBeComputedInHalf) {
    ShaderGraphText graph = painted();
    graph.more_of_graph = R"("m_GraphPrecision":2)";
    graph.nodes[4].more = R"("m_Precision":1)";
    const Imported made = import_graph(graph);
    EXPECT_TRUE(has(made, "\n  \"precision\": \"half\"")) << text_of(made);
    EXPECT_TRUE(has(made, R"("precision": "float" })")) << text_of(made);
    EXPECT_TRUE(says(made, Remark::Kind::Taken, "'Graph Precision'"));
    expect_compiles(made, "a graph in half");

    graph.more_of_graph = R"("m_GraphPrecision":1)";
    EXPECT_FALSE(has(import_graph(graph), "precision"));
    graph.more_of_graph = R"("m_ConcretePrecision":1)";
    EXPECT_TRUE(has(import_graph(graph), R"("precision": "half")"));
}

}  // namespace
}  // namespace patina::importers
