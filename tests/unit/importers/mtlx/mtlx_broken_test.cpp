// MaterialX documents that are broken, hostile or of another time: each is refused at its place, or imported with a
// remark.
#include <random>
#include <regex>

#include "tests/unit/importers/mtlx/mtlx_document.h"

namespace patina::importers {
namespace {

TEST(BrokenMtlx, BrokenFilesAreReportedAtTheirPlace) {
    const std::string good = material(R"(<gltf_pbr name="shader" type="surfaceshader"/>)");
    const auto error = [&](const std::string& text) { return import_mtlx(text).error; };
    for (const std::string& text : {good.substr(0, good.size() / 2), std::string("nonsense"), good + "</x>",
                                    std::string("<materialx version=\"1.38\"><a b=></materialx>")})
        EXPECT_TRUE(std::regex_search(error(text), std::regex("x\\.mtlx:[0-9]+:[0-9]+: "))) << error(text);
    EXPECT_NE(error("").find("the file is empty"), std::string::npos);
    EXPECT_NE(error("<a/>").find("x.mtlx:1:1: the outermost element is 'a'"), std::string::npos) << error("<a/>");
    EXPECT_NE(error(document("")).find("no material and no surface shader"), std::string::npos);
    std::string deep;
    for (int i = 0; i < 5000; ++i) deep += "<a>";
    for (int i = 0; i < 5000; ++i) deep += "</a>";
    EXPECT_NE(error(document(deep)).find("nested more than 32 deep"), std::string::npos);
    const std::string circle =
        one_node(R"(<add name="tested" type="float"><input name="in1" type="float" nodename="other"/></add>
<add name="other" type="float"><input name="in1" type="float" nodename="tested"/></add>)",
                 "float");
    EXPECT_TRUE(std::regex_search(error(circle), std::regex("x\\.mtlx:3:1: 'tested' reads itself"))) << error(circle);
    EXPECT_NE(error(document("<a name=\"x\" name=\"y\"/>")).find("two attributes 'name'"), std::string::npos);
}

TEST(BrokenMtlx, EntitiesOfADocumentTypeAreNotExpanded) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<!DOCTYPE x [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;\"><!ENTITY c "
        "\"&b;&b;&b;&b;\">]>\n";
    const std::string good = material(
        R"(<gltf_pbr name="shader" type="surfaceshader"><input name="base_color" type="color3" value="&c;"/></gltf_pbr>)");
    const Imported made = import_mtlx(text + good.substr(good.find('\n') + 1));
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find("'&c;' is no number"), std::string::npos) << made.error;
}

TEST(BrokenMtlx, WhatIsMissingIsSaid) {
    Imported made = import_mtlx(one_node(R"(<nodeofthefuture name="tested" type="color3"/>)", "color3"));
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find("nodeofthefuture 'tested': 'nodeofthefuture' is no node"),
              std::string::npos)
        << remarks(made, Remark::Kind::LeftOut);
    EXPECT_NE(text_of(made).find("\"float3(1, 0, 1)\""), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find("\"note\": \"not imported: 'nodeofthefuture' is no node"), std::string::npos)
        << text_of(made);
    EXPECT_TRUE(made.has_refused);
    expect_compiles(made, "future");
    made = import_mtlx(one_node("", "color3"));
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find("it reads 'tested', which is not there"), std::string::npos);
    made = import_mtlx(one_node(
        R"(<constant name="tested" type="float"><input name="value" type="float" value="nan"/></constant>)", "float"));
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find("'nan' is no number"), std::string::npos);
    made = import_mtlx(
        one_node(R"(<constant name="tested" type="float"/><constant name="tested" type="float"/>)", "float"));
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find("a second element has this name"), std::string::npos);
    made = import_mtlx(document(R"(<gltf_pbr name="paint" type="surfaceshader"/>)", "version=\"2.5\""));
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("it is 2.5"), std::string::npos);
    made = import_mtlx(one_node(
        R"(<image name="tested" type="color3"><input name="file" type="filename" value="no.png"/></image>)", "color3"));
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("the picture 'no.png' is not there"), std::string::npos);
    made = import_mtlx(
        material(R"(<gltf_pbr name="shader" type="surfaceshader"/>)",
                 R"(<xi:include href="standard_surface_gold.mtlx"/><xi:include href="stdlib/stdlib_defs.mtlx"/>)"));
    EXPECT_EQ(remarks(made, Remark::Kind::LeftOut),
              "include 'standard_surface_gold.mtlx': the file is not there: what it defines is missing\n");
    made = import_mtlx(material(R"(<lama_surface name="shader" type="surfaceshader"/>)"));
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find("'lama_surface' is no surface shader"), std::string::npos);
    expect_compiles(made, "unknown shader");
}

// The report says which octaves there are, and the graph has these.
TEST(BrokenMtlx, OctavesAreWhatTheReportSays) {
    const auto fractal = [](const std::string& octaves) {
        return import_mtlx(one_node(
            fmt::format(
                R"(<fractal3d name="tested" type="float"><input name="octaves" type="{}" value="{}"/></fractal3d>)",
                octaves == "-2.5" ? "float" : "integer", octaves),
            "float"));
    };
    Imported made = fractal("2000000000");
    EXPECT_NE(text_of(made).find("\"octaves\": 16"), std::string::npos) << text_of(made);
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("it has 16 octaves, and not 2e+09"), std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    expect_compiles(made, "many octaves");
    made = fractal("2.5");
    EXPECT_NE(text_of(made).find("\"octaves\": 2 "), std::string::npos) << text_of(made);
    EXPECT_NE(remarks(made, Remark::Kind::Changed)
                  .find("input 'octaves': '2.5' is no whole number of 32 bits: 2 stands for it"),
              std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    made = fractal("-2.5");
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("it has 0 octaves, and not -2.5"), std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    expect_compiles(made, "no octaves");
    // A property of an interface.
    const auto with_interface = [](const std::string& octaves) {
        return import_mtlx(material(
            R"(<gltf_pbr name="shader" type="surfaceshader"><input name="roughness" type="float" nodegraph="NG" output="out"/></gltf_pbr>)",
            fmt::format(
                R"(<nodegraph name="NG"><input name="layers" type="integer" value="{}"/><fractal3d name="f" type="float"><input name="octaves" type="integer" interfacename="layers"/></fractal3d><output name="out" type="float" nodename="f"/></nodegraph>)",
                octaves)));
    };
    made = with_interface("2000000000");
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("it has 16 octaves at most"), std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    expect_compiles(made, "a property of many octaves");
    EXPECT_EQ(remarks(with_interface("4"), Remark::Kind::Changed), "");
}

TEST(BrokenMtlx, LiteralsThatAreNotOfTheirTypeAreSaid) {
    const auto said = [](Remark::Kind kind, const std::string& type, const std::string& value) {
        return remarks(
            import_mtlx(one_node(
                fmt::format(
                    R"(<constant name="tested" type="{0}"><input name="value" type="{0}" value="{1}"/></constant>)",
                    type, value),
                type)),
            kind);
    };
    EXPECT_EQ(said(Remark::Kind::LeftOut, "color3", "0.5, 0.25"),
              "input 'value': '0.5, 0.25' is 2 numbers, and a color3 has 3: what is missing is 0\n");
    EXPECT_EQ(said(Remark::Kind::LeftOut, "color3", ""),
              "input 'value': '' is 0 numbers, and a color3 has 3: what is missing is 0\n");
    EXPECT_EQ(said(Remark::Kind::LeftOut, "vector4", "1 2"),
              "input 'value': '1 2' is 2 numbers, and a vector4 has 4: what is missing is 0, and the fourth component "
              "is 1\n");
    EXPECT_EQ(said(Remark::Kind::LeftOut, "matrix33", "1"),
              "input 'value': '1' is 1 number, and a matrix33 has 9: the identity matrix stands for it\n");
    EXPECT_EQ(said(Remark::Kind::LeftOut, "boolean", "yes"),
              "input 'value': 'yes' is neither true nor false: false stands for it\n");
    EXPECT_EQ(said(Remark::Kind::Changed, "color3", "0.5"),
              "input 'value': '0.5' is 1 number, and a color3 has 3: it stands for each component\n");
    EXPECT_EQ(said(Remark::Kind::Changed, "vector2", "1, 2, 3"),
              "input 'value': '1, 2, 3' is 3 numbers, and a vector2 has 2: the first ones count\n");
    for (const Remark::Kind kind : {Remark::Kind::LeftOut, Remark::Kind::Changed})
        EXPECT_EQ(said(kind, "color3", "0.5, 0.25, 0.125"), "");
}

TEST(BrokenMtlx, ConnectionsOfOtherTypesAreSaid) {
    const auto said = [](const std::string& type, const std::string& source) {
        const Imported made = import_mtlx(one_node(
            sources() +
                fmt::format(
                    R"(<add name="tested" type="{0}"><input name="in1" type="{0}" nodename="source_{1}"/><input name="in2" type="{0}" nodename="source_{0}"/></add>)",
                    type, source),
            type));
        expect_compiles(made, type + " reads " + source, false);
        return remarks(made, Remark::Kind::Changed);
    };
    EXPECT_EQ(said("color3", "vector2"),
              "input 'in1': it takes a color3 and reads 'source_vector2', which is a vector2: what is missing is 0\n");
    EXPECT_EQ(said("color3", "float"),
              "input 'in1': it takes a color3 and reads 'source_float', which is a float: it stands for each "
              "component\n");
    EXPECT_EQ(said("float", "vector3"),
              "input 'in1': it takes a float and reads 'source_vector3', which is a vector3: its first component "
              "counts\n");
    EXPECT_EQ(said("vector2", "color4"),
              "input 'in1': it takes a vector2 and reads 'source_color4', which is a color4: its first 2 components "
              "count\n");
    // The same numbers.
    EXPECT_EQ(said("color3", "vector3"), "");
    const Imported interface = import_mtlx(material(
        R"(<gltf_pbr name="shader" type="surfaceshader"><input name="base_color" type="color3" nodegraph="NG" output="out"/></gltf_pbr>)",
        R"(<nodegraph name="NG"><input name="grey" type="float" value="0.5"/><constant name="c" type="color3"><input name="value" type="color3" interfacename="grey"/></constant><output name="out" type="color3" nodename="c"/></nodegraph>)"));
    EXPECT_EQ(remarks(interface, Remark::Kind::Changed),
              "NG/input 'value': it takes a color3 and reads 'grey', which is a float: it stands for each component\n");
}

TEST(BrokenMtlx, DefinitionsThatUseOneAnotherTwiceEnd) {
    std::string text;
    for (int i = 0; i < 40; ++i)
        text += fmt::format(
            R"(<nodedef name="ND_{0}" node="level{0}"><input name="in" type="float" value="0"/><output name="out" type="float"/></nodedef>
<nodegraph name="NG_{0}" nodedef="ND_{0}"><level{1} name="a" type="float"><input name="in" type="float" interfacename="in"/></level{1}><level{1} name="b" type="float"><input name="in" type="float" nodename="a"/></level{1}><output name="out" type="float" nodename="b"/></nodegraph>)",
            i, i + 1);
    const Imported made = import_mtlx(one_node(text + R"(<level0 name="tested" type="float"/>)", "float"));
    EXPECT_TRUE(made.has_refused);
    EXPECT_LT(made.graphs.empty() ? 0 : made.graphs[0].text.size(), 8u << 20);
}

// Whatever is changed in a file: it is imported or refused, and an import is a graph.
TEST(BrokenMtlx, MutationsDoNotCrash) {
    save("planks.png", "no picture");
    std::mt19937 random(19);
    const std::string seeds[] = {
        material(
            R"(<gltf_pbr name="shader" type="surfaceshader"><input name="base_color" type="color3" nodegraph="grain" output="color"/><input name="roughness" type="float" nodegraph="grain" output="gloss"/></gltf_pbr>)",
            std::string(kWood)),
        one_node(
            sources() +
                R"(<worleynoise3d name="n" type="vector3"/><switch name="tested" type="color3"><input name="in1" type="color3" nodename="source_color3"/><input name="which" type="float" nodename="source_float"/></switch>)",
            "color3"),
        one_node(
            R"(<nodedef name="ND_t" node="twice"><input name="in" type="float" value="0.25"/><output name="out" type="float"/></nodedef>
<nodegraph name="NG_t" nodedef="ND_t"><place2d name="p" type="vector2"/><extract name="e" type="float"><input name="in" type="vector2" nodename="p"/><input name="index" type="integer" value="1"/></extract><output name="out" type="float" nodename="e"/></nodegraph><twice name="tested" type="float"/>)",
            "float")};
    std::size_t imported = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string text = seeds[random() % 3];
        // The word in the quotes that end behind a place, and the place.
        const auto word_at = [&](std::size_t at) {
            const std::size_t begin = std::min(text.find("=\"", at), text.size() - 2) + 2,
                              end = std::min(text.find('"', begin), text.size());
            return std::pair(begin, end - begin);
        };
        for (int edits = 1 + static_cast<int>(random() % 3); edits > 0; --edits) {
            const std::size_t at = random() % text.size(), count = 1 + random() % 12;
            switch (random() % 12) {
                case 0: text[at] = static_cast<char>(random() % 256); break;
                case 1: text.erase(at, count); break;
                case 2: text.insert(at, text.substr(random() % text.size(), count)); break;
                default: {
                    const auto [begin, length] = word_at(at);
                    const auto [from, size] = word_at(random() % text.size());
                    text.replace(begin, length, std::string(text, from, size));
                    break;
                }
                case 3:
                    text[std::min(text.find_first_of("0123456789\"", at), text.size() - 1)] =
                        static_cast<char>('0' + random() % 10);
                    break;
            }
        }
        const Imported made = import_mtlx(text);
        EXPECT_EQ(made.error.empty(), !made.graphs.empty());
        if (made.error.empty()) ++imported;
    }
    EXPECT_GT(imported, 500u);
}

}  // namespace
}  // namespace patina::importers
