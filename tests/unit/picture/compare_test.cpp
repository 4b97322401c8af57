#include "runtime/picture/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace patina::runtime {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(Compare, EqualPicturesDoNotDiffer) {
    Image image = make_image(5, 3, 0.2f, 0.4f, 0.6f, 0.8f);
    Comparison c = compare(image, image, 0);
    EXPECT_TRUE(c.same_size);
    EXPECT_EQ(c.share, 0);
    EXPECT_EQ(c.average, 0);
    EXPECT_EQ(c.largest, 0);
}

TEST(Compare, OnePixelIsItsShare) {
    Image a = make_image(4, 5), b = a;
    b.at(3, 2)[1] = 0.5f;
    Comparison c = compare(a, b, 0.1);
    EXPECT_DOUBLE_EQ(c.share, 1.0 / 20);
    EXPECT_DOUBLE_EQ(c.average, 0.5 / 80);
    EXPECT_DOUBLE_EQ(c.largest, 0.5);
    EXPECT_EQ(c.worst_x, 3);
    EXPECT_EQ(c.worst_y, 2);
}

TEST(Compare, APixelCountsOnceHoweverManyChannelsDiffer) {
    Image a = make_image(2, 2), b = a;
    for (float& channel : b.at(0, 0)) channel += 1;
    EXPECT_DOUBLE_EQ(compare(a, b, 0.5).share, 0.25);
}

TEST(Compare, AlphaCounts) {
    Image a = make_image(1, 1, 0, 0, 0, 1), b = make_image(1, 1, 0, 0, 0, 0);
    EXPECT_EQ(compare(a, b, 0.5).share, 1);
}

TEST(Compare, TheThresholdItselfPasses) {
    Image a = make_image(1, 1, 0.25f), b = make_image(1, 1, 0.5f);
    EXPECT_EQ(compare(a, b, 0.25).share, 0);
    EXPECT_EQ(compare(a, b, 0.2499).share, 1);
}

TEST(Compare, AFaintChangeOfEverythingShowsInTheAverageAlone) {
    Image a = make_image(8, 8, 0.5f, 0.5f, 0.5f, 1), b = make_image(8, 8, 0.5078125f, 0.5078125f, 0.5078125f, 1);
    Comparison c = compare(a, b, 0.01);
    EXPECT_EQ(c.share, 0);
    EXPECT_DOUBLE_EQ(c.average, 0.0078125 * 3 / 4);
}

TEST(Compare, NanIsEqualToNanOnly) {
    Image number = make_image(1, 1, 0), nan = make_image(1, 1, kNan);
    EXPECT_EQ(compare(nan, nan, 0).share, 0);
    Comparison c = compare(number, nan, 1e30);
    EXPECT_EQ(c.share, 1);
    EXPECT_TRUE(std::isinf(c.average));
}

TEST(Compare, InfinitiesOfOneSignAreEqual) {
    Image up = make_image(1, 1, kInfinity), down = make_image(1, 1, -kInfinity);
    EXPECT_EQ(compare(up, up, 0).average, 0);
    EXPECT_EQ(compare(up, down, 1e30).share, 1);
}

TEST(Compare, DifferentSizesAreNeverTheSame) {
    EXPECT_FALSE(compare(make_image(2, 3), make_image(3, 2), 1).same_size);
    EXPECT_FALSE(compare(make_image(2, 2), Image{}, 1).same_size);
}

TEST(DifferenceImage, IsBlackWhereEqualAndRedWhereOver) {
    Image a = make_image(3, 1, 0.5f, 0.5f, 0.5f, 1), b = a;
    b.at(1, 0)[0] += 0.0625f;  // under the threshold
    b.at(2, 0)[2] -= 0.25f;    // over it
    Image difference = difference_image(a, b, 0.1, 4);
    EXPECT_EQ(std::vector<float>(difference.pixels.begin(), difference.pixels.begin() + 4),
              (std::vector<float>{0, 0, 0, 1}));
    EXPECT_EQ(difference.at(1, 0)[0], 0.25f);
    EXPECT_EQ(difference.at(1, 0)[1], 0.25f);
    EXPECT_EQ(difference.at(2, 0)[0], 1);
    EXPECT_EQ(difference.at(2, 0)[1], 0);
}

TEST(DifferenceImage, MarksWhatOnlyOneOfThemHas) {
    Image difference = difference_image(make_image(2, 1), make_image(1, 2), 0.1);
    EXPECT_EQ(difference.width, 2);
    EXPECT_EQ(difference.height, 2);
    EXPECT_EQ(difference.at(0, 0)[0], 0);
    EXPECT_EQ(difference.at(1, 0)[0], 1);
    EXPECT_EQ(difference.at(1, 1)[0], 1);
}

// 40 x 20 pixels are 3 x 2 tiles; those at the far edges have 8 columns and 4 rows.
TEST(Compare, TheWorstTileIsTheMeanOfItsOwnPixels) {
    Image a = make_image(40, 20), b = a;
    b.at(0, 0)[0] = 1;    // of 16 x 16 pixels
    b.at(39, 19)[0] = 1;  // of 8 x 4
    Comparison c = compare(a, b, 0.5);
    EXPECT_DOUBLE_EQ(c.tile, 1.0 / (4 * 8 * 4));
    EXPECT_EQ(c.tile_x, 32);
    EXPECT_EQ(c.tile_y, 16);
    EXPECT_DOUBLE_EQ(compare(make_image(5, 3), make_image(5, 3, 1, 0, 0, 1), 0).tile, 0.25);
    EXPECT_EQ(compare(a, a, 0).tile, 0);
}

}  // namespace
}  // namespace patina::runtime
