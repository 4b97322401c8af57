#include "runtime/bake/texels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace patina::runtime {

std::vector<std::uint8_t> covered_texels(const Image& image) {
    std::vector<std::uint8_t> covered(image.pixels.size() / 4);
    for (std::size_t i = 0; i < covered.size(); i++) covered[i] = image.pixels[4 * i + 3] > 0.5f;
    return covered;
}

void make_finite(Image& image, std::vector<std::uint8_t>& broken) {
    for (std::size_t i = 0; i < image.pixels.size(); i++) {
        if (std::isfinite(image.pixels[i])) continue;
        image.pixels[i] = 0;
        broken[i / 4] = 1;
    }
}

NotFinite not_finite(const std::vector<std::uint8_t>& broken, const std::vector<std::uint8_t>& covered, int width) {
    NotFinite found;
    for (std::size_t i = 0; i < broken.size(); i++) {
        if (!broken[i] || !covered[i] || found.count++ > 0) continue;
        found.first_x = int(i % std::size_t(width));
        found.first_y = int(i / std::size_t(width));
    }
    return found;
}

Range range_of(const Image& image, const std::vector<std::uint8_t>& covered, int channel) {
    const auto at = [&](std::size_t i) { return image.pixels[4 * i + std::size_t(channel)]; };
    if (image.pixels.size() == 4) return {at(0), at(0)};
    Range found{std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest()};
    for (std::size_t i = 0; i < covered.size(); i++) {
        if (!covered[i]) continue;
        found.low = std::min(found.low, at(i));
        found.high = std::max(found.high, at(i));
    }
    return found.low > found.high ? Range{} : found;
}

Image picked(const Image& image, const std::array<std::optional<int>, 4>& channels) {
    Image made{.width = image.width, .height = image.height, .pixels = std::vector<float>(image.pixels.size(), 1)};
    for (std::size_t c = 0; c < 4; c++) {
        if (!channels[c]) continue;
        for (std::size_t i = c; i < made.pixels.size(); i += 4)
            made.pixels[i] = image.pixels[i - c + std::size_t(*channels[c])];
    }
    return made;
}

Image shrunk(Image image, const std::vector<std::uint8_t>& covered) {
    std::array<float, 4> values{};
    for (int c = 0; c < 4; c++) {
        const Range range = range_of(image, covered, c);
        if (!range.is_constant()) return image;
        values[std::size_t(c)] = float(range.middle());
    }
    return make_image(1, 1, values[0], values[1], values[2], values[3]);
}

}  // namespace patina::runtime
