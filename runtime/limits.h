// What a device cannot take, found out before anything is made for a draw: a driver that is asked for more than it says
// it has may crash.
//
//   std::string error = beyond_limits(device.limits, device.name, draw);   // empty: the device can take it
#pragma once

#include <vulkan/vulkan.h>

#include <string>

#include "runtime/renderer.h"

namespace patina::runtime {

// Empty, or what the draw needs and what the device has, with Vulkan's name of the limit.
std::string beyond_limits(const VkPhysicalDeviceLimits& limits, const std::string& device, const Draw& draw);

}  // namespace patina::runtime
