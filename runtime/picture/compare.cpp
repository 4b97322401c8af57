#include "runtime/picture/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace patina::runtime {
namespace {

double channel_difference(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    double difference = std::abs(double(a) - double(b));
    return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

}  // namespace

Comparison compare(const Image& a, const Image& b, double threshold) {
    Comparison result;
    result.same_size = a.width == b.width && a.height == b.height;
    if (!result.same_size || a.pixels.empty()) return result;

    std::size_t differing = 0;
    double sum = 0;
    const int columns = (a.width + kTileSide - 1) / kTileSide;
    std::vector<double> tiles(std::size_t(columns) * ((a.height + kTileSide - 1) / kTileSide));
    for (int y = 0; y < a.height; y++) {
        for (int x = 0; x < a.width; x++) {
            std::span<const float> p = a.at(x, y), q = b.at(x, y);
            double worst = 0;
            for (int c = 0; c < 4; c++) {
                double difference = channel_difference(p[c], q[c]);
                worst = std::max(worst, difference);
                sum += difference;
                tiles[std::size_t(y / kTileSide) * columns + x / kTileSide] += difference;
            }
            if (worst > threshold) differing++;
            if (worst > result.largest) {
                result.largest = worst;
                result.worst_x = x;
                result.worst_y = y;
            }
        }
    }
    result.share = double(differing) / (double(a.width) * a.height);
    result.average = sum / double(a.pixels.size());
    for (std::size_t i = 0; i < tiles.size(); i++) {
        const int x = int(i) % columns * kTileSide, y = int(i) / columns * kTileSide;
        const double pixels = double(std::min(kTileSide, a.width - x)) * std::min(kTileSide, a.height - y);
        const double mean = tiles[i] / (4 * pixels);
        if (mean <= result.tile) continue;
        result.tile = mean;
        result.tile_x = x;
        result.tile_y = y;
    }
    return result;
}

Image difference_image(const Image& a, const Image& b, double threshold, float gain) {
    Image result = make_image(std::max(a.width, b.width), std::max(a.height, b.height), 1, 0, 0, 1);
    for (int y = 0; y < std::min(a.height, b.height); y++) {
        for (int x = 0; x < std::min(a.width, b.width); x++) {
            std::span<const float> p = a.at(x, y), q = b.at(x, y);
            double worst = 0;
            for (int c = 0; c < 4; c++) worst = std::max(worst, channel_difference(p[c], q[c]));
            auto shade = float(std::min(1.0, worst * gain));
            bool over = worst > threshold;
            std::span<float> out = result.at(x, y);
            out[0] = over ? std::max(shade, 0.5f) : shade;
            out[1] = out[2] = over ? 0 : shade;
        }
    }
    return result;
}

}  // namespace patina::runtime
