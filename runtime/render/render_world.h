// A world drawn along a rendering path: its materials are compiled for the path, or for what it falls back to, a frame
// is planned (frame_plan.h), and the GPU or the CPU draws it.
//
//   RenderOutcome outcome = draw_world(compiler, world, {.path = "deferred"}, machine);
#pragma once

#include "patina/patina.h"
#include "runtime/render/render_machine.h"
#include "runtime/render/render_options.h"
#include "runtime/scene/world.h"

namespace patina::runtime {

RenderOutcome draw_world(const Compiler& compiler, const World& world, const RenderOptions& options,
                         RenderMachine& machine);

// What draw_world() would say before it draws, with the shaders of every target proved; also of materials that no
// object has. Ok if it would draw.
RenderOutcome check_world(const Compiler& compiler, const World& world, const RenderOptions& options);

}  // namespace patina::runtime
