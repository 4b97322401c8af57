#include "runtime/picture/picture_bounds.h"

#include <fmt/format.h>

#include <atomic>

#include "runtime/picture/image.h"

namespace patina::runtime {
namespace {

std::atomic<std::size_t> allowed{kMostPixels};

}  // namespace

void limit_pixels(std::size_t most) {
    allowed = most;
}

std::size_t most_pixels() {
    return allowed;
}

std::uint64_t most_picture_bytes() {
    return 16 * std::uint64_t{most_pixels()} + (std::uint64_t{64} << 20);
}

std::string size_fault(std::uint64_t width, std::uint64_t height, std::uint64_t channels) {
    const std::uint64_t pixels = width * height;
    if (width > kLargestImage || height > kLargestImage)
        return fmt::format("it is {} x {} pixels, and the limit is {} on a side", width, height, kLargestImage);
    if (pixels > most_pixels())
        return fmt::format("it is {} x {} pixels, and the limit is {} in all: --max-pixels allows another number",
                           width, height, most_pixels());
    if (channels > 4 && pixels > 4 * std::uint64_t{most_pixels()} / channels)
        return fmt::format(
            "it is {} x {} pixels with {} channels, and the limit is {} pixels with four: --max-pixels "
            "allows another number",
            width, height, channels, most_pixels());
    return {};
}

}  // namespace patina::runtime
