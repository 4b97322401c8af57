// Quilted cloth: a large pattern of stitched pillows, and the small weave that goes over it as a detail. The weave's
// colour is a factor around the middle grey of 0.5 in the file, as detail maps are.
#include <algorithm>
#include <cmath>

#include "examples/textures/noise.h"
#include "examples/textures/sets.h"

namespace textures {
namespace {

constexpr float kPi = 3.14159265f;

// Diamonds: seams run along both diagonals, four of each in a picture.
constexpr int kSeams = 4;

// Distance from the nearest seam, in diamonds: 0 to 0.5.
float from_seam(float u, float v) {
    const auto to_whole = [](float x) { return std::abs(x - std::round(x)); };
    return std::min(to_whole((u + v) * kSeams), to_whole((u - v) * kSeams));
}

Set pillows() {
    Picture layers(kSize), mask(kSize);  // red: height
    layers.fill([](float u, float v) {
        const float pillow = std::abs(std::sin(kPi * (u + v) * kSeams) * std::sin(kPi * (u - v) * kSeams));
        const float creases = fractal(u, v, {.cells = 8, .octaves = 3, .seed = 3});
        const float pull = 0.5f * (creases - 0.5f) * (1 - smoothstep(0.0f, 0.3f, from_seam(u, v)));
        return Color{std::clamp(0.05f + 0.9f * std::pow(pillow, 0.45f) + pull, 0.0f, 1.0f), 0, 0, 1};
    });
    // The seams are taped: no weave there. In alpha, where Unity's Standard shader reads it.
    mask.fill([](float u, float v) {
        const float woven = smoothstep(0.045f, 0.065f, from_seam(u, v));
        return Color{woven, woven, woven, woven};
    });
    return {{"quilt_normal", 3, normals_of(layers, 0, 14.0f)}, {"quilt_mask", 4, std::move(mask)}};
}

// Threads over and under each other, 16 by 16 in a picture.
Set weave() {
    constexpr int kThreads = 16;
    Picture layers(kSize);  // red: height, green: 1 where the thread runs along u, blue: the thread's own shade
    layers.fill([](float u, float v) {
        const float x = u * kThreads, y = v * kThreads;
        const float cx = std::floor(x), cy = std::floor(y), fx = x - cx - 0.5f, fy = y - cy - 0.5f;
        const bool is_along_u = std::fmod(cx + cy, 2.0f) < 0.5f;
        const float across = is_along_u ? fy : fx, along = is_along_u ? fx : fy;
        const float round = std::sqrt(std::max(0.0f, 1 - 3.2f * across * across));
        const float fibres =
            fractal(u, v, {.cells = is_along_u ? 12 : 96, .cells_v = is_along_u ? 96 : 12, .octaves = 2, .seed = 12});
        const float height = round * (0.55f + 0.45f * std::cos(kPi * along)) + 0.12f * (fibres - 0.5f);
        const std::uint32_t thread = hash(is_along_u ? 1 : 0, static_cast<std::uint32_t>(is_along_u ? cy : cx), 4);
        return Color{std::clamp(height, 0.0f, 1.0f), is_along_u ? 1.0f : 0.0f, random(thread, 0, 4), 1};
    });
    Picture color(kSize);
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const Color& layer = layers.at(x, y);
            const float shade = 0.30f + 0.24f * layer[0] + 0.06f * layer[1] + 0.10f * (layer[2] - 0.5f);
            color.at(x, y) = {shade + 0.01f, shade, shade - 0.01f, 1};
        }
    }
    return {{"weave_color", 3, std::move(color)}, {"weave_normal", 3, normals_of(layers, 0, 5.0f)}};
}

}  // namespace

Set quilt() {
    Set all = pillows();
    for (Texture& texture : weave()) all.push_back(std::move(texture));
    return all;
}

}  // namespace textures
