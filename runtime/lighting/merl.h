// Tables of measured isotropic BRDFs in the form of the MERL database (Matusik et al., SIGGRAPH 2003). The coordinates
// are the angles of the half vector and of the difference vector (Rusinkiewicz, EGWR 1998), the first with the spacing
// of a square. Reading, writing, sampling a known BRDF, and the texture that the node MeasuredBRDF reads.
//
//   Outcome<MerlTable> table = read_merl("gold-paint.binary");
//   if (table) save_exr("gold-paint.exr", as_texture(table.value));
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "runtime/picture/image.h"

namespace patina::runtime {

struct MerlTable {
    int half = 90, difference = 90, azimuth = 180;  // angles: theta_h, theta_d, phi_d
    // BRDF in 1/sr, red, green and blue each as a whole: [(half * difference_count + difference) * azimuth_count +
    // azimuth]
    std::array<std::vector<double>, 3> channels{};

    std::size_t entries() const { return std::size_t(half) * std::size_t(difference) * std::size_t(azimuth); }
};

// Three 32-bit counts, then doubles, little-endian, scaled by the database's factors. A file that is not exactly as
// long as its counts say, or whose counts are no table's, is refused.
Outcome<MerlTable> read_merl(const std::string& path);
std::string write_merl(const std::string& path, const MerlTable& table);

// Directions of an entry's middle, z up along the normal. Either may lie below the horizon, where nothing is measured.
struct DirectionPair {
    std::array<double, 3> light{}, view{};
};
DirectionPair directions_of(const MerlTable& table, int half, int difference, int azimuth);

using BrdfFunction = std::function<std::array<double, 3>(const DirectionPair&)>;
MerlTable sampled_table(const BrdfFunction& brdf, int half, int difference, int azimuth);

// Pi times the BRDF: columns are phi_d, rows theta_h and in them theta_d. What was measured as less than nothing is 0.
Image as_texture(const MerlTable& table);

}  // namespace patina::runtime
