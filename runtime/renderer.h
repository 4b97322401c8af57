// Draws one pass of a compiled material on a Vulkan device and reads the picture back as linear floats. Everything
// about the material comes from its reflection: bindings, vertex inputs, state, block layouts. Not a scene renderer:
// one mesh, one pass.
//
// The life of a draw:
//   1. the caller resolves values, textures and blocks (material_values.h, textures.h)
//   2. what the device's limits forbid is refused
//   3. colour and depth images of the wanted size are taken from the last draw, or made
//   4. mesh, uniforms and textures go to the device; textures that were seen before are still there
//   5. descriptor sets and a pipeline are made from the reflection
//   6. one command buffer: clear, draw, copy back; the call waits for it
//   7. samples are averaged on the CPU
//
//   Outcome<std::unique_ptr<Renderer>> renderer = Renderer::open({.validation = true});
//   Outcome<Image> image = renderer.value->draw({.reflection = &r, .pass = "forward", ...});
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "patina/interpret.h"
#include "patina/reflection.h"
#include "runtime/device.h"
#include "runtime/image.h"
#include "runtime/material_values.h"
#include "runtime/scene.h"
#include "runtime/textures.h"

namespace patina::runtime {

// One draw, the same for the GPU and for cpu_render.h: each uses its own form of the two stages.
struct Draw {
    const Reflection* reflection = nullptr;
    std::string pass = "forward";
    const Scene* scene = nullptr;
    std::span<const BlockBytes> blocks{};
    std::span<const LoadedTexture> textures{};
    std::span<const std::uint32_t> vertex_spirv{};  // GPU; entry point "main"
    std::span<const std::uint32_t> fragment_spirv{};
    const Program* program = nullptr;  // CPU
    // CPU: told now and then which share is done, 0 to 1, on the calling thread.
    std::function<void(double)> progress{};
};

// The pass that `draw` names, if it can be drawn: one colour target, a mesh, a picture of a sensible size.
Outcome<const Pass*> drawable_pass(const Draw& draw);

class Renderer {
public:
    static Outcome<std::unique_ptr<Renderer>> open(const DeviceOptions& options = {});
    ~Renderer();

    Outcome<Image> draw(const Draw& draw);
    // Of a draw that has a drawable_pass(): empty, or what this device cannot take (limits.h). draw() refuses it too.
    std::string beyond_limits(const Draw& draw) const;

    const std::string& device_name() const;
    // What the validation layer has said so far: tests want it empty.
    const std::vector<std::string>& messages() const;

private:
    Renderer();
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace patina::runtime
