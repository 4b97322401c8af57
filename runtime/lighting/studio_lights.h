// The lights of the studio in which `patina render` shows graphs and meshes without lights of their own: a key light
// from the upper left front, a weak cool fill, and a rim.
#pragma once

#include <array>

namespace patina::runtime {

// A directional light: towards it, any length; linear, E / pi.
struct StudioLight {
    std::array<float, 3> direction, color;
};
inline constexpr StudioLight kStudioLights[] = {
    {{-0.6f, 0.8f, 0.8f}, {0.41f, 0.395f, 0.375f}},
    {{0.9f, 0.1f, 0.5f}, {0.042f, 0.053f, 0.07f}},
    {{0.5f, 0.5f, -0.8f}, {0.155f, 0.155f, 0.155f}},
};

}  // namespace patina::runtime
