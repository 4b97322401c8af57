// Light as spherical harmonics: nine coefficients, from which shaders compute diffuse light.
//
//   SphericalHarmonics sky = gradient_ambient({0.4f, 0.5f, 0.7f}, glm::vec3(0.3f), glm::vec3(0.1f));
//   add_light(sky, {0, 1, 0}, glm::vec3(0.2f));
#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>

namespace patina::runtime {

// Linear radiance that arrives from a unit direction of the world; asked by several threads at once.
using Radiance = std::function<glm::vec3(glm::vec3)>;

// Radiance in nine coefficients, order l(l+1)+m, of the real basis without the Condon-Shortley sign, evaluated on world
// x, y and z directly: Y1 = 0.4886 y, Y2 = 0.4886 z, Y3 = 0.4886 x ... (Ramamoorthi and Hanrahan 2001).
struct SphericalHarmonics {
    std::array<glm::vec3, 9> coefficients{};
};
SphericalHarmonics constant_ambient(glm::vec3 radiance);
// The radiance horizon + (sky - ground) / 2 * y + ((sky + ground) / 2 - horizon) * y^2: exactly the three colours at
// up, horizontal and down, with no ringing.
SphericalHarmonics gradient_ambient(glm::vec3 sky, glm::vec3 horizon, glm::vec3 ground);
// Adds a directional light. `color`: its E/pi. The irradiance of the sum, over pi, grows by this on a surface that
// faces the light. Nine coefficients would make it 17/16 of that, so they are scaled (Sloan, "Stupid Spherical
// Harmonics Tricks", GDC 2008, "normalization"). `direction`: to the light, unit.
void add_light(SphericalHarmonics& sum, glm::vec3 direction, glm::vec3 color);
// The basis at a unit direction.
std::array<float, 9> spherical_harmonics_basis(glm::vec3 direction);
// The radiance that the coefficients describe, at a unit direction; 0 where it would be negative.
glm::vec3 evaluate(const SphericalHarmonics& sh, glm::vec3 direction);
// The integral of the radiance times each function of the basis, over the texels of a cube with faces of this size.
SphericalHarmonics project(const Radiance& radiance, int face_size = 48);
SphericalHarmonics scaled(SphericalHarmonics light, float factor);
// The brightest that a white matt surface becomes, whichever way it faces: irradiance over pi, the largest of the
// channels.
float largest_irradiance(const SphericalHarmonics& light);
// The same light, smoothed as little as makes the irradiance nowhere negative. Nine coefficients of a small bright lamp
// give negative irradiance on its other side, which would be a black spot on white things. Light without such a spot is
// returned as it is.
SphericalHarmonics without_negative_light(const SphericalHarmonics& light);
// The same light for a world whose z points the other way: right-handed to left-handed and back.
SphericalHarmonics with_z_reversed(SphericalHarmonics light);

// Diffuse light as engines evaluate it. At the normal n, the irradiance over pi is, for channel c (red, green, blue):
//   dot(linear[c], (n, 1)) + dot(quadratic[c], (n.x n.y, n.y n.z, n.z n.z, n.z n.x)) + last[c] (n.x^2 - n.y^2)
// The cosine lobe is in it: factors 1, 2/3 and 1/4 of the bands (Ramamoorthi and Hanrahan, "An Efficient Representation
// for Irradiance Environment Maps", SIGGRAPH 2001).
struct PackedIrradiance {
    std::array<glm::vec4, 3> linear{}, quadratic{};
    glm::vec3 last{0};
};
PackedIrradiance packed_irradiance(const SphericalHarmonics& light);

}  // namespace patina::runtime
