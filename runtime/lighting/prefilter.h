// Prefiltering: what rough surfaces reflect of an environment, as the levels of a cube map.
//
//   TextureData map = prefiltered(Pyramid(radiance, 256), {});
#pragma once

#include <functional>
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
    // The finest level is the mean of `samples` x `samples` directions in each texel.
    Pyramid(const Radiance& radiance, int size, int samples = 1);

    int size() const { return size_; }
    glm::vec3 look(glm::vec3 direction, float level) const;

private:
    glm::vec3 bilinear(int level, const CubePlace& place) const;

    int size_;
    std::vector<std::vector<glm::vec3>> levels_;
};

// The radiance as a cube of one level: the mean of `samples` x `samples` directions in each texel.
TextureData sampled(const Radiance& radiance, int size, int samples);

// Given the share that is done, 0 to 1, on the calling thread.
using PrefilterProgress = std::function<void(double)>;

// What a surface of this perceptual roughness reflects for a view along its normal: the mean of the radiance, weighted
// by n.l (Karis, SIGGRAPH 2013). `size`: texels along a face. `samples`: pairs of directions for each texel.
TextureLevel blurred(const Pyramid& pyramid, float roughness, int size, int samples,
                     const PrefilterProgress& progress = {});

// All levels of an environment's map. The first has the size of the pyramid.
TextureData prefiltered(const Pyramid& pyramid, const PrefilterProgress& progress);

}  // namespace patina::runtime
