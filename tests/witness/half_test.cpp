// Where half precision begins and ends: at the border of the node that asks for it. HLSL runs half at 32 bits here, so
// the witnesses are GLSL's float16_t and the CPU, which rounds after every operation.
#include <gtest/gtest.h>

#include "witness/bench.h"

namespace patina::witness {
namespace {

class HalfTest : public testing::Test {
protected:
    static void SetUpTestSuite() { bench = std::make_unique<Bench>(); }
    static void TearDownTestSuite() { bench.reset(); }
    void TearDown() override { bench->expect_silence(); }
    static inline std::unique_ptr<Bench> bench;

    // What `value`, a float4 over `nodes`, is where the node `t` reads (1.25, 2048, 0.5, 3).
    static void expect_value(const std::string& nodes, const std::string& value, const std::vector<float>& expected) {
        const auto material = bench->compile(
            R"({ "patina": 1, "workflow": "unlit", "properties": [ )" + data_property() + " ],\n\"nodes\": [ " +
            load_node("t", "0", "0") + ",\n" + nodes + ",\n{ \"id\": \"value\", \"expr\": \"" + value +
            "\" } ],\n\"surface\": { \"color\": \"value.rgb\", \"alpha\": \"value.a\" } }");
        ASSERT_TRUE(material);
        const Inputs inputs{.data = texture_of(runtime::make_image(1, 1, 1.25f, 2048, 0.5f, 3))};
        EXPECT_EQ(bench->draw(*material, Target::Glsl, inputs).pixels, expected) << "GLSL";
        EXPECT_EQ(bench->run(*material, Precision::Float, inputs).pixels, expected) << "the CPU in float";
        EXPECT_EQ(bench->run(*material, Precision::Double, inputs).pixels, expected) << "the CPU in double";
    }
};

// Halves between 2048 and 4096 are even numbers: 2049.25 becomes 2050.
TEST_F(HalfTest, AnExpressionReadsHalves) {
    expect_value(R"json({ "id": "h", "expr": "t.x + t.y", "precision": "half" })json",
                 "float4(h - 2048, t.x + t.y - 2048, 0, 0)", {2, 1.25f, 0, 0});
}

TEST_F(HalfTest, ALibraryNodeReadsHalves) {
    expect_value(
        R"json({ "id": "h", "node": "Add", "in": { "left": "t.x", "right": "t.y" }, "precision": "half" })json",
        "float4(h - 2048, 0, 0, 0)", {2, 0, 0, 0});
}

// 2050 * 2050 is beyond the largest half, 65504; and 2050 + 1 lies between two.
TEST_F(HalfTest, WhoReadsAHalfComputesInFloats) {
    expect_value(R"json({ "id": "h", "expr": "t.x + t.y", "precision": "half" },
                        { "id": "s", "node": "Split", "in": { "value": "t" }, "precision": "half" })json",
                 "float4(h * h, h + h.x / h, s.g * s.g, s.g + s.b)", {4202500, 2051, 4194304, 2048.5f});
}

TEST_F(HalfTest, MatricesJoinHalvesAndFloats) {
    expect_value(R"json({ "id": "h", "expr": "mul(float2x2(t.xy, t.zw), float2(1, 2))", "precision": "half" })json",
                 "float4(h, mul(float2x2(1, 0, 0, 1), h))", {4096, 6.5f, 4096, 6.5f});
}

TEST_F(HalfTest, WholeLiteralsMeetFractions) {
    expect_value(R"json({ "id": "h", "expr": "t.x + 2 * 1.5", "precision": "half" },
                        { "id": "whole", "expr": "-(1 + 1)" },
                        { "id": "clamped", "node": "Add", "in": { "left": "= whole", "right": "= t.x" } })json",
                 "float4(h, clamped, 0, 0)", {4.25f, -0.75f, 0, 0});
}

// The value is that of Random's own test line; a half has 11 bits of it. Its hash has more than a half can hold.
TEST_F(HalfTest, RandomNumbersFitAHalf) {
    const std::string half = R"(, "precision": "half" })";
    expect_value(R"json({ "id": "r", "node": "Random", "in": { "position": "= t.zz" })json" + half,
                 "float4(abs(r - 0.097231924533844) < 0.0005 ? 1 : 0, r.second >= 0 && r.second <= 1 ? 1 : 0, 0, 0)",
                 {1, 1, 0, 0});
}

}  // namespace
}  // namespace patina::witness
