// Compares two pictures by three figures. The share of pixels that differ by more than a threshold finds a wrong edge
// or a missing highlight. The average error finds a faint change of everything. The worst tile finds a faint change in
// one part. flip.h says how much of it a person sees.
//
//   Comparison c = compare(reference, received, 3.01 / 255);
//   bool same = c.same_size && c.share <= 0.001 && c.average <= 0.002;
#pragma once

#include "runtime/picture/image.h"

namespace patina::runtime {

struct Comparison {
    bool same_size = false;  // if not, the numbers below are 0
    double share = 0;        // of pixels in which some channel differs by more than the threshold
    double average = 0;  // mean absolute difference over all channels; infinite if a NaN or infinity stands on one side
    double largest = 0;  // greatest absolute difference of a channel
    int worst_x = 0, worst_y = 0;  // where it is
    double tile = 0;               // greatest mean absolute difference of a tile, over its channels
    int tile_x = 0, tile_y = 0;    // its upper left pixel
};

inline constexpr int kTileSide =
    16;  // pixels; tiles begin at the upper left, and those at the far edges may be smaller

// Channels are compared as they stand: give both encoded, or both linear. NaN equals NaN, and nothing else.
Comparison compare(const Image& a, const Image& b, double threshold);

// A picture of the differences: black where equal, brighter with the difference (times `gain`), red where it is over
// the threshold. Of different sizes: the common part, red outside.
Image difference_image(const Image& a, const Image& b, double threshold, float gain = 8);

}  // namespace patina::runtime
