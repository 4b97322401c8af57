#include "runtime/cpu/cpu_target.h"

namespace patina::runtime {

CpuTarget make_cpu_target(const FrameTarget& wanted, const PixelBounds& window) {
    CpuTarget target{.format = &pixel_format(wanted.format), .window = window};
    const std::size_t count = std::size_t(window.right - window.left) * (window.bottom - window.top);
    target.pixels.resize(count * target.format->bytes);
    for (std::size_t i = 0; i < count; i++)
        target.format->store(wanted.clear, &target.pixels[i * target.format->bytes]);
    if (target.format->is_depth) target.stencil.resize(count);
    return target;
}

Image image_of(const CpuTarget& target) {
    const PixelBounds& window = target.window;
    return image_of(*target.format, window.right - window.left, window.bottom - window.top, target.pixels.data());
}

std::shared_ptr<const TextureData> texture_of(CpuTarget& target) {
    if (target.seen_version == target.version) return target.seen;
    Image image = image_of(target);
    TextureData data{.levels = {{.width = image.width, .height = image.height, .texels = std::move(image.pixels)}},
                     .sampler = {.wrap = Wrap::Clamp, .filter = Filter::Nearest}};
    target.seen = std::make_shared<const TextureData>(std::move(data));
    target.seen_version = target.version;
    return target.seen;
}

}  // namespace patina::runtime
