// Vulkan objects as plain structs that free themselves, and the few free functions that make them: buffers, images,
// samplers, one-off command buffers. Only renderer.cpp and the files with its parts (gpu_*.cpp, bindings.cpp,
// pipeline.cpp) include this header.
//
// Creation can fail only for want of memory or on a lost device; then the result is null and Gpu::error says why: make
// several things, then ask once.
//
//   Gpu gpu{*device};
//   Buffer vertices = make_buffer(gpu, size, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
//   if (!gpu.error.empty()) return Failure{gpu.error};
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "patina/reflection.h"
#include "runtime/gpu/device.h"

namespace patina::runtime {

// A device and the first thing that went wrong on it since the caller last looked.
struct Gpu {
    const Device& device;
    std::string error;

    // True if `result` is success; else keeps "cannot <what>: VK_ERROR...".
    bool check(VkResult result, const char* what);
};

// An object that vkDestroyX(device, handle, nullptr) destroys.
template <class Handle, auto destroy>
class Owned {
public:
    Owned() = default;
    Owned(VkDevice device, Handle handle) : device_(device), handle_(handle) {}
    Owned(Owned&& other) noexcept : device_(other.device_), handle_(std::exchange(other.handle_, VK_NULL_HANDLE)) {}
    Owned& operator=(Owned&& other) noexcept {
        std::swap(device_, other.device_);
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~Owned() {
        if (handle_) destroy(device_, handle_, nullptr);
    }
    Handle get() const { return handle_; }
    explicit operator bool() const { return handle_ != VK_NULL_HANDLE; }

private:
    VkDevice device_ = VK_NULL_HANDLE;
    Handle handle_ = VK_NULL_HANDLE;
};

using Memory = Owned<VkDeviceMemory, vkFreeMemory>;
using SamplerHandle = Owned<VkSampler, vkDestroySampler>;
using ViewHandle = Owned<VkImageView, vkDestroyImageView>;
using ShaderHandle = Owned<VkShaderModule, vkDestroyShaderModule>;
using SetLayoutHandle = Owned<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout>;
using PoolHandle = Owned<VkDescriptorPool, vkDestroyDescriptorPool>;
using LayoutHandle = Owned<VkPipelineLayout, vkDestroyPipelineLayout>;
using PipelineHandle = Owned<VkPipeline, vkDestroyPipeline>;

// Host-visible and mapped for its whole life.
struct Buffer {
    Memory memory;
    Owned<VkBuffer, vkDestroyBuffer> handle;  // goes before its memory
    std::byte* data = nullptr;
    std::size_t size = 0;
};
Buffer make_buffer(Gpu& gpu, std::size_t size, VkBufferUsageFlags usage);

struct GpuImage {
    Memory memory;
    Owned<VkImage, vkDestroyImage> handle;
    ViewHandle view;  // of all of it
    std::uint32_t width = 0, height = 0, levels = 1, layers = 1;
    TextureDimension dimension = TextureDimension::Flat;
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;  // after everything that has been recorded
};
struct ImageInfo {
    std::uint32_t width = 1, height = 1, levels = 1;
    std::uint32_t layers = 1;  // of an array; 6 of a cube
    std::uint32_t depth = 1;   // of a 3D texture
    TextureDimension dimension = TextureDimension::Flat;
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkImageUsageFlags usage = 0;
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
};
GpuImage make_gpu_image(Gpu& gpu, const ImageInfo& info);
// Of some of the image's aspects.
ViewHandle make_view(Gpu& gpu, const GpuImage& image, VkImageAspectFlags aspect);
// Whether images of the format can be used in all these ways.
bool supports(const Device& device, VkFormat format, VkFormatFeatureFlags features);

SamplerHandle make_sampler(Gpu& gpu, const Sampler& sampler);

// Changes the layout of a whole image, or only waits if the layout is the same. Everything before it must be done, and
// everything after it waits. There is one queue with little on it, so finer barriers would gain nothing.
void transition(VkCommandBuffer commands, GpuImage& image, VkImageLayout to);

// Records, submits and waits.
bool run_commands(Gpu& gpu, const std::function<void(VkCommandBuffer)>& record);

}  // namespace patina::runtime
