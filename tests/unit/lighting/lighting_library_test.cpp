// The installed library patina::lighting, by its public header alone.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "patina/lighting.h"

namespace patina::lighting {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

struct Pixels {
    int width = 64, height = 32;
    std::vector<float> numbers;

    Picture picture() const { return {.width = width, .height = height, .numbers = numbers}; }
};

// A 2:1 picture; `light` is given the middle of each pixel, from 0 to 1.
template <class Light>
Pixels pixels_of(const Light& light) {
    Pixels pixels;
    for (int y = 0; y < pixels.height; y++) {
        for (int x = 0; x < pixels.width; x++) {
            const float value =
                light((float(x) + 0.5f) / float(pixels.width), (float(y) + 0.5f) / float(pixels.height));
            pixels.numbers.insert(pixels.numbers.end(), {value, 2 * value, 0});
        }
    }
    return pixels;
}

// The first texel of a face, in red.
float corner(const Level& level, int face) {
    return level.texels[std::size_t(4 * face * level.size * level.size)];
}

TEST(LightingLibrary, UniformLightIsTheSameEverywhere) {
    const Environment sky = prefilter(pixels_of([](float, float) { return 1.5f; }).picture());
    ASSERT_EQ(sky.error, "");
    ASSERT_EQ(sky.levels.size(), 6u);
    EXPECT_NEAR(sky.coefficients[0][0], 1.5f * std::sqrt(4 * kPi), 1e-3f);  // the integral of 1.5 * sqrt(1 / (4 pi))
    EXPECT_NEAR(sky.coefficients[0][1], 3 * std::sqrt(4 * kPi), 1e-3f);
    for (std::size_t i = 1; i < sky.coefficients.size(); i++) EXPECT_NEAR(sky.coefficients[i][0], 0, 2e-3f) << i;
    for (std::size_t i = 0; i < sky.levels.size(); i++) {
        const Level& level = sky.levels[i];
        EXPECT_EQ(level.size, 256 >> i);
        ASSERT_EQ(level.texels.size(), std::size_t(24) * level.size * level.size);
        EXPECT_NEAR(5 * level.roughness * (1.7f - 0.7f * level.roughness), float(i), 1e-4f);
        for (std::size_t at = 0; at < level.texels.size(); at += 4) {
            ASSERT_NEAR(level.texels[at], 1.5f, 1e-4f);
            ASSERT_NEAR(level.texels[at + 1], 3, 2e-4f);
            ASSERT_EQ(level.texels[at + 2], 0);
            ASSERT_EQ(level.texels[at + 3], 1);
        }
    }
}

TEST(LightingLibrary, ASkyIsAboveAndItsIntensityIsAFactor) {
    double last = 0;
    const Environment sky = prefilter(pixels_of([](float, float v) { return v < 0.5f ? 1.0f : 0.0f; }).picture(),
                                      {.intensity = 2, .progress = [&](double share) {
                                           EXPECT_GE(share, last);
                                           last = share;
                                       }});
    ASSERT_EQ(sky.error, "");
    EXPECT_DOUBLE_EQ(last, 1);
    // The integral of the cosine over the upper half of the sphere is pi; the picture's edge is a pixel wide.
    EXPECT_NEAR(sky.coefficients[1][0], 2 * std::sqrt(3 / (4 * kPi)) * kPi, 0.01f);
    EXPECT_NEAR(sky.coefficients[2][0], 0, 2e-3f);
    EXPECT_NEAR(sky.coefficients[3][0], 0, 2e-3f);
    EXPECT_NEAR(corner(sky.levels[0], 2), 2, 1e-4f);  // +y
    EXPECT_NEAR(corner(sky.levels[0], 3), 0, 1e-4f);  // -y
    EXPECT_GT(corner(sky.levels[5], 2), corner(sky.levels[5], 3));
}

// Even light beside the bright part: no side receives less than none, so nothing is smoothed.
TEST(LightingLibrary, TurnsAndMirrorsTheWorld) {
    const Pixels to_the_right = pixels_of([](float u, float) { return std::abs(u - 0.75f) < 0.125f ? 1.3f : 0.3f; });
    const Environment right = prefilter(to_the_right.picture());
    const Environment ahead = prefilter(to_the_right.picture(), {.rotation = 90});
    const Environment left_handed = prefilter(to_the_right.picture(), {.rotation = 90, .is_left_handed = true});
    // The light of a quarter of all sides: the integral of sin^2 times that of the cosine from -45 to 45 degrees.
    const float expected = std::sqrt(3 / (4 * kPi)) * kPi / 2 * std::sqrt(2.0f);
    EXPECT_NEAR(right.coefficients[3][0], expected, 0.01f);  // +x
    EXPECT_NEAR(ahead.coefficients[3][0], 0, 0.01f);
    EXPECT_NEAR(ahead.coefficients[2][0], -expected, 0.01f);       // -z
    EXPECT_NEAR(left_handed.coefficients[2][0], expected, 0.01f);  // +z
    const auto middle = [](const Environment& light, int face) {
        const Level& level = light.levels[0];
        return level.texels[std::size_t(4 * (face * level.size + level.size / 2) * level.size + 2 * level.size)];
    };
    EXPECT_NEAR(middle(right, 0), 1.3f, 1e-4f);        // +x
    EXPECT_NEAR(middle(ahead, 5), 1.3f, 1e-4f);        // -z
    EXPECT_NEAR(middle(left_handed, 4), 1.3f, 1e-4f);  // +z
    EXPECT_NEAR(middle(left_handed, 5), 0.3f, 1e-4f);
}

TEST(LightingLibrary, SaysWhatIsWrong) {
    const Pixels good = pixels_of([](float, float) { return 1.0f; });
    const auto error = [&](Picture picture, const Options& options = {}) {
        const Environment made = prefilter(picture, options);
        EXPECT_TRUE(made.levels.empty());
        return made.error;
    };
    Picture picture = good.picture();
    picture.height = 31;
    EXPECT_EQ(error(picture), "a picture of 64 x 31 pixels with 3 channels has 5952 numbers, not 6144");
    picture.numbers = picture.numbers.first(5952);
    EXPECT_NE(error(picture).find("the picture does not show all directions: it has 64 x 31 pixels"),
              std::string::npos);
    picture.width = 0;
    EXPECT_EQ(error(picture), "a picture has 1 to 16384 pixels on a side, not 0 x 31");
    picture = good.picture();
    picture.channels = 2;
    EXPECT_EQ(error(picture), "a pixel has 3 numbers or more (red, green, blue), not 2");
    EXPECT_EQ(error(good.picture(), {.face_size = 300}), "face_size is 0 or a power of two from 256 to 1024, not 300");
    EXPECT_EQ(error(good.picture(), {.intensity = -1}), "intensity is not from 0 to 1e6");
    EXPECT_EQ(error(good.picture(), {.rotation = std::numeric_limits<double>::infinity()}),
              "rotation is not a finite number");
    Pixels broken = good;
    broken.numbers[3 * (64 * 2 + 5)] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(error(broken.picture()), "the picture is not light everywhere: the pixel 5,2 is not finite");
}

TEST(LightingLibrary, TheTableOfTheSplitSumBeginsWithAMirror) {
    const SplitSumTable table = split_sum_table();
    ASSERT_EQ(table.size, 64);
    ASSERT_EQ(table.texels.size(), 2u * 64 * 64);
    for (int x = 0; x < 64; x++) {
        const float cosine = float(x * x) / (63 * 63), grazing = std::pow(1 - cosine, 5.0f);
        EXPECT_NEAR(table.texels[std::size_t(2 * x)], 1 - grazing, 1e-5f) << x;
        EXPECT_NEAR(table.texels[std::size_t(2 * x + 1)], grazing, 1e-5f) << x;
    }
    // No entry reflects more than arrives; the quadrature that makes the table is good to 5e-5.
    for (std::size_t i = 0; i < table.texels.size(); i += 2) {
        EXPECT_TRUE(table.texels[i] >= 0 && table.texels[i + 1] >= 0) << i;
        EXPECT_LE(table.texels[i] + table.texels[i + 1], 1 + 5e-5f) << i;
    }
}

}  // namespace
}  // namespace patina::lighting
