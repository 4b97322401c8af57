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

TextureLevel half_size(const TextureLevel& level) {
    int width = std::max(level.width / 2, 1), height = std::max(level.height / 2, 1);
    std::size_t row = 4 * std::size_t(level.width), half_row = 4 * std::size_t(width);
    std::vector<float> narrow(half_row * level.height);
    for (int y = 0; y < level.height; y++)
        shrink_line(&level.texels[y * row], level.width, &narrow[y * half_row], width, 4, 4);

    TextureLevel result{.width = width, .height = height, .texels = std::vector<float>(half_row * height)};
    for (int x = 0; x < width; x++)
        shrink_line(&narrow[4 * x], level.height, &result.texels[4 * x], height, half_row, half_row);
    return result;
}

}  // namespace

std::vector<TextureLevel> mip_chain(const Image& linear) {
    std::vector<TextureLevel> levels = {{.width = linear.width, .height = linear.height, .texels = linear.pixels}};
    while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(half_size(levels.back()));
    return levels;
}

}  // namespace patina::runtime
