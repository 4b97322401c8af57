#include "runtime/gpu/pipeline.h"

#include <algorithm>

#include "runtime/gpu/vulkan_words.h"
#include "runtime/values/vertex_inputs.h"

namespace patina::runtime {
namespace {

constexpr VkFormat kFloats[] = {VK_FORMAT_UNDEFINED, VK_FORMAT_R32_SFLOAT, VK_FORMAT_R32G32_SFLOAT,
                                VK_FORMAT_R32G32B32_SFLOAT, VK_FORMAT_R32G32B32A32_SFLOAT};

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

// Empty, or the blend state of the targets that the device does not support.
std::string blending_error(const Device& device, const PipelineInfo& wanted) {
    const std::vector<RenderTarget>& targets = wanted.pass->targets;
    for (std::size_t i = 0; i < targets.size(); i++) {
        if (targets[i].blend != targets.front().blend && !device.independent_blend)
            return "'" + device.name + "' cannot blend each target of the pass '" + wanted.pass->name + "' differently";
        if (targets[i].blend.is_on() &&
            !supports(device, wanted.color_formats[i], VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT))
            return "'" + device.name + "' cannot blend in the format of the target '" + targets[i].name + "'";
    }
    return "";
}

// A create-info that says what it is, and is zero otherwise.
template <class Info>
Info started(VkStructureType type) {
    Info info{};
    info.sType = type;
    return info;
}

// Fixed-function state: one triangle list, one sample, and what the pass asks for. The members point at each other, so
// it stays where it is made.
struct FixedState {
    VkPipelineInputAssemblyStateCreateInfo assembly;
    VkPipelineViewportDepthClipControlCreateInfoEXT clip;
    VkPipelineViewportStateCreateInfo viewport;
    VkPipelineRasterizationStateCreateInfo raster;
    VkPipelineMultisampleStateCreateInfo multisample;
    VkPipelineDepthStencilStateCreateInfo depth;
    std::vector<VkPipelineColorBlendAttachmentState> targets;
    VkPipelineColorBlendStateCreateInfo blend;
    VkDynamicState dynamic_states[3] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                        VK_DYNAMIC_STATE_STENCIL_REFERENCE};
    VkPipelineDynamicStateCreateInfo dynamic;

    FixedState(const Pass& pass, ClipDepth clip_depth);
    FixedState(const FixedState&) = delete;

private:
    void set_depth(const Pass& pass);
    void set_blending(const Pass& pass);
};

FixedState::FixedState(const Pass& pass, ClipDepth clip_depth)
    : assembly{started<decltype(assembly)>(VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO)},
      clip{started<decltype(clip)>(VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_DEPTH_CLIP_CONTROL_CREATE_INFO_EXT)},
      viewport{started<decltype(viewport)>(VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO)},
      raster{started<decltype(raster)>(VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO)},
      multisample{started<decltype(multisample)>(VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO)},
      depth{started<decltype(depth)>(VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO)},
      blend{started<decltype(blend)>(VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO)},
      dynamic{started<decltype(dynamic)>(VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO)} {
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    viewport.viewportCount = viewport.scissorCount = 1;
    clip.negativeOneToOne = VK_TRUE;
    if (clip_depth == ClipDepth::Symmetric) viewport.pNext = &clip;
    raster.cullMode = vulkan_cull(pass.cull);
    raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
    raster.lineWidth = 1;
    raster.depthBiasEnable = pass.depth_bias != 0 || pass.depth_slope_bias != 0;
    raster.depthBiasConstantFactor = float(pass.depth_bias);
    raster.depthBiasSlopeFactor = float(pass.depth_slope_bias);
    multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    set_depth(pass);
    set_blending(pass);
    dynamic.dynamicStateCount = std::uint32_t(std::size(dynamic_states));
    dynamic.pDynamicStates = dynamic_states;
}

void FixedState::set_depth(const Pass& pass) {
    depth.depthTestEnable = VK_TRUE;
    depth.depthWriteEnable = pass.depth_write;
    depth.depthCompareOp = vulkan_compare(pass.depth_test);
    depth.stencilTestEnable = pass.stencil.is_used();
    VkStencilOpState& stencil = depth.front;
    stencil.failOp = vulkan_stencil_op(pass.stencil.fail);
    stencil.depthFailOp = vulkan_stencil_op(pass.stencil.depth_fail);
    stencil.passOp = vulkan_stencil_op(pass.stencil.pass);
    stencil.compareOp = vulkan_compare(pass.stencil.test);
    stencil.compareMask = std::uint32_t(pass.stencil.read_mask);
    stencil.writeMask = std::uint32_t(pass.stencil.write_mask);
    depth.back = stencil;
}

void FixedState::set_blending(const Pass& pass) {
    for (const RenderTarget& wanted : pass.targets) {
        VkPipelineColorBlendAttachmentState target{};
        target.blendEnable = wanted.blend.is_on();
        target.srcColorBlendFactor = vulkan_blend_factor(wanted.blend.source);
        target.dstColorBlendFactor = vulkan_blend_factor(wanted.blend.destination);
        target.srcAlphaBlendFactor = vulkan_blend_factor(wanted.blend.source_alpha);
        target.dstAlphaBlendFactor = vulkan_blend_factor(wanted.blend.destination_alpha);
        target.colorWriteMask =
            VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
        targets.push_back(target);
    }
    blend.attachmentCount = std::uint32_t(targets.size());
    blend.pAttachments = targets.data();
}

VkPipelineShaderStageCreateInfo shader_stage(VkShaderStageFlagBits stage, const ShaderHandle& shader) {
    auto info = started<VkPipelineShaderStageCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO);
    info.stage = stage;
    info.module = shader.get();
    info.pName = "main";
    return info;
}

// The values of specialization constants, as Vulkan takes them.
struct Constants {
    std::vector<VkSpecializationMapEntry> entries;
    std::vector<std::uint32_t> values;
    VkSpecializationInfo info{};

    explicit Constants(std::span<const ConstantValue> wanted) {
        for (const ConstantValue& constant : wanted) {
            const auto offset = std::uint32_t(values.size() * sizeof(std::uint32_t));
            entries.push_back({.constantID = constant.id, .offset = offset, .size = sizeof(std::uint32_t)});
            values.push_back(constant.value);
        }
        info = {.mapEntryCount = std::uint32_t(entries.size()),
                .pMapEntries = entries.data(),
                .dataSize = values.size() * sizeof(std::uint32_t),
                .pData = values.data()};
    }
    Constants(const Constants&) = delete;
};

}  // namespace

Outcome<PipelineHandle> make_pipeline(Gpu& gpu, const PipelineInfo& wanted) {
    const Pass& pass = *wanted.pass;
    auto attributes = vertex_attributes(pass);
    if (!attributes) return Failure{attributes.error};
    if (std::string error = blending_error(gpu.device, wanted); !error.empty()) return Failure{error};
    if (wanted.clip_depth == ClipDepth::Symmetric && !gpu.device.symmetric_depth)
        return Failure{
            "'" + gpu.device.name + "' cannot draw the pass '" + pass.name +
            "', whose clip space begins at -1: it lacks VK_EXT_depth_clip_control; draw with '--device cpu'"};
    ShaderHandle vertex = make_shader(gpu, wanted.vertex_spirv), fragment = make_shader(gpu, wanted.fragment_spirv);
    if (!gpu.error.empty()) return Failure{gpu.error};

    VkPipelineShaderStageCreateInfo stages[] = {shader_stage(VK_SHADER_STAGE_VERTEX_BIT, vertex),
                                                shader_stage(VK_SHADER_STAGE_FRAGMENT_BIT, fragment)};
    const Constants constants(wanted.constants);
    for (VkPipelineShaderStageCreateInfo& stage : stages) stage.pSpecializationInfo = &constants.info;
    VkVertexInputBindingDescription vertices{0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX};
    auto input =
        started<VkPipelineVertexInputStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO);
    input.vertexBindingDescriptionCount = 1;
    input.pVertexBindingDescriptions = &vertices;
    input.vertexAttributeDescriptionCount = std::uint32_t(attributes.value.size());
    input.pVertexAttributeDescriptions = attributes.value.data();

    FixedState fixed(pass, wanted.clip_depth);
    auto rendering = started<VkPipelineRenderingCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO);
    rendering.colorAttachmentCount = std::uint32_t(wanted.color_formats.size());
    rendering.pColorAttachmentFormats = wanted.color_formats.data();
    rendering.depthAttachmentFormat = rendering.stencilAttachmentFormat = wanted.depth_format;

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
