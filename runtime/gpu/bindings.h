// A reflection's blocks and textures as Vulkan's descriptor sets. First, the places of all resources are found. The
// layout depends only on their shape, and steps of the same shape share it; each step fills its own sets.
//
//   Slots slots = find_slots(reflection, uniform_buffer, blocks, textures);
//   BindingLayout layout = make_layout(gpu, slots);
//   BoundSets bound = make_sets(gpu, layout, slots);
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "patina/reflection.h"
#include "runtime/gpu/gpu.h"

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

// What is bound where: the keys are (set, binding).
struct Slot {
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    std::uint32_t count = 1;  // an array that is longer than 1 holds the same in each element
    VkDescriptorBufferInfo buffer{};
    VkDescriptorImageInfo image{};
};
using Slots = std::map<std::pair<std::uint32_t, std::uint32_t>, Slot>;

// Everything that the reflection has and that is given; the places are the same in every pass. Blocks are all there
// (frame_check.h), and so are the textures that the pass reads. `samplers`: one for each of Reflection::samplers.
Slots find_slots(const Reflection& reflection, VkBuffer uniforms, std::span<const BoundBlock> blocks,
                 std::span<const BoundTexture> textures, std::span<const VkSampler> samplers);
// Descriptors of uniform buffers that find_slots() asks for.
std::uint32_t uniform_buffer_count(const Reflection& reflection);

// Sets 0 to the highest that is used; sets between that are not used are empty.
struct BindingLayout {
    std::vector<SetLayoutHandle> sets;
    LayoutHandle layout;
};
BindingLayout make_layout(Gpu& gpu, const Slots& slots);
// Equal shape, equal layout: set, binding, type and count of each slot.
using SlotShape = std::vector<std::array<std::uint32_t, 4>>;
SlotShape shape_of(const Slots& slots);

struct BoundSets {
    PoolHandle pool;
    std::vector<VkDescriptorSet> sets;
};
BoundSets make_sets(Gpu& gpu, const BindingLayout& layout, const Slots& slots);

}  // namespace patina::runtime
