// Variants and specialization constants: as many shaders as there are different ones, the right one for each
// combination, and a hash that knows equal ones whatever their nodes are called.
#include "patina/variants.h"

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

#include "patina/validate.h"
#include "random_graph.h"
#include "runtime/cpu/cpu_render.h"
#include "runtime/gpu/renderer.h"
#include "runtime/picture/compare.h"

namespace patina {
namespace {

using runtime::Image;

const Compiler& compiler() {
    static const Compiler kCompiler;
    return kCompiler;
}

CompileOptions options_for(const std::map<std::string, std::string>& files) {
    CompileOptions options;
    options.loader = [files](const std::string& path) -> std::optional<std::string> {
        const auto found = files.find(path.substr(path.find_last_of('/') + 1));
        return found == files.end() ? std::nullopt : std::optional(found->second);
    };
    return options;
}

std::string told(const std::vector<Diagnostic>& diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) text += to_text(diagnostic);
    return text;
}

// --- drawing

runtime::Renderer& renderer() {
    static const auto kOpened = runtime::Renderer::open({.validation = true});
    EXPECT_TRUE(kOpened) << kOpened.error;
    return *kOpened.value;
}

std::vector<std::uint32_t> spirv_of(const Result& result, Stage stage, Target target) {
    for (const Shader& shader : result.shaders) {
        if (shader.stage != stage || shader.target != target) continue;
        Validated validated = validate(shader);
        EXPECT_TRUE(validated.ok) << validated.log << shader.text;
        return validated.spirv;
    }
    ADD_FAILURE() << "there is no such stage";
    return {};
}

// A quad that fills the picture. Null target: the CPU.
Image drawn(const Result& result, std::optional<Target> target, const std::map<std::string, std::string>& words = {}) {
    runtime::Scene scene = runtime::fullscreen_scene(8, 8);
    const auto values = runtime::material_values(result.reflection, words);
    EXPECT_TRUE(values) << values.error;
    const auto blocks = runtime::fill_blocks(result.reflection, values.value, scene);
    runtime::Draw draw{.reflection = &result.reflection,
                       .scene = &scene,
                       .blocks = blocks,
                       .constants = runtime::constants_of(result.reflection, values.value),
                       .program = result.program.get()};
    if (!target) {
        auto image = runtime::cpu_draw(draw, Precision::Double);
        EXPECT_TRUE(image) << image.error;
        return std::move(image.value);
    }
    const auto vertex = spirv_of(result, Stage::Vertex, *target), fragment = spirv_of(result, Stage::Fragment, *target);
    draw.vertex_spirv = vertex;
    draw.fragment_spirv = fragment;
    auto image = renderer().draw(draw);
    EXPECT_TRUE(image) << image.error;
    return std::move(image.value);
}

// --- as many shaders as there are different ones

// Sixteen combinations. _B counts where _A is on; _C chooses between two ways to say one thing; nothing reads _D.
const std::map<std::string, std::string> kSixteen = {{"sixteen.graph.json", R"json({
  "patina": 1, "workflow": "unlit",
  "properties": [
    { "name": "_A", "type": "bool", "default": true, "as": "variant" },
    { "name": "_C", "type": "bool", "as": "variant" },
    { "name": "_D", "type": "bool", "as": "variant" }
  ],
  "variants": [ { "_A": false }, { "_B": true, "_A": true }, { "_A": false, "_B": false } ],
  "nodes": [
    { "id": "inner", "node": "./inner.subgraph.json" },
    { "id": "twice", "expr": "$_C ? @uv0.y * 2 : 2 * @uv0.y" }
  ],
  "surface": { "color": "= float3($_A ? inner : 0.5, twice, 0.25)" } })json"},
                                                     {"inner.subgraph.json", R"json({
  "patina": 1, "kind": "subgraph",
  "properties": [ { "name": "_B", "type": "bool", "as": "variant" } ],
  "outputs": { "value": "= $_B ? @uv0.x : 1 - @uv0.x" } })json"}};

VariantPlan planned(VariantsWanted wanted, std::size_t limit = kVariantLimit) {
    return compiler().plan_variants("sixteen.graph.json", wanted, options_for(kSixteen), limit);
}

TEST(Variants, OfASubgraphReachTheMaterial) {
    const VariantPlan plan = planned(VariantsWanted::All);
    ASSERT_TRUE(plan.ok) << told(plan.diagnostics);
    std::vector<std::string> names;
    for (const VariantAxis& axis : plan.axes) names.push_back(axis.property);
    EXPECT_EQ(names, (std::vector<std::string>{"_A", "_C", "_D", "_B"}));
    EXPECT_EQ(plan.count, 16u);
}

TEST(Variants, ThatAreEqualShareAShader) {
    const VariantPlan plan = planned(VariantsWanted::All);
    const VariantSet set = compiler().compile_variants("sixteen.graph.json", plan, options_for(kSixteen));
    ASSERT_TRUE(set.ok) << told(set.diagnostics);
    EXPECT_EQ(set.programs.size(), 3u);
    for (std::size_t i = 0; i < plan.count; ++i) {
        const VariantValues combination = plan.combination(i);
        const std::map<std::string, std::string> values(combination.begin(), combination.end());
        const VariantValues same_shader = {{"_A", values.at("_A")},
                                           {"_B", values.at("_A") == "true" ? values.at("_B") : "false"},
                                           {"_C", "false"},
                                           {"_D", "false"}};
        for (std::size_t j = 0; j < plan.count; ++j) {
            VariantValues other = plan.combination(j);
            std::sort(other.begin(), other.end());
            if (other == same_shader) {
                EXPECT_EQ(set.program_of[i], set.program_of[j]);
            }
        }
    }
}

TEST(Variants, AreDrawnByTheShaderThatTheyShare) {
    const VariantPlan plan = planned(VariantsWanted::All);
    const VariantSet set = compiler().compile_variants("sixteen.graph.json", plan, options_for(kSixteen));
    ASSERT_TRUE(set.ok);
    for (const Target& target : {Target::Glsl, Target::Hlsl}) {
        std::vector<Image> shared;
        for (const VariantProgram& program : set.programs) shared.push_back(drawn(program.result, target));
        for (std::size_t i = 0; i < plan.count; ++i) {
            CompileOptions options = options_for(kSixteen);
            options.switches = plan.combination(i);
            const Image own = drawn(compiler().compile_file("sixteen.graph.json", options), target);
            EXPECT_EQ(own.pixels, shared[set.program_of[i]].pixels) << i;
        }
        for (std::size_t i = 1; i < shared.size(); ++i) EXPECT_NE(shared[i].pixels, shared[i - 1].pixels);
    }
    EXPECT_EQ(renderer().messages(), std::vector<std::string>{});
}

TEST(Variants, CountOnlyWhereTheyCanBeReached) {
    const VariantPlan plan = planned(VariantsWanted::Reachable);
    ASSERT_TRUE(plan.ok) << told(plan.diagnostics);
    EXPECT_EQ(plan.picked,
              (std::vector<VariantValues>{
                  {{"_A", "false"}}, {{"_A", "true"}, {"_B", "false"}}, {{"_A", "true"}, {"_B", "true"}}}));
    const VariantSet set = compiler().compile_variants("sixteen.graph.json", plan, options_for(kSixteen));
    EXPECT_EQ(set.programs.size(), 3u);
}

TEST(Variants, CanBeListed) {
    const VariantPlan plan = planned(VariantsWanted::Listed);
    ASSERT_TRUE(plan.ok) << told(plan.diagnostics);
    // The third entry says what the first means.
    EXPECT_EQ(plan.picked,
              (std::vector<VariantValues>{{{"_A", "false"}, {"_C", "false"}, {"_D", "false"}, {"_B", "false"}},
                                          {{"_A", "true"}, {"_C", "false"}, {"_D", "false"}, {"_B", "true"}}}));
}

TEST(Variants, PastTheLimitAreRefusedWithWhatTheyCost) {
    const VariantPlan plan = planned(VariantsWanted::All, 15);
    ASSERT_FALSE(plan.ok);
    ASSERT_EQ(plan.diagnostics.size(), 1u);
    EXPECT_EQ(plan.diagnostics[0].message, "16 combinations of variants are too many: the limit is 15");
    ASSERT_EQ(plan.diagnostics[0].notes.size(), 5u);
    EXPECT_EQ(plan.diagnostics[0].notes[0].message, "'_A' has 2 values: without it there are 8");
    EXPECT_EQ(plan.diagnostics[0].notes[3].file, "inner.subgraph.json");
    EXPECT_TRUE(planned(VariantsWanted::All, 16).ok);
    // Three can be reached, and no more are counted than the limit. _C and _D cost nothing.
    const VariantPlan reachable = planned(VariantsWanted::Reachable, 2);
    ASSERT_EQ(reachable.diagnostics.size(), 1u);
    EXPECT_EQ(reachable.diagnostics[0].message, "the reachable combinations of variants are too many: the limit is 2");
    ASSERT_EQ(reachable.diagnostics[0].notes.size(), 3u);
    EXPECT_EQ(reachable.diagnostics[0].notes[0].message, "'_A' has 2 values: without it there are at most 2");
    EXPECT_EQ(reachable.diagnostics[0].notes[1].message, "'_B' has 2 values: without it there are at most 2");
    EXPECT_TRUE(planned(VariantsWanted::Reachable, 3).ok);
}

TEST(Variants, ThatAreFixedDoNotMultiply) {
    CompileOptions options = options_for(kSixteen);
    options.switches = {{"_A", "false"}, {"_D", "true"}};
    const VariantPlan plan =
        compiler().plan_variants("sixteen.graph.json", VariantsWanted::All, options, kVariantLimit);
    EXPECT_EQ(plan.count, 4u);
    EXPECT_EQ(plan.fixed, 2u);
    EXPECT_EQ(planned(VariantsWanted::All).fixed, 0u);
    EXPECT_EQ(compiler().compile_variants("sixteen.graph.json", plan, options).programs.size(), 1u);
}

// A file for Unity holds all combinations of variants that are not fixed; it belongs to each program of the others.
TEST(Variants, OfUnityAreInOneFile) {
    CompileOptions options = options_for(kSixteen);
    options.switches = {{"_A", "true"}, {"shadows", ""}};
    options.targets = {Target::Glsl, {"unity", "hlsl"}};
    const VariantPlan plan =
        compiler().plan_variants("sixteen.graph.json", VariantsWanted::All, options, kVariantLimit);
    const VariantSet both = compiler().compile_variants("sixteen.graph.json", plan, options);
    ASSERT_TRUE(both.ok);
    EXPECT_EQ(both.programs.size(), 2u);
    std::set<std::string> files;
    for (const VariantProgram& program : both.programs) {
        ASSERT_EQ(program.result.shaders.back().target.engine, "unity");
        files.insert(program.result.shaders.back().text);
    }
    ASSERT_EQ(files.size(), 1u);
    EXPECT_EQ(files.begin()->find("(_A)"), std::string::npos) << *files.begin();
    EXPECT_NE(files.begin()->find("#pragma shader_feature_local _B\n"), std::string::npos) << *files.begin();

    options.targets = {{"unity", "hlsl"}};
    options.switches = {{"_A", "true"}};
    const VariantSet alone = compiler().compile_variants("sixteen.graph.json", plan, options);
    ASSERT_EQ(alone.programs.size(), 1u);
    EXPECT_EQ(alone.program_of, std::vector<std::size_t>(8, 0));
    EXPECT_EQ(alone.programs[0].result.shaders.front().text, *files.begin());
}

TEST(Variants, ThatAreFixedLeaveOutWhatIsListedOtherwise) {
    CompileOptions options = options_for(kSixteen);
    options.switches = {{"_A", "false"}};
    const auto listed = [&] {
        return compiler().plan_variants("sixteen.graph.json", VariantsWanted::Listed, options, kVariantLimit);
    };
    EXPECT_EQ(listed().picked, (std::vector<VariantValues>{{{"_C", "false"}, {"_D", "false"}, {"_B", "false"}}}));
    options.switches = {{"_A", ""}, {"_B", "false"}};  // without a value it is on
    const VariantPlan none = listed();
    EXPECT_FALSE(none.ok);
    ASSERT_EQ(none.diagnostics.size(), 1u);
    EXPECT_EQ(none.diagnostics[0].code, "nothing-listed");
    EXPECT_EQ(none.diagnostics[0].message, "no combination that the graph lists has '_A' = true and '_B' = false");
    EXPECT_GT(none.diagnostics[0].line, 1);
}

// 2^19 combinations are counted, and each is had by its number, without a list of them: the last axis changes first.
TEST(Variants, AreCountedWithoutBeingListed) {
    std::string properties;
    for (int i = 0; i < 19; ++i)
        properties += "{ \"name\": \"_V" + std::to_string(i) + "\", \"type\": \"bool\", \"as\": \"variant\" },";
    const std::string text = R"({ "patina": 1, "workflow": "unlit", "properties": [)" + properties + "] }";
    const VariantPlan plan = compiler().plan_variants("many.graph.json", VariantsWanted::All,
                                                      options_for({{"many.graph.json", text}}), 600'000);
    ASSERT_TRUE(plan.ok) << told(plan.diagnostics);
    EXPECT_EQ(plan.count, 524288u);
    EXPECT_TRUE(plan.picked.empty());
    const VariantValues last_but_one = plan.combination(524286);
    EXPECT_EQ(last_but_one.front(), std::pair(std::string("_V0"), std::string("true")));
    EXPECT_EQ(last_but_one.back(), std::pair(std::string("_V18"), std::string("false")));
}

// A choice between equal values leaves no trace in the shader, for both kinds of property.
TEST(Variants, BetweenEqualValuesAreNotInTheShader) {
    const auto hash = [&](std::string_view binding, std::string_view value) {
        CompileOptions options;
        options.hashes = options.keep_variants = true;
        const Result result = compiler().compile_text(
            "equal.graph.json",
            R"({ "patina": 1, "workflow": "unlit", "properties": [ { "name": "_S", "type": "bool", "as": ")" +
                std::string(binding) + R"(" } ], "surface": { "color": "= )" + std::string(value) + R"(" } })",
            options);
        EXPECT_TRUE(result.ok) << told(result.diagnostics);
        return result.reflection.passes.at(0).hash;
    };
    for (const char* binding : {"specialization", "variant"}) {
        EXPECT_EQ(hash(binding, "$_S ? 0 : 0"), hash(binding, "0")) << binding;
        EXPECT_EQ(hash(binding, "$_S ? @uv0.x : @uv0.x"), hash(binding, "@uv0.x")) << binding;
        EXPECT_NE(hash(binding, "$_S ? 0 : 1"), hash(binding, "0")) << binding;
    }
}

// --- constants of a pipeline

const std::map<std::string, std::string> kSpecialized = {{"special.graph.json", R"json({
  "patina": 1, "workflow": "unlit",
  "properties": [
    { "name": "_Mode", "type": "enum", "values": ["Quarter", "Half", "Whole"], "default": "Half", "as": "specialization" },
    { "name": "_Fixed", "type": "bool", "as": "variant" },
    { "name": "_Blue", "type": "bool", "default": true, "as": "specialization" },
    { "name": "_Blend", "type": "enum", "values": ["Whiteout", "Reoriented"], "as": "specialization" }
  ],
  "nodes": [
    { "id": "tilted", "node": "NormalBlend",
      "in": { "base": [0.6, 0, 0.8], "detail": [0.6, 0, 0.8], "mode": "$_Blend" } }
  ],
  "surface": { "color": "= float3($_Mode == Quarter ? 0.25 : $_Mode == Half ? 0.5 : 1, $_Blue ? 0.75 : 0, tilted.z)" } })json"}};

// One that only a lighting graph declares has the default that -D gives it, too, and no other value than its own.
TEST(Specialization, OfALightingGraphIsSetLikeAnyOther) {
    const std::map<std::string, std::string> files = {{"m.graph.json", R"json({
  "patina": 1, "workflow": "metallic-roughness", "lighting": "./l.lighting.json" })json"},
                                                      {"l.lighting.json", R"json({
  "patina": 1, "kind": "lighting",
  "properties": [ { "name": "_Hard", "type": "bool", "as": "specialization" } ],
  "direct": "= @surface.diffuseColor * @light.color * ($_Hard ? 0.25 : 0.5)" })json"}};
    CompileOptions options = options_for(files);
    for (const bool is_hard : {false, true}) {
        options.switches = {{"_Hard", is_hard ? "true" : "false"}};
        const Result result = compiler().compile_file("m.graph.json", options);
        ASSERT_TRUE(result.ok) << told(result.diagnostics);
        const std::string wanted = std::string("const bool _Hard = ") + (is_hard ? "true;" : "false;");
        EXPECT_NE(result.shaders[1].text.find(wanted), std::string::npos) << result.shaders[1].text;
    }
    options.switches = {{"_Hard", "soft"}};
    const Result refused = compiler().compile_file("m.graph.json", options);
    ASSERT_EQ(refused.diagnostics.size(), 1u) << told(refused.diagnostics);
    EXPECT_EQ(refused.diagnostics[0].code, "unknown-word");
}

TEST(Specialization, HasTheIdsOfItsPropertiesInEveryVariant) {
    for (const char* fixed : {"false", "true"}) {
        CompileOptions options = options_for(kSpecialized);
        options.switches = {{"_Fixed", fixed}};
        const Result result = compiler().compile_file("special.graph.json", options);
        ASSERT_TRUE(result.ok) << told(result.diagnostics);
        std::map<std::string, std::optional<std::uint32_t>> ids;
        for (const Property& property : result.reflection.properties) ids[property.name] = property.constant_id;
        EXPECT_EQ(ids["_Mode"], 0u);
        EXPECT_EQ(ids["_Fixed"], std::nullopt);
        EXPECT_EQ(ids["_Blue"], 1u);
        EXPECT_EQ(ids["_Blend"], 2u);
        EXPECT_EQ(result.reflection.passes[0].keywords, (std::vector<std::string>{"_Mode", "_Blue", "_Blend"}));
    }
}

// Two slopes of 3/4 along x: whiteout adds them, z = 0.64 / |(1.2, 0, 0.64)| = 0.64 / 1.36; reoriented doubles the
// angle, whose cosine is 0.8, so that z = 2 * 0.64 - 1.
TEST(Specialization, ChoosesWhenThePipelineIsMade) {
    CompileOptions options = options_for(kSpecialized);
    options.keep_programs = true;
    const Result result = compiler().compile_file("special.graph.json", options);
    ASSERT_TRUE(result.ok) << told(result.diagnostics);
    struct Case {
        std::map<std::string, std::string> words;
        float red, green, blue;
    };
    const Case cases[] = {{{}, 0.5f, 0.75f, 0.64f / 1.36f},
                          {{{"_Mode", "Quarter"}, {"_Blend", "Reoriented"}}, 0.25f, 0.75f, 0.28f},
                          {{{"_Mode", "Whole"}, {"_Blue", "false"}}, 1, 0, 0.64f / 1.36f}};
    for (const Case& each : cases) {
        for (const std::optional<Target>& target : {std::optional(Target::Glsl), std::optional(Target::Hlsl), {}}) {
            const Image image = drawn(result, target, each.words);
            ASSERT_GE(image.pixels.size(), 4u);
            EXPECT_NEAR(image.pixels[0], each.red, 1e-6);
            EXPECT_NEAR(image.pixels[1], each.green, 1e-6);
            EXPECT_NEAR(image.pixels[2], each.blue, 1e-5);
        }
    }
    EXPECT_EQ(renderer().messages(), std::vector<std::string>{});
}

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
    EXPECT_TRUE(result.ok) << told(result.diagnostics) << text;
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
    EXPECT_TRUE(result.ok) << told(result.diagnostics) << text;
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
    EXPECT_NE(shader.find("vec3 material = surface(vUv0, vX);"), std::string::npos) << shader;
    for (const bool turned : {false, true}) {
        EXPECT_EQ(stage_hashes(compiled(text("x", "y", "c", turned))), stage_hashes(plain));
        EXPECT_EQ(stage_hashes(compiled(text("q", "b", "z", turned))), stage_hashes(plain));
        EXPECT_EQ(stage_hashes(compiled(text("b", "q", "a", turned))), stage_hashes(plain));
    }
}

}  // namespace
}  // namespace patina
