// What a shader graph leaves unsaid, or said in an older version of a node; and textures without their tiling.
#include <cmath>
#include <map>

#include "runtime/picture/image.h"
#include "runtime/render/render_request.h"
#include "tests/unit/importers/shadergraph_import.h"

namespace patina::importers {
namespace {

// --- a texture apart from its tiling

constexpr int kSide = 4;
double decoded(int byte) {
    const double value = byte / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}
// Each texel has a colour of its own; rows count from the top.
std::array<int, 3> texel(int column, int row) {
    static constexpr int kGreen[] = {0, 64, 128, 255};
    return {column & 1 ? 255 : 0, kGreen[row], column & 2 ? 255 : 0};
}

// The texture, its transform apart, and put together again as its author does; or the texture as it is.
ShaderGraphText tiled(double u, double v, bool is_split, const std::string& sampling = "SampleTexture2DNode") {
    const auto number = [](int id, double value) {
        return SlotText{.id = id, .kind = "Vector1", .value = fmt::format("{}", value)};
    };
    ShaderGraphText graph{
        .properties =
            {{.id = "p",
              .kind = "Texture2D",
              .name = "Albedo",
              .value = fmt::format(
                  R"({{"m_SerializedTexture":"{{\"texture\":{{\"fileID\":2800000,\"guid\":\"{}\"}}}}","m_Guid":""}})",
                  kGuid),
              .more = R"("useTilingAndOffset":true)"}},
        .nodes = {{.id = "t", .kind = "PropertyNode", .slots = {out(0, "Texture2D")}, .property = "p"},
                  {.id = "at", .kind = "Vector2Node", .slots = {number(1, u), number(2, v), out(0, "Vector2")}},
                  {.id = "split",
                   .kind = "SplitTextureTransformNode",
                   .slots = {{0, "Texture2DInput"}, out(1, "Vector2"), out(2, "Vector2"), out(3, "Texture2D")}},
                  {.id = "place",
                   .kind = "TilingAndOffsetNode",
                   .slots = {{.id = 0, .kind = "UV"}, {1, "Vector2"}, {2, "Vector2"}, out(3, "Vector2")}},
                  {.id = "s",
                   .kind = "SamplerStateNode",
                   .slots = {out(0, "SamplerState")},
                   .more = R"("m_filter":1,"m_wrap":0)"},
                  {.id = "read",
                   .kind = sampling,
                   .slots = {{.id = 1, .kind = "Texture2DInput", .more = R"("m_Texture":{})"},
                             {.id = 2, .kind = "UV"},
                             {3, "SamplerState"},
                             number(4, 0),
                             out(0, "Vector4")}}},
        .edges = {{"t", 0, "split", 0}, {"s", 0, "read", 3}, {"read", 0, "BaseColor"}}};
    if (is_split)
        for (const EdgeText& each :
             {EdgeText{"at", 0, "place", 0}, EdgeText{"split", 1, "place", 1}, EdgeText{"split", 2, "place", 2},
              EdgeText{"place", 3, "read", 2}, EdgeText{"split", 3, "read", 1}})
            graph.edges.push_back(each);
    else
        for (const EdgeText& each : {EdgeText{"at", 0, "read", 2}, EdgeText{"t", 0, "read", 1}})
            graph.edges.push_back(each);
    return graph;
}

std::array<float, 4> drawn(const Imported& made, const std::string& tiling) {
    const std::string graph = save_shader_graph("x.graph.json", text_of(made));
    runtime::RenderRequest request{
        .graph = graph, .size = 8, .samples = 1, .overrides = {{"_Albedo_ST", tiling}}, .options = {.via = "cpu"}};
    runtime::RenderMachine machine;
    const runtime::RenderOutcome outcome = runtime::render(compiler(), request, machine);
    for (const Diagnostic& each : outcome.diagnostics) ADD_FAILURE() << to_text(each);
    EXPECT_EQ(outcome.error, "");
    if (!outcome.ok) return {};
    const auto pixel = outcome.image.at(4, 4);
    return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

// The engine counts v from the bottom, and adds the offset there.
TEST(ShaderGraphTiling, ATextureApartFromItsTransformIsReadWhereTheEngineReadsIt) {
    runtime::Image image = runtime::make_image(kSide, kSide);
    image.bits = 8;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            for (std::size_t c = 0; c < 3; ++c) image.at(x, y)[c] = static_cast<float>(texel(x, y)[c]) / 255;
    save_shader_graph("albedo.png", runtime::encode_png_as_is(image).value, kGuid);
    const double scale[] = {1.5, 2}, offset[] = {0.1, 0.15};
    // As an imported material has it.
    const std::string tiling = fmt::format("{},{},{},{}", scale[0], scale[1], offset[0], 1 - scale[1] - offset[1]);
    for (const auto& [u, v] : std::map<double, double>{{0.3, 0.4}, {0.8, 0.1}, {0.05, 0.9}, {0.65, 0.6}}) {
        const double place[] = {u * scale[0] + offset[0], 1 - (v * scale[1] + offset[1])};
        const auto index = [](double at) { return static_cast<int>(std::floor((at - std::floor(at)) * kSide)); };
        const std::array<int, 3> expected = texel(index(place[0]), index(place[1]));
        for (const bool is_split : {true, false})
            for (const char* kind : {"SampleTexture2DNode", "SampleTexture2DLODNode"}) {
                const Imported made = import_graph(tiled(u, v, is_split, kind));
                const std::array<float, 4> pixel = drawn(made, tiling);
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_NEAR(pixel[c], decoded(expected[c]), 2e-3)
                        << kind << " at " << u << ", " << v << (is_split ? " apart" : "") << ", channel " << c;
            }
    }
}

// Nodes that compute with the coordinates do not know how to leave the tiling out.
TEST(ShaderGraphTiling, OtherNodesSayThatItCounts) {
    ShaderGraphText graph = tiled(0.3, 0.4, true);
    graph.nodes.back() = {.id = "read",
                          .kind = "TriplanarNode",
                          .slots = {{.id = 1, .kind = "Texture2DInput", .more = R"("m_Texture":{})"},
                                    {2, "UV"},
                                    {3, "Position"},
                                    out(0, "Vector4")}};
    const std::string changed = remarks(import_graph(graph), Remark::Kind::Changed);
    EXPECT_NE(changed.find("the tiling and the offset of its texture count here"), std::string::npos) << changed;
    // A texture without a tiling has nothing to leave out.
    graph = tiled(0.3, 0.4, true);
    graph.properties[0].more.clear();
    const Imported made = import_graph(graph);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed).find("tiling"), std::string::npos);
    EXPECT_EQ(text_of(made).find(" / "), std::string::npos) << text_of(made);
}

}  // namespace
}  // namespace patina::importers
