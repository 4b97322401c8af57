// Checks a frame independently of a device: the targets, blocks and textures of its steps exist, match and are filled.
// limits.h checks the limits of a device.
//
//   if (std::string error = frame_error(frame); !error.empty()) return Failure{error};
#pragma once

#include <string>

#include "runtime/frame/frame.h"

namespace patina::runtime {

// Empty, or what is wrong, in one sentence.
std::string frame_error(const Frame& frame);

// The area in full: a width of 0 becomes all of the target.
PixelArea full_area(const FrameStep& step, const Frame& frame);

// The targets that the step draws into, depth last; the first has the size of all.
std::vector<std::size_t> attachments(const FrameStep& step);

}  // namespace patina::runtime
