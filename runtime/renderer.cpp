#include "runtime/renderer.h"

#include <algorithm>
#include <cstring>
#include <map>

#include "runtime/gpu.h"
#include "runtime/limits.h"
#include "runtime/pipeline.h"

namespace patina::runtime {
namespace {

constexpr VkFormat kColorFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;
constexpr std::size_t kMostCachedTextures = 64;

// What is drawn into, kept from draw to draw while the size stays.
struct Targets {
    GpuImage color, depth;
    Buffer readback;
};

struct CachedTexture {
    std::shared_ptr<const TextureData> data;  // keeps the key's address from being used again
    GpuImage image;
    SamplerHandle sampler;
};
using TextureKey = std::pair<const TextureData*, TexelFormat>;

VkFormat vulkan_format(TexelFormat format) {
    switch (format) {
        case TexelFormat::Srgb8: return VK_FORMAT_R8G8B8A8_SRGB;
        case TexelFormat::Unorm8: return VK_FORMAT_R8G8B8A8_UNORM;
        case TexelFormat::Float32: break;
    }
    return VK_FORMAT_R32G32B32A32_SFLOAT;
}

std::size_t texel_size(TexelFormat format) {
    return format == TexelFormat::Float32 ? 16 : 4;
}

// Linear texels -> bytes of the format.
void store_texels(const TextureLevel& level, TexelFormat format, std::byte* target) {
    if (format == TexelFormat::Float32) {
        std::memcpy(target, level.texels.data(), level.texels.size() * sizeof(float));
        return;
    }
    for (std::size_t i = 0; i < level.texels.size(); i++) {
        bool encoded = format == TexelFormat::Srgb8 && i % 4 != 3;
        float value = encoded ? srgb_encode(level.texels[i]) : level.texels[i];
        target[i] = std::byte(std::clamp(value, 0.0f, 1.0f) * 255 + 0.5f);
    }
}

std::size_t aligned(std::size_t offset, std::size_t alignment) {
    return (offset + alignment - 1) / alignment * alignment;
}

bool supports_linear_filter(const Device& device, VkFormat format) {
    VkFormatProperties properties{};
    vkGetPhysicalDeviceFormatProperties(device.physical, format, &properties);
    return properties.optimalTilingFeatures & VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
}

Outcome<GpuImage> upload(Gpu& gpu, const LoadedTexture& texture) {
    const std::vector<TextureLevel>& levels = texture.data->levels;
    const auto faces = static_cast<std::uint32_t>(texture.data->faces);
    VkFormat format = vulkan_format(texture.format);
    if (!supports_linear_filter(gpu.device, format))
        return Failure{"'" + gpu.device.name + "' cannot filter the float texture '" + texture.name + "'"};
    GpuImage image = make_gpu_image(gpu, {.width = std::uint32_t(levels.front().width),
                                          .height = std::uint32_t(levels.front().height),
                                          .levels = std::uint32_t(levels.size()),
                                          .faces = faces,
                                          .format = format,
                                          .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    std::vector<VkBufferImageCopy> copies;
    std::size_t size = 0;
    for (std::uint32_t i = 0; i < levels.size(); i++) {
        copies.push_back({.bufferOffset = size,
                          .bufferRowLength = 0,
                          .bufferImageHeight = 0,
                          .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, i, 0, faces},
                          .imageOffset = {0, 0, 0},
                          .imageExtent = {std::uint32_t(levels[i].width), std::uint32_t(levels[i].height), 1}});
        size += std::size_t(levels[i].width) * levels[i].height * faces * texel_size(texture.format);
    }
    Buffer staging = make_buffer(gpu, size, VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    if (!gpu.error.empty()) return Failure{gpu.error};
    for (std::size_t i = 0; i < levels.size(); i++)
        store_texels(levels[i], texture.format, staging.data + copies[i].bufferOffset);

    run_commands(gpu, [&](VkCommandBuffer commands) {
        transition(commands, image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        vkCmdCopyBufferToImage(commands, staging.handle.get(), image.handle.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                               std::uint32_t(copies.size()), copies.data());
        transition(commands, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    });
    if (!gpu.error.empty()) return Failure{gpu.error};
    return image;
}

Targets make_targets(Gpu& gpu, std::uint32_t width, std::uint32_t height) {
    Targets targets;
    targets.color =
        make_gpu_image(gpu, {.width = width,
                             .height = height,
                             .format = kColorFormat,
                             .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
    targets.depth = make_gpu_image(gpu, {.width = width,
                                         .height = height,
                                         .format = kDepthFormat,
                                         .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                                         .aspect = VK_IMAGE_ASPECT_DEPTH_BIT});
    targets.readback = make_buffer(gpu, std::size_t(width) * height * 16, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    return targets;
}

// Vertices, indices and uniform blocks in one buffer.
struct DrawData {
    Buffer buffer;
    std::size_t index_offset = 0;
    std::vector<BoundBlock> blocks;
};

DrawData make_draw_data(Gpu& gpu, const Draw& draw) {
    const Mesh& mesh = draw.scene->mesh;
    DrawData data;
    data.index_offset = mesh.vertices.size() * sizeof(Vertex);
    std::size_t size = data.index_offset + mesh.indices.size() * sizeof(std::uint32_t);
    for (const BlockBytes& block : draw.blocks) {
        std::size_t offset = aligned(size, gpu.device.limits.minUniformBufferOffsetAlignment);
        data.blocks.push_back({.name = block.name, .offset = offset, .size = block.bytes.size()});
        size = offset + block.bytes.size();
    }
    data.buffer = make_buffer(
        gpu, size,
        VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    if (!data.buffer.data) return data;
    std::memcpy(data.buffer.data, mesh.vertices.data(), data.index_offset);
    std::memcpy(data.buffer.data + data.index_offset, mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t));
    for (std::size_t i = 0; i < data.blocks.size(); i++)
        std::memcpy(data.buffer.data + data.blocks[i].offset, draw.blocks[i].bytes.data(), data.blocks[i].size);
    return data;
}

VkRenderingAttachmentInfo attachment(const GpuImage& image, VkImageLayout layout, VkClearValue clear) {
    VkRenderingAttachmentInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
    info.imageView = image.view.get();
    info.imageLayout = layout;
    info.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    info.clearValue = clear;
    return info;
}

void record_draw(VkCommandBuffer commands, const Targets& targets, const DrawData& data, const Bindings& bindings,
                 VkPipeline pipeline, const Scene& scene) {
    transition(commands, targets.color, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    transition(commands, targets.depth, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
               VK_IMAGE_ASPECT_DEPTH_BIT);

    const glm::vec4& back = scene.background;
    VkRenderingAttachmentInfo color = attachment(targets.color, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                                 {.color = {.float32 = {back.r, back.g, back.b, back.a}}});
    VkRenderingAttachmentInfo depth =
        attachment(targets.depth, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, {.depthStencil = {1, 0}});
    VkRect2D area{{0, 0}, {targets.color.width, targets.color.height}};
    VkRenderingInfo rendering{};
    rendering.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
    rendering.renderArea = area;
    rendering.layerCount = 1;
    rendering.colorAttachmentCount = 1;
    rendering.pColorAttachments = &color;
    rendering.pDepthAttachment = &depth;

    vkCmdBeginRendering(commands, &rendering);
    // The negative height makes clip space y-up, as graphs and meshes are.
    auto width = float(area.extent.width), height = float(area.extent.height);
    VkViewport viewport{0, height, width, -height, 0, 1};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &area);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
    if (!bindings.sets.empty())
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, bindings.layout.get(), 0,
                                std::uint32_t(bindings.sets.size()), bindings.sets.data(), 0, nullptr);
    VkBuffer buffer = data.buffer.handle.get();
    VkDeviceSize start = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &buffer, &start);
    vkCmdBindIndexBuffer(commands, buffer, data.index_offset, VK_INDEX_TYPE_UINT32);
    vkCmdDrawIndexed(commands, std::uint32_t(scene.mesh.indices.size()), 1, 0, 0, 0);
    vkCmdEndRendering(commands);

    transition(commands, targets.color, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    VkBufferImageCopy copy{};
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    copy.imageExtent = {area.extent.width, area.extent.height, 1};
    vkCmdCopyImageToBuffer(commands, targets.color.handle.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           targets.readback.handle.get(), 1, &copy);
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

}  // namespace

Outcome<const Pass*> drawable_pass(const Draw& draw) {
    for (const Pass& pass : draw.reflection->passes) {
        if (pass.name != draw.pass) continue;
        if (pass.draws != "objects") return Failure{"the pass '" + pass.name + "' does not draw meshes"};
        if (pass.targets.size() != 1)
            return Failure{"the pass '" + pass.name + "' writes " + std::to_string(pass.targets.size()) +
                           " targets; one that can be seen writes 1"};
        const Scene& scene = *draw.scene;
        int limit = kLargestImage / std::max(scene.samples, 1);
        if (scene.samples < 1 || scene.width < 1 || scene.height < 1 || scene.width > limit || scene.height > limit)
            return Failure{"a picture of " + std::to_string(scene.width) + " x " + std::to_string(scene.height) +
                           " pixels with " + std::to_string(scene.samples) +
                           " samples along each axis is not between 1 and " + std::to_string(kLargestImage) +
                           " samples wide and high"};
        if (scene.mesh.indices.empty()) return Failure{"the scene has no mesh"};
        return &pass;
    }
    return Failure{"the material has no pass '" + draw.pass + "'"};
}

struct Renderer::Impl {
    std::unique_ptr<Device> device;  // first, so that it goes last
    Targets targets;
    std::map<TextureKey, CachedTexture> textures;

    Outcome<bool> resize(Gpu& gpu, std::uint32_t width, std::uint32_t height);
    Outcome<std::vector<BoundTexture>> bind_textures(Gpu& gpu, const Draw& draw);
};

Outcome<bool> Renderer::Impl::resize(Gpu& gpu, std::uint32_t width, std::uint32_t height) {
    if (targets.color.width == width && targets.color.height == height) return true;
    targets = {};  // the old ones go before the new ones come
    targets = make_targets(gpu, width, height);
    if (gpu.error.empty()) return true;
    targets = {};
    return Failure{gpu.error};
}

Outcome<std::vector<BoundTexture>> Renderer::Impl::bind_textures(Gpu& gpu, const Draw& draw) {
    if (textures.size() > kMostCachedTextures) textures.clear();
    std::vector<BoundTexture> bound;
    for (const LoadedTexture& texture : draw.textures) {
        TextureKey key{texture.data.get(), texture.format};
        auto found = textures.find(key);
        if (found == textures.end()) {
            Outcome<GpuImage> image = upload(gpu, texture);
            if (!image) return Failure{image.error};
            CachedTexture cached{.data = texture.data,
                                 .image = std::move(image.value),
                                 .sampler = make_sampler(gpu, texture.data->sampler)};
            if (!gpu.error.empty()) return Failure{gpu.error};
            found = textures.emplace(key, std::move(cached)).first;
        }
        bound.push_back(
            {.name = texture.name, .view = found->second.image.view.get(), .sampler = found->second.sampler.get()});
    }
    return bound;
}

Renderer::Renderer() : impl_(std::make_unique<Impl>()) {}
Renderer::~Renderer() = default;

Outcome<std::unique_ptr<Renderer>> Renderer::open(const DeviceOptions& options) {
    Outcome<std::unique_ptr<Device>> device = open_device(options);
    if (!device) return Failure{device.error};
    std::unique_ptr<Renderer> renderer(new Renderer);
    renderer->impl_->device = std::move(device.value);
    return renderer;
}

Outcome<Image> Renderer::draw(const Draw& draw) {
    Outcome<const Pass*> pass = drawable_pass(draw);
    if (!pass) return Failure{pass.error};
    if (std::string error = beyond_limits(draw); !error.empty()) return Failure{error};
    const Scene& scene = *draw.scene;
    Gpu gpu{.device = *impl_->device, .error = {}};

    int width = scene.width * scene.samples, height = scene.height * scene.samples;
    if (auto sized = impl_->resize(gpu, std::uint32_t(width), std::uint32_t(height)); !sized)
        return Failure{sized.error};
    auto textures = impl_->bind_textures(gpu, draw);
    if (!textures) return Failure{textures.error};
    DrawData data = make_draw_data(gpu, draw);
    if (!gpu.error.empty()) return Failure{gpu.error};

    auto bindings = make_bindings(gpu, *draw.reflection, data.buffer.handle.get(), data.blocks, textures.value);
    if (!bindings) return Failure{bindings.error};
    auto pipeline = make_pipeline(gpu, {.pass = pass.value,
                                        .layout = bindings.value.layout.get(),
                                        .vertex_spirv = draw.vertex_spirv,
                                        .fragment_spirv = draw.fragment_spirv,
                                        .color_format = kColorFormat,
                                        .depth_format = kDepthFormat});
    if (!pipeline) return Failure{pipeline.error};

    run_commands(gpu, [&](VkCommandBuffer commands) {
        record_draw(commands, impl_->targets, data, bindings.value, pipeline.value.get(), scene);
    });
    if (!gpu.error.empty()) return Failure{gpu.error};

    Image image{.width = width, .height = height, .pixels = std::vector<float>(4 * std::size_t(width) * height)};
    std::memcpy(image.pixels.data(), impl_->targets.readback.data, image.pixels.size() * sizeof(float));
    return box_filtered(image, scene.samples);
}

std::string Renderer::beyond_limits(const Draw& draw) const {
    return runtime::beyond_limits(impl_->device->limits, impl_->device->name, draw);
}

const std::string& Renderer::device_name() const {
    return impl_->device->name;
}
const std::vector<std::string>& Renderer::messages() const {
    return impl_->device->messages;
}

}  // namespace patina::runtime
