#include "examples/textures/noise.h"

#include <algorithm>
#include <cmath>

namespace textures {
namespace {

std::uint32_t wrap(int i, int period) {
    return static_cast<std::uint32_t>(((i % period) + period) % period);
}

// Dot product of the offset with one of eight directions: enough that no axis stands out at these sizes.
float corner(std::uint32_t h, float x, float y) {
    constexpr float kDiagonal = 0.70710678f;
    switch (h & 7u) {
        case 0: return x;
        case 1: return -x;
        case 2: return y;
        case 3: return -y;
        case 4: return kDiagonal * (x + y);
        case 5: return kDiagonal * (x - y);
        case 6: return kDiagonal * (y - x);
    }
    return kDiagonal * (-x - y);
}

float fade(float t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}

template <class Shape>
float octaves(float u, float v, const Fractal& options, Shape shape) {
    float sum = 0, weight = 0.5f, total = 0;
    int cells_u = options.cells, cells_v = options.cells_v > 0 ? options.cells_v : options.cells;
    for (int i = 0; i < options.octaves; ++i) {
        sum += weight * shape(gradient(u, v, cells_u, cells_v, options.seed + 101u * static_cast<std::uint32_t>(i)));
        total += weight;
        weight *= 0.5f;
        cells_u *= 2;
        cells_v *= 2;
    }
    return sum / total;
}

}  // namespace

std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    // Two rounds of multiply and xor-shift over a mix of the inputs; the multipliers are odd, so each step is a
    // bijection.
    std::uint32_t h = x * 0x9e3779b1u ^ y * 0x85ebca77u ^ (seed + 0x165667b1u) * 0xc2b2ae3du;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return h ^ (h >> 15);
}

float random(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    return static_cast<float>(hash(x, y, seed) >> 8) * (1.0f / 16777216.0f);
}

float gradient(float u, float v, int cells_u, int cells_v, std::uint32_t seed) {
    const float x = u * static_cast<float>(cells_u), y = v * static_cast<float>(cells_v);
    const int ix = static_cast<int>(std::floor(x)), iy = static_cast<int>(std::floor(y));
    const float fx = x - static_cast<float>(ix), fy = y - static_cast<float>(iy);
    auto at = [&](int dx, int dy) {
        return corner(hash(wrap(ix + dx, cells_u), wrap(iy + dy, cells_v), seed), fx - static_cast<float>(dx),
                      fy - static_cast<float>(dy));
    };
    const float sx = fade(fx), sy = fade(fy);
    // The largest value of the sum is about 0.7; scaled to fill -1 to 1.
    return 1.4f * mix(mix(at(0, 0), at(1, 0), sx), mix(at(0, 1), at(1, 1), sx), sy);
}

float fractal(float u, float v, const Fractal& options) {
    return std::clamp(0.5f + 0.75f * octaves(u, v, options, [](float n) { return n; }), 0.0f, 1.0f);
}

float ridged(float u, float v, const Fractal& options) {
    return std::clamp(octaves(u, v, options, [](float n) { return 1 - 1.6f * std::abs(n); }), 0.0f, 1.0f);
}

Cell voronoi(float u, float v, int cells, std::uint32_t seed) {
    const float x = u * static_cast<float>(cells), y = v * static_cast<float>(cells);
    const int ix = static_cast<int>(std::floor(x)), iy = static_cast<int>(std::floor(y));
    struct Point {
        float dx, dy;  // from the point to (x, y)
        std::uint32_t id;
    };
    auto point = [&](int cx, int cy) {
        const std::uint32_t wx = wrap(cx, cells), wy = wrap(cy, cells);
        return Point{x - (static_cast<float>(cx) + random(wx, wy, seed)),
                     y - (static_cast<float>(cy) + random(wx, wy, seed + 1)), hash(wx, wy, seed + 2)};
    };
    Point best{1e3f, 1e3f, 0};
    for (int j = -2; j <= 2; ++j) {
        for (int i = -2; i <= 2; ++i) {
            const Point p = point(ix + i, iy + j);
            if (p.dx * p.dx + p.dy * p.dy < best.dx * best.dx + best.dy * best.dy) best = p;
        }
    }
    // Distance to the bisector of the nearest point and each other one.
    float border = 1e3f;
    for (int j = -2; j <= 2; ++j) {
        for (int i = -2; i <= 2; ++i) {
            const Point p = point(ix + i, iy + j);
            const float ax = best.dx - p.dx, ay = best.dy - p.dy, length = std::sqrt(ax * ax + ay * ay);
            if (length < 1e-4f) continue;
            border = std::min(border, std::abs((best.dx + p.dx) * ax + (best.dy + p.dy) * ay) / (2 * length));
        }
    }
    return {.nearest = std::sqrt(best.dx * best.dx + best.dy * best.dy),
            .border = border,
            .id = best.id,
            .to_x = best.dx,
            .to_y = best.dy};
}

float smoothstep(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

float mix(float a, float b, float t) {
    return a + (b - a) * t;
}

}  // namespace textures
