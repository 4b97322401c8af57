// Prefiltering: what rough surfaces reflect of an environment, as the levels of a cube map.
//
//   Pyramid pyramid(radiance, 256);
//   TextureLevel rough = blurred(pyramid, 3, 32);
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "patina/interpret.h"
#include "runtime/lighting/cube.h"
#include "runtime/lighting/harmonics.h"

namespace patina::runtime {

// Levels of an environment's map, and how rough the surface is that level `level` is blurred for: 0 at the first, 1 at
// the last, as MipFromRoughness reads them.
inline constexpr int kEnvironmentLevels = 6;
float roughness_of_level(int level);

// The radiance on the faces of a cube, with mip levels down to one texel per face. A sample reads the level whose
// texels are as wide as the distance between samples (Krivanek and Colbert, "Real-time Shading with Filtered Importance
// Sampling", EGSR 2008).
class Pyramid {
public:
    Pyramid(const Radiance& radiance, int size);

    int size() const { return size_; }
    glm::vec3 look(glm::vec3 direction, float level) const;

private:
    glm::vec3 bilinear(int level, const CubePlace& place) const;

    int size_;
    std::vector<std::vector<glm::vec3>> levels_;
};

// What a surface that is as rough as the level reflects, for a view along its normal: the mean of the radiance,
// weighted by n.l (Karis, SIGGRAPH 2013). `size`: texels along a face.
TextureLevel blurred(const Pyramid& pyramid, int level, int size);

}  // namespace patina::runtime
