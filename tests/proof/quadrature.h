// Numerical integration and evenly spread points: what the proofs compare a closed form with. Plain mathematics; knows
// no node.
//
//   const Rule rule = gauss_legendre(0, 1, 16);
//   sum over i of rule.weights[i] * f(rule.points[i])
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <vector>

namespace patina::proof {

inline constexpr double kPi = std::numbers::pi;

// Sanitizers make a point ten to fifty times as dear: fewer of them are enough to find what they look for.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

struct Rule {
    std::vector<double> points, weights;
    std::size_t size() const { return points.size(); }
};

// On [-1, 1], exact for polynomials up to degree 2 count - 1. Made once for each count.
inline const Rule& gauss_legendre(std::size_t count) {
    static std::map<std::size_t, Rule> made;
    Rule& rule = made[count];
    const auto n = static_cast<double>(count);
    for (std::size_t i = rule.size(); i < count; ++i) {
        // Newton's method on the Legendre polynomial, from Tricomi's estimate of its root.
        double x = -std::cos(kPi * (static_cast<double>(i) + 0.75) / (n + 0.5)), slope = 1;
        for (int step = 0; step < 8; ++step) {
            double p0 = 1, p1 = x;
            for (std::size_t k = 2; k <= count; ++k) {
                const auto m = static_cast<double>(k);
                const double p2 = ((2 * m - 1) * x * p1 - (m - 1) * p0) / m;
                p0 = p1;
                p1 = p2;
            }
            slope = n * (x * p1 - p0) / (x * x - 1);
            x -= p1 / slope;
        }
        rule.points.push_back(x);
        rule.weights.push_back(2 / ((1 - x * x) * slope * slope));
    }
    return rule;
}

inline Rule gauss_legendre(double from, double to, std::size_t count) {
    Rule rule = gauss_legendre(count);
    for (double& point : rule.points) point = from + (to - from) * 0.5 * (1 + point);
    for (double& weight : rule.weights) weight *= 0.5 * (to - from);
    return rule;
}

// Gauss's rule on equal parts: for functions that change on the scale of a part.
inline Rule composite(double from, double to, std::size_t parts, std::size_t count) {
    Rule rule;
    const double step = (to - from) / static_cast<double>(parts);
    for (std::size_t i = 0; i < parts; ++i) {
        const double begin = from + step * static_cast<double>(i);
        const Rule part = gauss_legendre(begin, begin + step, count);
        rule.points.insert(rule.points.end(), part.points.begin(), part.points.end());
        rule.weights.insert(rule.weights.end(), part.weights.begin(), part.weights.end());
    }
    return rule;
}

// Gauss's rule through x = from + (to - from) (1 - cos t) / 2: for functions with a square root at either end.
inline Rule root_ended(double from, double to, std::size_t count) {
    Rule rule = gauss_legendre(0, kPi, count);
    for (std::size_t i = 0; i < count; ++i) {
        rule.weights[i] *= 0.5 * (to - from) * std::sin(rule.points[i]);
        rule.points[i] = from + 0.5 * (to - from) * (1 - std::cos(rule.points[i]));
    }
    return rule;
}

// Point `index` of a sequence that fills the unit cube evenly: a rotation by the powers of the root of
// x^(d + 1) = x + 1, the golden ratio's kin. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018.
class Sequence {
public:
    explicit Sequence(std::size_t dimensions) {
        double root = 2;
        for (int i = 0; i < 64; ++i) root = std::pow(1 + root, 1 / (static_cast<double>(dimensions) + 1));
        double step = 1;
        for (std::size_t i = 0; i < dimensions; ++i) steps_.push_back(step /= root);
    }
    // In [0, 1).
    double operator()(std::size_t index, std::size_t dimension) const {
        const double x = 0.5 + steps_[dimension] * static_cast<double>(index + 1);
        return x - std::floor(x);
    }

private:
    std::vector<double> steps_;
};

using Direction = std::array<double, 3>;

inline double dot(const Direction& a, const Direction& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Direction direction(double cosine, double angle) {
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    return {sine * std::cos(angle), sine * std::sin(angle), cosine};
}
// Two numbers in [0, 1) as a direction: evenly over the upper hemisphere, over the whole sphere.
inline Direction on_hemisphere(double u, double w) {
    return direction(u, 2 * kPi * w);
}
inline Direction on_sphere(double u, double w) {
    return direction(2 * u - 1, 2 * kPi * w);
}

}  // namespace patina::proof
