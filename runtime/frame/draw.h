// One mesh, one pass, one picture: the smallest frame, for a single material. frame_of() converts it to a frame, which
// the GPU (renderer.h) and the CPU (cpu_render.h) draw.
//
//   Draw draw{.reflection = &r, .pass = "forward", .scene = &scene, ...};
//   Outcome<const Pass*> pass = drawable_pass(draw);
//   Frame frame = frame_of(draw, *pass.value);
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "runtime/frame/frame.h"
#include "runtime/outcome.h"
#include "runtime/scene/scene.h"

namespace patina::runtime {

// Each way of drawing uses its own form of the two stages.
struct Draw {
    const Reflection* reflection = nullptr;
    std::string pass = "forward";
    const Scene* scene = nullptr;
    std::span<const BlockBytes> blocks{};
    std::vector<ConstantValue> constants{};
    std::span<const LoadedTexture> textures{};
    std::span<const std::uint32_t> vertex_spirv{};  // GPU; entry point "main"
    std::span<const std::uint32_t> fragment_spirv{};
    const Program* program = nullptr;  // CPU
    // CPU: called now and then with the share that is done, 0 to 1, on the calling thread.
    std::function<void(double)> progress{};
};

// The pass that `draw` names, if it can be drawn: one colour target, a mesh, a picture of a sensible size.
Outcome<const Pass*> drawable_pass(const Draw& draw);

// One step into a colour target of 32-bit floats and a depth target. It points into `draw`.
Frame frame_of(const Draw& draw, const Pass& pass);

}  // namespace patina::runtime
