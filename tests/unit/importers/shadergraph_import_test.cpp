// Shader graphs of Unity: what they become, in both layouts; every row of the table of node classes; settings; and
// broken files.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <regex>
#include <set>

#include "compiler/importers/importer.h"
#include "compiler/importers/shadergraph/node_table.h"
#include "compiler/importers/shadergraph/values/term.h"
#include "patina/patina.h"
#include "tests/unit/importers/shadergraph_writer.h"

namespace patina::importers {
namespace {

const Compiler& compiler() {
    static const Compiler made;
    return made;
}

Imported import(const std::string& path) {
    const Source source{.path = path, .start = {}};
    return importer_of(source)->read(source, {});
}
Imported import_text(const std::string& text) {
    return import(save_shader_graph("x.shadergraph", text));
}
Imported import_graph(const ShaderGraphText& graph) {
    return import_text(graph.new_layout());
}

const std::string& text_of(const Imported& made, const std::string& name = "x.graph.json") {
    static const std::string kNone;
    for (const TextFile& each : made.graphs)
        if (each.name == name) return each.text;
    ADD_FAILURE() << name << " is not there: " << made.error;
    return kNone;
}

Result compiled(const Imported& made, const std::string& name = "x.graph.json") {
    CompileOptions options;
    options.files.read = [&](const std::string& path) -> std::optional<std::string> {
        for (const TextFile& file : made.graphs)
            if (file.name == path || "./" + file.name == path) return file.text;
        return std::nullopt;
    };
    return compiler().compile_text(name, text_of(made, name), options);
}

void expect_compiles(const Imported& made, const std::string& what) {
    EXPECT_EQ(made.error, "") << what;
    const Result result = compiled(made);
    EXPECT_TRUE(result.ok) << what << "\n" << text_of(made);
    for (const Diagnostic& each : result.diagnostics)
        if (each.severity == Severity::Error) ADD_FAILURE() << what << ": " << to_text(each);
}

// All remarks of a kind, "part: text".
std::string remarks(const Imported& made, Remark::Kind kind) {
    std::string text;
    for (const Remark& each : made.remarks)
        if (each.kind == kind) text += each.part + ": " + each.text + "\n";
    return text;
}

SlotText out(int id, std::string kind = "DynamicVector") {
    return {.id = id, .kind = std::move(kind), .is_input = false};
}

ShaderGraphText painted() {
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

constexpr std::string_view kPainted = R"({
  "patina": 1,
  "kind": "material",
  "name": "x",
  "workflow": "unlit",
  "properties": [
    { "name": "_Tint", "type": "color", "default": "#ff8000", "label": "Tint" },
    { "name": "_MainTex", "type": "texture2d", "default": "white", "label": "MainTex" },
    { "name": "_Wear", "type": "float", "default": 0.25, "range": [0, 1], "label": "Wear" }
  ],
  "nodes": [
    { "id": "mainTex", "node": "SampleTexture2D", "in": { "texture": "$_MainTex" } }
  ],
  "surface": { "color": "= lerp(mainTex * $_Tint, 0.5, $_Wear).rgb" },
  "ui": { "nodes": { "mainTex": [0, 0] } }
}
)";

TEST(ShaderGraphImport, BothLayoutsBecomeTheSameGraph) {
    const Imported made = import_graph(painted());
    EXPECT_EQ(text_of(made), kPainted);
    EXPECT_EQ(text_of(import_text(painted().old_layout())), kPainted);
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    EXPECT_FALSE(made.has_refused);
    expect_compiles(made, "painted");
    // It is as `patina fmt` leaves it.
    EXPECT_EQ(compiler().format("x.graph.json", text_of(made)).text, kPainted);
}

TEST(ShaderGraphImport, EachPartHasARemark) {
    const Imported made = import_graph(painted());
    std::multiset<std::string> parts;
    for (const Remark& each : made.remarks) parts.insert(each.part);
    for (const char* part : {"property 'Tint'", "property 'MainTex'", "property 'Wear'", "node 'Property' (Tint)",
                             "node 'Multiply'", "node 'Lerp'", "node 'Sample Texture 2D'", "block 'BaseColor'",
                             "setting 'Surface Type'", "target 'UniversalTarget'"})
        EXPECT_EQ(parts.count(part), 1u) << part;
    for (const Remark& each : made.remarks) {
        if (each.part == "node 'Multiply'") {
            EXPECT_GT(each.line, 1);
        }
    }
}

// --- the table of classes: a node of each class, with the slots that its row names, compiles

struct Row {
    std::string kind, condition, outputs, remark;
};
constexpr const char* kRows[][4] = {
#define NODE(kind, condition, outputs, remark) {kind, condition, outputs, remark},
#include "compiler/importers/shadergraph/nodes.def"
#undef NODE
};

// A graph with one node, whose outputs are all read.
ShaderGraphText graph_of(const Row& row) {
    NodeText node{.id = "it", .kind = row.kind, .name = "It"};
    std::set<std::string> inputs;
    const std::regex placeholder(R"(\{([A-Za-z0-9]+))"), output(R"((?:^|; )([0-9]+): )");
    const std::string texture =
        row.outputs.find("TextureCube") != std::string::npos || row.outputs.find("Cubemap") != std::string::npos
            ? "CubemapInput"
        : row.outputs.find("2DArray") != std::string::npos   ? "Texture2DArrayInput"
        : row.outputs.find("Texture3D") != std::string::npos ? "Texture3DInput"
                                                             : "Texture2DInput";
    for (std::sregex_iterator each(row.outputs.begin(), row.outputs.end(), placeholder), end; each != end; ++each)
        inputs.insert((*each)[1]);
    int further = 20;
    for (const std::string& each : inputs) {
        SlotText slot{.value = R"({"x":0.5,"y":0.25,"z":0.75,"w":1.0})"};
        const bool is_number = each[0] >= '0' && each[0] <= '9';
        slot.id = is_number ? std::stoi(each) : further++;
        if (!is_number) slot.name = each;
        if (each == "DDX" || each == "DDY") slot.kind = "Vector2";
        if (row.outputs.find("texture={" + each) != std::string::npos ||
            row.outputs.find("(texture={" + each) != std::string::npos ||
            row.outputs.find("Level({" + each) != std::string::npos ||
            row.outputs.find("Transform(texture={" + each) != std::string::npos) {
            slot.kind = texture;
            slot.more = R"("m_Texture":{})";
        }
        const bool is_flag =
            std::regex_search(row.outputs, std::regex("(\\{" + each + "\\} (&&|\\|\\||\\?)|(&&|\\|\\|) \\{" + each +
                                                      "\\}|!\\{" + each + "\\}|!\\(\\{" + each + "\\})"));
        if (is_flag) {
            slot.kind = "Boolean";
            slot.value = "true";
        }
        const bool is_matrix = row.kind == "MatrixDeterminantNode" || row.kind == "MatrixTransposeNode";
        if (is_matrix) slot = {.id = slot.id, .kind = "DynamicMatrix", .value = R"({"e00":1.0,"e11":1.0})"};
        if (row.kind == "MatrixConstructionNode") slot.kind = "Vector4";
        if (row.outputs.find("cross(") != std::string::npos || row.outputs.find("normalize({") != std::string::npos ||
            row.outputs.find("reflect(") != std::string::npos ||
            row.outputs.find("Transform({" + each) != std::string::npos ||
            row.outputs.find("AmbientIrradiance(") != std::string::npos)
            slot.kind = "Vector3";
        if (row.outputs.find("NormalReconstructZ(") != std::string::npos) slot.kind = "Vector2";
        node.slots.push_back(slot);
    }
    ShaderGraphText graph{.blocks = {}};
    std::string sum;
    std::vector<int> outputs;
    for (std::sregex_iterator each(row.outputs.begin(), row.outputs.end(), output), end; each != end; ++each)
        outputs.push_back(std::stoi((*each)[1]));
    for (const std::string& word : {std::string("uses:2"), std::string("uses:3"), std::string("uses:4")})
        if (row.condition == word && outputs.empty()) outputs.push_back(word.back() - '0');
    if (outputs.empty()) outputs.push_back(0);
    for (const std::string kind : {"m_", "version<"}) {
        const std::regex setting("(" + kind + "[A-Za-z_.]*)[=<]?([0-9]+)");
        for (std::sregex_iterator each(row.condition.begin(), row.condition.end(), setting), end; each != end; ++each)
            if (kind == "m_")
                node.more +=
                    (node.more.empty() ? "" : ",") + fmt::format("\"{}\":{}", (*each)[1].str(), (*each)[2].str());
    }
    node.version = row.condition.find("version<1") != std::string::npos ? 0 : 1;
    // A chain of sums reads all outputs of vectors.
    const std::string type = row.kind.starts_with("Matrix") && row.kind != "MatrixDeterminantNode" ? "Matrix" : "";
    for (const int id : outputs) {
        if (row.kind == "SplitTextureTransformNode" && id == 3) continue;
        const bool is_bool = row.kind == "ComparisonNode" || row.kind == "AndNode" || row.kind == "OrNode" ||
                             row.kind == "NotNode" || row.kind == "NandNode" || row.kind == "AllNode" ||
                             row.kind == "AnyNode" || row.kind.starts_with("Is") || row.kind == "BooleanNode";
        std::string kind = is_bool ? "Boolean" : "Vector4";
        if (row.kind == "MatrixConstructionNode") kind = id == 4 ? "Matrix4" : id == 5 ? "Matrix3" : "Matrix2";
        if (row.kind == "MatrixTransposeNode") kind = "DynamicMatrix";
        node.slots.push_back(out(id + 0, kind));
    }
    graph.nodes.push_back(node);
    graph.blocks = {{"SurfaceDescription.BaseColor", "ColorRGB"}};
    std::string last;
    int last_slot = 0;
    for (const SlotText& slot : graph.nodes[0].slots) {
        if (slot.is_input) continue;
        const std::string id = fmt::format("sum{}", slot.id);
        const bool is_matrix = slot.kind.find("Matrix") != std::string::npos;
        graph.nodes.push_back({.id = id,
                               .kind = is_matrix ? "MatrixDeterminantNode" : "AddNode",
                               .slots = is_matrix ? std::vector<SlotText>{{0, "DynamicMatrix"}, out(1, "Vector1")}
                                                  : std::vector<SlotText>{{0}, {1}, out(2)}});
        graph.edges.push_back({"it", slot.id, id, 0});
        if (!last.empty() && !is_matrix) graph.edges.push_back({last, last_slot, id, 1});
        last = id;
        last_slot = is_matrix ? 1 : 2;
    }
    graph.edges.push_back({last, last_slot, "BaseColor"});
    return graph;
}

TEST(ShaderGraphImport, EveryClassOfTheTableCompiles) {
    std::size_t count = 0;
    for (const auto& each : kRows) {
        const Row row{each[0], each[1], each[2], each[3]};
        if (row.condition.find("linked:") != std::string::npos) continue;  // a test of their own
        const ShaderGraphText all = graph_of(row);
        const std::string what = row.kind + " " + row.condition;
        if (row.remark.starts_with("!")) {
            const Imported made = import_graph(all);
            EXPECT_TRUE(made.has_refused) << what;
            expect_compiles(made, what);
            ++count;
            continue;
        }
        // Each output by itself, in the type that it has: the table does not say it, the slots of real files do.
        for (const SlotText& slot : all.nodes[0].slots) {
            if (slot.is_input) continue;
            bool is_valid = false;
            Imported made;
            for (const char* kind : {"", "Vector1", "Vector2", "Vector3"}) {
                ShaderGraphText graph = all;
                for (SlotText& each_slot : graph.nodes[0].slots)
                    if (!each_slot.is_input && *kind) each_slot.kind = kind;
                graph.edges = {{"it", slot.id, fmt::format("sum{}", slot.id), 0},
                               {fmt::format("sum{}", slot.id), slot.kind.find("Matrix") != std::string::npos ? 1 : 2,
                                "BaseColor"}};
                made = import_graph(graph);
                EXPECT_EQ(made.error, "") << what;
                EXPECT_FALSE(made.has_refused) << what << remarks(made, Remark::Kind::LeftOut);
                is_valid = is_valid || compiled(made).ok;
                if (is_valid) break;
            }
            if (!is_valid) expect_compiles(made, fmt::format("{}, output {}", what, slot.id));
        }
        ++count;
    }
    EXPECT_GT(count, 150u);
}

TEST(ShaderGraphImport, TheTableNamesNodesOfTheLibraryAlone) {
    const std::regex call(R"(@([A-Z][A-Za-z0-9]*)\()");
    for (const auto& each : kRows) {
        const std::string outputs = each[2];
        for (std::sregex_iterator found(outputs.begin(), outputs.end(), call), end; found != end; ++found)
            EXPECT_NE(compiler().node((*found)[1].str()), nullptr) << each[0] << ": " << (*found)[1];
    }
}

// --- values

ShaderGraphText one_node(NodeText node, int output) {
    ShaderGraphText graph{.nodes = {std::move(node)}};
    graph.edges = {{graph.nodes[0].id, output, "BaseColor"}};
    return graph;
}

std::string surface_of(const Imported& made) {
    const std::string& text = text_of(made);
    const std::size_t begin = text.find("\"surface\"");
    return begin == text.npos ? text : text.substr(begin, text.find('\n', begin) - begin);
}

// The smallest vector decides, and numbers fit it.
TEST(ShaderGraphImport, DynamicVectorsTakeTheSmallestOne) {
    ShaderGraphText graph{
        .nodes = {{.id = "a", .kind = "PositionNode", .slots = {out(0, "Vector3")}, .more = R"("m_Space":2)"},
                  {.id = "b", .kind = "UVNode", .slots = {out(0, "Vector4")}, .more = R"("m_OutputChannel":0)"},
                  {.id = "sum", .kind = "AddNode", .slots = {{0}, {1}, out(2)}}},
        .edges = {{"a", 0, "sum", 0}, {"b", 0, "sum", 1}, {"sum", 2, "BaseColor"}}};
    const Imported made = import_graph(graph);
    EXPECT_NE(surface_of(made).find("= @positionWS + float3(uv, 0)"), std::string::npos) << text_of(made);
    expect_compiles(made, "sum");
}

TEST(ShaderGraphImport, CoordinatesCountFromTheBottom) {
    const NodeText noise{.id = "n",
                         .kind = "NoiseNode",
                         .slots = {{.id = 0, .kind = "UV"}, {1, "Vector1", true, "5.0"}, out(2, "Vector1")},
                         .more = R"("m_HashType":0)",
                         .version = 1,
                         .name = "Simple Noise"};
    const Imported made = import_graph(one_node(noise, 2));
    EXPECT_NE(text_of(made).find(R"x("expr": "float2(@uv0.x, 1 - @uv0.y)")x"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find(R"("in": { "uv": "uv", "scale": 5, "hash": "Deterministic" })"), std::string::npos)
        << text_of(made);
    expect_compiles(made, "noise");
}

TEST(ShaderGraphImport, ConversionsAreThoseOfEdges) {
    using namespace shadergraph;
    const Term two = link("a", Type::Float2), four = link("b", Type::Float4), one = link("c", Type::Float),
               flag = link("d", Type::Bool);
    EXPECT_EQ(converted(two, Type::Float3).text(), "float3(a, 0)");
    EXPECT_EQ(converted(two, Type::Float4).text(), "float4(a, 0, 1)");
    EXPECT_EQ(converted(link("a", Type::Float3), Type::Float4).text(), "float4(a, 1)");
    EXPECT_EQ(converted(four, Type::Float2).text(), "b.xy");
    EXPECT_EQ(converted(one, Type::Float3).text(), "float3(c)");
    EXPECT_EQ(converted(one, Type::Float3, true).text(), "c");
    EXPECT_EQ(converted(flag, Type::Float).text(), "float(d)");
    EXPECT_EQ(converted(four, Type::Bool).text(), "b.x != 0");
    EXPECT_EQ(swizzled(converted(two, Type::Float4), "xy").text(), "a");
    EXPECT_EQ(swizzled(swizzled(four, "zyx"), "xz").text(), "b.zx");
    EXPECT_EQ(converted(link("t", Type::Texture2D), Type::Float).type, Type::None);
}

TEST(ShaderGraphImport, BracketsStandWhereTheyAreNeeded) {
    const auto chain = [](const char* outer, const char* inner) {
        ShaderGraphText graph{
            .properties = {{.id = "p", .kind = "Vector3", .name = "P", .value = R"({"x":1.0})"}},
            .nodes = {{.id = "a", .kind = "PropertyNode", .slots = {out(0, "Vector3")}, .property = "p"},
                      {.id = "in", .kind = inner, .slots = {{0}, {1}, out(2)}},
                      {.id = "out", .kind = outer, .slots = {{0}, {1}, out(2)}}},
            .edges = {{"a", 0, "in", 0},
                      {"a", 0, "in", 1},
                      {"a", 0, "out", 0},
                      {"in", 2, "out", 1},
                      {"out", 2, "BaseColor"}}};
        const Imported made = import_graph(graph);
        expect_compiles(made, outer);
        return surface_of(made);
    };
    EXPECT_NE(chain("SubtractNode", "SubtractNode").find("= $_P - ($_P - $_P)"), std::string::npos);
    EXPECT_NE(chain("DivideNode", "DivideNode").find("= $_P / ($_P / $_P)"), std::string::npos);
    EXPECT_NE(chain("AddNode", "DivideNode").find("= $_P + $_P / $_P"), std::string::npos);
    EXPECT_NE(chain("DivideNode", "AddNode").find("= $_P / ($_P + $_P)"), std::string::npos);
    EXPECT_NE(chain("MaximumNode", "AddNode").find("= max($_P, $_P + $_P)"), std::string::npos);
}

// --- keywords, sub-graphs, functions

TEST(ShaderGraphImport, KeywordsAreVariants) {
    ShaderGraphText graph{
        .keywords =
            {{.id = "mud",
              .kind = "",
              .name = "Mud",
              .value = "1",
              .more = R"("m_KeywordType":0,"m_IsEditable":true)",
              .reference = "_MUD"},
             {.id = "q",
              .kind = "",
              .name = "Quality",
              .value = "1",
              .more =
                  R"("m_KeywordType":1,"m_IsEditable":true,"m_Entries":[{"id":4,"displayName":"Low","referenceName":"LOW"},{"id":7,"displayName":"High","referenceName":"HIGH"}])",
              .reference = "_QUALITY"}},
        .nodes = {{.id = "a",
                   .kind = "KeywordNode",
                   .slots = {out(0), {.id = 1, .value = R"({"x":1.0})"}, {.id = 2}},
                   .property = "mud"},
                  {.id = "b",
                   .kind = "KeywordNode",
                   .slots = {out(0), {.id = 4}, {.id = 7, .value = R"({"x":0.5})"}},
                   .property = "q"},
                  {.id = "sum", .kind = "AddNode", .slots = {{0}, {1}, out(2)}}},
        .edges = {{"a", 0, "sum", 0}, {"b", 0, "sum", 1}, {"sum", 2, "BaseColor"}}};
    const Imported made = import_graph(graph);
    EXPECT_NE(text_of(made).find(R"("name": "_MUD", "type": "bool", "default": true, "as": "variant")"),
              std::string::npos)
        << text_of(made);
    EXPECT_NE(text_of(made).find(R"("values": ["Low", "High"])"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find("$_QUALITY == Low ? 0 : 0.5"), std::string::npos) << text_of(made);
    expect_compiles(made, "keywords");
}

ShaderGraphText doubled() {
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
ShaderGraphText user(const std::string& guid, bool is_linked = true) {
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
constexpr const char* kGuid = "0123456789abcdef0123456789abcdef";

TEST(ShaderGraphImport, SubgraphsAreFoundByGuid) {
    save_shader_graph("Doubled.shadersubgraph", doubled().new_layout(), kGuid);
    const Imported made = import_graph(user(kGuid));
    EXPECT_NE(text_of(made).find(R"("node": "./Doubled.subgraph.json")"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find(R"("inValueConnected": true)"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find(R"("mode": 1)"), std::string::npos) << text_of(made);
    const std::string& sub = text_of(made, "Doubled.subgraph.json");
    EXPECT_NE(sub.find(R"("kind": "subgraph")"), std::string::npos);
    EXPECT_NE(sub.find("$mode == 0 ? $inValue : $inValue * 2"), std::string::npos) << sub;
    EXPECT_NE(sub.find("$inValueConnected ?"), std::string::npos) << sub;
    EXPECT_EQ(remarks(made, Remark::Kind::Changed), "");
    expect_compiles(made, "sub-graph");
    // Nothing is connected, so the branch for that case counts.
    const Imported open = import_graph(user(kGuid, false));
    EXPECT_EQ(text_of(open).find("inValueConnected"), std::string::npos) << text_of(open);
    expect_compiles(open, "open sub-graph");
}

TEST(ShaderGraphImport, SubgraphsAreFoundByName) {
    save_shader_graph("Doubled.shadersubgraph", doubled().new_layout());
    const Imported made = import_graph(user(kGuid));
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("no file has its GUID"), std::string::npos)
        << remarks(made, Remark::Kind::Changed);
    expect_compiles(made, "by name");
}

TEST(ShaderGraphImport, AMissingSubgraphIsRefusedAndSeen) {
    const Imported made = import_graph(user(kGuid));
    EXPECT_TRUE(made.has_refused);
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find(std::string("has the GUID ") + kGuid), std::string::npos);
    EXPECT_NE(text_of(made).find(R"x("expr": "float3(1, 0, 1)")x"), std::string::npos) << text_of(made);
    expect_compiles(made, "magenta");
}

TEST(ShaderGraphImport, ASubgraphThatUsesItselfIsRefused) {
    ShaderGraphText circle = user(kGuid);
    circle.edges = {{"sub", 1, "output", 1}};
    circle.outputs = {{.id = 1, .kind = "Vector3", .name = "Result"}};
    save_shader_graph("Doubled.shadersubgraph", circle.new_layout(), kGuid);
    const Imported made = import_graph(user(kGuid));
    EXPECT_EQ(made.error, "");
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find("uses itself"), std::string::npos);
}

NodeText custom(const std::string& body, const std::string& name = "Glow", int source = 1) {
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

TEST(ShaderGraphImport, CodeBecomesANodeFile) {
    const Imported made = import_graph(one_node(
        custom(
            R"(#if SHADERGRAPH_PREVIEW\nOut = 1;\n#else\n$precision3 twice = A * 2.0f; // doubled\nOut = pow(twice, B);\n#endif)"),
        2));
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    const std::string& code = text_of(made, "Glow.node.hlsl");
    EXPECT_NE(
        code.find(
            "void Glow(float3 A, float B, out float3 Out) {\n    float3 twice = A * 2.0;\n    Out = pow(twice, B);\n}"),
        std::string::npos)
        << code;
    expect_compiles(made, "code");
}

TEST(ShaderGraphImport, CodeOfTheEnginesLightReadsTheMainLight) {
    const Imported made = import_graph(one_node(
        custom(R"(Light l = GetMainLight();\nOut = l.color * l.distanceAttenuation * dot(A, l.direction) * B;)"), 2));
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("@light"), std::string::npos);
    expect_compiles(made, "light");
}

TEST(ShaderGraphImport, CodeThatIsNotValidIsRefusedWithTheReason) {
    const Imported made = import_graph(one_node(custom(R"(Out = SomethingOfTheEngine(A);)"), 2));
    EXPECT_TRUE(made.has_refused);
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find("SomethingOfTheEngine"), std::string::npos)
        << remarks(made, Remark::Kind::LeftOut);
    expect_compiles(made, "magenta");
}

TEST(ShaderGraphImport, AFunctionOfAFileBringsWhatItCalls) {
    save_shader_graph(
        "Glow.hlsl",
        "#ifndef GLOW\n#define GLOW\nfloat Half_float(float x) { return x * 0.5; }\nvoid Unused_float(out float x) { x "
        "= tex2D(a, b); }\n"
        "void Glow_float(float3 A, float B, out float3 Out)\n{\n    Out = A * Half_float(B);\n}\n#endif\n",
        kGuid);
    const Imported made = import_graph(one_node(custom("", "Glow", 0), 2));
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    EXPECT_EQ(text_of(made, "Glow.node.hlsl").find("Unused"), std::string::npos);
    expect_compiles(made, "file");
}

TEST(ShaderGraphImport, CustomInterpolatorsAreNodesOfTheVertexStage) {
    ShaderGraphText graph{
        .nodes = {{.id = "a", .kind = "PositionNode", .slots = {out(0, "Vector3")}, .more = R"("m_Space":0)"},
                  {.id = "read",
                   .kind = "CustomInterpolatorNode",
                   .slots = {out(0, "Vector3")},
                   .more = R"("customBlockNodeName":"Blend")"}},
        .edges = {{"a", 0, "Blend#3"}, {"read", 0, "BaseColor"}},
        .blocks = {{"VertexDescription.Blend#3", "Vector3"}, {"SurfaceDescription.BaseColor", "ColorRGB"}}};
    const Imported made = import_graph(graph);
    EXPECT_NE(text_of(made).find(R"({ "id": "blend", "expr": "@positionOS", "stage": "vertex" })"), std::string::npos)
        << text_of(made);
    expect_compiles(made, "interpolator");
}

// --- settings

TEST(ShaderGraphImport, SettingsBecomeTheRenderState) {
    struct Case {
        const char *target, *material, *expected;
    };
    const Case cases[] = {
        {R"("m_SurfaceType":0,"m_RenderFace":2)", "UniversalUnlitSubTarget", ""},
        {R"("m_SurfaceType":1,"m_AlphaMode":0)", "UniversalUnlitSubTarget", R"("surface": "fade")"},
        {R"("m_SurfaceType":1,"m_AlphaMode":1)", "UniversalUnlitSubTarget", R"("surface": "transparent")"},
        {R"("m_SurfaceType":1,"m_AlphaMode":2)", "UniversalUnlitSubTarget", R"("surface": "additive")"},
        {R"("m_SurfaceType":1,"m_AlphaMode":3)", "UniversalUnlitSubTarget", R"("surface": "multiply")"},
        {R"("m_AlphaClip":true)", "UniversalUnlitSubTarget", R"("surface": "cutout")"},
        {R"("m_RenderFace":0)", "UniversalUnlitSubTarget", R"("cull": "off")"},
        {R"("m_RenderFace":1)", "UniversalUnlitSubTarget", R"("cull": "front")"},
        {R"("m_TwoSided":true)", "UniversalUnlitSubTarget", R"("cull": "off")"},
        {R"("m_ZWriteControl":2)", "UniversalUnlitSubTarget", R"("depthWrite": false)"},
        {R"("m_ZTestMode":8)", "UniversalUnlitSubTarget", R"("depthTest": "always")"},
        {R"("m_SurfaceType":0)", "UniversalSpriteUnlitSubTarget", R"("surface": "fade", "cull": "off")"},
    };
    for (const Case& each : cases) {
        ShaderGraphText graph = painted();
        graph.target = each.target;
        graph.material = each.material;
        const Imported made = import_graph(graph);
        const std::string text = text_of(made);
        const std::string expected = each.expected;
        EXPECT_NE(text.find(expected), std::string::npos) << each.target << text;
        EXPECT_EQ(text.find("\"render\"") == std::string::npos, expected.empty()) << text;
        expect_compiles(made, each.target);
    }
}

TEST(ShaderGraphImport, LitMaterialsTakeTheirWorkflow) {
    ShaderGraphText graph = painted();
    graph.material = "UniversalLitSubTarget";
    graph.blocks.push_back({"SurfaceDescription.Metallic", "Vector1", "1.0"});
    graph.blocks.push_back({"SurfaceDescription.Smoothness", "Vector1", "0.75"});
    graph.blocks.push_back({"SurfaceDescription.Specular", "ColorRGB"});
    graph.blocks.push_back({"SurfaceDescription.Occlusion", "Vector1", "1.0"});
    Imported made = import_graph(graph);
    EXPECT_NE(text_of(made).find(R"("workflow": "metallic-smoothness")"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find(R"("metallic": 1)"), std::string::npos) << text_of(made);
    EXPECT_EQ(text_of(made).find("occlusion"), std::string::npos) << "its default is not written";
    EXPECT_EQ(text_of(made).find("specular\":"), std::string::npos) << "the target does not have it";
    expect_compiles(made, "lit");
    graph.material_settings = R"("m_WorkflowMode":0)";
    made = import_graph(graph);
    EXPECT_NE(text_of(made).find(R"("workflow": "specular-glossiness")"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find(R"("glossiness": 0.75)"), std::string::npos) << text_of(made);
    expect_compiles(made, "specular");
}

TEST(ShaderGraphImport, GroupsAndNotesAreKept) {
    ShaderGraphText graph = painted();
    graph.nodes[3].group = "g";
    graph.more_of_graph = R"("m_GroupDatas":[{"m_Id":"g"}],"m_StickyNoteDatas":[{"m_Id":"n"}])";
    graph.more_objects = R"x(

{"m_SGVersion":0,"m_Type":"UnityEditor.ShaderGraph.GroupData","m_ObjectId":"g","m_Title":"Paint"}

{"m_SGVersion":0,"m_Type":"UnityEditor.ShaderGraph.StickyNoteData","m_ObjectId":"n","m_Title":"Careful","m_Content":"wet","m_Position":{"x":1.0,"y":2.0,"width":30.0,"height":40.0}})x";
    const Imported made = import_graph(graph);
    EXPECT_NE(text_of(made).find("// Paint\n"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find(R"({ "title": "Paint", "nodes": ["mainTex"] })"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find(R"("title": "Careful", "text": "wet", "at": [1, 2], "size": [30, 40])"),
              std::string::npos)
        << text_of(made);
    expect_compiles(made, "notes");
}

// --- broken files

TEST(ShaderGraphImport, BrokenFilesAreReportedAtTheirPlace) {
    const std::string good = painted().new_layout();
    EXPECT_TRUE(std::regex_search(import_text(good.substr(0, good.size() - 10)).error,
                                  std::regex("x\\.shadergraph:[0-9]+:[0-9]+: ")));
    EXPECT_NE(import_text("").error.find("the file is empty"), std::string::npos);
    EXPECT_NE(import_text("nonsense").error.find("x.shadergraph:1:1: "), std::string::npos);
    EXPECT_NE(import_text("{}").error.find("is no shader graph"), std::string::npos);
    EXPECT_NE(import_text(good + "\n\n<<<<<<< HEAD\n").error.find("begins with '{'"), std::string::npos);
    std::string nan = good;
    nan.replace(nan.find("0.25"), 4, "NaN");
    EXPECT_TRUE(std::regex_search(import_text(nan).error, std::regex("x\\.shadergraph:[0-9]+:[0-9]+: ")))
        << import_text(nan).error;
    EXPECT_NE(import_text(std::string(5000, '{') + good).error, "");
    ShaderGraphText twice = painted();
    twice.nodes.push_back(twice.nodes[0]);
    EXPECT_NE(import_graph(twice).error.find("a second object has the id"), std::string::npos);
    ShaderGraphText circle = painted();
    circle.edges.push_back({"mix", 3, "product", 0});
    circle.edges.erase(circle.edges.begin() + 1);
    EXPECT_NE(import_graph(circle).error.find("reads itself, through"), std::string::npos);
}

TEST(ShaderGraphImport, WhatIsMissingIsSaid) {
    ShaderGraphText graph = painted();
    graph.edges.push_back({"nobody", 0, "mix", 1});
    graph.edges.push_back({"a", 99, "mix", 1});
    graph.nodes.push_back({.id = "u", .kind = "NodeOfTheFuture", .slots = {{0}, out(1)}, .name = "Future"});
    graph.edges.push_back({"u", 1, "mix", 1});
    const Imported made = import_graph(graph);
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("a node at its end does not exist"), std::string::npos);
    EXPECT_NE(remarks(made, Remark::Kind::Changed).find("the slot at its end does not exist"), std::string::npos);
    EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find("'NodeOfTheFuture' is no node"), std::string::npos);
    expect_compiles(made, "missing");
}

// Each level reads the one before it twice: what is noted of a value must not double with each.
TEST(ShaderGraphImport, AChainThatReadsEachLinkTwiceIsShort) {
    ShaderGraphText graph;
    graph.nodes.push_back({.id = "uv", .kind = "UVNode", .slots = {{.id = 0, .kind = "Vector4", .is_input = false}}});
    std::string last = "uv";
    int slot = 0;
    for (int i = 0; i < 60; ++i) {
        const std::string split = fmt::format("split{}", i), combine = fmt::format("combine{}", i);
        graph.nodes.push_back({.id = split,
                               .kind = "SplitNode",
                               .slots = {{.id = 0, .kind = "DynamicVector"},
                                         {.id = 1, .kind = "Vector1", .is_input = false},
                                         {.id = 2, .kind = "Vector1", .is_input = false}}});
        graph.nodes.push_back({.id = combine,
                               .kind = "CombineNode",
                               .slots = {{.id = 0, .kind = "Vector1"},
                                         {.id = 1, .kind = "Vector1"},
                                         {.id = 6, .kind = "Vector2", .is_input = false}}});
        graph.edges.push_back({last, slot, split, 0});
        graph.edges.push_back({split, 1, combine, 0});
        graph.edges.push_back({split, 2, combine, 1});
        last = combine;
        slot = 6;
    }
    graph.edges.push_back({last, slot, "BaseColor"});
    const Imported made = import_graph(graph);
    EXPECT_FALSE(made.has_refused) << remarks(made, Remark::Kind::LeftOut);
    EXPECT_LT(made.graphs[0].text.size(), 20000u);
}

TEST(ShaderGraphImport, AConditionWithoutEndIsRefused) {
    const std::map<std::string, std::string> reasons = {
        {"#if " + std::string(400000, '!') + R"(A\nOut = A;\n#endif)", "a condition of its preprocessor is too long"},
        {R"(#if 1\nOut = A;)", "it has an '#if' without its '#endif'"}};
    for (const auto& [body, reason] : reasons) {
        const Imported made = import_graph(one_node(custom(body), 2));
        EXPECT_TRUE(made.has_refused) << reason;
        EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find(reason), std::string::npos)
            << remarks(made, Remark::Kind::LeftOut);
    }
}

TEST(ShaderGraphImport, HugeNumbersAreNumbers) {
    ShaderGraphText graph = painted();
    graph.properties[2].value = "1e300";
    EXPECT_EQ(import_graph(graph).error, "");
    expect_compiles(import_graph(graph), "huge");
}

// Whatever is changed in a file: it is imported or refused, and an import is a graph.
TEST(ShaderGraphImport, MutationsDoNotCrash) {
    std::mt19937 random(19);
    const std::string seeds[] = {painted().new_layout(), painted().old_layout(), user(kGuid).new_layout(),
                                 doubled().new_layout()};
    std::size_t imported = 0;
    for (int i = 0; i < 4000; ++i) {
        std::string text = seeds[random() % 4];
        for (int edits = 1 + static_cast<int>(random() % 4); edits > 0; --edits) {
            const std::size_t at = random() % text.size(), count = 1 + random() % 12;
            switch (random() % 4) {
                case 0: text[at] = static_cast<char>(random() % 256); break;
                case 1: text.erase(at, count); break;
                case 2: text.insert(at, text.substr(random() % text.size(), count)); break;
                case 3:
                    text[std::min(text.find_first_of("0123456789", at), text.size() - 1)] =
                        static_cast<char>('0' + random() % 10);
                    break;
            }
        }
        const Imported made = import_text(text);
        EXPECT_EQ(made.error.empty(), !made.graphs.empty());
        if (made.error.empty()) ++imported;
    }
    EXPECT_GT(imported, 500u);
}

}  // namespace
}  // namespace patina::importers
