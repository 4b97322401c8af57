// Computes the table that the node SplitSumTable reads: how strongly a rough surface reflects a uniform environment.
// The reflectance is f0 scale + f90 offset (Karis, SIGGRAPH 2013), for GGX with Smith's exact joint visibility.
//
//   auto [scale, offset] = split_sum(0.25, 0.5, 32);   texture = split_sum_table();
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "patina/interpret.h"

namespace patina::runtime {

inline constexpr int kSplitSumSize = 64;  // texels along both sides of the table

// kSplitSumSize x kSplitSumSize texels; x: square root of n.v, y: perceptual roughness, both from 0 to 1 at the centres
// of the outer texels. The node SplitSumTable reads it in the same way, with an error of 0.3 %. Red is the share of f0,
// green that of f90, for GGX with Smith's exact joint visibility (Karis, SIGGRAPH 2013). The same object each time.
std::shared_ptr<const TextureData> split_sum_table();
// One entry of it, by quadrature: {scale, offset}. `alpha`: roughness squared; both from 0 to 1.
std::array<double, 2> split_sum(double alpha, double ndotv, int samples);
// All entries, row by row, two numbers each. It takes a quarter of a second: the table keeps them.
std::vector<float> split_sum_numbers();

}  // namespace patina::runtime
