#include "runtime/picture/image.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace patina::runtime {
namespace {

template <class Function>
void change_colors(Image& image, Function function) {
    for (std::size_t i = 0; i < image.pixels.size(); i++)
        if (i % 4 != 3) image.pixels[i] = function(image.pixels[i]);
}

}  // namespace

Image make_image(int width, int height, float red, float green, float blue, float alpha) {
    Image image{.width = width, .height = height};
    image.pixels.reserve(4 * std::size_t(width) * height);
    for (std::size_t i = 0; i < std::size_t(width) * height; i++)
        image.pixels.insert(image.pixels.end(), {red, green, blue, alpha});
    return image;
}

float to_unit_range(float value) {
    return std::isnan(value) ? 0 : std::clamp(value, 0.0f, 1.0f);
}

float srgb_encode(float linear) {
    float x = std::abs(linear);
    float encoded = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
    return std::copysign(encoded, linear);
}

float srgb_decode(float encoded) {
    float x = std::abs(encoded);
    float linear = x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
    return std::copysign(linear, encoded);
}

void encode_srgb(Image& image) {
    change_colors(image, srgb_encode);
}
void decode_srgb(Image& image) {
    change_colors(image, srgb_decode);
}

Image quantized(const Image& encoded) {
    Image result = encoded;
    result.bits = 8;
    for (float& value : result.pixels) value = std::round(to_unit_range(value) * 255) / 255;
    return result;
}

Image box_filtered(const Image& image, int factor) {
    if (factor <= 1) return image;
    Image result = make_image(image.width / factor, image.height / factor);
    for (int y = 0; y < result.height; y++) {
        for (int x = 0; x < result.width; x++) {
            std::array<double, 4> weighted{}, plain{};
            for (int j = 0; j < factor; j++) {
                for (int i = 0; i < factor; i++) {
                    std::span<const float> pixel = image.at(x * factor + i, y * factor + j);
                    double weight = std::max(pixel[3], 0.0f);
                    if (weight > 0) {
                        for (int c = 0; c < 3; c++) weighted[c] += pixel[c] * weight;
                        weighted[3] += weight;
                    }
                    for (int c = 0; c < 4; c++) plain[c] += pixel[c];
                }
            }
            double count = double(factor) * factor;
            std::span<float> out = result.at(x, y);
            for (int c = 0; c < 3; c++) out[c] = float(weighted[3] > 0 ? weighted[c] / weighted[3] : plain[c] / count);
            out[3] = float(plain[3] / count);
        }
    }
    return result;
}

}  // namespace patina::runtime
