// A world drawn along a rendering path: its materials are compiled for the path, or for what it falls back to, a frame
// is planned (frame_plan.h), and the GPU or the CPU draws it.
//
//   WorldDrawing drawing = draw_world(compiler, world, {.path = "deferred"}, machine);
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "patina/patina.h"
#include "runtime/frame/frame_plan.h"
#include "runtime/render/render_request.h"

namespace patina::runtime {

struct WorldOptions {
    std::string path = "forward";                                 // a rendering path, or a file x.pass.hlsl
    std::vector<std::pair<std::string, std::string>> switches{};  // beside those that the world asks for
    std::string preview{};                                        // a port of each material to look at, unlit
    std::string via = "glsl";                                     // glsl | hlsl | cpu
    std::string device{};
    bool validation = false;
    bool exact_textures = false;  // float texels on the GPU, to compare it with the CPU
    bool exact_targets = false;   // every colour target in 32-bit floats
    bool stated_formats = false;  // the picture too is drawn in the format that the passes state, not in 32-bit floats
    int shadow_atlas_size = 2048;
    std::vector<std::string> include_dirs{};
    std::function<void(double)> progress{};  // via cpu
};

RenderOutcome draw_world(const Compiler& compiler, const World& world, const WorldOptions& options,
                         RenderMachine& machine);

// What draw_world() would say before it draws, with the shaders of every target proved; also of materials that no
// object has. Ok if it would draw.
RenderOutcome check_world(const Compiler& compiler, const World& world, const WorldOptions& options);

}  // namespace patina::runtime
