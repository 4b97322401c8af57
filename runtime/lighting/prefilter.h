// Prefiltering: what rough surfaces reflect of an environment, as the levels of a cube map.
//
//   TextureData map = prefiltered(Pyramid(radiance, 256), {});
#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "patina/interpret.h"
#include "runtime/lighting/cube.h"
#include "runtime/lighting/harmonics.h"

namespace patina::runtime {

// Levels of an environment's map, and the roughness of the surface for which level `level` is blurred: 0 at the first,
// 1 at the last, as MipFromRoughness reads them.
inline constexpr int kEnvironmentLevels = 6;
float roughness_of_level(int level);

// The radiance on the faces of a cube, as levels of squares: texels, four of them together, and so on up to whole
// faces. Each square knows how much light comes from it, and from where. The reflection of a rough surface is a sum
// over squares: large ones where its lobe changes little, small ones elsewhere (after Barnes and Hut, "A Hierarchical
// O(N log N) Force-Calculation Algorithm", Nature 324, 1986). All light is in that sum, so a lamp of a few pixels
// leaves no grain.
class Pyramid {
public:
    // `size`: texels along a face, a power of two. Each texel is the mean of `samples` x `samples` directions.
    Pyramid(const Radiance& radiance, int size, int samples = 1);

    int size() const { return size_; }
    // Of the texel in this direction.
    glm::vec3 radiance(glm::vec3 direction) const;
    // The mean of the radiance over the GGX lobe around the unit normal, for a view along it, weighted by n.l (Karis,
    // SIGGRAPH 2013). `roughness`: perceptual, 0 to 1.
    glm::vec3 reflected(glm::vec3 normal, float roughness) const;

private:
    // A texel, or four squares of the next finer level.
    struct Square {
        glm::vec3 direction{0};  // to the centre of its light
        float solid_angle = 0;
        glm::vec3 light{0};  // the integral of the radiance
        float radius = 0;    // from `direction` to its furthest corner, as a chord of the unit sphere; 0 for a texel
    };
    using Level = std::vector<Square>;  // face by face, row by row
    static Level texels(const Radiance& radiance, int size, int samples);
    static Level coarser(const Level& finer, int size);
    static Square joined(const std::array<Square, 4>& quarters);

    int size_;
    std::vector<Level> levels_{};  // the texels first, the six faces last
};

// The radiance as a cube of one level: the mean of `samples` x `samples` directions in each texel.
TextureData sampled(const Radiance& radiance, int size, int samples);

// Given the share that is done, 0 to 1, on the calling thread.
using PrefilterProgress = std::function<void(double)>;

// The reflection of surfaces of this perceptual roughness that are seen along their normals. `size`: texels along a
// face.
TextureLevel blurred(const Pyramid& pyramid, float roughness, int size, const PrefilterProgress& progress = {});

// All levels of an environment's map. The first has the size of the pyramid.
TextureData prefiltered(const Pyramid& pyramid, const PrefilterProgress& progress);

}  // namespace patina::runtime
