#include "runtime/gpu/vulkan_words.h"

namespace patina::runtime {

VkCullModeFlags vulkan_cull(Cull cull) {
    switch (cull) {
        case Cull::Back: return VK_CULL_MODE_BACK_BIT;
        case Cull::Front: return VK_CULL_MODE_FRONT_BIT;
        case Cull::Off: return VK_CULL_MODE_NONE;
    }
    return VK_CULL_MODE_NONE;
}

VkCompareOp vulkan_compare(Compare compare) {
    switch (compare) {
        case Compare::Never: return VK_COMPARE_OP_NEVER;
        case Compare::Less: return VK_COMPARE_OP_LESS;
        case Compare::Equal: return VK_COMPARE_OP_EQUAL;
        case Compare::LessEqual: return VK_COMPARE_OP_LESS_OR_EQUAL;
        case Compare::Greater: return VK_COMPARE_OP_GREATER;
        case Compare::NotEqual: return VK_COMPARE_OP_NOT_EQUAL;
        case Compare::GreaterEqual: return VK_COMPARE_OP_GREATER_OR_EQUAL;
        case Compare::Always: return VK_COMPARE_OP_ALWAYS;
    }
    return VK_COMPARE_OP_ALWAYS;
}

VkStencilOp vulkan_stencil_op(StencilOp op) {
    switch (op) {
        case StencilOp::Keep: return VK_STENCIL_OP_KEEP;
        case StencilOp::Zero: return VK_STENCIL_OP_ZERO;
        case StencilOp::Replace: return VK_STENCIL_OP_REPLACE;
        case StencilOp::Increment: return VK_STENCIL_OP_INCREMENT_AND_CLAMP;
        case StencilOp::Decrement: return VK_STENCIL_OP_DECREMENT_AND_CLAMP;
        case StencilOp::Invert: return VK_STENCIL_OP_INVERT;
        case StencilOp::IncrementWrap: return VK_STENCIL_OP_INCREMENT_AND_WRAP;
        case StencilOp::DecrementWrap: return VK_STENCIL_OP_DECREMENT_AND_WRAP;
    }
    return VK_STENCIL_OP_KEEP;
}

VkBlendFactor vulkan_blend_factor(BlendFactor factor) {
    switch (factor) {
        case BlendFactor::One: return VK_BLEND_FACTOR_ONE;
        case BlendFactor::Zero: return VK_BLEND_FACTOR_ZERO;
        case BlendFactor::SourceAlpha: return VK_BLEND_FACTOR_SRC_ALPHA;
        case BlendFactor::OneMinusSourceAlpha: return VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
        case BlendFactor::TargetAlpha: return VK_BLEND_FACTOR_DST_ALPHA;
        case BlendFactor::OneMinusTargetAlpha: return VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA;
        case BlendFactor::SourceColor: return VK_BLEND_FACTOR_SRC_COLOR;
        case BlendFactor::TargetColor: return VK_BLEND_FACTOR_DST_COLOR;
        case BlendFactor::OneMinusSourceColor: return VK_BLEND_FACTOR_ONE_MINUS_SRC_COLOR;
        case BlendFactor::OneMinusTargetColor: return VK_BLEND_FACTOR_ONE_MINUS_DST_COLOR;
    }
    return VK_BLEND_FACTOR_ONE;
}

VkFormat vulkan_format(TargetFormat format) {
    switch (format) {
        case TargetFormat::Rgba8: return VK_FORMAT_R8G8B8A8_UNORM;
        case TargetFormat::Rgb10A2: return VK_FORMAT_A2B10G10R10_UNORM_PACK32;
        case TargetFormat::Rgba16F: return VK_FORMAT_R16G16B16A16_SFLOAT;
        case TargetFormat::Rgba32F: return VK_FORMAT_R32G32B32A32_SFLOAT;
        case TargetFormat::R32F: return VK_FORMAT_R32_SFLOAT;
        case TargetFormat::Depth: return VK_FORMAT_D32_SFLOAT_S8_UINT;
    }
    return VK_FORMAT_UNDEFINED;
}

VkSamplerAddressMode vulkan_wrap(Wrap wrap) {
    switch (wrap) {
        case Wrap::Repeat: return VK_SAMPLER_ADDRESS_MODE_REPEAT;
        case Wrap::Clamp: return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
        case Wrap::Mirror: return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
    }
    return VK_SAMPLER_ADDRESS_MODE_REPEAT;
}

}  // namespace patina::runtime
