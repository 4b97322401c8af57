// Each class of the table of Unity's nodes, with the slots that files have: with nothing connected and with numbers and
// vectors of each size, with each setting left out and with each of its values. What is imported compiles without a
// warning; what is not imported is refused at its place.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <regex>

#include "compiler/importers/shadergraph/values/types.h"
#include "tests/unit/importers/shadergraph/shadergraph_import.h"

namespace patina::importers {
namespace {

struct Row {
    std::string kind, condition, outputs, remark;
};
const std::vector<Row>& rows() {
    static const std::vector<Row> made = {
#define NODE(kind, condition, outputs, remark) {kind, condition, outputs, remark},
#include "compiler/importers/shadergraph/nodes.def"
#undef NODE
    };
    return made;
}

struct Slots {
    std::string kind, inputs, outputs;
};
const Slots kSlots[] = {
#define SLOTS(kind, inputs, outputs) {kind, inputs, outputs},
#include "tests/unit/importers/shadergraph/shadergraph_slots.def"
#undef SLOTS
};

std::vector<SlotText> slots_of(const std::string& list, bool is_input) {
    std::vector<SlotText> made;
    const std::regex slot("([0-9]+) ([A-Za-z0-9]+) ?([A-Za-z]*)");
    for (std::sregex_iterator each(list.begin(), list.end(), slot), end; each != end; ++each) {
        SlotText text{.id = std::stoi((*each)[1]), .kind = (*each)[2], .is_input = is_input, .name = (*each)[3]};
        if (text.kind == "Vector1") text.value = "0.5";
        if (text.kind == "Boolean") text.value = "true";
        if (text.kind == "DynamicVector" || text.kind.starts_with("Vector"))
            text.value = text.kind == "Vector1" ? "0.5" : R"({"x":0.5,"y":0.25,"z":0.75,"w":1.0})";
        made.push_back(std::move(text));
    }
    return made;
}

// --- settings of a class, as its rows name them

struct Setting {
    std::string name;
    std::vector<int> values{};
    bool is_closed = false;  // it has no other values
};

std::vector<Setting> settings_of(const std::string& kind) {
    std::vector<Setting> made;
    const auto setting = [&](const std::string& name) -> Setting& {
        for (Setting& each : made)
            if (each.name == name) return each;
        return made.emplace_back(Setting{.name = name});
    };
    const auto add = [](Setting& to, int value) {
        if (std::find(to.values.begin(), to.values.end(), value) == to.values.end()) to.values.push_back(value);
    };
    for (const Row& row : rows()) {
        if (row.kind != kind) continue;
        const std::regex choice(R"(\[(m_[A-Za-z.]+)(?:=[0-9]+)?((?:\|[^\]|]*)+)\])"),
            condition("(m_[A-Za-z.]+)=([-0-9,*]+)"), switches("<([A-Za-z_,]+):0>");
        for (std::sregex_iterator each(row.outputs.begin(), row.outputs.end(), choice), end; each != end; ++each) {
            const std::string words = (*each)[2];
            for (int i = 0; i < std::count(words.begin(), words.end(), '|'); ++i) add(setting((*each)[1]), i);
            setting((*each)[1]).is_closed = true;
        }
        for (std::sregex_iterator each(row.condition.begin(), row.condition.end(), condition), end; each != end;
             ++each) {
            const std::string values = (*each)[2];
            const std::regex number("-?[0-9]+");
            for (std::sregex_iterator value(values.begin(), values.end(), number); value != end; ++value)
                add(setting((*each)[1]), std::stoi(value->str()));
        }
        for (std::sregex_iterator each(row.outputs.begin(), row.outputs.end(), switches), end; each != end; ++each) {
            const std::string names = (*each)[1];
            const std::regex name("m_[A-Za-z]+");
            for (std::sregex_iterator one(names.begin(), names.end(), name); one != end; ++one)
                for (const int value : {0, 1}) add(setting(one->str()), value);
        }
        if (row.outputs.find("<&m_ChannelMask") != std::string::npos)
            for (const int value : {-1, 0, 5}) add(setting("m_ChannelMask"), value);
    }
    return made;
}

using Chosen = std::vector<std::pair<std::string, int>>;

// "m_Conversion.from" and "m_Conversion.to" are members of one object.
std::string settings_text(const Chosen& chosen) {
    std::map<std::string, std::string> made;
    for (const auto& [name, value] : chosen) {
        const std::size_t dot = name.find('.');
        std::string& text = made[name.substr(0, dot)];
        text += dot == name.npos ? std::to_string(value)
                                 : fmt::format("{}\"{}\":{}", text.empty() ? "" : ",", name.substr(dot + 1), value);
    }
    std::string all;
    for (const auto& [name, text] : made) {
        const bool is_object = text.find(':') != text.npos;
        all += fmt::format("{}\"{}\":{}{}{}", all.empty() ? "" : ",", name, is_object ? "{" : "", text,
                           is_object ? "}" : "");
    }
    return all;
}

// --- a graph with one node, whose outputs are all read, and whose inputs are connected to values of `width`
// components, or to nothing

ShaderGraphText graph_of(const Slots& slots, const std::string& settings, std::size_t width, int version) {
    NodeText node{.id = "it",
                  .kind = slots.kind,
                  .slots = slots_of(slots.inputs, true),
                  .more = settings,
                  .version = version,
                  .name = "It"};
    ShaderGraphText graph{.nodes = {}, .edges = {}};
    const auto value = [&](const std::string& kind, const std::string& json) {
        graph.properties.push_back({.id = "value", .kind = kind, .name = "Value", .value = json});
        graph.nodes.push_back(
            {.id = "source", .kind = "PropertyNode", .slots = {out(0, kind)}, .name = "Property", .property = "value"});
    };
    if (width > 0) value(fmt::format("Vector{}", width), width == 1 ? "0.5" : R"({"x":0.5,"y":0.25,"z":0.75,"w":1.0})");
    if (width > 1)
        graph.nodes.push_back(
            {.id = "matrix",
             .kind = fmt::format("Matrix{}Node", width),
             .slots = {out(0, fmt::format("Matrix{}", width))},
             .more = R"("m_Row0":{"x":1.0},"m_Row1":{"y":1.0},"m_Row2":{"z":1.0},"m_Row3":{"w":1.0})"});
    if (width > 0) {
        graph.properties.push_back(
            {.id = "how", .kind = "SamplerState", .name = "How", .value = R"({"m_filter":1,"m_wrap":1})"});
        graph.nodes.push_back({.id = "sampler",
                               .kind = "PropertyNode",
                               .slots = {out(0, "SamplerState")},
                               .name = "Property",
                               .property = "how"});
    }
    for (const SlotText& slot : node.slots) {
        const shadergraph::Type type = shadergraph::type_of_slot(slot.kind).type;
        if (width > 0 && type == shadergraph::Type::Sampler) graph.edges.push_back({"sampler", 0, "it", slot.id});
        if (slot.kind == "DynamicMatrix" && width > 1) graph.edges.push_back({"matrix", 0, "it", slot.id});
        if (width > 0 && (shadergraph::is_vector(type) || type == shadergraph::Type::Bool))
            graph.edges.push_back({"source", 0, "it", slot.id});
    }
    std::string last;
    int last_slot = 0;
    for (const SlotText& slot : slots_of(slots.outputs, false)) {
        node.slots.push_back(slot);
        const shadergraph::Type type = shadergraph::type_of_slot(slot.kind).type;
        const std::string id = fmt::format("read{}", slot.id), sum = fmt::format("sum{}", slot.id);
        int read = 1;
        if (type == shadergraph::Type::VirtualTexture) continue;
        if (type == shadergraph::Type::Sampler) {
            graph.nodes.push_back({.id = id,
                                   .kind = "SampleTexture2DNode",
                                   .slots = {{.id = 1, .kind = "Texture2DInput", .more = R"("m_Texture":{})"},
                                             {.id = 2, .kind = "UV"},
                                             {3, "SamplerState"},
                                             out(0, "Vector4")}});
            read = 3;
        } else if (type == shadergraph::Type::Texture2D || type == shadergraph::Type::Cubemap ||
                   type == shadergraph::Type::Texture2DArray || type == shadergraph::Type::Texture3D) {
            const bool is_cube = type == shadergraph::Type::Cubemap, is_flat = type == shadergraph::Type::Texture2D;
            graph.nodes.push_back({.id = id,
                                   .kind = is_cube                                ? "SampleRawCubemapNode"
                                           : is_flat                              ? "SampleTexture2DNode"
                                           : type == shadergraph::Type::Texture3D ? "SampleTexture3DNode"
                                                                                  : "SampleTexture2DArrayNode",
                                   .slots = {{1, slot.kind + "Input"},
                                             {.id = 2,
                                              .kind = is_cube                                ? "Normal"
                                                      : type == shadergraph::Type::Texture3D ? "Vector3"
                                                                                             : "UV"},
                                             {.id = 4, .kind = "Vector1", .value = "0.0"},
                                             {.id = 8, .kind = "Vector1", .value = "0.0"},
                                             out(0, "Vector4")}});
            read = 0;
        } else if (type == shadergraph::Type::Gradient) {
            graph.nodes.push_back(
                {.id = id,
                 .kind = "SampleGradient",
                 .slots = {{0, "GradientInput"}, {.id = 1, .kind = "Vector1", .value = "0.5"}, out(2, "Vector4")}});
            read = 2;
        } else if (shadergraph::is_matrix(type)) {
            graph.nodes.push_back(
                {.id = id, .kind = "MatrixDeterminantNode", .slots = {{0, "DynamicMatrix"}, out(1, "Vector1")}});
        } else {
            graph.nodes.push_back({.id = id, .kind = "AbsoluteNode", .slots = {{0}, out(1)}});
        }
        const bool is_sample = read == 0, is_sampler = read == 3;
        graph.edges.push_back({"it", slot.id, id, is_sampler ? 3 : is_sample ? 1 : 0});
        if (is_sampler) read = 0;
        graph.nodes.push_back({.id = sum, .kind = "AddNode", .slots = {{0}, {1}, out(2)}});
        graph.edges.push_back({id, read, sum, 0});
        if (!last.empty()) graph.edges.push_back({last, last_slot, sum, 1});
        last = sum;
        last_slot = 2;
    }
    graph.nodes.push_back(node);
    if (!last.empty()) graph.edges.push_back({last, last_slot, "BaseColor"});
    return graph;
}

// One of its outputs is a value that only the engine has.
bool has_refused_row(const std::string& kind) {
    return std::any_of(rows().begin(), rows().end(),
                       [&](const Row& row) { return row.kind == kind && row.remark.starts_with("!"); });
}

// About the numbers of this test, and not about what the importer makes of a node.
bool is_about_values(const Diagnostic& each, const std::string& kind) {
    // The library's node speaks of world space, but computes in any.
    const bool is_space = each.code == "wrong-meaning" && kind == "TriplanarNode";
    return each.code == "soft-range" || each.code == "division-by-zero" || is_space;
}

bool has_versions(const std::string& kind) {
    return std::any_of(rows().begin(), rows().end(), [&](const Row& row) {
        return row.kind == kind && row.condition.find("version<") != std::string::npos;
    });
}

// Imports and compiles; a refusal has its place.
void expect_imported(const Slots& slots, const Chosen& chosen, std::size_t width, bool may_refuse) {
    for (int version = has_versions(slots.kind) ? 0 : 1; version <= 1; ++version) {
        const std::string settings = settings_text(chosen);
        const std::string what =
            fmt::format("{} {{{}}} connected to {}, version {}", slots.kind, settings, width, version);
        const Imported made = import_graph(graph_of(slots, settings, width, version));
        ASSERT_EQ(made.error, "") << what;
        const Result result = compiled(made);
        for (const Diagnostic& each : result.diagnostics) {
            if (!is_about_values(each, slots.kind)) ADD_FAILURE() << what << ": " << to_text(each) << text_of(made);
        }
        ASSERT_TRUE(result.ok) << what << "\n" << text_of(made);
        bool has_reason = false;
        for (const Remark& each : made.remarks)
            has_reason |= each.kind == Remark::Kind::LeftOut && each.part == "node 'It'" && each.line > 0;
        EXPECT_EQ(made.has_refused, has_reason) << what;
        EXPECT_TRUE(!made.has_refused || may_refuse) << what << ": " << remarks(made, Remark::Kind::LeftOut);
    }
}

// All combinations of the settings' values.
void for_each_choice(const std::vector<Setting>& settings, const std::function<void(const Chosen&)>& use,
                     Chosen chosen = {}) {
    if (chosen.size() == settings.size()) return use(chosen);
    const Setting& next = settings[chosen.size()];
    for (const int value : next.values) {
        Chosen more = chosen;
        more.push_back({next.name, value});
        for_each_choice(settings, use, more);
    }
}

class ShaderGraphNodes : public testing::TestWithParam<std::size_t> {};

TEST_P(ShaderGraphNodes, ImportWithEachInputAndSetting) {
    for (std::size_t i = GetParam(); i < std::size(kSlots); i += 8) {
        const Slots& slots = kSlots[i];
        const bool may_refuse = has_refused_row(slots.kind);
        const std::vector<Setting> settings = settings_of(slots.kind);
        for (std::size_t width = 0; width <= 4; ++width) {
            expect_imported(slots, {}, width, may_refuse);
            for (const Setting& setting : settings)
                for (const int value : setting.values)
                    expect_imported(slots, {{setting.name, value}}, width, may_refuse);
        }
        for_each_choice(settings, [&](const Chosen& chosen) { expect_imported(slots, chosen, 3, may_refuse); });
    }
}
INSTANTIATE_TEST_SUITE_P(All, ShaderGraphNodes, testing::Range(std::size_t{0}, std::size_t{8}));

TEST(ShaderGraphTable, EachClassHasItsSlots) {
    for (const Row& row : rows())
        EXPECT_TRUE(std::any_of(std::begin(kSlots), std::end(kSlots), [&](const Slots& each) {
            return each.kind == row.kind;
        })) << row.kind;
}

TEST(ShaderGraphTable, AValueOfTheFutureIsRefusedByName) {
    std::size_t count = 0;
    for (const Slots& slots : kSlots)
        for (const Setting& setting : settings_of(slots.kind)) {
            if (!setting.is_closed) continue;
            // A space of the result is asked for only if the result is a normal.
            const Chosen chosen = {{setting.name, 99}, {"m_TextureType", setting.name == "m_TextureType" ? 99 : 1}};
            const Imported made = import_graph(graph_of(slots, settings_text(chosen), 0, 1));
            EXPECT_NE(remarks(made, Remark::Kind::LeftOut).find(fmt::format("its setting '{}' is 99", setting.name)),
                      std::string::npos)
                << slots.kind << " " << setting.name << remarks(made, Remark::Kind::LeftOut);
            expect_compiles(made, slots.kind);
            ++count;
        }
    EXPECT_GT(count, 30u);
}

// What a node is after its import, with no input connected.
std::string imported_node(const std::string& kind, const std::string& settings) {
    const auto slots =
        std::find_if(std::begin(kSlots), std::end(kSlots), [&](const Slots& each) { return each.kind == kind; });
    return text_of(import_graph(graph_of(*slots, settings, 0, 1)));
}

TEST(ShaderGraphTable, FresnelsEquationsAreThoseOfTheLibrary) {
    const auto fresnel = [](int mode) {
        return imported_node("HDFresnelEquationNode", fmt::format("\"m_FresnelEquationMode\":{}", mode));
    };
    EXPECT_NE(fresnel(0).find("0.5 + 0.25 * pow(0.25, 2)"), std::string::npos) << fresnel(0);
    EXPECT_NE(fresnel(1).find(R"("node": "FresnelDielectric")"), std::string::npos) << fresnel(1);
    EXPECT_NE(fresnel(2).find(R"("node": "FresnelConductor")"), std::string::npos) << fresnel(2);
}

Imported import_switch(const std::string& more) {
    return import_graph({.properties = {{.id = "p", .kind = "Vector1", .name = "P", .value = "1.0"}},
                         .nodes = {{.id = "v", .kind = "PropertyNode", .slots = {out(0, "Vector1")}, .property = "p"},
                                   {.id = "it",
                                    .kind = "SwitchNode",
                                    .slots = {{.id = 0, .kind = "Vector1", .value = "0.0"},
                                              {.id = 1, .value = R"({"x":0.25,"y":0.0,"z":0.0,"w":0.0})"},
                                              {.id = 3, .value = R"({"x":0.5,"y":0.0,"z":0.0,"w":0.0})"},
                                              {.id = 4, .value = R"({"x":0.75,"y":0.0,"z":0.0,"w":0.0})"},
                                              out(2)},
                                    .more = more,
                                    .name = "It"}},
                         .edges = {{"v", 0, "it", 0}, {"it", 2, "BaseColor"}}});
}

TEST(ShaderGraphTable, ASwitchIsAChainOfConditions) {
    const std::string cases =
        R"([{"name":"a","comparisonType":0,"threshold":2.0},{"comparisonType":3,"threshold":5.0}])";
    const Imported made = import_switch("\"m_cases\":" + cases);
    EXPECT_NE(text_of(made).find(R"j("it", "expr": "floor($_P)")j"), std::string::npos) << text_of(made);
    EXPECT_NE(text_of(made).find("it == 2 ? 0.5 : it <= 5 ? 0.75 : 0.25"), std::string::npos) << text_of(made);
    expect_compiles(made, "a switch");
    const Imported enumerated = import_switch(
        R"("m_floorPredicate":false,"m_useProperty":true,"m_cases":[],"m_casesFromUpstreamEnumProperty":)" + cases);
    EXPECT_NE(text_of(enumerated).find("$_P == 2 ? 0.5 : $_P <= 5 ? 0.75 : 0.25"), std::string::npos)
        << text_of(enumerated);
    expect_compiles(enumerated, "a switch by a list");
}

TEST(ShaderGraphTable, UnknownNodesHaveTheirReasons) {
    const auto reason = [](const std::string& kind, const std::string& name_space = "UnityEditor.ShaderGraph") {
        std::string text = one_node({.id = "it", .kind = kind, .slots = {out(0, "Vector1")}}, 0).new_layout();
        const std::string full = "UnityEditor.ShaderGraph." + kind;
        text.replace(text.find(full), full.size(), name_space + "." + kind);
        return remarks(import_shadergraph(text), Remark::Kind::LeftOut);
    };
    EXPECT_NE(reason("HDSceneColorNode").find("the buffers of the high definition pipeline"), std::string::npos);
    EXPECT_NE(reason("PackVertexData_Water").find("the water of the high definition pipeline"), std::string::npos);
    EXPECT_NE(reason("ForLoopEndNode").find("a fork of Unity"), std::string::npos);
    EXPECT_NE(reason("NewNode", "UnityEditor.Rendering.HighDefinition").find("no node of the high definition pipeline"),
              std::string::npos);
    EXPECT_NE(reason("MyNode").find("'MyNode' is no node of Shader Graph"), std::string::npos);
}

TEST(ShaderGraphTable, EachMatrixOfTheEngineIsANode) {
    const char* kinds[] = {"",           "WorldToObject", "WorldToView", "ViewToWorld",
                           "ViewToClip", "ClipToView",    "WorldToClip", "ClipToWorld"};
    for (std::size_t i = 0; i < std::size(kinds); ++i)
        for (const char* setting : {"m_MatrixType", "m_matrix"}) {
            const std::string text = imported_node("TransformationMatrixNode", fmt::format("\"{}\":{}", setting, i));
            const std::string input = i == 0 ? "" : fmt::format(R"(, "in": {{ "kind": "{}" }})", kinds[i]);
            EXPECT_NE(text.find(R"("node": "TransformationMatrix")" + input + " }"), std::string::npos) << text;
        }
}

// v counts from the bottom in the engine, and on the screen, too.
TEST(ShaderGraphTable, PointsGoToTheScreenAndBack) {
    const std::string to = imported_node("TransformNode", R"("m_Conversion":{"from":0,"to":5})");
    EXPECT_NE(to.find(R"("node": "Transform", "in": { "vector": [0.5, 0.25, 0.75], "to": "Screen" })"),
              std::string::npos)
        << to;
    EXPECT_NE(to.find("float3(it.x, 1 - it.y, it.z)"), std::string::npos) << to;
    const std::string from = imported_node("TransformNode", R"("m_Conversion":{"from":5,"to":1})");
    EXPECT_NE(from.find(R"("from": "Screen", "to": "View" })"), std::string::npos) << from;
}

TEST(ShaderGraphTable, EachSetOfTextureCoordinatesIsRead) {
    for (int set = 0; set < 4; ++set) {
        const std::string text = imported_node("UVNode", fmt::format("\"m_OutputChannel\":{}", set));
        const std::string name = set == 0 ? "uv" : fmt::format("uv{}", set);
        EXPECT_NE(text.find(fmt::format("\"id\": \"{}\"", name)), std::string::npos) << text;
        EXPECT_NE(text.find(fmt::format("\"expr\": \"float2(@uv{0}.x, 1 - @uv{0}.y)\"", set)), std::string::npos)
            << text;
    }
}

// If a file lacks a setting, the setting has Unity's default.
TEST(ShaderGraphTable, AbsentSettingsAreTheDefaults) {
    const std::pair<const char*, Chosen> defaults[] = {
        {"BlendNode", {{"m_BlendMode", 15}}},
        {"RefractNode", {{"m_RefractMode", 1}}},
        {"ParallaxMappingNode", {{"m_Channel", 1}}},
        {"ParallaxOcclusionMappingNode", {{"m_Channel", 0}}},
        {"CalculateLevelOfDetailTexture2DNode", {{"m_Clamp", 1}}},
        {"TriplanarNode", {{"m_TextureType", 0}}},
        {"TransformNode", {{"m_Conversion.from", 0}, {"m_Conversion.to", 2}}},
        {"TransformNode", {{"m_ConversionType", 0}, {"m_Normalize", 1}}},
        {"PositionNode", {{"m_Space", 2}}},
        {"NormalVectorNode", {{"m_Space", 2}}},
        {"TangentVectorNode", {{"m_Space", 2}}},
        {"BitangentVectorNode", {{"m_Space", 2}}},
        {"ViewDirectionNode", {{"m_Space", 2}}},
        {"ViewVectorNode", {{"m_Space", 2}}},
        {"FlipbookNode", {{"m_InvertX", 0}, {"m_InvertY", 1}}},
        {"ChannelMaskNode", {{"m_ChannelMask", -1}}},
        {"SampleTexture2DNode", {{"m_TextureType", 0}, {"m_NormalMapSpace", 0}, {"m_MipSamplingMode", 0}}},
        {"RotateNode", {{"m_Unit", 0}}},
        {"HueNode", {{"m_HueMode", 0}}},
    };
    for (const auto& each_default : defaults) {
        const std::string kind = each_default.first;
        const Chosen& chosen = each_default.second;
        const auto slots =
            std::find_if(std::begin(kSlots), std::end(kSlots), [&](const Slots& each) { return each.kind == kind; });
        ASSERT_NE(slots, std::end(kSlots)) << kind;
        EXPECT_EQ(text_of(import_graph(graph_of(*slots, "", 3, 1))),
                  text_of(import_graph(graph_of(*slots, settings_text(chosen), 3, 1))))
            << kind;
    }
    // A normal that is sampled from three sides: world space in, tangent space out.
    const auto triplanar = std::find_if(std::begin(kSlots), std::end(kSlots),
                                        [](const Slots& each) { return each.kind == "TriplanarNode"; });
    EXPECT_EQ(text_of(import_graph(graph_of(*triplanar, R"("m_TextureType":1)", 3, 1))),
              text_of(import_graph(
                  graph_of(*triplanar, R"("m_TextureType":1,"m_InputSpace":4,"m_NormalOutputSpace":3)", 3, 1))));
}

TEST(ShaderGraphTable, TheTableNamesNodesOfTheLibraryAlone) {
    const std::regex call(R"(@([A-Z][A-Za-z0-9]*)\()");
    for (const Row& each : rows()) {
        for (std::sregex_iterator found(each.outputs.begin(), each.outputs.end(), call), end; found != end; ++found)
            EXPECT_NE(compiler().node((*found)[1].str()), nullptr) << each.kind << ": " << (*found)[1];
    }
}

}  // namespace
}  // namespace patina::importers
