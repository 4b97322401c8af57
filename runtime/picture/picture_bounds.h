// How large a picture may be.
//
//   size_fault(4096, 4096, 4);          // nothing: that is allowed
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace patina::runtime {

// Of a picture, unless a program allows another number: 8192 x 8192. As floats they take 1 GiB.
inline constexpr std::size_t kMostPixels = std::size_t{1} << 26;
// A program calls it once, before it starts threads.
void limit_pixels(std::size_t most);
std::size_t most_pixels();
// Of a picture's file: 16 bytes for each allowed pixel, and 64 MiB for all else that is in it.
std::uint64_t most_picture_bytes();

// What is wrong with a picture of this size, or nothing. More than four channels count as more pixels.
std::string size_fault(std::uint64_t width, std::uint64_t height, std::uint64_t channels);

}  // namespace patina::runtime
