// Rasterises triangles by Vulkan's rules: clips, snaps to 1/256 pixel, applies the top-left rule, and produces 2 x 2
// quads with the weights of the three corners in each lane. It does not shade pixels; cpu_step.cpp does.
//
//   for (const ScreenTriangle& t : clip_to_screen(a, b, c, width, height))
//       for_each_quad(t, width, height, 0, 1, [&](const Quad& quad) { ... });
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <vector>

namespace patina::runtime {

// A corner after the vertex stage: clip-space position, and varyings end to end.
struct ClipVertex {
    glm::dvec4 position{};
    std::vector<double> varyings{};
};

// Corners are clockwise on the screen (y down), also if the triangle faced away. Snapped coordinates decide which
// pixels it covers, so that neighbours share an edge without gaps. Varyings use the exact coordinates, as on most
// devices.
struct ScreenTriangle {
    std::array<ClipVertex, 3> corners{};
    std::array<glm::i64vec2, 3> snapped{};  // 1/256 pixel
    std::array<glm::dvec2, 3> exact{};      // pixels
    double area = 0;                        // twice, of the exact one; above 0
    bool is_front = false;                  // it was counter-clockwise
};

// Cuts at the near plane and far outside the screen, divides, snaps; leaves out what has no area. The screen is `width`
// by `height` pixels whose top left one is `origin`.
std::vector<ScreenTriangle> clip_to_screen(const ClipVertex& a, const ClipVertex& b, const ClipVertex& c, int width,
                                           int height, glm::ivec2 origin = {0, 0});

struct Quad {
    int x = 0, y = 0;               // of lane 0: even; lanes are 0 1 / 2 3, right and down
    std::array<bool, 4> covered{};  // by the triangle and within the bounds
    // Per lane. Outside the triangle (helper lanes) the same planes go on.
    std::array<std::array<double, 3>, 4> weights{};  // of the corners, perspective-correct
    std::array<double, 4> depth{};                   // 0 near to 1 far
    std::array<double, 4> inverse_w{};
};

// Pixels from the first to before the end.
struct PixelBounds {
    int left = 0, top = 0, right = 0, bottom = 0;

    bool holds(int x, int y) const { return x >= left && y >= top && x < right && y < bottom; }
};

// Quads with at least one lane covered within the bounds, in rows `first_row`, `first_row` + `row_step` ... of quads
// from the top.
void for_each_quad(const ScreenTriangle& triangle, const PixelBounds& bounds, int first_row, int row_step,
                   const std::function<void(const Quad&)>& visit);
inline void for_each_quad(const ScreenTriangle& triangle, int width, int height, int first_row, int row_step,
                          const std::function<void(const Quad&)>& visit) {
    for_each_quad(triangle, {.right = width, .bottom = height}, first_row, row_step, visit);
}

}  // namespace patina::runtime
