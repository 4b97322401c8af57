// Gradients, curves and matrices: as constants, which fold, and as properties, which a material sets. The expected
// numbers are worked out by hand from the definitions.
#include <gtest/gtest.h>

#include "witness/bench.h"

namespace patina::witness {
namespace {

class ValuesTest : public testing::Test {
protected:
    static void SetUpTestSuite() { bench = std::make_unique<Bench>(); }
    static void TearDownTestSuite() { bench.reset(); }
    void TearDown() override { bench->expect_silence(); }
    static inline std::unique_ptr<Bench> bench;

    // What `value`, a float4 over `nodes`, is. The node `t` reads (0.25, 0.5, 0.75, 1.5).
    static void expect_value(const std::string& properties, const std::string& nodes, const std::string& value,
                             const std::vector<float>& expected,
                             const std::map<std::string, std::string>& values = {}) {
        const auto material = bench->compile(
            R"({ "patina": 1, "workflow": "unlit", "properties": [ )" + data_property() + properties +
            " ],\n\"nodes\": [ " + load_node("t", "0", "0") + ",\n" + nodes + "{ \"id\": \"value\", \"expr\": \"" +
            value + "\" } ],\n\"surface\": { \"color\": \"value.rgb\", \"alpha\": \"value.a\" } }");
        ASSERT_TRUE(material);
        const Inputs inputs{.data = texture_of(runtime::make_image(1, 1, 0.25f, 0.5f, 0.75f, 1.5f)), .values = values};
        const auto compare = [&](const Image& image, const char* witness) {
            ASSERT_EQ(image.pixels.size(), expected.size()) << witness;
            for (std::size_t i = 0; i < expected.size(); ++i)
                EXPECT_NEAR(image.pixels[i], expected[i], 2e-5) << witness << ", component " << i;
        };
        compare(bench->draw(*material, Target::Glsl, inputs), "GLSL");
        compare(bench->draw(*material, Target::Hlsl, inputs), "HLSL");
        compare(bench->run(*material, Precision::Double, inputs), "the CPU");
    }

    static std::string sample(const std::string& id, const std::string& gradient, const std::string& time) {
        return R"({ "id": ")" + id + R"(", "node": "SampleGradient", "in": { "gradient": )" + gradient +
               R"(, "time": ")" + time + "\" } },\n";
    }
    static std::string curve(const std::string& id, const std::string& keys, const std::string& time) {
        return R"({ "id": ")" + id + R"(", "node": "SampleCurve", "in": { "curve": )" + keys + R"(, "time": ")" + time +
               "\" } },\n";
    }
};

constexpr const char* kRamp =
    R"({ "colors": [[0, [0, 0, 0]], [0.5, [1, 0.5, 0]], [1, [1, 1, 1]]], "alphas": [[0.5, 1], [1, 0]] })";

TEST_F(ValuesTest, AGradientGoesFromKeyToKey) {
    expect_value("", sample("g", kRamp, "t.x"), "g", {0.5f, 0.25f, 0, 1});
    expect_value("", sample("g", kRamp, "t.z"), "g", {1, 0.75f, 0.5f, 0.5f});
    expect_value("", sample("g", kRamp, "t.w"), "g", {1, 1, 1, 0});
    expect_value("", sample("g", R"({ "colors": [[0.5, [0.25, 2, 4]]] })", "t.x"), "g", {0.25f, 2, 4, 1});
}

TEST_F(ValuesTest, AFixedGradientHasTheNextKeysColour) {
    const std::string fixed =
        R"({ "colors": [[0.25, [1, 0, 0]], [0.5, [0, 1, 0]], [1, [0, 0, 1]]], "alphas": [[0, 0.25], [1, 0.75]], "blend": "fixed" })";
    expect_value("", sample("g", fixed, "t.x"), "g", {1, 0, 0, 0.75f});
    expect_value("", sample("g", fixed, "t.y"), "g", {0, 1, 0, 0.75f});
    expect_value("", sample("g", fixed, "t.z"), "g", {0, 0, 1, 0.75f});
}

// In OkLab, the lightness of a grey is the cube root of its linear value.
TEST_F(ValuesTest, APerceptualGradientBlendsInOkLab) {
    const std::string greys = R"({ "colors": [[0, [0, 0, 0]], [1, [1, 1, 1]]], "blend": "perceptual" })";
    expect_value("", sample("g", greys, "t.y"), "g", {0.125f, 0.125f, 0.125f, 1});
    expect_value("", sample("g", greys, "t.x"), "g", {0.015625f, 0.015625f, 0.015625f, 1});
}

TEST_F(ValuesTest, APropertyHoldsAGradient) {
    const std::string ramp = R"(, { "name": "_Ramp", "type": "gradient", "default": )" + std::string(kRamp) + " }";
    expect_value(ramp, sample("g", R"("$_Ramp")", "t.z"), "g", {1, 0.75f, 0.5f, 0.5f});
    expect_value(R"(, { "name": "_Ramp", "type": "gradient" })", sample("g", R"("$_Ramp")", "t.x"), "g",
                 {0.25f, 0.25f, 0.25f, 1});
    expect_value(ramp, sample("g", R"("$_Ramp")", "t.y"), "g", {0.125f, 0.125f, 0.125f, 1},
                 {{"_Ramp", R"({ "colors": [[0, [0, 0, 0]], [1, [1, 1, 1]]], "blend": "perceptual" })"}});
    expect_value(ramp, sample("g", R"("$_Ramp")", "t.x"), "g", {0, 1, 0, 1},
                 {{"_Ramp", R"({ "colors": [[0, [1, 0, 0]], [1, [0, 1, 0]]], "blend": "fixed" })"}});
}

// With flat ends, a cubic from 0 to 1 is t * t * (3 - 2 t). With the slope 1 at both ends, it is the line.
TEST_F(ValuesTest, ACurveIsCubicBetweenItsKeys) {
    const std::string smooth = R"({ "keys": [[0, 0, 0, 0], [1, 1, 0, 0]] })";
    const std::string three = R"({ "keys": [[0, 1], [0.5, 3, 0, 4], [1, 5, 4, 0]] })";
    expect_value(
        "", curve("a", smooth, "t.x") + curve("b", smooth, "t.w") + curve("c", three, "t.x") + curve("d", three, "t.z"),
        "float4(a, b, c, d)", {0.15625f, 1, 2, 4});
    const std::string step = R"({ "keys": [[0, 1], [0.5, 1], [0.5, 2], [1, 2]] })";
    expect_value("", curve("a", step, "t.x") + curve("b", step, "t.z") + curve("c", R"({ "keys": [[0.5, 7]] })", "t.x"),
                 "float4(a, b, c, 0)", {1, 2, 7, 0});
    const std::string line = R"(, { "name": "_Line", "type": "curve" })";
    expect_value(line, curve("a", R"("$_Line")", "t.x") + curve("b", R"("$_Line")", "t.w"), "float4(a, b, 0, 0)",
                 {0.25f, 1, 0, 0});
    expect_value(line, curve("a", R"("$_Line")", "t.x") + curve("b", R"("$_Line")", "t.z"), "float4(a, b, 0, 0)",
                 {2, 4, 0, 0}, {{"_Line", three}});
}

TEST_F(ValuesTest, MatricesAreRows) {
    const std::string split =
        R"({ "id": "s", "node": "MatrixSplit", "in": { "matrix": [[1, 2, 3, 4], [5, 6, 7, 8], [9, 10, 11, 12], [13, 14, 15, 16]], "axis": ")";
    expect_value("", split + "Rows\" } },\n", "s.m1", {5, 6, 7, 8});
    expect_value("", split + "Columns\" } },\n", "s.m1", {2, 6, 10, 14});
    const std::string made =
        R"({ "id": "m", "node": "MatrixConstruction", "in": { "m0": [1, 2, 3, 4], "m1": [5, 6, 7, 8], "axis": ")";
    expect_value("", made + "Rows\" } },\n", "float4(mul(m.m2x2, t.xy), mul(m.m3x3, t.xyz).x, mul(m, t).y)",
                 {1.25f, 4.25f, 3.5f, 21.5f});
    expect_value("", made + "Columns\" } },\n", "float4(mul(m.m2x2, t.xy), mul(t.xy, m.m2x2))",
                 {2.75f, 3.5f, 1.25f, 4.25f});
}

TEST_F(ValuesTest, APropertyHoldsAMatrix) {
    const std::string properties =
        R"(, { "name": "_Two", "type": "float2x2", "default": [[1, 2], [3, 4]] }, { "name": "_Three", "type": "float3x3" },
            { "name": "_Four", "type": "float4x4" }, { "name": "_Behind", "type": "float", "default": 7 })";
    expect_value(properties, "", "float4(mul($_Two, t.xy), determinant($_Two), $_Behind)", {1.25f, 2.75f, -2, 7});
    expect_value(properties, "", "mul($_Four, t) + float4(mul($_Three, t.xyz), 0)", {0.5f, 1, 1.5f, 1.5f});
    const std::map<std::string, std::string> values = {
        {"_Three", "[[0, 1, 0], [0, 0, 1], [2, 0, 0]]"},
        {"_Four", "[[0, 0, 0, 1], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]"}};
    expect_value(properties, "", "float4(mul($_Three, t.xyz), 1)", {0.5f, 0.75f, 0.5f, 1}, values);
    expect_value(properties, "", "mul($_Four, t)", {1.5f, 0.25f, 0.5f, 0.75f}, values);
    expect_value(properties, "", "mul(t, $_Four)", {0.5f, 0.75f, 1.5f, 0.25f}, values);
}

// The matrix of the object is the node's, and a semantic goes through it.
TEST_F(ValuesTest, TheObjectsMatrixIsTheOneThatPlacesIt) {
    expect_value("", R"({ "id": "m", "node": "TransformationMatrix" },
)",
                 "float4(mul(m, float4(@positionOS, 1)).xyz - @positionWS, 1)", {0, 0, 0, 1});
}

TEST_F(ValuesTest, TheCamerasMatricesAreInversesOfEachOther) {
    const auto matrix = [](const std::string& id, const std::string& kind) {
        return R"({ "id": ")" + id + R"(", "node": "TransformationMatrix", "in": { "kind": ")" + kind + "\" } },\n";
    };
    expect_value("", matrix("m", "ViewToWorld"), "float4(mul(m, float4(@positionVS, 1)).xyz - @positionWS, 1)",
                 {0, 0, 0, 1});
    expect_value("", matrix("p", "ViewToClip") + matrix("c", "WorldToClip"),
                 "float4((mul(p, float4(@positionVS, 1)) - mul(c, float4(@positionWS, 1))).xyw, 1)", {0, 0, 0, 1});
    expect_value("", matrix("p", "ViewToClip") + matrix("v", "ClipToView"), "mul(v, mul(p, float4(1, 2, -3, 1)))",
                 {1, 2, -3, 1});
}

TEST_F(ValuesTest, APointIsSeenAtItsPixel) {
    const std::string seen = R"({ "id": "s", "node": "Transform", "in": { "vector": "@positionOS", "to": "Screen" } },
)";
    expect_value("", seen, "float4(s.xy - @screenUV, 0, 1)", {0, 0, 0, 1});
    expect_value("", seen + R"({ "id": "w", "node": "Transform", "in": { "vector": "s", "from": "Screen" } },
)",
                 "float4(w - @positionWS, 1)", {0, 0, 0, 1});
}

// As vectors are: where a node computes in halves, and reads or makes a matrix of floats.
TEST_F(ValuesTest, AMatrixOfFloatsIsConvertedToHalves) {
    const std::string half = R"(, "precision": "half" },
)";
    const std::string split =
        R"json({ "id": "s", "node": "MatrixSplit", "in": { "matrix": "= float4x4(t, t * 2, t, t)" })json";
    expect_value("", split + half, "s.m1", {0.5f, 1, 1.5f, 3});
    expect_value("", R"({ "id": "m", "node": "TransformationMatrix")" + half,
                 "float4(mul(m, float4(@positionOS, 1)).xyz - @positionWS, 1)", {0, 0, 0, 1});
}

TEST_F(ValuesTest, AnUnsignedNumberIsItsOwnAbsoluteValue) {
    expect_value("", "", "float4(abs(uint(t.w * 2)), abs(int(t.x * -8)), abs(1013904223u) > 0u ? 1 : 0, abs(-t.x))",
                 {3, 2, 1, 0.25f});
}

}  // namespace
}  // namespace patina::witness
