// Pictures of data: values that are no colours, such as a distance, a mask or a direction. A range of values becomes
// the colours that a picture can show, and values that are not finite get a pattern.
//
//   const DataSummary summary = summarise(image);
//   if (summary.not_finite > 0) mark_not_finite(image);
//   Image shown = in_range(image, {.low = -1, .high = 1});
#pragma once

#include <cstddef>
#include <string_view>

#include "runtime/outcome.h"
#include "runtime/picture/image.h"

namespace patina::runtime {

struct DataRange {
    double low = 0, high = 1;  // low < high
};
// "-1..1", "0..2.5"; a failure says what is wrong.
Outcome<DataRange> parse_data_range(std::string_view text);

struct DataSummary {
    bool is_empty = true;          // no pixel has a finite value
    double low = 0, high = 0;      // of the finite channels
    std::size_t not_finite = 0;    // pixels with a channel that is NaN or infinite
    int first_x = 0, first_y = 0;  // the first of them, from the top left
};
// Of red, green and blue where alpha is above 0.
DataSummary summarise(const Image& image);

// Gives pixels that are not finite squares of magenta and black, eight pixels wide.
void mark_not_finite(Image& image);

// The picture of a range, linear, so that save_png writes the colours below. Alpha stays.
// - One number a pixel (red, green and blue are equal everywhere): false colour. If 0 lies inside the range: from blue
//   at the lower end over grey at 0 to red at the upper end (Moreland, Diverging Color Maps for Scientific
//   Visualization, 2009). Otherwise: from dark violet over blue and green to yellow (viridis).
// - Otherwise each channel goes from 0 to 255.
// Below the range is black, above it is white.
Image in_range(const Image& data, DataRange range);

// The picture in front of an even background, by its alpha; all of it becomes opaque.
void put_before(Image& image, float red, float green, float blue);
// The same in front of a picture of the same size, whose alpha stays where nothing is before it.
void put_before(Image& image, const Image& behind);

// A picture as the surroundings of data: grey, and a quarter as bright. What is not finite is black.
void fade(Image& image);

}  // namespace patina::runtime
