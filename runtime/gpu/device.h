// A headless Vulkan 1.3 device: instance, one queue, one command pool, and the messages of the validation layer. It has
// no surface and no swapchain. The default is a software device (lavapipe), so that pictures are the same everywhere; a
// GPU is chosen by name.
//
//   Outcome<std::unique_ptr<Device>> device = open_device({.validation = true});
//   if (!device) return Failure{device.error};   // says what to install
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "runtime/outcome.h"

namespace patina::runtime {

struct DeviceOptions {
    bool validation = false;  // Khronos validation layer, synchronisation checks included
    std::string device{};     // part of the device's name, any case; empty: the first software device, else the first
    friend bool operator==(const DeviceOptions&, const DeviceOptions&) = default;
};

struct Device {
    VkInstance instance = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;  // graphics
    std::uint32_t queue_family = 0;
    VkCommandPool commands = VK_NULL_HANDLE;
    VkPhysicalDeviceMemoryProperties memory{};
    VkPhysicalDeviceLimits limits{};
    std::uint64_t most_allocation = 0;  // bytes that one image or buffer can have
    bool anisotropy = false;
    bool independent_blend = false;     // targets of one draw may blend differently
    bool symmetric_depth = false;       // clip space may begin at z = -w
    std::string name, driver;           // the driver with its version: "llvmpipe Mesa 22.3.6 (LLVM 15.0.6)"
    std::vector<std::string> messages;  // warnings and errors of the validation layer

    Device() = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    ~Device();
};

Outcome<std::unique_ptr<Device>> open_device(const DeviceOptions& options);

// "VK_ERROR_OUT_OF_DEVICE_MEMORY", or the number of a result that is not known by name.
std::string result_name(VkResult result);

}  // namespace patina::runtime
