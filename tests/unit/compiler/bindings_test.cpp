// What a switch adds moves no binding: a program that has bound its resources by number keeps working.
#include <gtest/gtest.h>

#include <map>

#include "patina/patina.h"

namespace patina {
namespace {

constexpr const char* kGraph = R"json({
  "patina": 1,
  "workflow": "metallic-roughness",
  "lighting": "unity-brdf1",
  "properties": [
    { "name": "_MainTex", "type": "texture2d" },
    { "name": "_Wet", "type": "bool", "as": "variant", "default": false },
    { "name": "_WetTex", "type": "texture2d" },
    { "name": "_Tint", "type": "color", "default": "#ffffff" }
  ],
  "nodes": [
    { "id": "dry", "node": "SampleTexture2D", "in": { "texture": "$_MainTex" } },
    { "id": "wet", "node": "SampleTexture2D", "in": { "texture": "$_WetTex" } }
  ],
  "surface": { "baseColor": "= ($_Wet ? wet.rgb : dry.rgb) * $_Tint.rgb" }
})json";

using Bindings = std::map<std::string, std::string>;

Bindings bindings(const Target& target, const std::string& path, const std::vector<std::string>& on) {
    CompileOptions options;
    options.targets = {target};
    options.request = CompileOptions::Passes{.path = path};
    for (const std::string& name : on) options.switches.emplace_back(name, "true");
    const Result result = Compiler().compile_text("test.graph.json", kGraph, options);
    EXPECT_TRUE(result.ok) << (result.diagnostics.empty() ? "" : result.diagnostics[0].message);
    Bindings all;
    const auto place = [](std::uint32_t set, std::uint32_t binding, const std::string& hlsl) {
        return std::to_string(set) + ":" + std::to_string(binding) + " " + hlsl;
    };
    for (const Block& block : result.reflection.blocks)
        all[block.name] = place(block.set, block.binding, block.hlsl_register);
    for (const Texture& texture : result.reflection.textures) {
        all[texture.name] = place(texture.set, texture.binding, texture.hlsl_register);
        all[texture.sampler_name] = place(texture.set, texture.sampler_binding, texture.sampler_register);
    }
    return all;
}

void expect_unmoved(const Bindings& before, const Bindings& after, const std::string& what) {
    for (const auto& [name, place] : after) {
        const auto found = before.find(name);
        EXPECT_TRUE(found == before.end() || found->second == place) << name << " with " << what << ": " << place;
    }
}

const std::vector<std::vector<std::string>> kChoices = {
    {"cookies"},
    {"shadows"},
    {"fog"},
    {"lightmap"},
    {"shadowMask"},
    {"_Wet"},
    {"shadows", "shadowsFade"},
    {"lightmap", "shadowMask", "shadows"},
    {"shadows", "cookies", "fog", "lightmap", "shadowMask", "_Wet"},
};

TEST(Bindings, DoNotMoveWithSwitches) {
    for (const char* path : {"forward", "deferred"}) {
        for (const Target& target : {Target::Glsl, Target::Hlsl}) {
            const Bindings plain = bindings(target, path, {});
            EXPECT_GT(plain.size(), 4u);
            std::vector<Bindings> seen = {plain};
            for (const std::vector<std::string>& on : kChoices) {
                const Bindings now = bindings(target, path, on);
                // Also what several switches add has one place.
                for (const Bindings& other : seen) expect_unmoved(other, now, std::string(path) + ", " + on.back());
                seen.push_back(now);
            }
        }
    }
}

TEST(Bindings, OfAllPathsAreTheSame) {
    expect_unmoved(bindings(Target::Glsl, "forward", {"shadows"}), bindings(Target::Glsl, "deferred", {"shadows"}),
                   "deferred");
}

// Unity's file declares no places, and a switch of the library is none of its passes'.
TEST(Bindings, OfUnityDoNotMoveWithVariants) {
    const Target unity{.engine = "unity", .language = "hlsl"};
    expect_unmoved(bindings(unity, "forward", {}), bindings(unity, "forward", {"_Wet"}), "_Wet");
}

}  // namespace
}  // namespace patina
