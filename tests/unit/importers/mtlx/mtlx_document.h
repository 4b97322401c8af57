// MaterialX documents, as tests write them, and their imports.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "compiler/importers/importer.h"
#include "compiler/importers/mtlx/graph_maker.h"
#include "patina/patina.h"
#include "patina/validate.h"

namespace patina::importers {

inline std::filesystem::path folder() {
    const std::filesystem::path made =
        std::filesystem::path(testing::TempDir()) / fmt::format("mtlx_import_{}", getpid());
    std::filesystem::create_directories(made);
    return made;
}

inline void save(const std::string& name, const std::string& text) {
    std::ofstream(folder() / name, std::ios::binary) << text;
}

inline Imported import_mtlx(const std::string& text) {
    save("x.mtlx", text);
    const Source source{.path = (folder() / "x.mtlx").string(), .start = {}};
    return importer_of(source)->read(source, {});
}

inline std::string document(const std::string& inside, const std::string& attributes = "version=\"1.38\"") {
    return "<?xml version=\"1.0\"?>\n<materialx " + attributes + ">\n" + inside + "\n</materialx>\n";
}
inline std::string material(const std::string& shader, const std::string& before = {}) {
    return document(before + "\n" + shader +
                    "\n<surfacematerial name=\"paint\" type=\"material\">"
                    "<input name=\"surfaceshader\" type=\"surfaceshader\" nodename=\"shader\"/></surfacematerial>");
}
// A material whose base colour or roughness is the output of a node.
inline std::string one_node(const std::string& nodes, const std::string& type, const std::string& output = "out") {
    std::string reader = fmt::format("<input name=\"base_color\" type=\"color3\" nodename=\"asColor\"/>"), between;
    if (type == "color3")
        reader = fmt::format("<input name=\"base_color\" type=\"color3\" nodename=\"tested\" output=\"{}\"/>", output);
    else if (type == "float")
        reader = fmt::format("<input name=\"roughness\" type=\"float\" nodename=\"tested\" output=\"{}\"/>", output);
    else if (type == "boolean")
        between = fmt::format(
            "<ifequal name=\"asColor\" type=\"color3\"><input name=\"value1\" type=\"boolean\" nodename=\"tested\" "
            "output=\"{}\"/>"
            "<input name=\"value2\" type=\"boolean\" value=\"true\"/><input name=\"in1\" type=\"color3\" "
            "value=\"1,0,0\"/></ifequal>",
            output);
    else if (type == "matrix33" || type == "matrix44")
        between = fmt::format(
            "<transformmatrix name=\"asVector\" type=\"vector3\"><input name=\"in\" type=\"vector3\" "
            "value=\"1,2,3\"/><input name=\"mat\" type=\"{}\" nodename=\"tested\" output=\"{}\"/></transformmatrix>"
            "<convert name=\"asColor\" type=\"color3\"><input name=\"in\" type=\"vector3\" "
            "nodename=\"asVector\"/></convert>",
            type, output);
    else
        between = fmt::format(
            "<convert name=\"asColor\" type=\"color3\"><input name=\"in\" type=\"{}\" nodename=\"tested\" "
            "output=\"{}\"/></convert>",
            type, output);
    return material(fmt::format("<gltf_pbr name=\"shader\" type=\"surfaceshader\">{}</gltf_pbr>", reader),
                    nodes + between);
}

inline const std::string& text_of(const Imported& made, const std::string& name = "paint.graph.json") {
    static const std::string kNone;
    for (const TextFile& each : made.graphs)
        if (each.name == name) return each.text;
    ADD_FAILURE() << name << " is not there: " << made.error;
    return kNone;
}

inline void expect_compiles(const Imported& made, const std::string& what, bool is_validated = true) {
    const std::string name = "paint.graph.json";
    static const Compiler compiler;
    ASSERT_EQ(made.error, "") << what;
    CompileOptions options;
    options.files.read = [&](const std::string& path) -> std::optional<std::string> {
        for (const TextFile& file : made.graphs)
            if (file.name == path || "./" + file.name == path) return file.text;
        if (path.ends_with(".png")) return "no picture";
        return std::nullopt;
    };
    const Result result = compiler.compile_text(name, text_of(made, name), options);
    EXPECT_TRUE(result.ok) << what << "\n" << text_of(made, name);
    for (const Diagnostic& each : result.diagnostics)
        if (each.severity == Severity::Error) ADD_FAILURE() << what << ": " << to_text(each);
    for (const Shader& each : result.shaders) {
        if (!is_validated) break;
        const Validated validated = validate(each);
        EXPECT_TRUE(validated.ok) << what << " " << each.file_name << "\n" << validated.log;
    }
}

inline std::string remarks(const Imported& made, Remark::Kind kind) {
    std::string text;
    for (const Remark& each : made.remarks)
        if (each.kind == kind) text += each.part + ": " + each.text + "\n";
    return text;
}

// What inputs are connected to: values that vary over the surface.
inline std::string sources() {
    std::string made = R"(<position name="place" type="vector3"/>)";
    for (const std::string_view type : {"float", "vector2", "vector3", "vector4", "color3", "color4"})
        made += fmt::format(
            R"(<swizzle name="source_{0}" type="{0}"><input name="in" type="vector3" nodename="place"/><input name="channels" type="string" value="{1}"/></swizzle>)",
            type, std::string_view("xyzx").substr(0, std::max<std::size_t>(terms::width(mtlx::type_of_word(type)), 1)));
    return made;
}

// The node graph of a material.
inline constexpr std::string_view kWood = R"(
<nodegraph name="grain">
  <input name="tint" type="color3" value="0.5, 0.25, 0.125" uiname="Tint" uifolder="Wood"/>
  <input name="rings" type="float" value="8" uisoftmin="1" uisoftmax="20"/>
  <image name="planks" type="color3"><input name="file" type="filename" value="planks.png" colorspace="srgb_texture"/></image>
  <position name="place" type="vector3"/>
  <multiply name="scaled" type="vector3"><input name="in1" type="vector3" nodename="place"/><input name="in2" type="float" interfacename="rings"/></multiply>
  <magnitude name="distance" type="float"><input name="in" type="vector3" nodename="scaled"/></magnitude>
  <sin name="wave" type="float"><input name="in" type="float" nodename="distance"/></sin>
  <mix name="colors" type="color3"><input name="fg" type="color3" nodename="planks"/><input name="bg" type="color3" interfacename="tint"/><input name="mix" type="float" nodename="wave"/></mix>
  <output name="color" type="color3" nodename="colors"/>
  <output name="gloss" type="float" nodename="wave"/>
</nodegraph>)";

}  // namespace patina::importers
