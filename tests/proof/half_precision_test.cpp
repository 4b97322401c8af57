// GGX computed in half precision, against double: what the cross product of the mobile form is for. A half has eleven
// bits; a cosine near 1 keeps none of the angle below 1.3 degrees, the cross product of the same vectors does.
#include <gtest/gtest.h>

#include <algorithm>

#include "proof/quadrature.h"
#include "proof/term.h"

namespace patina::proof {
namespace {

constexpr std::size_t kPoints = kSanitized ? 20000 : 200000;
// Where alpha begins: AlphaFromRoughness goes no lower.
constexpr double kSmoothest = 0.002;
constexpr double kLargest = 65504;

struct Point {
    Direction n, h;
    double alpha = 0, sine = 0;
};

// The normal over the whole sphere, every roughness, and the half vector at every angle from the normal up to 90
// degrees: of one half of the points evenly so, of the other as wide as the peak is.
Point point(std::size_t i) {
    static const Sequence sequence(5);
    const auto u = [i](std::size_t dimension) { return sequence(i, dimension); };
    const Direction n = on_sphere(u(0), u(1));
    const double smooth = std::sqrt(kSmoothest), roughness = smooth + (1 - smooth) * u(4);
    const double alpha = roughness * roughness, turn = 2 * kPi * u(3);
    const double angle = i % 2 == 0 ? kPi / 2 * u(2) : std::atan(alpha * std::tan(kPi / 2 * u(2)));
    // Two directions at right angles to n and to each other.
    const Direction side = std::abs(n[2]) < 0.9 ? Direction{0, 0, 1} : Direction{1, 0, 0};
    Direction t = {n[1] * side[2] - n[2] * side[1], n[2] * side[0] - n[0] * side[2], n[0] * side[1] - n[1] * side[0]};
    const double length = std::sqrt(dot(t, t));
    for (double& c : t) c /= length;
    const Direction b = {n[1] * t[2] - n[2] * t[1], n[2] * t[0] - n[0] * t[2], n[0] * t[1] - n[1] * t[0]};
    Direction h{};
    for (std::size_t c = 0; c < 3; ++c)
        h[c] = std::cos(angle) * n[c] + std::sin(angle) * (std::cos(turn) * t[c] + std::sin(turn) * b[c]);
    return {.n = n, .h = h, .alpha = alpha, .sine = std::sin(angle)};
}

std::vector<double> values(const char* call, Arithmetic arithmetic) {
    Term term = Term::of("float f(float3 n, float3 h, float a) { return " + std::string(call) + "; }", arithmetic);
    std::vector<double> all(kPoints);
    term.each(
        kPoints,
        [](std::size_t i, double* in) {
            const Point p = point(i);
            std::copy(p.n.begin(), p.n.end(), in);
            std::copy(p.h.begin(), p.h.end(), in + 3);
            in[6] = p.alpha;
        },
        [&](std::size_t i, const double* out) { all[i] = out[0]; });
    return all;
}

constexpr const char* kNaive = "DistributionGGX(NdotH(n, h), a)";
constexpr const char* kMobile = "DistributionGGXMobile(n, h, a)";
constexpr const char* kUnity = "DistributionGGXUnity(NdotH(n, h), a)";

// What a half can hold of the exact values.
const std::vector<double>& exact() {
    static const std::vector<double> all = [] {
        std::vector<double> made = values(kNaive, {});
        for (double& value : made) value = std::min(value, kLargest / kPi);
        return made;
    }();
    return all;
}

struct Errors {
    double most = 0, of_999 = 0;
};
Errors relative_errors(const char* name, const char* call) {
    const std::vector<double> half = values(call, {.half = true});
    std::vector<double> errors(kPoints);
    for (std::size_t i = 0; i < kPoints; ++i) errors[i] = std::abs(half[i] / exact()[i] - 1);
    std::sort(errors.begin(), errors.end());
    const auto infinite = std::count(errors.begin(), errors.end(), INFINITY);
    const Errors found{errors.back(), errors[kPoints * 999 / 1000]};
    std::printf(
        "%-24s largest error %.3g, 99.9 %% of all at most %.3g, 99 %% %.3g, half of all %.2g; %.2f %% infinite\n", name,
        found.most, found.of_999, errors[kPoints * 99 / 100], errors[kPoints / 2],
        100 * static_cast<double>(infinite) / kPoints);
    return found;
}

constexpr double kRounding = 1.0 / 2048;

// Rounding both unit vectors moves their cross product by up to two roundings, t in units of alpha; where that matters
// most, D changes by the factor ((t + sqrt(t^2 + 4)) / 2)^4. Smoother surfaces than alpha 1 / sqrt(65504) are limited.
double factor_of_rounded_vectors() {
    const double t = 2 * kRounding * std::sqrt(kLargest);
    return std::pow((t + std::sqrt(t * t + 4)) / 2, 4);
}

TEST(HalfPrecision, TheMobileFormHasTheSmallerErrors) {
    const Errors naive = relative_errors("DistributionGGX", kNaive);
    const Errors unity = relative_errors("DistributionGGXUnity", kUnity);
    const Errors mobile = relative_errors("DistributionGGXMobile", kMobile);
    std::printf("rounded vectors alone: at most %.3g\n", factor_of_rounded_vectors() - 1);
    EXPECT_LT(mobile.most, naive.most);
    EXPECT_LT(mobile.of_999, naive.of_999);
    EXPECT_LT(mobile.most, unity.most);
    EXPECT_LT(mobile.of_999, unity.of_999);
    EXPECT_LT(mobile.most, factor_of_rounded_vectors() - 1);
    EXPECT_LT(mobile.of_999, 0.15);
}

// Every value lies between what the roundings of inputs and operations can make of it at most.
TEST(HalfPrecision, TheMobileFormKeepsItsBound) {
    const std::vector<double> half = values(kMobile, {.half = true});
    constexpr double tiny = 1.0 / (1 << 24);  // smallest half
    double widest = 0;
    for (std::size_t i = 0; i < kPoints; ++i) {
        const Point p = point(i);
        // Two roundings of inputs, two of products and their difference.
        const double off = 4 * kRounding, a = p.alpha, c = dot(p.n, p.h);
        const auto squares = [&](double sine, double cosine) {
            return std::pow(std::max(sine, 0.0), 2) + std::pow(std::max(cosine, 0.0) * a, 2);
        };
        const double q_low = squares(p.sine - off, c - off) * (1 - 6 * kRounding) - 4 * tiny;
        const double q_high = squares(p.sine + off, c + off) * (1 + 6 * kRounding) + 4 * tiny;
        const double p_low = a * (1 - 2 * kRounding) / q_high;
        const double p_high = q_low > 0 ? a * (1 + 2 * kRounding) / q_low : INFINITY;
        const double low = std::min(p_low * p_low, kLargest) / kPi * (1 - 4 * kRounding) - 2 * tiny;
        const double high = std::min(p_high * p_high, kLargest) / kPi * (1 + 4 * kRounding) + 2 * tiny;
        ASSERT_GE(half[i], low) << "alpha " << a << " sine " << p.sine;
        ASSERT_LE(half[i], high) << "alpha " << a << " sine " << p.sine;
        if (a > 0.1) widest = std::max(widest, high / low - 1);
    }
    // The bound says something: it is not wide where the surface is not smooth.
    EXPECT_LT(widest, 0.25);
}

// Two points whose errors were worked out apart from this project, for the plain and for the mobile form.
TEST(HalfPrecision, AtOneAndTwoDegrees) {
    struct Row {
        double alpha, degrees, naive, mobile;
    };
    for (const Row& row : {Row{0.04, 1, 0.416, 0.008}, Row{0.09, 2, 0.053, 0.002}}) {
        const double angle = row.degrees * kPi / 180;
        const auto error = [&](const char* call) {
            const std::string text = "float f(float3 n, float3 h, float a) { return " + std::string(call) + "; }";
            const std::vector<double> at = {0, 0, 1, std::sin(angle), 0, std::cos(angle), row.alpha};
            return std::abs(Term::of(text, {.half = true})(at) / Term::of(text)(at) - 1);
        };
        std::printf("alpha %g at %g degrees: plain %.4f, mobile %.4f\n", row.alpha, row.degrees, error(kNaive),
                    error(kMobile));
        EXPECT_NEAR(error(kNaive), row.naive, 0.01);
        EXPECT_LE(error(kMobile), row.mobile + 0.002);
    }
}

}  // namespace
}  // namespace patina::proof
