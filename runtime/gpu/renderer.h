// The room `gpu`: no other room includes Vulkan. Only `render`, which opens the device, includes its headers.
//
// Draws a frame on a Vulkan device and reads the picture back as linear floats. A frame is a list (frame.h): the
// images, and which mesh is drawn into which image with which shaders. Everything about a material comes from its
// reflection: bindings, vertex inputs, state, block layouts. It knows neither scenes nor rendering paths.
//
// The life of a frame:
//   1. the caller decides what is drawn and resolves values, textures and blocks (material_values.h, textures.h)
//   2. a frame that does not fit together (frame_check.h), or that the device's limits forbid (limits.h), is refused
//   3. images of the wanted sizes and formats are taken from the last frame, or made (gpu_target.h)
//   4. each mesh and all uniforms go to the device in one buffer; textures that were seen before are still there
//      (gpu_upload.h)
//   5. each step gets descriptor sets (bindings.h), and a pipeline (pipeline.h) that it shares with equal steps
//   6. for each tile (tiles.h), one command buffer (gpu_frame.h): clear every image, then step after step, with a copy
//      of an image where a step reads what it also draws into; copy back the one that is shown; the call waits for it
//   7. the tile's samples are averaged into the picture on the CPU
//
//   Outcome<std::unique_ptr<Renderer>> renderer = Renderer::open({.validation = true});
//   Outcome<Image> image = renderer.value->draw(frame);
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/frame/draw.h"
#include "runtime/frame/frame.h"
#include "runtime/gpu/device.h"
#include "runtime/picture/image.h"

namespace patina::runtime {

class Renderer {
public:
    static Outcome<std::unique_ptr<Renderer>> open(const DeviceOptions& options = {});
    ~Renderer();

    // The target Frame::shown, its samples averaged.
    Outcome<Image> draw(const Frame& frame);
    Outcome<Image> draw(const Draw& draw);
    // The same, and behind it each of Frame::also_shown.
    Outcome<std::vector<Image>> draw_all(const Frame& frame);
    // For a valid frame (frame_check.h, drawable_pass()): empty, or the limit of this device that it exceeds
    // (limits.h). draw() refuses it too.
    std::string beyond_limits(const Frame& frame) const;
    std::string beyond_limits(const Draw& draw) const;

    const std::string& device_name() const;
    const std::string& driver() const;  // with its version
    // The messages of the validation layer until now: tests require that there are none.
    const std::vector<std::string>& messages() const;

private:
    Renderer();
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace patina::runtime
