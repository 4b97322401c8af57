// The render targets of a frame on the device. Later frames reuse them while they need the same ones. If a step reads a
// target that it also draws into, it reads a copy. The copy is valid until something draws into the target again.
//
//   std::vector<GpuTarget> targets;
//   Outcome<bool> fitted = fit_targets(gpu, targets, frame.targets);
#pragma once

#include <span>
#include <vector>

#include "runtime/frame/frame.h"
#include "runtime/frame/pixel_format.h"
#include "runtime/gpu/gpu.h"
#include "runtime/outcome.h"

namespace patina::runtime {

struct TargetImage {
    GpuImage image;
    ViewHandle depth_only;  // of a depth target: what a shader can read

    VkImageView read_view() const { return depth_only ? depth_only.get() : image.view.get(); }
};

struct GpuTarget {
    const PixelFormat* format = nullptr;
    TargetImage drawn, copy;  // the copy is made when something first needs one
    // How often the frame has drawn into it, and how often when it was copied; 0: never cleared or copied.
    unsigned version = 0, copied_version = 0;
};

// Makes `targets` match the given list; their old contents are lost.
Outcome<bool> fit_targets(Gpu& gpu, std::vector<GpuTarget>& targets, std::span<const FrameTarget> wanted);
// Sees to it that there is an image for the copy.
Outcome<bool> need_copy(Gpu& gpu, GpuTarget& target);

void clear_target(VkCommandBuffer commands, GpuTarget& target, const glm::vec4& value);
// Brings the copy up to date, ready to be read.
void copy_target(VkCommandBuffer commands, GpuTarget& target);
// The target's pixels into `buffer`, in the bytes of its format.
void read_target(VkCommandBuffer commands, GpuTarget& target, const Buffer& buffer);

}  // namespace patina::runtime
