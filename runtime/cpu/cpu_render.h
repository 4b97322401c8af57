// The room `cpu`: draws a frame as it stands. It includes nothing of Vulkan, and decides nothing about what is drawn.
//
// Draws the same Frame as the GPU, on the CPU: a small rasteriser around patina::Interpreter. It works in 2 x 2 quads
// with helper lanes, so derivatives and mip levels exist. It follows Vulkan's rules: eight bits of sub-pixel precision,
// top-left rule, perspective-correct varyings, clipping at the near plane, tests of depth and stencil, blending in the
// target's format. Slow: a witness, and a fallback without a GPU.
//
//   Outcome<Image> image = cpu_draw(frame);
//   Outcome<Image> alone = cpu_draw({.reflection = &r, .program = result.program.get(), ...});
#pragma once

#include "patina/interpret.h"
#include "runtime/frame/draw.h"
#include "runtime/frame/frame.h"
#include "runtime/picture/image.h"

namespace patina::runtime {

// The target Frame::shown, its samples averaged.
Outcome<Image> cpu_draw(const Frame& frame, Precision precision = Precision::Float);
Outcome<Image> cpu_draw(const Draw& draw, Precision precision = Precision::Float);
// The same, and behind it each of Frame::also_shown.
Outcome<std::vector<Image>> cpu_draw_all(const Frame& frame, Precision precision = Precision::Float);

}  // namespace patina::runtime
