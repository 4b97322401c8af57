// When two pictures are the same: the limits of a snapshot, and the figures that are compared with them.
//
//   const std::vector<Gate> gates = figures(compare(reference, received, tolerance.pixel), flip(...), tolerance);
//   bool same = all_pass(gates);
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/picture/compare.h"

namespace patina::runtime {

// Colours are compared sRGB-encoded, 0 to 1.
struct Tolerance {
    double pixel = 3.01 / 255;  // a pixel differs if any channel is off by more
    double share = 0.001;       // of pixels that may differ
    double average = 0.002;     // mean absolute error over all channels
    double tile = 0.02;         // the same of the worst 16 x 16 tile
    double perceptual = 0.01;   // mean of FLIP (picture/flip.h)
    double other_driver = 4;    // the limits but `pixel` are multiplied by it if another driver drew the reference
};

// A number of a tolerance, as files and the command line name it.
struct ToleranceKey {
    std::string_view name;
    double Tolerance::*member;
    double lowest, highest;
};
std::span<const ToleranceKey> tolerance_keys();
// Null if there is none of this name.
const ToleranceKey* find_tolerance_key(std::string_view name);
// Empty, or what is wrong with the value: "'share' must be between 0 and 1".
std::string check_tolerance(const ToleranceKey& key, double value);

// For a reference that another driver drew. No limit is above 1, which every picture keeps.
Tolerance widened(Tolerance tolerance);

// One figure and its limit.
struct Gate {
    std::string_view name;  // the key of its limit
    double value = 0, limit = 0;
    bool passes() const { return value <= limit; }
};
// In the order of Tolerance. `perceptual`: of flip().
std::vector<Gate> figures(const Comparison& comparison, double perceptual, const Tolerance& tolerance);
bool all_pass(std::span<const Gate> gates);
// "share 0.4 % (limit 0.1 %)"; "share 0.4 %" if it passes.
std::string to_text(const Gate& gate);

}  // namespace patina::runtime
