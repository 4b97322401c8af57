// Noise that tiles: every function takes u and v in units of one texture (0 to 1) and repeats exactly at 1, so that a
// picture made of it has no seam. Built on an integer hash; no state, no random device: the same seed gives the same
// picture on every machine. Not the node library's noise, which lives in nodes/procedural.
//
//   float cloud = fractal(u, v, {.cells = 4, .octaves = 5, .seed = 7});   // 0 to 1
#pragma once

#include <cstdint>

namespace textures {

std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t seed);
// The hash as a number in [0, 1).
float random(std::uint32_t x, std::uint32_t y, std::uint32_t seed);

// Perlin's gradient noise, about -1 to 1, with `cells_u` by `cells_v` lattice cells in a texture.
float gradient(float u, float v, int cells_u, int cells_v, std::uint32_t seed);

struct Fractal {
    int cells = 4;    // of the coarsest octave
    int cells_v = 0;  // 0: as many as `cells`; else the noise is stretched
    int octaves = 5;  // each has twice the cells and half the weight of the one before
    std::uint32_t seed = 0;
};
// Sum of octaves, in 0 to 1 around 0.5.
float fractal(float u, float v, const Fractal& options);
// The same of |noise|, turned over: sharp crests near 1.
float ridged(float u, float v, const Fractal& options);

struct Cell {
    float nearest = 0;         // distance to the nearest point, in cells
    float border = 0;          // distance to the border between the nearest two, in cells
    std::uint32_t id = 0;      // hash of the cell
    float to_x = 0, to_y = 0;  // vector from the point to (u, v), in cells
};
// Voronoi cells: one jittered point in each of `cells` x `cells` squares.
Cell voronoi(float u, float v, int cells, std::uint32_t seed);

float smoothstep(float low, float high, float x);
float mix(float a, float b, float t);

}  // namespace textures
