// MaterialX documents: what they become; every row of the table of nodes and every input of the surface shaders. All
// documents are written here.
#include <map>
#include <set>

#include "compiler/base/text.h"
#include "compiler/importers/mtlx/colors.h"
#include "compiler/importers/mtlx/graph_maker.h"
#include "tests/unit/importers/mtlx/mtlx_document.h"

namespace patina::importers {
namespace {

// --- what a document becomes

TEST(MtlxImport, ChainsOfNodesAreExpressions) {
    save("planks.png", "no picture");
    const Imported made = import_mtlx(material(R"(<gltf_pbr name="shader" type="surfaceshader">
  <input name="base_color" type="color3" nodegraph="grain" output="color"/>
  <input name="roughness" type="float" nodegraph="grain" output="gloss"/>
  <input name="metallic" type="float" value="0"/></gltf_pbr>)",
                                               std::string(kWood)));
    EXPECT_EQ(text_of(made), R"x({
  "patina": 1,
  "kind": "material",
  "name": "paint",
  "workflow": "metallic-roughness",
  "lighting": "gltf",
  "properties": [
    { "name": "_Tint", "type": "color", "default": [0.5, 0.25, 0.125], "label": "Tint", "group": "Wood" },
    { "name": "_Rings", "type": "float", "default": 8, "range": [1, 20] },
    { "name": "_Planks", "type": "texture2d", "default": "./planks.png" }
  ],
  "nodes": [
    { "id": "planks", "node": "SampleTexture2D", "in": { "texture": "$_Planks" } },
    { "id": "wave", "expr": "sin(length(@positionOS * $_Rings))" }
  ],
  "surface": { "baseColor": "= lerp($_Tint.rgb, planks.rgb, wave)", "roughness": "wave" }
}
)x");
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    expect_compiles(made, "wood");
}

TEST(MtlxImport, ANormalMapIsSampledAsOne) {
    save("bumps.png", "no picture");
    const Imported made = import_mtlx(material(
        R"(<standard_surface name="shader" type="surfaceshader"><input name="normal" type="vector3" nodename="bumps"/></standard_surface>)",
        R"(<image name="texels" type="vector3"><input name="file" type="filename" value="bumps.png"/></image>
<normalmap name="bumps" type="vector3"><input name="in" type="vector3" nodename="texels"/><input name="scale" type="float" value="0.5"/></normalmap>)"));
    const std::string& text = text_of(made);
    EXPECT_NE(text.find(R"("usage": "normal")"), text.npos) << text;
    EXPECT_NE(text.find(R"("node": "SampleNormalMap", "in": { "texture": "$_Bumps", "scale": 0.5 })"), text.npos)
        << text;
    EXPECT_NE(text.find(R"("normalTS": "bumps")"), text.npos) << text;
    expect_compiles(made, "bumps");
}

TEST(MtlxImport, CoordinatesAreCountedFromTheTop) {
    save("t.png", "no picture");
    const auto coordinates = [&](const std::string& node, const std::string& inputs) {
        return text_of(import_mtlx(one_node(
            fmt::format(
                R"(<{0} name="tested" type="color3"><input name="file" type="filename" value="t.png"/>{1}</{0}>)", node,
                inputs),
            "color3")));
    };
    std::string text = coordinates("image", "");
    EXPECT_EQ(text.find("uv"), text.npos) << text;
    text = coordinates("tiledimage", R"(<input name="uvtiling" type="vector2" value="4, 4"/>)");
    EXPECT_NE(text.find(R"("expr": "@uv0 * 4")"), text.npos) << text;
    // v' = 1.5 v - 0.25 from the bottom is 1 - (1.5 (1 - t) - 0.25) = 1.5 t - 0.25 from the top, and 0.75 more is a
    // tile.
    text = coordinates(
        "tiledimage",
        R"(<input name="uvtiling" type="vector2" value="1, 1.5"/><input name="uvoffset" type="vector2" value="0, 0.25"/>)");
    EXPECT_NE(text.find(R"x("expr": "@uv0 * float2(1, 1.5) + float2(0, 0.75)")x"), text.npos) << text;
}

// A product of two calls is no call.
TEST(MtlxImport, ProductsOfVectorsStayProducts) {
    const Imported made = import_mtlx(one_node(
        R"(<combine2 name="a" type="vector2"><input name="in1" type="float" nodename="s"/><input name="in2" type="float" nodename="c"/></combine2>
<position name="place" type="vector3"/><extract name="s" type="float"><input name="in" type="vector3" nodename="place"/></extract>
<sin name="c" type="float"><input name="in" type="float" nodename="s"/></sin>
<combine2 name="b" type="vector2"><input name="in1" type="float" nodename="c"/><input name="in2" type="float" value="2"/></combine2>
<multiply name="product" type="vector2"><input name="in1" type="vector2" nodename="a"/><input name="in2" type="vector2" nodename="b"/></multiply>
<extract name="tested" type="float"><input name="in" type="vector2" nodename="product"/><input name="index" type="integer" value="1"/></extract>)",
        "float"));
    EXPECT_NE(text_of(made).find("(float2(@positionOS.x, c) * float2(c, 2)).y"), std::string::npos) << text_of(made);
    expect_compiles(made, "product");
}

TEST(MtlxImport, ColoursBecomeLinear) {
    const auto color = [&](const std::string& space) {
        return text_of(import_mtlx(material(fmt::format(
            R"(<gltf_pbr name="shader" type="surfaceshader"><input name="base_color" type="color3" value="0.5, 1, 0" colorspace="{}"/></gltf_pbr>)",
            space))));
    };
    EXPECT_NE(color("lin_rec709").find("\"baseColor\": [0.5, 1, 0]"), std::string::npos);
    EXPECT_NE(color("srgb_texture").find("\"baseColor\": [0.21404114, 1, 0]"), std::string::npos)
        << color("srgb_texture");
    // White stays white in all of them.
    for (const std::string_view space : {"acescg", "lin_adobergb", "lin_displayp3", "g22_ap1", "srgb_displayp3"}) {
        std::vector<double> white = {1, 1, 1};
        mtlx::to_linear(mtlx::colorspace_of(space), white);
        for (const double each : white) EXPECT_NEAR(each, 1, 1e-5) << space;
    }
}

TEST(MtlxImport, DefinitionsInTheDocumentAreReplacedByWhatImplementsThem) {
    const Imported made = import_mtlx(one_node(R"(
<nodedef name="ND_twice" node="twice"><input name="in" type="float" value="0.25"/><input name="more" type="float" value="0.125"/><output name="out" type="float"/></nodedef>
<nodegraph name="NG_twice" nodedef="ND_twice">
  <multiply name="product" type="float"><input name="in1" type="float" interfacename="in"/><input name="in2" type="float" value="2"/></multiply>
  <add name="sum" type="float"><input name="in1" type="float" nodename="product"/><input name="in2" type="float" interfacename="more"/></add>
  <output name="out" type="float" nodename="sum"/>
</nodegraph>
<texcoord name="place" type="vector2"/>
<extract name="u" type="float"><input name="in" type="vector2" nodename="place"/><input name="index" type="integer" value="0"/></extract>
<twice name="first" type="float"><input name="in" type="float" nodename="u"/></twice>
<twice name="tested" type="float"><input name="in" type="float" nodename="first"/><input name="more" type="float" value="0"/></twice>)",
                                               "float"));
    EXPECT_NE(text_of(made).find(R"("roughness": "= (@uv0.x * 2 + 0.125) * 2")"), std::string::npos) << text_of(made);
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    expect_compiles(made, "definitions");
}

TEST(MtlxImport, EachMaterialIsAGraph) {
    const Imported made = import_mtlx(document(R"(
<gltf_pbr name="a" type="surfaceshader"/><open_pbr_surface name="b" type="surfaceshader"/>
<surfacematerial name="one" type="material"><input name="surfaceshader" type="surfaceshader" nodename="a"/></surfacematerial>
<surfacematerial name="two" type="material"><input name="surfaceshader" type="surfaceshader" nodename="b"/></surfacematerial>)"));
    EXPECT_NE(text_of(made, "one.graph.json").find(R"("lighting": "gltf")"), std::string::npos);
    EXPECT_NE(text_of(made, "two.graph.json").find(R"("lighting": "openpbr")"), std::string::npos);
}

TEST(MtlxImport, Version136) {
    const Imported made = import_mtlx(document(R"(
<nodegraph name="g"><constant name="c" type="color3"><parameter name="value" type="color3" value="0.25, 0.5, 0.75"/></constant><output name="out" type="color3" nodename="c"/></nodegraph>
<material name="paint"><shaderref name="s" node="standard_surface">
  <bindinput name="base_color" type="color3" nodegraph="g" output="out"/><bindinput name="metalness" type="float" value="1"/></shaderref></material>)",
                                               "version=\"1.36\""));
    EXPECT_NE(text_of(made).find("\"baseColor\": [0.25, 0.5, 0.75]"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find("\"metallic\": 1"), std::string::npos) << text_of(made);
    expect_compiles(made, "1.36");
}

TEST(MtlxImport, AnIncludedFileIsAPart) {
    save("part.mtlx",
         document(
             R"(<constant name="tested" type="float"><input name="value" type="float" value="0.375"/></constant>)"));
    const Imported made = import_mtlx(one_node("<xi:include href=\"part.mtlx\"/>", "float"));
    EXPECT_NE(text_of(made).find("\"roughness\": 0.375"), std::string::npos) << text_of(made);
    const Imported without = import_mtlx(one_node("<xi:include href=\"nothing.mtlx\"/>", "float"));
    EXPECT_NE(remarks(without, Remark::Kind::LeftOut).find("include 'nothing.mtlx': the file is not there"),
              std::string::npos);
    EXPECT_TRUE(without.has_refused);
}

// --- the tables

// A literal of a type.
std::string value_of(std::string_view type, int seed) {
    if (type == "boolean") return seed % 2 == 0 ? "true" : "false";
    if (type == "integer") return std::to_string(seed % 3);
    std::string text;
    const std::size_t width = type == "matrix33"   ? 9
                              : type == "matrix44" ? 16
                                                   : std::max<std::size_t>(terms::width(mtlx::type_of_word(type)), 1);
    for (std::size_t i = 0; i < width; ++i)
        text += (i > 0 ? ", " : "") + fmt::format("0.{}", 1 + (static_cast<std::size_t>(seed) + 2 * i) % 8);
    return text;
}

// The condition's words as inputs and a type: "space=world", "in.type=float", "set:iny".
struct Case {
    std::string type{}, inputs{};
};
Case case_of(const mtlx::TableRow& row, const std::string& free_type, bool is_linked) {
    Case made{.type = free_type};
    std::map<std::string, std::string> types, words;
    std::set<std::string> unset;
    for (const std::string_view word : split(row.condition, " ")) {
        const std::size_t equals = std::min(word.find('='), word.size());
        const std::string what(word.substr(0, equals)), wanted(word.substr(std::min(equals + 1, word.size())));
        const std::string first = wanted.substr(0, wanted.find('|'));
        if (what == "type")
            made.type = first;
        else if (what.ends_with(".type"))
            types[what.substr(0, what.size() - 5)] = first;
        else if (word.starts_with("unset:"))
            unset.insert(std::string(word.substr(6)));
        else if (!word.starts_with("set:"))
            words[what] = first;
    }
    for (const auto& [name, word] : words) {
        const std::string type = word == "true" || word == "false" ? "boolean" : "string";
        made.inputs += fmt::format("<input name=\"{}\" type=\"{}\" value=\"{}\"/>", name, type, word);
    }
    int seed = 1;
    for (const std::string_view part : split(row.inputs, "; ")) {
        const std::size_t end = part.find_first_of(":=");
        const std::string name(part.substr(0, end));
        std::string type = part[end] == ':' ? std::string(part.substr(end + 1, part.find('=') - end - 1)) : made.type;
        if (types.contains(name)) type = types[name];
        if (unset.contains(name)) continue;
        ++seed;
        const bool has_link = is_linked && type != "boolean" && type != "integer" && !type.starts_with("matrix");
        made.inputs +=
            has_link ? fmt::format("<input name=\"{}\" type=\"{}\" nodename=\"source_{}\"/>", name, type, type)
                     : fmt::format("<input name=\"{}\" type=\"{}\" value=\"{}\"/>", name, type, value_of(type, seed));
    }
    return made;
}

// The types that a row without a condition has in the standard library.
std::vector<std::string> types_of(const mtlx::TableRow& row) {
    const std::set<std::string_view> of_float = {"dotproduct", "magnitude",    "distance",    "determinant",
                                                 "extract",    "geomcolor",    "facingratio", "ambientocclusion",
                                                 "time",       "frame",        "randomfloat", "circle",
                                                 "line",       "trianglewave", "cloverleaf"};
    const std::set<std::string_view> of_vector3 = {
        "crossproduct",    "reflect",  "refract", "rotate3d", "transformpoint", "transformvector", "transformnormal",
        "transformmatrix", "position", "normal",  "tangent",  "bitangent",      "viewdirection",   "bump",
        "heighttonormal",  "combine3"};
    const std::set<std::string_view> of_vector2 = {"rotate2d", "place2d", "UsdTransform2d", "roughness_anisotropy"};
    const std::set<std::string_view> of_color4 = {"premult", "unpremult", "in",           "out",     "mask",
                                                  "over",    "matte",     "disjointover", "combine4"};
    const std::set<std::string_view> of_color3 = {"luminance",    "rgbtohsv",  "hsvtorgb",     "hsvadjust",
                                                  "saturate",     "grid",      "tiledcircles", "randomcolor",
                                                  "checkerboard", "blackbody", "crosshatch"};
    const std::set<std::string_view> of_boolean = {"and", "or", "xor", "not"};
    const std::string_view node = row.category;
    if (of_float.contains(node)) return {"float"};
    if (node.ends_with("_to_lin_rec709")) return {row.condition.empty() ? "color3" : "color4"};
    if (of_vector3.contains(node)) return {"vector3"};
    if (of_vector2.contains(node)) return {"vector2"};
    if (of_color4.contains(node)) return {"color4"};
    if (of_color3.contains(node)) return {"color3"};
    if (of_boolean.contains(node)) return {"boolean"};
    if (node == "creatematrix" || node == "transpose") return {"matrix33"};
    if (node == "combine2")
        return row.condition == "in1.type=float" ? std::vector<std::string>{"vector2"}
                                                 : std::vector<std::string>{"color4"};
    if (node == "normalize") return {"vector2", "vector3", "vector4"};
    return {"float", "vector2", "vector3", "vector4", "color3", "color4"};
}

TEST(MtlxImport, EachRowOfTheTableCompiles) {
    std::size_t count = 0;
    for (const mtlx::TableRow& row : mtlx::table_rows()) {
        if (row.remark.starts_with("!")) continue;
        for (const std::string& type : types_of(row)) {
            for (const bool is_linked : {true, false}) {
                const Case each = case_of(row, type, is_linked);
                if (!is_linked && type != types_of(row)[0]) continue;  // constants of one type
                std::string output = "out";
                if (row.outputs.starts_with("outx")) output = "outy";
                const std::string result = output == "out" ? each.type : "float";
                const Imported made =
                    import_mtlx(one_node(sources() + fmt::format("<{0} name=\"tested\" type=\"{1}\">{2}</{0}>",
                                                                 row.category, each.type, each.inputs),
                                         result, output));
                const std::string what = fmt::format("{} {} '{}'", row.category, each.type, row.condition);
                EXPECT_FALSE(made.has_refused) << what << remarks(made, Remark::Kind::LeftOut);
                EXPECT_EQ(!remarks(made, Remark::Kind::Changed).empty(), row.remark.starts_with("~"))
                    << what << remarks(made, Remark::Kind::Changed);
                expect_compiles(made, what, is_linked && type == types_of(row)[0]);
                ++count;
            }
        }
    }
    EXPECT_GT(count, 300u);
}

// What reads an input that the document does not set.
TEST(MtlxImport, EachRowOfTheTableCompilesWithItsDefaults) {
    for (const mtlx::TableRow& row : mtlx::table_rows()) {
        const bool has_channels = row.outputs.starts_with("outx");
        if (row.remark.starts_with("!") || !row.condition.empty() || has_channels) continue;
        for (const std::string& type : types_of(row)) {
            if (type == "float" || type == "boolean" || type == "matrix33") continue;
            // A component of the result: a number that stands for a vector has none.
            const Imported made = import_mtlx(
                one_node(fmt::format("<{0} name=\"whole\" type=\"{1}\"/><absval name=\"one\" type=\"{1}\"><input "
                                     "name=\"in\" type=\"{1}\" nodename=\"whole\"/></absval><extract name=\"tested\" "
                                     "type=\"float\"><input name=\"in\" type=\"{1}\" nodename=\"one\"/><input "
                                     "name=\"index\" type=\"integer\" value=\"1\"/></extract>",
                                     row.category, type),
                         "float"));
            expect_compiles(made, fmt::format("{} {}", row.category, type), false);
        }
    }
}

// Equal numbers stand for a vector, but not where components are read.
TEST(MtlxImport, CoordinatesMayBeNumbers) {
    for (const auto& [node, type] :
         {std::pair("checkerboard", "color3"), std::pair("grid", "color3"), std::pair("tiledcircles", "color3"),
          std::pair("ramp4", "color3"), std::pair("circle", "float"), std::pair("line", "float")}) {
        const Imported made = import_mtlx(one_node(
            fmt::format(
                R"(<{0} name="tested" type="{1}"><input name="texcoord" type="vector2" value="0.5,0.5"/></{0}>)", node,
                type),
            type));
        expect_compiles(made, node, false);
    }
}

TEST(MtlxImport, NodesWithFunctionsOfTheirOwnCompile) {
    save("t.png", "no picture");
    const std::string file = R"(<input name="file" type="filename" value="t.png"/>)";
    struct Special {
        std::string node{}, type{}, inputs{}, output = "out";
    };
    std::vector<Special> all = {
        {"UsdUVTexture", "color3", file + R"(<input name="scale" type="color4" value="2,2,2,1"/>)", "rgb"},
        {"UsdUVTexture", "color3", file, "g"},
        {"gltf_image", "vector3",
         file + R"(<input name="scale" type="vector2" value="2,2"/><input name="rotate" type="float" value="30"/>)"},
        {"gltf_colorimage", "color3", file + R"(<input name="color" type="color4" nodename="source_color4"/>)",
         "outcolor"},
        {"gltf_normalmap", "vector3", file},
        {"triplanarprojection", "color3",
         R"(<input name="filex" type="filename" value="t.png"/><input name="filey" type="filename" value="t.png"/><input name="filez" type="filename" value="t.png"/>)"},
        {"hextiledimage", "color3", file},
        {"hextiledimage", "color4",
         file +
             R"(<input name="tiling" type="vector2" value="4,4"/><input name="rotation" type="float" nodename="source_float"/>)"},
        {"hextilednormalmap", "vector3", file + R"(<input name="strength" type="float" value="0.5"/>)"},
        {"texcoord", "vector2", ""},
        {"texcoord", "vector2", R"(<input name="index" type="integer" value="1"/>)"},
        {"geompropvalue", "vector2", R"(<input name="geomprop" type="string" value="st"/>)"},
        {"UsdPrimvarReader", "color3", R"(<input name="varname" type="string" value="displayColor"/>)"},
        {"extract", "float",
         R"(<input name="in" type="vector3" nodename="source_vector3"/><input name="index" type="integer" nodename="source_float"/>)"},
        {"swizzle", "vector4",
         R"(<input name="in" type="color3" nodename="source_color3"/><input name="channels" type="string" value="bg01"/>)"},
        {"switch", "color3",
         R"(<input name="in1" type="color3" nodename="source_color3"/><input name="in2" type="color3" value="1,0,0"/><input name="in3" type="color3" value="0,1,0"/><input name="which" type="float" nodename="source_float"/>)"},
        {"normalmap", "vector3",
         R"(<input name="in" type="vector3" nodename="source_vector3"/><input name="scale" type="float" value="0.5"/>)"},
        {"normalmap", "vector3",
         R"(<input name="in" type="vector3" nodename="source_vector3"/><input name="space" type="string" value="object"/>)"},
        {"colorcorrect", "color3",
         R"(<input name="in" type="color3" nodename="source_color3"/><input name="hue" type="float" value="0.1"/><input name="saturation" type="float" nodename="source_float"/><input name="gamma" type="float" value="2"/><input name="lift" type="float" value="0.1"/><input name="gain" type="float" value="2"/><input name="contrast" type="float" value="0.5"/><input name="exposure" type="float" value="1"/>)"},
        {"colorcorrect", "color4",
         R"(<input name="in" type="color4" nodename="source_color4"/><input name="gain" type="float" value="2"/>)"},
        {"ramp", "color4",
         R"(<input name="num_intervals" type="integer" value="3"/><input name="interval2" type="float" value="0.3"/><input name="color2" type="color4" nodename="source_color4"/>)"},
        {"ramp", "color4",
         R"(<input name="type" type="integer" value="2"/><input name="interpolation" type="integer" value="0"/>)"},
        {"gltf_image", "color3",
         file +
             R"(<input name="factor" type="color3" value="1,0.5,0"/><input name="offset" type="vector2" value="0.5,0"/>)"},
        {"cellnoise2d", "float", ""},
        {"cellnoise3d", "float", R"(<input name="position" type="vector3" nodename="source_vector3"/>)"}};
    for (const std::string_view type : {"float", "vector2", "vector3", "vector4", "color3", "color4"}) {
        for (const std::string_view node : {"image", "tiledimage"})
            all.push_back({std::string(node), std::string(type), file});
        for (const std::string_view node : {"noise2d", "noise3d", "fractal2d", "fractal3d"})
            all.push_back(
                {std::string(node), std::string(type),
                 fmt::format(
                     R"(<input name="amplitude" type="{}" value="{}"/><input name="pivot" type="float" value="0.5"/><input name="octaves" type="integer" value="4"/>)",
                     type, value_of(type, 2))});
        for (const std::string_view from : {"float", "vector2", "vector3", "vector4", "color3", "color4"})
            all.push_back({"convert", std::string(type),
                           fmt::format(R"(<input name="in" type="{0}" nodename="source_{0}"/>)", from)});
    }
    for (const std::string_view type : {"float", "vector2", "vector3"})
        for (const std::string_view node : {"worleynoise2d", "worleynoise3d"})
            all.push_back({std::string(node), std::string(type), R"(<input name="jitter" type="float" value="0.5"/>)"});
    std::set<std::string, std::less<>> tested;
    for (const Special& each : all) {
        const std::string result = each.output == "out" ? each.type : each.output.size() == 1 ? "float" : "color3";
        const Imported made = import_mtlx(one_node(
            sources() + fmt::format("<{0} name=\"tested\" type=\"{1}\">{2}</{0}>", each.node, each.type, each.inputs),
            result, each.output));
        EXPECT_FALSE(made.has_refused) << each.node << remarks(made, Remark::Kind::LeftOut);
        expect_compiles(made, each.node + " " + each.type, tested.insert(each.node).second);
    }
    for (const std::string_view each : mtlx::special_nodes())
        EXPECT_TRUE(tested.contains(each) || each == "geompropvalueuniform" || each == "UsdUvTexture") << each;
}

// The nodes are named here, so that another name is no silent change; tests/data/noise_values.py has their values.
TEST(MtlxImport, NoiseIsANodeOfTheLibrary) {
    const std::pair<std::string, std::string> noises[] = {
        {"noise2d", "PerlinNoise2D"},       {"noise3d", "PerlinNoise3D"},       {"fractal2d", "PerlinFractal2D"},
        {"fractal3d", "PerlinFractal3D"},   {"cellnoise2d", "CellNoise2D"},     {"cellnoise3d", "CellNoise3D"},
        {"worleynoise2d", "WorleyNoise2D"}, {"worleynoise3d", "WorleyNoise3D"},
    };
    for (const auto& [noise, node] : noises) {
        for (const std::string type : {"float", "vector3"}) {
            const Imported made =
                import_mtlx(one_node(fmt::format("<{0} name=\"tested\" type=\"{1}\"/>", noise, type), type));
            EXPECT_EQ(made.graphs.size(), 1u) << noise;
            EXPECT_NE(text_of(made).find("\"node\": \"" + node), std::string::npos) << text_of(made);
            EXPECT_EQ(remarks(made, Remark::Kind::Changed), "") << noise;
        }
    }
}

// Its style asks for the random numbers of cells; a float has another one than a vector.
TEST(MtlxImport, WorleyNoiseHasNumbersOfCells) {
    for (const auto& [type, word] : {std::pair<std::string, std::string>{"float", "Cell"}, {"vector3", "CellVector"}}) {
        const Imported made = import_mtlx(one_node(
            fmt::format(
                R"(<worleynoise2d name="tested" type="{}"><input name="style" type="integer" value="1"/></worleynoise2d>)",
                type),
            type));
        EXPECT_NE(text_of(made).find("\"style\": \"" + word + "\""), std::string::npos) << text_of(made);
        EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    }
}

// The value of an input of the surface, with what it reads.
std::vector<double> computed(const Imported& made, const std::string& key, const std::vector<double>& uv) {
    static const Compiler compiler;
    std::vector<NamedValue> names = {{.name = "uv0", .values = uv}};
    const std::string& text = text_of(made);
    const auto run = [&](std::string expression) {
        for (std::size_t at; (at = expression.find('@')) != expression.npos;) expression.erase(at, 1);
        const EvalResult result = compiler.evaluate_expression(expression, names);
        EXPECT_TRUE(result.ok) << expression;
        return result.ok ? result.outputs[0].values : std::vector<double>();
    };
    const auto quoted = [&](std::size_t at) { return text.substr(at, text.find('"', at) - at); };
    for (std::size_t at = 0; (at = text.find("\"id\": \"", at)) != text.npos; ++at)
        names.push_back({.name = quoted(at + 7), .values = run(quoted(text.find("\"expr\": \"", at) + 9))});
    const std::size_t at = text.find("\"" + key + "\": ") + key.size() + 4;
    if (text[at] != '"') return {std::stod(text.substr(at))};  // what is constant is a number
    return run(text[at + 1] == '=' ? quoted(at + 3) : quoted(at + 1));
}

// The numbers are those of the node graphs in the standard library, computed apart from this program.
TEST(MtlxImport, ColourTransformsAreThoseOfTheLibrary) {
    const std::pair<std::string, std::vector<double>> transforms[] = {
        {"g18_rec709", {0.287174589, 0.0824692444, 0.000874689659}},
        {"g22_rec709", {0.217637641, 0.0473661427, 0.000182922021}},
        {"rec709_display", {0.189464571, 0.0358968236, 8.36511642e-05}},
        {"acescg", {0.695412289, 0.219862009, -0.0211844758}},
        {"g22_ap1", {0.341616151, 0.025684891, -0.0111218928}},
        {"srgb_texture", {0.21404114, 0.0508760882, 0.00154798762}},
        {"lin_adobergb", {0.599588934, 0.25, 0.0101263325}},
        {"adobergb", {0.285610671, 0.04741747, -0.00184422544}},
        {"lin_displayp3", {0.556232726, 0.239485395, -0.00751684}},
        {"srgb_displayp3", {0.250741934, 0.0440135947, -0.00650520334}},
    };
    for (const auto& [name, wanted] : transforms) {
        const Imported made = import_mtlx(one_node(
            fmt::format(
                R"(<{0}_to_lin_rec709 name="tested" type="color3"><input name="in" type="color3" value="0.5, 0.25, 0.02"/></{0}_to_lin_rec709>)",
                name),
            "color3"));
        const std::vector<double> values = computed(made, "baseColor", {0, 0});
        ASSERT_EQ(values.size(), 3u) << name;
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(values[i], wanted[i], 1e-6) << name << i;
    }
}

TEST(MtlxImport, PatternsAreThoseOfTheLibrary) {
    const std::string tiles = R"(<input name="uvtiling" type="vector2" value="4, 4"/>)",
                      staggered = tiles + R"(<input name="staggered" type="boolean" value="true"/>)";
    struct Case {
        std::string node, type, inputs;
        std::vector<double> at;  // v from the bottom
        double wanted;
    };
    const Case cases[] = {
        {"cloverleaf", "float", "", {0.24, 0.1}, 1},
        {"cloverleaf", "float", "", {0.4, 0.15}, 1},
        {"cloverleaf", "float", "", {0.92, 0.8}, 0},
        {"cloverleaf", "float", "", {0.77, 0.22}, 0},
        {"crosshatch", "color3", tiles, {0.54, 0.28}, 0},
        {"crosshatch", "color3", tiles, {0.17, 0.11}, 0},
        {"crosshatch", "color3", tiles, {0.55, 0.3}, 1},
        {"crosshatch", "color3", tiles, {0.28, 0.53}, 1},
        {"crosshatch", "color3", staggered, {0.47, 0.34}, 1},
        {"crosshatch", "color3", staggered, {1, 0.2}, 0},
        {"crosshatch", "color3", staggered, {0.41, 0.2}, 0},
        {"crosshatch", "color3", staggered, {0.9, 0.1}, 1},
        {"tiledcircles", "color3", staggered, {0.06, 0.23}, 0},
        {"tiledcircles", "color3", staggered, {0.77, 0.62}, 0},
        {"tiledcircles", "color3", staggered, {0.98, 0.42}, 1},
        {"tiledcircles", "color3", staggered, {0.77, 0.41}, 1},
    };
    for (const Case& each : cases) {
        const Imported made = import_mtlx(one_node(
            fmt::format(R"(<{0} name="tested" type="{1}">{2}</{0}>)", each.node, each.type, each.inputs), each.type));
        const std::vector<double> values =
            computed(made, each.type == "float" ? "roughness" : "baseColor", {each.at[0], 1 - each.at[1]});
        ASSERT_FALSE(values.empty());
        EXPECT_EQ(values[0], each.wanted) << each.node << " " << each.at[0] << ", " << each.at[1] << text_of(made);
    }
}

// By the library's node graph: amplitude and pivot are 0.5, places are multiplied and moved, and the result is clamped.
TEST(MtlxImport, UnifiedNoiseIsOneOfTheOthers) {
    const auto import = [](const std::string& node, const std::string& inputs) {
        const Imported made =
            import_mtlx(one_node(fmt::format(R"(<{0} name="tested" type="float">{1}</{0}>)", node, inputs), "float"));
        EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
        EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
        expect_compiles(made, node + inputs);
        return made;
    };
    const auto type = [](int index) { return fmt::format(R"(<input name="type" type="integer" value="{}"/>)", index); };
    const auto has = [](const Imported& made, const std::string& part) {
        return text_of(made).find(part) != std::string::npos;
    };
    Imported made = import("unifiednoise3d", R"(<input name="freq" type="vector3" value="2,2,2"/>)");
    EXPECT_TRUE(has(made, R"("node": "PerlinNoise3D", "in": { "position": "moved" })")) << text_of(made);
    EXPECT_TRUE(has(made, R"("id": "moved", "expr": "@positionOS * 2")")) << text_of(made);
    EXPECT_TRUE(has(made, "perlin * 0.5 + 0.5")) << text_of(made);
    EXPECT_TRUE(has(made, "clamp(")) << text_of(made);
    EXPECT_EQ(remarks(made, Remark::Kind::Taken).find("perlin"), std::string::npos);
    made = import("unifiednoise3d", type(1) + R"(<input name="clampoutput" type="boolean" value="false"/>)");
    EXPECT_TRUE(has(made, R"("node": "CellNoise3D")")) << text_of(made);
    EXPECT_FALSE(has(made, "clamp(")) << text_of(made);
    made = import("unifiednoise2d", type(2) + R"(<input name="jitter" type="float" value="0.25"/>)");
    EXPECT_TRUE(has(made, R"("node": "WorleyNoise2D")")) << text_of(made);
    EXPECT_TRUE(has(made, R"("jitter": 0.25)")) << text_of(made);
    EXPECT_FALSE(has(made, "Rotate(")) << text_of(made);
    made = import("unifiednoise2d", type(3) + R"(<input name="octaves" type="integer" value="5"/>)");
    EXPECT_TRUE(has(made, R"("node": "PerlinFractal3D")")) << text_of(made);
    EXPECT_TRUE(has(made, R"("octaves": 5)")) << text_of(made);
    // It is turned by (0.5 - 1) * 90000 degrees.
    made = import("unifiednoise2d", R"(<input name="jitter" type="float" value="0.5"/>)");
    EXPECT_TRUE(has(made, "-radians(-45000)")) << text_of(made);
}

// 0.6 is not below 0.3, so it is the second value. Versions before 1.37 had this node.
TEST(MtlxImport, CompareHasTheSecondValueFromTheCutoffOn) {
    for (const auto& [tested, wanted] : {std::pair(0.6, 0.75), std::pair(0.3, 0.75), std::pair(0.2, 0.25)}) {
        const Imported made = import_mtlx(one_node(
            fmt::format(
                R"(<compare name="tested" type="float"><input name="intest" type="float" value="{}"/><parameter name="cutoff" type="float" value="0.3"/><input name="in1" type="float" value="0.25"/><input name="in2" type="float" value="0.75"/></compare>)",
                tested),
            "float"));
        EXPECT_EQ(computed(made, "roughness", {0, 0}).at(0), wanted) << tested;
    }
}

// sqrt(1 - 0.75) is 0.5: 0.36 is 0.72 along the tangent, and 0.18 across it.
TEST(MtlxImport, RoughnessAnisotropyStretches) {
    const Imported made = import_mtlx(one_node(
        R"(<roughness_anisotropy name="both" type="vector2"><input name="roughness" type="float" value="0.6"/><input name="anisotropy" type="float" value="0.75"/></roughness_anisotropy>
<convert name="tested" type="color3"><input name="in" type="vector2" nodename="both"/></convert>)",
        "color3"));
    const std::vector<double> values = computed(made, "baseColor", {0, 0});
    EXPECT_NEAR(values.at(0), 0.72, 1e-6) << text_of(made);
    EXPECT_NEAR(values.at(1), 0.18, 1e-6) << text_of(made);
}

TEST(MtlxImport, EachInputOfASurfaceShaderIsCarriedOver) {
    for (const std::string_view shader : mtlx::surface_shaders()) {
        const mtlx::SurfaceRule& rule = *mtlx::surface_rule(shader);
        const bool is_specular = shader.ends_with(" specular");
        std::string inputs = is_specular ? R"(<input name="useSpecularWorkflow" type="integer" value="1"/>)" : "";
        for (const mtlx::Port& port : rule.rule.inputs) {
            if (port.name == "useSpecularWorkflow" || port.name == "alpha_mode") continue;
            const bool is_linked = port.type != "integer" && port.type != "boolean";
            inputs += is_linked ? fmt::format(R"(<input name="{}" type="{}" nodename="source_{}"/>)", port.name,
                                              port.type, port.type)
                                : fmt::format(R"(<input name="{}" type="{}" value="1"/>)", port.name, port.type);
        }
        if (shader == "gltf_pbr") inputs += R"(<input name="alpha_mode" type="integer" value="1"/>)";
        const std::string category(shader.substr(0, shader.find(' ')));
        const Imported made = import_mtlx(
            material(fmt::format(R"(<{0} name="shader" type="surfaceshader">{1}</{0}>)", category, inputs), sources()));
        EXPECT_FALSE(made.has_refused) << shader << remarks(made, Remark::Kind::LeftOut);
        for (const mtlx::Statement& each : rule.rule.statements) {
            if (each.output.starts_with("normal")) continue;
            EXPECT_NE(text_of(made).find("\"" + each.output + "\""), std::string::npos)
                << shader << " " << each.output << text_of(made);
        }
        expect_compiles(made, std::string(shader));
        for (const mtlx::SurfaceRule::Ignored& each : rule.ignored) {
            const Imported other = import_mtlx(material(fmt::format(
                R"(<{0} name="shader" type="surfaceshader">{1}<input name="{2}" type="float" value="0.75"/></{0}>)",
                category, is_specular ? inputs.substr(0, inputs.find("/>") + 2) : "", each.input)));
            EXPECT_NE(remarks(other, Remark::Kind::Changed).find(each.text), std::string::npos)
                << shader << " " << each.input;
        }
    }
}

}  // namespace
}  // namespace patina::importers
