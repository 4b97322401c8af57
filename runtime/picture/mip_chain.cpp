#include "runtime/picture/mip_chain.h"

#include <algorithm>
#include <cmath>

namespace patina::runtime {
namespace {

// Averages runs of `from` samples down to `to`: sample i covers from i * from / to to (i + 1) * from / to, and parts of
// a source sample count as such. `stride` is the distance of neighbours in floats.
void shrink_line(const float* source, int from, float* target, int to, std::size_t stride, std::size_t target_stride) {
    for (int i = 0; i < to; i++) {
        double begin = double(i) * from / to, end = double(i + 1) * from / to;
        std::array<double, 4> sum{};
        for (int k = int(begin); k < from && k < end; k++) {
            double weight = std::min(end, k + 1.0) - std::max(begin, double(k));
            for (int c = 0; c < 4; c++) sum[c] += source[k * stride + c] * weight;
        }
        for (int c = 0; c < 4; c++) target[i * target_stride + c] = float(sum[c] / (end - begin));
    }
}

// `layers` pictures that follow each other.
TextureLevel half_size(const TextureLevel& level, int layers) {
    const int width = std::max(level.width / 2, 1), height = std::max(level.height / 2, 1);
    const std::size_t row = 4 * std::size_t(level.width), half_row = 4 * std::size_t(width);
    const std::size_t rows = std::size_t(level.height) * layers;
    std::vector<float> narrow(half_row * rows);
    for (std::size_t y = 0; y < rows; y++)
        shrink_line(&level.texels[y * row], level.width, &narrow[y * half_row], width, 4, 4);

    TextureLevel result{.width = width, .height = height, .texels = std::vector<float>(half_row * height * layers)};
    for (int layer = 0; layer < layers; layer++) {
        const float* from = &narrow[half_row * level.height * layer];
        float* to = &result.texels[half_row * height * layer];
        for (int x = 0; x < width; x++) shrink_line(from + 4 * x, level.height, to + 4 * x, height, half_row, half_row);
    }
    return result;
}

// Half as many layers.
TextureLevel half_depth(const TextureLevel& level, int depth) {
    const std::size_t layer = 4 * std::size_t(level.width) * level.height;
    TextureLevel result{.width = level.width,
                        .height = level.height,
                        .texels = std::vector<float>(layer * std::max(depth / 2, 1)),
                        .depth = std::max(depth / 2, 1)};
    for (std::size_t i = 0; i < layer; i += 4)
        shrink_line(&level.texels[i], depth, &result.texels[i], result.depth, layer, layer);
    return result;
}

TextureLevel stacked(std::span<const Image> layers) {
    TextureLevel level{.width = layers.front().width, .height = layers.front().height, .texels = {}};
    for (const Image& each : layers) level.texels.insert(level.texels.end(), each.pixels.begin(), each.pixels.end());
    return level;
}

std::vector<TextureLevel> with_smaller(TextureLevel finest, int layers) {
    std::vector<TextureLevel> levels;
    levels.push_back(std::move(finest));
    while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(half_size(levels.back(), layers));
    return levels;
}

}  // namespace

std::vector<TextureLevel> mip_chain(Image linear) {
    return with_smaller({.width = linear.width, .height = linear.height, .texels = std::move(linear.pixels)}, 1);
}

std::vector<TextureLevel> mip_chain(std::span<const Image> layers) {
    return with_smaller(stacked(layers), int(layers.size()));
}

std::vector<TextureLevel> volume_mip_chain(std::span<const Image> layers) {
    std::vector<TextureLevel> levels = {stacked(layers)};
    levels.back().depth = int(layers.size());
    while (levels.back().width > 1 || levels.back().height > 1 || levels.back().depth > 1) {
        const int depth = levels.back().depth;
        levels.push_back(half_depth(half_size(levels.back(), depth), depth));
    }
    return levels;
}

}  // namespace patina::runtime
