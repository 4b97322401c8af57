// Checks a frame against the limits of a device before any object is created: a driver may crash if its limits are
// exceeded.
//
//   std::string error = beyond_limits(device.limits, device.name, frame);   // empty: the device can take it
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <string>

#include "runtime/gpu/renderer.h"

namespace patina::runtime {

// Empty, or the number that the frame needs and the number that the device has, with Vulkan's name of the limit.
// `most_allocation`: bytes that one image can have.
std::string beyond_limits(const VkPhysicalDeviceLimits& limits, const std::string& device, const Frame& frame,
                          std::uint64_t most_allocation = UINT64_MAX);
// The same for the frame of a draw.
std::string beyond_limits(const VkPhysicalDeviceLimits& limits, const std::string& device, const Draw& draw,
                          std::uint64_t most_allocation = UINT64_MAX);

}  // namespace patina::runtime
