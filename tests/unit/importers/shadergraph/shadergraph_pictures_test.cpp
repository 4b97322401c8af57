// Pictures that shader graphs show: what the import settings beside them say.
#include "tests/unit/importers/shadergraph/shadergraph_import.h"

namespace patina::importers {
namespace {

// A picture beside the graph, with import settings in YAML.
void save_picture(const std::string& name, const std::string& guid, const std::string& settings) {
    const std::string path = save_shader_graph(name, "no pixels are read");
    std::ofstream(path + ".meta") << "fileFormatVersion: 2\nguid: " << guid << "\nTextureImporter:\n" << settings;
}

std::string showing(const std::string& guid) {
    return fmt::format(R"({{"m_SerializedTexture":"{{\"texture\":{{\"guid\":\"{}\"}}}}","m_Guid":""}})", guid);
}

// A property that shows the picture and is sampled. `type`: 0 a colour, 1 a normal map.
ShaderGraphText sampled(int type = 0, const std::string& kind = "Texture2D") {
    NodeText sample{.id = "a",
                    .kind = fmt::format("Sample{}Node", kind),
                    .slots = {{1, kind + "Input"}, {.id = 2, .kind = "UV"}, {3, "SamplerState"}, out(0, "Vector4")},
                    .more = fmt::format(R"("m_TextureType":{})", type)};
    if (kind == "Texture2DArray") sample.slots.push_back({.id = 8, .kind = "Vector1", .value = "0.0"});
    return {
        .properties = {{.id = "main", .kind = kind, .name = "MainTex", .value = showing(kGuid)}},
        .nodes = {{.id = "t", .kind = "PropertyNode", .slots = {out(0, kind)}, .property = "main"},
                  {.id = "s", .kind = "SamplerStateNode", .slots = {out(0, "SamplerState")}, .more = R"("m_filter":1)"},
                  std::move(sample)},
        .edges = {{"t", 0, "a", 1}, {"a", 0, "BaseColor"}}};
}

bool has(const Imported& made, const std::string& part) {
    return text_of(made).find(part) != std::string::npos;
}

TEST(ShaderGraphPictures, AreDecodedAndSampledAsTheirSettingsSay) {
    save_picture("mask.png", kGuid,
                 "  mipmaps:\n    sRGBTexture: 0\n  textureSettings:\n    filterMode: 0\n    wrapU: 1\n    wrapV: 1\n");
    ShaderGraphText graph = sampled();
    const Imported made = import_graph(graph);
    EXPECT_TRUE(has(made, R"("usage": "data")")) << text_of(made);
    EXPECT_TRUE(has(made, R"("sampler": { "wrap": "clamp", "filter": "nearest" })")) << text_of(made);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");

    // A node's own sampler counts for what it samples.
    graph.edges.push_back({"s", 0, "a", 3});
    const Imported own = import_graph(graph);
    EXPECT_TRUE(has(own, R"("sampler": "nearestRepeat")")) << text_of(own);
    EXPECT_TRUE(has(own, R"("sampler": { "wrap": "clamp", "filter": "nearest" })")) << text_of(own);
}

TEST(ShaderGraphPictures, OfColorsStayColorsWhateverReadsThem) {
    save_picture("wood.png", kGuid, "  mipmaps:\n    sRGBTexture: 1\n");
    EXPECT_TRUE(has(import_graph(sampled()), R"("usage": "color")"));
}

TEST(ShaderGraphPictures, OfNormalsMayHaveTheirGreenTurned) {
    save_picture("bumps.png", kGuid,
                 "  textureType: 1\n  bumpmap:\n    flipGreenChannel: 1\n  textureSettings:\n    aniso: 8\n    wrapU: "
                 "2\n    wrapV: 2\n");
    const Imported made = import_graph(sampled(1));
    EXPECT_TRUE(has(made, R"("usage": "normal")")) << text_of(made);
    EXPECT_TRUE(has(made, R"("handedness": "directx")")) << text_of(made);
    EXPECT_TRUE(has(made, R"("sampler": { "wrap": "mirror", "anisotropy": 8 })")) << text_of(made);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    EXPECT_NE(remarks(import_graph(sampled(0)), Remark::Kind::Changed).find("is not read as one"), std::string::npos);
}

TEST(ShaderGraphPictures, OfLayersHaveAGrid) {
    save_picture("pages.png", kGuid, "  textureShape: 4\n  flipbookRows: 2\n  flipbookColumns: 3\n");
    const Imported made = import_graph(sampled(0, "Texture2DArray"));
    EXPECT_TRUE(has(made, R"("grid": [3, 2])")) << text_of(made);
    EXPECT_FALSE(has(import_graph(sampled()), "grid"));
}

TEST(ShaderGraphPictures, AtAPortHaveSettings) {
    save_picture("mask.png", kGuid, "  mipmaps:\n    sRGBTexture: 0\n    enableMipMap: 0\n");
    ShaderGraphText graph = sampled();
    graph.edges.erase(graph.edges.begin());
    graph.nodes[2].slots[0].more = fmt::format(R"("m_Texture":{})", showing(kGuid));
    const Imported made = import_graph(graph);
    EXPECT_TRUE(has(made, R"("usage": "data")")) << text_of(made);
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("its picture: it has mip levels"), std::string::npos)
        << remarks(made, Remark::Kind::Changed);
}

// A sub-graph that has a texture and gives it on: who reads the output samples what is connected to the input.
TEST(ShaderGraphPictures, PassThroughSubgraphs) {
    const ShaderGraphText passing{
        .properties = {{.id = "in",
                        .kind = "Texture2D",
                        .name = "In",
                        .value = R"({"m_SerializedTexture":"","m_Guid":""})",
                        .more = R"("m_Guid":{"m_GuidSerialized":"in"})"}},
        .nodes = {{.id = "p", .kind = "PropertyNode", .slots = {out(0, "Texture2D")}, .property = "in"},
                  {.id = "own", .kind = "Texture2DAssetNode", .slots = {out(0, "Texture2D")}}},
        .edges = {{"p", 0, "output", 1}, {"own", 0, "output", 2}},
        .outputs = {{.id = 1, .kind = "Texture2D", .name = "Same"},
                    {.id = 2, .kind = "Texture2D", .name = "Own"},
                    {.id = 3, .kind = "Vector1", .name = "Number"}}};
    save_shader_graph("Passing.shadersubgraph", passing.new_layout(), kGuid);
    ShaderGraphText graph = sampled();
    graph.nodes.push_back(
        {.id = "sub",
         .kind = "SubGraphNode",
         .slots = {{.id = 5, .kind = "Texture2DInput", .name = "In"}, out(1, "Texture2D"), out(2, "Texture2D")},
         .more = fmt::format(
             R"x("m_SerializedSubGraph":"{{\"subGraph\":{{\"guid\":\"{}\"}}}}","m_PropertyGuids":["in"],"m_PropertyIds":[5])x",
             kGuid)});
    graph.edges = {{"t", 0, "sub", 5}, {"sub", 1, "a", 1}, {"a", 0, "BaseColor"}};
    const Imported made = import_graph(graph);
    EXPECT_TRUE(has(made, R"("node": "SampleTexture2D", "in": { "texture": "$_MainTex")")) << text_of(made);
    EXPECT_EQ(remarks(made, Remark::Kind::LeftOut), "output 'Own': an output of a sub-graph cannot be Texture2D\n");
    // The other output is a texture of the sub-graph's own.
    graph.edges[1] = {"sub", 2, "a", 1};
    EXPECT_NE(remarks(import_graph(graph), Remark::Kind::Changed).find("the sub-graph has no output"),
              std::string::npos);
}

}  // namespace
}  // namespace patina::importers
