#include "runtime/gpu/bindings.h"

#include <algorithm>

namespace patina::runtime {
namespace {

template <class Range>
auto* find_named(Range&& range, const std::string& name) {
    auto found = std::find_if(range.begin(), range.end(), [&](const auto& item) { return item.name == name; });
    return found == range.end() ? nullptr : &*found;
}

// lavapipe (Mesa 22.3) numbers the uniform buffers of a stage from 1, in the order of sets and bindings. In a shader of
// more than 100 values it records which uniforms decide a branch. Its record for number 4 overwrites its own counters,
// and the draw crashes. So the third buffer takes two numbers, and nobody is number 4. The others up to 8 are safe.
constexpr std::uint32_t kDoubledBuffer = 3;

void leave_out_buffer_4(Slots& slots) {
    std::uint32_t number = 0;
    for (auto& [place, slot] : slots)
        if (slot.type == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER && ++number == kDoubledBuffer) slot.count = 2;
}

PoolHandle make_pool(Gpu& gpu, const BindingLayout& layout, const Slots& slots) {
    std::vector<VkDescriptorPoolSize> sizes;
    for (VkDescriptorType type :
         {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, VK_DESCRIPTOR_TYPE_SAMPLER}) {
        std::uint32_t count = 0;
        for (const auto& [place, slot] : slots)
            if (slot.type == type) count += slot.count;
        if (count) sizes.push_back({type, count});
    }
    VkDescriptorPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    info.maxSets = std::uint32_t(layout.sets.size());
    info.poolSizeCount = std::uint32_t(sizes.size());
    info.pPoolSizes = sizes.data();
    VkDescriptorPool pool = VK_NULL_HANDLE;
    gpu.check(vkCreateDescriptorPool(gpu.device.device, &info, nullptr, &pool), "make a descriptor pool");
    return {gpu.device.device, pool};
}

}  // namespace

Slots find_slots(const Reflection& reflection, VkBuffer uniforms, std::span<const BoundBlock> blocks,
                 std::span<const BoundTexture> textures, std::span<const VkSampler> samplers) {
    Slots slots;
    for (const Block& block : reflection.blocks) {
        if (const BoundBlock* bound = find_named(blocks, block.name))
            slots[{block.set, block.binding}] = {.buffer = {uniforms, bound->offset, bound->size}};
    }
    for (const Texture& texture : reflection.textures) {
        const BoundTexture* bound = find_named(textures, texture.name);
        if (!bound) continue;  // this pass does not read it
        slots[{texture.set, texture.binding}] = {
            .type = VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE,
            .image = {VK_NULL_HANDLE, bound->view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}};
        slots[{texture.set, texture.sampler_binding}] = {.type = VK_DESCRIPTOR_TYPE_SAMPLER,
                                                         .image = {bound->sampler, VK_NULL_HANDLE, {}}};
    }
    for (std::size_t i = 0; i < samplers.size(); i++) {
        const BoundSampler& sampler = reflection.samplers[i];
        slots[{sampler.set, sampler.binding}] = {.type = VK_DESCRIPTOR_TYPE_SAMPLER,
                                                 .image = {samplers[i], VK_NULL_HANDLE, {}}};
    }
    leave_out_buffer_4(slots);
    return slots;
}

std::uint32_t uniform_buffer_count(const Reflection& reflection) {
    auto blocks = std::uint32_t(reflection.blocks.size());
    return blocks + (blocks >= kDoubledBuffer ? 1 : 0);
}

SlotShape shape_of(const Slots& slots) {
    SlotShape shape;
    for (const auto& [place, slot] : slots)
        shape.push_back({place.first, place.second, std::uint32_t(slot.type), slot.count});
    return shape;
}

BindingLayout make_layout(Gpu& gpu, const Slots& slots) {
    VkDevice device = gpu.device.device;
    BindingLayout made;
    std::uint32_t set_count = slots.empty() ? 0 : slots.rbegin()->first.first + 1;
    std::vector<VkDescriptorSetLayout> handles;
    for (std::uint32_t set = 0; set < set_count; set++) {
        std::vector<VkDescriptorSetLayoutBinding> in_set;
        for (const auto& [place, slot] : slots)
            if (place.first == set)
                in_set.push_back({place.second, slot.type, slot.count,
                                  VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, nullptr});
        VkDescriptorSetLayoutCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
        info.bindingCount = std::uint32_t(in_set.size());
        info.pBindings = in_set.data();
        VkDescriptorSetLayout handle = VK_NULL_HANDLE;
        gpu.check(vkCreateDescriptorSetLayout(device, &info, nullptr, &handle), "make a descriptor set layout");
        made.sets.emplace_back(device, handle);
        handles.push_back(handle);
    }
    if (!gpu.error.empty()) return made;

    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = set_count;
    info.pSetLayouts = handles.data();
    VkPipelineLayout layout = VK_NULL_HANDLE;
    gpu.check(vkCreatePipelineLayout(device, &info, nullptr, &layout), "make a pipeline layout");
    made.layout = {device, layout};
    return made;
}

BoundSets make_sets(Gpu& gpu, const BindingLayout& layout, const Slots& slots) {
    VkDevice device = gpu.device.device;
    BoundSets bound;
    if (layout.sets.empty()) return bound;
    bound.pool = make_pool(gpu, layout, slots);
    if (!bound.pool) return bound;

    std::vector<VkDescriptorSetLayout> layouts;
    for (const SetLayoutHandle& set : layout.sets) layouts.push_back(set.get());
    VkDescriptorSetAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    allocate.descriptorPool = bound.pool.get();
    allocate.descriptorSetCount = std::uint32_t(layouts.size());
    allocate.pSetLayouts = layouts.data();
    bound.sets.resize(layouts.size());
    if (!gpu.check(vkAllocateDescriptorSets(device, &allocate, bound.sets.data()), "make descriptor sets"))
        return bound;

    std::vector<VkWriteDescriptorSet> writes;
    for (const auto& [place, slot] : slots) {
        VkWriteDescriptorSet write{};
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstSet = bound.sets[place.first];
        write.dstBinding = place.second;
        write.descriptorCount = 1;
        write.descriptorType = slot.type;
        write.pBufferInfo = &slot.buffer;
        write.pImageInfo = &slot.image;
        for (; write.dstArrayElement < slot.count; write.dstArrayElement++) writes.push_back(write);
    }
    vkUpdateDescriptorSets(device, std::uint32_t(writes.size()), writes.data(), 0, nullptr);
    return bound;
}

}  // namespace patina::runtime
