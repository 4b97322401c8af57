// The room `lighting`: light as numbers and tables, computed on the CPU. It knows no scene and no device; all but
// MERL files is a library of its own, which reads no pictures either.
//
// The environment of a scene, in the three forms that shaders read: nine coefficients for diffuse light, a cube map
// blurred level by level for specular light, and the table of the split sum, which is the same for all environments.
// It is computed on the CPU from a function of the direction.
//
//   Environment sunset([](glm::vec3 d) { return glm::vec3(d.y > 0 ? 1 : 0.2f); }, 64);
//   scene.ambient = sunset.ambient();   texture = sunset.map();
#pragma once

#include <memory>
#include <mutex>
#include <span>

#include "patina/interpret.h"
#include "runtime/lighting/harmonics.h"

namespace patina::runtime {

class Environment {
public:
    // `face_size`: texels along a face of the cube, a power of two, 256 or more: the last level has 8 or more, fewer of
    // which would show as facets.
    Environment(Radiance radiance, int face_size);
    // With a map that is known already: its levels from the second on, texel by texel, red, green and blue.
    // `blurred_levels` must outlive this.
    Environment(Radiance radiance, int face_size, std::span<const float> blurred_levels);
    // What the coefficients describe, smooth as it is.
    explicit Environment(const SphericalHarmonics& ambient);

    glm::vec3 radiance(glm::vec3 direction) const { return radiance_(direction); }
    const SphericalHarmonics& ambient() const { return ambient_; }
    // A cube; made when first asked for, by one thread.
    std::shared_ptr<const TextureData> map() const;

private:
    Radiance radiance_;
    int face_size_;
    SphericalHarmonics ambient_;
    std::span<const float> blurred_levels_{};  // empty: not known
    mutable std::once_flag made_;
    mutable std::shared_ptr<const TextureData> map_;
};

// The studio of studio.h. The same object each time.
std::shared_ptr<const Environment> studio_environment();

}  // namespace patina::runtime
