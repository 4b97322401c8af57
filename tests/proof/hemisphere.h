// All directions that light can come from, as points and weights for the integral of a BRDF: close together around the
// mirror direction, as close as a highlight of the given width needs.
//
//   for (const LightPoint& p : light_points(ndotv, alpha)) sum += brdf(p.l, v) * p.ndotl * p.weight;
#pragma once

#include "proof/quadrature.h"

namespace patina::proof {

// The normal is z and the view lies in the plane of x and z.
inline Direction view_of(double ndotv) {
    return direction(ndotv, 0);
}

struct LightPoint {
    Direction l;
    double ndotl = 0, ndoth = 0, ldoth = 0;
    double weight = 0;  // solid angle; a point stands for its mirror image on the other side of the plane as well
};

// Gauss's rule over half vectors in polar coordinates (t, phi), t = ln tan(theta): as wide for every alpha. The light
// is above the surface where cos(phi) > -cot(2 theta) cot(theta_v): all around up to theta = (90 deg - theta_v) / 2,
// nowhere from (90 deg + theta_v) / 2 on, with square roots at both ends of what lies between.
struct Fineness {
    std::size_t azimuth = 32, per_unit = 8, with_roots = 96;
};
// Some 5000 points, good to six digits; some 600, good to three.
inline constexpr Fineness kFine{}, kCoarse{.azimuth = 12, .per_unit = 4, .with_roots = 32};

inline std::vector<LightPoint> light_points(double ndotv, double alpha, Fineness fineness = kFine) {
    std::vector<LightPoint> points;
    const double theta_v = std::acos(ndotv), cot_v = ndotv / std::max(std::sin(theta_v), 1e-12);
    const Direction v = view_of(ndotv);
    const double first = std::log(alpha) - 11;
    const double whole = std::log(std::tan((kPi / 2 - theta_v) / 2 + 1e-9));
    const double last = std::log(std::tan((kPi / 2 + theta_v) / 2));
    const auto ring = [&](double t, double weight, bool is_whole) {
        const double theta = std::atan(std::exp(t)), sine = std::sin(theta), cosine = std::cos(theta);
        const double cut = -cot_v / std::tan(2 * theta);
        const double phi_end = is_whole ? kPi : std::acos(std::clamp(cut, -1.0, 1.0));
        const Rule phi = gauss_legendre(0, phi_end, fineness.azimuth);
        for (std::size_t i = 0; i < phi.size(); ++i) {
            const Direction h = direction(cosine, phi.points[i]);
            const double vdoth = dot(v, h);
            LightPoint point{.l = {2 * vdoth * h[0] - v[0], 2 * vdoth * h[1] - v[1], 2 * vdoth * h[2] - v[2]}};
            point.ndotl = point.l[2];
            point.ndoth = cosine;
            point.ldoth = vdoth;
            // d theta = sin cos dt, and the solid angle of light is 4 v.h that of half vectors.
            point.weight = 2 * 4 * vdoth * sine * sine * cosine * phi.weights[i] * weight;
            if (point.ndotl > 0) points.push_back(point);
        }
    };
    if (whole > first) {
        const Rule t = composite(first, whole, static_cast<std::size_t>(std::ceil(whole - first)), fineness.per_unit);
        for (std::size_t i = 0; i < t.size(); ++i) ring(t.points[i], t.weights[i], true);
    }
    if (last > whole) {
        const Rule t = root_ended(std::max(first, whole), last, fineness.with_roots);
        for (std::size_t i = 0; i < t.size(); ++i) ring(t.points[i], t.weights[i], false);
    }
    return points;
}

}  // namespace patina::proof
