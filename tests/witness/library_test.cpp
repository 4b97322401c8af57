// Every `test:` line of the library, three times: by the CPU interpreter in double, and on the GPU through GLSL and
// through HLSL. On the GPU the arguments come out of a texture, one test a pixel.
#include <gtest/gtest.h>

#include <cmath>

#include "witness/bench.h"
#include "witness/node_tests.h"

namespace patina::witness {
namespace {

// Nodes without a test line, and why they can have none. What is not here must have one.
struct Exempt {
    std::string_view node, reason;
};
constexpr Exempt kExempt[] = {
    {"AmbientIrradiance", "reads the scene's ambient light; EvaluateSH9, which it calls, is tested"},
    {"EnvironmentRadiance", "reads the scene's environment; environment_test looks at what is in it"},
    {"SceneColor", "reads what was drawn before"},
    {"SceneThroughRoughSurface", "reads what was drawn before; the example flint_glass draws with it"},
    {"ScreenFromWorld", "reads the camera; the example flint_glass draws with it"},
    {"SceneDepth", "reads what was drawn before"},
    {"SplitSumTable", "reads a table; environment_test compares it with the integral"},
    {"SampleShadowTent5x5", "reads a shadow map; pass_functions_test compares it with an integral"},
    {"CookieAttenuation", "reads a texture; pass_functions_test draws with it"},
    {"MeasuredBRDF", "reads a table; merl_test compares it with the BRDF that its table was sampled from"},
    {"LoadTexture2D", "reads a texture; every other test here reads its arguments by it"},
    {"DDX", "a difference between pixels; quads_test draws with it"},
    {"DDXY", "a difference between pixels; quads_test draws with it"},
    {"DDY", "a difference between pixels; quads_test draws with it"},
    {"NormalFromHeight", "differences between pixels; quads_test draws with it"},
    {"NormalFromTexture", "reads a texture; quads_test draws with it"},
    {"MatrixConstruction", "gives matrices; values_test draws with it"},
    {"MatrixSplit", "takes a matrix; values_test draws with it"},
    {"TransformationMatrix", "reads the object and the camera; values_test draws with it"},
    {"SampleCurve", "takes a curve; values_test draws with it"},
    {"SampleGradient", "takes a gradient; values_test draws with it"},
    {"ParallaxOcclusion", "reads a texture; parallax_test compares it with the geometry of its reliefs"},
    {"SampleNormalMap", "reads a texture; UnpackNormal, which it calls, is tested"},
    {"SampleTexture2DArray", "reads a texture; orientation_test draws with it"},
    {"SampleTexture2DArrayLevel", "reads a texture; the pictures of Unity's files draw with it"},
    {"SampleTexture3D", "reads a texture; orientation_test draws with it"},
    {"SampleTexture3DLevel", "reads a texture; the pictures of Unity's files draw with it"},
    {"SampleTextureCube", "reads a texture; orientation_test draws with it"},
    {"SampleTextureCubeLevel", "reads a texture; orientation_test draws with it"},
    {"SampleTexture2D", "reads a texture; quads_test draws with it"},
    {"SampleTexture2DMoved", "reads a texture; quads_test draws with it"},
    {"SampleTexture2DLevel", "reads a texture; quads_test draws with it"},
    {"Ambient", "reads the scene's ambient light; EvaluateSH9, which it calls, is tested"},
    {"CalculateLevel", "uses derivatives; texture_nodes_test compares it with Vulkan's rule"},
    {"DepthFade", "reads what was drawn before"},
    {"Fog", "reads the scene's fog; FogFactor, which it calls, is tested"},
    {"GatherTexture2D", "reads a texture; texture_nodes_test compares it with the texels"},
    {"HexTiling", "reads a texture; texture_nodes_test draws with it"},
    {"HexTilingNormal", "reads a texture; texture_nodes_test draws with it"},
    {"ParallaxMapping", "reads a texture; texture_nodes_test draws with it"},
    {"ParallaxOcclusionMapping", "reads a texture; texture_nodes_test draws with it"},
    {"ReflectionProbe", "reads the scene's environment"},
    {"SampleFlow", "reads a texture; texture_nodes_test draws with it"},
    {"SampleReflectedCubemap", "reads a texture; texture_nodes_test draws with it"},
    {"SampleTexture2DArrayBias", "reads a texture; texture_nodes_test draws with it"},
    {"SampleTexture2DArrayGrad", "reads a texture; texture_nodes_test draws with it"},
    {"SampleTexture2DBias", "reads a texture; texture_nodes_test draws with it"},
    {"SampleTexture2DGrad", "reads a texture; texture_nodes_test draws with it"},
    {"SceneDepthDifference", "reads what was drawn before"},
    {"SceneDepthLinear01", "reads what was drawn before"},
    {"SceneDepthRaw", "reads what was drawn before"},
    {"SdfMask", "uses derivatives; shapes_test compares it with the coverage of pixels"},
    {"SplitTextureTransform", "reads a texture; texture_nodes_test draws with it"},
    {"StochasticTiling", "reads a texture; texture_nodes_test compares its contrast with the texture's"},
    {"Triplanar", "reads a texture; texture_nodes_test draws with it"},
    {"TriplanarNormal", "reads a texture; texture_nodes_test draws with it"},
    {"TexelSize", "reads a texture; quads_test draws with it"},
};

// Null if the node must have test lines.
const Exempt* exemption_of(const NodeInfo& node) {
    const auto* found = std::find_if(std::begin(kExempt), std::end(kExempt),
                                     [&](const Exempt& candidate) { return candidate.node == node.name; });
    return found == std::end(kExempt) ? nullptr : found;
}

class LibraryTest : public testing::Test {
protected:
    static void SetUpTestSuite() { bench = std::make_unique<Bench>(); }
    static void TearDownTestSuite() { bench.reset(); }
    static inline std::unique_ptr<Bench> bench;

    std::vector<NodeTest> all_tests() const {
        std::vector<NodeTest> tests;
        for (const NodeInfo& node : bench->compiler().nodes())
            for (NodeTest& test : bench->compiler().tests(node.name)) tests.push_back(std::move(test));
        return tests;
    }
};

TEST_F(LibraryTest, EveryNodeHasTestsOrAReasonForNone) {
    std::size_t exempt = 0;
    for (const NodeInfo& node : bench->compiler().nodes()) {
        const Exempt* found = exemption_of(node);
        EXPECT_NE(bench->compiler().tests(node.name).empty(), !found) << node.name;
        if (!found) continue;
        std::printf("without a test line: %s (%s)\n", node.name.c_str(), std::string(found->reason).c_str());
        ++exempt;
    }
    EXPECT_EQ(exempt, std::size(kExempt)) << "the list names a node that is not there";
}

TEST_F(LibraryTest, EveryWordOfADropDownIsTested) {
    const std::vector<NodeTest> tests = all_tests();
    for (const NodeInfo& node : bench->compiler().nodes()) {
        if (exemption_of(node)) continue;
        for (const PortInfo& port : node.ports) {
            for (const auto& [word, doc] : port.enumerators) {
                const bool is_default = port.default_value == word;
                const auto uses = [&, &word = word](const NodeTest& test) {
                    if (test.node != node.name) return false;
                    const auto given = std::find_if(test.arguments.begin(), test.arguments.end(),
                                                    [&](const NodeTest::Argument& a) { return a.name == port.name; });
                    return given == test.arguments.end() ? is_default : given->enumerator == word;
                };
                EXPECT_TRUE(std::any_of(tests.begin(), tests.end(), uses)) << node.name << ": " << word;
            }
        }
    }
}

TEST_F(LibraryTest, OnTheCpuInDouble) {
    for (const NodeTest& test : all_tests()) expect_passed(test, "the CPU");
}

TEST_F(LibraryTest, OnTheGpuThroughGlslAndHlsl) {
    std::size_t count = 0;
    for (const NodeInfo& node : bench->compiler().nodes()) {
        for (const Batch& batch : batches_of(bench->compiler().tests(node.name))) {
            const NodeTest& first = batch.tests[0];
            const auto port = std::find_if(node.ports.begin(), node.ports.end(),
                                           [&](const PortInfo& p) { return p.is_output && p.name == first.output; });
            // A line that could not be read has failed on the CPU already.
            if (port == node.ports.end() || first.actual.empty()) continue;
            const auto material = bench->compile(graph_of(batch, first.actual.size(), port->type == "bool"));
            if (!material) continue;
            count += expect_passed_when_drawn(*bench, *material, batch);
        }
    }
    // Each line was drawn twice.
    EXPECT_EQ(count, 2 * all_tests().size());
    bench->expect_silence();
}

// Arguments that a formula seldom meets still arrive as what they are.
TEST_F(LibraryTest, NanAndInfinityPassThrough) {
    NodeTest test;
    test.node = "Constant";
    test.arguments = {{.name = "value", .type = "float4", .values = {}, .enumerator = {}}};
    Batch batch{.expression = "Constant(a0)", .tests = {test}};
    const auto material = bench->compile(graph_of(batch, 4, false));
    ASSERT_TRUE(material);
    const double infinity = INFINITY;
    batch.tests[0].arguments[0].values = {NAN, infinity, -infinity, 1e-30};
    const Inputs inputs{.data = texture_of(arguments_of(batch))};
    for (const Image& image :
         {bench->draw(*material, Target::Glsl, inputs), bench->draw(*material, Target::Hlsl, inputs),
          bench->run(*material, Precision::Double, inputs)}) {
        ASSERT_EQ(image.pixels.size(), 4u);
        EXPECT_TRUE(std::isnan(image.pixels[0]));
        EXPECT_EQ(image.pixels[1], INFINITY);
        EXPECT_EQ(image.pixels[2], -INFINITY);
        EXPECT_EQ(image.pixels[3], 1e-30f);
    }
    bench->expect_silence();
}

}  // namespace
}  // namespace patina::witness
