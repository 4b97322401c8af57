// Draws a world with a rendering path. Compiles its materials for the path or its fallback, plans a frame
// (frame_plan.h), and draws it on the GPU or the CPU.
//
//   RenderOutcome outcome = draw_world(compiler, world, {.path = "deferred"}, machine);
//   TraceOutcome pixel = trace_world(compiler, world, {}, {.x = 120, .y = 80});
#pragma once

#include "patina/patina.h"
#include "runtime/render/render_machine.h"
#include "runtime/render/render_options.h"
#include "runtime/scene/world.h"

namespace patina::runtime {

RenderOutcome draw_world(const Compiler& compiler, const World& world, const RenderOptions& options,
                         RenderMachine& machine);

// The values behind a pixel of the picture that draw_world() draws. The CPU reference computes them, for every
// `options.via`.
TraceOutcome trace_world(const Compiler& compiler, const World& world, RenderOptions options, const TraceWish& wish);

// The messages that draw_world() gives before it draws, with the shaders of every target proved; also for materials
// that no object has. Ok if it would draw.
RenderOutcome check_world(const Compiler& compiler, const World& world, const RenderOptions& options);

}  // namespace patina::runtime
