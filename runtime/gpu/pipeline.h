// A pass's two stages, vertex inputs and state as Vulkan's graphics pipeline. bindings.h handles its descriptors.
//
//   Outcome<PipelineHandle> pipeline = make_pipeline(gpu, {.pass = &pass, .layout = layout.layout.get(), ...});
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "patina/reflection.h"
#include "runtime/gpu/gpu.h"
#include "runtime/outcome.h"
#include "runtime/values/material_values.h"

namespace patina::runtime {

struct PipelineInfo {
    const Pass* pass = nullptr;
    ClipDepth clip_depth = ClipDepth::NearToFar;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    std::span<const std::uint32_t> vertex_spirv{};
    std::span<const std::uint32_t> fragment_spirv{};
    std::span<const ConstantValue> constants{};
    std::vector<VkFormat> color_formats{};        // one per target of the pass
    VkFormat depth_format = VK_FORMAT_UNDEFINED;  // of depth and stencil; undefined: none
};
Outcome<PipelineHandle> make_pipeline(Gpu& gpu, const PipelineInfo& info);

}  // namespace patina::runtime
