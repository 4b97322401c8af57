// Glazed tiles, two by two in a picture, with a blue pattern of a ring, a star and corner leaves that goes on across
// the tiles; pillowed edges, grout between, and a hair-line crackle in the glaze.
#include <algorithm>
#include <cmath>

#include "examples/textures/noise.h"
#include "examples/textures/sets.h"

namespace textures {
namespace {

constexpr int kTiles = 2;
constexpr float kGrout = 0.022f;  // half its width, in tiles

struct Place {
    float x, y;  // within the tile, -0.5 to 0.5
    float edge;  // distance to the nearest edge of the tile, less the grout; negative: grout
    std::uint32_t id;
};

Place place(float u, float v) {
    const float tx = u * kTiles, ty = v * kTiles;
    const float cx = std::floor(tx), cy = std::floor(ty);
    const float x = tx - cx - 0.5f, y = ty - cy - 0.5f;
    // A box with rounded corners.
    const float radius = 0.05f, half = 0.5f - kGrout - radius;
    const float qx = std::max(std::abs(x) - half, 0.0f), qy = std::max(std::abs(y) - half, 0.0f);
    const float outside = std::sqrt(qx * qx + qy * qy);
    const float inside = std::min(std::max(std::abs(x), std::abs(y)) - half, 0.0f);
    return {x, y, radius - outside - inside, hash(static_cast<std::uint32_t>(cx), static_cast<std::uint32_t>(cy), 5)};
}

// 1 inside the shape whose signed distance is given (negative: inside), soft over a texel.
float inked(float distance) {
    constexpr float kTexel = static_cast<float>(kTiles) / kSize;
    return 1 - smoothstep(-0.7f * kTexel, 0.7f * kTexel, distance);
}

// Distance to a pointed leaf along +x from `from` to `to`: two arcs.
float leaf(float x, float y, float from, float to, float width) {
    const float half = 0.5f * (to - from), middle = 0.5f * (from + to);
    const float radius = (half * half + width * width) / (2 * width);
    const float dx = x - middle, dy = std::abs(y) + radius - width;
    return std::sqrt(dx * dx + dy * dy) - radius;
}

struct Ink {
    float dark, light, gold;
};

Ink pattern(float x, float y) {
    const float r = std::sqrt(x * x + y * y), angle = std::atan2(y, x);
    constexpr float kQuarter = 0.78539816f;
    // Eight leaves around the middle: fold the angle into one sector.
    const float sector = angle - kQuarter * std::round(angle / kQuarter);
    const float fx = r * std::cos(sector), fy = r * std::sin(sector);
    const bool straight = std::abs(std::remainder(angle, 2 * kQuarter)) < kQuarter / 2;
    const float petal = straight ? leaf(fx, fy, 0.06f, 0.285f, 0.050f) : leaf(fx, fy, 0.06f, 0.235f, 0.042f);
    const float vein = std::max(std::abs(fy) - 0.006f, std::abs(fx - 0.17f) - 0.075f);
    // Rings around the middle, and quarter rings around the corners that meet their neighbours'.
    const float ring = std::abs(r - 0.335f) - 0.014f, hair = std::abs(r - 0.365f) - 0.005f;
    const float kx = 0.5f - std::abs(x), ky = 0.5f - std::abs(y), k = std::sqrt(kx * kx + ky * ky);
    const float corner = std::abs(k - 0.235f) - 0.012f, corner_disc = k - 0.205f;
    const float bud = leaf((kx + ky) * 0.70710678f, (kx - ky) * 0.70710678f, 0.035f, 0.175f, 0.040f);
    const float dots =
        std::sqrt(std::pow(r - 0.412f, 2.0f) + std::pow(r * std::sin(std::remainder(angle, 2 * kQuarter)), 2.0f)) -
        0.020f;
    Ink ink{};
    ink.dark = std::max(
        {inked(ring), inked(corner), inked(bud), straight ? inked(petal) * (1 - inked(vein)) : 0.0f, inked(hair)});
    ink.light = std::max(inked(corner_disc), straight ? 0.0f : inked(petal));
    ink.gold = std::max(inked(r - 0.045f), inked(dots));
    return ink;
}

}  // namespace

Set painted_tiles() {
    Picture layers(kSize);  // red: height, green: glaze (1) or grout (0), blue: crackle
    layers.fill([](float u, float v) {
        const Place p = place(u, v);
        const float glaze = smoothstep(0.0f, 0.008f, p.edge);
        const float pillow = 1 - std::pow(1 - std::clamp(p.edge / 0.09f, 0.0f, 1.0f), 3.0f);
        const float waves = fractal(u, v, {.cells = 6, .octaves = 2, .seed = 4});
        const float sand = fractal(u, v, {.cells = 40, .octaves = 2, .seed = 9});
        const float crackle = 1 - smoothstep(0.0f, 0.055f, voronoi(u, v, 14, 12).border);
        const float height = mix(0.20f + 0.10f * sand, 0.52f + 0.36f * pillow + 0.06f * waves, glaze);
        return Color{height, glaze, crackle * glaze, 1};
    });

    Picture color(kSize), specgloss(kSize);
    const Color white{0.93f, 0.915f, 0.87f, 1}, cobalt{0.075f, 0.17f, 0.46f, 1}, sky{0.47f, 0.64f, 0.80f, 1};
    const Color ochre{0.86f, 0.60f, 0.17f, 1}, mortar{0.52f, 0.49f, 0.45f, 1};
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const float u = (static_cast<float>(x) + 0.5f) / kSize, v = (static_cast<float>(y) + 0.5f) / kSize;
            const Place p = place(u, v);
            const Color& layer = layers.at(x, y);
            const Ink ink = pattern(p.x, p.y);
            // The brush leaves the blue uneven.
            const float brush = fractal(u, v, {.cells = 10, .octaves = 4, .seed = 66});
            Color paint = mix(white, mix(sky, white, 0.5f * brush), ink.light);
            paint = mix(paint, ochre, ink.gold);
            paint = mix(paint, mix(cobalt, sky, 0.35f * brush), ink.dark);
            paint = scaled(paint, 0.95f + 0.05f * random(p.id, 1, 3));
            paint = mix(paint, Color{0.45f, 0.38f, 0.30f, 1}, 0.22f * layer[2]);
            const float dirt = fractal(u, v, {.cells = 12, .octaves = 4, .seed = 90});
            color.at(x, y) = mix(scaled(mortar, 0.8f + 0.4f * dirt), paint, layer[1]);
            // Glaze reflects 5 % at normal incidence, mortar 3 %; stored as sRGB.
            const float f0 = mix(0.19f, 0.247f, layer[1]);
            const float gloss = mix(0.18f, 0.90f - 0.10f * layer[2] - 0.10f * smoothstep(0.5f, 0.8f, dirt), layer[1]);
            specgloss.at(x, y) = {f0, f0, f0, gloss};
        }
    }
    return {{"tiles_color", 3, std::move(color)},
            {"tiles_specgloss", 4, std::move(specgloss)},
            {"tiles_normal", 3, normals_of(layers, 0, 9.0f)}};
}

}  // namespace textures
