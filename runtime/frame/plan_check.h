// Checks whether a world and its compiled materials can become a frame: nothing is missing, a list of draws can provide
// everything that the passes need, and the passes support the camera. frame_check.h checks the frame itself.
//
//   if (std::string error = plan_error(world, materials, options); !error.empty()) return Failure{error};
#pragma once

#include <span>
#include <string>

#include "runtime/frame/frame_plan.h"

namespace patina::runtime {

// Empty, or a message that names the material and its pass.
std::string plan_error(const World& world, std::span<const DrawnMaterial> materials, const FrameOptions& options);

}  // namespace patina::runtime
