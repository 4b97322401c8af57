#include "runtime/frame/pixel_format.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

namespace patina::runtime {
namespace {

// To nearest of 0, 1 / most ... 1; NaN becomes 0.
std::uint32_t normalized(float value, std::uint32_t most) {
    return std::isnan(value) ? 0 : std::uint32_t(std::lround(std::clamp(double(value), 0.0, 1.0) * most));
}

template <class Bits>
Bits bits_at(const std::byte* pixel) {
    Bits bits;
    std::memcpy(&bits, pixel, sizeof bits);
    return bits;
}

void store_rgba8(const glm::vec4& value, std::byte* pixel) {
    for (int c = 0; c < 4; c++) pixel[c] = std::byte(normalized(value[c], 255));
}
glm::vec4 load_rgba8(const std::byte* pixel) {
    glm::vec4 value;
    for (int c = 0; c < 4; c++) value[c] = float(pixel[c]) / 255;
    return value;
}

// Red in the lowest bits.
void store_rgb10a2(const glm::vec4& value, std::byte* pixel) {
    std::uint32_t bits = normalized(value.a, 3) << 30;
    for (int c = 0; c < 3; c++) bits |= normalized(value[c], 1023) << 10 * c;
    std::memcpy(pixel, &bits, sizeof bits);
}
glm::vec4 load_rgb10a2(const std::byte* pixel) {
    const auto bits = bits_at<std::uint32_t>(pixel);
    const auto channel = [&](int c) { return float(bits >> 10 * c & 1023) / 1023; };
    return {channel(0), channel(1), channel(2), float(bits >> 30) / 3};
}

void store_rgba16f(const glm::vec4& value, std::byte* pixel) {
    for (int c = 0; c < 4; c++) {
        const std::uint16_t bits = half_bits(value[c]);
        std::memcpy(pixel + 2 * c, &bits, sizeof bits);
    }
}
glm::vec4 load_rgba16f(const std::byte* pixel) {
    glm::vec4 value;
    for (int c = 0; c < 4; c++) value[c] = half_value(bits_at<std::uint16_t>(pixel + 2 * c));
    return value;
}

void store_rgba32f(const glm::vec4& value, std::byte* pixel) {
    std::memcpy(pixel, &value, sizeof value);
}
glm::vec4 load_rgba32f(const std::byte* pixel) {
    return bits_at<glm::vec4>(pixel);
}

void store_red(const glm::vec4& value, std::byte* pixel) {
    std::memcpy(pixel, &value.r, sizeof value.r);
}
glm::vec4 load_red(const std::byte* pixel) {
    return {bits_at<float>(pixel), 0, 0, 1};
}

constexpr PixelFormat kFormats[] = {
    {TargetFormat::Rgba8, 4, false, true, store_rgba8, load_rgba8},
    {TargetFormat::Rgb10A2, 4, false, true, store_rgb10a2, load_rgb10a2},
    {TargetFormat::Rgba16F, 8, false, false, store_rgba16f, load_rgba16f},
    {TargetFormat::Rgba32F, 16, false, false, store_rgba32f, load_rgba32f},
    {TargetFormat::R32F, 4, false, false, store_red, load_red},
    {TargetFormat::Depth, 4, true, false, store_red, load_red},
};
static_assert(std::size(kFormats) == kWords<TargetFormat>.size());

}  // namespace

const PixelFormat& pixel_format(TargetFormat word) {
    return *std::find_if(std::begin(kFormats), std::end(kFormats),
                         [&](const PixelFormat& format) { return format.word == word; });
}

Image image_of(const PixelFormat& format, int width, int height, const std::byte* pixels) {
    Image image{.width = width, .height = height, .pixels = std::vector<float>(4 * std::size_t(width) * height)};
    for (std::size_t i = 0; i < std::size_t(width) * height; i++) {
        const glm::vec4 value = format.load(pixels + i * format.bytes);
        std::memcpy(&image.pixels[4 * i], &value, sizeof value);
    }
    return image;
}

std::uint16_t half_bits(float value) {
    constexpr int kFraction = 10, kMostExponent = 15, kLeastExponent = -14;
    const auto sign = std::uint16_t(std::signbit(value) ? 0x8000 : 0);
    if (std::isnan(value)) return sign | 0x7e00;
    const float size = std::abs(value);
    if (size == 0) return sign;
    if (std::isinf(size)) return sign | 0x7c00;
    // Rounds in units of the last place; subnormal numbers have the smallest unit. nearbyint rounds ties to even.
    const int exponent = std::max(std::ilogb(size), kLeastExponent);
    const auto units = std::uint32_t(std::nearbyint(std::ldexp(size, kFraction - exponent)));
    if (exponent > kMostExponent) return sign | 0x7c00;
    // A fraction that was rounded up to the next power of two carries into the exponent, up to infinity, as it should.
    const auto biased = std::uint32_t(exponent - kLeastExponent) << kFraction;
    return std::uint16_t(sign | (biased + units));
}

float half_value(std::uint16_t bits) {
    const int exponent = bits >> 10 & 0x1f, fraction = bits & 0x3ff;
    float size = exponent == 0x1f ? (fraction ? std::nanf("") : INFINITY)
                 : exponent       ? std::ldexp(float(1024 + fraction), exponent - 25)
                                  : std::ldexp(float(fraction), -24);
    return bits & 0x8000 ? -size : size;
}

}  // namespace patina::runtime
