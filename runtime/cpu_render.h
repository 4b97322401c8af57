// Draws the same Draw as the GPU, on the CPU: a small rasteriser around patina::Interpreter. It works in 2 x 2 quads
// with helper lanes, so derivatives and mip levels exist, by Vulkan's rules: eight bits of sub-pixel precision,
// top-left rule, perspective-correct varyings, clipping at the near plane, depth test. Slow: a witness, and a fallback
// without a GPU.
//
//   Outcome<Image> image = cpu_draw({.reflection = &r, .program = result.program.get(), ...});
#pragma once

#include "runtime/renderer.h"

namespace patina::runtime {

Outcome<Image> cpu_draw(const Draw& draw, Precision precision = Precision::Float);

}  // namespace patina::runtime
