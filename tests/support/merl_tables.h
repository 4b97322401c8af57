// Tables in the form of the MERL database, made of a BRDF that is known, and their files. What reads them is
// runtime/lighting/merl.h.
//
//   const runtime::MerlTable table = sampled_table(lambert, 4, 4, 6);
//   write_merl("lambert.binary", table);
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "runtime/files/files.h"
#include "runtime/lighting/merl.h"

namespace patina::merl {

// Empty, or why the file cannot be written.
inline std::string write_merl(const std::string& path, const runtime::MerlTable& table) {
    constexpr std::array<double, 3> kScale = {1.0 / 1500, 1.15 / 1500, 1.66 / 1500};  // the database's
    std::string bytes;
    const auto add = [&](const void* data, std::size_t size) { bytes.append(static_cast<const char*>(data), size); };
    const std::array<std::int32_t, 3> counts = {table.half, table.difference, table.azimuth};
    add(counts.data(), sizeof counts);
    for (std::size_t c = 0; c < 3; c++) {
        std::vector<double> scaled = table.channels[c];
        for (double& value : scaled) value /= kScale[c];
        add(scaled.data(), scaled.size() * sizeof(double));
    }
    return runtime::write_file(path, std::move(bytes));
}

// Directions of an entry's middle, z up along the normal. Either may lie below the horizon, where nothing is measured.
struct DirectionPair {
    std::array<double, 3> light{}, view{};
};
inline DirectionPair directions_of(const runtime::MerlTable& table, int half, int difference, int azimuth) {
    constexpr double kPi = std::numbers::pi;
    const double root = (half + 0.5) / table.half;
    const double theta_half = root * root * kPi / 2;
    const double theta = (difference + 0.5) / table.difference * kPi / 2, phi = (azimuth + 0.5) / table.azimuth * kPi;
    // The difference vector around z, turned with z to the half vector in the x-z plane.
    const double x = std::sin(theta) * std::cos(phi), y = std::sin(theta) * std::sin(phi), z = std::cos(theta);
    const double s = std::sin(theta_half), c = std::cos(theta_half);
    DirectionPair pair{.light = {x * c + z * s, y, -x * s + z * c}};
    const double along = pair.light[0] * s + pair.light[2] * c;
    pair.view = {2 * along * s - pair.light[0], -pair.light[1], 2 * along * c - pair.light[2]};
    return pair;
}

using BrdfFunction = std::function<std::array<double, 3>(const DirectionPair&)>;
inline runtime::MerlTable sampled_table(const BrdfFunction& brdf, int half, int difference, int azimuth) {
    runtime::MerlTable table{.half = half, .difference = difference, .azimuth = azimuth};
    for (std::vector<double>& channel : table.channels) channel.reserve(table.entries());
    for (int h = 0; h < half; h++) {
        for (int d = 0; d < difference; d++) {
            for (int a = 0; a < azimuth; a++) {
                const std::array<double, 3> value = brdf(directions_of(table, h, d, a));
                for (std::size_t c = 0; c < 3; c++) table.channels[c].push_back(value[c]);
            }
        }
    }
    return table;
}

}  // namespace patina::merl
