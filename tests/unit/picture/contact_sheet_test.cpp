// Sheets: every picture is on them whole, at its place in the order, and labels are drawn where nothing else is.
#include "runtime/picture/contact_sheet.h"

#include <gtest/gtest.h>

#include "runtime/picture/lettering.h"

namespace patina::runtime {
namespace {

constexpr int kSize = 40;

std::vector<Image> greys(int count) {
    std::vector<Image> cells;
    for (int i = 0; i < count; ++i) {
        const float grey = float(i + 1) / 8;
        cells.push_back(make_image(kSize, kSize, grey, grey, grey));
    }
    return cells;
}

// The left upper corner of the square of this grey, which is there once; and how many pixels have it.
struct Found {
    int x = -1, y = -1, count = 0;
};
Found find(const Image& sheet, float grey) {
    Found found;
    for (int y = 0; y < sheet.height; ++y) {
        for (int x = 0; x < sheet.width; ++x) {
            const std::span<const float> pixel = sheet.at(x, y);
            if (pixel[0] != grey || pixel[2] != grey) continue;
            if (found.count++ == 0) found.x = x, found.y = y;
        }
    }
    return found;
}

double ink(const Image& sheet, int left, int top, int width, int height) {
    const float paper = sheet.at(0, 0)[0];
    double sum = 0;
    for (int y = top; y < top + height; ++y)
        for (int x = left; x < left + width; ++x) sum += sheet.at(x, y)[0] - paper;
    return sum;
}

TEST(ContactSheet, PicturesStandInTheirOrder) {
    const Outcome<Image> sheet = contact_sheet({.columns = 3}, greys(5));
    ASSERT_TRUE(sheet) << sheet.error;
    Found before;
    for (int i = 0; i < 5; ++i) {
        const Found found = find(sheet.value, float(i + 1) / 8);
        EXPECT_EQ(found.count, kSize * kSize) << i;
        if (i % 3 > 0) {
            EXPECT_EQ(found.y, before.y) << i;
            EXPECT_GE(found.x, before.x + kSize) << i;
        } else if (i == 3) {
            EXPECT_GE(found.y, before.y + kSize);
            EXPECT_EQ(found.x, find(sheet.value, 1.0f / 8).x);
        }
        before = found;
    }
}

TEST(ContactSheet, LabelsAreAboveColumnsAndLeftOfRows) {
    const SheetLayout layout{.columns = 2, .column_labels = {"one", "two"}, .row_labels = {"upper", "lower"}};
    const Outcome<Image> sheet = contact_sheet(layout, greys(4));
    ASSERT_TRUE(sheet) << sheet.error;
    for (int i = 0; i < 4; ++i) {
        const Found cell = find(sheet.value, float(i + 1) / 8);
        EXPECT_EQ(cell.count, kSize * kSize) << "a label covers picture " << i;
        if (i < 2) {
            EXPECT_GT(ink(sheet.value, cell.x, 0, kSize, cell.y), 1) << i;
        }
        if (i % 2 == 0) {
            EXPECT_GT(ink(sheet.value, 0, cell.y, cell.x, kSize), 1) << i;
        }
    }
}

TEST(ContactSheet, PicturesHaveLabelsOfTheirOwn) {
    const SheetLayout layout{.columns = 2, .cell_labels = {"a", "b", "c"}};
    const Outcome<Image> sheet = contact_sheet(layout, greys(3));
    ASSERT_TRUE(sheet) << sheet.error;
    const Found above = find(sheet.value, 1.0f / 8), below = find(sheet.value, 3.0f / 8);
    const int gap = above.y + kSize;
    EXPECT_GT(ink(sheet.value, below.x, gap, kSize, below.y - gap), 1);
}

TEST(ContactSheet, TooManyPicturesAreRefused) {
    const auto size = sheet_size({.columns = 100}, 100, 512, 512);
    ASSERT_FALSE(size);
    EXPECT_NE(size.error.find("more than 16384 on a side"), std::string::npos) << size.error;
}

TEST(Lettering, LongTextsAreMadeToFit) {
    const Outcome<Lettering> whole = lettering("_AVeryLongNameOfAProperty = 0.123456", 20);
    ASSERT_TRUE(whole) << whole.error;
    const Outcome<Lettering> within = lettering_within("_AVeryLongNameOfAProperty = 0.123456", 20, 60);
    ASSERT_TRUE(within) << within.error;
    EXPECT_GT(whole.value.width, 60);
    EXPECT_LE(within.value.width, 60);
    EXPECT_GT(within.value.width, 30);
}

}  // namespace
}  // namespace patina::runtime
