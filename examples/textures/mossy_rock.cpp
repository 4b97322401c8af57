// Cracked rock, and moss of the same size to lay over it. Both carry their height in the normal map's alpha, so that a
// graph can let the moss grow out of the cracks.
#include <algorithm>
#include <cmath>

#include "examples/textures/noise.h"
#include "examples/textures/sets.h"

namespace textures {
namespace {

Set rock() {
    Picture layers(kSize);  // red: height, green: crack, blue: strata
    layers.fill([](float u, float v) {
        // Bend the cells, so that the cracks are not straight.
        const float wu = u + 0.05f * (fractal(u, v, {.cells = 5, .octaves = 4, .seed = 1}) - 0.5f);
        const float wv = v + 0.05f * (fractal(u, v, {.cells = 5, .octaves = 4, .seed = 2}) - 0.5f);
        const Cell block = voronoi(wu, wv, 4, 17);
        const float crack = 1 - smoothstep(0.0f, 0.085f, block.border);
        const float step = random(block.id, 0, 1);
        const float rough = fractal(u, v, {.cells = 6, .octaves = 6, .seed = 23});
        const float chips = ridged(u, v, {.cells = 8, .octaves = 4, .seed = 29});
        const float tilt = block.to_x * (random(block.id, 1, 1) - 0.5f) + block.to_y * (random(block.id, 2, 1) - 0.5f);
        const float height =
            0.42f + 0.18f * step + 0.22f * tilt + 0.26f * (rough - 0.5f) + 0.12f * chips - 0.34f * crack;
        return Color{std::clamp(height, 0.0f, 1.0f), crack, rough, step};
    });
    Picture color(kSize);
    const Color dark{0.30f, 0.285f, 0.275f, 1}, light{0.62f, 0.60f, 0.565f, 1}, warm{0.56f, 0.47f, 0.38f, 1};
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const Color& layer = layers.at(x, y);
            const float u = static_cast<float>(x) / kSize, v = static_cast<float>(y) / kSize;
            const float speckle = fractal(u, v, {.cells = 48, .octaves = 2, .seed = 71});
            const float lichen = smoothstep(0.6f, 0.72f, fractal(u, v, {.cells = 7, .octaves = 4, .seed = 73}));
            Color stone = mix(dark, light, std::clamp(0.15f + 0.8f * layer[2] + 0.3f * (layer[3] - 0.5f), 0.0f, 1.0f));
            stone = mix(stone, warm, 0.5f * lichen);
            stone = scaled(stone, 0.82f + 0.36f * speckle);
            stone = scaled(stone, cavity(layers, 0, x, y, 4, 2.2f) * (1 - 0.35f * layer[1]));
            color.at(x, y) = stone;
        }
    }
    return {{"rock_color", 3, std::move(color)}, {"rock_normal", 4, normals_of(layers, 0, 11.0f)}};
}

Set moss() {
    Picture layers(kSize);
    layers.fill([](float u, float v) {
        const Cell tuft = voronoi(u, v, 11, 5), sprig = voronoi(u, v, 38, 6);
        const float mound = 1 - std::clamp(tuft.nearest, 0.0f, 1.0f);
        const float fibre = 1 - std::clamp(sprig.nearest, 0.0f, 1.0f);
        const float cloud = fractal(u, v, {.cells = 4, .octaves = 4, .seed = 44});
        return Color{std::clamp(0.12f + 0.40f * mound + 0.28f * fibre + 0.25f * cloud, 0.0f, 1.0f), fibre, cloud,
                     random(sprig.id, 0, 2)};
    });
    Picture color(kSize);
    const Color deep{0.11f, 0.17f, 0.05f, 1}, green{0.33f, 0.44f, 0.12f, 1}, tip{0.62f, 0.66f, 0.26f, 1};
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const Color& layer = layers.at(x, y);
            Color leaf = mix(deep, green, smoothstep(0.25f, 0.7f, layer[0]));
            leaf = mix(leaf, tip, smoothstep(0.55f, 1.0f, 0.5f * layer[0] + 0.35f * layer[1] + 0.25f * layer[3]));
            leaf = scaled(leaf, 0.8f + 0.4f * layer[2]);
            color.at(x, y) = scaled(leaf, cavity(layers, 0, x, y, 2, 2.5f));
        }
    }
    return {{"moss_color", 3, std::move(color)}, {"moss_normal", 4, normals_of(layers, 0, 5.0f)}};
}

}  // namespace

Set mossy_rock() {
    Set all = rock();
    for (Texture& texture : moss()) all.push_back(std::move(texture));
    return all;
}

}  // namespace textures
