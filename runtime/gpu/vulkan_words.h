// Translates the words of passes and textures (patina/words.h) to Vulkan's values. For the CPU, cpu/fixed_state.h has
// the same words as formulas.
//
//   info.cullMode = vulkan_cull(pass.cull);
#pragma once

#include <vulkan/vulkan.h>

#include "patina/words.h"

namespace patina::runtime {

VkCullModeFlags vulkan_cull(Cull cull);
VkCompareOp vulkan_compare(Compare compare);
VkStencilOp vulkan_stencil_op(StencilOp op);
VkBlendFactor vulkan_blend_factor(BlendFactor factor);
VkFormat vulkan_format(TargetFormat format);
VkSamplerAddressMode vulkan_wrap(Wrap wrap);

}  // namespace patina::runtime
