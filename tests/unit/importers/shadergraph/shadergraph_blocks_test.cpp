// Blocks of a shader graph's target that a surface lacks, and the settings that they come with.
#include "tests/unit/importers/shadergraph/shadergraph_import.h"

namespace patina::importers {
namespace {

bool says(const Imported& made, Remark::Kind kind, const std::string& part) {
    return remarks(made, kind).find(part) != std::string::npos;
}

ShaderGraphText with_blocks(const std::string& material, const std::string& settings, std::vector<BlockText> blocks) {
    blocks.push_back({"SurfaceDescription.BaseColor", "ColorRGB"});
    return {.blocks = std::move(blocks), .material = material, .material_settings = settings};
}
BlockText number_block(const std::string& name, const std::string& value) {
    return {"SurfaceDescription." + name, "Vector1", value};
}

// The same for the target of the high definition pipeline, whose settings lie in an object of their own.
Imported import_lit(const std::string& data, std::vector<BlockText> blocks, std::vector<EdgeText> edges = {},
                    const std::string& material = "HDLitSubTarget") {
    ShaderGraphText graph = with_blocks(material, "", std::move(blocks));
    graph.nodes = {{.id = "n", .kind = "Vector1Node", .slots = {{.id = 1, .kind = "Vector1", .value = "0.25"}, out(0)}},
                   {.id = "c",
                    .kind = "ColorNode",
                    .slots = {out(0, "Vector4")},
                    .more = R"("m_Color":{"color":{"r":1.0,"g":0.0,"b":0.0,"a":1.0},"mode":0})"}};
    graph.edges = std::move(edges);
    graph.target = R"("m_Datas":[{"m_Id":"lit"}])";
    graph.more_objects = "\n\n" + fmt::format(R"({{"m_Type":"x.HDLitData","m_ObjectId":"lit",{}}})", data);
    std::string source = graph.new_layout();
    source.replace(source.find("UniversalTarget"), 15, "HDTarget");
    return import_shadergraph(source);
}

TEST(ShaderGraphBlocks, ASpecularColourIsTheOtherWorkflow) {
    const Imported made = import_lit(R"("m_MaterialType":4)",
                                     {{"SurfaceDescription.Specular", "ColorRGB"},
                                      number_block("Smoothness", "0.75"),
                                      number_block("Metallic", "1.0")},
                                     {{"c", 0, "Specular"}});
    const std::string& text = text_of(made);
    EXPECT_NE(text.find(R"("workflow": "specular-glossiness")"), std::string::npos) << text;
    EXPECT_NE(text.find(R"("specular": [1, 0, 0])"), std::string::npos) << text;
    EXPECT_NE(text.find(R"("glossiness": 0.75)"), std::string::npos) << text;
    EXPECT_EQ(text.find("metallic"), std::string::npos) << text;
    EXPECT_TRUE(says(made, Remark::Kind::Taken, "block 'Metallic': the target has no such block"));
    EXPECT_FALSE(says(made, Remark::Kind::Changed, "block"));
    expect_compiles(made, "a specular colour");
    // Of newer graphs: a bit for each type, in another order.
    EXPECT_NE(text_of(import_lit(R"("m_MaterialTypeMask":16,"m_MaterialType":0)", {})).find("specular-glossiness"),
              std::string::npos);
}

TEST(ShaderGraphBlocks, MaterialTypesSayWhatIsLost) {
    struct Row {
        const char *settings, *block, *value, *text;
    };
    constexpr Row kRows[] = {
        {R"("m_MaterialType":1)", "SubsurfaceMask", "0.5", "'Subsurface Scattering': light does not go below"},
        {R"("m_MaterialTypeMask":1)", "Thickness", "0.5", "'Subsurface Scattering': light does not go below"},
        {R"("m_MaterialType":2)", "Anisotropy", "0.5", "'Anisotropy': highlights have the same width"},
        {R"("m_MaterialType":3)", "IridescenceMask", "0.5", "'Iridescence': highlights have no colours"},
        {R"("m_MaterialType":5)", "TransmissionMask", "0.5", "'Translucent': no light shines through"},
    };
    for (const Row& row : kRows) {
        const Imported made = import_lit(row.settings, {number_block(row.block, row.value)});
        EXPECT_TRUE(says(made, Remark::Kind::Changed, fmt::format("'Material Type': {}", row.text))) << row.settings;
        EXPECT_TRUE(says(made, Remark::Kind::Changed, fmt::format("block '{}': the workflow has no", row.block)));
        // A standard surface has none of these blocks.
        const Imported standard = import_lit(R"("m_MaterialType":0)", {number_block(row.block, row.value)});
        EXPECT_TRUE(says(standard, Remark::Kind::Taken, fmt::format("block '{}': the target has no such", row.block)));
        EXPECT_TRUE(says(standard, Remark::Kind::Taken, "'Material Type': 'Standard'"));
    }
    const auto anisotropy = [](std::vector<EdgeText> edges) {
        return import_lit(R"("m_MaterialType":2)", {number_block("Anisotropy", "0.0")}, std::move(edges));
    };
    EXPECT_TRUE(says(anisotropy({}), Remark::Kind::Taken, "block 'Anisotropy': it has its default"));
    EXPECT_TRUE(says(anisotropy({{"n", 0, "Anisotropy"}}), Remark::Kind::Changed, "block 'Anisotropy'"));
    EXPECT_TRUE(says(import_lit(R"("m_MaterialTypeMask":6)", {}), Remark::Kind::Changed,
                     "'Standard': materials cannot choose another one"));
    // The types of a fabric are others.
    EXPECT_FALSE(
        says(import_lit(R"("m_MaterialType":1)", {}, {}, "FabricSubTarget"), Remark::Kind::Changed, "'Material Type'"));
    // Light that goes below the surface meets no metal.
    const Imported skin = import_lit(R"("m_MaterialType":1)", {number_block("Metallic", "1.0")});
    EXPECT_EQ(text_of(skin).find(R"("metallic":)"), std::string::npos) << text_of(skin);
}

TEST(ShaderGraphBlocks, SettingsOfTheHighDefinitionPipelineAreSaid) {
    struct Row {
        const char *settings, *label, *block, *otherwise;
    };
    constexpr Row kRows[] = {
        {R"("m_SpecularAA":true)", "Specular AA", "SpecularAAThreshold", R"("m_SpecularAA":false)"},
        {R"("m_DepthOffset":true)", "Depth Offset", "DepthOffset", R"("m_DepthOffset":false)"},
        {R"("m_SurfaceType":1,"m_RefractionModel":2)", "Refraction Model", "RefractionIndex",
         R"("m_RefractionModel":2)"},
        {R"("m_SpecularOcclusionMode":3)", "Specular Occlusion Mode", "SpecularOcclusion",
         R"("m_SpecularOcclusionMode":2)"},
        {R"("m_AlphaTest":true,"m_AlphaTestShadow":true)", "Use Shadow Threshold", "AlphaClipThresholdShadow",
         R"("m_AlphaTestShadow":true)"},
        {R"("m_MaterialType":4,"m_EnergyConservingSpecular":false)", "Energy Conserving Specular", "",
         R"("m_EnergyConservingSpecular":false)"},
    };
    for (const Row& row : kRows) {
        std::vector<BlockText> blocks;
        if (*row.block) blocks.push_back(number_block(row.block, "0.125"));
        const Imported made = import_lit(row.settings, blocks);
        const std::string block = fmt::format("block '{}'", row.block);
        EXPECT_TRUE(says(made, Remark::Kind::Changed, fmt::format("setting '{}'", row.label))) << row.settings;
        EXPECT_EQ(says(made, Remark::Kind::Changed, block), *row.block != '\0') << row.settings;
        EXPECT_FALSE(says(import_lit(row.otherwise, blocks), Remark::Kind::Changed, block)) << row.otherwise;
    }
    EXPECT_TRUE(says(import_lit(R"("m_RefractionModel":2)", {}), Remark::Kind::Taken,
                     "'Refraction Model': it has no effect on an opaque surface"));
    EXPECT_TRUE(says(import_lit(R"("m_SurfaceType":0)", {number_block("Alpha", "0.5")}), Remark::Kind::Taken,
                     "block 'Alpha': an opaque surface does not read it"));
}

TEST(ShaderGraphBlocks, ConstantsAreLostToo) {
    const std::string lit = "UniversalLitSubTarget", coat = R"("m_ClearCoat":true)";
    const Imported coated =
        import_graph(with_blocks(lit, coat, {number_block("CoatMask", "0.8"), number_block("CoatSmoothness", "1.0")}));
    EXPECT_TRUE(says(coated, Remark::Kind::Changed, "setting 'Clear Coat'"));
    EXPECT_TRUE(says(coated, Remark::Kind::Changed, "block 'CoatMask': the workflow has no such input"));
    EXPECT_TRUE(says(coated, Remark::Kind::Taken, "block 'CoatSmoothness': it has its default"));
    const Imported bare = import_graph(with_blocks(lit, "", {number_block("CoatMask", "0.8")}));
    EXPECT_TRUE(says(bare, Remark::Kind::Taken, "block 'CoatMask': the target has no such block"));

    const std::string red = R"({"x":1.0,"y":0.0,"z":0.0,"w":1.0})", white = R"({"x":1.0,"y":1.0,"z":1.0,"w":1.0})";
    for (const std::string& value : {red, white}) {
        ShaderGraphText graph = with_blocks(
            "UniversalSpriteLitSubTarget", "",
            {{"SurfaceDescription.SpriteMask", "ColorRGBA", value}, {"SurfaceDescription.NormalTS", "Normal", white}});
        EXPECT_EQ(says(import_graph(graph), Remark::Kind::Changed, "block 'SpriteMask'"), value == red);
        EXPECT_TRUE(says(import_graph(graph), Remark::Kind::Taken, "block 'NormalTS': it has its default"));
        graph.material = "UniversalSpriteUnlitSubTarget";
        EXPECT_FALSE(says(import_graph(graph), Remark::Kind::Changed, "block"));
    }
    // A target that is not known may have any block.
    for (const char* block : {"Foam", "Metallic"})
        EXPECT_TRUE(says(import_graph(with_blocks("WaterSubTarget", "", {number_block(block, "0.5")})),
                         Remark::Kind::Changed, fmt::format("block '{}'", block)));
    EXPECT_FALSE(says(import_graph(with_blocks("WaterSubTarget", "", {number_block("Alpha", "0.5")})),
                      Remark::Kind::Changed, "block"));
}

// A master node of 2020.1 and before, whose slots have names.
std::string old_master(const std::string& kind, const std::string& settings, const std::string& slots) {
    return fmt::format(
        R"({{"m_SerializedProperties":[],"m_SerializableEdges":[],"m_SerializableNodes":[{{"typeInfo":{{"fullName":"UnityEditor.ShaderGraph.{}"}},"JSONnodeData":"{{\"m_GuidSerialized\":\"m\",\"m_Name\":\"Master\",{},\"m_SerializableSlots\":[{}]}}"}}]}})",
        kind, settings, slots);
}
std::string old_slot(int id, const std::string& kind, const std::string& name, const std::string& value) {
    return fmt::format(
        R"({{\"typeInfo\":{{\"fullName\":\"UnityEditor.ShaderGraph.{}MaterialSlot\"}},\"JSONnodeData\":\"{{\\\"m_Id\\\":{},\\\"m_DisplayName\\\":\\\"{}\\\",\\\"m_SlotType\\\":0,\\\"m_Value\\\":{}}}\"}})",
        kind, id, name, value);
}

TEST(ShaderGraphBlocks, OfOldMasterNodesHaveOtherNames) {
    const std::string red = R"({\\\"x\\\":1.0,\\\"y\\\":0.0,\\\"z\\\":0.0})";
    const std::string slots = old_slot(0, "ColorRGB", "Specular Color", red) + "," +
                              old_slot(1, "ColorRGB", "Emissive", red) + "," + old_slot(2, "Vector1", "Alpha", "0.5") +
                              "," + old_slot(3, "Vector1", "Coat Mask", "0.5") + "," +
                              old_slot(4, "Vector1", "Subsurface Mask", "1.0");
    const Imported made = import_shadergraph(old_master("HDLitMasterNode", R"(\"m_MaterialType\":4)", slots));
    EXPECT_NE(text_of(made).find(R"("specular": [1, 0, 0], "emission": [1, 0, 0])"), std::string::npos)
        << text_of(made) << made.error;
    EXPECT_TRUE(says(made, Remark::Kind::Changed, "block 'CoatMask'"));
    EXPECT_TRUE(says(made, Remark::Kind::Taken, "block 'SubsurfaceMask': it has its default"));
    EXPECT_TRUE(says(made, Remark::Kind::Taken, "block 'Alpha': an opaque surface does not read it"));
}

TEST(ShaderGraphBlocks, OfVerticesAreLostToo) {
    BlockText factor{"VertexDescription.TessellationFactor", "Vector1", "4.0"};
    EXPECT_TRUE(says(import_lit(R"("m_Tessellation":true)", {factor}), Remark::Kind::Changed,
                     "block 'TessellationFactor': the vertex block of a graph has no such value"));
    EXPECT_TRUE(says(import_lit(R"("m_Tessellation":false)", {factor}), Remark::Kind::Taken,
                     "block 'TessellationFactor': the target has no such block"));
}

}  // namespace
}  // namespace patina::importers
