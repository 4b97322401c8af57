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

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <mutex>
#include <span>

#include "patina/interpret.h"

namespace patina::runtime {

// Radiance in nine coefficients, order l(l+1)+m, of the real basis without the Condon-Shortley sign, evaluated on world
// x, y and z directly: Y1 = 0.4886 y, Y2 = 0.4886 z, Y3 = 0.4886 x ... (Ramamoorthi and Hanrahan 2001).
struct SphericalHarmonics {
    std::array<glm::vec3, 9> coefficients{};
};
SphericalHarmonics constant_ambient(glm::vec3 radiance);
// The radiance horizon + (sky - ground) / 2 * y + ((sky + ground) / 2 - horizon) * y^2: exactly the three colours at
// up, horizontal and down, with no ringing.
SphericalHarmonics gradient_ambient(glm::vec3 sky, glm::vec3 horizon, glm::vec3 ground);
// Adds a directional light. `color`: its E/pi, which is what the irradiance of the sum gains, over pi, on a surface
// that faces the light: nine coefficients would make it 17/16 of that, so they are scaled (Sloan, "Stupid Spherical
// Harmonics Tricks", GDC 2008, "normalization"). `direction`: to the light, unit.
void add_light(SphericalHarmonics& sum, glm::vec3 direction, glm::vec3 color);
// The basis at a unit direction.
std::array<float, 9> spherical_harmonics_basis(glm::vec3 direction);

// Linear radiance that arrives from a unit direction of the world; asked by several threads at once.
using Radiance = std::function<glm::vec3(glm::vec3)>;

// Levels of an environment's map, and how rough the surface is that level `level` is blurred for: 0 at the first, 1 at
// the last, as MipFromRoughness reads them.
inline constexpr int kEnvironmentLevels = 6;
float roughness_of_level(int level);

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
