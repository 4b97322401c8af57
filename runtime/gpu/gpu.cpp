#include "runtime/gpu/gpu.h"

#include <algorithm>

#include "runtime/gpu/vulkan_words.h"

namespace patina::runtime {
namespace {

// Index of a memory type among `allowed` with all the wanted flags, or -1.
int memory_type(const Device& device, std::uint32_t allowed, VkMemoryPropertyFlags wanted) {
    for (std::uint32_t i = 0; i < device.memory.memoryTypeCount; i++)
        if (allowed >> i & 1 && (device.memory.memoryTypes[i].propertyFlags & wanted) == wanted) return int(i);
    return -1;
}

Memory allocate(Gpu& gpu, const VkMemoryRequirements& needs, std::initializer_list<VkMemoryPropertyFlags> choices) {
    int type = -1;
    for (VkMemoryPropertyFlags wanted : choices)
        if (type < 0) type = memory_type(gpu.device, needs.memoryTypeBits, wanted);
    if (type < 0) {
        gpu.check(VK_ERROR_OUT_OF_DEVICE_MEMORY, "find suitable memory");
        return {};
    }
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = needs.size;
    info.memoryTypeIndex = std::uint32_t(type);
    VkDeviceMemory memory = VK_NULL_HANDLE;
    gpu.check(vkAllocateMemory(gpu.device.device, &info, nullptr, &memory), "allocate memory");
    return {gpu.device.device, memory};
}

}  // namespace

bool Gpu::check(VkResult result, const char* what) {
    if (result == VK_SUCCESS) return true;
    if (error.empty()) error = "'" + device.name + "' cannot " + what + ": " + result_name(result);
    return false;
}

Buffer make_buffer(Gpu& gpu, std::size_t size, VkBufferUsageFlags usage) {
    VkDevice device = gpu.device.device;
    Buffer buffer;
    buffer.size = size;
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = size;
    info.usage = usage;
    VkBuffer handle = VK_NULL_HANDLE;
    if (!gpu.check(vkCreateBuffer(device, &info, nullptr, &handle), "make a buffer")) return {};
    buffer.handle = {device, handle};

    VkMemoryRequirements needs{};
    vkGetBufferMemoryRequirements(device, handle, &needs);
    // Cached memory makes reading pictures back many times faster; some devices offer none that is coherent too.
    constexpr VkMemoryPropertyFlags kHost = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    buffer.memory = allocate(gpu, needs, {kHost | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, kHost});
    if (!buffer.memory) return {};
    void* data = nullptr;
    if (!gpu.check(vkBindBufferMemory(device, handle, buffer.memory.get(), 0), "bind a buffer")) return {};
    if (!gpu.check(vkMapMemory(device, buffer.memory.get(), 0, VK_WHOLE_SIZE, 0, &data), "map a buffer")) return {};
    buffer.data = static_cast<std::byte*>(data);
    return buffer;
}

GpuImage make_gpu_image(Gpu& gpu, const ImageInfo& wanted) {
    VkDevice device = gpu.device.device;
    GpuImage image;
    image.width = wanted.width;
    image.height = wanted.height;
    image.levels = wanted.levels;
    image.layers = wanted.layers;
    image.dimension = wanted.dimension;
    image.format = wanted.format;
    image.aspect = wanted.aspect;
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.flags = wanted.dimension == TextureDimension::Cube ? VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT : 0;
    info.imageType = wanted.dimension == TextureDimension::Volume ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D;
    info.format = wanted.format;
    info.extent = {wanted.width, wanted.height, wanted.depth};
    info.mipLevels = wanted.levels;
    info.arrayLayers = wanted.layers;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = wanted.usage;
    info.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    VkImage handle = VK_NULL_HANDLE;
    if (!gpu.check(vkCreateImage(device, &info, nullptr, &handle), "make an image")) return {};
    image.handle = {device, handle};

    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(device, handle, &needs);
    image.memory = allocate(gpu, needs, {VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0});
    if (!image.memory) return {};
    if (!gpu.check(vkBindImageMemory(device, handle, image.memory.get(), 0), "bind an image")) return {};

    image.view = make_view(gpu, image, wanted.aspect);
    if (!image.view) return {};
    return image;
}

namespace {

VkImageViewType view_type(TextureDimension dimension) {
    switch (dimension) {
        case TextureDimension::Cube: return VK_IMAGE_VIEW_TYPE_CUBE;
        case TextureDimension::Array: return VK_IMAGE_VIEW_TYPE_2D_ARRAY;
        case TextureDimension::Volume: return VK_IMAGE_VIEW_TYPE_3D;
        case TextureDimension::Flat: break;
    }
    return VK_IMAGE_VIEW_TYPE_2D;
}

}  // namespace

ViewHandle make_view(Gpu& gpu, const GpuImage& image, VkImageAspectFlags aspect) {
    VkImageViewCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    info.image = image.handle.get();
    info.viewType = view_type(image.dimension);
    info.format = image.format;
    info.subresourceRange = {aspect, 0, image.levels, 0, image.layers};
    VkImageView handle = VK_NULL_HANDLE;
    gpu.check(vkCreateImageView(gpu.device.device, &info, nullptr, &handle), "make an image view");
    return {gpu.device.device, handle};
}

bool supports(const Device& device, VkFormat format, VkFormatFeatureFlags features) {
    VkFormatProperties properties{};
    vkGetPhysicalDeviceFormatProperties(device.physical, format, &properties);
    return (properties.optimalTilingFeatures & features) == features;
}

SamplerHandle make_sampler(Gpu& gpu, const Sampler& sampler) {
    const bool nearest = sampler.filter == Filter::Nearest;
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.magFilter = info.minFilter = nearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR;
    info.mipmapMode = nearest ? VK_SAMPLER_MIPMAP_MODE_NEAREST : VK_SAMPLER_MIPMAP_MODE_LINEAR;
    info.addressModeU = info.addressModeV = info.addressModeW = vulkan_wrap(sampler.wrap);
    info.anisotropyEnable = gpu.device.anisotropy && sampler.anisotropy > 1 && !nearest;
    info.maxAnisotropy = std::clamp(float(sampler.anisotropy), 1.0f, gpu.device.limits.maxSamplerAnisotropy);
    info.maxLod = VK_LOD_CLAMP_NONE;
    VkSampler handle = VK_NULL_HANDLE;
    gpu.check(vkCreateSampler(gpu.device.device, &info, nullptr, &handle), "make a sampler");
    return {gpu.device.device, handle};
}

void transition(VkCommandBuffer commands, GpuImage& image, VkImageLayout to) {
    VkImageMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.oldLayout = std::exchange(image.layout, to);
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image.handle.get();
    barrier.subresourceRange = {image.aspect, 0, image.levels, 0, image.layers};
    VkDependencyInfo dependency{};
    dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

bool run_commands(Gpu& gpu, const std::function<void(VkCommandBuffer)>& record) {
    const Device& device = gpu.device;
    VkCommandBufferAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocate.commandPool = device.commands;
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    if (!gpu.check(vkAllocateCommandBuffers(device.device, &allocate, &commands), "make a command buffer"))
        return false;

    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    bool good = gpu.check(vkBeginCommandBuffer(commands, &begin), "record commands");
    if (good) {
        record(commands);
        good = gpu.check(vkEndCommandBuffer(commands), "record commands");
    }
    VkCommandBufferSubmitInfo buffer{};
    buffer.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
    buffer.commandBuffer = commands;
    VkSubmitInfo2 submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
    submit.commandBufferInfoCount = 1;
    submit.pCommandBufferInfos = &buffer;
    good = good && gpu.check(vkQueueSubmit2(device.queue, 1, &submit, VK_NULL_HANDLE), "submit commands") &&
           gpu.check(vkQueueWaitIdle(device.queue), "finish drawing");
    vkFreeCommandBuffers(device.device, device.commands, 1, &commands);
    return good;
}

}  // namespace patina::runtime
