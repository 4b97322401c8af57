// Nodes that read textures, against a closed form: 32 x 32 pixels, the GPU through both languages and the CPU in both
// precisions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "witness/pixels.h"

namespace patina::witness {
namespace {

class TextureNodesTest : public PixelsTest {};

constexpr int kTexels = 64, kLevels = 7;

// Every texel of a level is the level's number.
std::shared_ptr<const TextureData> numbered_levels() {
    TextureData data{.levels = {}, .sampler = {.wrap = Wrap::Repeat, .filter = Filter::Nearest}};
    for (int level = 0; level < kLevels; ++level) {
        const int side = kTexels >> level;
        const Image image = runtime::make_image(side, side, static_cast<float>(level));
        data.levels.push_back({.width = side, .height = side, .texels = image.pixels});
    }
    return std::make_shared<const TextureData>(std::move(data));
}

// Red is the column, green the row, of one level; repeats.
std::shared_ptr<const TextureData> numbered_texels(int side) {
    Image image = runtime::make_image(side, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            image.at(x, y)[0] = static_cast<float>(x);
            image.at(x, y)[1] = static_cast<float>(y);
            image.at(x, y)[2] = static_cast<float>(x * side + y);
        }
    }
    TextureData data{.levels = {}, .sampler = {.wrap = Wrap::Repeat, .filter = Filter::Nearest}};
    data.levels.push_back({.width = side, .height = side, .texels = image.pixels});
    return std::make_shared<const TextureData>(std::move(data));
}

std::shared_ptr<const TextureData> plain(float r, float g, float b) {
    return texture_of(runtime::make_image(1, 1, r, g, b));
}

double wrapped(int place, int side) {
    return (place % side + side) % side;
}

TEST_F(TextureNodesTest, LevelsFollowBiasAndDerivatives) {
    // Four texels a pixel: level 2.
    const auto witnesses = all_witnesses(
        R"({ "id": "at", "expr": "@fragCoord.xy * 4 / 64" })",
        "float3(SampleTexture2DBias($_Data, at, 1).r, SampleTexture2DGrad($_Data, at, float2(0, 0.125), 0).r, "
        "CalculateLevel($_Data, at))"
        " + float3(0, 0, CalculateLevel($_Data, at * 0.125, Unclamped))",
        "SampleTexture2DBias($_Data, at, -1.0).r", numbered_levels());
    expect_all(witnesses, 0.05, [](int, int) -> std::array<double, 4> { return {3, 3, 2 - 1, 1}; });
}

TEST_F(TextureNodesTest, TheLevelIsLimitedToThoseThatThereAre) {
    const auto witnesses = all_witnesses(
        R"({ "id": "at", "expr": "@fragCoord.xy" })",
        "float3(CalculateLevel($_Data, at * 16), CalculateLevel($_Data, at / 256), SplitTextureTransform($_Data).x)",
        "SplitTextureTransform($_Data).offset.y", numbered_levels());
    expect_all(witnesses, 0.05, [](int, int) -> std::array<double, 4> { return {6, 0, 1, 0}; });
}

// Every texel of a layer and a level: ten times the layer, and the level.
std::shared_ptr<const TextureData> numbered_layers(int layers) {
    TextureData data{.levels = {}, .sampler = {.wrap = Wrap::Repeat, .filter = Filter::Nearest}, .layers = layers};
    for (int level = 0; level < kLevels; ++level) {
        const int side = kTexels >> level;
        TextureLevel made{.width = side, .height = side, .texels = {}};
        for (int layer = 0; layer < layers; ++layer) {
            const Image image = runtime::make_image(side, side, static_cast<float>(10 * layer + level));
            made.texels.insert(made.texels.end(), image.pixels.begin(), image.pixels.end());
        }
        data.levels.push_back(std::move(made));
    }
    return std::make_shared<const TextureData>(std::move(data));
}

TEST_F(TextureNodesTest, LayersFollowBiasAndDerivatives) {
    const auto witnesses = on_the_cpu(R"({ "name": "_Data", "type": "texture2dArray" })",
                                      R"({ "id": "at", "expr": "@fragCoord.xy * 4 / 64" })",
                                      "float3(SampleTexture2DArrayBias($_Data, at, 2, 1).r, "
                                      "SampleTexture2DArrayGrad($_Data, at, 1, float2(0, 0.25), 0).r, 0)",
                                      numbered_layers(3));
    expect_all(witnesses, 0, [](int, int) -> std::array<double, 4> { return {20 + 3, 10 + 4, 0, 1}; });
}

TEST_F(TextureNodesTest, AMirrorReadsTheOtherSideOfACube) {
    // The sides are +x, -x, +y, -y, +z, -z.
    const auto witnesses = on_the_cpu(R"({ "name": "_Data", "type": "textureCube" })",
                                      R"json({ "id": "up", "expr": "float3(0, 1, 0)" })json",
                                      "float3(SampleReflectedCubemap($_Data, float3(0.8, 0.6, 0), up, 2).r, "
                                      "SampleReflectedCubemap($_Data, float3(0.1, 0.9, 0), up).r, "
                                      "SampleReflectedCubemap($_Data, float3(0, -1, 0), up).r)",
                                      numbered_layers(6));
    expect_all(witnesses, 0, [](int, int) -> std::array<double, 4> { return {10 + 2, 20, 30, 1}; });
}

TEST_F(TextureNodesTest, GatherReadsTheFourTexelsOfABilinearFilter) {
    const auto witnesses =
        all_witnesses(R"json({ "id": "four", "expr": "GatherTexture2D($_Data, @fragCoord.xy / 16, float2(1, 0))" },
{ "id": "rows", "expr": "GatherTexture2D($_Data, @fragCoord.yx / 16)" })json",
                      "float3(four.x, four.y, four.z - four.w)", "rows.w", numbered_texels(16));
    expect_all(witnesses, 1e-3, [](int x, int y) -> std::array<double, 4> {
        // The pixel's centre is a texel's centre: its texel is the upper left one.
        const double left = wrapped(x + 1, 16), right = wrapped(x + 2, 16);
        return {left, right, right - left, wrapped(y, 16)};
    });
}

TEST_F(TextureNodesTest, TriplanarReadsTheSideThatTheSurfaceFaces) {
    const auto witnesses = all_witnesses(
        R"json({ "id": "p", "expr": "float3(@fragCoord.x, @fragCoord.y, 3.5) / 16" },
{ "id": "top", "expr": "Triplanar($_Data, p, float3(0, 1, 0))" },
{ "id": "front", "expr": "Triplanar($_Data, p, float3(0, 0, -1))" },
{ "id": "side", "expr": "Triplanar($_Data, p, float3(1, 0, 0))" })json",
        "float3(top.r + top.g * 100, front.r + front.g * 100, side.r + side.g * 100)", "1", numbered_texels(16));
    expect_all(witnesses, 1e-2, [](int x, int y) -> std::array<double, 4> {
        // The texture's top is towards +z from above, and up on walls: its rows count down.
        const double column = wrapped(x, 16), up = wrapped(-1 - y, 16), z = wrapped(-1 - 3, 16);
        return {column + z * 100, column + up * 100, 3 + up * 100, 1};
    });
}

TEST_F(TextureNodesTest, TriplanarNormalsAddTheirSlopes) {
    // The texel (0.8, 0.6) is the slope (0.6, 0.2) with z = sqrt(0.6).
    const auto witnesses = all_witnesses(
        R"json({ "id": "flat", "expr": "TriplanarNormal($_Data, @positionWS, float3(0, 1, 0), 1, 4, 1, World)" })json",
        "flat", "TriplanarNormal($_Data, @positionWS, float3(0, 0, 1), 1, 4, 1, World).y", plain(0.8f, 0.6f, 1));
    const double z = std::sqrt(1 - 0.36 - 0.04);
    expect_all(witnesses, 1e-4, [&](int, int) -> std::array<double, 4> { return {0.6, z, 0.2, 0.2}; });
}

TEST_F(TextureNodesTest, FlowBlendsTwoPlaces) {
    const auto witnesses =
        all_witnesses(R"json({ "id": "at", "expr": "@fragCoord.xy / 16" })json",
                      "SampleFlow($_Data, at, float2(1, 0), 0.25, 1, 1).rgb", "1", numbered_texels(16));
    expect_all(witnesses, 1e-3, [](int x, int y) -> std::array<double, 4> {
        // A quarter of a cycle: the first copy is a quarter texture ahead, the second one behind, and half a texture
        // away.
        const double first = wrapped(x + 4, 16), second = wrapped(x - 4 + 8, 16);
        const double upper = wrapped(y, 16), lower = wrapped(y + 8, 16);
        return {(first + second) / 2, (upper + lower) / 2, (first * 16 + upper + second * 16 + lower) / 2, 1};
    });
}

TEST_F(TextureNodesTest, FlowReadsThroughItsSampler) {
    const auto witnesses =
        all_witnesses(R"json({ "id": "at", "expr": "@fragCoord.xy / 16" })json",
                      "SampleFlow($_Data, at, float2(1, 0), 0.25, 1, 1, nearestClamp).rgb", "1", numbered_texels(16));
    expect_all(witnesses, 1e-3, [](int x, int y) -> std::array<double, 4> {
        const auto edged = [](int place) -> double { return std::clamp(place, 0, 15); };
        const double first = edged(x + 4), second = edged(x + 4), upper = edged(y), lower = edged(y + 8);
        return {(first + second) / 2, (upper + lower) / 2, (first * 16 + upper + second * 16 + lower) / 2, 1};
    });
}

// Red is 1 at the right edge and in the middle, which is the mean of a texture with one level, and 0 elsewhere. Far
// beyond the edge, a clamped texture is 1 everywhere.
TEST_F(TextureNodesTest, TilingWithoutRepetitionReadsThroughItsSampler) {
    Image image = runtime::make_image(16, 16, 0, 0.5f, 1);
    for (int y = 0; y < 16; ++y) image.at(15, y)[0] = 1;
    for (int y = 7; y < 9; ++y) image.at(7, y)[0] = image.at(8, y)[0] = 1;
    TextureData data{.levels = {}, .sampler = {.wrap = Wrap::Repeat, .filter = Filter::Nearest}};
    data.levels.push_back({.width = 16, .height = 16, .texels = image.pixels});
    const auto witnesses = all_witnesses(
        R"json({ "id": "at", "expr": "@fragCoord.xy / 16 + 8" })json",
        "float3(HexTiling($_Data, at, 3, 0, 0.6, 7, nearestClamp).r, StochasticTiling($_Data, at, 3, nearestClamp).r, "
        "HexTilingNormal($_Data, at, 3, 0, 7, 1, nearestClamp).x)",
        "1", std::make_shared<const TextureData>(std::move(data)));
    // The bump lies on its side: its slope is limited to 1 / 0.05.
    const double x = 20 / std::sqrt(20 * 20 + 1);
    expect_all(witnesses, 1e-4, [&](int, int) -> std::array<double, 4> { return {1, 1, x, 1}; });
}

TEST_F(TextureNodesTest, ParallaxMovesByHeightAndView) {
    const auto witnesses = all_witnesses(
        R"json({ "id": "view", "expr": "float3(0.6, 0, 0.8)" },
{ "id": "one", "expr": "ParallaxMapping($_Data, float2(0, 0), 8, Blue, view)" },
{ "id": "deep", "expr": "ParallaxOcclusionMapping($_Data, float2(0.5, 0.5), 8, 5, float2(1, 1), float2(0, 0), float2(1, 1), 0, 0, Green, view)" },
{ "id": "faded", "expr": "ParallaxOcclusionMapping($_Data, float2(0.5, 0.5), 8, 5, float2(1, 1), float2(0, 0), float2(1, 1), 3, 2, Green, view)" })json",
        "float3(one.x, deep.x - 0.5, deep.depthOffset)", "faded.x", plain(0.25f, 0, 1));
    expect_all(witnesses, 1e-4, [](int, int) -> std::array<double, 4> {
        return {0.04 * 0.6 / (0.8 + 0.42), -0.08 * 0.6 / 0.8, 0.08 / 0.8, 0.5};
    });
}

// glslang makes blocks of a choice between sums, and SPIR-V forbids to join texture and sampler in another block than
// the one that samples.
TEST_F(TextureNodesTest, ACoordinateMayBeAChoice) {
    const auto witnesses = all_witnesses(R"json({ "id": "at", "expr": "@fragCoord.xy * 0.37" })json",
                                         "float3(SampleTexture2D($_Data, at.x > 2 ? at * 2 : at.yx + 1).r, 0, 0)", "1",
                                         plain(0.8f, 0.6f, 1));
    expect_all(witnesses, 1e-4, [](int, int) -> std::array<double, 4> { return {0.8, 0, 0, 1}; });
}

TEST_F(TextureNodesTest, TilingWithoutRepetitionKeepsAPlainTexture) {
    const auto witnesses = all_witnesses(
        R"json({ "id": "at", "expr": "@fragCoord.xy * 0.37" })json",
        "float3(HexTiling($_Data, at, 2, 3).r, StochasticTiling($_Data, at).g, HexTilingNormal($_Data, at, 2, 0).x)",
        "HexTilingNormal($_Data, at, 2, 0).z", plain(0.8f, 0.6f, 1));
    expect_all(witnesses, 1e-4, [](int, int) -> std::array<double, 4> {
        return {0.8, 0.6, 0.6, std::sqrt(1 - 0.36 - 0.04)};
    });
}

// Noise of the mean 0.5 without neighbours that resemble each other.
std::shared_ptr<const TextureData> bell(int side) {
    TextureData data{.levels = {}, .sampler = {.wrap = Wrap::Repeat, .filter = Filter::Nearest}};
    Image image = runtime::make_image(side, side, 0.5f);
    std::uint32_t state = 1;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            float sum = 0;
            for (int i = 0; i < 12; ++i) {
                state = state * 1664525u + 1013904223u;
                sum += static_cast<float>(state >> 8) / static_cast<float>(1 << 24) - 0.5f;
            }
            image.at(x, y)[0] = 0.5f + 0.1f * sum;
        }
    }
    data.levels.push_back({.width = side, .height = side, .texels = image.pixels});
    for (int level = side / 2; level >= 1; level /= 2)
        data.levels.push_back(
            {.width = level, .height = level, .texels = runtime::make_image(level, level, 0.5f).pixels});
    return std::make_shared<const TextureData>(std::move(data));
}

TEST_F(TextureNodesTest, StochasticTilingKeepsMeanAndContrast) {
    const auto witnesses = all_witnesses(R"json({ "id": "at", "expr": "@fragCoord.xy * 1.0 / 64" })json",
                                         "float3(StochasticTiling($_Data, at, 40).r, SampleTexture2D($_Data, at).r, 0)",
                                         "1", bell(kTexels));
    ASSERT_EQ(witnesses.size(), 4u);
    for (const auto& [name, image] : witnesses) {
        double sum = 0, squares = 0;
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                const double value = static_cast<double>(image.at(x, y)[0]);
                sum += value, squares += value * value;
            }
        }
        const double mean = sum / (kSide * kSide), deviation = std::sqrt(squares / (kSide * kSide) - mean * mean);
        EXPECT_NEAR(mean, 0.5, 0.015) << name;
        EXPECT_NEAR(deviation, 0.1, 0.01) << name;
    }
}

}  // namespace
}  // namespace patina::witness
