// The formats of render targets as bytes, in Vulkan's layout. The CPU stores its pixels in these bytes, and the pixels
// of the GPU are read back by the same rules.
//
//   const PixelFormat& format = pixel_format(TargetFormat::Rgba8);
//   format.store({0.5f, 0, 0, 1}, bytes);   // 128, 0, 0, 255
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

#include "patina/words.h"
#include "runtime/picture/image.h"

namespace patina::runtime {

struct PixelFormat {
    TargetFormat word;
    std::size_t bytes;  // of a pixel; depth: without its stencil
    bool is_depth;
    bool is_normalized;  // holds 0 to 1, and blends what is clamped to that
    // Numbers are rounded to the nearest that the format holds. Channels that it lacks are 0, alpha 1; depth is red.
    void (*store)(const glm::vec4& value, std::byte* pixel);
    glm::vec4 (*load)(const std::byte* pixel);
};

const PixelFormat& pixel_format(TargetFormat word);

// Rows of pixels from the top, without gaps -> linear floats.
Image image_of(const PixelFormat& format, int width, int height, const std::byte* pixels);

// IEEE 754 binary16, to nearest, ties to even; too large becomes infinite, NaN stays NaN.
std::uint16_t half_bits(float value);
float half_value(std::uint16_t bits);

}  // namespace patina::runtime
