// Errors that follow from the paper's formulas on paper: where a picture is even, no filter changes it and nothing is
// an edge, so that the error is that of two colours.
#include "runtime/picture/flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace patina::runtime {
namespace {

struct Lab {
    double l, a, b;
};
// CIELAB of the primaries and of white under D65, as tables have them.
constexpr Lab kBlack{0, 0, 0}, kWhite{100, 0, 0}, kRed{53.2408, 80.0925, 67.2032}, kGreen{87.7347, -86.1827, 83.1793},
    kBlue{32.2970, 79.1875, -107.8602};

// Hunt's adjustment, the distance of HyAB, and the paper's map of distances to errors.
double distance(const Lab& p, const Lab& q) {
    const auto hunt = [](double lightness, double chroma) { return 0.01 * lightness * chroma; };
    return std::abs(p.l - q.l) + std::hypot(hunt(p.l, p.a) - hunt(q.l, q.a), hunt(p.l, p.b) - hunt(q.l, q.b));
}
double error_of(const Lab& p, const Lab& q) {
    const double most = std::pow(distance(kGreen, kBlue), 0.7), error = std::pow(distance(p, q), 0.7);
    const double split = 0.4 * most;
    return error < split ? 0.95 * error / split : 0.95 + 0.05 * (error - split) / (most - split);
}

Image even(float red, float green, float blue) {
    return make_image(40, 30, red, green, blue);
}

TEST(Flip, OfEvenPicturesIsTheErrorOfTheirColours) {
    const Image black = even(0, 0, 0), white = even(1, 1, 1), red = even(1, 0, 0), green = even(0, 1, 0),
                blue = even(0, 0, 1);
    EXPECT_NEAR(flip(black, white), error_of(kBlack, kWhite), 1e-4);
    EXPECT_NEAR(flip(white, black), error_of(kBlack, kWhite), 1e-4);
    EXPECT_NEAR(flip(black, red), error_of(kBlack, kRed), 1e-4);
    EXPECT_NEAR(flip(red, blue), error_of(kRed, kBlue), 1e-4);
    EXPECT_NEAR(flip(green, blue), 1, 1e-4);
}

// L* is 116 Y^(1/3) - 16, so that these two are 1 apart.
TEST(Flip, OfAStepOfLightnessOfOne) {
    const auto grey_of = [](double lightness) { return srgb_encode(float(std::pow((lightness + 16) / 116, 3))); };
    const float dark = grey_of(50), light = grey_of(51);
    EXPECT_NEAR(flip(even(dark, dark, dark), even(light, light, light)), error_of({50, 0, 0}, {51, 0, 0}), 1e-3);
}

TEST(Flip, EqualPicturesDoNotDiffer) {
    const Image image = even(0.2f, 0.4f, 0.6f);
    EXPECT_EQ(flip(image, image), 0);
    EXPECT_EQ(flip(Image{}, Image{}), 0);
}

// A picture that is white right of the middle, against black. The first white column is an edge of strength 1 in one
// picture: all weights of one sign are over white. What is seen there is half of white and half of the weight at the
// middle of the filter.
TEST(Flip, AnEdgeThatIsInOnePictureOnlyCountsForMore) {
    constexpr int kWidth = 101, kFirst = 50, kRadius = 10;
    Image black = make_image(kWidth, 1), half = black;
    for (int x = kFirst; x < kWidth; x++)
        for (int c = 0; c < 3; c++) half.at(x, 0)[c] = 1;
    const double scale = M_PI * M_PI / (0.0047 * 67.02 * 67.02);
    const auto weight = [&](int x) { return std::exp(-scale * x * x); };
    const double feature_scale = 1 / (2 * std::pow(0.5 * 0.082 * 67.02, 2));
    double total = 0, expected = 0;
    for (int x = -kRadius; x <= kRadius; x++) total += weight(x);
    for (int at = 0; at < kWidth; at++) {
        double seen = 0, edge = 0, edges = 0, point = 0, above = 0, below = 0;
        for (int x = -kRadius; x <= kRadius; x++) {
            const bool is_white = at + x >= kFirst;
            if (is_white) seen += weight(x) / total;
            if (std::abs(x) > 9) continue;  // three standard deviations of the features' filter
            const double slope = x * std::exp(-feature_scale * x * x);
            const double bend = (2 * feature_scale * x * x - 1) * std::exp(-feature_scale * x * x);
            if (x > 0) edges += slope;
            if (is_white) edge += slope;
            (bend > 0 ? above : below) += std::abs(bend);
        }
        for (int x = -9; x <= 9; x++) {
            const double bend = (2 * feature_scale * x * x - 1) * std::exp(-feature_scale * x * x);
            if (at + x >= kFirst) point += bend / (bend > 0 ? above : below);
        }
        if (at == kFirst) {
            EXPECT_DOUBLE_EQ(edge / edges, 1);
        }
        const double lightness = seen > 216.0 / 24389 ? 116 * std::cbrt(seen) - 16 : seen * 24389 / 27;
        const double feature = std::sqrt(std::max(std::abs(edge / edges), std::abs(point)) / std::sqrt(2));
        expected += std::pow(error_of(kBlack, {lightness, 0, 0}), 1 - feature) / kWidth;
    }
    EXPECT_NEAR(flip(black, half), expected, 2e-4);
    // Without the feature, less than a half would be this different.
    EXPECT_GT(flip(black, half), 0.5);
}

TEST(Flip, ATransparentPixelIsTheGreyBehindIt) {
    Image clear = even(1, 0, 0);
    for (std::size_t i = 3; i < clear.pixels.size(); i += 4) clear.pixels[i] = 0;
    EXPECT_EQ(flip(clear, even(0.5f, 0.5f, 0.5f)), 0);
}

TEST(Flip, NotANumberIsBlack) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NEAR(flip(even(kNan, kNan, kNan), even(1, 1, 1)), error_of(kBlack, kWhite), 1e-4);
}

}  // namespace
}  // namespace patina::runtime
