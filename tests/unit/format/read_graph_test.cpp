// The graph reader: the meaning of each key, the values at ports, and the messages for everything else.
#include "compiler/format/read_graph.h"

#include <gtest/gtest.h>

#include "compiler/format/color.h"
#include "compiler/format/keys.h"

namespace patina::format {

using namespace json;
namespace {

using nodelang::Expr;

struct Read {
    SourceMap sources;
    Diagnostics diagnostics;
    nodelang::Ast ast;
    std::unique_ptr<Json> json;
    std::shared_ptr<Graph> graph;

    explicit Read(std::string text, std::optional<GraphKind> expected = {}, std::string path = "dir/t.graph.json") {
        const std::uint32_t base = sources.add(path, std::move(text));
        json = parse_json(sources, base, diagnostics);
        if (json) graph = read_graph(*json, std::move(path), sources, ast, diagnostics, expected);
    }
    // "column message | note | note" of each complaint; all texts here are one line.
    std::vector<std::string> complaints() const {
        std::vector<std::string> out;
        for (const DiagnosticRecord& record : diagnostics.records()) {
            std::string text = fmt::format("{} {}", sources.resolve(record.span.begin).column, record.message);
            for (const DiagnosticNote& note : record.notes) text += " | " + note.message;
            out.push_back(std::move(text));
        }
        return out;
    }
    std::string_view text(Span span) const { return sources.text(span); }
};

using Complaints = std::vector<std::string>;

const std::string kMaterial = R"({"patina":1,"workflow":"unlit",)";  // the start of a material

// One value, as if it stood at a port.
struct Value {
    SourceMap sources;
    Diagnostics diagnostics;
    nodelang::Ast ast;
    std::unique_ptr<Json> json;
    const Expr* expr = nullptr;

    explicit Value(const std::string& text) {
        const std::uint32_t base = sources.add("v", "[" + text + "]");
        json = parse_json(sources, base, diagnostics);
        if (json) expr = read_value(json->elements.at(0), sources, ast, diagnostics);
    }
    // Column (of the value's own first character: 1) and message, and the first note.
    std::string complaint() const {
        if (diagnostics.records().empty()) return "none";
        const DiagnosticRecord& record = diagnostics.records().front();
        std::string text = fmt::format("{} {}", sources.resolve(record.span.begin).column - 1, record.message);
        if (!record.notes.empty()) text += " | " + record.notes[0].message;
        return text;
    }
};

// --- colours

TEST(Color, FollowsThePiecewiseCurve) {
    // IEC 61966-2-1, at its ends, in its linear part (10/255 < 0.04045) and at the middle grey of 8 bits.
    EXPECT_DOUBLE_EQ(srgb_to_linear(0), 0);
    EXPECT_DOUBLE_EQ(srgb_to_linear(1), 1);
    EXPECT_DOUBLE_EQ(srgb_to_linear(10 / 255.0), 0.0030352698354883748);
    EXPECT_NEAR(srgb_to_linear(128 / 255.0), 0.2158605001138993, 1e-15);
}

TEST(Color, ReadsEveryForm) {
    const std::array<double, 4> orange = {1, srgb_to_linear(0x88 / 255.0), 0, 1};
    EXPECT_EQ(parse_color("#f80")->value, orange);
    EXPECT_EQ(parse_color("#FF8800")->value, orange);
    EXPECT_FALSE(parse_color("#ff8800")->has_alpha);
    EXPECT_TRUE(parse_color("#ff880033")->has_alpha);
    EXPECT_DOUBLE_EQ(parse_color("#ff880033")->value[3], 0.2);  // linear, not decoded
    for (const char* bad : {"", "#", "#ff", "#ff88", "#ff880", "#ff88000", "#gg0000", "ff8800", "#ff 800"}) {
        EXPECT_FALSE(parse_color(bad)) << bad;
    }
}

// --- the value grammar

TEST(Value, Literals) {
    const Value whole("3"), real("3.0"), large("3000000000"), negative("-0.5"), yes("true");
    EXPECT_EQ(whole.expr->number_kind, nodelang::NumberKind::Int);
    EXPECT_EQ(real.expr->number_kind, nodelang::NumberKind::Float);
    EXPECT_EQ(large.expr->number_kind, nodelang::NumberKind::Float);
    EXPECT_EQ(large.expr->number, 3e9);
    EXPECT_EQ(negative.expr->number, -0.5);
    EXPECT_EQ(yes.expr->kind, Expr::Kind::Bool);
    EXPECT_EQ(yes.expr->number, 1);

    const Value list("[1, 0.5, -2]");
    ASSERT_EQ(list.expr->kind, Expr::Kind::List);
    ASSERT_EQ(list.expr->args.size(), 3u);
    EXPECT_EQ(list.expr->args[2]->number, -2);
    EXPECT_EQ(list.sources.text(list.expr->args[1]->span), "0.5");
}

TEST(Value, ColorsAreLinear) {
    const Value color("\"#ff000080\"");
    ASSERT_EQ(color.expr->kind, Expr::Kind::Color);
    ASSERT_EQ(color.expr->args.size(), 4u);
    EXPECT_EQ(color.expr->args[0]->number, 1);
    EXPECT_DOUBLE_EQ(color.expr->args[3]->number, 128 / 255.0);
    EXPECT_EQ(Value("\"#f00\"").expr->args.size(), 3u);
}

TEST(Value, LinksFilesAndExpressions) {
    const Value link("\"rust.amount.xy\"");
    ASSERT_EQ(link.expr->kind, Expr::Kind::Member);
    EXPECT_EQ(link.expr->text, "xy");
    EXPECT_EQ(link.sources.text(link.expr->args[0]->name_span), "amount");
    EXPECT_EQ(Value("\"$_Tint\"").expr->kind, Expr::Kind::Property);
    EXPECT_EQ(Value("\"@uv0\"").expr->kind, Expr::Kind::Semantic);
    for (const char* file : {"./a b.png", "../a.png", "/a.png"}) {
        const Value value(fmt::format("\"{}\"", file));
        ASSERT_EQ(value.expr->kind, Expr::Kind::File);
        EXPECT_EQ(value.expr->text, file);
    }
    const Value sum("\"= a + 2\"");
    ASSERT_EQ(sum.expr->kind, Expr::Kind::Binary);
    EXPECT_EQ(sum.sources.text(sum.expr->args[1]->span), "2");
}

TEST(Value, ExpressionsPointThroughEscapes) {
    const Value value(R"("=\u0061\t* $_\u0042")");  // = a <tab> * $_B
    ASSERT_TRUE(value.expr) << value.complaint();
    ASSERT_EQ(value.expr->kind, Expr::Kind::Binary);
    EXPECT_EQ(value.expr->args[0]->text, "a");
    EXPECT_EQ(value.sources.text(value.expr->args[0]->span), "\\u0061");
    EXPECT_EQ(value.expr->args[1]->text, "_B");
    EXPECT_EQ(value.sources.text(value.expr->args[1]->span), "$_\\u0042");
}

TEST(Value, SaysWhatItCannotRead) {
    EXPECT_EQ(Value("\"a + b\"").complaint(),
              "3 ' ' is not allowed here | a link is node.port.swizzle; an expression starts with '='");
    EXPECT_EQ(Value("\"tex/rust.png\"").complaint(),
              "5 '/' is not allowed here | a file name starts with './', an expression with '='");
    EXPECT_EQ(Value("\"\xC3\xA9\"").complaint(),
              "2 '\xC3\xA9' is not allowed here | a link is node.port.swizzle; an expression starts with '='");
    EXPECT_EQ(Value("\"0.5\"").complaint(),
              "2 expected a link, not '0.5' | write a number without quotes; start an expression with '='");
    EXPECT_EQ(Value("\"\"").complaint(), "1 expected a value, not an empty string");
    EXPECT_EQ(Value("\"#ff\"").complaint(), "2 '#ff' is not a colour: write #rgb, #rrggbb or #rrggbbaa");
    EXPECT_EQ(Value("[1]").complaint(), "1 a vector must be an array of 2 to 4 numbers, not an array of 1");
    EXPECT_EQ(Value("[1, \"a\"]").complaint(), "5 a component of a vector must be a number, not a string");
    EXPECT_EQ(Value("1e39").complaint(), "1 the number 1e39 does not fit in a 32-bit float");
    EXPECT_EQ(Value("null").complaint(), "1 a value must be a number, true or false, an array or a string, not null");
    for (const char* bad : {"\"a..b\"", "\"a.\"", "\"$\"", "\"@\"", "\"=\"", "\"= a +\"", "\"= (a\""}) {
        const Value value(bad);
        EXPECT_EQ(value.expr, nullptr) << bad;
        EXPECT_TRUE(value.diagnostics.has_errors()) << bad;
    }
}

// --- materials

TEST(ReadGraph, Material) {
    const Read r(R"({
      "$schema": "s.json", "patina": 1, "kind": "material", "name": "Rusty", "workflow": "unlit", "precision": "half",
      "lighting": { "use": "./toon.lighting.json", "in": { "_Bands": 4 } },
      "properties": [ { "name": "_A", "type": "float" } ],
      "nodes": [
        { "id": "a", "node": "SampleTexture2D", "in": { "texture": "$_T" }, "note": "hm" },
        { "id": "b", "expr": "a.r * 2", "stage": "vertex", "precision": "half" }
      ],
      "vertex": { "positionOS": "@positionOS" },
      "surface": { "color": "a", "alpha": 1 },
      "render": { "surface": "cutout", "cull": "off", "depthWrite": false, "depthTest": "lessEqual", "queue": 2450,
        "materialOverride": true },
      "meta": { "k": [1.0, /* c */ "\u0041",], }, "ui": { "a": null }
    })");
    ASSERT_FALSE(r.diagnostics.has_errors()) << r.complaints()[0];
    const Graph& g = *r.graph;
    EXPECT_EQ(g.kind, GraphKind::Material);
    EXPECT_EQ(g.name, "Rusty");
    EXPECT_EQ(g.workflow, "unlit");
    EXPECT_EQ(g.precision, Precision::Half);
    EXPECT_TRUE(g.lighting.present);
    EXPECT_EQ(g.lighting.use, "./toon.lighting.json");
    ASSERT_EQ(g.lighting.inputs.size(), 1u);
    ASSERT_EQ(g.nodes.size(), 2u);
    EXPECT_EQ(g.nodes[0].type, "SampleTexture2D");
    EXPECT_EQ(g.nodes[0].note, "hm");
    EXPECT_EQ(r.text(g.nodes[0].id_span), "a");
    EXPECT_EQ(r.text(g.nodes[0].inputs.at(0).name_span), "texture");
    EXPECT_EQ(r.text(g.nodes[0].inputs.at(0).value_span), "\"$_T\"");
    EXPECT_TRUE(g.nodes[1].is_expression);
    EXPECT_EQ(g.nodes[1].stage, NodeStage::Vertex);
    EXPECT_EQ(g.nodes[1].precision, Precision::Half);
    EXPECT_EQ(r.text(g.nodes[1].expr->span), "a.r * 2");
    EXPECT_EQ(g.vertex.at(0).name, "positionOS");
    EXPECT_EQ(g.surface.size(), 2u);
    EXPECT_EQ(g.render.surface, SurfaceKind::Cutout);
    EXPECT_EQ(g.render.cull, Cull::Off);
    EXPECT_EQ(g.render.depth_write, false);
    EXPECT_EQ(g.render.depth_test, Compare::LessEqual);
    EXPECT_EQ(g.render.queue, 2450);
    EXPECT_TRUE(g.render.allows_override);
    EXPECT_EQ(g.meta, R"({ "k": [1.0, "A"] })");  // strict JSON again
}

TEST(ReadGraph, NameIsTheStemOfTheFile) {
    const std::string text = R"({"patina":1,"workflow":"unlit"})";
    EXPECT_EQ(Read(text, {}, "a/b.c/rust.graph.json").graph->name, "rust");
    EXPECT_EQ(Read(text, {}, "rust.subgraph.json").graph->name, "rust");
    EXPECT_EQ(Read(text, {}, "rust.v2.json").graph->name, "rust.v2");
}

TEST(ReadGraph, PropertyValues) {
    const Read r(R"({"patina":1,"workflow":"unlit","properties":[
      {"name":"f","type":"float","default":0.25,"range":[0,1],"hard":true,"label":"L","group":"G","help":"H"},
      {"name":"v","type":"float3","default":[1,2,3]}, {"name":"s","type":"float2","default":0.5},
      {"name":"c","type":"color","default":"#ff8800"}, {"name":"l","type":"color","default":[2,1,0,0.5]},
      {"name":"i","type":"int","default":-7}, {"name":"b","type":"bool","default":true},
      {"name":"e","type":"enum","values":["Dry","Wet"],"default":"Wet"},
      {"name":"t","type":"texture2d","usage":"data","default":"./x.png","tiling":true,
       "sampler":{"wrap":"mirror","filter":"nearest","anisotropy":16}},
      {"name":"u","type":"float","as":"uniform"}]})");
    ASSERT_FALSE(r.diagnostics.has_errors()) << r.complaints()[0];
    const std::vector<Property>& p = r.graph->properties;
    EXPECT_EQ(p[0].value[0], 0.25);
    EXPECT_EQ(*p[0].range, (std::array<double, 2>{0, 1}));
    EXPECT_TRUE(p[0].hard);
    EXPECT_EQ(p[0].label + p[0].group + p[0].help, "LGH");
    EXPECT_EQ(p[1].value, (std::array<double, 4>{1, 2, 3, 0}));
    EXPECT_EQ(p[2].value, (std::array<double, 4>{0.5, 0.5, 0, 0}));
    EXPECT_EQ(p[3].value, parse_color("#ff8800")->value);
    EXPECT_EQ(p[4].value, (std::array<double, 4>{2, 1, 0, 0.5}));
    EXPECT_EQ(p[5].value[0], -7);
    EXPECT_EQ(p[6].value[0], 1);
    EXPECT_EQ(p[7].value[0], 1);
    EXPECT_EQ(p[7].values, (std::vector<std::string>{"Dry", "Wet"}));
    EXPECT_EQ(p[8].texture, "./x.png");
    EXPECT_EQ(p[8].usage, TextureUsage::Data);
    EXPECT_TRUE(p[8].tiling);
    EXPECT_EQ(p[8].sampler.wrap, Wrap::Mirror);
    EXPECT_EQ(p[8].sampler.filter, Filter::Nearest);
    EXPECT_EQ(p[8].sampler.anisotropy, 16);
    EXPECT_EQ(to_string(p[8].type), "texture2d");
}

TEST(ReadGraph, PropertiesWithoutADefault) {
    const Read r(R"({"patina":1,"workflow":"unlit","properties":[
      {"name":"a","type":"float"}, {"name":"b","type":"float2","range":[0.5,2]},
      {"name":"c","type":"int","range":[-9,-3]},
      {"name":"d","type":"color"}, {"name":"e","type":"texture2d"},
      {"name":"f","type":"texture2d","usage":"normal"}, {"name":"g","type":"color","range":[2,8]}]})");
    ASSERT_TRUE(r.diagnostics.records().empty()) << r.complaints()[0];
    const std::vector<Property>& p = r.graph->properties;
    EXPECT_EQ(p[0].value[0], 0);
    EXPECT_EQ(p[1].value, (std::array<double, 4>{0.5, 0.5, 0, 0}));
    EXPECT_EQ(p[2].value[0], -3);
    EXPECT_EQ(p[3].value, (std::array<double, 4>{1, 1, 1, 1}));
    EXPECT_EQ(p[4].texture, "white");
    EXPECT_EQ(p[5].texture, "bump");
    EXPECT_EQ(p[6].value, (std::array<double, 4>{2, 2, 2, 1}));
}

// --- the other kinds

TEST(ReadGraph, Subgraph) {
    const Read r(
        R"({"patina":1,"kind":"subgraph","help":"H","inputs":[{"name":"h","type":"float","default":"@time",
                     "range":[0,1],
                     "hard":true,"help":"x"},{"name":"m","type":"texture2d"}],"outputs":{"amount":"$h"}})",
        GraphKind::Subgraph);
    ASSERT_FALSE(r.diagnostics.has_errors()) << r.complaints()[0];
    EXPECT_EQ(r.graph->kind, GraphKind::Subgraph);
    EXPECT_EQ(r.graph->help, "H");
    ASSERT_EQ(r.graph->inputs.size(), 2u);
    EXPECT_EQ(r.graph->inputs[0].value->kind, Expr::Kind::Semantic);
    EXPECT_TRUE(r.graph->inputs[0].hard);
    EXPECT_EQ(r.graph->inputs[1].value, nullptr);
    EXPECT_EQ(r.graph->outputs.at(0).name, "amount");
}

TEST(ReadGraph, LightingHasItsOutputsInOrder) {
    const Read r(
        R"({"patina":1,"kind":"lighting","final":"@sum.direct","direct":0,
                     "surface":[{"name":"rim","type":"float","default":0}],
                     "properties":[{"name":"rim","type":"float"}]})");
    ASSERT_FALSE(r.diagnostics.has_errors()) << r.complaints()[0];
    ASSERT_EQ(r.graph->outputs.size(), 2u);
    EXPECT_EQ(r.graph->outputs[0].name, "direct");
    EXPECT_EQ(r.graph->outputs[1].name, "final");
    EXPECT_EQ(r.graph->inputs.at(0).name, "rim");
}

TEST(ReadGraph, LightingMayStandInAMaterial) {
    const Read r(R"({"patina":1,"workflow":"unlit","lighting":{"nodes":[{"id":"n","expr":"1"}],"direct":"n"}})");
    ASSERT_FALSE(r.diagnostics.has_errors()) << r.complaints()[0];
    ASSERT_TRUE(r.graph->lighting.inlined);
    EXPECT_EQ(r.graph->lighting.inlined->kind, GraphKind::Lighting);
    EXPECT_EQ(r.graph->lighting.inlined->outputs.size(), 1u);
}

TEST(ReadGraph, Workflow) {
    const Read r(R"-({"patina":1,"kind":"workflow","name":"w","lighting":"lambert","preview":"color",
        "inputs":[{"name":"color","type":"color","default":[1,1,1]},
                  {"name":"tint","type":"color","default":"#fff","gives":"color","as":"= f($tint)"}],
        "surface":{"emission":"$color"}})-");
    ASSERT_FALSE(r.diagnostics.has_errors()) << r.complaints()[0];
    EXPECT_EQ(r.graph->preview_input, "color");
    EXPECT_EQ(r.graph->lighting.use, "lambert");
    EXPECT_EQ(r.graph->inputs[1].gives, "color");
    ASSERT_TRUE(r.graph->inputs[1].as);
    EXPECT_EQ(r.text(r.graph->inputs[1].as->span), "f($tint)");
    EXPECT_EQ(r.graph->surface.at(0).name, "emission");
}

// --- complaints

// The only complaint about a text, if it stands where the text has a '^' (which is taken out first); else what came.
std::string complaint(std::string text, std::optional<GraphKind> expected = {}) {
    const std::size_t caret = text.find('^');
    text.erase(caret, 1);
    const Complaints all = Read(text, expected).complaints();
    const std::string place = fmt::format("{} ", caret + 1);
    return all.size() == 1 && all[0].starts_with(place) ? all[0].substr(place.size())
                                                        : fmt::format("{}", fmt::join(all, "\n"));
}

struct Case {
    std::string rest;  // behind kMaterial
    std::string complaint;
};

void check(const std::vector<Case>& cases) {
    for (const Case& c : cases) EXPECT_EQ(complaint(kMaterial + c.rest + "}"), c.complaint) << c.rest;
}

TEST(ReadGraphErrors, Keys) {
    check({
        {R"("^node":[])", "unknown key 'node' in a material | did you mean 'nodes'?"},
        {R"("^outputs":{})", "unknown key 'outputs' in a material | 'outputs' belongs to a sub-graph"},
        {R"("surface":^[])", "'surface' must be an object, not an empty array"},
        {R"("name":^3)", "'name' must be a string, not 3"},
        {R"("precision":"^hallf")", "'hallf' is not a precision | did you mean 'half'?"},
        {R"("nodes":[{"id":"a","node":"X","^inn":{}}])", "unknown key 'inn' in a node | did you mean 'in'?"},
        {R"("lighting":{"use":"a","^nodes":[]})",
         "unknown key 'nodes' in a use of a lighting model | these exist: use and in"},
        {R"("lighting":^{"nodes":[]})", "a lighting graph needs the key 'direct'"},
        {R"("lighting":^5)", "'lighting' must be a name, a file or a lighting graph, not 5"},
    });
}

TEST(ReadGraphErrors, Nodes) {
    check({
        {R"("nodes":[^{"node":"X"}])", "a node needs the key 'id'"},
        {R"("nodes":[^{"id":"a"}])", "the node 'a' needs the key 'node' | or the key 'expr', with an expression"},
        {R"("nodes":[{"id":"a","node":"X","^expr":"1"}])", "'node' and 'expr' exclude each other: remove one"},
        {R"("nodes":[{"id":"a","expr":"^= 1"}])",
         "'=' is not allowed here | 'expr' is an expression already: leave out the '='"},
        {R"("nodes":[{"id":"a","expr":"1","^in":{}}])",
         "unknown key 'in' in an expression | an expression reads other nodes by their ids"},
        {R"("nodes":[{"id":"^2x","node":"X"}])",
         "'2x' is not an identifier: use letters, digits and _, and no digit first"},
        {R"("nodes":[{"id":"a","node":"X"},{"id":"^a","node":"X"}])",
         "a second node is called 'a' | the first one is here"},
        {R"("nodes":[{"id":"a","node":"X","stage":"^vertx"}])", "'vertx' is not a stage | did you mean 'vertex'?"},
        {R"("nodes":[^4])", "a node must be an object, not 4"},
    });
}

TEST(ReadGraphErrors, NameTheNodeAndThePort) {
    const Read r(kMaterial + R"("nodes":[{"id":"a","node":"X","in":{"uv":null}}],"surface":{"color":{}}})");
    ASSERT_EQ(r.diagnostics.records().size(), 2u);
    EXPECT_EQ(r.diagnostics.records()[0].node, "a");
    EXPECT_EQ(r.diagnostics.records()[0].port, "uv");
    EXPECT_EQ(r.diagnostics.records()[1].node, "");
    EXPECT_EQ(r.diagnostics.records()[1].port, "color");
}

TEST(ReadGraphErrors, Properties) {
    const auto property = [](const std::string& rest) { return R"("properties":[{"name":"a","type":)" + rest + "}]"; };
    check({
        {R"("properties":[^{"type":"float"}])", "a property needs the key 'name'"},
        {R"("properties":[^{"name":"a"}])", "a property needs the key 'type'"},
        {property(R"("^flot")"), "'flot' is not a property type | did you mean 'float'?"},
        {property(R"("float","^usage":"data")"),
         "unknown key 'usage' in a property of type float | 'usage' belongs to a texture"},
        {property(R"("bool","^range":[0,1])"),
         "unknown key 'range' in a property of type bool | 'range' belongs to float, float2, float3, float4, color and "
         "int"},
        {property(R"("color","default":^[9,0,0,2],"range":[0,8])"), "9 is outside the usual range 0 to 8 of 'a'"},
        {property(R"("float","default":^"x")"), "the default of a float must be a number, not a string"},
        {property(R"("float3","default":^[1,2])"),
         "the default of a float3 must be an array of 3 numbers, not an array of 2"},
        {property(R"("color","default":"^#12")"), "'#12' is not a colour: write #rgb, #rrggbb or #rrggbbaa"},
        {property(R"("int","default":^1.5)"), "the default of an int must be a whole number, not 1.5"},
        {property(R"("int","default":^3e9)"), "the number 3e9 does not fit in a 32-bit int"},
        {property(R"("float","default":^-1e39)"), "the number -1e39 does not fit in a 32-bit float"},
        {property(R"("float","default":^2,"range":[0,1])"), "2 is outside the usual range 0 to 1 of 'a'"},
        {property(R"("float2","default":^[0,2],"range":[0,1],"hard":true)"), "2 is outside the range 0 to 1 of 'a'"},
        {property(R"("float","range":^[1,0])"), "'range' must be two numbers, the lower one first, not [1, 0]"},
        {property(R"("float","range":^[1])"), "'range' must be an array of two numbers, not an array of 1"},
        {property(R"("float","^hard":true)"), "'hard' needs the key 'range'"},
        {R"("properties":[^{"name":"a","type":"enum"}])",
         R"(an enum needs the key 'values' | "values": ["Dry", "Wet"])"},
        {property(R"("enum","values":["A","B"],"default":"^C")"), "'C' is not a value of 'a' | these exist: A and B"},
        {property(R"("enum","values":["A","^A"])"), "a second value is called 'A' | the first one is here"},
        {property(R"("texture2d","^grid":[2,2])"),
         "unknown key 'grid' in a property of type texture2d | 'grid' belongs to a texture2dArray and a texture3d"},
        {property(R"("texture3d","^tiling":true)"),
         "unknown key 'tiling' in a property of type texture3d | 'tiling' belongs to a texture2d"},
        {property(R"("texture2dArray","grid":^[2])"),
         "'grid' must be [columns, rows] of its layers in the picture, such as [4, 2], not an array of 1"},
        {property(R"("texture2dArray","grid":[2,^0])"), "0 is outside the range 1 to 256 of 'grid'"},
        {property(R"("textureCube","usage":^"normal")"),
         "'usage' must be color or data: a textureCube holds no normal map"},
        {property(R"("texture2d","default":"^whit")"), "'whit' is not a default texture | did you mean 'white'?"},
        {property(R"("texture2d","default":"^rust.png")"),
         "'rust.png' is not a default texture | a file name starts with './'"},
        {property(R"("texture2d","sampler":{"wrap":"^tile"})"),
         "'tile' is not a wrap mode | these exist: repeat, clamp and mirror"},
        {property(R"("texture2d","sampler":{"anisotropy":^17})"), "17 is outside the range 1 to 16 of 'anisotropy'"},
        {R"("properties":[{"name":"a","type":"int"},{"name":"^a","type":"int"}])",
         "a second property is called 'a' | the first one is here"},
    });
}

TEST(ReadGraphErrors, Files) {
    EXPECT_EQ(complaint("^[]"), "a graph must be an object, not an empty array");
    EXPECT_EQ(complaint(R"(^{"workflow":"unlit"})"),
              "a graph needs the key 'patina' | add \"patina\": 1, the version of the graph format");
    EXPECT_EQ(complaint(R"({"patina":^2,"foo":1})"),
              "this is version 2 of the graph format; this compiler reads version 1");
    EXPECT_EQ(complaint(R"({"patina":^"1","workflow":"unlit"})"), "'patina' must be the number 1, not a string");
    EXPECT_EQ(complaint(R"(^{"patina":1})"), "a material needs the key 'workflow'");
    EXPECT_EQ(complaint(R"({"patina":1,"kind":"^subgraf"})"),
              "'subgraf' is not a kind of graph | did you mean 'subgraph'?");
    EXPECT_EQ(complaint(R"(^{"patina":1,"outputs":{}})", GraphKind::Subgraph),
              "this file must be a sub-graph, not a material | \"kind\": \"subgraph\" is missing");
    EXPECT_EQ(complaint(R"({"patina":1,"kind":^"lighting","direct":0})", GraphKind::Material),
              "this file must be a material, not a lighting graph");
}

TEST(ReadGraphErrors, Inputs) {
    const auto subgraph = [](const std::string& input) {
        return complaint(R"({"patina":1,"kind":"subgraph","outputs":{},"inputs":[)" + input + "]}");
    };
    EXPECT_EQ(subgraph(R"(^{"name":"a"})"), "an input needs the key 'type'");
    EXPECT_EQ(
        subgraph(R"({"name":"a","type":"^enum"})"),
        "'enum' is not the type of an input | these exist: float, float2, float3, float4, color, color3, int, bool, "
        "float2x2, float3x3, float4x4, gradient, curve, texture2d, textureCube, texture2dArray, texture3d "
        "and sampler");
    EXPECT_EQ(subgraph(R"({"name":"a","type":"float","default":^2,"range":[0,1]})"),
              "2 is outside the usual range 0 to 1 of 'a'");
    EXPECT_EQ(subgraph(R"({"name":"a","type":"float3","default":[0,^5,0],"range":[0,1],"hard":true})"),
              "5 is outside the range 0 to 1 of 'a'");
    EXPECT_EQ(subgraph(R"({"name":"a","type":"int"},{"name":"^a","type":"int"})"),
              "a second input is called 'a' | the first one is here");
    EXPECT_EQ(subgraph(R"({"name":"a","type":"int","^gives":"b"})"),
              "unknown key 'gives' in an input | 'gives' belongs to the inputs of a workflow");
    EXPECT_EQ(complaint(R"({"patina":1,"kind":"subgraph","outputs":{"^a b":1}})"),
              "'a b' is not an identifier: use letters, digits and _, and no digit first");

    const auto workflow = [](const std::string& rest) {
        return complaint(R"({"patina":1,"kind":"workflow","surface":{},"inputs":[{"name":"color","type":"color")" +
                         rest);
    };
    EXPECT_EQ(workflow(R"(}],"preview":"^colour"})"),
              "'colour' is not an input of this workflow | did you mean 'color'?");
    EXPECT_EQ(workflow(R"(,"^gives":"x"}]})"), "'gives' needs the key 'as'");
    EXPECT_EQ(workflow(R"-(,"gives":"color","as":"^f($color)"}]})-"),
              "expected an expression that starts with '=', not 'f($color)'");
}

TEST(ReadGraphErrors, AllInOneRun) {
    const Read r(kMaterial +
                 R"("nodez":1,"precision":"x","nodes":[{"id":"a","node":"X","in":{"u":"","v":"a b"}}],"passes":[1]})");
    EXPECT_EQ(r.complaints().size(), 5u);
    EXPECT_EQ(r.graph->nodes.at(0).inputs.size(), 2u);  // what could be read is there
}

TEST(ReadGraphErrors, LongWordsAreCutInMessages) {
    const Read r(kMaterial + "\"" + std::string(100'000, 'k') + "\":1}");
    ASSERT_EQ(r.complaints().size(), 1u);
    EXPECT_LT(r.diagnostics.records()[0].message.size(), 200u);
}

TEST(ReadGraphErrors, AMillionUnknownKeysEnd) {
    std::string text = "{\"patina\":1,\"workflow\":\"unlit\"";
    for (int i = 0; i < 200'000; ++i) text += fmt::format(",\"key{}\":1", i);
    EXPECT_TRUE(Read(text + "}").diagnostics.has_errors());
}

// --- the tables

TEST(Keys, AreNamedOnceAndExplained) {
    using enum ObjectKind;
    for (const ObjectKind kind :
         {Material, Subgraph, Lighting, Workflow, Property, Node, Input, Sampler, Render, LightingUse}) {
        const std::span<const KeyInfo> keys = keys_of(kind);
        EXPECT_FALSE(keys.empty());
        for (const KeyInfo& key : keys) {
            EXPECT_EQ(find_key(kind, key.name), &key) << key.name;
            EXPECT_FALSE(key.help.empty()) << key.name;
        }
    }
    EXPECT_TRUE(keys_of(Free).empty());
}

}  // namespace
}  // namespace patina::format
