// Prepares a frame's steps for the device, and records them. Preparing can fail; recording cannot.
//
//   Outcome<ReadyFrame> ready = make_ready(gpu, frame, targets, textures);
//   for (const PixelArea& tile : tiles_of(frame)) {
//       move_to(ready.value, frame, device.limits, tile);
//       run_commands(gpu, [&](VkCommandBuffer commands) { record_frame(commands, frame, ready.value, targets); });
//   }
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "runtime/gpu/gpu_target.h"
#include "runtime/gpu/gpu_upload.h"
#include "runtime/gpu/pipeline.h"

namespace patina::runtime {

// What a step binds: handles of things that ReadyFrame keeps.
struct ReadyStep {
    VkPipeline pipeline = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    BoundSets bound;
};

struct ReadyFrame {
    FrameData data;
    SamplerHandle read_sampler;                                       // targets are read texel by texel
    std::map<std::tuple<Wrap, Filter, int>, SamplerHandle> samplers;  // of Reflection::samplers, by their state
    std::map<SlotShape, BindingLayout> layouts;
    // By pass, shaders, layout, formats and constants: two steps with the same ones share the pipeline.
    using PipelineKey = std::tuple<const Pass*, const std::uint32_t*, const std::uint32_t*, VkPipelineLayout,
                                   std::vector<VkFormat>, VkFormat, std::vector<ConstantValue>>;
    std::map<PipelineKey, PipelineHandle> pipelines;
    std::vector<ReadyStep> steps;
    // What is drawn next.
    PixelArea viewport{};  // of the steps that draw into the picture, in their targets
    PixelArea tile{};
    bool is_first = true;  // only the first tile draws what all tiles share
};

// Of a frame without a frame_error(), into targets that fit it.
Outcome<ReadyFrame> make_ready(Gpu& gpu, const Frame& frame, std::vector<GpuTarget>& targets, TextureCache& textures);

// Chooses the viewport of a tile, and puts its place into the blocks. Nothing that was recorded may still run.
void move_to(ReadyFrame& ready, const Frame& frame, const VkPhysicalDeviceLimits& limits, const PixelArea& tile);

void record_frame(VkCommandBuffer commands, const Frame& frame, const ReadyFrame& ready,
                  std::vector<GpuTarget>& targets);

}  // namespace patina::runtime
