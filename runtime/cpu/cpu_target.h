// The render targets of a frame in memory. They store the bytes of their formats, so that values are rounded as on a
// GPU. A target may hold only a window of its pixels, which is enough to trace one pixel.
//
//   CpuTarget target = make_cpu_target({.width = 4, .height = 4}, {.right = 4, .bottom = 4});
//   target.store(1, 2, {0.5f, 0, 0, 1});
#pragma once

#include <memory>
#include <vector>

#include "runtime/cpu/raster.h"
#include "runtime/frame/frame.h"
#include "runtime/frame/pixel_format.h"

namespace patina::runtime {

struct CpuTarget {
    const PixelFormat* format = nullptr;
    PixelBounds window{};
    std::vector<std::byte> pixels{};
    std::vector<std::uint8_t> stencil{};  // of a depth target
    // How often the frame has drawn into it, and its pixels as a texture at one such time.
    unsigned version = 1, seen_version = 0;
    std::shared_ptr<const TextureData> seen{};

    std::size_t index(int x, int y) const {
        return std::size_t(y - window.top) * (window.right - window.left) + (x - window.left);
    }
    glm::vec4 load(int x, int y) const { return format->load(&pixels[index(x, y) * format->bytes]); }
    void store(int x, int y, const glm::vec4& value) { format->store(value, &pixels[index(x, y) * format->bytes]); }
};

CpuTarget make_cpu_target(const FrameTarget& target, const PixelBounds& window);

// The window's pixels as they are now, to be read texel by texel: the same object until something is drawn.
std::shared_ptr<const TextureData> texture_of(CpuTarget& target);
Image image_of(const CpuTarget& target);

}  // namespace patina::runtime
