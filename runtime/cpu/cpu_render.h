// The room `cpu`: draws a frame as it stands. It includes nothing of Vulkan, and decides nothing about what is drawn.
//
// Draws the same Frame as the GPU, on the CPU: a small rasteriser around patina::Interpreter. It works in 2 x 2 quads
// with helper lanes, so derivatives and mip levels exist, by Vulkan's rules: eight bits of sub-pixel precision,
// top-left rule, perspective-correct varyings, clipping at the near plane, tests of depth and stencil, blending in the
// target's format. Slow: a witness, and a fallback without a GPU.
//
//   Outcome<Image> image = cpu_draw(frame);
//   Outcome<Image> alone = cpu_draw({.reflection = &r, .program = result.program.get(), ...});
#pragma once

#include <array>
#include <vector>

#include "patina/interpret.h"
#include "runtime/frame/draw.h"
#include "runtime/frame/frame.h"
#include "runtime/picture/image.h"

namespace patina::runtime {

// The target Frame::shown, its samples averaged.
Outcome<Image> cpu_draw(const Frame& frame, Precision precision = Precision::Float);
Outcome<Image> cpu_draw(const Draw& draw, Precision precision = Precision::Float);

// The values behind one pixel of a draw.
struct PixelTrace {
    bool is_covered = false;    // by the mesh; if not, there is nothing but the background's colour
    bool is_discarded = false;  // every fragment was, such as in the holes of a cutout; `values` are of the nearest
    // The traced sample of the pixel: of the samples that show the material, the one nearest to the middle.
    int sample_x = 0, sample_y = 0;                     // 0 to samples - 1, right and down
    std::vector<TracedValue> values{};                  // of the fragment stage
    std::array<std::vector<TracedValue>, 3> corners{};  // of the vertex stage, at the triangle's corners
    std::array<float, 4> sample_color{};                // what the sample shows, linear
    std::array<float, 4> color{};                       // what the pixel shows: all its samples, averaged
};

// The pixel at `x`, `y` from the top left, inside the picture. It runs that pixel and no other.
Outcome<PixelTrace> cpu_trace(const Draw& draw, int x, int y, Precision precision = Precision::Float);

}  // namespace patina::runtime
