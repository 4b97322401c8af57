// How different two pictures look to a person who switches between them: FLIP, for pictures that a screen shows.
// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: "FLIP: A Difference Evaluator for Alternating
// Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020.
//
//   double seen = flip(reference, received);   // 0: no difference; 1: that of green and blue, everywhere
#pragma once

#include "runtime/picture/image.h"

namespace patina::runtime {

// The paper's screen: 0.7 m wide, 3840 pixels, seen from 0.7 m. A filter is then 21 pixels wide.
inline constexpr double kPixelsPerDegree = 67.02;

// The mean over all pixels of the error of each, 0 to 1. Takes sRGB-encoded pictures of one size. Colours beyond 0 and
// 1 are shown as these; what is transparent is seen before a grey; NaN is black.
double flip(const Image& a, const Image& b);

}  // namespace patina::runtime
