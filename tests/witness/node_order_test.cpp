// Neither the names nor the order of nodes change what is compiled: the hash, the properties and the interpolators.
#include <gtest/gtest.h>
#include <rapidjson/document.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <sstream>

#include "runtime/picture/compare.h"
#include "witness/drawn.h"
#include "witness/random_graph.h"

namespace patina {
namespace {

using runtime::Image;
using namespace witness;

// --- the hash

using Json = rapidjson::Value;

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

// Node ids have other names wherever they are read: not behind a dot, a $ or an @, which mean other things.
std::string renamed(const std::string& text, const std::map<std::string, std::string>& names) {
    std::string made;
    for (std::size_t i = 0; i < text.size();) {
        if (!is_word(text[i])) {
            made += text[i++];
            continue;
        }
        std::size_t end = i;
        while (end < text.size() && is_word(text[end])) ++end;
        const std::string word = text.substr(i, end - i);
        const char before = i > 0 ? text[i - 1] : ' ';
        const auto found = names.find(word);
        const bool is_id = found != names.end() && before != '.' && before != '$' && before != '@';
        made += is_id ? found->second : word;
        i = end;
    }
    return made;
}

void rename_values(Json& json, const std::map<std::string, std::string>& names, rapidjson::Document& document) {
    if (json.IsString()) {
        const std::string text = renamed(json.GetString(), names);
        json.SetString(text.c_str(), static_cast<rapidjson::SizeType>(text.size()), document.GetAllocator());
    } else if (json.IsObject()) {
        for (auto& member : json.GetObject()) rename_values(member.value, names, document);
    } else if (json.IsArray()) {
        for (Json& element : json.GetArray()) rename_values(element, names, document);
    }
}

// The same graph with other node ids, its nodes in another order.
std::string disguised(const std::string& text, unsigned seed) {
    rapidjson::Document document;
    document.Parse<rapidjson::kParseCommentsFlag | rapidjson::kParseTrailingCommasFlag>(text.c_str());
    EXPECT_FALSE(document.HasParseError()) << text;
    if (!document.HasMember("nodes")) return text;
    Json& nodes = document["nodes"];
    std::map<std::string, std::string> names;
    for (Json& node : nodes.GetArray()) {
        const std::string id = node["id"].GetString();
        names[id] = "other" + std::to_string(names.size() * 7 % 101) + "_" + std::to_string(names.size());
    }
    for (Json& node : nodes.GetArray()) {
        for (const char* key : {"id", "expr", "in"}) {
            if (node.HasMember(key)) rename_values(node[key], names, document);
        }
    }
    for (const char* key : {"surface", "vertex", "lighting", "passes"}) {
        if (document.HasMember(key)) rename_values(document[key], names, document);
    }
    std::mt19937 dice(seed);
    for (rapidjson::SizeType i = nodes.Size(); i > 1; --i) nodes[i - 1].Swap(nodes[dice() % i]);
    rapidjson::StringBuffer buffer;
    rapidjson::Writer<rapidjson::StringBuffer> writer(buffer);
    document.Accept(writer);
    return buffer.GetString();
}

std::string hash_of(const std::string& path, const std::string& text, CompileOptions options) {
    options.hashes = true;
    const Result result = compiler().compile_text(path, text, options);
    EXPECT_TRUE(result.ok) << text_of(result.diagnostics) << text;
    return result.ok ? result.reflection.passes[0].hash : "";
}

TEST(CanonicalHash, DoesNotSeeNamesAndOrderOfRandomGraphs) {
    std::set<std::string> hashes;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const witness::RandomGraph graph = witness::random_graph(compiler(), seed);
        const CompileOptions options = options_for(graph.exact.files);
        const std::string hash = hash_of("graph.graph.json", graph.exact.json, options);
        EXPECT_EQ(hash, hash_of("other.graph.json", disguised(graph.exact.json, seed), options))
            << seed << graph.exact.json;
        hashes.insert(hash);
    }
    EXPECT_EQ(hashes.size(), 40u);  // no two are the same
}

TEST(CanonicalHash, DoesNotSeeNamesAndOrderOfExamples) {
    std::set<std::string> hashes;
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator("examples")) {
        const std::string path = entry.path().string();
        if (!path.ends_with(".graph.json")) continue;
        std::stringstream text;
        text << std::ifstream(path).rdbuf();
        const std::string hash = hash_of(path, text.str(), {});
        EXPECT_EQ(hash, hash_of(path, disguised(text.str(), 3), {})) << path;
        hashes.insert(hash);
        ++count;
    }
    EXPECT_GT(count, 30u);
    EXPECT_GT(hashes.size(), count - 5);  // some of the sources' shaders are one
}

std::string unlit(const std::string& color, const std::string& nodes = "") {
    return R"json({ "patina": 1, "workflow": "unlit",
      "properties": [ { "name": "_P", "type": "float" }, { "name": "_Q", "type": "float" } ],
      "nodes": [)json" +
           nodes + R"json(], "surface": { "color": ")json" + color + "\" } }";
}

TEST(CanonicalHash, SeesWhatIsComputed) {
    const std::string texts[] = {
        unlit("= float3($_P, $_Q, 0.5)"),
        unlit("= float3($_Q, $_P, 0.5)"),
        unlit("= float3($_P, $_Q, 0.25)"),
        unlit("= float3($_P - $_Q)"),
        unlit("= float3($_Q - $_P)"),
        unlit("= float3(@uv0, 0)"),
        unlit("= float3(@uv0.yx, 0)"),
        unlit("= float3(wave)", R"json({ "id": "wave", "expr": "sin(@positionOS.x)" })json"),
        unlit("= float3(wave)", R"json({ "id": "wave", "expr": "sin(@positionOS.x)", "stage": "vertex" })json"),
        unlit("= float3(wave)", R"json({ "id": "wave", "expr": "sin(@positionOS.y)", "stage": "vertex" })json")};
    std::set<std::string> hashes;
    for (const std::string& text : texts) hashes.insert(hash_of("a.graph.json", text, {}));
    EXPECT_EQ(hashes.size(), std::size(texts));
    EXPECT_EQ(hash_of("a.graph.json", unlit("= float3($_P + $_Q)"), {}),
              hash_of("b.graph.json", unlit("= float3($_Q + $_P)"), {}));
    EXPECT_EQ(
        hash_of("a.graph.json",
                unlit("= float3(wave)", R"json({ "id": "wave", "expr": "sin(@positionOS.x)", "stage": "vertex" })json"),
                {}),
        hash_of(
            "b.graph.json",
            unlit("= float3(swell)", R"json({ "id": "swell", "expr": "sin(@positionOS.x)", "stage": "vertex" })json"),
            {}));
}

// --- what nodes bring and hand over

std::vector<std::string> stage_hashes(const Result& result) {
    std::vector<std::string> hashes;
    for (const Shader& shader : result.shaders) hashes.push_back(shader.hash);
    return hashes;
}

Result compiled(const std::string& text, std::map<std::string, std::string> files = {}) {
    CompileOptions options = options_for(files);
    options.hashes = options.keep_programs = true;
    Result result = compiler().compile_text("a.graph.json", text, options);
    EXPECT_TRUE(result.ok) << text_of(result.diagnostics) << text;
    return result;
}

std::string subgraph(const std::string& properties, const std::string& nodes, const std::string& value) {
    return R"json({ "patina": 1, "kind": "subgraph", "properties": [)json" + properties + R"json(], "nodes": [)json" +
           nodes + R"json(], "outputs": { "value": ")json" + value + "\" } }";
}

// 'moss' and 'sand' both have 'grain' inside; 'ground' has both. What a graph declares lies together in its order, what
// its sub-graphs bring behind it, those first whose first property's name comes first: _A of 'moss', _B of 'sand'.
TEST(Properties, OfSubgraphsHaveAnOrderThatNodesDoNotChange) {
    const std::string grain = R"json({ "id": "g", "node": "./grain.subgraph.json" })json";
    const std::string inside[] = {R"json({ "id": "m", "node": "./moss.subgraph.json" })json",
                                  R"json({ "id": "s", "node": "./sand.subgraph.json" })json"};
    const std::map<std::string, std::string> files = {
        {"moss.subgraph.json", subgraph(R"json({ "name": "_A", "type": "bool", "as": "specialization" },
                                               { "name": "_Z", "type": "float", "default": 0.25 })json",
                                        grain, "= $_A ? $_Z : g")},
        {"sand.subgraph.json", subgraph(R"json({ "name": "_B", "type": "bool", "as": "specialization" },
                                               { "name": "_Y", "type": "float2" })json",
                                        grain, "= $_B ? $_Y.x : g")},
        {"grain.subgraph.json",
         subgraph(R"json({ "name": "_C", "type": "bool", "as": "specialization" },
                                                { "name": "_T", "type": "texture2d" })json",
                  R"json({ "id": "t", "node": "SampleTexture2D", "in": { "texture": "$_T" } })json",
                  "= $_C ? t.r : @uv0.x")},
        {"ground.subgraph.json", subgraph("", inside[0] + "," + inside[1], "= m - s")},
        {"ground_turned.subgraph.json", subgraph("", inside[1] + "," + inside[0], "= m - s")}};
    const auto material = [](const std::string& nodes, const std::string& value) {
        return R"json({ "patina": 1, "workflow": "unlit", "properties": [ { "name": "_Own", "type": "float" } ],
                        "nodes": [)json" +
               nodes + R"json(], "surface": { "color": "= float3($_Own + )json" + value + ")\" } }";
    };
    const auto node = [](const std::string& id, const std::string& file) {
        return R"json({ "id": ")json" + id + R"json(", "node": "./)json" + file + R"json(.subgraph.json" })json";
    };
    const std::string materials[] = {material(node("a", "moss") + "," + node("b", "sand"), "(a - b)"),
                                     material(node("b", "sand") + "," + node("a", "moss"), "(a - b)"),
                                     material(node("a", "sand") + "," + node("b", "moss"), "(b - a)"),
                                     material(node("zz", "moss") + "," + node("aa", "sand"), "(zz - aa)"),
                                     material(node("n", "ground"), "n"),
                                     material(node("n", "ground_turned"), "n")};
    const Result first = compiled(materials[0], files);
    for (const std::string& text : materials) {
        const Result result = compiled(text, files);
        std::vector<std::string> names;
        std::map<std::string, std::optional<std::uint32_t>> ids;
        for (const Property& property : result.reflection.properties) {
            names.push_back(property.name);
            ids[property.name] = property.constant_id;
        }
        EXPECT_EQ(names, (std::vector<std::string>{"_Own", "_A", "_Z", "_C", "_T", "_B", "_Y"})) << text;
        EXPECT_EQ(ids["_A"], 0u);
        EXPECT_EQ(ids["_C"], 1u);
        EXPECT_EQ(ids["_B"], 2u);
        EXPECT_EQ(result.reflection.layout_hash, first.reflection.layout_hash);
        EXPECT_EQ(result.reflection.passes[0].hash, first.reflection.passes[0].hash) << text;
        EXPECT_EQ(stage_hashes(result), stage_hashes(first)) << text;
    }
}

// The sub-graph comes before the lighting graph and says 0.2 of both, with another range.
TEST(Properties, HaveTheDefaultThatTheMaterialGivesItsLightingGraph) {
    const std::map<std::string, std::string> files = {
        {"part.subgraph.json", subgraph(R"json({ "name": "_P", "type": "float", "default": 0.2, "label": "Part" },
                                               { "name": "_ON", "type": "bool", "as": "specialization" })json",
                                        "", "= $_ON ? $_P : 0")},
        {"lit.lighting.json", R"json({ "patina": 1, "kind": "lighting", "properties": [
             { "name": "_P", "type": "float", "default": 0.3, "range": [0, 2] },
             { "name": "_ON", "type": "bool", "as": "specialization" } ],
             "direct": "= $_ON ? $_P * @light.radiance : float3(0)" })json"}};
    const Result result = compiled(R"json({ "patina": 1, "workflow": "metallic-roughness",
        "lighting": { "use": "./lit.lighting.json", "in": { "_P": 0.75, "_ON": true } },
        "nodes": [ { "id": "part", "node": "./part.subgraph.json" } ], "surface": { "metallic": "part" },
        "passes": [ { "name": "again", "lighting": "./lit.lighting.json" } ] })json",
                                   files);
    const std::vector<Property>& properties = result.reflection.properties;
    ASSERT_EQ(properties.size(), 2u);
    EXPECT_EQ(properties[0].value[0], 0.75);
    EXPECT_EQ(properties[0].label, "Part");
    ASSERT_TRUE(properties[0].range.has_value());
    EXPECT_EQ((*properties[0].range)[1], 2);
    EXPECT_EQ(properties[1].value[0], 1);
}

TEST(Properties, ThatAreFilesAtPortsHaveAnOrderThatNodesDoNotChange) {
    const std::string moss = R"json({ "id": "m", "node": "SampleTexture2D", "in": { "texture": "./moss.png" } })json";
    const std::string sand = R"json({ "id": "s", "node": "SampleTexture2D", "in": { "texture": "./sand.png" } })json";
    const std::map<std::string, std::string> files = {{"moss.png", ""}, {"sand.png", ""}};
    const Result first = compiled(unlit("= m.rgb - s.rgb", moss + "," + sand), files);
    const Result turned = compiled(unlit("= m.rgb - s.rgb", sand + "," + moss), files);
    ASSERT_EQ(turned.reflection.properties.size(), 4u);
    EXPECT_EQ(turned.reflection.properties[2].name, "_moss");
    EXPECT_EQ(turned.reflection.properties[3].name, "_sand");
    EXPECT_EQ(stage_hashes(turned), stage_hashes(first));
}

// A quad's corners are where a wave is computed, and between them it is a line: what the CPU makes of it, too.
TEST(Interpolators, HaveAnOrderThatNodesDoNotChange) {
    const auto pinned = [](const std::string& id, const std::string& value) {
        return R"json({ "id": ")json" + id + R"json(", "expr": ")json" + value + R"json(", "stage": "vertex" })json";
    };
    const std::string sine = "0.5 + 0.25 * sin(@uv0.x)", cosine = "0.5 * cos(@uv0.y)", both = "@uv0 * 0.5";
    const std::string texts[] = {
        unlit("= float3(x, y, z.x - z.y)", pinned("x", sine) + "," + pinned("y", cosine) + "," + pinned("z", both)),
        unlit("= float3(x, y, z.x - z.y)", pinned("z", both) + "," + pinned("y", cosine) + "," + pinned("x", sine)),
        unlit("= float3(y, z, x.x - x.y)", pinned("z", cosine) + "," + pinned("y", sine) + "," + pinned("x", both))};
    const Result first = compiled(texts[0]);
    const Image cpu = drawn(first, {});
    for (const std::string& text : texts) {
        const Result result = compiled(text);
        EXPECT_EQ(stage_hashes(result), stage_hashes(first)) << text;
        for (const Target& target : {Target::Glsl, Target::Hlsl}) {
            const Image image = drawn(result, target);
            ASSERT_EQ(image.pixels.size(), cpu.pixels.size());
            for (std::size_t i = 0; i < image.pixels.size(); ++i) EXPECT_NEAR(image.pixels[i], cpu.pixels[i], 1e-5);
        }
    }
    EXPECT_EQ(renderer().messages(), std::vector<std::string>{});
    EXPECT_NE(stage_hashes(compiled(unlit("= float3(y, x, z.x - z.y)",
                                          pinned("x", sine) + "," + pinned("y", cosine) + "," + pinned("z", both)))),
              stage_hashes(first));
}

TEST(Interpolators, ThatAreEqualAreOne) {
    const auto text = [](const std::string& value, const std::string& second) {
        return unlit(value, R"json({ "id": "x", "expr": "sin(@uv0.x + @uv0.y)", "stage": "vertex" })json" + second);
    };
    const std::string second = R"json(, { "id": "y", "expr": "sin(@uv0.y + @uv0.x)", "stage": "vertex" })json";
    const std::vector<std::string> one = stage_hashes(compiled(text("= float3(x - 2 * sqrt(x))", "")));
    EXPECT_EQ(stage_hashes(compiled(text("= float3(x - 2 * sqrt(y))", second))), one);
    EXPECT_EQ(stage_hashes(compiled(text("= float3(y - 2 * sqrt(x))", second))), one);
}

// In a surface that is a function of its own what turned out to be a constant, or another interpolator, is no
// parameter.
TEST(Interpolators, ThatAreOneOrKnownAreNotHandedOnTwice) {
    const auto text = [](const std::string& x, const std::string& y, const std::string& c, bool turned) {
        const auto pinned = [](const std::string& id, const std::string& value) {
            return R"json({ "id": ")json" + id + R"json(", "expr": ")json" + value +
                   R"json(", "stage": "vertex" })json";
        };
        const auto noise = [](const std::string& id, const std::string& scale) {
            return R"json({ "id": ")json" + id + R"json(", "node": "GradientNoise", "in": { "scale": "= )json" + scale +
                   R"json(" } })json";
        };
        const std::string wave = "sin(@uv0.x + @uv0.y)";
        const std::string first = pinned(x, wave) + "," + pinned(c, "2.46"), second = pinned(y, wave);
        return unlit("= float3(one - 2 * sqrt(two), sin(three), cos(three) * " + y + ")",
                     (turned ? second + "," + first : first + "," + second) + "," + noise("one", "3 + " + x) + "," +
                         noise("two", "3 - " + y) + "," + noise("three", c));
    };
    const Result plain = compiled(text("x", "y", "c", false));
    const std::string& shader = plain.shaders[1].text;
    EXPECT_NE(shader.find("vec3 emission = surface(vUv0, vX);"), std::string::npos) << shader;
    for (const bool turned : {false, true}) {
        EXPECT_EQ(stage_hashes(compiled(text("x", "y", "c", turned))), stage_hashes(plain));
        EXPECT_EQ(stage_hashes(compiled(text("q", "b", "z", turned))), stage_hashes(plain));
        EXPECT_EQ(stage_hashes(compiled(text("b", "q", "a", turned))), stage_hashes(plain));
    }
}

}  // namespace
}  // namespace patina
