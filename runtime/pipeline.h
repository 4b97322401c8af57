// A reflection's words turned into Vulkan's objects: descriptor sets with all its blocks and textures, and the graphics
// pipeline of a pass with its vertex inputs and state. Drawing itself is renderer.cpp.
//
//   Outcome<Bindings> bindings = make_bindings(gpu, reflection, uniform_buffer, blocks, textures);
//   Outcome<PipelineHandle> pipeline = make_pipeline(gpu, {.pass = &pass, .layout = bindings.value.layout.get(), ...});
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "patina/reflection.h"
#include "runtime/gpu.h"
#include "runtime/outcome.h"

namespace patina::runtime {

struct BoundBlock {
    std::string name;
    VkDeviceSize offset = 0;  // in the uniform buffer
    VkDeviceSize size = 0;
};
struct BoundTexture {
    std::string name;
    VkImageView view = VK_NULL_HANDLE;
    VkSampler sampler = VK_NULL_HANDLE;
};

// Sets 0 to the highest that the reflection uses; sets between that it does not use are empty.
struct Bindings {
    std::vector<SetLayoutHandle> set_layouts;
    LayoutHandle layout;
    PoolHandle pool;
    std::vector<VkDescriptorSet> sets;
};
// Descriptors of uniform buffers that make_bindings() asks for.
std::uint32_t uniform_buffer_count(const Reflection& reflection);
Outcome<Bindings> make_bindings(Gpu& gpu, const Reflection& reflection, VkBuffer uniforms,
                                std::span<const BoundBlock> blocks, std::span<const BoundTexture> textures);

struct PipelineInfo {
    const Pass* pass = nullptr;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    std::span<const std::uint32_t> vertex_spirv{};
    std::span<const std::uint32_t> fragment_spirv{};
    VkFormat color_format = VK_FORMAT_UNDEFINED;
    VkFormat depth_format = VK_FORMAT_UNDEFINED;
};
Outcome<PipelineHandle> make_pipeline(Gpu& gpu, const PipelineInfo& info);

}  // namespace patina::runtime
