#include "runtime/gpu/gpu_target.h"

#include "runtime/gpu/vulkan_words.h"

namespace patina::runtime {
namespace {

constexpr VkImageAspectFlags kColor = VK_IMAGE_ASPECT_COLOR_BIT;
constexpr VkImageAspectFlags kDepthStencil = VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT;

VkImageAspectFlags read_aspect(const PixelFormat& format) {
    return format.is_depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

Outcome<TargetImage> make_target_image(Gpu& gpu, const PixelFormat& format, std::uint32_t width, std::uint32_t height,
                                       VkImageUsageFlags usage, VkFormatFeatureFlags features) {
    if (!supports(gpu.device, vulkan_format(format.word), features))
        return Failure{"'" + gpu.device.name + "' cannot draw into a target of the format '" +
                       std::string(to_string(format.word)) + "'"};
    TargetImage made;
    made.image = make_gpu_image(gpu, {.width = width,
                                      .height = height,
                                      .format = vulkan_format(format.word),
                                      .usage = usage,
                                      .aspect = format.is_depth ? kDepthStencil : kColor});
    if (gpu.error.empty() && format.is_depth) made.depth_only = make_view(gpu, made.image, VK_IMAGE_ASPECT_DEPTH_BIT);
    if (!gpu.error.empty()) return Failure{gpu.error};
    return made;
}

bool fits(const GpuTarget& target, const FrameTarget& wanted) {
    const GpuImage& image = target.drawn.image;
    return image.handle && target.format == &pixel_format(wanted.format) &&
           image.width == std::uint32_t(wanted.width) && image.height == std::uint32_t(wanted.height);
}

VkExtent3D extent_of(const GpuImage& image) {
    return {image.width, image.height, 1};
}

}  // namespace

Outcome<bool> fit_targets(Gpu& gpu, std::vector<GpuTarget>& targets, std::span<const FrameTarget> wanted) {
    targets.resize(wanted.size());
    for (std::size_t i = 0; i < wanted.size(); i++)  // the old ones go before the new ones come
        if (!fits(targets[i], wanted[i])) targets[i] = {};
    for (std::size_t i = 0; i < wanted.size(); i++) {
        GpuTarget& target = targets[i];
        target.version = target.copied_version = 0;
        if (target.format) continue;
        const PixelFormat& format = pixel_format(wanted[i].format);
        Outcome<TargetImage> made = make_target_image(
            gpu, format, std::uint32_t(wanted[i].width), std::uint32_t(wanted[i].height),
            (format.is_depth ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT) |
                VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
            (format.is_depth ? VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT
                             : VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT) |
                VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT);
        if (!made) return Failure{made.error};
        target.drawn = std::move(made.value);
        target.format = &format;
    }
    return true;
}

Outcome<bool> need_copy(Gpu& gpu, GpuTarget& target) {
    if (target.copy.image.handle) return true;
    const GpuImage& image = target.drawn.image;
    Outcome<TargetImage> made = make_target_image(gpu, *target.format, image.width, image.height,
                                                  VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                                  VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT);
    if (!made) return Failure{made.error};
    target.copy = std::move(made.value);
    return true;
}

void clear_target(VkCommandBuffer commands, GpuTarget& target, const glm::vec4& value) {
    GpuImage& image = target.drawn.image;
    transition(commands, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    const VkImageSubresourceRange all{image.aspect, 0, 1, 0, 1};
    if (target.format->is_depth) {
        const VkClearDepthStencilValue clear{value.x, 0};
        vkCmdClearDepthStencilImage(commands, image.handle.get(), image.layout, &clear, 1, &all);
    } else {
        const VkClearColorValue clear{.float32 = {value.r, value.g, value.b, value.a}};
        vkCmdClearColorImage(commands, image.handle.get(), image.layout, &clear, 1, &all);
    }
    target.version = 1;
    target.copied_version = 0;
}

void copy_target(VkCommandBuffer commands, GpuTarget& target) {
    GpuImage &from = target.drawn.image, &to = target.copy.image;
    transition(commands, from, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    transition(commands, to, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    VkImageCopy region{};
    region.srcSubresource = region.dstSubresource = {read_aspect(*target.format), 0, 0, 1};
    region.extent = extent_of(from);
    vkCmdCopyImage(commands, from.handle.get(), from.layout, to.handle.get(), to.layout, 1, &region);
    transition(commands, to, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    target.copied_version = target.version;
}

void read_target(VkCommandBuffer commands, GpuTarget& target, const Buffer& buffer) {
    GpuImage& image = target.drawn.image;
    transition(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    VkBufferImageCopy copy{};
    copy.imageSubresource = {read_aspect(*target.format), 0, 0, 1};
    copy.imageExtent = extent_of(image);
    vkCmdCopyImageToBuffer(commands, image.handle.get(), image.layout, buffer.handle.get(), 1, &copy);
    VkMemoryBarrier2 for_host{};
    for_host.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    for_host.srcStageMask = VK_PIPELINE_STAGE_2_TRANSFER_BIT;
    for_host.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    for_host.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
    for_host.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
    VkDependencyInfo dependency{};
    dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &for_host;
    vkCmdPipelineBarrier2(commands, &dependency);
}

}  // namespace patina::runtime
