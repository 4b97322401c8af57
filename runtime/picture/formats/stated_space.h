// The colour space that a picture's file states. Formats that only imply a colour space (a JPEG is usually sRGB)
// declare none.
//
//   const StatedSpace stated = stated_space("rust.png");
//   if (stated.space == ColorSpace::Srgb) ...   // stated.by: "its sRGB chunk"
#pragma once

#include <string>

namespace patina::runtime {

enum class ColorSpace { None, Srgb, Linear };

struct StatedSpace {
    ColorSpace space = ColorSpace::None;  // None: the file declares no space, or another one
    std::string by{};                     // what states it
};

// PNG: the chunks cICP, iCCP, sRGB and gAMA, the first of these that the file has (PNG, third edition, 11.3.2). Others:
// an ICC profile by its description, and Exif's ColorSpace. None if the file cannot be read.
StatedSpace stated_space(const std::string& path);

}  // namespace patina::runtime
