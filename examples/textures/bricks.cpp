// A wall of worn bricks in running bond, three by eight in a picture, set back mortar between them. The height map goes
// from the deepest mortar (0) to the face of the foremost brick (1).
#include <algorithm>
#include <cmath>

#include "examples/textures/noise.h"
#include "examples/textures/sets.h"

namespace textures {
namespace {

constexpr int kAcross = 3, kRows = 8;
constexpr float kJoint = 0.09f;   // half of the mortar's width, in rows
constexpr float kRelief = 10.0f;  // texels: a 25th of the picture, as the graphs' _Parallax has it

struct Place {
    float x, y;  // from the middle of the brick, in rows
    float edge;  // distance to the edge of the brick, in rows; negative: mortar
    std::uint32_t id;
};

Place place(float u, float v) {
    constexpr float kLength = static_cast<float>(kRows) / kAcross;  // of a brick with its joint, in rows
    const float row = std::floor(v * kRows), shift = 0.5f * std::fmod(row, 2.0f);
    const float along = u * kAcross + shift, column = std::floor(along);
    const float x = (along - column - 0.5f) * kLength, y = v * kRows - row - 0.5f;
    // A box with rounded corners, whose edges are worn unevenly.
    const float worn = 0.10f * (fractal(u, v, {.cells = 10, .octaves = 4, .seed = 31}) - 0.5f);
    constexpr float kRadius = 0.09f;
    const float qx = std::abs(x) - (0.5f * kLength - kJoint - kRadius), qy = std::abs(y) - (0.5f - kJoint - kRadius);
    const float outside = std::hypot(std::max(qx, 0.0f), std::max(qy, 0.0f)), inside = std::min(std::max(qx, qy), 0.0f);
    const std::uint32_t across = static_cast<std::uint32_t>(column) % kAcross;  // the last begins the row again
    return {x, y, kRadius - outside - inside + worn, hash(across, static_cast<std::uint32_t>(row), 77)};
}

}  // namespace

Set bricks() {
    Picture layers(kSize);  // red: height, green: brick (1) or mortar (0), blue: how deeply it was burnt
    layers.fill([](float u, float v) {
        const Place p = place(u, v);
        const float brick = smoothstep(0.0f, 0.05f, p.edge);
        const float shoulder = smoothstep(0.0f, 0.16f, p.edge);
        const float rough = fractal(u, v, {.cells = 16, .octaves = 4, .seed = 8});
        const float pits = smoothstep(0.60f, 0.72f, fractal(u, v, {.cells = 24, .octaves = 3, .seed = 19}));
        const float sand = fractal(u, v, {.cells = 64, .octaves = 2, .seed = 15});
        const float set = 0.12f * (random(p.id, 0, 1) - 0.5f);  // how far it stands out of the wall
        const float tilt = 0.05f * p.x * (random(p.id, 1, 1) - 0.5f) + 0.10f * p.y * (random(p.id, 2, 1) - 0.5f);
        const float face = 0.74f + 0.12f * shoulder + set + tilt + 0.10f * (rough - 0.5f) - 0.10f * pits * shoulder;
        return Color{std::clamp(mix(0.10f + 0.10f * sand, face, brick), 0.0f, 1.0f), brick, random(p.id, 3, 1), 1};
    });

    Picture color(kSize), height(kSize);
    const Color pale{0.72f, 0.46f, 0.34f, 1}, red{0.60f, 0.29f, 0.21f, 1}, burnt{0.36f, 0.20f, 0.19f, 1};
    const Color lime{0.66f, 0.63f, 0.58f, 1};
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const float u = (static_cast<float>(x) + 0.5f) / kSize, v = (static_cast<float>(y) + 0.5f) / kSize;
            const Color& layer = layers.at(x, y);
            const float cloud = fractal(u, v, {.cells = 8, .octaves = 5, .seed = 50});
            const float grain = fractal(u, v, {.cells = 48, .octaves = 2, .seed = 52});
            Color clay = layer[2] < 0.6f ? mix(pale, red, layer[2] / 0.6f) : mix(red, burnt, (layer[2] - 0.6f) / 0.4f);
            clay = mix(clay, burnt, 0.5f * smoothstep(0.5f, 0.8f, cloud));
            clay = mix(clay, lime, 0.25f * smoothstep(0.62f, 0.75f, 1 - cloud));
            Color surface = mix(scaled(lime, 0.85f + 0.2f * grain), clay, layer[1]);
            surface = scaled(surface, (0.85f + 0.3f * grain) * cavity(layers, 0, x, y, 4, 1.2f));
            color.at(x, y) = surface;
            height.at(x, y) = {layer[0], layer[0], layer[0], 1};
        }
    }
    return {{"bricks_color", 3, std::move(color)},
            {"bricks_height", 1, std::move(height)},
            {"bricks_normal", 3, normals_of(layers, 0, kRelief)}};
}

}  // namespace textures
