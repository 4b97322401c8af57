// The settings of a shader graph's target change the surface, and the report names each.
#include "tests/unit/importers/shadergraph/shadergraph_import.h"

namespace patina::importers {
namespace {

// A colour whose alpha is that of the surface.
ShaderGraphText blended(const std::string& target, const std::string& material = "UniversalUnlitSubTarget") {
    return {.properties = {{.id = "c",
                            .kind = "Color",
                            .name = "Tint",
                            .value = R"({"r":1.0,"g":0.5019608,"b":0.0,"a":0.5019608})"}},
            .nodes = {{.id = "p", .kind = "PropertyNode", .slots = {out(0, "Vector4")}, .property = "c"},
                      {.id = "s", .kind = "SplitNode", .slots = {{0}, out(4, "Vector1")}}},
            .edges = {{"p", 0, "s", 0}, {"p", 0, "BaseColor"}, {"s", 4, "Alpha"}},
            .blocks = {{"SurfaceDescription.BaseColor", "ColorRGB"}, {"SurfaceDescription.Alpha", "Vector1", "1.0"}},
            .target = target,
            .material = material};
}

bool has(const Imported& made, const std::string& part) {
    return text_of(made).find(part) != std::string::npos;
}
bool says(const Imported& made, Remark::Kind kind, const std::string& part) {
    return remarks(made, kind).find(part) != std::string::npos;
}

TEST(ShaderGraphSettings, AdditiveColoursAreWeightedByAlpha) {
    const Imported made = import_graph(blended(R"("m_SurfaceType":1,"m_AlphaMode":2)"));
    EXPECT_TRUE(has(made, R"("surface": { "color": "= $_Tint.rgb * $_Tint.a" })")) << text_of(made);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    EXPECT_TRUE(compiled(made).diagnostics.empty());

    // Alpha stays for materials, which may choose another blending.
    const Imported open = import_graph(blended(R"("m_SurfaceType":1,"m_AlphaMode":2,"m_AllowMaterialOverride":true)"));
    EXPECT_TRUE(has(open, R"("color": "= $_Tint.rgb * $_Tint.a")")) << text_of(open);
    EXPECT_TRUE(has(open, R"("alpha": "$_Tint.a")")) << text_of(open);
    EXPECT_TRUE(says(open, Remark::Kind::Changed, "alpha changes the colour"));

    const Imported sprite =
        import_graph(blended(R"("m_SurfaceType":1,"m_AlphaMode":2)", "UniversalSpriteUnlitSubTarget"));
    EXPECT_TRUE(has(sprite, R"j("color": "= $_Tint.rgb * @vertexColor.rgb * ($_Tint.a * @vertexColor.a)")j"))
        << text_of(sprite);
}

TEST(ShaderGraphSettings, AdditiveLightIsWeightedInPart) {
    ShaderGraphText graph = blended(R"("m_SurfaceType":1,"m_AlphaMode":2)", "UniversalLitSubTarget");
    const Imported made = import_graph(graph);
    EXPECT_TRUE(has(made, R"("baseColor": "= $_Tint.rgb * $_Tint.a")")) << text_of(made);
    EXPECT_TRUE(says(made, Remark::Kind::Changed, "and not highlights and emission"));

    graph.material_settings = R"("m_WorkflowMode":0,"m_BlendModePreserveSpecular":true)";
    const Imported kept = import_graph(graph);
    EXPECT_EQ(remarks(kept, Remark::Kind::Changed), "");
    EXPECT_TRUE(says(kept, Remark::Kind::Taken, "'Preserve Specular Lighting': alpha does not weaken highlights"));
    graph.material_settings = R"("m_WorkflowMode":1,"m_BlendModePreserveSpecular":true)";
    EXPECT_TRUE(says(import_graph(graph), Remark::Kind::Changed, "highlights of metals"));
}

TEST(ShaderGraphSettings, AMultipliedColourFadesToWhite) {
    const Imported made = import_graph(blended(R"("m_SurfaceType":1,"m_AlphaMode":3)"));
    EXPECT_TRUE(has(made, R"j("surface": { "color": "= lerp(float3(1), $_Tint.rgb, $_Tint.a)" })j")) << text_of(made);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    EXPECT_TRUE(compiled(made).diagnostics.empty());
}

TEST(ShaderGraphSettings, PremultipliedIsNotPreserveSpecular) {
    ShaderGraphText graph = blended(R"("m_SurfaceType":1,"m_AlphaMode":1)", "UniversalLitSubTarget");
    graph.material_settings = R"("m_BlendModePreserveSpecular":true)";
    const Imported made = import_graph(graph);
    EXPECT_TRUE(says(made, Remark::Kind::Changed, "'Blending Mode': 'transparent': the colour is multiplied by alpha"))
        << remarks(made, Remark::Kind::Changed);
    EXPECT_TRUE(says(made, Remark::Kind::Taken, "'Preserve Specular Lighting': it has no effect"));

    graph.target = R"("m_SurfaceType":1,"m_AlphaMode":0)";
    const Imported kept = import_graph(graph);
    EXPECT_TRUE(has(kept, R"("surface": "transparent")")) << text_of(kept);
    EXPECT_EQ(remarks(kept, Remark::Kind::Changed), "");
}

TEST(ShaderGraphSettings, ABlendedSurfaceIsCutOut) {
    ShaderGraphText graph = blended(R"("m_SurfaceType":1,"m_AlphaMode":0,"m_AlphaClip":true)");
    graph.blocks.push_back({"SurfaceDescription.AlphaClipThreshold", "Vector1", "0.5"});
    const Imported made = import_graph(graph);
    EXPECT_TRUE(has(made, R"("alphaClip": 0.5)")) << text_of(made);  // also if it is the input's default
    EXPECT_TRUE(says(made, Remark::Kind::Taken, "'Alpha Clipping': 'surface.alphaClip'"))
        << remarks(made, Remark::Kind::Taken);
    const Result result = compiled(made);
    EXPECT_TRUE(result.diagnostics.empty());
    EXPECT_NE(result.shaders.back().text.find("discard"), std::string::npos) << result.shaders.back().text;
}

TEST(ShaderGraphSettings, WhatIsClippedAddsNothing) {
    ShaderGraphText graph = blended(R"("m_SurfaceType":1,"m_AlphaMode":2,"m_AlphaClip":true)");
    graph.blocks.push_back({"SurfaceDescription.AlphaClipThreshold", "Vector1", "0.25"});
    const Imported made = import_graph(graph);
    EXPECT_TRUE(has(made, R"j("color": "= $_Tint.rgb * $_Tint.a")j")) << text_of(made);
    EXPECT_TRUE(has(made, R"("alphaClip": 0.25)")) << text_of(made);
    EXPECT_TRUE(compiled(made).diagnostics.empty());
}

// The same of another target, whose settings lie in an object of their own.
Imported import_for(const std::string& target, const std::string& material, const std::string& data) {
    ShaderGraphText graph = blended(R"("m_Datas":[{"m_Id":"system"}])", material);
    graph.blocks.push_back({"SurfaceDescription.AlphaClipThreshold", "Vector1", "0.25"});
    graph.more_objects = fmt::format("\n\n{{\"m_Type\":\"x.SystemData\",\"m_ObjectId\":\"system\",{}}}", data);
    std::string source = graph.new_layout();
    source.replace(source.find("UniversalTarget"), 15, target);
    return import_shadergraph(source);
}

TEST(ShaderGraphSettings, OfTheHighDefinitionPipeline) {
    const Imported cut = import_for("HDTarget", "HDUnlitSubTarget",
                                    R"("m_SurfaceType":0,"m_BlendMode":0,"m_AlphaTest":true,"m_DoubleSidedMode":1)");
    EXPECT_TRUE(has(cut, R"("render": { "surface": "cutout", "cull": "off" })")) << text_of(cut);
    EXPECT_TRUE(has(cut, R"("alphaClip": 0.25)")) << text_of(cut);

    const Imported added =
        import_for("HDTarget", "HDLitSubTarget",
                   R"("m_SurfaceType":1,"m_BlendMode":1,"m_ZTest":8,"m_ZWrite":true,"m_DoubleSidedMode":1)");
    EXPECT_TRUE(
        has(added, R"("render": { "surface": "additive", "cull": "off", "depthWrite": true, "depthTest": "always" })"))
        << text_of(added);
    EXPECT_TRUE(has(added, R"("baseColor": "= $_Tint.rgb * $_Tint.a")")) << text_of(added);
    EXPECT_TRUE(says(added, Remark::Kind::Changed, "normals of back faces"));

    const std::string plain = R"("m_SurfaceType":1,"m_BlendMode":0,"m_TransparentCullMode":1,"m_OpaqueCullMode":2)";
    const Imported faded = import_for("HDTarget", "HDLitSubTarget", plain + R"(,"m_BlendPreserveSpecular":false)");
    EXPECT_TRUE(has(faded, R"("render": { "surface": "fade", "cull": "front" })")) << text_of(faded);
    const Imported kept =
        import_for("HDTarget", "HDLitSubTarget", plain + R"(,"m_BlendPreserveSpecular":true,"m_SortPriority":2)");
    EXPECT_TRUE(has(kept, R"("surface": "transparent")")) << text_of(kept);
    EXPECT_TRUE(says(kept, Remark::Kind::Changed, "Sorting Priority"));
}

// Opaque surfaces of that pipeline write and test the depth, whatever these numbers are.
TEST(ShaderGraphSettings, OfTransparentSurfacesDoNotCountForOpaqueOnes) {
    const Imported made =
        import_for("HDTarget", "HDUnlitSubTarget",
                   R"("m_SurfaceType":0,"m_BlendMode":1,"m_ZTest":8,"m_ZWrite":true,"m_TransparentCullMode":1)");
    EXPECT_FALSE(has(made, R"("render")")) << text_of(made);
}

TEST(ShaderGraphSettings, OfEffects) {
    const Imported made = import_for("VFXTarget", "None", R"("m_Lit":true,"m_AlphaTest":true)");
    EXPECT_TRUE(has(made, R"("workflow": "metallic-smoothness")")) << text_of(made);
    EXPECT_TRUE(has(made, R"("surface": "cutout")")) << text_of(made);
    EXPECT_TRUE(says(made, Remark::Kind::Changed, "not on particles"));
    EXPECT_TRUE(has(import_for("VFXTarget", "None", R"("m_Lit":false)"), R"("workflow": "unlit")"));

    // Of 2020.1 and before: a master node.
    const Imported old = import_shadergraph(
        R"({"m_SerializedProperties":[],"m_SerializableEdges":[],"m_SerializableNodes":[{"typeInfo":{"fullName":"UnityEditor.ShaderGraph.VfxMasterNode"},"JSONnodeData":"{\"m_GuidSerialized\":\"m\",\"m_Name\":\"Effect\",\"m_Lit\":false,\"m_AlphaTest\":true,\"m_SerializableSlots\":[{\"typeInfo\":{\"fullName\":\"UnityEditor.ShaderGraph.Vector1MaterialSlot\"},\"JSONnodeData\":\"{\\\"m_Id\\\":4,\\\"m_DisplayName\\\":\\\"Alpha Threshold\\\",\\\"m_SlotType\\\":0,\\\"m_Value\\\":0.25}\"}]}"}]})");
    EXPECT_TRUE(has(old, R"("alphaClip": 0.25)")) << text_of(old) << old.error;
    EXPECT_TRUE(has(old, R"("surface": "cutout")")) << text_of(old);
}

// Blocks stay in the file when the settings do not want them any more.
ShaderGraphText with_normals(const std::string& space) {
    ShaderGraphText graph = blended(R"("m_SurfaceType":0)", "UniversalLitSubTarget");
    graph.material_settings = space;
    const std::string slant = R"({"x":0.0,"y":0.6,"z":0.8})";
    graph.nodes.push_back({.id = "v", .kind = "PositionNode", .slots = {out(0, "Vector3")}, .more = R"("m_Space":2)"});
    for (const char* each : {"NormalTS", "NormalWS"}) {
        graph.blocks.push_back({std::string("SurfaceDescription.") + each, "Vector3", slant});
        graph.edges.push_back({"v", 0, each});
    }
    return graph;
}

TEST(ShaderGraphSettings, TheNormalIsThatOfTheChosenSpace) {
    const Imported world = import_graph(with_normals(R"("m_NormalDropOffSpace":2)"));
    EXPECT_TRUE(has(world, R"("normalWS": "@positionWS")")) << text_of(world);
    EXPECT_FALSE(has(world, "normalTS")) << text_of(world);
    EXPECT_TRUE(says(world, Remark::Kind::Taken, "block 'NormalTS': the target has no such block"));
    const Imported tangent = import_graph(with_normals(R"("m_NormalDropOffSpace":0)"));
    EXPECT_TRUE(has(tangent, R"("normalTS": )")) << text_of(tangent);
    EXPECT_FALSE(has(tangent, "normalWS")) << text_of(tangent);

    // An unconnected block that is left over is no normal either.
    ShaderGraphText stale = with_normals(R"("m_NormalDropOffSpace":1)");
    EXPECT_FALSE(has(import_graph(stale), "normal"));
}

TEST(ShaderGraphSettings, OneBlockGivesTheColour) {
    ShaderGraphText graph = blended(R"("m_SurfaceType":0)");
    const std::string blue = R"({"x":0.0,"y":0.0,"z":1.0,"w":1.0})";
    for (const char* each : {"FullscreenColor", "SpriteColor"})
        graph.blocks.push_back({std::string("SurfaceDescription.") + each, "ColorRGBA", blue});
    const Imported made = import_graph(graph);
    EXPECT_EQ(made.error, "");
    EXPECT_TRUE(has(made, R"("color": "$_Tint.rgb")")) << text_of(made);
    EXPECT_TRUE(says(made, Remark::Kind::Taken, "block 'FullscreenColor': the target has no such block"));

    graph.material = "UniversalFullscreenSubTarget";
    graph.blocks.erase(graph.blocks.begin());
    graph.edges.erase(graph.edges.begin() + 1);
    EXPECT_TRUE(has(import_graph(graph), R"("color": [0, 0, 1])")) << text_of(import_graph(graph));
}

TEST(ShaderGraphSettings, ASecondBlockForAnInputIsSaid) {
    ShaderGraphText graph = blended(R"("m_SurfaceType":0)", "UniversalLitSubTarget");
    graph.blocks.push_back({"SurfaceDescription.Occlusion", "Vector1", "0.5"});
    graph.blocks.push_back({"SurfaceDescription.AmbientOcclusion", "Vector1", "0.25"});
    const Imported made = import_graph(graph);
    EXPECT_TRUE(has(made, R"("occlusion": 0.5)")) << text_of(made);
    EXPECT_TRUE(says(made, Remark::Kind::Changed, "block 'AmbientOcclusion': a second block"));

    // A normal of the vertices is another one than that of the surface.
    graph = with_normals(R"("m_NormalDropOffSpace":1)");
    for (const char* each : {"VertexDescription.Normal", "SurfaceDescription.NormalOS"}) {
        graph.blocks.push_back({each, "Vector3", R"({"x":0.0,"y":0.0,"z":1.0})"});
        graph.edges.push_back({"v", 0, graph.blocks.back().name.substr(graph.blocks.back().name.find('.') + 1)});
    }
    const Imported both = import_graph(graph);
    EXPECT_TRUE(has(both, R"("vertex": { "normalOS": "@positionWS" })")) << text_of(both);
    EXPECT_TRUE(has(both, R"("baseColor": "$_Tint.rgb", "normalOS": "@positionWS")")) << text_of(both);
}

TEST(ShaderGraphSettings, SpritesAreTwoSided) {
    const Imported made = import_graph(blended(R"("m_RenderFace":2)", "UniversalSpriteUnlitSubTarget"));
    EXPECT_TRUE(has(made, R"("cull": "off")")) << text_of(made);
    EXPECT_TRUE(says(made, Remark::Kind::Taken, "sprites are two-sided"));
}

}  // namespace
}  // namespace patina::importers
