// Whether a world and its compiled materials can become a frame: everything is there, every pass asks for what a list
// of draws can give, and the camera is one that the passes work for. Whether the frame itself holds together is
// frame_check.h.
//
//   if (std::string error = plan_error(world, materials, options); !error.empty()) return Failure{error};
#pragma once

#include <span>
#include <string>

#include "runtime/frame/frame_plan.h"

namespace patina::runtime {

// Empty, or what is wrong; it names the material and its pass.
std::string plan_error(const World& world, std::span<const DrawnMaterial> materials, const FrameOptions& options);

}  // namespace patina::runtime
