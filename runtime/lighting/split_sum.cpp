#include "runtime/lighting/split_sum.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace patina::runtime {
namespace {

constexpr double kPi = std::numbers::pi;

// Moves a point of [0, 1] towards both ends, and gives the factor by which steps shrink there. An integrand with a root
// or a slope at an end becomes flat there up to its second derivative. So the midpoint rule has fourth order.
struct Crowded {
    double at, step;
};
Crowded crowded(int index, int count) {
    double s = (index + 0.5) / count;
    return {s * s * s * (10 + s * (6 * s - 15)), 30 * s * s * (1 - s) * (1 - s) / count};
}

}  // namespace

std::array<double, 2> split_sum(double alpha, double ndotv, int samples) {
    // A mirror has one half vector: its F is the offset.
    double grazing = std::pow(1 - ndotv, 5);
    if (alpha < 1e-4) return {1 - grazing, grazing};
    // Half vectors in polar coordinates, tan(angle) = alpha sinh(x), in which GGX times its solid angle is smooth. The
    // light is above the surface all around up to the first angle, and nowhere from the second on.
    double a2 = alpha * alpha, view_angle = std::acos(ndotv), view_sine = std::sin(view_angle);
    double view_root = std::sqrt(ndotv * ndotv * (1 - a2) + a2);
    double highest = std::min(kPi / 4 + view_angle / 2, kPi / 2 - 1e-9);
    std::array<double, 3> ends = {0, std::asinh(std::tan(kPi / 4 - view_angle / 2) / alpha),
                                  std::asinh(std::tan(highest) / alpha)};
    double scale = 0, offset = 0;
    int around = std::max(1, samples / 2);  // the other half mirrors this one
    for (std::size_t part = 0; part < 2; part++) {
        for (int i = 0; i < samples; i++) {
            double length = ends[part + 1] - ends[part];
            double x = ends[part] + length * crowded(i, samples).at;
            double tangent = alpha * std::sinh(x), ndoth = 1 / std::sqrt(1 + tangent * tangent), sine = tangent * ndoth;
            double share = 2 * std::sinh(x) / std::pow(std::cosh(x), 3) * length * crowded(i, samples).step / kPi;
            double edge = (ndotv / (2 * ndoth) - ndotv * ndoth) / std::max(view_sine * sine, 1e-12);
            double last = std::acos(std::clamp(edge, -1.0, 1.0));
            for (int k = 0; k < around; k++) {
                double phi = last * crowded(k, around).at;
                double vdoth = view_sine * sine * std::cos(phi) + ndotv * ndoth, ndotl = 2 * vdoth * ndoth - ndotv;
                if (ndotl <= 0 || vdoth <= 0) continue;
                // w = 4 V (n.l) (v.h) / (n.h), with Smith's exact joint V.
                double light_root = std::sqrt(ndotl * ndotl * (1 - a2) + a2);
                double weight = 2 * ndotl * vdoth / (ndoth * (ndotl * view_root + ndotv * light_root));
                weight *= share * last * crowded(k, around).step;
                double fresnel = std::pow(1 - vdoth, 5);
                scale += (1 - fresnel) * weight;
                offset += fresnel * weight;
            }
        }
    }
    return {scale, offset};
}

std::vector<float> split_sum_numbers() {
    constexpr int kSamples = 24;
    std::vector<float> numbers;
    for (int y = 0; y < kSplitSumSize; y++) {
        double roughness = double(y) / (kSplitSumSize - 1);
        for (int x = 0; x < kSplitSumSize; x++) {
            double root = double(x) / (kSplitSumSize - 1);
            auto [scale, offset] = split_sum(roughness * roughness, root * root, kSamples);
            numbers.insert(numbers.end(), {float(scale), float(offset)});
        }
    }
    return numbers;
}

}  // namespace patina::runtime
