// Pictures of MaterialX documents: how they are read, and what their properties say.
#include "tests/unit/importers/mtlx_document.h"

namespace patina::importers {
namespace {

bool has(const Imported& made, const std::string& part) {
    return text_of(made).find(part) != std::string::npos;
}

// The nodes of a normal map, and of a surface that reads it.
Imported normal_map(const std::string& words) {
    save("bumps.png", "no picture");
    return import_text(material(
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
    made = import_text(material(
        R"(<UsdPreviewSurface name="shader" type="surfaceshader"><input name="normal" type="vector3" nodename="texels" output="rgb"/></UsdPreviewSurface>)",
        R"(<UsdUVTexture name="texels" type="multioutput"><input name="file" type="filename" value="bumps.png"/><input name="wrapS" type="string" value="mirror"/><input name="wrapT" type="string" value="mirror"/><input name="scale" type="vector4" value="2,2,2,1"/><input name="bias" type="vector4" value="-1,-1,-1,0"/></UsdUVTexture>)"));
    EXPECT_TRUE(has(made, R"("sampler": { "wrap": "mirror" })")) << text_of(made);
    expect_compiles(made, "mirror");
}

TEST(MtlxTexture, PropertiesKeepTheirDescription) {
    save("a.png", "no picture");
    const Imported made = import_text(material(
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

}  // namespace
}  // namespace patina::importers
