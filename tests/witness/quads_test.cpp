// What a pixel learns from its neighbours in the 2 x 2 quad: derivatives, the mip level of a sample, and values that
// come out of loops of different length. 32 x 32 pixels, the GPU through both languages and the CPU in both precisions,
// each against a closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "witness/pixels.h"

namespace patina::witness {
namespace {

class QuadsTest : public PixelsTest {};

// With b the centre of the quad's left (upper) pixel, (b + 1)^2 - b^2 = 2 b + 1 is the difference in both of its
// columns (rows). All of it is exact in floats.
TEST_F(QuadsTest, DerivativesAreDifferencesWithinTheQuad) {
    const auto witnesses = all_witnesses(R"({ "id": "p", "expr": "@fragCoord.xy" })",
                                         "float3(ddx(p.x * p.y), ddy(p.x * p.y), ddx(p.x * p.x * p.y))",
                                         "fwidth(p.x * p.x + p.y * p.y * 0.5)", white());
    expect_all(witnesses, 0, [](int column, int row) -> std::array<double, 4> {
        const double x = column + 0.5, y = row + 0.5;
        const double left = column / 2 * 2 + 0.5, upper = row / 2 * 2 + 0.5;
        return {y, x, (2 * left + 1) * y, (2 * left + 1) + (2 * upper + 1) / 2};
    });
}

// The nodes are the functions.
TEST_F(QuadsTest, NodesOfDerivatives) {
    const auto witnesses = all_witnesses(R"json({ "id": "p", "expr": "@fragCoord.xy" },
        { "id": "right", "node": "DDX", "in": { "value": "= p.x * p.y" } },
        { "id": "down", "node": "DDY", "in": { "value": "= p.x * p.y" } },
        { "id": "both", "node": "DDXY", "in": { "value": "= float2(p.x * p.y, p.x - 2 * p.y)" } })json",
                                         "float3(right, down, both.x)", "both.y", white());
    expect_all(witnesses, 0, [](int column, int row) -> std::array<double, 4> {
        const double x = column + 0.5, y = row + 0.5;
        return {y, x, x + y, 3};
    });
}

// --- normals

// The screen is a plane that faces the camera. A height that grows by (a, b) for each metre to the right and up tilts
// its normal by as much the other way; a metre is told in pixels by the derivative of the place.
TEST_F(QuadsTest, NormalFromHeightLeansAgainstTheSlope) {
    const auto witnesses = all_witnesses(R"json(
        { "id": "right", "expr": "normalize(ddx(@positionWS))" }, { "id": "up", "expr": "-normalize(ddy(@positionWS))" },
        { "id": "height", "expr": "dot(@positionWS, right) * 30 + dot(@positionWS, up) * 40" },
        { "id": "world", "node": "NormalFromHeight", "in": { "height": "height", "space": "World" } },
        { "id": "tangent", "node": "NormalFromHeight", "in": { "height": "height", "strength": 0.02 } },
        { "id": "back", "expr": "NormalTangentToWorld(tangent)" })json",
                                         "float3(dot(world, right), dot(world, up), dot(world, @geometryNormalWS))",
                                         "dot(back, right)", white());
    const double length = std::sqrt(1 + 0.3 * 0.3 + 0.4 * 0.4), doubled = std::sqrt(1 + 0.6 * 0.6 + 0.8 * 0.8);
    expect_all(witnesses, 2e-3, [&](int, int) -> std::array<double, 4> {
        return {-0.3 / length, -0.4 / length, 1 / length, -0.6 / doubled};
    });
}

// Heights in a texture: h = u + 0.5 (1 - v) where the samples do not wrap, so each step of 0.1 * 0.5^3 upwards or to
// the right grows by as much.
TEST_F(QuadsTest, NormalFromTextureLeansAgainstTheSlope) {
    constexpr int kHeights = 128;
    TextureData data{.levels = {}, .sampler = {.wrap = Wrap::Repeat, .filter = Filter::Linear}};
    Image heights = runtime::make_image(kHeights, kHeights);
    for (int y = 0; y < kHeights; ++y)
        for (int x = 0; x < kHeights; ++x)
            heights.at(x, y)[0] = static_cast<float>((x + 0.5) / kHeights + 0.5 * (1 - (y + 0.5) / kHeights));
    data.levels.push_back({.width = kHeights, .height = kHeights, .texels = heights.pixels});
    const auto witnesses = all_witnesses(R"json(
        { "id": "normal", "node": "NormalFromTexture",
          "in": { "texture": "$_Data", "uv": "= @fragCoord.xy / 64 + 0.25", "offset": 0.5, "strength": 40 } })json",
                                         "normal", "1", std::make_shared<const TextureData>(std::move(data)));
    const double right = 40 * 0.0125, up = 0.5 * right, length = std::sqrt(1 + right * right + up * up);
    // A filter of the GPU has 8 bits between texels: 1 / 256 of 1 / 128, times 40.
    expect_all(witnesses, 4e-3, [&](int, int) -> std::array<double, 4> {
        return {-right / length, -up / length, 1 / length, 1};
    });
}

// --- mip levels

constexpr int kTexels = 64, kLevels = 7;

// Every texel of a level is the level's number.
std::shared_ptr<const TextureData> numbered_levels(Filter filter) {
    TextureData data{.levels = {}, .sampler = {.wrap = Wrap::Repeat, .filter = filter}};
    for (int level = 0; level < kLevels; ++level) {
        const int side = kTexels >> level;
        const Image image = runtime::make_image(side, side, static_cast<float>(level));
        data.levels.push_back({.width = side, .height = side, .texels = image.pixels});
    }
    return std::make_shared<const TextureData>(std::move(data));
}

// Texels a pixel, as powers of two: the same within a quad, so that the coordinate's derivatives are these numbers.
constexpr const char* kCoordinate = R"json(
    { "id": "quad", "expr": "floor(@fragCoord.xy * 0.5)" },
    { "id": "power", "expr": "float2(quad.x * 0.62 - 2, quad.y * 0.27 - 1.5)" },
    { "id": "at", "expr": "@fragCoord.xy * exp2(power) / 64" })json";

// Vulkan's rule where the coordinate runs along the axes: the larger of the two rates.
double level_of_detail(int x, int y) {
    return std::max(x / 2 * 0.62 - 2, y / 2 * 0.27 - 1.5);
}

// The level that is nearest; NaN where a GPU's approximate logarithm may choose either.
double nearest_level(double level_of_detail) {
    const double level = std::clamp(std::ceil(level_of_detail + 0.5) - 1, 0.0, kLevels - 1.0);
    const double from_edge = std::abs(level_of_detail - std::floor(level_of_detail) - 0.5);
    const bool is_inside = level_of_detail > 0 && level_of_detail < kLevels - 1;
    return is_inside && from_edge < 0.04 ? NAN : level;
}

TEST_F(QuadsTest, SamplesTakeTheMipLevelOfTheirQuad) {
    const auto witnesses = all_witnesses(
        kCoordinate,
        "float3(SampleTexture2D($_Data, at).r, $_Data.SampleBias(at, 1.25).r, SampleTexture2DLevel($_Data, at, 2).r)",
        "TexelSize($_Data).size.x", numbered_levels(Filter::Nearest));
    int skipped = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) skipped += std::isnan(nearest_level(level_of_detail(x, y))) ? 1 : 0;
    EXPECT_LT(skipped, kSide * kSide / 8);
    expect_all(witnesses, 0, [](int x, int y) -> std::array<double, 4> {
        const double level = level_of_detail(x, y);
        return {nearest_level(level), nearest_level(level + 1.25), 2, kTexels};
    });
}

// What is read jumps by several textures from pixel to pixel; the level is that of the coordinate which does not.
TEST_F(QuadsTest, SamplesWhereCoordinatesJumpTakeTheLevelOfTheOnesThatDoNot) {
    const std::string jumping = R"json(, { "id": "jump", "expr": "at + 9.3 * frac(@fragCoord.xy * 0.37)" })json";
    const auto witnesses =
        all_witnesses(kCoordinate + jumping, "float3(SampleTexture2DMoved($_Data, jump, at).r, 0, 0)", "1",
                      numbered_levels(Filter::Nearest));
    expect_all(witnesses, 0, [](int x, int y) -> std::array<double, 4> {
        return {nearest_level(level_of_detail(x, y)), 0, 0, 1};
    });
}

TEST_F(QuadsTest, TrilinearSamplesBlendTheTwoLevelsAroundIt) {
    const auto witnesses =
        all_witnesses(kCoordinate, "float3(SampleTexture2D($_Data, at).r, 0, 0)", "1", numbered_levels(Filter::Linear));
    // lavapipe approximates the logarithm: its level of detail is off by up to 0.036.
    expect_all(witnesses, 0.05, [](int x, int y) -> std::array<double, 4> {
        return {std::clamp(level_of_detail(x, y), 0.0, kLevels - 1.0), 0, 0, 1};
    });
}

// --- loops

constexpr const char* kDiverging = R"(
/// Adds up count numbers: 1, 2, 3 ..., but every third of them is taken off and ends up in `thirds`.
[node("Custom/Diverging")]
float Diverging(float count = 0, out float thirds) {
    float sum = 0;
    thirds = 0;
    for (int i = 0; i < min(int(count), 16); i++) {
        if (i % 3 == 2) {
            sum -= float(i + 1);
            thirds += 1;
        } else {
            sum += float(i + 1);
        }
    }
    return sum;
}
)";

double count_at(int x, int y) {
    return (x * 3 + y * 5) % 20;
}
double sum_at(int x, int y) {
    const int count = std::min(static_cast<int>(count_at(x, y)), 16), thirds = count / 3;
    // 1 + ... + count, less twice 3 + 6 + ...
    return count * (count + 1) / 2 - 3 * thirds * (thirds + 1);
}

TEST_F(QuadsTest, LoopsOfDifferentLengthMeetAgain) {
    const auto witnesses = all_witnesses(
        R"json({ "id": "pixel", "expr": "floor(@fragCoord.xy)" },
           { "id": "count", "expr": "fmod(pixel.x * 3 + pixel.y * 5, 20)" },
           { "id": "loop", "node": "./Diverging.node.hlsl", "in": { "count": "count" } })json",
        "float3(loop, loop.thirds, ddx(loop))", "ddy(loop)", white(), {{"Diverging.node.hlsl", kDiverging}});
    expect_all(witnesses, 0, [](int x, int y) -> std::array<double, 4> {
        const int left = x / 2 * 2, upper = y / 2 * 2;
        return {sum_at(x, y), std::floor(std::min(count_at(x, y), 16.0) / 3), sum_at(left + 1, y) - sum_at(left, y),
                sum_at(x, upper + 1) - sum_at(x, upper)};
    });
}

}  // namespace
}  // namespace patina::witness
