// What an import of a MaterialX document says of what it does not take as it is.
#include <algorithm>

#include "tests/unit/importers/mtlx/mtlx_document.h"

namespace patina::importers {
namespace {

std::string changed(const std::string& nodes, const std::string& type = "color3") {
    const Imported made = import_mtlx(one_node(nodes, type));
    EXPECT_EQ(remarks(made, Remark::Kind::LeftOut), "");
    return remarks(made, Remark::Kind::Changed);
}
std::string word(const std::string& name, const std::string& value) {
    return fmt::format(R"(<input name="{}" type="string" value="{}"/>)", name, value);
}

TEST(MtlxReport, UnknownWordsAreSaid) {
    const auto said = [](const std::string& node, const std::string& inputs) {
        return changed(fmt::format(R"(<{0} name="tested" type="vector3">{1}</{0}>)", node, inputs), "vector3");
    };
    EXPECT_EQ(said("position", word("space", "wrld")),
              "input 'space': 'wrld' is none of 'model', 'object', 'world': the default stands for it\n");
    EXPECT_EQ(said("transformpoint", word("fromspace", "camera") + word("tospace", "world")),
              "input 'fromspace': 'camera' is none of 'model', 'object', 'world', 'tangent': the default stands for "
              "it\n");
    EXPECT_EQ(said("position", word("space", "world")), "");
    EXPECT_EQ(
        changed(R"(<geomcolor name="tested" type="color3"><input name="index" type="integer" value="1"/></geomcolor>)"),
        "input 'index': '1' is not '0': a mesh has one set of them\n");
    EXPECT_EQ(
        changed(R"(<geomcolor name="tested" type="color3"><input name="index" type="integer" value="0"/></geomcolor>)"),
        "");
    save("t.png", "no picture");
    EXPECT_EQ(said("image", R"(<input name="file" type="filename" value="t.png"/>)" + word("filtertype", "sharp")),
              "input 'filtertype': 'sharp' is none of 'closest', 'linear', 'cubic': the default stands for it\n");
}

TEST(MtlxReport, InputsThatANodeDoesNotHaveAreSaid) {
    EXPECT_EQ(
        changed(
            R"(<ifgreater name="tested" type="color3"><input name="value1" type="float" value="1"/><input name="value3" type="float" value="2"/><input name="in1" type="color3" value="1,0,0"/></ifgreater>)"),
        "input 'value3': 'ifgreater' has no such input\n");
    const std::string definition =
        R"(<nodedef name="ND_t" node="twice"><input name="in" type="float" value="0.25"/><output name="out" type="float"/></nodedef>
<nodegraph name="NG_t" nodedef="ND_t"><add name="e" type="float"><input name="in1" type="float" interfacename="in"/><input name="in2" type="float" interfacename="in"/></add><output name="out" type="float" nodename="e"/></nodegraph>)";
    EXPECT_EQ(
        changed(definition + R"(<twice name="tested" type="float"><input name="in" type="float" value="1"/></twice>)",
                "float"),
        "");
    EXPECT_EQ(
        changed(definition + R"(<twice name="tested" type="float"><input name="inn" type="float" value="1"/></twice>)",
                "float"),
        "input 'inn': 'twice' has no such input\n");
}

TEST(MtlxReport, AnInterfaceThatIsNotThereIsRefused) {
    const Imported made = import_mtlx(material(
        R"(<surface_unlit name="shader" type="surfaceshader"><input name="emission_color" type="color3" interfacename="missing"/></surface_unlit>)"));
    EXPECT_EQ(remarks(made, Remark::Kind::LeftOut),
              "input 'emission_color': it reads 'missing', which is no input of the node graph around: the default "
              "stands for it\n");
    EXPECT_EQ(remarks(made, Remark::Kind::Taken).find("emission_color"), std::string::npos);
    EXPECT_TRUE(made.has_refused);
}

TEST(MtlxReport, WhatAlphaBecomesIsSaid) {
    const auto import = [](const std::string& mode) {
        return import_mtlx(material(fmt::format(
            R"(<gltf_pbr name="shader" type="surfaceshader"><input name="alpha_mode" type="integer" value="{}"/><input name="alpha" type="float" value="0.25"/><input name="alpha_cutoff" type="float" value="0.75"/></gltf_pbr>)",
            mode)));
    };
    Imported made = import("5");
    EXPECT_EQ(remarks(made, Remark::Kind::Changed),
              "gltf_pbr input 'alpha_mode': '5' is no mode: the surface is opaque\n");
    const auto said = [](const Imported& from) { return remarks(from, Remark::Kind::Taken); };
    const auto expect_line = [&](const Imported& from, const std::string& line) {
        EXPECT_NE(said(from).find(line + "\n"), std::string::npos) << line << "\n" << said(from);
    };
    expect_line(made, "gltf_pbr input 'alpha': the surface is opaque");
    made = import("1");
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    expect_line(made, "gltf_pbr input 'alpha_mode': the surface is 'cutout'");
    expect_line(made, "gltf_pbr input 'alpha': 'surface.alpha'");
    expect_line(made, "gltf_pbr input 'alpha_cutoff': 'surface.alphaClip'");
    made = import("2");
    expect_line(made, "gltf_pbr input 'alpha_mode': the surface is 'fade'");
    expect_line(made, "gltf_pbr input 'alpha_cutoff': the surface is 'fade'");
    made = import_mtlx(material(
        R"(<UsdPreviewSurface name="shader" type="surfaceshader"><input name="opacity" type="float" value="0.5"/><input name="opacityMode" type="string" value="presence"/></UsdPreviewSurface>)"));
    expect_line(made, "UsdPreviewSurface input 'opacityMode': the surface is 'fade'");
}

TEST(MtlxReport, AConstantNormalIsTheMeshsOwn) {
    const auto import = [](const std::string& normal) {
        return import_mtlx(material(fmt::format(
            R"(<gltf_pbr name="shader" type="surfaceshader"><input name="normal" type="vector3" value="{}"/></gltf_pbr>)",
            normal)));
    };
    EXPECT_EQ(remarks(import("0.5, 0.5, 0.7"), Remark::Kind::Changed),
              "gltf_pbr input 'normal': the mesh's own normal stands for a constant direction\n");
    // What programs write for a default.
    for (const std::string normal : {"0, 0, 1", "0.5, 0.5, 1", "0, 0, 0"})
        EXPECT_EQ(remarks(import(normal), Remark::Kind::Changed), "") << normal;
}

TEST(MtlxReport, WhatNothingReadsIsSaid) {
    const Imported made = import_mtlx(material(
        R"(<gltf_pbr name="shader" type="surfaceshader"><input name="roughness" type="float" nodegraph="NG" output="out"/></gltf_pbr>)",
        R"(<nodegraph name="NG"><input name="hot" type="float" value="2" uimin="0" uimax="1"/><input name="flag" type="boolean" value="true"/><output name="out" type="float" interfacename="hot"/></nodegraph>
<variantset name="colours"><variant name="red"><input name="hot" type="float" value="1"/></variant></variantset>)"));
    EXPECT_NE(remarks(made, Remark::Kind::Taken).find("NG/input 'flag': no material reads it\n"), std::string::npos)
        << remarks(made, Remark::Kind::Taken);
    EXPECT_EQ(remarks(made, Remark::Kind::Taken).find("'hot': no material"), std::string::npos);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed),
              "input 'hot': its limits, 0 to 1, are left out: its value, 2, is outside of them\n"
              "variantset 'colours': a graph has no sets of values: the inputs keep their own\n");
}

TEST(MtlxReport, WhatARefusedNodeReadStays) {
    Imported made = import_mtlx(
        one_node(sources() +
                     R"(<sin name="wave" type="float"><input name="in" type="float" nodename="source_float"/></sin>
<curveadjust name="tested" type="float"><input name="in" type="float" nodename="wave"/><input name="knots" type="float" value="1"/></curveadjust>)",
                 "float"));
    EXPECT_NE(text_of(made).find(R"x("id": "wave", "expr": "sin(@positionOS.x)")x"), std::string::npos)
        << text_of(made);
    EXPECT_NE(text_of(made).find("has points of several values. It read in = wave\""), std::string::npos)
        << text_of(made);
    EXPECT_NE(remarks(made, Remark::Kind::Taken).find("sin 'wave': the node 'wave'\n"), std::string::npos)
        << remarks(made, Remark::Kind::Taken);
    expect_compiles(made, "a refused node");
    // A whole surface.
    made = import_mtlx(material(
        R"(<foggy name="shader" type="surfaceshader"><input name="tint" type="color3" nodename="source_color3"/><input name="file" type="filename" value="a.png"/></foggy>)",
        sources()));
    EXPECT_NE(text_of(made).find("It read tint = "), std::string::npos) << text_of(made);
    expect_compiles(made, "a refused surface");
}

// What an output without a connection says is reported at its place, and not at an element that is gone.
TEST(MtlxReport, OutputsThatReadNothing) {
    const Imported made = import_mtlx(R"(<materialx version="1.39">
<nodedef name="ND_a" node="a" type="float"><output name="out" type="float"/></nodedef>
<nodegraph name="NG_a" nodedef="ND_a"><texcoord name="t" type="vector2"/>
<output/></nodegraph>
<a name="rows" type="float"/>
<open_pbr_surface name="s" type="surfaceshader"><input name="base_metalness" type="float" nodename="rows"/></open_pbr_surface>
<surfacematerial name="m" type="material"><input name="surfaceshader" type="surfaceshader" nodename="s"/></surfacematerial>
</materialx>)");
    const auto is_output = [](const Remark& each) { return each.line == 4 && each.part == "output"; };
    EXPECT_TRUE(std::ranges::any_of(made.remarks, is_output)) << remarks(made, Remark::Kind::Changed);
}

}  // namespace
}  // namespace patina::importers
