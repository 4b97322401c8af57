// What a device cannot take, found out before anything is made for a frame: a driver that is asked for more than it
// says it has may crash.
//
//   std::string error = beyond_limits(device.limits, device.name, frame);   // empty: the device can take it
#pragma once

#include <vulkan/vulkan.h>

#include <string>

#include "runtime/gpu/renderer.h"

namespace patina::runtime {

// Empty, or what the frame needs and what the device has, with Vulkan's name of the limit.
std::string beyond_limits(const VkPhysicalDeviceLimits& limits, const std::string& device, const Frame& frame);
// The same of the frame that the draw stands for.
std::string beyond_limits(const VkPhysicalDeviceLimits& limits, const std::string& device, const Draw& draw);

}  // namespace patina::runtime
