#include "runtime/pipeline.h"

#include <algorithm>
#include <map>
#include <optional>

#include "runtime/vertex_inputs.h"

namespace patina::runtime {
namespace {

// A reflection's word -> Vulkan's value; the tables are short, so they are searched.
template <class Value>
struct Word {
    std::string_view word;
    Value value;
};

template <class Value, std::size_t count>
std::optional<Value> find_word(const Word<Value> (&table)[count], std::string_view word) {
    for (const Word<Value>& entry : table)
        if (entry.word == word) return entry.value;
    return std::nullopt;
}

constexpr Word<VkCullModeFlags> kCullModes[] = {
    {"back", VK_CULL_MODE_BACK_BIT}, {"front", VK_CULL_MODE_FRONT_BIT}, {"off", VK_CULL_MODE_NONE}};

constexpr Word<VkCompareOp> kDepthTests[] = {{"never", VK_COMPARE_OP_NEVER},
                                             {"less", VK_COMPARE_OP_LESS},
                                             {"equal", VK_COMPARE_OP_EQUAL},
                                             {"lessEqual", VK_COMPARE_OP_LESS_OR_EQUAL},
                                             {"greater", VK_COMPARE_OP_GREATER},
                                             {"notEqual", VK_COMPARE_OP_NOT_EQUAL},
                                             {"greaterEqual", VK_COMPARE_OP_GREATER_OR_EQUAL},
                                             {"always", VK_COMPARE_OP_ALWAYS}};

constexpr Word<VkBlendFactor> kBlendFactors[] = {{"one", VK_BLEND_FACTOR_ONE},
                                                 {"zero", VK_BLEND_FACTOR_ZERO},
                                                 {"src_alpha", VK_BLEND_FACTOR_SRC_ALPHA},
                                                 {"one_minus_src_alpha", VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA}};

constexpr VkFormat kFloats[] = {VK_FORMAT_UNDEFINED, VK_FORMAT_R32_SFLOAT, VK_FORMAT_R32G32_SFLOAT,
                                VK_FORMAT_R32G32B32_SFLOAT, VK_FORMAT_R32G32B32A32_SFLOAT};

// What is bound where: the keys are (set, binding).
struct Slot {
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    std::uint32_t count = 1;  // an array that is longer than 1 holds the same in each element
    VkDescriptorBufferInfo buffer{};
    VkDescriptorImageInfo image{};
};
using Slots = std::map<std::pair<std::uint32_t, std::uint32_t>, Slot>;

template <class Range>
auto* find_named(Range&& range, const std::string& name) {
    auto found = std::find_if(range.begin(), range.end(), [&](const auto& item) { return item.name == name; });
    return found == range.end() ? nullptr : &*found;
}

// lavapipe (Mesa 22.3) numbers the uniform buffers of a stage from 1, in the order of sets and bindings. In a shader of
// more than 100 values it notes which uniforms decide a branch; what it notes of number 4 falls on its own counters,
// and the draw crashes. So the third buffer takes two numbers, and nobody is number 4. The others up to 8 are safe.
constexpr std::uint32_t kDoubledBuffer = 3;

void leave_out_buffer_4(Slots& slots) {
    std::uint32_t number = 0;
    for (auto& [place, slot] : slots)
        if (slot.type == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER && ++number == kDoubledBuffer) slot.count = 2;
}

// Everything that the reflection has, whether this pass reads it or not: the places are the same in every pass.
Outcome<Slots> find_slots(const Reflection& reflection, VkBuffer uniforms, std::span<const BoundBlock> blocks,
                          std::span<const BoundTexture> textures) {
    Slots slots;
    for (const Block& block : reflection.blocks) {
        const BoundBlock* bound = find_named(blocks, block.name);
        if (!bound) return Failure{"nobody filled the block '" + block.name + "'"};
        slots[{block.set, block.binding}] = {.buffer = {uniforms, bound->offset, bound->size}};
    }
    for (const Texture& texture : reflection.textures) {
        const BoundTexture* bound = find_named(textures, texture.name);
        if (!bound && !texture.is_material) continue;  // no pass reads it
        if (!bound) return Failure{"nobody loaded the texture '" + texture.name + "'"};
        slots[{texture.set, texture.binding}] = {
            .type = VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE,
            .image = {VK_NULL_HANDLE, bound->view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}};
        slots[{texture.set, texture.sampler_binding}] = {.type = VK_DESCRIPTOR_TYPE_SAMPLER,
                                                         .image = {bound->sampler, VK_NULL_HANDLE, {}}};
    }
    leave_out_buffer_4(slots);
    return slots;
}

void make_layouts(Gpu& gpu, const Slots& slots, Bindings& bindings) {
    VkDevice device = gpu.device.device;
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
        bindings.set_layouts.emplace_back(device, handle);
        handles.push_back(handle);
    }
    if (!gpu.error.empty()) return;

    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = set_count;
    info.pSetLayouts = handles.data();
    VkPipelineLayout layout = VK_NULL_HANDLE;
    gpu.check(vkCreatePipelineLayout(device, &info, nullptr, &layout), "make a pipeline layout");
    bindings.layout = {device, layout};
}

void make_sets(Gpu& gpu, const Slots& slots, Bindings& bindings) {
    VkDevice device = gpu.device.device;
    std::vector<VkDescriptorPoolSize> sizes;
    for (VkDescriptorType type :
         {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, VK_DESCRIPTOR_TYPE_SAMPLER}) {
        std::uint32_t count = 0;
        for (const auto& [place, slot] : slots)
            if (slot.type == type) count += slot.count;
        if (count) sizes.push_back({type, count});
    }
    VkDescriptorPoolCreateInfo pool_info{};
    pool_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    pool_info.maxSets = std::uint32_t(bindings.set_layouts.size());
    pool_info.poolSizeCount = std::uint32_t(sizes.size());
    pool_info.pPoolSizes = sizes.data();
    VkDescriptorPool pool = VK_NULL_HANDLE;
    if (!gpu.check(vkCreateDescriptorPool(device, &pool_info, nullptr, &pool), "make a descriptor pool")) return;
    bindings.pool = {device, pool};

    std::vector<VkDescriptorSetLayout> layouts;
    for (const SetLayoutHandle& layout : bindings.set_layouts) layouts.push_back(layout.get());
    VkDescriptorSetAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    allocate.descriptorPool = pool;
    allocate.descriptorSetCount = std::uint32_t(layouts.size());
    allocate.pSetLayouts = layouts.data();
    bindings.sets.resize(layouts.size());
    if (!gpu.check(vkAllocateDescriptorSets(device, &allocate, bindings.sets.data()), "make descriptor sets")) return;

    std::vector<VkWriteDescriptorSet> writes;
    for (const auto& [place, slot] : slots) {
        VkWriteDescriptorSet write{};
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstSet = bindings.sets[place.first];
        write.dstBinding = place.second;
        write.descriptorCount = 1;
        write.descriptorType = slot.type;
        write.pBufferInfo = &slot.buffer;
        write.pImageInfo = &slot.image;
        for (; write.dstArrayElement < slot.count; write.dstArrayElement++) writes.push_back(write);
    }
    vkUpdateDescriptorSets(device, std::uint32_t(writes.size()), writes.data(), 0, nullptr);
}

ShaderHandle make_shader(Gpu& gpu, std::span<const std::uint32_t> spirv) {
    VkShaderModuleCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = spirv.size_bytes();
    info.pCode = spirv.data();
    VkShaderModule handle = VK_NULL_HANDLE;
    gpu.check(vkCreateShaderModule(gpu.device.device, &info, nullptr, &handle), "take a shader");
    return {gpu.device.device, handle};
}

Outcome<std::vector<VkVertexInputAttributeDescription>> vertex_attributes(const Pass& pass) {
    std::vector<VkVertexInputAttributeDescription> result;
    for (const VertexInput& input : pass.vertex_inputs) {
        const VertexSource* source = vertex_source(input.name);
        if (!source) return Failure{"the preview meshes have no vertex input '" + input.name + "'"};
        result.push_back({input.location, 0, kFloats[source->components], std::uint32_t(source->offset)});
    }
    return result;
}

// The pass's words for state, looked up; the error names the one that is not known.
struct State {
    VkCullModeFlags cull = VK_CULL_MODE_NONE;
    VkCompareOp depth = VK_COMPARE_OP_ALWAYS;
    VkBlendFactor source = VK_BLEND_FACTOR_ONE, destination = VK_BLEND_FACTOR_ZERO;
};

Outcome<State> pass_state(const Pass& pass) {
    const RenderTarget target = pass.targets.empty() ? RenderTarget{} : pass.targets.front();
    auto cull = find_word(kCullModes, pass.cull);
    if (!cull) return Failure{"'" + pass.cull + "' is not a way to cull"};
    auto depth = find_word(kDepthTests, pass.depth_test);
    if (!depth) return Failure{"'" + pass.depth_test + "' is not a depth test"};
    auto source = find_word(kBlendFactors, target.blend_source);
    if (!source) return Failure{"'" + target.blend_source + "' is not a blend factor"};
    auto destination = find_word(kBlendFactors, target.blend_destination);
    if (!destination) return Failure{"'" + target.blend_destination + "' is not a blend factor"};
    return State{.cull = *cull, .depth = *depth, .source = *source, .destination = *destination};
}

// A create-info that says what it is, and is zero otherwise.
template <class Info>
Info started(VkStructureType type) {
    Info info{};
    info.sType = type;
    return info;
}

// Fixed-function state: one triangle list, one sample, one target, and what the pass asks for. The members point at
// each other, so it stays where it is made.
struct FixedState {
    VkPipelineInputAssemblyStateCreateInfo assembly;
    VkPipelineViewportStateCreateInfo viewport;
    VkPipelineRasterizationStateCreateInfo raster;
    VkPipelineMultisampleStateCreateInfo multisample;
    VkPipelineDepthStencilStateCreateInfo depth;
    VkPipelineColorBlendAttachmentState target{};
    VkPipelineColorBlendStateCreateInfo blend;
    VkDynamicState dynamic_states[2] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    VkPipelineDynamicStateCreateInfo dynamic;

    FixedState(const Pass& pass, const State& state);
    FixedState(const FixedState&) = delete;
};

FixedState::FixedState(const Pass& pass, const State& state)
    : assembly{started<decltype(assembly)>(VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO)},
      viewport{started<decltype(viewport)>(VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO)},
      raster{started<decltype(raster)>(VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO)},
      multisample{started<decltype(multisample)>(VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO)},
      depth{started<decltype(depth)>(VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO)},
      blend{started<decltype(blend)>(VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO)},
      dynamic{started<decltype(dynamic)>(VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO)} {
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    viewport.viewportCount = viewport.scissorCount = 1;
    raster.cullMode = state.cull;
    raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
    raster.lineWidth = 1;
    multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    depth.depthTestEnable = VK_TRUE;
    depth.depthWriteEnable = pass.depth_write;
    depth.depthCompareOp = state.depth;
    target.blendEnable = state.source != VK_BLEND_FACTOR_ONE || state.destination != VK_BLEND_FACTOR_ZERO;
    target.srcColorBlendFactor = target.srcAlphaBlendFactor = state.source;
    target.dstColorBlendFactor = target.dstAlphaBlendFactor = state.destination;
    target.colorWriteMask =
        VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    blend.attachmentCount = 1;
    blend.pAttachments = &target;
    dynamic.dynamicStateCount = 2;
    dynamic.pDynamicStates = dynamic_states;
}

VkPipelineShaderStageCreateInfo shader_stage(VkShaderStageFlagBits stage, const ShaderHandle& shader) {
    auto info = started<VkPipelineShaderStageCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO);
    info.stage = stage;
    info.module = shader.get();
    info.pName = "main";
    return info;
}

}  // namespace

std::uint32_t uniform_buffer_count(const Reflection& reflection) {
    auto blocks = std::uint32_t(reflection.blocks.size());
    return blocks + (blocks >= kDoubledBuffer ? 1 : 0);
}

Outcome<Bindings> make_bindings(Gpu& gpu, const Reflection& reflection, VkBuffer uniforms,
                                std::span<const BoundBlock> blocks, std::span<const BoundTexture> textures) {
    Outcome<Slots> slots = find_slots(reflection, uniforms, blocks, textures);
    if (!slots) return Failure{slots.error};
    Bindings bindings;
    make_layouts(gpu, slots.value, bindings);
    if (gpu.error.empty() && !bindings.set_layouts.empty()) make_sets(gpu, slots.value, bindings);
    if (!gpu.error.empty()) return Failure{gpu.error};
    return bindings;
}

Outcome<PipelineHandle> make_pipeline(Gpu& gpu, const PipelineInfo& wanted) {
    const Pass& pass = *wanted.pass;
    Outcome<State> state = pass_state(pass);
    if (!state) return Failure{state.error};
    auto attributes = vertex_attributes(pass);
    if (!attributes) return Failure{attributes.error};
    ShaderHandle vertex = make_shader(gpu, wanted.vertex_spirv), fragment = make_shader(gpu, wanted.fragment_spirv);
    if (!gpu.error.empty()) return Failure{gpu.error};

    VkPipelineShaderStageCreateInfo stages[] = {shader_stage(VK_SHADER_STAGE_VERTEX_BIT, vertex),
                                                shader_stage(VK_SHADER_STAGE_FRAGMENT_BIT, fragment)};
    VkVertexInputBindingDescription vertices{0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX};
    auto input =
        started<VkPipelineVertexInputStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO);
    input.vertexBindingDescriptionCount = 1;
    input.pVertexBindingDescriptions = &vertices;
    input.vertexAttributeDescriptionCount = std::uint32_t(attributes.value.size());
    input.pVertexAttributeDescriptions = attributes.value.data();

    FixedState fixed(pass, state.value);
    auto rendering = started<VkPipelineRenderingCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO);
    rendering.colorAttachmentCount = 1;
    rendering.pColorAttachmentFormats = &wanted.color_format;
    rendering.depthAttachmentFormat = wanted.depth_format;

    auto info = started<VkGraphicsPipelineCreateInfo>(VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO);
    info.pNext = &rendering;
    info.stageCount = 2;
    info.pStages = stages;
    info.pVertexInputState = &input;
    info.pInputAssemblyState = &fixed.assembly;
    info.pViewportState = &fixed.viewport;
    info.pRasterizationState = &fixed.raster;
    info.pMultisampleState = &fixed.multisample;
    info.pDepthStencilState = &fixed.depth;
    info.pColorBlendState = &fixed.blend;
    info.pDynamicState = &fixed.dynamic;
    info.layout = wanted.layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    gpu.check(vkCreateGraphicsPipelines(gpu.device.device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
              "make a pipeline");
    if (!gpu.error.empty()) return Failure{gpu.error};
    return PipelineHandle(gpu.device.device, pipeline);
}

}  // namespace patina::runtime
