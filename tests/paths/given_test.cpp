// What a pass file gives to a pass takes effect in both stages: an object whose position the pass changes is drawn, lit
// and textured where an object that stands there is. On the GPU and the CPU.
#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>

#include "paths/drawing/checkerboard.h"

namespace patina::paths {
namespace {

// A path of one forward pass, with these declarations in front of it.
std::string path_with(const std::string& name, const std::string& declarations) {
    return written(name + ".pass.hlsl", declarations + R"(
[pass("given")] [vertex]
float4 givenVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("given")] [fragment]
float4 givenFragment(float3 position = positionWS) {
    return float4(litByAll(lightingSurface(), position), 1);
}
)");
}

// A plane that shows the texture coordinates and the position of each of its points.
World plane(const glm::mat4& place) {
    World world = checkerboard();
    world.objects.clear();
    const std::string graph = written("shown.graph.json", R"({ "patina": 1, "workflow": "unlit",
  "nodes": [ { "id": "shown", "expr": "float3(@uv0, @positionWS.x + 1) " } ],
  "surface": { "color": "shown" } })");
    add_object(world, graph, "plane", 4, place);
    return world;
}

void expect_alike(const std::string& path, const World& given, const World& meant) {
    const std::string usual = path_with("usual", "");
    for (const char* via : {"glsl", "cpu"}) {
        SCOPED_TRACE(via);
        const Image expected = draw(meant, {.path = usual, .via = via, .exact_targets = true});
        const Image image = draw(given, {.path = path, .via = via, .exact_targets = true});
        EXPECT_GT(lit_pixels(expected), 100);
        EXPECT_SAME_PICTURE(image, expected);
    }
}

const glm::mat4 kHere(1), kHalf = glm::scale(glm::mat4(1), glm::vec3(0.5f));

TEST(Given, APositionOfTheMeshMovesTheObject) {
    expect_alike(path_with("halved", R"([gives("positionOS", "given")]
float3 halved(float3 position = positionOS) { return 0.5 * position; })"),
                 plane(kHere), plane(kHalf));
}

TEST(Given, APositionInTheWorldMovesTheObject) {
    expect_alike(path_with("halved_world", R"([gives("positionWS", "given")]
float3 halved(float3 position = positionWS) { return 0.5 * position; })"),
                 plane(kHere), plane(kHalf));
}

// The vertex function reads the mesh's position first, and the recipe reads the usual position in the world.
TEST(Given, WhatARecipeReadsIsNotWhatOthersRead) {
    const std::string path = written("early.pass.hlsl", R"(
[gives("positionOS", "early")]
float3 halved(float3 position = positionOS, float3 world = positionWS) { return position - 0.5 * world; }
[pass("early")] [vertex]
float4 earlyVertex(float3 own = positionOS, float3 position = positionWS) {
    return mul(worldToClip, float4(0.5 * (own + position), 1));
}
[pass("early")] [fragment]
float4 earlyFragment(float3 position = positionWS) {
    return float4(litByAll(lightingSurface(), position), 1);
})");
    expect_alike(path, plane(kHere), plane(kHalf));
}

TEST(Given, WithFragmentTheVertexStageKeepsItsOwn) {
    World world = checkerboard();
    add_object(world, written("place.graph.json", R"({ "patina": 1, "workflow": "unlit",
  "surface": { "color": "@positionWS" } })"),
               "plane", 4, kHere);
    const std::string path = path_with("in_pixels", R"([gives("positionWS", "given")] [fragment]
float3 onTheScreen(float2 uv = screenUV) { return float3(uv, 0.25); })");
    const Image image = draw(world, {.path = path, .exact_targets = true});
    for (const int x : {0, 9, 31}) {
        const auto pixel = image.at(x, 7);
        EXPECT_NEAR(pixel[0], (x + 0.5) / kBoardPixels, 1e-4);
        EXPECT_NEAR(pixel[1], 7.5 / kBoardPixels, 1e-4);
        EXPECT_NEAR(pixel[2], 0.25, 1e-4);
    }
}

// A function that only another replacement calls is replaced, too, in whatever order a file has them.
TEST(Given, AFunctionIsReplacedWhoeverCallsIt) {
    const std::string shadow = R"([gives("shadow", "ambient")]
float quarter(int index, float3 position) { return 0.25; }
)";
    const std::string ambient = R"([gives("AmbientIrradiance", "ambient")]
float3 shadowed(float3 normal, float3 position = positionWS) { return float3(2 * shadow(1, position)); }
)";
    const std::string pass = R"([pass("ambient")] [vertex]
float4 ambientVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("ambient")] [fragment] [lights("none")]
float4 ambientFragment() {
    return float4(AmbientIrradiance(float3(0, 1, 0)), 1);
}
)";
    int number = 0;
    for (const std::string& both : {shadow + ambient, ambient + shadow}) {
        World world = plane(kHere);
        const std::string path = written(fmt::format("functions_{}.pass.hlsl", number++), both + pass);
        EXPECT_NEAR(draw(world, {.path = path, .exact_targets = true}).at(5, 5)[0], 0.5, 1e-4);
    }
}

}  // namespace
}  // namespace patina::paths
