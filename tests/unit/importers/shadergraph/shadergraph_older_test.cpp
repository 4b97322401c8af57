// What a shader graph leaves unsaid, or said in an older version of a node; and textures without their tiling.
#include <cmath>
#include <map>

#include "runtime/picture/image.h"
#include "runtime/render/render_request.h"
#include "tests/unit/importers/shadergraph/shadergraph_import.h"

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

// --- inputs whose slots a file lacks

std::string without_slots(const std::string& kind, const std::vector<SlotText>& slots, const std::string& more = "") {
    const int output = slots.back().id;
    const Imported made = import_graph(one_node({.id = "it", .kind = kind, .slots = slots, .more = more}, output));
    EXPECT_FALSE(made.has_refused) << kind << remarks(made, Remark::Kind::LeftOut);
    expect_compiles(made, kind);
    return text_of(made);
}
void expect_text(const std::string& graph, const std::string& part) {
    EXPECT_NE(graph.find(part), std::string::npos) << part << "\n" << graph;
}

TEST(ShaderGraphInputs, WithoutASlotHaveTheDefaultOfTheNode) {
    // What is the default of the library's node, too, is not written.
    const SlotText half{.id = 0, .value = R"({"x":0.5,"y":0.5,"z":0.5,"w":0.5})"};
    const SlotText blend{.id = 1, .value = R"({"x":0.25,"y":0.25,"z":0.25,"w":0.25})"};
    EXPECT_EQ(without_slots("BlendNode", {half, blend, out(2)}).find("opacity"), std::string::npos);
    expect_text(without_slots("NormalFromHeightNode", {{0, "Vector1"}, out(1, "Vector3")}),
                R"("node": "NormalFromHeight" })");
    expect_text(without_slots("RemapNode", {half, out(3)}), R"("node": "Remap", "in": { "value": 0.5 } })");
    expect_text(without_slots("RefractNode", {out(4, "Vector3")}), R"("node": "RefractUnity" })");
    expect_text(without_slots("MultiplyNode", {{.id = 0, .kind = "DynamicValue", .value = R"({"e00":0.5})"}, out(2)}),
                "\"color\": 1 }");
    expect_text(without_slots("DivideNode", {half, out(2)}), "\"color\": 0.25 }");
    expect_text(without_slots("Vector2Node", {out(0, "Vector2")}, R"("m_Value":{"x":0.25,"y":0.75})"), "0.25, 0.75");
    expect_text(without_slots("TilingAndOffsetNode",
                              {{.id = 2, .kind = "Vector2", .value = R"({"x":0.5,"y":0.5})"}, out(3, "Vector2")}),
                R"("in": { "uv": "uv", "offset": 0.5 })");
    const std::string parallax = without_slots(
        "ParallaxOcclusionMappingNode",
        {{.id = 2, .kind = "Texture2DInput", .more = R"("m_Texture":{})"}, out(0, "Vector1"), out(1, "Vector2")});
    EXPECT_EQ(parallax.find("tiling"), std::string::npos) << parallax;
    EXPECT_EQ(parallax.find("primitiveSize"), std::string::npos) << parallax;
}

// A matrix times a vector whose slot the file lacks.
TEST(ShaderGraphInputs, OfAMatrixHaveTheDefaultToo) {
    ShaderGraphText graph{
        .nodes = {{.id = "m",
                   .kind = "Matrix3Node",
                   .slots = {out(0, "Matrix3")},
                   .more = R"("m_Row0":{"x":1.0},"m_Row1":{"y":1.0},"m_Row2":{"z":1.0})"},
                  {.id = "it", .kind = "MultiplyNode", .slots = {{0, "DynamicValue"}, out(2, "DynamicValue")}}},
        .edges = {{"m", 0, "it", 0}, {"it", 2, "BaseColor"}}};
    const Imported made = import_graph(graph);
    expect_compiles(made, "a matrix");
    expect_text(text_of(made), "float3(2))");
}

// Without any slot of an input, each class of the list still says what compiles.
TEST(ShaderGraphInputs, OfEachClassCompileWithoutTheirSlots) {
    const struct {
        const char *kind, *inputs;
    } rows[] =
        {
#define INPUTS(kind, inputs) {kind, inputs},
#include "compiler/importers/shadergraph/inputs.def"
#undef INPUTS
        },
      outputs[] = {
#define SLOTS(kind, inputs, outputs) {kind, outputs},
#include "tests/unit/importers/shadergraph/shadergraph_slots.def"
#undef SLOTS
      };
    for (const auto& row : rows) {
        const auto* slots = std::find_if(std::begin(outputs), std::end(outputs),
                                         [&](const auto& each) { return std::string_view(each.kind) == row.kind; });
        ASSERT_NE(slots, std::end(outputs)) << row.kind;
        const std::string list = slots->inputs;  // "4 Vector1; ..."
        const std::size_t space = list.find(' '), end = std::min(list.find(';'), list.size());
        const SlotText slot = out(std::stoi(list), list.substr(space + 1, end - space - 1));
        const Imported made =
            import_graph(one_node({.id = "it", .kind = row.kind, .slots = {slot}, .version = 1}, slot.id));
        EXPECT_FALSE(made.has_refused) << row.kind << remarks(made, Remark::Kind::LeftOut);
        expect_compiles(made, row.kind);
    }
}

// --- versions of nodes

NodeText noise(const char* input, int version) {
    return {.id = "it",
            .kind = "NoiseSineWaveNode",
            .slots = {{.id = 0, .kind = input}, {.id = 1, .kind = "Vector2", .value = R"({"x":-0.5,"y":0.5})"}, out(2)},
            .version = version};
}
TEST(ShaderGraphVersions, TheFirstNoiseSineWaveHasOneNoiseForAllComponents) {
    ShaderGraphText wide = one_node(noise("DynamicVector", 0), 2);
    wide.nodes.push_back({.id = "a", .kind = "PositionNode", .slots = {out(0, "Vector3")}, .more = R"("m_Space":2)"});
    wide.edges.push_back({"a", 0, "it", 0});
    const Imported old = import_graph(wide);
    expect_text(text_of(old), R"("node": "NoiseSineWave", "in": { "value": "@positionWS.x")");
    expect_text(remarks(old, Remark::Kind::Changed), "one noise for all components");
    expect_compiles(old, "version 0");
    wide.nodes[0].version = 1;
    const Imported made = import_graph(wide);
    expect_text(text_of(made), R"("node": "NoiseSineWave", "in": { "value": "@positionWS")");
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    // One component has one noise.
    EXPECT_EQ(remarks(import_graph(one_node(noise("DynamicVector", 0), 2)), Remark::Kind::Changed), "");
    EXPECT_NE(remarks(import_graph(one_node(noise("DynamicVector", 2), 2)), Remark::Kind::Changed), "");
}

TEST(ShaderGraphVersions, OlderTransformsOfDirectionsAndOfTangentSpaceAreApproximate) {
    const auto changed = [](const std::string& settings, int version) {
        const Imported made = import_graph(one_node({.id = "it",
                                                     .kind = "TransformNode",
                                                     .slots = {{0, "Vector3"}, out(1, "Vector3")},
                                                     .more = settings,
                                                     .version = version},
                                                    1));
        expect_compiles(made, settings);
        return !remarks(made, Remark::Kind::Changed).empty();
    };
    const std::string to_tangent = R"("m_Conversion":{"from":2,"to":3})",
                      to_view = R"("m_Conversion":{"from":0,"to":1})", direction = R"(,"m_ConversionType":1)";
    for (const int version : {0, 1}) {
        EXPECT_TRUE(changed(to_tangent, version)) << version;
        EXPECT_TRUE(changed(to_view + direction, version)) << version;
        EXPECT_FALSE(changed(to_view, version)) << version;
    }
    EXPECT_FALSE(changed(to_tangent, 2));
    EXPECT_FALSE(changed(to_view + direction, 2));
    EXPECT_FALSE(changed(to_view + direction + R"(,"m_Normalize":false)", 2));
    EXPECT_TRUE(changed(to_view, 3));
}

TEST(ShaderGraphVersions, ATransformKeepsTheLengthIfItSaysSo) {
    const auto imported = [](const std::string& flag) {
        return text_of(import_graph(one_node({.id = "it",
                                              .kind = "TransformNode",
                                              .slots = {{0, "Vector3"}, out(1, "Vector3")},
                                              .more = R"("m_ConversionType":1,"m_Normalize":)" + flag,
                                              .version = 2},
                                             1)));
    };
    expect_text(imported("false"), R"("normalized": false)");
    EXPECT_EQ(imported("true").find("normalized"), std::string::npos);
}

}  // namespace
}  // namespace patina::importers
