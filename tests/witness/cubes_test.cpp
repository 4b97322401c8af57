// What a material sees of its surroundings, on the GPU through GLSL and HLSL and on the CPU: a cube's texels, looked up
// everywhere, along its edges and at its corners, at every level; and spheres of metal that mirror a room.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "runtime/lighting/prefilter.h"
#include "witness/bench.h"

namespace patina::witness {
namespace {

// The same numbers on every machine, from -1 to 1.
class Numbers {
public:
    float next() {
        state_ = state_ * 1664525u + 1013904223u;
        return float(state_ >> 8) / float(1 << 23) - 1;
    }
    float sign() { return next() < 0 ? -1.0f : 1.0f; }

private:
    std::uint32_t state_ = 1;
};

// Radiance without rhyme or reason, from 0 to 1: no texel is like its neighbour.
glm::vec3 noise(glm::vec3 d) {
    std::uint32_t hash = 0;
    for (int i = 0; i < 3; ++i) {
        hash = (hash ^ static_cast<std::uint32_t>(static_cast<int>(d[i] * 4000))) * 2654435761u;
        hash ^= hash >> 15;
    }
    return glm::vec3(hash & 255, hash >> 8 & 255, hash >> 16 & 255) / 255.0f;
}

constexpr int kSize = 64;
enum Rows { Anywhere = 0, Edges = 16, Corners = 32, Ties = 48 };  // of the picture, where each begins

// A direction of any length, and the roughness of a level, whole in every other row.
glm::vec4 looked_up(int x, int y, Numbers& numbers) {
    glm::vec3 d(numbers.next(), numbers.next(), numbers.next());
    if (y >= Edges && y < Corners) {  // two components are nearly as long
        d[(x + 1) % 3] = numbers.sign() * d[x % 3] * (1 + 0.02f * numbers.next());
    } else if (y >= Corners && y < Ties) {
        for (int i = 0; i < 3; ++i) d[i] = numbers.sign() + 0.03f * d[i];
    } else if (y >= Ties) {  // two or three are exactly as long
        const float rest = d[2];
        for (int i = 0; i < 3; ++i) d[i] = numbers.sign();
        if (x % 2 == 1) d[x / 2 % 3] = rest;
    }
    const int last = runtime::kEnvironmentLevels - 1, whole = y % 16 / 2;
    const float level = std::min(float(whole) + (y % 2 == 1 ? std::abs(numbers.next()) : 0), float(last));
    // What MipFromRoughness turns into that level.
    const float roughness = (1.7f - std::sqrt(1.7f * 1.7f - 2.8f * level / float(last))) / 1.4f;
    return {d * std::exp2(3 * numbers.next()), roughness};
}

class CubesTest : public testing::Test {
protected:
    static void SetUpTestSuite() { bench = std::make_unique<Bench>(); }
    static void TearDownTestSuite() { bench.reset(); }
    void TearDown() override { bench->expect_silence(); }
    static inline std::unique_ptr<Bench> bench;
};

TEST_F(CubesTest, EveryDirectionAndLevelReadsTheSameTexels) {
    const auto material = bench->compile(R"({ "patina": 1, "workflow": "unlit", "properties": [ )" + data_property() +
                                         " ],\n\"nodes\": [ " + load_node("t", "@fragCoord.x", "@fragCoord.y") +
                                         R"(,
{ "id": "seen", "node": "EnvironmentRadiance", "in": { "direction": "= t.xyz", "roughness": "= t.w" } } ],
"surface": { "color": "seen" } })");
    ASSERT_TRUE(material);
    Image places = runtime::make_image(kSize, kSize);
    Numbers numbers;
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const glm::vec4 place = looked_up(x, y, numbers);
            std::copy_n(&place.x, 4, places.at(x, y).begin());
        }
    }
    runtime::Scene scene = runtime::fullscreen_scene(kSize, kSize);
    scene.environment = std::make_shared<const runtime::Environment>(noise, 64);
    const Inputs inputs{.data = texture_of(places), .scene = &scene};
    const Image cpu = bench->run(*material, Precision::Double, inputs);
    // Neighbouring texels differ by up to 1, and a place on a face of 64 is known to 64 * 2^-24.
    constexpr float kTolerance = 1e-5f;
    EXPECT_GT(*std::max_element(cpu.pixels.begin(), cpu.pixels.end()), 0.9f);
    for (const Target& target : {Target::Glsl, Target::Hlsl}) {
        const Image gpu = bench->draw(*material, target, inputs);
        ASSERT_EQ(gpu.pixels.size(), cpu.pixels.size());
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                const auto place = places.at(x, y);
                for (std::size_t c = 0; c < 3; ++c)
                    ASSERT_NEAR(gpu.at(x, y)[c], cpu.at(x, y)[c], kTolerance)
                        << target.name() << ": direction " << place[0] << ", " << place[1] << ", " << place[2]
                        << ", roughness " << place[3];
            }
        }
    }
}

// A sphere turns through all six faces, their edges and corners. The camera looks along a diagonal, so that a corner of
// the cube is mirrored in the middle and three edges run out from there.
TEST_F(CubesTest, SpheresOfMetal) {
    const auto material = bench->compile(R"({ "patina": 1, "workflow": "metallic-roughness",
"properties": [ { "name": "_Roughness", "type": "float" } ],
"surface": { "baseColor": [0.9, 0.7, 0.4], "metallic": 1, "roughness": "$_Roughness" } })");
    ASSERT_TRUE(material);
    runtime::Scene scene = runtime::default_scene("sphere");
    scene.width = scene.height = kSize;
    scene.lights.clear();
    scene.camera.position = glm::normalize(glm::vec3(1, 1, 1)) * glm::length(scene.camera.position);
    // Of what a white mirror of white surroundings would show: 1.
    constexpr float kTolerance = 2e-4f;
    for (const bool is_noise : {false, true}) {
        if (is_noise) scene.environment = std::make_shared<const runtime::Environment>(noise, 64);
        for (const char* roughness : {"0.02", "0.3", "0.7"}) {
            SCOPED_TRACE(roughness);
            const Inputs inputs{.scene = &scene, .values = {{"_Roughness", roughness}}};
            const Image cpu = bench->run(*material, Precision::Float, inputs);
            EXPECT_GT(*std::max_element(cpu.pixels.begin(), cpu.pixels.end() - 4), is_noise ? 0.4f : 0.3f);
            for (const Target& target : {Target::Glsl, Target::Hlsl}) {
                const Image gpu = bench->draw(*material, target, inputs);
                ASSERT_EQ(gpu.pixels.size(), cpu.pixels.size());
                for (std::size_t i = 0; i < gpu.pixels.size(); ++i)
                    ASSERT_NEAR(gpu.pixels[i], cpu.pixels[i], kTolerance)
                        << target.name() << " at " << i / 4 % kSize << ", " << i / 4 / kSize;
            }
        }
    }
}

}  // namespace
}  // namespace patina::witness
