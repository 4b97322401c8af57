// The definitions of what an engine gives: complete, and the same as what shaders read and what the runtime fills.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "patina/engine_values.h"
#include "runtime/values/engine_values.h"

namespace patina {
namespace {

const Compiler& compiler() {
    static const Compiler kCompiler;
    return kCompiler;
}

TEST(EngineBlocks, SayWhatEachValueIsAndWhoFillsIt) {
    const std::vector<EngineBlockInfo> blocks = engine_blocks(compiler());
    ASSERT_GE(blocks.size(), 7u);
    EXPECT_EQ(blocks.back().name, "");  // the textures
    for (const EngineBlockInfo& block : blocks) {
        EXPECT_NE(block.doc.find("engine"), std::string::npos) << block.name << " does not say when it is filled";
        for (const EngineValueInfo& value : block.values) {
            EXPECT_GT(value.doc.size(), 10u) << value.name;
            EXPECT_EQ(value.doc.back(), '.') << value.name;
            EXPECT_EQ(value.doc.find("unit:"), std::string::npos) << value.name;
            EXPECT_EQ(value.type.starts_with("Texture"), block.name.empty()) << value.name;
            if (value.type.starts_with("float4x4")) {
                EXPECT_NE(value.space.find(" to "), std::string::npos) << value.name;
            }
        }
    }
}

TEST(EngineBlocks, AreThoseOfTheShaders) {
    const std::vector<EngineBlockInfo> blocks = engine_blocks(compiler());
    CompileOptions options;
    options.targets = {Target::Glsl};
    for (const char* name : {"shadows", "fog", "cookies", "lightmap", "shadowMask", "subtractive", "shadowsFade",
                             "reflectionProbes", "tiles", "distanceShadowMask"})
        options.switches.emplace_back(name, "true");
    std::size_t found = 0;
    for (const char* graph : {"examples/graphs/rusted_steel.graph.json", "examples/graphs/lava.graph.json"}) {
        const Result result = compiler().compile_file(graph, options);
        ASSERT_TRUE(result.ok) << (result.diagnostics.empty() ? "" : to_text(result.diagnostics.front()));
        for (const Block& block : result.reflection.blocks) {
            if (block.is_material) continue;
            const auto known = std::find_if(blocks.begin(), blocks.end(),
                                            [&](const EngineBlockInfo& each) { return each.name == block.name; });
            ASSERT_NE(known, blocks.end()) << block.name;
            // Their order is that of the offsets; a block has those that exist.
            auto at = known->values.begin();
            for (const BlockMember& member : block.members) {
                at = std::find_if(at, known->values.end(),
                                  [&](const EngineValueInfo& each) { return each.name == member.name; });
                ASSERT_NE(at, known->values.end()) << block.name << " " << member.name;
                const std::string count = member.array_count ? "[" + std::to_string(member.array_count) + "]" : "";
                EXPECT_TRUE(at->type.ends_with(count)) << member.name;
                ++found;
            }
        }
        for (const Texture& texture : result.reflection.textures) {
            if (texture.is_material || !texture.reads.empty()) continue;
            EXPECT_TRUE(std::any_of(blocks.back().values.begin(), blocks.back().values.end(),
                                    [&](const EngineValueInfo& each) { return each.name == texture.name; }))
                << texture.name;
        }
    }
    EXPECT_GT(found, 40u);
}

// Every combination of the switches that bring values. A member has one offset, and an array of instances one length.
TEST(EngineBlocks, HaveOneLayoutWhateverIsOn) {
    std::vector<std::string> switches;
    for (const EngineBlockInfo& block : engine_blocks(compiler())) {
        for (const EngineValueInfo& value : block.values) {
            for (const std::string& name : value.with) {
                const bool is_path = name.find('-') != std::string::npos;
                if (!is_path && std::find(switches.begin(), switches.end(), name) == switches.end())
                    switches.push_back(name);
            }
        }
    }
    ASSERT_GE(switches.size(), 8u);
    // A material, one that is drawn as instances with a property, and one that reads the number of the instance alone.
    const char* const graphs[] = {
        R"json({ "patina": 1, "workflow": "metallic-roughness", "surface": { "baseColor": [1, 0.5, 0] } })json",
        R"json({ "patina": 1, "workflow": "metallic-roughness",
  "properties": [{ "name": "_Tint", "type": "color", "as": "instance" }], "surface": { "baseColor": "$_Tint" } })json",
        R"json({ "patina": 1, "workflow": "metallic-roughness", "surface": { "metallic": "= @instanceId / 7" } })json"};
    for (const char* graph : graphs) {
        std::map<std::string, std::pair<std::uint32_t, std::uint32_t>> places;
        const std::uint32_t combinations = 1u << switches.size();
        // The last one is a path that brings a value.
        for (std::uint32_t on = 0; on <= combinations; ++on) {
            CompileOptions options;
            options.targets = {Target::Glsl};
            if (on == combinations) options.passes()->path = "deferred-shadowmask";
            for (std::size_t i = 0; i < switches.size(); ++i)
                if (on >> i & 1u) options.switches.emplace_back(switches[i], "true");
            const Result result = compiler().compile_text("layout.graph.json", graph, options);
            ASSERT_TRUE(result.ok) << (result.diagnostics.empty() ? "" : to_text(result.diagnostics.front()));
            for (const Block& block : result.reflection.blocks) {
                if (block.is_material) continue;
                for (const BlockMember& member : block.members) {
                    const std::pair place(member.offset, member.array_count);
                    const auto known = places.try_emplace(block.name + " " + member.name, place).first;
                    ASSERT_EQ(known->second, place) << known->first << " with the switches " << on;
                }
            }
        }
        EXPECT_GT(places.size(), 30u);
    }
}

TEST(EngineBlocks, AreThoseThatTheRuntimeFills) {
    std::set<std::string> defined;
    for (const EngineBlockInfo& block : engine_blocks(compiler())) {
        if (block.name.empty()) continue;
        for (const EngineValueInfo& value : block.values) defined.insert(value.name);
    }
    const std::vector<std::string> filled = runtime::engine_value_names();
    EXPECT_EQ(defined, std::set<std::string>(filled.begin(), filled.end()));
}

}  // namespace
}  // namespace patina
