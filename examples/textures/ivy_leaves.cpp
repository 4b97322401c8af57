// Leaves scattered over the picture, with holes between them: a cut-out. Colour goes on under the holes, so that mip
// levels do not bleed black into the rims.
#include <algorithm>
#include <cmath>

#include "examples/textures/noise.h"
#include "examples/textures/sets.h"

namespace textures {
namespace {

struct Leaf {
    float u, v, x, y;  // stem's place; unit vector along the leaf
    float length;      // in textures
    float tint;        // 0 to 1
};

// What a leaf looks like at one place.
struct Sample {
    bool inside = false;
    float edge = 0;  // 0 at the rim, about 1 in the middle
    float vein = 0;  // 1 on a vein
    float height = 0;
};

// Leaf space: x runs from stem (0) to tip (1), y across.
Sample look(float x, float y) {
    if (x <= 0.0f || x >= 1.0f) return {};
    // Widest a third of the way, a drawn-out tip, and a finely toothed rim.
    const float body = 1.35f * std::pow(x, 0.62f) * std::pow(1 - x, 0.95f) * 0.62f;
    const float teeth = 0.022f * std::abs(std::sin(34 * x)) * (1 - x);
    const float half = body + teeth, across = std::abs(y);
    if (across >= half) return {};
    // Side veins leave the middle at an angle: lines of constant x - 0.75 |y|.
    const float along = (x - 0.75f * across) * 7.5f;
    const float side = std::abs(along - std::round(along));
    const float side_vein = (1 - smoothstep(0.03f, 0.13f, side)) * (1 - smoothstep(0.6f, 0.98f, across / half));
    const float middle_vein = 1 - smoothstep(0.008f, 0.028f, across);
    Sample s{.inside = true, .edge = 1 - across / half, .vein = std::max(middle_vein, 0.75f * side_vein)};
    // Folded along the middle, domed between the side veins, the rim bent down.
    s.height = 0.35f + 0.35f * smoothstep(0.0f, 0.5f, s.edge) - 0.22f * middle_vein - 0.12f * side_vein +
               0.05f * std::cos(6.2831853f * along);
    return s;
}

std::vector<Leaf> scatter() {
    std::vector<Leaf> leaves;
    constexpr std::uint32_t kSide = 6, kSeed = 19;
    for (std::uint32_t j = 0; j < kSide; ++j) {
        for (std::uint32_t i = 0; i < kSide; ++i) {
            // Most hang down; the jitter is large enough to hide the grid.
            const float angle = 1.5707963f + 2.4f * (random(i, j, kSeed) - 0.5f);
            const float u = (static_cast<float>(i) + random(i, j, kSeed + 1)) / kSide;
            const float v = (static_cast<float>(j) + random(i, j, kSeed + 2)) / kSide;
            leaves.push_back({u, v, std::cos(angle), std::sin(angle), 0.24f + 0.09f * random(i, j, kSeed + 3),
                              random(i, j, kSeed + 4)});
        }
    }
    return leaves;
}

}  // namespace

Set ivy_leaves() {
    const std::vector<Leaf> leaves = scatter();
    Picture color(kSize), heights(kSize);
    const Color shade{0.10f, 0.20f, 0.07f, 1}, young{0.38f, 0.52f, 0.16f, 1}, old{0.17f, 0.33f, 0.12f, 1};
    const Color pale{0.62f, 0.70f, 0.38f, 1};
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const float u = (static_cast<float>(x) + 0.5f) / kSize, v = (static_cast<float>(y) + 0.5f) / kSize;
            Color result = shade;
            result[3] = 0;
            float height = 0.3f;
            // Later leaves lie on top.
            for (std::size_t i = 0; i < leaves.size(); ++i) {
                const Leaf& leaf = leaves[i];
                const float du = u - leaf.u - std::round(u - leaf.u), dv = v - leaf.v - std::round(v - leaf.v);
                const Sample s =
                    look((du * leaf.x + dv * leaf.y) / leaf.length, (du * leaf.y - dv * leaf.x) / leaf.length);
                if (!s.inside) continue;
                const float mottle = fractal(u, v, {.cells = 12, .octaves = 4, .seed = 7});
                result = mix(old, young, std::clamp(0.75f * leaf.tint + 0.6f * (mottle - 0.4f), 0.0f, 1.0f));
                result = scaled(result, 0.72f + 0.34f * smoothstep(0.0f, 0.35f, s.edge));
                result = mix(result, pale, 0.55f * s.vein);
                result[3] = 1;
                height = s.height + 0.012f * static_cast<float>(i);
            }
            color.at(x, y) = result;
            heights.at(x, y) = {height, 0, 0, 0};
        }
    }
    return {{"leaves", 4, std::move(color)}, {"leaves_normal", 3, normals_of(heights, 0, 4.0f)}};
}

}  // namespace textures
