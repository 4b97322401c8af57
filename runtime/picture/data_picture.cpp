#include "runtime/picture/data_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace patina::runtime {
namespace {

using Rgb = std::array<float, 3>;

// Five even steps of each map, in 8-bit sRGB.
constexpr std::array<Rgb, 5> kSequential = {Rgb{68, 1, 84}, Rgb{59, 82, 139}, Rgb{33, 145, 140}, Rgb{94, 201, 98},
                                            Rgb{253, 231, 37}};
constexpr std::array<Rgb, 5> kDiverging = {Rgb{59, 76, 192}, Rgb{141, 176, 254}, Rgb{221, 221, 221}, Rgb{244, 152, 122},
                                           Rgb{180, 4, 38}};
constexpr int kSquare = 8;  // pixels

bool is_finite(std::span<const float> pixel) {
    return std::isfinite(pixel[0]) && std::isfinite(pixel[1]) && std::isfinite(pixel[2]);
}

Rgb color_at(const std::array<Rgb, 5>& map, double share) {
    const double place = share * (map.size() - 1);
    const std::size_t left = std::min<std::size_t>(std::size_t(place), map.size() - 2);
    const double part = place - double(left);
    Rgb made{};
    for (std::size_t c = 0; c < 3; ++c) made[c] = float(std::lerp(map[left][c], map[left + 1][c], part) / 255);
    return made;
}

// Where a value is in the range, 0 to 1. Around 0, each side has half of the map.
double share_of(double value, DataRange range, bool is_around_zero) {
    if (!is_around_zero) return (value - range.low) / (range.high - range.low);
    return 0.5 + 0.5 * (value < 0 ? -value / range.low : value / range.high);
}

bool is_one_number(const Image& image) {
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        const std::span<const float> pixel(image.pixels.data() + i, 4);
        if (pixel[3] > 0 && is_finite(pixel) && (pixel[0] != pixel[1] || pixel[1] != pixel[2])) return false;
    }
    return true;
}

}  // namespace

Outcome<DataRange> parse_data_range(std::string_view text) {
    const auto number = [](std::string_view word, double& value) {
        if (word.starts_with('+')) word.remove_prefix(1);
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        return error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
    };
    DataRange range;
    const std::size_t dots = text.find("..");
    if (dots == text.npos || !number(text.substr(0, dots), range.low) || !number(text.substr(dots + 2), range.high))
        return Failure{fmt::format("'{}' is not of the form LOW..HIGH, such as -1..1", text)};
    if (!(range.low < range.high)) return Failure{fmt::format("'{}' does not go from a lower to a higher value", text)};
    return range;
}

DataSummary summarise(const Image& image) {
    DataSummary summary;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::span<const float> pixel = image.at(x, y);
            if (!(pixel[3] > 0) && !std::isnan(pixel[3])) continue;
            if (!is_finite(pixel) || !std::isfinite(pixel[3])) {
                if (summary.not_finite++ == 0) summary.first_x = x, summary.first_y = y;
                continue;
            }
            const auto [low, high] = std::minmax({pixel[0], pixel[1], pixel[2]});
            summary.low = summary.is_empty ? low : std::min<double>(summary.low, low);
            summary.high = summary.is_empty ? high : std::max<double>(summary.high, high);
            summary.is_empty = false;
        }
    }
    return summary;
}

void mark_not_finite(Image& image) {
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::span<float> pixel = image.at(x, y);
            if (is_finite(pixel)) continue;
            const float magenta = (x / kSquare + y / kSquare) % 2 == 0 ? 1.0f : 0.0f;
            pixel[0] = pixel[2] = magenta;
            pixel[1] = 0;
        }
    }
}

Image in_range(const Image& data, DataRange range) {
    const bool is_scalar = is_one_number(data), is_around_zero = is_scalar && range.low < 0 && range.high > 0;
    Image shown = data;
    for (std::size_t i = 0; i < shown.pixels.size(); i += 4) {
        const std::span<float> pixel(shown.pixels.data() + i, 4);
        if (!is_finite(pixel)) continue;
        Rgb color{};
        for (std::size_t c = 0; c < 3; ++c) color[c] = float(share_of(pixel[c], range, is_around_zero));
        if (is_scalar && color[0] >= 0 && color[0] <= 1)
            color = color_at(is_around_zero ? kDiverging : kSequential, color[0]);
        for (std::size_t c = 0; c < 3; ++c) pixel[c] = srgb_decode(std::clamp(color[c], 0.0f, 1.0f));
    }
    mark_not_finite(shown);
    return shown;
}

void put_before(Image& image, float red, float green, float blue) {
    const Rgb behind = {red, green, blue};
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        float* pixel = image.pixels.data() + i;
        // Where nothing is drawn, nothing of it counts, not even a NaN.
        for (std::size_t c = 0; c < 3; ++c)
            pixel[c] = pixel[3] > 0 ? std::lerp(behind[c], pixel[c], pixel[3]) : behind[c];
        pixel[3] = 1;
    }
}

void put_before(Image& image, const Image& behind) {
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        float* pixel = image.pixels.data() + i;
        const float* there = behind.pixels.data() + i;
        for (std::size_t c = 0; c < 3; ++c)
            pixel[c] = pixel[3] > 0 ? std::lerp(there[c], pixel[c], pixel[3]) : there[c];
        pixel[3] = std::lerp(there[3], 1.0f, std::max(pixel[3], 0.0f));
    }
}

void fade(Image& image) {
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        const std::span<float> pixel(image.pixels.data() + i, 4);
        const float light = is_finite(pixel) ? 0.2126f * pixel[0] + 0.7152f * pixel[1] + 0.0722f * pixel[2] : 0;
        pixel[0] = pixel[1] = pixel[2] = light / 4;
        if (!std::isfinite(pixel[3])) pixel[3] = 1;
    }
}

}  // namespace patina::runtime
