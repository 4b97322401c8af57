// Steel plate: fine scratches, then rust that starts in spots, eats pits and has a darker rim.
#include <algorithm>
#include <cmath>

#include "examples/textures/noise.h"
#include "examples/textures/sets.h"

namespace textures {
namespace {

// Straight scratches of random angle, position and length, drawn over the torus; 1 in the groove's middle.
class Scratches {
public:
    Scratches(int count, float width, std::uint32_t seed) : width_(width) {
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
            const float angle = 3.14159265f * random(i, 2, seed);
            const float length = 0.05f + 0.3f * random(i, 3, seed) * random(i, 4, seed);
            lines_.push_back({random(i, 0, seed), random(i, 1, seed), std::cos(angle), std::sin(angle), length,
                              0.3f + 0.7f * random(i, 5, seed)});
        }
    }

    float at(float u, float v) const {
        float deepest = 0;
        for (const Line& line : lines_) {
            // The nearest copy of the line's middle.
            const float dx = u - line.u - std::round(u - line.u), dy = v - line.v - std::round(v - line.v);
            const float along = std::abs(dx * line.x + dy * line.y), across = std::abs(dx * line.y - dy * line.x);
            const float ends = 1 - smoothstep(0.7f * line.length, line.length, along);
            deepest = std::max(deepest, line.depth * ends * (1 - smoothstep(0, width_, across)));
        }
        return deepest;
    }

private:
    struct Line {
        float u, v, x, y, length, depth;
    };
    std::vector<Line> lines_;
    float width_;
};

}  // namespace

Set rusted_steel() {
    const Scratches scratches(90, 0.004f, 11);
    Picture layers(kSize);  // red: height, green: rust, blue: scratch, alpha: grain
    layers.fill([&](float u, float v) {
        const float patches = fractal(u, v, {.cells = 2, .octaves = 4, .seed = 3});
        const float spots = fractal(u, v, {.cells = 9, .octaves = 4, .seed = 21});
        const float rust = smoothstep(0.50f, 0.60f, 0.72f * patches + 0.28f * spots);
        const float scratch = scratches.at(u, v) * (1 - rust);
        const float grain = fractal(u, v, {.cells = 24, .octaves = 3, .seed = 5});
        const float crust = fractal(u, v, {.cells = 14, .octaves = 4, .seed = 8});
        const float pits = smoothstep(0.55f, 0.75f, fractal(u, v, {.cells = 20, .octaves = 2, .seed = 31}));
        const float rusted = 0.62f + 0.30f * crust - 0.30f * pits;
        const float height = mix(0.55f + 0.01f * grain - 0.10f * scratch, rusted, rust);
        return Color{height, rust, scratch, crust};
    });

    Picture color(kSize), orm(kSize);
    const Color steel{0.78f, 0.765f, 0.74f, 1}, worn{0.70f, 0.68f, 0.66f, 1};
    const Color dark{0.19f, 0.095f, 0.06f, 1}, brown{0.42f, 0.20f, 0.10f, 1}, orange{0.72f, 0.37f, 0.15f, 1};
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const Color& layer = layers.at(x, y);
            const float u = static_cast<float>(x) / kSize, v = static_cast<float>(y) / kSize;
            const float rust = layer[1], scratch = layer[2], crust = layer[3];
            const float stain = fractal(u, v, {.cells = 3, .octaves = 5, .seed = 55});
            Color metal = mix(steel, worn, stain);
            metal = scaled(metal, 1 + 0.18f * scratch);
            Color oxide = mix(dark, brown, smoothstep(0.25f, 0.55f, crust));
            oxide = mix(oxide, orange, smoothstep(0.5f, 0.85f, 0.5f * crust + 0.6f * stain));
            // Where rust begins it is thin and stains the metal around it.
            const float halo = smoothstep(0.0f, 0.35f, rust);
            color.at(x, y) = mix(metal, oxide, std::max(rust, 0.45f * halo));
            const float rough = mix(0.30f + 0.16f * stain + 0.12f * scratch, 0.82f + 0.14f * crust, rust);
            orm.at(x, y) = {cavity(layers, 0, x, y, 3, 3.0f), rough, 1 - smoothstep(0.05f, 0.6f, rust), 1};
        }
    }
    return {{"steel_color", 3, std::move(color)},
            {"steel_orm", 3, std::move(orm)},
            {"steel_normal", 3, normals_of(layers, 0, 6.0f)}};
}

}  // namespace textures
