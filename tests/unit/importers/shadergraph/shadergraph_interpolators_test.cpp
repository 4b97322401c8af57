// Custom interpolators of a shader graph: blocks of its vertex context, which become nodes of the vertex stage.
#include "tests/unit/importers/shadergraph/shadergraph_import.h"

namespace patina::importers {
namespace {

TEST(ShaderGraphInterpolators, AreNodesOfTheVertexStage) {
    ShaderGraphText graph{
        .nodes = {{.id = "a", .kind = "PositionNode", .slots = {out(0, "Vector3")}, .more = R"("m_Space":0)"},
                  {.id = "read",
                   .kind = "CustomInterpolatorNode",
                   .slots = {out(0, "Vector3")},
                   .more = R"("customBlockNodeName":"Blend")"}},
        .edges = {{"a", 0, "Blend#3"}, {"read", 0, "BaseColor"}},
        .blocks = {{"VertexDescription.Blend#3", "Vector3"}, {"SurfaceDescription.BaseColor", "ColorRGB"}}};
    const Imported made = import_graph(graph);
    EXPECT_NE(text_of(made).find(R"({ "id": "blend", "expr": "@positionOS", "stage": "vertex" })"), std::string::npos)
        << text_of(made);
    expect_compiles(made, "interpolator");
}

// A vertex block and a colour that read the same kind of node.
ShaderGraphText interpolated(const std::string& block) {
    return {.nodes = {{.id = "p",
                       .kind = "PositionNode",
                       .slots = {out(0, "Vector3")},
                       .more = R"("m_Space":0,"m_PositionSource":1)"},
                      {.id = "i",
                       .kind = "CustomInterpolatorNode",
                       .slots = {out(0, "Vector3")},
                       .more = R"("customBlockNodeName":"Blend","serializedType":3)"}},
            .edges = {{"p", 0, block}, {"i", 0, "BaseColor"}},
            .blocks = {{"VertexDescription." + block, "Vector3"}, {"SurfaceDescription.BaseColor", "ColorRGB"}}};
}
TEST(ShaderGraphInterpolators, AQualifierIsSaid) {
    EXPECT_NE(remarks(import_graph(interpolated("Blend#3#nointerpolation")), Remark::Kind::Changed)
                  .find("its value is interpolated in the usual way, not as 'nointerpolation'"),
              std::string::npos);
    // In the vertex block the position is the one before displacement.
    ShaderGraphText graph = interpolated("Blend#3");
    EXPECT_EQ(remarks(import_graph(graph), Remark::Kind::Changed), "");
    graph.edges.back() = {"p", 0, "BaseColor"};
    EXPECT_NE(remarks(import_graph(graph), Remark::Kind::Changed).find("the position after the vertex block"),
              std::string::npos);
}

// Each is a node of its own, whatever it is called: names that the importer needs itself, that differ in spaces alone,
// or that have no letter which an id may have.
TEST(ShaderGraphInterpolators, OfAnyNameAreKept) {
    for (const auto& [first, second] :
         {std::pair{"UV", "uv1"}, {"My Val", "MyVal"}, {"\xe4\xbd\x8d", "\xe7\xbd\xae"}}) {
        SCOPED_TRACE(first);
        const auto read = [](std::string id, const char* name) {
            return NodeText{.id = std::move(id),
                            .kind = "CustomInterpolatorNode",
                            .slots = {out(0, "Vector3")},
                            .more = fmt::format(R"("customBlockNodeName":"{}","serializedType":3)", name)};
        };
        const std::string one = fmt::format("{}#3", first), two = fmt::format("{}#3", second);
        const ShaderGraphText graph{
            .nodes = {{.id = "p", .kind = "PositionNode", .slots = {out(0, "Vector3")}, .more = R"("m_Space":0)"},
                      {.id = "n", .kind = "NormalVectorNode", .slots = {out(0, "Vector3")}, .more = R"("m_Space":0)"},
                      read("a", first),
                      read("b", second),
                      {.id = "difference", .kind = "SubtractNode", .slots = {{0}, {1}, out(2)}}},
            .edges = {{"p", 0, one},
                      {"n", 0, two},
                      {"a", 0, "difference", 0},
                      {"b", 0, "difference", 1},
                      {"difference", 2, "BaseColor"}},
            .blocks = {{"VertexDescription." + one, "Vector3"},
                       {"VertexDescription." + two, "Vector3"},
                       {"SurfaceDescription.BaseColor", "ColorRGB"}}};
        const Imported made = import_graph(graph);
        EXPECT_EQ(made.error, "");
        EXPECT_EQ(remarks(made, Remark::Kind::Changed) + remarks(made, Remark::Kind::LeftOut), "");
        EXPECT_NE(text_of(made).find(R"("expr": "@positionOS", "stage": "vertex")"), std::string::npos)
            << text_of(made);
        EXPECT_NE(text_of(made).find(R"("expr": "@normalOS", "stage": "vertex")"), std::string::npos) << text_of(made);
        expect_compiles(made, "names");
    }
}

}  // namespace
}  // namespace patina::importers
