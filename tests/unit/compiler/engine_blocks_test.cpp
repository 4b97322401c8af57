// The definitions of what an engine gives: complete, and the same as what shaders read and what the runtime fills.
#include <gtest/gtest.h>

#include <algorithm>
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
