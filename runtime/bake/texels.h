// The values of drawn textures where the mesh is: whether they are finite, their range, and whether all of them are
// equal.
//
//   const Range red = range_of(image, covered, 0);
//   if (red.is_constant()) factor = red.middle();
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/picture/image.h"

namespace patina::runtime {

// Numbers that differ by no more than this are one number: the rounding of 32-bit floats, far below a step of 8 bits.
inline constexpr float kSame = 1e-4f;

struct Range {
    float low = 0, high = 0;
    bool is_constant() const { return high - low <= kSame; }
    double middle() const { return (double(low) + double(high)) / 2; }
};

// Texel by texel, 1 where alpha says that the mesh is there.
std::vector<std::uint8_t> covered_texels(const Image& image);

// Replaces numbers that are not finite by 0, and marks their texels in `broken`, which has an element for each texel.
void make_finite(Image& image, std::vector<std::uint8_t>& broken);

// The covered ones among broken texels: how many, and where the first is.
struct NotFinite {
    std::size_t count = 0;
    int first_x = 0, first_y = 0;
};
NotFinite not_finite(const std::vector<std::uint8_t>& broken, const std::vector<std::uint8_t>& covered, int width);

// Of one channel of the covered texels. An image of one texel means that the value is the same everywhere.
Range range_of(const Image& image, const std::vector<std::uint8_t>& covered, int channel);

// A texture of four channels, each from a channel of `image`; 1 where there is none.
Image picked(const Image& image, const std::array<std::optional<int>, 4>& channels);

// One texel if all that is covered has the same values; otherwise the image.
Image shrunk(Image image, const std::vector<std::uint8_t>& covered);

}  // namespace patina::runtime
