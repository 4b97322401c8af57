// Exposure and tone curves: values that follow from the published formulas, worked out by hand, and what each promises.
#include "runtime/picture/tone.h"

#include <gtest/gtest.h>

#include <cmath>

namespace patina::runtime {
namespace {

float grey(Tonemap curve, float value) {
    const std::array<float, 3> made = tone_mapped(curve, {value, value, value});
    EXPECT_NEAR(made[0], made[1], 2e-3f * std::max(1.0f, made[0]));
    EXPECT_NEAR(made[1], made[2], 2e-3f * std::max(1.0f, made[0]));
    return made[1];
}

TEST(Tone, KhronosNeutralKeepsWhatIsNotBright) {
    // Less the reflection of 0.04 that a dielectric adds, so that a base colour comes out as it is (its README).
    EXPECT_NEAR(grey(Tonemap::KhronosNeutral, 0.5f), 0.46f, 1e-6f);
    EXPECT_NEAR(grey(Tonemap::KhronosNeutral, 0.04f), 0.04f - (0.04f - 6.25f * 0.0016f), 1e-6f);
    // Of peak 1.04 - 0.04 = 1: 1 - 0.24^2 / (1 + 0.24 - 0.76) = 1 - 0.0576 / 0.48 = 0.88.
    EXPECT_NEAR(grey(Tonemap::KhronosNeutral, 1.04f), 0.88f, 1e-6f);
    // Red of peak 1 goes to 0.88, and then by 1 - 1 / (0.15 * 0.12 + 1) = 0.0176817 towards white of 0.88.
    const auto red = tone_mapped(Tonemap::KhronosNeutral, {1, 0, 0});
    EXPECT_NEAR(red[0], 0.88f, 1e-6f);
    EXPECT_NEAR(red[1], 0.88f * 0.0176817f, 1e-6f);
}

TEST(Tone, AcesOfGrey) {
    // The rows of the first matrix sum to 1. At 0.18: (0.18 * 0.2045786 - 0.000090537) / (0.18 * 0.61002222 + 0.238081)
    // = 0.036733611 / 0.347885 = 0.1055912; the rows of the second sum to 1 within 1e-4.
    EXPECT_NEAR(grey(Tonemap::Aces, 0.18f), 0.1055912f, 2e-4f);
    EXPECT_NEAR(grey(Tonemap::Aces, 1e5f), 1, 1e-4f);
}

TEST(Tone, AgxPutsMiddleGreyInTheMiddle) {
    // The pivot of its curve: 0.18 comes out as 0.5 of the encoded range. Its range is 0.18 times 2^-10 to 2^6.5.
    EXPECT_NEAR(std::pow(grey(Tonemap::Agx, 0.18f), 1 / 2.2f), 0.5f, 0.01f);
    EXPECT_NEAR(grey(Tonemap::Agx, 0.18f * std::exp2(6.5f)), 1, 0.02f);
    EXPECT_NEAR(grey(Tonemap::Agx, 0), 0, 1e-3f);
}

TEST(Tone, CurvesRiseAndStayBelowWhite) {
    for (const TonemapWord& each : kTonemaps) {
        if (each.curve == Tonemap::None) continue;
        float last = -1;
        for (float value = 0.001f; value < 1e4f; value *= 1.3f) {
            const float made = grey(each.curve, value);
            EXPECT_GE(made, last - 1e-5f) << each.word << " " << value;
            EXPECT_LE(made, 1.02f) << each.word << " " << value;
            last = made;
        }
    }
}

TEST(Tone, StopsAreFactorsOfTwo) {
    const Image image = toned(make_image(1, 1, 0.25f, 1, 3, 0.5f), {.exposure = -1});
    EXPECT_EQ(image.pixels, (std::vector<float>{0.125f, 0.5f, 1.5f, 0.5f}));
}

TEST(Clipping, SaysTheExposureInWhichOnlyHighlightsClip) {
    EXPECT_FALSE(clipping(make_image(4, 4, 1, 1, 1)));
    Image image = make_image(4, 4, 0.5f, 0.5f, 0.5f);
    image.at(1, 2)[1] = 5;
    const auto clipped = clipping(image);
    ASSERT_TRUE(clipped);
    EXPECT_EQ(clipped->share, 1.0 / 16);
    EXPECT_NEAR(clipped->exposure, -std::log2(5), 0.01);
    EXPECT_EQ(clipped->left, 0);
    EXPECT_FALSE(clipping(toned(image, {.exposure = clipped->exposure})));
    // 5 of 100 pixels are highlights, however bright. With a sixth one, it is the darkest of them that must not clip.
    Image sparkling = make_image(10, 10, 0.5f, 0.5f, 0.5f);
    for (int x = 0; x < 5; ++x) sparkling.at(x, 0)[0] = 1000;
    EXPECT_EQ(clipping(sparkling)->exposure, 0);
    sparkling.at(5, 0)[0] = 4;
    EXPECT_NEAR(clipping(sparkling)->exposure, -2, 0.01);
    EXPECT_NEAR(clipping(toned(sparkling, {.exposure = -2}))->share, 0.05, 1e-9);
    EXPECT_NEAR(clipping(sparkling)->left, 0.05, 1e-9);
    image.at(1, 2)[3] = 0;  // which nobody sees
    EXPECT_FALSE(clipping(image));
    Image large = make_image(100, 100, 0, 0, 0);
    for (int x = 0; x < 9; ++x) large.at(x, 0)[0] = 2;
    EXPECT_FALSE(clipping(large));
    large.at(9, 0)[0] = 2;
    EXPECT_TRUE(clipping(large));
}

// A matt ball has no highlights: in the exposure that is told, nothing of it clips.
TEST(Clipping, WhatFallsOffSmoothlyIsNoHighlight) {
    Image ball = make_image(100, 100, 0, 0, 0);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            const double away = std::hypot(x - 50, y - 50) / 50;
            if (away < 1) ball.at(x, y)[1] = float(40 * std::sqrt(1 - away * away));
        }
    const auto clipped = clipping(ball);
    ASSERT_TRUE(clipped);
    EXPECT_GT(clipped->share, 0.7);
    EXPECT_LT(clipped->left, kUnseen);
    EXPECT_FALSE(clipping(toned(ball, {.exposure = clipped->exposure})));
    EXPECT_NEAR(clipped->exposure, -std::log2(40), 0.05);
}

}  // namespace
}  // namespace patina::runtime
