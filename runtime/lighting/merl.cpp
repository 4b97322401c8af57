#include "runtime/lighting/merl.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

#include "compiler/base/disk/disk.h"
#include "runtime/files/files.h"

namespace patina::runtime {
namespace {

static_assert(std::endian::native == std::endian::little, "tables are read as they lie in the file");

constexpr double kPi = std::numbers::pi;
// The scale factors of the database's numbers.
constexpr std::array<double, 3> kScale = {1.0 / 1500, 1.15 / 1500, 1.66 / 1500};
constexpr int kMostAngles = 1024;
constexpr std::int64_t kMostEntries = std::int64_t{1} << 24;  // 400 MB; the database's tables have 1.5 million

std::string shown_counts(std::array<std::int32_t, 3> counts) {
    return std::to_string(counts[0]) + " x " + std::to_string(counts[1]) + " x " + std::to_string(counts[2]);
}

}  // namespace

Outcome<MerlTable> read_merl(const std::string& path) {
    std::array<std::int32_t, 3> counts{};
    const DiskFile start = read_beginning(path, sizeof counts);
    if (!start.bytes) return Failure{no_file(path)};
    const std::uintmax_t size = start.size;
    if (start.bytes->size() < sizeof counts)
        return Failure{"'" + path + "' is not a MERL table: it has " + std::to_string(size) + " bytes"};
    std::memcpy(counts.data(), start.bytes->data(), sizeof counts);
    const bool is_table = counts[0] == counts[1] &&
                          std::all_of(counts.begin(), counts.end(), [](int n) { return n > 0 && n <= kMostAngles; }) &&
                          std::int64_t{counts[0]} * counts[1] * counts[2] <= kMostEntries;
    if (!is_table)
        return Failure{"'" + path + "' is not a MERL table: its counts of angles are " + shown_counts(counts) +
                       ", and a table has 90 x 90 x 180"};
    MerlTable table{.half = counts[0], .difference = counts[1], .azimuth = counts[2]};
    const std::uintmax_t needed = sizeof counts + 3 * table.entries() * sizeof(double);
    if (size != needed)
        return Failure{"'" + path + "' is " + (size < needed ? "cut off" : "too long") + ": a table of " +
                       shown_counts(counts) + " angles has " + std::to_string(needed) + " bytes, and it has " +
                       std::to_string(size)};
    const Outcome<std::string> file = read_file(path, needed);
    if (!file) return Failure{file.error};
    if (file.value.size() != needed) return Failure{"cannot read '" + path + "': it changed meanwhile"};
    const char* from = file.value.data() + sizeof counts;
    for (std::size_t c = 0; c < 3; c++) {
        std::vector<double>& channel = table.channels[c];
        channel.resize(table.entries());
        std::memcpy(channel.data(), from, channel.size() * sizeof(double));
        from += channel.size() * sizeof(double);
        for (double& value : channel) {
            // A texture of floats cannot hold larger numbers; measured values are below a million.
            if (!(std::abs(value) < 1e30)) return Failure{"'" + path + "' holds a value that is not a reflectance"};
            value *= kScale[c];
        }
    }
    return table;
}

std::string write_merl(const std::string& path, const MerlTable& table) {
    std::string bytes;
    const auto add = [&](const void* data, std::size_t size) { bytes.append(static_cast<const char*>(data), size); };
    const std::array<std::int32_t, 3> counts = {table.half, table.difference, table.azimuth};
    add(counts.data(), sizeof counts);
    for (std::size_t c = 0; c < 3; c++) {
        std::vector<double> scaled = table.channels[c];
        for (double& value : scaled) value /= kScale[c];
        add(scaled.data(), scaled.size() * sizeof(double));
    }
    return write_file(path, std::move(bytes));
}

DirectionPair directions_of(const MerlTable& table, int half, int difference, int azimuth) {
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

MerlTable sampled_table(const BrdfFunction& brdf, int half, int difference, int azimuth) {
    MerlTable table{.half = half, .difference = difference, .azimuth = azimuth};
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

Image as_texture(const MerlTable& table) {
    Image image = make_image(table.azimuth, table.half * table.difference);
    for (std::size_t i = 0; i < table.entries(); i++) {
        for (std::size_t c = 0; c < 3; c++) image.pixels[4 * i + c] = float(std::max(table.channels[c][i], 0.0) * kPi);
    }
    return image;
}

}  // namespace patina::runtime
