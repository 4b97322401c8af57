// A part of an image, in pixels from the top left.
//
//   PixelArea left_half{.width = image.width / 2, .height = image.height};
#pragma once

namespace patina::runtime {

struct PixelArea {
    int x = 0, y = 0, width = 0, height = 0;
};

}  // namespace patina::runtime
