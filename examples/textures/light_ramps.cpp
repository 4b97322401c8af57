// Ramps for a lighting graph to look its tones up in: from what the light leaves dark, at the left, to what it falls on
// straight; a cold one in the first row, a warm one in the last.
#include <array>

#include "examples/textures/noise.h"
#include "examples/textures/sets.h"

namespace textures {
namespace {

using Tones = std::array<Color, 4>;
constexpr Tones kCold = {{{0, 0, 0, 1}, {0.36f, 0.34f, 0.72f, 1}, {0.55f, 0.78f, 0.86f, 1}, {0.97f, 1, 1, 1}}};
constexpr Tones kWarm = {{{0, 0, 0, 1}, {0.66f, 0.20f, 0.32f, 1}, {0.97f, 0.62f, 0.30f, 1}, {1, 0.97f, 0.82f, 1}}};
constexpr std::array<float, 3> kEdges = {0.44f, 0.6f, 0.86f};  // a half is where light grazes

Color tone(const Tones& tones, float u) {
    Color color = tones[0];
    for (std::size_t i = 0; i < kEdges.size(); ++i)
        color = mix(color, tones[i + 1], smoothstep(kEdges[i] - 0.02f, kEdges[i] + 0.02f, u));
    return color;
}

}  // namespace

Set light_ramps() {
    Picture ramps(kSize / 4);
    ramps.fill([](float u, float v) { return mix(tone(kCold, u), tone(kWarm, u), smoothstep(0.2f, 0.8f, v)); });
    return {{"light_ramps", 3, ramps}};
}

}  // namespace textures
