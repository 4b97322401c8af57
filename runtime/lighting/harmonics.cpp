#include "runtime/lighting/harmonics.h"

#include <algorithm>
#include <numbers>

#include "runtime/lighting/cube.h"

namespace patina::runtime {
namespace {

// Normalisation of the basis: sqrt(1 / 4pi), sqrt(3 / 4pi), sqrt(15 / 4pi), sqrt(5 / 16pi), sqrt(15 / 16pi).
constexpr float kK0 = 0.28209479177387814f;
constexpr float kK1 = 0.48860251190291992f;
constexpr float kK2 = 1.0925484305920792f;
constexpr float kK3 = 0.31539156525252005f;
constexpr float kK4 = 0.5462742152960396f;

// What the cosine lobe leaves of the bands 1 and 2, over pi.
constexpr float kBand1 = 2.0f / 3, kBand2 = 1.0f / 4;

std::size_t band_of(std::size_t coefficient) {
    return coefficient < 1 ? 0 : coefficient < 4 ? 1 : 2;
}

struct Range {
    float low = 0, high = 0;
};

// Of the irradiance over pi, in all directions and channels, and of 0.
Range irradiance_range(const SphericalHarmonics& light) {
    constexpr std::array<float, 3> kBands = {1, kBand1, kBand2};
    // So smooth a function is less than a thousandth larger between directions that are 3 degrees apart.
    constexpr int kFaceSize = 32;
    Range range;
    for (int face = 0; face < 6; face++) {
        for (int y = 0; y < kFaceSize; y++) {
            for (int x = 0; x < kFaceSize; x++) {
                const std::array<float, 9> basis = spherical_harmonics_basis(cube_direction(face, x, y, kFaceSize));
                glm::vec3 sum(0);
                for (std::size_t i = 0; i < basis.size(); i++)
                    sum += kBands[band_of(i)] * basis[i] * light.coefficients[i];
                range.low = std::min({range.low, sum.r, sum.g, sum.b});
                range.high = std::max({range.high, sum.r, sum.g, sum.b});
            }
        }
    }
    return range;
}

// Sloan's window of this width ("Stupid Spherical Harmonics Tricks", GDC 2008, "windowing"): 1 / (1 + w l^2 (l + 1)^2)
// of band l.
SphericalHarmonics windowed(SphericalHarmonics light, float width) {
    constexpr std::array<float, 3> kOfBand = {0, 1 * 4, 4 * 9};
    for (std::size_t i = 0; i < light.coefficients.size(); i++)
        light.coefficients[i] /= 1 + width * kOfBand[band_of(i)];
    return light;
}

}  // namespace

std::array<float, 9> spherical_harmonics_basis(glm::vec3 d) {
    return {kK0,
            kK1 * d.y,
            kK1 * d.z,
            kK1 * d.x,
            kK2 * d.x * d.y,
            kK2 * d.y * d.z,
            kK3 * (3 * d.z * d.z - 1),
            kK2 * d.x * d.z,
            kK4 * (d.x * d.x - d.y * d.y)};
}

SphericalHarmonics constant_ambient(glm::vec3 radiance) {
    SphericalHarmonics result;
    result.coefficients[0] = radiance / kK0;
    return result;
}

SphericalHarmonics gradient_ambient(glm::vec3 sky, glm::vec3 horizon, glm::vec3 ground) {
    // On the unit sphere y^2 = 1/3 - (3z^2 - 1)/6 - (x^2 - y^2)/2: each term is one basis function.
    glm::vec3 linear = (sky - ground) / 2.0f;
    glm::vec3 square = (sky + ground) / 2.0f - horizon;
    SphericalHarmonics result;
    result.coefficients[0] = (horizon + square / 3.0f) / kK0;
    result.coefficients[1] = linear / kK1;
    result.coefficients[6] = square * (-1.0f / 6) / kK3;
    result.coefficients[8] = square * (-1.0f / 2) / kK4;
    return result;
}

void add_light(SphericalHarmonics& sum, glm::vec3 direction, glm::vec3 color) {
    constexpr float kNormalization = 16 * std::numbers::pi_v<float> / 17;
    std::array<float, 9> basis = spherical_harmonics_basis(direction);
    for (std::size_t i = 0; i < basis.size(); i++) sum.coefficients[i] += color * (kNormalization * basis[i]);
}

glm::vec3 evaluate(const SphericalHarmonics& sh, glm::vec3 direction) {
    std::array<float, 9> basis = spherical_harmonics_basis(direction);
    glm::vec3 sum(0);
    for (std::size_t i = 0; i < basis.size(); i++) sum += basis[i] * sh.coefficients[i];
    return glm::max(sum, glm::vec3(0));
}

// c_i = integral of L Y_i, over the texels of a cube with their solid angles, which are made to sum to 4 pi.
SphericalHarmonics project(const Radiance& radiance, int face_size) {
    std::array<glm::dvec3, 9> sums{};
    double weight_sum = 0;
    for (int face = 0; face < 6; face++) {
        for (int y = 0; y < face_size; y++) {
            for (int x = 0; x < face_size; x++) {
                glm::vec3 direction = cube_direction(face, x, y, face_size);
                float weight = cube_solid_angle(x, y, face_size);
                weight_sum += weight;
                std::array<float, 9> basis = spherical_harmonics_basis(direction);
                glm::vec3 light = radiance(direction) * weight;
                for (std::size_t i = 0; i < basis.size(); i++) sums[i] += glm::dvec3(basis[i] * light);
            }
        }
    }
    SphericalHarmonics result;
    for (std::size_t i = 0; i < sums.size(); i++)
        result.coefficients[i] = glm::vec3(sums[i] * (4 * std::numbers::pi / weight_sum));
    return result;
}

SphericalHarmonics scaled(SphericalHarmonics light, float factor) {
    for (glm::vec3& coefficient : light.coefficients) coefficient *= factor;
    return light;
}

SphericalHarmonics with_z_reversed(SphericalHarmonics light) {
    for (const std::size_t odd : {2, 5, 7}) light.coefficients[odd] = -light.coefficients[odd];
    return light;
}

float largest_irradiance(const SphericalHarmonics& light) {
    return irradiance_range(light).high;
}

SphericalHarmonics without_negative_light(const SphericalHarmonics& light) {
    // Negative light that is rounding alone, as a share of the brightest.
    constexpr float kRounding = 1e-4f;
    // The largest width leaves 1/257 of band 1, which is at most twice band 0, and less of band 2: no surface is then
    // black. Halving the interval 20 times finds the least width that will do.
    constexpr float kLargestWidth = 64;
    constexpr int kHalvings = 20;
    const Range range = irradiance_range(light);
    const float least = -kRounding * range.high;
    if (range.low >= least) return light;
    float enough = kLargestWidth, too_little = 0;
    for (int i = 0; i < kHalvings; i++) {
        const float middle = (enough + too_little) / 2;
        (irradiance_range(windowed(light, middle)).low >= least ? enough : too_little) = middle;
    }
    return windowed(light, enough);
}

PackedIrradiance packed_irradiance(const SphericalHarmonics& light) {
    PackedIrradiance packed;
    for (int channel = 0; channel < 3; channel++) {
        const auto c = [&](std::size_t i) { return light.coefficients[i][channel]; };
        const std::size_t at = std::size_t(channel);
        // 3 z^2 - 1 gives to the constant, too.
        packed.linear[at] = {kBand1 * kK1 * c(3), kBand1 * kK1 * c(1), kBand1 * kK1 * c(2),
                             kK0 * c(0) - kBand2 * kK3 * c(6)};
        packed.quadratic[at] = {kBand2 * kK2 * c(4), kBand2 * kK2 * c(5), 3 * kBand2 * kK3 * c(6), kBand2 * kK2 * c(7)};
        packed.last[channel] = kBand2 * kK4 * c(8);
    }
    return packed;
}

}  // namespace patina::runtime
