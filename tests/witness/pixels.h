// A fixture for tests of what each pixel of a small picture is: one graph, drawn on the GPU through GLSL and HLSL and
// run on the CPU in both precisions, and each of the four pictures compared with a closed form.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "witness/bench.h"

namespace patina::witness {

class PixelsTest : public testing::Test {
protected:
    static constexpr int kSide = 32;

    struct Named {
        const char* name;
        Image image;
    };

    static void SetUpTestSuite() { bench = std::make_unique<Bench>(); }
    static void TearDownTestSuite() { bench.reset(); }
    void TearDown() override { bench->expect_silence(); }
    static inline std::unique_ptr<Bench> bench;

    static std::vector<Named> all_witnesses(const std::string& nodes, const std::string& color,
                                            const std::string& alpha, std::shared_ptr<const TextureData> data,
                                            const std::map<std::string, std::string>& files = {}) {
        const auto material = bench->compile(
            R"({ "patina": 1, "workflow": "unlit", "properties": [ )" + data_property() + " ],\n\"nodes\": [ " + nodes +
                " ],\n\"surface\": { \"color\": \"= " + color + "\", \"alpha\": \"= " + alpha + "\" } }",
            files);
        if (!material) return {};
        const Inputs inputs{.width = kSide, .height = kSide, .data = std::move(data)};
        return {{"GLSL", bench->draw(*material, Target::Glsl, inputs)},
                {"HLSL", bench->draw(*material, Target::Hlsl, inputs)},
                {"the CPU in float", bench->run(*material, Precision::Float, inputs)},
                {"the CPU in double", bench->run(*material, Precision::Double, inputs)}};
    }

    // Only the CPU, of a texture of any kind: its property is `property`.
    static std::vector<Named> on_the_cpu(const std::string& property, const std::string& nodes,
                                         const std::string& color, std::shared_ptr<const TextureData> data) {
        const auto material =
            bench->compile(R"({ "patina": 1, "workflow": "unlit", "properties": [ )" + property + " ],\n\"nodes\": [ " +
                               nodes + " ],\n\"surface\": { \"color\": \"= " + color + "\" } }",
                           {}, true);
        if (!material) return {};
        const Inputs inputs{.width = kSide, .height = kSide, .data = std::move(data)};
        return {{"the CPU in float", bench->run(*material, Precision::Float, inputs)},
                {"the CPU in double", bench->run(*material, Precision::Double, inputs)}};
    }

    // `expected` of a pixel's column and row; NaN: whatever it is. The first wrong channel of each witness is reported.
    static void expect_all(const std::vector<Named>& witnesses, double tolerance,
                           const std::function<std::array<double, 4>(int, int)>& expected) {
        ASSERT_FALSE(witnesses.empty());
        for (const auto& [name, image] : witnesses) {
            ASSERT_EQ(image.width, kSide);
            std::string wrong;
            for (int y = 0; y < kSide && wrong.empty(); ++y) {
                for (int x = 0; x < kSide && wrong.empty(); ++x) {
                    const std::array<double, 4> wanted = expected(x, y);
                    for (std::size_t c = 0; c < 4; ++c) {
                        const double got = static_cast<double>(image.at(x, y)[c]);
                        if (std::isnan(wanted[c]) || std::abs(got - wanted[c]) <= tolerance) continue;
                        wrong = "pixel (" + std::to_string(x) + ", " + std::to_string(y) + "), channel " + "rgba"[c] +
                                ": " + std::to_string(got) + ", expected " + std::to_string(wanted[c]);
                    }
                }
            }
            EXPECT_EQ(wrong, "") << name;
        }
    }

    static std::shared_ptr<const TextureData> white() { return texture_of(runtime::make_image(1, 1, 1, 1, 1)); }
};

}  // namespace patina::witness
