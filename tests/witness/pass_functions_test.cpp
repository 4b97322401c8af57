// What passes read out of textures and matrices, and no `test:` line can: shadow maps, cookies, and places in the world
// from their depth. On the GPU through GLSL and HLSL, and on the CPU in both precisions, each against a computation of
// its own.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>

#include "witness/bench.h"

namespace patina::witness {
namespace {

constexpr int kSide = 32;

class PassFunctionsTest : public testing::Test {
protected:
    static void SetUpTestSuite() { bench = std::make_unique<Bench>(); }
    static void TearDownTestSuite() { bench.reset(); }
    void TearDown() override { bench->expect_silence(); }
    static inline std::unique_ptr<Bench> bench;

    // The colour of each pixel, `expected` of its column and row.
    static void expect_all(const std::string& nodes, const std::string& color, const Image& data, double tolerance,
                           const std::function<glm::dvec3(int, int)>& expected,
                           const std::map<std::string, std::string>& files = {}) {
        const auto material =
            bench->compile(R"({ "patina": 1, "workflow": "unlit", "properties": [ )" + data_property() +
                               " ],\n\"nodes\": [ " + nodes + " ],\n\"surface\": { \"color\": \"= " + color + "\" } }",
                           files);
        ASSERT_TRUE(material);
        const Inputs inputs{.width = kSide, .height = kSide, .data = texture_of(data)};
        const std::pair<const char*, Image> witnesses[] = {
            {"GLSL", bench->draw(*material, Target::Glsl, inputs)},
            {"HLSL", bench->draw(*material, Target::Hlsl, inputs)},
            {"the CPU in float", bench->run(*material, Precision::Float, inputs)},
            {"the CPU in double", bench->run(*material, Precision::Double, inputs)}};
        for (const auto& [name, image] : witnesses) {
            ASSERT_EQ(image.width, kSide) << name;
            std::string wrong;
            for (int i = 0; i < kSide * kSide && wrong.empty(); ++i) {
                const int x = i % kSide, y = i / kSide;
                const glm::dvec3 wanted = expected(x, y);
                for (int c = 0; c < 3; ++c) {
                    const double got = static_cast<double>(image.at(x, y)[static_cast<std::size_t>(c)]);
                    if (std::abs(got - wanted[c]) <= tolerance * std::max(1.0, std::abs(wanted[c]))) continue;
                    wrong = "pixel (" + std::to_string(x) + ", " + std::to_string(y) + "), channel " + "rgb"[c] + ": " +
                            std::to_string(got) + ", expected " + std::to_string(wanted[c]);
                }
            }
            EXPECT_EQ(wrong, "") << name;
        }
    }
};

// --- the tent: four maps of 8 x 8 texels in one of 16 x 16

constexpr int kAtlas = 16, kTile = 8;
constexpr double kDepth = 0.5;

// Every texel another depth, none of them near the one that is compared.
Image depths() {
    Image image = runtime::make_image(kAtlas, kAtlas);
    std::uint32_t state = 7;
    for (int i = 0; i < kAtlas * kAtlas; ++i) {
        state = state * 1664525u + 1013904223u;
        image.at(i % kAtlas, i / kAtlas)[0] = (state >> 16 & 1 ? 0.6f : 0.1f) + 0.3f * float(state >> 24) / 256;
    }
    return image;
}

// The tent's area over a texel, piece by piece: it is straight between these borders.
double tent_over(double texel, double peak) {
    double pieces[] = {texel, std::clamp(peak - 2.5, texel, texel + 1), std::clamp(peak, texel, texel + 1),
                       std::clamp(peak + 2.5, texel, texel + 1), texel + 1};
    double area = 0;
    for (std::size_t i = 0; i + 1 < std::size(pieces); ++i) {
        const double middle = (pieces[i] + pieces[i + 1]) / 2;
        area += (pieces[i + 1] - pieces[i]) * std::max(0.0, 1 - std::abs(middle - peak) / 2.5) / 2.5;
    }
    return area;
}

// The map's own texels go on beyond its borders as its outermost ones.
double filtered(const Image& map, double u, double v, int tile_x, int tile_y) {
    if (std::abs(u - 0.5) > 0.5 || std::abs(v - 0.5) > 0.5) return 1;
    double lit = 0;
    for (int y = -4; y < kTile + 4; ++y) {
        for (int x = -4; x < kTile + 4; ++x) {
            const float stored = map.at(tile_x + std::clamp(x, 0, kTile - 1), tile_y + std::clamp(y, 0, kTile - 1))[0];
            if (kDepth <= static_cast<double>(stored)) lit += tent_over(x, u * kTile) * tent_over(y, v * kTile);
        }
    }
    return lit;
}

TEST_F(PassFunctionsTest, ATentOverAShadowMapStaysInItsTile) {
    const Image map = depths();
    // Each map a little beyond its borders.
    const auto at = [](int pixel) { return (pixel + 0.5) / kSide * 1.25 - 0.125; };
    expect_all(R"json({ "id": "uv", "expr": "@fragCoord.xy * 1.25 / 32 - 0.125" },
        { "id": "first", "node": "SampleShadowTent5x5",
          "in": { "map": "$_Data", "uv": "uv", "depth": 0.5, "texel": 0.0625, "tile": [0.5, 0.5, 0, 0] } },
        { "id": "last", "node": "SampleShadowTent5x5",
          "in": { "map": "$_Data", "uv": "uv", "depth": 0.5, "texel": 0.0625, "tile": [0.5, 0.5, 0.5, 0.5] } },
        { "id": "far", "node": "SampleShadowTent5x5",
          "in": { "map": "$_Data", "uv": "uv", "depth": "= 1.001 + abs(uv.x)", "texel": 0.0625 } })json",
               "float3(first, last, far)", map, 1e-5, [&](int x, int y) {
                   return glm::dvec3(filtered(map, at(x), at(y), 0, 0), filtered(map, at(x), at(y), kTile, kTile), 1);
               });
}

// --- a cookie of 4 x 4 texels, the outermost of which go on for ever

TEST_F(PassFunctionsTest, ACookieIsProjectedForwardOnly) {
    Image cookie = runtime::make_image(4, 4);
    for (int i = 0; i < 16; ++i) cookie.at(i % 4, i / 4)[0] = float(i + 1) / 16;
    expect_all(R"json({ "id": "w", "expr": "@fragCoord.x < 16 ? 2 : -2" },
        { "id": "spot", "node": "CookieAttenuation",
          "in": { "cookie": "$_Data", "place": "= float4(@fragCoord.xy / 8, 0.75, w)" } },
        { "id": "sun", "node": "CookieAttenuation",
          "in": { "cookie": "$_Data", "place": "= float4(@fragCoord.xy / 8, -3, 1)" } })json",
               "float3(spot, sun, 0)", cookie, 1e-6, [&](int x, int y) {
                   // A texel is four pixels of the spot's wide, and two of the sun's.
                   const auto seen = [&](int pixels) {
                       return static_cast<double>(cookie.at(std::min(x / pixels, 3), std::min(y / pixels, 3))[0]);
                   };
                   return glm::dvec3(x < 16 ? seen(4) : 0, seen(2), 0);
               });
}

// --- points of the world, seen by a camera

std::string rows_of(const glm::dmat4& m) {
    std::string text;
    for (int i = 0; i < 16; ++i) text += (i ? ", " : "") + literal(m[i % 4][i / 4]);
    return text;
}

TEST_F(PassFunctionsTest, WhatACameraSeesIsFoundAgainFromItsDepth) {
    const glm::dmat4 view = glm::lookAtRH(glm::dvec3(3, 2, 5), glm::dvec3(0, 0.5, 0), glm::dvec3(0, 1, 0));
    const auto point = [](int x, int y) { return glm::dvec3(x * 0.1 - 1.6, (x * y % 7) * 0.3, y * 0.1 - 1.6); };
    for (const glm::dmat4& projection :
         {glm::perspectiveRH_ZO(0.9, 1.25, 0.5, 40.0), glm::orthoRH_ZO(-4.0, 4.0, -3.0, 3.0, 0.5, 40.0)}) {
        const glm::dmat4 world_to_clip = projection * view;
        Image seen = runtime::make_image(kSide, kSide);
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                const glm::dvec4 clip = world_to_clip * glm::dvec4(point(x, y), 1);
                seen.at(x, y)[0] = float(0.5 + 0.5 * clip.x / clip.w);
                seen.at(x, y)[1] = float(0.5 - 0.5 * clip.y / clip.w);
                seen.at(x, y)[2] = float(clip.z / clip.w);
            }
        }
        const std::string file =
            "/// A place.\n[node(\"Custom/Place\")]\nfloat3 Place(float3 seen) {\n"
            "    return WorldFromDepth(seen.xy, seen.z, float4x4(" +
            rows_of(glm::inverse(world_to_clip)) + "));\n}\n";
        expect_all(load_node("t", "@fragCoord.x", "@fragCoord.y") +
                       R"(, { "id": "place", "node": "./Place.node.hlsl", "in": { "seen": "= t.xyz" } })",
                   "place", seen, 2e-4, point, {{"Place.node.hlsl", file}});
    }
}

}  // namespace
}  // namespace patina::witness
