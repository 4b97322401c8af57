#include "runtime/gpu/gpu_upload.h"

#include <algorithm>
#include <cstring>

namespace patina::runtime {
namespace {

constexpr std::size_t kMostCachedTextures = 64;

VkFormat texel_format(TexelFormat format) {
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

Outcome<GpuImage> upload(Gpu& gpu, const LoadedTexture& texture) {
    const std::vector<TextureLevel>& levels = texture.data->levels;
    const auto layers = static_cast<std::uint32_t>(texture.data->layers);
    VkFormat format = texel_format(texture.format);
    if (!supports(gpu.device, format, VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT))
        return Failure{"'" + gpu.device.name + "' cannot filter the float texture '" + texture.name + "'"};
    GpuImage image = make_gpu_image(gpu, {.width = std::uint32_t(levels.front().width),
                                          .height = std::uint32_t(levels.front().height),
                                          .levels = std::uint32_t(levels.size()),
                                          .layers = layers,
                                          .depth = std::uint32_t(levels.front().depth),
                                          .dimension = texture.dimension,
                                          .format = format,
                                          .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    std::vector<VkBufferImageCopy> copies;
    std::size_t size = 0;
    for (std::uint32_t i = 0; i < levels.size(); i++) {
        copies.push_back({.bufferOffset = size,
                          .bufferRowLength = 0,
                          .bufferImageHeight = 0,
                          .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, i, 0, layers},
                          .imageOffset = {0, 0, 0},
                          .imageExtent = {std::uint32_t(levels[i].width), std::uint32_t(levels[i].height),
                                          std::uint32_t(levels[i].depth)}});
        size += std::size_t(levels[i].width) * levels[i].height * levels[i].depth * layers * texel_size(texture.format);
    }
    Buffer staging = make_buffer(gpu, size, VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    if (!gpu.error.empty()) return Failure{gpu.error};
    for (std::size_t i = 0; i < levels.size(); i++)
        store_texels(levels[i], texture.format, staging.data + copies[i].bufferOffset);

    run_commands(gpu, [&](VkCommandBuffer commands) {
        transition(commands, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        vkCmdCopyBufferToImage(commands, staging.handle.get(), image.handle.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                               std::uint32_t(copies.size()), copies.data());
        transition(commands, image, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    });
    if (!gpu.error.empty()) return Failure{gpu.error};
    return image;
}

std::size_t aligned(std::size_t offset, std::size_t alignment) {
    return (offset + alignment - 1) / alignment * alignment;
}

template <class Element>
void copy_to(Buffer& buffer, std::size_t offset, const std::vector<Element>& from) {
    std::memcpy(buffer.data + offset, from.data(), from.size() * sizeof(Element));
}

}  // namespace

void TextureCache::trim() {
    if (textures_.size() > kMostCachedTextures) textures_.clear();
}

Outcome<BoundTexture> TextureCache::bind(Gpu& gpu, const LoadedTexture& texture) {
    auto found = textures_.find({texture.data.get(), texture.format});
    if (found == textures_.end()) {
        Outcome<GpuImage> image = upload(gpu, texture);
        if (!image) return Failure{image.error};
        Cached cached{
            .data = texture.data, .image = std::move(image.value), .sampler = make_sampler(gpu, texture.data->sampler)};
        if (!gpu.error.empty()) return Failure{gpu.error};
        found = textures_.emplace(std::pair(texture.data.get(), texture.format), std::move(cached)).first;
    }
    const Cached& cached = found->second;
    return BoundTexture{.name = texture.name, .view = cached.image.view.get(), .sampler = cached.sampler.get()};
}

FrameData make_frame_data(Gpu& gpu, const Frame& frame) {
    FrameData data;
    std::size_t size = 0;
    for (const FrameStep& step : frame.steps) {
        if (data.meshes.contains(step.mesh)) continue;
        const std::size_t indices = size + step.mesh->vertices.size() * sizeof(Vertex);
        data.meshes[step.mesh] = {.vertices = size, .indices = indices};
        size = indices + step.mesh->indices.size() * sizeof(std::uint32_t);
    }
    for (const FrameStep& step : frame.steps) {
        std::vector<BoundBlock>& blocks = data.blocks.emplace_back();
        for (const BlockBytes& block : step.blocks) {
            const std::size_t offset = aligned(size, gpu.device.limits.minUniformBufferOffsetAlignment);
            blocks.push_back({.name = block.name, .offset = offset, .size = block.bytes.size()});
            size = offset + block.bytes.size();
        }
    }
    if (size == 0) return data;
    data.buffer = make_buffer(
        gpu, size,
        VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    if (!data.buffer.data) return data;
    for (const auto& [mesh, place] : data.meshes) {
        copy_to(data.buffer, place.vertices, mesh->vertices);
        copy_to(data.buffer, place.indices, mesh->indices);
    }
    for (std::size_t i = 0; i < frame.steps.size(); i++)
        for (std::size_t k = 0; k < data.blocks[i].size(); k++)
            copy_to(data.buffer, data.blocks[i][k].offset, frame.steps[i].blocks[k].bytes);
    return data;
}

}  // namespace patina::runtime
