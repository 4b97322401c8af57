// The node Transform against what the stages compute: a stretched and turned cube before a camera that looks down at
// it. Each graph adds up how far a vector is off in all of its forms; every pixel that the cube covers must say zero.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "runtime/scene/scene.h"
#include "witness/bench.h"

namespace patina::witness {
namespace {

runtime::Scene stretched_cube() {
    runtime::Scene scene = runtime::default_scene("cube");
    scene.object_to_world = glm::translate(glm::mat4(1), {0.3f, -0.2f, 0.5f}) *
                            glm::rotate(glm::mat4(1), 0.7f, glm::normalize(glm::vec3(1, 2, 0.5f))) *
                            glm::scale(glm::mat4(1), {1.5f, 0.5f, 0.8f});
    scene.camera = {.position = {2, 3, 4}, .target = {0.2f, 0, 0.3f}};
    scene.width = scene.height = 24;
    scene.background = glm::vec4(0);
    return scene;
}

// `off`: an expression that is zero.
void expect_zero(const std::string& off) {
    Bench bench;
    const auto material =
        bench.compile(R"({ "patina": 1, "workflow": "unlit", "nodes": [ { "id": "off", "expr": ")" + off +
                      R"json(" } ], "surface": { "color": "= float3(length(off), 1, 0)", "alpha": "= 1" } })json");
    ASSERT_TRUE(material);
    const runtime::Scene scene = stretched_cube();
    const Inputs inputs{.scene = &scene};
    const std::pair<const char*, Image> drawn[] = {{"GLSL", bench.draw(*material, Target::Glsl, inputs)},
                                                   {"HLSL", bench.draw(*material, Target::Hlsl, inputs)},
                                                   {"the CPU", bench.run(*material, Precision::Double, inputs)}};
    for (const auto& [name, image] : drawn) {
        int covered = 0;
        float most = 0;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                if (image.at(x, y)[1] != 1) continue;
                ++covered;
                most = std::max(most, image.at(x, y)[0]);
            }
        }
        EXPECT_GT(covered, 100) << name;
        EXPECT_LT(most, 2e-5f) << name << ": " << off;
    }
    bench.expect_silence();
}

TEST(Transform, MovesPositions) {
    expect_zero("Transform(@positionOS, Object, World) - @positionWS");
    expect_zero("Transform(@positionWS, World, Object) - @positionOS");
    expect_zero("Transform(@positionWS, World, View) - @positionVS");
    expect_zero("Transform(@positionVS, View, World) - @positionWS");
    expect_zero("Transform(@positionOS, Object, View) - @positionVS");
    expect_zero("Transform(@positionVS, View, Object) - @positionOS");
    expect_zero("Transform(@positionVS, View, Tangent)");
    expect_zero("Transform(float3(0), Tangent, Object) - @positionOS");
}

TEST(Transform, TurnsNormalsAndDirections) {
    expect_zero("Transform(@normalOS, Object, World, Normal) - @geometryNormalWS");
    expect_zero("Transform(@geometryNormalWS, World, Object, Normal) - @normalOS");
    expect_zero("Transform(@normalOS, Object, View, Normal) - @normalVS");
    expect_zero("Transform(@normalVS, View, Tangent, Normal) - float3(0, 0, 1)");
    expect_zero("Transform(@tangentOS.xyz, Object, World, Direction) - @tangentWS");
    expect_zero("Transform(@tangentWS, World, Object, Direction) - @tangentOS.xyz");
    expect_zero("Transform(float3(1, 0, 0), Tangent, World, Direction) - @tangentWS");
    expect_zero("Transform(@viewDirWS, World, View, Direction) + normalize(@positionVS)");
    // A direction that is stretched twice and back keeps its length if it is not normalized.
    expect_zero(
        "Transform(Transform(float3(1, 2, 3), Object, World, Direction, false), World, Object, Direction, "
        "false) - float3(1, 2, 3)");
}

}  // namespace
}  // namespace patina::witness
