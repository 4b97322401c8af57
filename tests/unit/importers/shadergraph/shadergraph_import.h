// Imports the shader graphs of tests, compiles what they become, and has some graphs that several tests use.
#pragma once

#include <gtest/gtest.h>

#include "compiler/importers/importer.h"
#include "patina/patina.h"
#include "tests/unit/importers/shadergraph/shadergraph_writer.h"

namespace patina::importers {

inline const Compiler& compiler() {
    static const Compiler made;
    return made;
}

inline Imported import(const std::string& path) {
    const Source source{.path = path, .start = {}};
    return importer_of(source)->read(source, {});
}
inline Imported import_shadergraph(const std::string& text) {
    return import(save_shader_graph("x.shadergraph", text));
}
inline Imported import_graph(const ShaderGraphText& graph) {
    return import_shadergraph(graph.new_layout());
}

inline const std::string& text_of(const Imported& made, const std::string& name = "x.graph.json") {
    static const std::string kNone;
    for (const TextFile& each : made.graphs)
        if (each.name == name) return each.text;
    ADD_FAILURE() << name << " is not there: " << made.error;
    return kNone;
}

inline Result compiled(const Imported& made, const std::string& name = "x.graph.json") {
    CompileOptions options;
    options.files.read = [&](const std::string& path) -> std::optional<std::string> {
        for (const TextFile& file : made.graphs)
            if (file.name == path || "./" + file.name == path) return file.text;
        return std::nullopt;
    };
    return compiler().compile_text(name, text_of(made, name), options);
}

inline void expect_compiles(const Imported& made, const std::string& what) {
    EXPECT_EQ(made.error, "") << what;
    const Result result = compiled(made);
    EXPECT_TRUE(result.ok) << what << "\n" << text_of(made);
    for (const Diagnostic& each : result.diagnostics)
        if (each.severity == Severity::Error) ADD_FAILURE() << what << ": " << to_text(each);
}

// All remarks of a kind, "part: text".
inline std::string remarks(const Imported& made, Remark::Kind kind) {
    std::string text;
    for (const Remark& each : made.remarks)
        if (each.kind == kind) text += each.part + ": " + each.text + "\n";
    return text;
}

inline SlotText out(int id, std::string kind = "DynamicVector") {
    return {.id = id, .kind = std::move(kind), .is_input = false};
}

// --- graphs

inline ShaderGraphText painted() {
    return {
        .properties =
            {{.id = "tint", .kind = "Color", .name = "Tint", .value = R"({"r":1.0,"g":0.5019608,"b":0.0,"a":1.0})"},
             {.id = "main",
              .kind = "Texture2D",
              .name = "MainTex",
              .value = R"({"m_SerializedTexture":"","m_Guid":""})"},
             {.id = "wear",
              .kind = "Vector1",
              .name = "Wear",
              .value = "0.25",
              .more = R"("m_FloatType":1,"m_RangeValues":{"x":0.0,"y":1.0})"}},
        .nodes =
            {{.id = "a", .kind = "PropertyNode", .slots = {out(0, "Vector4")}, .name = "Property", .property = "tint"},
             {.id = "b",
              .kind = "PropertyNode",
              .slots = {out(0, "Texture2D")},
              .name = "Property",
              .property = "main"},
             {.id = "c", .kind = "PropertyNode", .slots = {out(0, "Vector1")}, .name = "Property", .property = "wear"},
             {.id = "sample",
              .kind = "SampleTexture2DNode",
              .slots = {{1, "Texture2DInput"},
                        {.id = 2, .kind = "UV"},
                        {3, "SamplerState"},
                        out(0, "Vector4"),
                        out(4, "Vector1")},
              .name = "Sample Texture 2D"},
             {.id = "product",
              .kind = "MultiplyNode",
              .slots = {{0, "DynamicValue"}, {1, "DynamicValue"}, out(2, "DynamicValue")},
              .name = "Multiply"},
             {.id = "mix",
              .kind = "LerpNode",
              .slots = {{0}, {.id = 1, .value = R"({"x":0.5,"y":0.5,"z":0.5,"w":0.5})"}, {2}, out(3)},
              .name = "Lerp"}},
        .edges = {{"b", 0, "sample", 1},
                  {"sample", 0, "product", 0},
                  {"a", 0, "product", 1},
                  {"product", 2, "mix", 0},
                  {"c", 0, "mix", 2},
                  {"mix", 3, "BaseColor"}}};
}

inline ShaderGraphText doubled() {
    return {.properties = {{.id = "p",
                            .kind = "Vector3",
                            .name = "In Value",
                            .value = R"({"x":1.0,"y":2.0,"z":3.0})",
                            .more = R"("m_Guid":{"m_GuidSerialized":"guid-of-p"})"}},
            .dropdowns = {{.id = "d",
                           .kind = "",
                           .name = "Mode",
                           .value = "9",
                           .more = R"("m_Entries":[{"id":9,"displayName":"Once"},{"id":2,"displayName":"Twice"}])",
                           .reference = "_Mode"}},
            .nodes =
                {{.id = "a", .kind = "PropertyNode", .slots = {out(0, "Vector3")}, .property = "p"},
                 {.id = "two",
                  .kind = "MultiplyNode",
                  .slots = {{0, "DynamicValue"},
                            {.id = 1, .kind = "DynamicValue", .value = R"({"e00":2.0,"e01":2.0,"e02":2.0,"e03":2.0})"},
                            out(2, "DynamicValue")}},
                 {.id = "choice", .kind = "DropdownNode", .slots = {out(0), {9}, {2}}, .property = "d"},
                 {.id = "state", .kind = "PropertyNode", .slots = {out(0, "PropertyConnectionState")}, .property = "p"},
                 {.id = "branch",
                  .kind = "BranchOnInputConnectionNode",
                  .slots = {{0, "PropertyConnectionState"},
                            {1},
                            {.id = 2, .value = R"({"x":0.5,"y":0.5,"z":0.5,"w":0.5})"},
                            out(3)}}},
            .edges = {{"a", 0, "two", 0},
                      {"a", 0, "choice", 9},
                      {"two", 2, "choice", 2},
                      {"choice", 0, "branch", 1},
                      {"state", 0, "branch", 0},
                      {"branch", 3, "output", 1}},
            .outputs = {{.id = 1, .kind = "Vector3", .name = "Result"}}};
}
inline ShaderGraphText user(const std::string& guid, bool is_linked = true) {
    ShaderGraphText graph{
        .nodes =
            {{.id = "a", .kind = "PositionNode", .slots = {out(0, "Vector3")}, .more = R"("m_Space":2)"},
             {.id = "sub",
              .kind = "SubGraphNode",
              .slots = {{-77, "Vector3"}, out(1, "Vector3")},
              .more = fmt::format(
                  R"("m_SerializedSubGraph":"{{\"subGraph\":{{\"guid\":\"{}\"}}}}","m_PropertyGuids":["guid-of-p"],"m_PropertyIds":[-77],"m_Dropdowns":["_Mode"],"m_DropdownSelectedEntries":["Twice"])",
                  guid),
              .name = "Doubled"}},
        .edges = {{"sub", 1, "BaseColor"}}};
    if (is_linked) graph.edges.push_back({"a", 0, "sub", -77});
    return graph;
}
inline constexpr const char* kGuid = "0123456789abcdef0123456789abcdef";

// A graph of this node alone, whose output is the colour.
inline ShaderGraphText one_node(NodeText node, int output) {
    ShaderGraphText graph{.nodes = {std::move(node)}};
    graph.edges = {{graph.nodes[0].id, output, "BaseColor"}};
    return graph;
}

inline NodeText custom(const std::string& body, const std::string& name = "Glow", int source = 1) {
    return {
        .id = "f",
        .kind = "CustomFunctionNode",
        .slots = {{.id = 0, .kind = "Vector3", .name = "A"},
                  {.id = 1, .kind = "Vector1", .value = "2.0", .name = "B"},
                  {.id = 2, .kind = "Vector3", .is_input = false, .name = "Out"}},
        .more = fmt::format(R"("m_SourceType":{},"m_FunctionName":"{}","m_FunctionSource":"{}","m_FunctionBody":"{}")",
                            source, name, source == 0 ? kGuid : "", body),
        .version = 1};
}

}  // namespace patina::importers
