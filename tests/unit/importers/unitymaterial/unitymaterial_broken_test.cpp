// Materials of Unity that are broken or hostile: each is refused at its place or imported with a remark, and none
// crashes or runs long.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <regex>

#include "tests/unit/importers/unitymaterial/unitymaterial_check.h"

namespace patina::importers {
namespace {

constexpr const char* kGuid = "0123456789abcdef0123456789abcdef";
constexpr const char* kOther = "1123456789abcdef0123456789abcdef";

MaterialText painted() {
    return {.keywords = {"_NORMALMAP", "_EMISSION"},
            .textures = {{"_MainTex", kGuid}, {"_BumpMap", kOther, "{x: 2, y: 2}"}},
            .numbers = {{"_Glossiness", "0.25"}, {"_Metallic", "0.5"}},
            .colors = {{"_Color", "{r: 1, g: 0.5, b: 0, a: 1}"}, {"_EmissionColor", "{r: 1, g: 2, b: 3, a: 1}"}}};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, text.npos) << from;
    return at == text.npos ? text : text.replace(at, from.size(), to);
}

void expect_error(const std::string& text, const std::string& pattern) {
    const Imported made = import_material(text);
    EXPECT_TRUE(std::regex_search(made.error, std::regex(pattern))) << pattern << "\n" << made.error;
    EXPECT_TRUE(made.graphs.empty());
}

TEST(BrokenUnityMaterial, IsReportedAtItsPlace) {
    const std::string good = painted().text();
    expect_error(replaced(good, "m_Scale: {x: 1", "m_Scale: {x: ]1"), R"(x\.mat:36:[0-9]+: it is not valid YAML: )");
    expect_error(replaced(good, "{x: 1, y: 1}", "&a {x: 1, y: *a}"), R"(x\.mat:36:[0-9]+: an alias)");
    expect_error(replaced(good, "{x: 1, y: 1}", "*nobody"), R"(x\.mat:36:[0-9]+: )");
    expect_error(replaced(good, "{x: 1, y: 1}", "{[1, 2]: 1}"), R"(x\.mat:36:[0-9]+: a key is a list or a map)");
    expect_error("", "there is no material in it");
    expect_error("nonsense", "there is no material in it");
    expect_error("%YAML 1.1\n--- !u!21 &2100000\nMaterial:\n", R"(x\.mat:3:[0-9]+: the material has no values)");
    expect_error(std::string("\x00\x01\x02", 3) + good, "the file is not text; in Unity, set .*'Force Text'");
    const Imported missing = import_file("/nowhere/x.mat");
    EXPECT_EQ(missing.error, "there is no file '/nowhere/x.mat'");
}

// What multiplies or lies deep in a small file is refused before anything is built of it.
TEST(BrokenUnityMaterial, HostileFilesAreRefused) {
    std::string laughs = "a0: &a0 [x, x]\n";
    for (int i = 1; i < 60; ++i) laughs += fmt::format("a{}: &a{} [*a{}, *a{}]\n", i, i, i - 1, i - 1);
    expect_error(laughs, R"(x\.mat:2:[0-9]+: an alias)");
    for (const char* bracket : {"[", "{", "{a: ", "- ", "? "}) {
        std::string deep = "Material: \n  m_Floats: ";
        for (int i = 0; i < 20000; ++i) deep += bracket;
        const Imported made = import_material(deep);
        EXPECT_NE(made.error, "") << bracket;
    }
    expect_error("Material:\n  m_Name: [" + std::string(40, '[') + std::string(41, ']'),
                 R"(x\.mat:2:[0-9]+: more than 32 values lie in one another)");
}

TEST(BrokenUnityMaterial, CutOffFilesAreRefusedOrImported) {
    const std::string good = painted().text();
    std::size_t imported = 0;
    for (std::size_t size = 0; size < good.size(); size += 7) {
        const Imported made = import_material(good.substr(0, size));
        EXPECT_EQ(made.error.empty(), !made.graphs.empty());
        if (made.error.empty()) ++imported;
    }
    EXPECT_GT(imported, 50u);
    const Imported made = import_material(good.substr(0, good.find("  m_SavedProperties")));
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("setting 'm_SavedProperties': it is missing"),
              std::string::npos)
        << remarks(made, Remark::Kind::Changed);
}

TEST(BrokenUnityMaterial, ValuesThatAreNoNumbersAreSaid) {
    for (const char* value : {"NaN", ".nan", "Infinity", "-.inf", "1e39", "abc", "", "0x1p3", "0.5f"}) {
        MaterialText material = painted();
        material.numbers[0].value = value;
        const Imported made = import(material);
        EXPECT_EQ(made.error, "") << value;
        EXPECT_NE(remarks(made, Remark::Kind::Changed).find("property '_Glossiness': '"), std::string::npos)
            << value << remarks(made, Remark::Kind::Changed);
        // Standard's own default.
        EXPECT_NE(graph_of(made).find(R"("_Glossiness", "type": "float", "default": 0.5)"), std::string::npos)
            << graph_of(made);
        expect_compiles(made, value);
    }
    MaterialText material = painted();
    material.colors[0].value = "{r: 1, g: 0.5, a: 1}";
    const Imported made = import(material);
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("property '_Color': 'nothing' is not a finite number"),
              std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    expect_compiles(made, "no blue");
}

TEST(BrokenUnityMaterial, NewerVersionsAreSaid) {
    const std::string good = painted().text();
    EXPECT_EQ(remarks(import_material(good), Remark::Kind::Changed).find("newest"), std::string::npos);
    const Imported made = import_material(replaced(replaced(good, "serializedVersion: 8", "serializedVersion: 800"),
                                                   "    serializedVersion: 3", "    serializedVersion: 99"));
    const std::string changed = remarks(made, Remark::Kind::Changed);
    EXPECT_NE(changed.find("the file: it is of version 800; 8 is the newest that is known: read as that"),
              std::string::npos)
        << changed;
    EXPECT_NE(
        changed.find("setting 'm_SavedProperties': it is of version 99; 3 is the newest that is known: read as that"),
        std::string::npos)
        << changed;
    expect_compiles(made, "newer");
}

// Unity always writes the lists of textures, numbers and colours, and the three parts of a texture.
TEST(BrokenUnityMaterial, WhatACutOffFileLacksIsSaid) {
    const std::string good = painted().text();
    const auto changed = [](const std::string& text) { return remarks(import_material(text), Remark::Kind::Changed); };
    std::string said = changed(good.substr(0, good.find("        m_Scale: {x: 1, y: 1}")));
    for (const char* expected : {"property '_MainTex': it has no m_Scale; the file may be cut off",
                                 "property '_MainTex': it has no m_Offset; the file may be cut off",
                                 "setting 'm_Floats': the file has no m_Floats; the file may be cut off",
                                 "setting 'm_Colors': the file has no m_Colors; the file may be cut off"})
        EXPECT_NE(said.find(expected), std::string::npos) << expected << "\n" << said;
    said = changed(replaced(good, "m_TexEnvs", "m_TexEnvsX"));
    EXPECT_NE(said.find("setting 'm_TexEnvs': the file has no m_TexEnvs"), std::string::npos) << said;
    // Older versions have no m_Ints.
    EXPECT_EQ(changed(painted().old_text()).find("cut off"), std::string::npos) << changed(painted().old_text());
}

TEST(BrokenUnityMaterial, StructureOfAWrongTypeIsAnErrorAtItsPlace) {
    const std::string good = painted().text();
    expect_error(replaced(good, "    m_Floats:\n", "    m_Floats: 7\n    m_FloatsX:\n"),
                 R"(x\.mat:[0-9]+:15: m_Floats is a list of properties, and not '7')");
    expect_error(replaced(good, "- _Metallic: 0.5", "- 0.5"),
                 R"(x\.mat:[0-9]+:7: an entry of m_Floats is a name and a value, and not '0\.5')");
    expect_error(replaced(good, "_Metallic: 0.5", "_Metallic: [1]"),
                 R"(x\.mat:[0-9]+:18: the number of '_Metallic' is a list)");
    expect_error(replaced(good, "{r: 1, g: 0.5, b: 0, a: 1}", "{r: [1], g: 0.5, b: 0, a: 1}"),
                 R"(x\.mat:[0-9]+:19: the number of '_Color' is a list)");
    expect_error(replaced(good, "{r: 1, g: 0.5, b: 0, a: 1}", "red"),
                 R"(x\.mat:[0-9]+:15: the colour '_Color' is \{r: \.\.\., .*\}, and not 'red')");
    expect_error(replaced(good, "m_Scale: {x: 1, y: 1}", "m_Scale: 1"),
                 R"(x\.mat:[0-9]+:18: m_Scale is \{x: \.\.\., y: \.\.\.\}, and not '1')");
    expect_error(replaced(good, "m_Shader: {fileID: 46, ", "m_Shader: 46 #{"),
                 R"(x\.mat:[0-9]+:13: m_Shader is \{fileID: .*\}, and not '46')");
    expect_error(replaced(good, "  - _NORMALMAP", "  - [_NORMALMAP]"),
                 R"(x\.mat:[0-9]+:5: a keyword is a word, and not a list)");
}

TEST(BrokenUnityMaterial, NumbersThatUnityDoesNotHaveAreSaid) {
    MaterialText material = painted();
    material.shader = kLit;
    material.numbers.push_back({"_Cull", "8"});
    const Imported made = import(material);
    EXPECT_NE(
        remarks(made, Remark::Kind::Changed).find("property '_Cull': 8 is none of its numbers, which are 0 to 2: 2"),
        std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    expect_compiles(made, "cull");
}

TEST(BrokenUnityMaterial, PropertiesAreReadOnce) {
    MaterialText material = painted();
    material.numbers.push_back({"_Glossiness", "0.75"});
    const Imported made = import(material);
    EXPECT_NE(
        remarks(made, Remark::Kind::Changed).find("property '_Glossiness': it is there twice: the first one counts"),
        std::string::npos);
    EXPECT_NE(graph_of(made).find(R"("default": 0.25)"), std::string::npos) << graph_of(made);
    const Imported several = import_material(painted().text() + "--- !u!21 &2100002\nMaterial:\n  m_Name: y\n");
    EXPECT_NE(remarks(several, Remark::Kind::Changed).find("material: there are several: the first one counts"),
              std::string::npos);
}

// A comment of the graph shows them as escapes: they neither end it nor reach a terminal.
TEST(BrokenUnityMaterial, ControlCharactersAreEscapedInComments) {
    MaterialText material = painted();
    material.textures[0].guid = R"("\e[31mred\r\x07\L")";
    const Imported made = import(material);
    EXPECT_NE(graph_of(made).find(R"(// The picture with the GUID \x1b[31mred\r\x07\u2028 was not found.)"),
              std::string::npos)
        << graph_of(made);
    EXPECT_EQ(graph_of(made).find_first_of("\033\r\007"), std::string::npos);
    expect_compiles(made, "control characters");
}

TEST(BrokenUnityMaterial, AMaterialIsNoVariantOfItself) {
    const MaterialFolder folder;
    MaterialText first = painted(), second = painted();
    first.parent = fmt::format("{{fileID: 2100000, guid: {}, type: 2}}", kOther);
    second.parent = fmt::format("{{fileID: 2100000, guid: {}, type: 2}}", kGuid);
    folder.save("y.mat", second.text(), kOther);
    const Imported made = import_file(folder.save("x.mat", first.text(), kGuid));
    EXPECT_TRUE(std::regex_search(
        made.error, std::regex(R"(x\.mat:18:3: m_Parent: the material is a variant of itself, by '.*y\.mat')")))
        << made.error;
    // The error of a parent is that of its file.
    folder.save("y.mat", "Material: [", kOther);
    EXPECT_NE(import_file(folder.path() + "/x.mat").error.find("y.mat:1:"), std::string::npos);
}

TEST(BrokenUnityMaterial, ALongChainOfParentsEnds) {
    const MaterialFolder folder;
    const auto guid = [](int i) { return fmt::format("{:032x}", i + 1); };
    for (int i = 0; i < 100; ++i) {
        MaterialText material = painted();
        material.parent = fmt::format("{{fileID: 2100000, guid: {}, type: 2}}", guid(i + 1));
        folder.save(fmt::format("m{}.mat", i), material.text(), guid(i));
    }
    EXPECT_NE(import_file(folder.path() + "/m0.mat").error.find("more than 32 materials are variants of one another"),
              std::string::npos);
}

TEST(BrokenUnityMaterial, NumbersOfAnySizeCompile) {
    for (const char* value : {"-5", "1e30", "-1e30", "1e-30"}) {
        MaterialText material = painted();
        for (ValueText& each : material.numbers) each.value = value;
        for (ValueText& each : material.colors)
            each.value = fmt::format("{{r: {}, g: {}, b: 1, a: {}}}", value, value, value);
        material.textures[0].scale = fmt::format("{{x: {}, y: {}}}", value, value);
        material.queue = value;
        expect_compiles(import(material), value);
        for (const char* shader : {kStandardSpecular, kLit, kSimpleLit, kUnlit}) {
            material.shader = shader;
            material.numbers.push_back({"_SrcBlend", value});
            material.numbers.push_back({"_Cull", value});
            expect_compiles(import(material), shader);
        }
    }
}

// Whatever is changed in a file: it is imported or refused, and an import is a graph.
TEST(BrokenUnityMaterial, MutationsDoNotCrash) {
    std::mt19937 random(21);
    MaterialText lit = painted();
    lit.shader = kLit;
    const std::string seeds[] = {painted().text(), painted().old_text(), lit.text()};
    const std::string odd = "!&*{}[]|>%@`'\"#-?:,\n \t~0a\\";
    const MaterialFolder folder;
    std::size_t imported = 0;
    for (int i = 0; i < 4000; ++i) {
        std::string text = seeds[random() % 3];
        for (int edits = 1 + static_cast<int>(random() % 4); edits > 0; --edits) {
            const std::size_t at = random() % text.size(), size = 1 + random() % 12;
            switch (random() % 5) {
                case 0: text[at] = static_cast<char>(random() % 256); break;
                case 1: text.erase(at, size); break;
                case 2: text.insert(at, text.substr(random() % text.size(), size)); break;
                case 3: text[at] = odd[random() % odd.size()]; break;
                case 4: text.insert(at, 1, odd[random() % odd.size()]); break;
            }
        }
        const Imported made = import_file(folder.save("x.mat", text));
        EXPECT_EQ(made.error.empty(), !made.graphs.empty());
        if (made.error.empty()) ++imported;
    }
    EXPECT_GT(imported, 500u);
}

}  // namespace
}  // namespace patina::importers
