// The counting of SPIR-V instructions: on modules written by hand, and on what the library's models become.
#include "patina/spirv_size.h"

#include <gtest/gtest.h>

#include "patina/validate.h"

namespace patina::cli {
namespace {

using Words = std::vector<std::uint32_t>;

// A module of instructions, each an opcode and its operands; a row is a block.
Words module_of(const std::vector<std::vector<Words>>& rows) {
    Words words = {0x07230203u, 0x00010000u, 0, 100, 0};
    for (const std::vector<Words>& row : rows) {
        for (const Words& instruction : row) {
            words.push_back(static_cast<std::uint32_t>(instruction.size()) << 16 | instruction[0]);
            words.insert(words.end(), instruction.begin() + 1, instruction.end());
        }
    }
    return words;
}

Words function(std::uint32_t id) {
    return {54, 1, id, 0, 2};
}
const Words kEnd = {56}, kReturn = {253}, kNop = {0};
Words label(std::uint32_t id) {
    return {248, id};
}
Words branch(std::uint32_t to) {
    return {249, to};
}
Words branch(std::uint32_t if_true, std::uint32_t if_false) {
    return {250, 5, if_true, if_false};
}
Words loop(std::uint32_t end, std::uint32_t next) {
    return {246, end, next, 0};
}
Words call(std::uint32_t callee) {
    return {57, 1, 90, callee};
}

TEST(SpirvSize, OfNothing) {
    EXPECT_EQ(size_of({}).instructions, 0u);
    EXPECT_EQ(size_of({1, 2, 3, 4, 5, 6}).instructions, 0u);
}

TEST(SpirvSize, WithoutALoop) {
    const SpirvSize size = size_of(module_of({{kNop, kNop}, {function(10)}, {label(20), kNop, kReturn, kEnd}}));
    EXPECT_EQ(size.instructions, 7u);
    EXPECT_EQ(size.in_functions, 5u);
    EXPECT_EQ(size.loops, 0u);
    EXPECT_EQ(size.in_loops, 0u);
}

// 20 -> 21 (header, end 24, continue 23) -> 22 or 24; 22 calls f twice -> 23 -> 21.
TEST(SpirvSize, OfALoopThatCalls) {
    const SpirvSize size = size_of(module_of({
        {function(10), label(20), branch(21)},
        {label(21), loop(24, 23), branch(22, 24)},                // 3 instructions
        {label(22), kNop, call(11), call(11), branch(23)},        // 5, and 2 x 6
        {label(23), branch(21)},                                  // 2
        {label(24), kNop, kNop, kReturn, kEnd},                   // behind it
        {function(11), label(30), kNop, kNop, kReturn, kEnd},     // 6
        {function(12), label(31), call(11), kNop, kReturn, kEnd}  // called by no one
    }));
    EXPECT_EQ(size.loops, 1u);
    EXPECT_EQ(size.in_loops, 3u + 5u + 12u + 2u);
}

// The loop of header 22, with a switch, stands in that of header 21: all of it is counted, once.
TEST(SpirvSize, OfALoopInALoopAndOneAfterIt) {
    const SpirvSize size = size_of(module_of({
        {function(10), label(20), branch(21)},
        {label(21), loop(29, 28), branch(22, 29)},       // 3
        {label(22), loop(26, 25), branch(23, 26)},       // 3
        {label(23), {247, 24, 0}, {251, 6, 24, 0, 27}},  // 3: to its default or its case
        {label(27), kNop, branch(24)},                   // 3
        {label(24), branch(25)},                         // 2
        {label(25), branch(22)},                         // 2
        {label(26), branch(28)},                         // 2
        {label(28), branch(21)},                         // 2
        {label(29), branch(40)},
        {label(40), loop(42, 41), branch(41, 42)},  // 3: another loop
        {label(41), branch(40)},                    // 2
        {label(42), kReturn, kEnd},
    }));
    EXPECT_EQ(size.loops, 2u);
    EXPECT_EQ(size.in_loops, 20u + 5u);
}

// Cost pages call the trip of a model's loop "each light": there is no other loop, and the light is read in it.
TEST(SpirvSize, OfTheModelsIsOfOneLoop) {
    const Compiler compiler;
    CompileOptions options;
    options.targets = {Target::Glsl};
    options.request = CompileOptions::Passes{.only = {"forward"}};
    for (const ModelInfo& model : compiler.lighting_models()) {
        const std::string text =
            R"({ "patina": 1, "workflow": "metallic-roughness", "lighting": ")" + model.name + R"(", "surface": {} })";
        const Result result = compiler.compile_text("cost.graph.json", text, options);
        ASSERT_TRUE(result.ok) << model.name;
        for (const Shader& shader : result.shaders) {
            if (shader.stage != Stage::Fragment) continue;
            const SpirvSize size = size_of(optimised(validate(shader).spirv));
            EXPECT_EQ(size.loops, model.name == "unlit" ? 0u : 1u) << model.name;
            EXPECT_LT(size.in_loops, size.in_functions) << model.name;
            EXPECT_EQ(size.in_loops > 20, size.loops > 0) << model.name;
        }
    }
}

}  // namespace
}  // namespace patina::cli
