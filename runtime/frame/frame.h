// The room `frame`: converts a world to such a list, and checks the list. It compiles nothing, runs no shader, and
// does not depend on Vulkan.
//
// A frame as a list: render targets, and draws in order. It knows neither scenes nor rendering paths: frame_plan.h has
// decided the contents of the list. The GPU (renderer.h) and the CPU (cpu_render.h) draw the same list.
//
//   Frame frame{.targets = {{.name = "color", .width = 64, .height = 64},
//                           {.name = "depth", .format = TargetFormat::Depth, .width = 64, .height = 64}},
//               .steps = {...}};
//   frame.targets[1].clear = glm::vec4(1);
//   Outcome<Image> image = renderer.draw(frame);
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "patina/interpret.h"
#include "patina/reflection.h"
#include "runtime/mesh/mesh.h"
#include "runtime/picture/image.h"
#include "runtime/values/material_values.h"
#include "runtime/values/textures.h"

namespace patina::runtime {

// The depth of pixels without geometry: that of the far plane.
constexpr float farthest(ClipDepth depth) {
    return depth == ClipDepth::Reversed ? 0.0f : 1.0f;
}

// An image that steps draw into. It starts out as `clear` (depth: x; stencil: 0).
struct FrameTarget {
    std::string name{};
    TargetFormat format = TargetFormat::Rgba32F;
    int width = 0, height = 0;
    glm::vec4 clear{0};
    bool is_of_picture = false;  // it has the size of the picture, so that it can be drawn in tiles (tiles.h)
};

// A texture of the step that is a render target: its content when the step begins, even if the step draws into it.
struct FrameRead {
    std::string texture{};  // of the reflection
    std::size_t target = 0;
};

// The two stages of one pass of one material, in the form that a renderer can run.
struct StagePair {
    std::span<const std::uint32_t> vertex_spirv{}, fragment_spirv{};  // GPU; entry point "main"
    const Program* program = nullptr;                                 // CPU
};

struct FrameStep {
    const Reflection* reflection = nullptr;
    const Pass* pass = nullptr;  // of `reflection`
    // z / w of the vertex stage's positions. Shadow maps are near to far, for every camera.
    ClipDepth clip_depth() const {
        return pass->lights == PassLights::Shadowed ? ClipDepth::NearToFar : reflection->clip_depth;
    }
    StagePair stages{};
    const Mesh* mesh = nullptr;
    std::uint32_t instances = 1;  // of the mesh, in one draw
    std::vector<BlockBytes> blocks{};
    std::vector<ConstantValue> constants{};
    std::span<const LoadedTexture> textures{};
    std::map<std::string, Sampler> samplers{};  // of Reflection::samplers: those that have not their default
    std::vector<FrameRead> reads{};
    std::vector<std::size_t> targets{};  // one per Pass::targets, indices into Frame::targets
    int depth = -1;                      // index into Frame::targets; -1: no depth or stencil
    PixelArea area{};                    // of the targets; a width of 0: all of them
    std::uint8_t stencil_reference = 0;
    bool clears_stencil = false;  // to 0, all of it, before the step draws
    const Sampler& state_of(const BoundSampler& sampler) const {
        const auto found = samplers.find(sampler.name);
        return found == samplers.end() ? sampler.sampler : found->second;
    }
    // For finding what a pixel shows. Indices into the world whose frame it is.
    std::optional<std::size_t> object{};  // nothing: no object is drawn
    std::size_t first_instance = 0;       // the first of `instances`, among those of the object
    std::vector<std::size_t> lights{};    // in the order in which the shaders number them
};

struct Frame {
    std::vector<FrameTarget> targets{};
    std::vector<FrameStep> steps{};
    std::size_t shown = 0;                  // the target that is the result
    std::vector<std::size_t> also_shown{};  // others of the picture whose pixels are wanted (draw_all())
    int samples = 1;                        // the result is averaged over so many pixels along each axis
    int tile = 0;                           // the side of a tile, in samples (tiles.h); 0: the picture is drawn at once
    // Of a tile: the largest viewport that is used, in samples; 0: the device's limit says. The CPU has none.
    int largest_viewport = 0;
    // Called now and then with the share that is done, 0 to 1, on the calling thread; on the GPU after each tile.
    std::function<void(double)> progress{};
    std::shared_ptr<const void> keep{};  // what steps point to and nobody else holds
};

}  // namespace patina::runtime
