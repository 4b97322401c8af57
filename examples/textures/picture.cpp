#include "examples/textures/picture.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

#include "examples/textures/noise.h"

namespace textures {

Color mix(const Color& a, const Color& b, float t) {
    return {mix(a[0], b[0], t), mix(a[1], b[1], t), mix(a[2], b[2], t), mix(a[3], b[3], t)};
}

Color scaled(const Color& color, float factor) {
    return {color[0] * factor, color[1] * factor, color[2] * factor, color[3]};
}

Picture normals_of(const Picture& heights, int channel, float depth) {
    const auto c = static_cast<std::size_t>(channel);
    Picture result(heights.size);
    for (int y = 0; y < heights.size; ++y) {
        for (int x = 0; x < heights.size; ++x) {
            auto h = [&](int dx, int dy) { return heights.at(x + dx, y + dy)[c]; };
            // Sobel's filter: a central difference, smoothed across, over eight texels' worth of weight.
            const float du = (h(1, -1) + 2 * h(1, 0) + h(1, 1) - h(-1, -1) - 2 * h(-1, 0) - h(-1, 1)) / 8;
            const float down = (h(-1, 1) + 2 * h(0, 1) + h(1, 1) - h(-1, -1) - 2 * h(0, -1) - h(1, -1)) / 8;
            const float nx = -du * depth, ny = down * depth;
            const float scale = 1 / std::sqrt(nx * nx + ny * ny + 1);
            result.at(x, y) = {nx * scale * 0.5f + 0.5f, ny * scale * 0.5f + 0.5f, scale * 0.5f + 0.5f, h(0, 0)};
        }
    }
    return result;
}

float cavity(const Picture& heights, int channel, int x, int y, int radius, float strength) {
    const auto c = static_cast<std::size_t>(channel);
    const float here = heights.at(x, y)[c];
    float above = 0;
    int count = 0;
    for (int dy = -radius; dy <= radius; ++dy) {
        for (int dx = -radius; dx <= radius; ++dx) {
            above += std::max(heights.at(x + dx, y + dy)[c] - here, 0.0f);
            ++count;
        }
    }
    return std::clamp(1 - strength * above / static_cast<float>(count), 0.0f, 1.0f);
}

std::string save(const Picture& picture, int channels, const std::string& path) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(picture.texels.size() * static_cast<std::size_t>(channels));
    for (const Color& texel : picture.texels) {
        for (int i = 0; i < channels; ++i) {
            const float value = std::clamp(texel[static_cast<std::size_t>(i)], 0.0f, 1.0f);
            bytes.push_back(static_cast<std::uint8_t>(value * 255 + 0.5f));
        }
    }
    std::unique_ptr<OIIO::ImageOutput> file = OIIO::ImageOutput::create(path);
    if (!file) return OIIO::geterror();
    OIIO::ImageSpec spec(picture.size, picture.size, channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("png:compressionLevel", 9);
    if (!file->open(path, spec) || !file->write_image(OIIO::TypeDesc::UINT8, bytes.data()) || !file->close()) {
        return file->geterror();
    }
    return {};
}

}  // namespace textures
