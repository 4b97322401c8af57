// Settings of a shader graph's target: what they do to the surface, and what the report says of them.
#include "tests/unit/importers/shadergraph_import.h"

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

TEST(ShaderGraphSettings, WhatIsClippedAddsNothing) {
    ShaderGraphText graph = blended(R"("m_SurfaceType":1,"m_AlphaMode":2,"m_AlphaClip":true)");
    graph.blocks.push_back({"SurfaceDescription.AlphaClipThreshold", "Vector1", "0.25"});
    const Imported made = import_graph(graph);
    EXPECT_TRUE(has(made, R"j("color": "= $_Tint.rgb * ($_Tint.a < 0.25 ? 0 : $_Tint.a)")j")) << text_of(made);
    EXPECT_TRUE(compiled(made).diagnostics.empty());
}

}  // namespace
}  // namespace patina::importers
