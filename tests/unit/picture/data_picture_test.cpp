// Pictures of data: ranges, false colour and values that are not finite.
#include "runtime/picture/data_picture.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace patina::runtime {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

Image row(const std::vector<std::array<float, 4>>& pixels) {
    Image image = make_image(int(pixels.size()), 1);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        std::copy(pixels[i].begin(), pixels[i].end(), image.at(int(i), 0).begin());
    return image;
}

// As a PNG stores it.
std::array<int, 3> bytes(const Image& linear, int x) {
    Image encoded = linear;
    encode_srgb(encoded);
    const Image stored = quantized(encoded);
    std::array<int, 3> made{};
    for (std::size_t c = 0; c < 3; ++c) made[c] = int(std::lround(stored.at(x, 0)[c] * 255));
    return made;
}

using Bytes = std::array<int, 3>;

TEST(DataRange, IsTwoNumbers) {
    EXPECT_EQ(parse_data_range("-1..1").value.low, -1);
    EXPECT_EQ(parse_data_range("0...5").value.high, 0.5);
    EXPECT_EQ(parse_data_range("1e-3..+2").value.high, 2);
    for (const char* wrong : {"", "1", "..", "1..", "a..2", "0..1x", "nan..1", "0..inf", "0, 1"})
        EXPECT_NE(parse_data_range(wrong).error.find("is not of the form LOW..HIGH"), std::string::npos) << wrong;
    for (const char* wrong : {"1..1", "2..1"})
        EXPECT_NE(parse_data_range(wrong).error.find("from a lower to a higher value"), std::string::npos) << wrong;
}

// The ends and the middle of the published maps: viridis, and Moreland's cool to warm.
TEST(InRange, OneNumberIsInFalseColour) {
    const Image data = row({{0, 0, 0, 1}, {1, 1, 1, 1}, {2, 2, 2, 1}, {-1, -1, -1, 1}, {3, 3, 3, 1}});
    const Image shown = in_range(data, {.low = 0, .high = 2});
    EXPECT_EQ(bytes(shown, 0), (Bytes{68, 1, 84}));
    EXPECT_EQ(bytes(shown, 1), (Bytes{33, 145, 140}));
    EXPECT_EQ(bytes(shown, 2), (Bytes{253, 231, 37}));
    EXPECT_EQ(bytes(shown, 3), (Bytes{0, 0, 0}));        // below
    EXPECT_EQ(bytes(shown, 4), (Bytes{255, 255, 255}));  // above
}

TEST(InRange, ZeroIsGreyWhateverTheEnds) {
    const Image shown = in_range(row({{-1, -1, -1, 1}, {0, 0, 0, 1}, {4, 4, 4, 1}}), {.low = -1, .high = 4});
    EXPECT_EQ(bytes(shown, 0), (Bytes{59, 76, 192}));
    EXPECT_EQ(bytes(shown, 1), (Bytes{221, 221, 221}));
    EXPECT_EQ(bytes(shown, 2), (Bytes{180, 4, 38}));
}

TEST(InRange, VectorsKeepTheirChannels) {
    const Image shown = in_range(row({{-1, 0, 1, 1}, {0.5f, -2, 2, 0.5f}}), {.low = -1, .high = 1});
    EXPECT_EQ(bytes(shown, 0), (Bytes{0, 128, 255}));
    EXPECT_EQ(bytes(shown, 1), (Bytes{191, 0, 255}));
    EXPECT_EQ(shown.at(1, 0)[3], 0.5f);
}

TEST(Summary, CountsWhatIsDrawn) {
    const Image data = row({{0.5f, -2, 3, 1}, {kNan, 0, 0, 1}, {0, kInfinity, 0, 1}, {9, 9, 9, 0}, {kNan, 0, 0, 0}});
    const DataSummary summary = summarise(data);
    EXPECT_FALSE(summary.is_empty);
    EXPECT_EQ(summary.low, -2);
    EXPECT_EQ(summary.high, 3);
    EXPECT_EQ(summary.not_finite, 2u);
    EXPECT_EQ(summary.first_x, 1);
    EXPECT_TRUE(summarise(row({{1, 1, 1, 0}})).is_empty);
}

TEST(NotFinite, IsMagentaAndBlackSquares) {
    Image image = make_image(32, 8, kNan, 1, 1);
    mark_not_finite(image);
    const auto color = [&](int x, int y) {
        return Bytes{int(image.at(x, y)[0]), int(image.at(x, y)[1]), int(image.at(x, y)[2])};
    };
    EXPECT_EQ(color(0, 0), (Bytes{1, 0, 1}));
    EXPECT_EQ(color(7, 7), (Bytes{1, 0, 1}));
    EXPECT_EQ(color(8, 0), (Bytes{0, 0, 0}));
    EXPECT_EQ(color(16, 0), (Bytes{1, 0, 1}));
}

TEST(Background, IsSeenThroughWhatIsNotOpaque) {
    Image image = row({{1, 0, 0, 0.25f}, {kNan, kNan, kNan, 0}});
    put_before(image, 0.2f, 0.4f, 0.8f);
    EXPECT_NEAR(image.at(0, 0)[0], 0.25f + 0.75f * 0.2f, 1e-6);
    EXPECT_NEAR(image.at(0, 0)[2], 0.75f * 0.8f, 1e-6);
    EXPECT_EQ(image.at(1, 0)[1], 0.4f);  // nothing is drawn there
    EXPECT_EQ(image.at(1, 0)[3], 1);
}

}  // namespace
}  // namespace patina::runtime
