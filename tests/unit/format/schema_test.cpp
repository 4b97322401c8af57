// The JSON Schema: it accepts the graphs that the documentation shows, refuses what the reader refuses, and names every
// key, node and port. Checked by a validator of the few keywords that the schema uses.
#include "compiler/format/schema/schema.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "compiler/format/keys.h"
#include "compiler/json/json_text.h"

namespace patina::format {

using namespace json;
namespace {

// --- a validator

struct Tree {
    SourceMap sources;
    Diagnostics diagnostics;
    std::unique_ptr<Json> root;

    explicit Tree(std::string text) {
        root = parse_json(sources, sources.add("t", std::move(text)), diagnostics);
        if (!root) ADD_FAILURE() << diagnostics.records().front().message;
    }
    std::string text(const Json& json) const {
        std::string out;
        append_one_line(out, json, sources);
        return out;
    }
};

class Validator {
public:
    explicit Validator(const Tree& schema) : schema_(schema) {}
    bool accepts(const Tree& tree) const { return valid(*schema_.root, *tree.root, tree); }

private:
    // JSON Schema's words, JSON type by JSON type. A keyword that is not known here fails the test.
    bool valid(const Json& schema, const Json& value, const Tree& tree) const {
        if (schema.kind == Json::Kind::Bool) return schema.boolean;
        return std::all_of(schema.members.begin(), schema.members.end(), [&](const JsonMember& keyword) {
            return holds(keyword.key, keyword.value, schema, value, tree);
        });
    }

    bool holds(std::string_view keyword, const Json& rule, const Json& schema, const Json& value,
               const Tree& tree) const {
        const auto is_valid = [&](const Json& other) { return valid(other, value, tree); };
        if (keyword == "$ref") return valid(*definition(rule.string), value, tree);
        if (keyword == "type") return has_type(rule.string, value);
        if (keyword == "const") return schema_.text(rule) == tree.text(value);
        if (keyword == "enum") {
            return std::any_of(rule.elements.begin(), rule.elements.end(),
                               [&](const Json& word) { return schema_.text(word) == tree.text(value); });
        }
        if (keyword == "allOf") return std::all_of(rule.elements.begin(), rule.elements.end(), is_valid);
        if (keyword == "anyOf") return std::any_of(rule.elements.begin(), rule.elements.end(), is_valid);
        if (keyword == "oneOf") return std::count_if(rule.elements.begin(), rule.elements.end(), is_valid) == 1;
        if (keyword == "not") return !is_valid(rule);
        if (keyword == "if") {
            const Json* branch = schema.find(is_valid(rule) ? "then" : "else");
            return !branch || is_valid(*branch);
        }
        if (keyword == "pattern") {
            return value.kind != Json::Kind::String || std::regex_search(value.string, std::regex(rule.string));
        }
        if (keyword == "minimum") return value.kind != Json::Kind::Number || value.number >= rule.number;
        if (keyword == "maximum") return value.kind != Json::Kind::Number || value.number <= rule.number;
        if (value.kind == Json::Kind::Array) return array_holds(keyword, rule, value, tree);
        if (value.kind == Json::Kind::Object) return object_holds(keyword, rule, schema, value, tree);
        return true;
    }

    bool array_holds(std::string_view keyword, const Json& rule, const Json& value, const Tree& tree) const {
        if (keyword == "minItems") return static_cast<double>(value.elements.size()) >= rule.number;
        if (keyword == "maxItems") return static_cast<double>(value.elements.size()) <= rule.number;
        if (keyword == "prefixItems") {
            const std::size_t both = std::min(rule.elements.size(), value.elements.size());
            return std::equal(rule.elements.begin(), rule.elements.begin() + std::ptrdiff_t(both),
                              value.elements.begin(),
                              [&](const Json& one, const Json& element) { return valid(one, element, tree); });
        }
        if (keyword == "items") {
            return std::all_of(value.elements.begin(), value.elements.end(),
                               [&](const Json& element) { return valid(rule, element, tree); });
        }
        if (keyword == "uniqueItems") {
            std::vector<std::string> texts;
            for (const Json& element : value.elements) texts.push_back(tree.text(element));
            std::sort(texts.begin(), texts.end());
            return std::adjacent_find(texts.begin(), texts.end()) == texts.end();
        }
        return known(keyword);
    }

    bool object_holds(std::string_view keyword, const Json& rule, const Json& schema, const Json& value,
                      const Tree& tree) const {
        const auto each_member = [&](auto check) {
            return std::all_of(value.members.begin(), value.members.end(), check);
        };
        const Json* properties = schema.find("properties");
        if (keyword == "required") {
            return std::all_of(rule.elements.begin(), rule.elements.end(),
                               [&](const Json& name) { return value.find(name.string); });
        }
        if (keyword == "properties") {
            return each_member([&](const JsonMember& member) {
                const Json* of_member = rule.find(member.key);
                return !of_member || valid(*of_member, member.value, tree);
            });
        }
        if (keyword == "additionalProperties") {
            return each_member([&](const JsonMember& member) {
                return (properties && properties->find(member.key)) || valid(rule, member.value, tree);
            });
        }
        if (keyword == "propertyNames") {
            return each_member([&](const JsonMember& member) {
                std::string name;
                append_quoted(name, member.key);
                const Tree name_tree(name);
                return valid(rule, *name_tree.root, name_tree);
            });
        }
        return known(keyword);
    }

    static bool known(std::string_view keyword) {
        static constexpr std::string_view kOthers[] = {
            "$schema",     "$defs",    "title",      "description",          "then",
            "else",        "minItems", "items",      "prefixItems",          "maxItems",
            "uniqueItems", "required", "properties", "additionalProperties", "propertyNames"};
        const bool is_known = std::find(std::begin(kOthers), std::end(kOthers), keyword) != std::end(kOthers);
        EXPECT_TRUE(is_known) << "the validator does not know " << keyword;
        return is_known;
    }

    static bool has_type(std::string_view type, const Json& value) {
        if (type == "object") return value.kind == Json::Kind::Object;
        if (type == "array") return value.kind == Json::Kind::Array;
        if (type == "string") return value.kind == Json::Kind::String;
        if (type == "boolean") return value.kind == Json::Kind::Bool;
        if (type == "integer")
            return value.kind == Json::Kind::Number && value.number == static_cast<int>(value.number);
        EXPECT_EQ(type, "number");
        return value.kind == Json::Kind::Number;
    }

    const Json* definition(std::string_view reference) const {
        constexpr std::string_view kPrefix = "#/$defs/";
        const Json* found = schema_.root->find("$defs")->find(reference.substr(kPrefix.size()));
        EXPECT_TRUE(reference.starts_with(kPrefix) && found) << reference;
        static const Json kNothing;
        return found ? found : &kNothing;
    }

    const Tree& schema_;
};

// --- a small library

PortInfo input(std::string name, std::string type, std::string default_value, std::vector<std::string> words = {}) {
    PortInfo port;
    port.name = std::move(name);
    port.type = std::move(type);
    port.default_value = std::move(default_value);
    for (std::string& word : words) port.enumerators.push_back({.name = std::move(word), .doc = {}});
    return port;
}

NodeInfo node(std::string name, std::vector<PortInfo> ports) {
    NodeInfo info;
    info.name = std::move(name);
    info.category = "Test";
    info.doc = "What it does.\n\nAnd how.";
    info.ports = std::move(ports);
    PortInfo output = input("out", "float", "");
    output.is_output = true;
    info.ports.push_back(output);
    return info;
}

ModelInfo model(std::string name, std::string doc, std::vector<ModelInputInfo> inputs = {}) {
    ModelInfo info;
    info.name = std::move(name);
    info.doc = std::move(doc);
    info.inputs = std::move(inputs);
    return info;
}

struct Library {
    std::vector<NodeInfo> nodes = {
        node("SampleTexture2D", {input("texture", "Texture2D", ""), input("uv", "float2", "@uv0")}),
        node("Smoothstep",
             {input("edge0", "floatN", "0"), input("edge1", "floatN", "1"), input("value", "floatN", "0")}),
        node("FractalNoise", {input("uv", "float2", "@uv0"), input("scale", "float", "4")}),
        node("GradientNoise", {input("uv", "float2", "@uv0"), input("scale", "float", "8")}),
        node("NormalBlend", {input("base", "float3", ""), input("mode", "Mode", "Linear", {"Linear", "Reoriented"})}),
        node("NdotL", {}),
        node("NdotV", {}),
    };
    std::vector<SemanticInfo> semantics = {{"uv0", "float2", "texture coordinates", "vertex"},
                                           {"light.direction", "float3", "", "light"}};
    std::vector<ModelInfo> workflows = {model("metallic-roughness", "Metal.", {{"metallic", "float", "0", "0 or 1"}}),
                                        model("metallic-smoothness", ""), model("specular-glossiness", ""),
                                        model("unlit", "")};
    std::vector<ModelInfo> lighting_models = {model("unity-brdf1", ""), model("lambert", "Matt.")};

    std::string schema() const { return make_schema({nodes, semantics, workflows, lighting_models}); }
};

// The examples of docs/graph-format.md: whatever stands between ```jsonc and ```.
std::vector<std::string> documented_graphs() {
    std::ifstream file("docs/graph-format.md");
    std::vector<std::string> graphs;
    bool inside = false;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("```")) {
            inside = line == "```jsonc";
            if (inside) graphs.emplace_back();
        } else if (inside) {
            graphs.back() += line + '\n';
        }
    }
    return graphs;
}

// --- tests

TEST(Schema, AcceptsEveryDocumentedGraph) {
    const Tree schema(Compiler().schema());
    const std::vector<std::string> graphs = documented_graphs();
    ASSERT_GE(graphs.size(), 10u) << "run this in the project's root";
    for (const std::string& graph : graphs) EXPECT_TRUE(Validator(schema).accepts(Tree(graph))) << graph;
}

TEST(Schema, AcceptsWhatTheReaderAccepts) {
    const Tree schema(Library().schema());
    for (
        const char* graph : {
            R"({"patina":1,"workflow":"unlit","lighting":"./own.lighting.json","surface":{"a":0.5,"b":true,"c":[1,2],"d":"#fff","e":"#12345678"}})",
            R"({"patina":1,"workflow":"unlit","lighting":"./own.lighting.json","surface":{"a":"n.out.xy","b":"$_A.rgb","c":"@uv0","d":"@other"}})",
            R"({"patina":1,"workflow":"unlit","lighting":"./own.lighting.json","surface":{"a":"./a b.png","b":"../a.png","c":"/a.png"}})",
            R"({"patina":1,"workflow":"unlit","lighting":"../my.lighting.json","meta":[1],"ui":null})",
            R"({"patina":1,"workflow":"unlit","nodes":[{"id":"n","node":"NormalBlend","in":{"mode":"Reoriented"}}]})",
            R"({"patina":1,"workflow":"unlit","nodes":[{"id":"n","node":"./own.node.hlsl","in":{"any":1}}]})",
            R"({"patina":1,"kind":"workflow","name":"w","inputs":[{"name":"a","type":"color","gives":"b","as":"= $a"}],
                 "surface":{"emission":"$b"}})",
            R"({"patina":1,"kind":"scene","camera":{"position":[0,1,5]},"objects":[]})",
            R"({"patina":1,"kind":"scene","camera":{"position":[0,1,5],"orthographic":2},"ambient":{"sky":"#fff"},
                 "fog":{"mode":"exp","color":0.2},"lights":[{"type":"spot","position":[0,1,0],"direction":[0,-1,0],
                 "range":4,"shadow":{"strength":0.5}},{"type":"directional","direction":[0,1,0],"shadow":true}],
                 "materials":[{"name":"m","graph":"m.graph.json","set":{"_A":[1,2],"_B":"x","_C":true,"_D":0}}],
                 "objects":[{"id":"o","mesh":"sphere","material":"m","scale":[1,2,3]}]})",
            R"({"patina":1,"kind":"scene","camera":{"position":[0,1,5]},"objects":[],"probes":[{"environment":"a.hdr",
                 "box":{"min":[0,0,0],"max":[1,1,1]},"blend":0.5}]})",
        }) {
        EXPECT_TRUE(Validator(schema).accepts(Tree(graph))) << graph;
    }
}

TEST(Schema, RefusesWhatTheReaderRefuses) {
    const Tree schema(Library().schema());
    for (
        const char* graph : {
            R"([])",
            R"({})",
            R"({"patina":1})",
            R"({"patina":2,"workflow":"unlit"})",
            R"({"patina":1,"workflow":"unlitt"})",
            R"({"patina":1,"workflow":"unlit","nodez":[]})",
            R"({"patina":1,"workflow":"unlit","surface":{"colr":1}})",
            R"({"patina":1,"workflow":"metallic-roughness","lighting":"lambert","surface":{"color":1}})",
            R"({"patina":1,"workflow":"unlit","passes":[{}]})",
            R"({"patina":1,"workflow":"unlit","passes":[{"name":"p","nodes":[]}]})",
            R"({"patina":1,"workflow":"unlit","render":{"stencil":{"reference":256}}})",
            R"({"patina":1,"workflow":"unlit","render":{"stencil":{"pass":"incr"}}})",
            R"({"patina":1,"workflow":"unlit","render":{"depthOffset":1}})",
            R"({"patina":1,"workflow":"unlit","render":{"bounds":[1,1]}})",
            R"({"patina":1,"workflow":"unlit","render":{"materialOverride":1}})",
            R"({"patina":1,"workflow":"unlit","kind":"scene"})",
            R"({"patina":1,"workflow":"unlit","lighting":"phong"})",
            R"({"patina":1,"workflow":"unlit","render":{"surface":"glassy"}})",
            R"({"patina":1,"workflow":"unlit","surface":{"a":"b c"}})",
            R"({"patina":1,"workflow":"unlit","surface":{"a":null}})",
            R"({"patina":1,"workflow":"unlit","surface":{"a":[1]}})",
            R"({"patina":1,"workflow":"unlit","surface":{"a":"#ff"}})",
            R"({"patina":1,"workflow":"unlit","properties":[{"name":"a","type":"flot"}]})",
            R"({"patina":1,"workflow":"unlit","properties":[{"name":"1","type":"int"}]})",
            R"({"patina":1,"workflow":"unlit","properties":[{"name":"a","type":"bool","as":"sometimes"}]})",
            R"({"patina":1,"workflow":"unlit","variants":[{"a":1}]})",
            R"({"patina":1,"workflow":"unlit","nodes":[{"node":"NdotL"}]})",
            R"({"patina":1,"workflow":"unlit","nodes":[{"id":"a"}]})",
            R"({"patina":1,"workflow":"unlit","nodes":[{"id":"a","node":"NdotL","expr":"1"}]})",
            R"({"patina":1,"workflow":"unlit","nodes":[{"id":"a","expr":"= 1"}]})",
            R"({"patina":1,"workflow":"unlit","nodes":[{"id":"a","expr":"1","in":{}}]})",
            R"({"patina":1,"workflow":"unlit","nodes":[{"id":"a","node":"Missing"}]})",
            R"({"patina":1,"workflow":"unlit","nodes":[{"id":"a","node":"Smoothstep","in":{"low":1}}]})",
            R"({"patina":1,"workflow":"unlit","nodes":[{"id":"a","node":"Smoothstep","in":{"out":1}}]})",
            R"({"patina":1,"workflow":"unlit","nodes":[{"id":"a","node":"NormalBlend","in":{"mode":"Whiteout"}}]})",
            R"({"patina":1,"kind":"scene","objects":[]})",
            R"({"patina":1,"kind":"scene","camera":{"position":[0,1]},"objects":[]})",
            R"({"patina":1,"kind":"scene","camera":{"position":[0,1,2000000]},"objects":[]})",
            R"({"patina":1,"kind":"scene","camera":{"position":[0,1,5],"near":0},"objects":[]})",
            R"({"patina":1,"kind":"scene","camera":{"position":[0,1,5]},"objects":[],"fog":{"mode":"exp","density":-1}})",
            R"({"patina":1,"kind":"scene","camera":{"position":[0,1,5]},"objects":[{"id":"o","mesh":"cube",
                 "material":"m","scale":0}]})",
            R"({"patina":1,"kind":"scene","camera":{"position":[0,1,5]},"objects":[{"id":"o","mesh":"cube"}]})",
            R"({"patina":1,"kind":"scene","camera":{"position":[0,1,5]},"objects":[],"workflow":"unlit"})",
            R"({"patina":1,"kind":"scene","camera":{"position":[0,1,5]},"objects":[],"ambient":"sky"})",
            R"({"patina":1,"kind":"scene","camera":{"position":[0,1,5]},"objects":[],"lights":[{"type":"sun"}]})",
            R"({"patina":1,"kind":"scene","camera":{"position":[0,1,5]},"objects":[],"fog":{"mode":"exp3"}})",
            R"({"patina":1,"kind":"subgraph"})",
            R"({"patina":1,"kind":"subgraph","outputs":{"a b":1}})",
            R"({"patina":1,"kind":"lighting","indirect":0})",
        }) {
        EXPECT_FALSE(Validator(schema).accepts(Tree(graph))) << graph;
    }
}

TEST(Schema, ExplainsEveryKeyOfEveryObject) {
    using enum ObjectKind;
    const Tree schema(Library().schema());
    const std::pair<const char*, ObjectKind> objects[] = {{"material", Material},
                                                          {"subgraph", Subgraph},
                                                          {"lighting", Lighting},
                                                          {"workflow", Workflow},
                                                          {"property", Property},
                                                          {"node", Node},
                                                          {"input", Input},
                                                          {"sampler", Sampler},
                                                          {"render", Render},
                                                          {"lightingUse", LightingUse},
                                                          {"scene", Scene},
                                                          {"camera", Camera},
                                                          {"ambient", Ambient},
                                                          {"fog", Fog},
                                                          {"light", Light},
                                                          {"shadow", Shadow},
                                                          {"sceneMaterial", SceneMaterial},
                                                          {"sceneObject", SceneObject}};
    for (const auto& [name, kind] : objects) {
        const Json* definition = schema.root->find("$defs")->find(name);
        ASSERT_TRUE(definition) << name;
        const Json* properties = definition->find("properties");
        EXPECT_EQ(properties->members.size(), keys_of(kind).size()) << name;
        for (const KeyInfo& key : keys_of(kind)) {
            const Json* property = properties->find(key.name);
            ASSERT_TRUE(property && property->find("description")) << name << "." << key.name;
            EXPECT_EQ(property->find("description")->string, key.help);
        }
    }
}

TEST(Schema, ExplainsTheLibrary) {
    const Tree schema(Library().schema());
    const Json& definitions = *schema.root->find("$defs");
    const Json* port = definitions.find("ports.Smoothstep")->find("properties")->find("edge0");
    EXPECT_EQ(port->find("description")->string, "floatN, default 0");
    EXPECT_NE(schema.text(definitions).find(R"("const": "@light.direction")"), std::string::npos);
    EXPECT_NE(schema.text(definitions).find(R"("description": "Test: What it does.")"), std::string::npos);
    EXPECT_NE(schema.text(definitions).find("float: 0 or 1 (default 0)"), std::string::npos);
}

TEST(Schema, ManagesWithoutALibrary) {
    const Tree schema(make_schema({}));
    EXPECT_TRUE(Validator(schema).accepts(Tree(R"({"patina":1,"kind":"subgraph","outputs":{"a":"= 1"}})")));
}

}  // namespace
}  // namespace patina::format
