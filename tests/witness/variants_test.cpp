// Variants and specialization constants: as many shaders as there are different ones, and the right one for each
// combination.
#include "patina/variants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "patina/validate.h"
#include "runtime/picture/compare.h"
#include "witness/drawn.h"

namespace patina {
namespace {

using runtime::Image;
using namespace witness;

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
    ASSERT_TRUE(plan.ok) << text_of(plan.diagnostics);
    std::vector<std::string> names;
    for (const VariantAxis& axis : plan.axes) names.push_back(axis.property);
    EXPECT_EQ(names, (std::vector<std::string>{"_A", "_C", "_D", "_B"}));
    EXPECT_EQ(plan.count, 16u);
}

TEST(Variants, ThatAreEqualShareAShader) {
    const VariantPlan plan = planned(VariantsWanted::All);
    const VariantSet set = compiler().compile_variants("sixteen.graph.json", plan, options_for(kSixteen));
    ASSERT_TRUE(set.ok) << text_of(set.diagnostics);
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
    ASSERT_TRUE(plan.ok) << text_of(plan.diagnostics);
    EXPECT_EQ(plan.picked,
              (std::vector<VariantValues>{
                  {{"_A", "false"}}, {{"_A", "true"}, {"_B", "false"}}, {{"_A", "true"}, {"_B", "true"}}}));
    const VariantSet set = compiler().compile_variants("sixteen.graph.json", plan, options_for(kSixteen));
    EXPECT_EQ(set.programs.size(), 3u);
}

TEST(Variants, CanBeListed) {
    const VariantPlan plan = planned(VariantsWanted::Listed);
    ASSERT_TRUE(plan.ok) << text_of(plan.diagnostics);
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
    EXPECT_EQ(plan.diagnostics[0].notes[0].message,
              "'_A' has 2 values: if it has one value, the number of combinations is 8");
    EXPECT_EQ(plan.diagnostics[0].notes[3].file, "inner.subgraph.json");
    EXPECT_TRUE(planned(VariantsWanted::All, 16).ok);
    // Three can be reached, and no more are counted than the limit. _C and _D cost nothing.
    const VariantPlan reachable = planned(VariantsWanted::Reachable, 2);
    ASSERT_EQ(reachable.diagnostics.size(), 1u);
    EXPECT_EQ(reachable.diagnostics[0].message, "the reachable combinations of variants are too many: the limit is 2");
    ASSERT_EQ(reachable.diagnostics[0].notes.size(), 3u);
    EXPECT_EQ(reachable.diagnostics[0].notes[0].message,
              "'_A' has 2 values: if it has one value, the number of combinations is at most 2");
    EXPECT_EQ(reachable.diagnostics[0].notes[1].message,
              "'_B' has 2 values: if it has one value, the number of combinations is at most 2");
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
    EXPECT_EQ(
        none.diagnostics[0].message,
        "no entry of 'variants' is left: _A = true and _B = false exclude all of them; remove one, or list such a "
        "combination");
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
    ASSERT_TRUE(plan.ok) << text_of(plan.diagnostics);
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
        EXPECT_TRUE(result.ok) << text_of(result.diagnostics);
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
        ASSERT_TRUE(result.ok) << text_of(result.diagnostics);
        const std::string wanted = std::string("const bool _Hard = ") + (is_hard ? "true;" : "false;");
        EXPECT_NE(result.shaders[1].text.find(wanted), std::string::npos) << result.shaders[1].text;
    }
    options.switches = {{"_Hard", "soft"}};
    const Result refused = compiler().compile_file("m.graph.json", options);
    ASSERT_EQ(refused.diagnostics.size(), 1u) << text_of(refused.diagnostics);
    EXPECT_EQ(refused.diagnostics[0].code, "unknown-word");
}

TEST(Specialization, HasTheIdsOfItsPropertiesInEveryVariant) {
    for (const char* fixed : {"false", "true"}) {
        CompileOptions options = options_for(kSpecialized);
        options.switches = {{"_Fixed", fixed}};
        const Result result = compiler().compile_file("special.graph.json", options);
        ASSERT_TRUE(result.ok) << text_of(result.diagnostics);
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
    ASSERT_TRUE(result.ok) << text_of(result.diagnostics);
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

}  // namespace
}  // namespace patina
