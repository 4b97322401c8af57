// Pictures of MaterialX documents: how they are read, and what their properties say.
#include "tests/unit/importers/mtlx/mtlx_document.h"

namespace patina::importers {
namespace {

bool has(const Imported& made, const std::string& part) {
    return text_of(made).find(part) != std::string::npos;
}

// The nodes of a normal map, and of a surface that reads it.
Imported normal_map(const std::string& words) {
    save("bumps.png", "no picture");
    return import_mtlx(material(
        R"(<gltf_pbr name="shader" type="surfaceshader"><input name="normal" type="vector3" nodename="bumps"/></gltf_pbr>)",
        fmt::format(
            R"(<image name="texels" type="vector3"><input name="file" type="filename" value="bumps.png"/>{}</image>
<normalmap name="bumps" type="vector3"><input name="in" type="vector3" nodename="texels"/></normalmap>)",
            words)));
}

TEST(MtlxTexture, NormalMapsKeepWrapAndFilter) {
    const std::string clamped =
        R"(<input name="uaddressmode" type="string" value="clamp"/><input name="vaddressmode" type="string" value="clamp"/>)";
    Imported made = normal_map(clamped + R"(<input name="filtertype" type="string" value="closest"/>)");
    EXPECT_TRUE(has(made, R"("sampler": { "wrap": "clamp", "filter": "nearest" })")) << text_of(made);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    made = normal_map(clamped + R"(<input name="filtertype" type="string" value="cubic"/>)");
    EXPECT_TRUE(has(made, R"("sampler": { "wrap": "clamp" })")) << text_of(made);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "image 'texels': the node 'bumps': the filter is linear\n");
    EXPECT_FALSE(has(normal_map(""), "sampler"));
    // That of USD, whose surface takes what the texture has decoded.
    save("bumps.png", "no picture");
    made = import_mtlx(material(
        R"(<UsdPreviewSurface name="shader" type="surfaceshader"><input name="normal" type="vector3" nodename="texels" output="rgb"/></UsdPreviewSurface>)",
        R"(<UsdUVTexture name="texels" type="multioutput"><input name="file" type="filename" value="bumps.png"/><input name="wrapS" type="string" value="mirror"/><input name="wrapT" type="string" value="mirror"/><input name="scale" type="vector4" value="2,2,2,1"/><input name="bias" type="vector4" value="-1,-1,-1,0"/></UsdUVTexture>)"));
    EXPECT_TRUE(has(made, R"("sampler": { "wrap": "mirror" })")) << text_of(made);
    expect_compiles(made, "mirror");
}

TEST(MtlxTexture, PropertiesKeepTheirDescription) {
    save("a.png", "no picture");
    const Imported made = import_mtlx(material(
        R"(<gltf_pbr name="shader" type="surfaceshader"><input name="base_color" type="color3" nodegraph="NG" output="out"/></gltf_pbr>)",
        R"(<nodegraph name="NG"><input name="one" type="filename" value="a.png" uiname="One" uifolder="Pictures" doc="the first"/><input name="two" type="filename" value="a.png" uiname="Two"/>
<image name="i1" type="color3"><input name="file" type="filename" interfacename="one"/></image><image name="i2" type="color3"><input name="file" type="filename" interfacename="two"/></image>
<add name="sum" type="color3"><input name="in1" type="color3" nodename="i1"/><input name="in2" type="color3" nodename="i2"/></add><output name="out" type="color3" nodename="sum"/></nodegraph>)"));
    EXPECT_TRUE(has(made, R"("label": "One")") && has(made, R"("group": "Pictures")") &&
                has(made, R"("help": "the first")"))
        << text_of(made);
    EXPECT_TRUE(has(made, R"("label": "Two")")) << text_of(made);
    expect_compiles(made, "two properties of one picture");
}

// A texture slot without a picture, which stays one.
TEST(MtlxTexture, APropertyMayNameNoPicture) {
    const auto import = [](const std::string& otherwise, const std::string& type = "color3") {
        return import_mtlx(material(
            R"(<gltf_pbr name="shader" type="surfaceshader"><input name="base_color" type="color3" nodegraph="NG" output="out"/></gltf_pbr>)",
            fmt::format(
                R"(<nodegraph name="NG"><input name="slot" type="filename" value="" uiname="Slot" colorspace="srgb_texture"/><image name="picture" type="{0}"><input name="file" type="filename" interfacename="slot"/>{1}</image><convert name="three" type="color3"><input name="in" type="{0}" nodename="picture"/></convert><output name="out" type="color3" nodename="three"/></nodegraph>)",
                type,
                otherwise.empty() ? ""
                                  : fmt::format(R"(<input name="default" type="{}" value="{}"/>)", type, otherwise))));
    };
    const auto expect_slot = [](const Imported& made, const std::string& word) {
        EXPECT_TRUE(has(
            made, fmt::format(R"({{ "name": "_Slot", "type": "texture2d", "default": "{}", "label": "Slot" }})", word)))
            << text_of(made);
        EXPECT_TRUE(has(made, R"("node": "SampleTexture2D", "in": { "texture": "$_Slot" })")) << text_of(made);
        EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
        expect_compiles(made, word);
    };
    expect_slot(import("1, 1, 1"), "white");
    expect_slot(import("1, 1, 1, 1", "color4"), "white");
    expect_slot(import("0.21404114, 0.21404114, 0.21404114"), "gray");
    expect_slot(import("0, 0, 0"), "black");
    expect_slot(import(""), "black");
    // No texture has this colour.
    const Imported red = import("1, 0, 0");
    EXPECT_TRUE(has(red, R"("baseColor": [1, 0, 0])")) << text_of(red);
    EXPECT_EQ(remarks(red, Remark::Kind::Changed),
              "NG/image 'picture': 'surface.baseColor': it names no picture: its default value\n");
    const Imported normal = import_mtlx(material(
        R"(<gltf_pbr name="shader" type="surfaceshader"><input name="normal" type="vector3" nodegraph="NG" output="out"/></gltf_pbr>)",
        R"(<nodegraph name="NG"><input name="slot" type="filename" value=""/><image name="picture" type="vector3"><input name="file" type="filename" interfacename="slot"/></image><normalmap name="bumps" type="vector3"><input name="in" type="vector3" nodename="picture"/></normalmap><output name="out" type="vector3" nodename="bumps"/></nodegraph>)"));
    EXPECT_TRUE(has(normal, R"("usage": "normal", "default": "bump")")) << text_of(normal);
    expect_compiles(normal, "a normal map without a picture");
}

// The order of the document, not that in which the surface reads them.
TEST(MtlxTexture, PropertiesKeepTheirOrder) {
    save("a.png", "no picture");
    const Imported made = import_mtlx(material(
        R"(<gltf_pbr name="shader" type="surfaceshader"><input name="base_color" type="color3" nodegraph="NG" output="color"/><input name="roughness" type="float" nodegraph="NG" output="r"/><input name="metallic" type="float" nodegraph="NG" output="m"/></gltf_pbr>)",
        R"(<nodegraph name="NG"><input name="rough" type="float" value="1"/><input name="metal" type="float" value="0"/><input name="picture" type="filename" value="a.png"/>
<image name="image" type="color3"><input name="file" type="filename" interfacename="picture"/></image>
<output name="color" type="color3" nodename="image"/><output name="r" type="float" interfacename="rough"/><output name="m" type="float" interfacename="metal"/></nodegraph>)"));
    const std::string& text = text_of(made);
    EXPECT_LT(text.find("\"_Rough\""), text.find("\"_Metal\"")) << text;
    EXPECT_LT(text.find("\"_Metal\""), text.find("\"_Picture\"")) << text;
}

// "wood_[age].png" has the text of the nearest token of that name.
TEST(MtlxTexture, NamesOfFilesHaveTokens) {
    save("wood_old_2k.png", "no picture");
    const Imported made = import_mtlx(material(
        R"(<gltf_pbr name="shader" type="surfaceshader"><input name="base_color" type="color3" nodegraph="wood" output="out"/></gltf_pbr>)",
        R"(<token name="age" type="string" value="new"/><token name="size" type="string" value="2k"/>
<token name="idle" type="string" value="x"/>
<nodegraph name="wood"><token name="age" type="string" value="old"/>
<image name="texels" type="color3"><input name="file" type="filename" value="wood_[age]_[size].png"/></image>
<output name="out" type="color3" nodename="texels"/></nodegraph>)"));
    EXPECT_TRUE(has(made, "wood_old_2k.png")) << text_of(made);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    const std::string taken = remarks(made, Remark::Kind::Taken);
    EXPECT_NE(taken.find("wood/token 'age': its text is in names of files\n"), taken.npos) << taken;
    EXPECT_NE(taken.find("token 'size': its text is in names of files\n"), taken.npos) << taken;
    EXPECT_NE(taken.find("token 'idle': no name of a file has it\n"), taken.npos) << taken;
}

}  // namespace
}  // namespace patina::importers
