// Normal distributions: the integral of D (n.h) over the hemisphere is 1; those that are not normalised miss it by what
// their closed form says. And which of them keep their shape when the surface is stretched.
#include <gtest/gtest.h>

#include <functional>

#include "proof/quadrature.h"
#include "proof/term.h"

namespace patina::proof {
namespace {

constexpr std::array kAlphas = {0.01, 0.02, 0.03, 0.05, 0.08, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0};

// What stands before the parameters of a distribution: the cosine n.h, then its own.
std::string ndf(const std::string& parameters, const std::string& call) {
    return "float f(float ndoth" + parameters + ") { return " + call + "; }";
}

// 2 pi times the integral of D cos sin over the angle, with y = ln(tan(angle) / width) for the angle: however narrow
// the peak, it is as wide as 1 in y, both ends fall off exponentially, and the trapezoid rule then converges faster
// than any power of its step.
double projected_integral(Term& distribution, const std::vector<double>& parameters, double width) {
    constexpr double step = 0.05;
    const double begin = -12, end = 12 - std::log(width);
    const auto count = static_cast<std::size_t>((end - begin) / step);
    const auto tangent2 = [&](std::size_t i) {
        return width * width * std::exp(2 * (begin + step * static_cast<double>(i)));
    };
    double sum = 0;
    distribution.each(
        count,
        [&](std::size_t i, double* in) {
            in[0] = 1 / std::sqrt(1 + tangent2(i));
            std::copy(parameters.begin(), parameters.end(), in + 1);
        },
        [&](std::size_t i, const double* out) {
            const double t2 = tangent2(i);
            sum += out[0] * t2 / ((1 + t2) * (1 + t2));
        });
    return 2 * kPi * sum * step;
}

struct Normalised {
    const char* name;
    std::string function;
    std::vector<double> further;  // parameters after alpha
};

TEST(Ndf, IntegratesToOne) {
    std::vector<Normalised> all = {
        {"DistributionGGX", ndf(", float a", "DistributionGGX(ndoth, a)"), {}},
        {"DistributionBeckmann", ndf(", float a", "DistributionBeckmann(ndoth, a)"), {}},
        {"DistributionBlinnPhongRoughness", ndf(", float a", "DistributionBlinnPhongRoughness(ndoth, a)"), {}},
        {"DistributionGTR1", ndf(", float a", "DistributionGTR1(ndoth, a)"), {}},
        {"DistributionGGXMobile",
         ndf(", float a",
             "DistributionGGXMobile(float3(0, 0, 1), float3(sqrt(max(1 - ndoth * ndoth, 0)), 0, ndoth), a)"),
         {}},
    };
    for (const double gamma : {0.5, 1.0, 1.5, 2.0, 3.0, 10.0})
        all.push_back({"DistributionGTR", ndf(", float a, float g", "DistributionGTR(ndoth, a, g)"), {gamma}});
    for (const Normalised& row : all) {
        Term distribution = Term::of(row.function);
        double worst = 0;
        for (const double alpha : kAlphas) {
            std::vector<double> parameters = {alpha};
            parameters.insert(parameters.end(), row.further.begin(), row.further.end());
            const double off = std::abs(projected_integral(distribution, parameters, alpha) - 1);
            EXPECT_LE(off, 1e-4) << row.name << " at alpha " << alpha;
            worst = std::max(worst, off);
        }
        std::printf("%-32s %-6s integral 1, off by at most %.1e\n", row.name,
                    row.further.empty() ? "" : testing::PrintToString(row.further[0]).c_str(), worst);
    }
}

TEST(Ndf, BlinnPhongIntegratesToOneForEveryExponent) {
    Term distribution = Term::of(ndf(", float e", "DistributionBlinnPhong(ndoth, e)"));
    for (const double exponent : {0.0, 0.0001, 1.0, 8.0, 100.0, 2000.0, 19998.0})
        EXPECT_NEAR(projected_integral(distribution, {exponent}, std::sqrt(2 / (exponent + 2))), 1, 1e-4) << exponent;
}

// Over slopes (x, y) = (tx / tz, ty / tz): D cos^4 is their density, and stretching makes it a round one.
TEST(Ndf, AnisotropicGgxIntegratesToOne) {
    Term distribution = Term::of(
        "float f(float x, float y, float at, float ab) {"
        "  float c = rsqrt(1 + x * x + y * y);"
        "  return DistributionGGXAnisotropic(c, x * c, y * c, at, ab) * c * c * c * c; }");
    const Rule angle = gauss_legendre(0, kPi / 2, 64), radius = composite(-12, 12, 48, 8);
    double worst = 0;
    for (const auto& [at, ab] : {std::array{0.01, 0.01}, std::array{0.01, 1.0}, std::array{0.05, 0.3},
                                 std::array{0.2, 0.5}, std::array{1.0, 1.0}, std::array{0.9, 0.02}}) {
        double sum = 0;
        const std::size_t count = angle.size() * radius.size();
        distribution.each(
            count,
            [&, at = at, ab = ab](std::size_t i, double* in) {
                const double r = std::exp(radius.points[i / angle.size()]), phi = angle.points[i % angle.size()];
                in[0] = at * r * std::cos(phi);
                in[1] = ab * r * std::sin(phi);
                in[2] = at;
                in[3] = ab;
            },
            [&, at = at, ab = ab](std::size_t i, const double* out) {
                const double r = std::exp(radius.points[i / angle.size()]);
                sum +=
                    out[0] * 4 * at * ab * r * r * radius.weights[i / angle.size()] * angle.weights[i % angle.size()];
            });
        EXPECT_NEAR(sum, 1, 1e-4) << at << " " << ab;
        worst = std::max(worst, std::abs(sum - 1));
    }
    std::printf("DistributionGGXAnisotropic: integral 1, off by at most %.1e\n", worst);
}

// --- those that are not normalised

// With u = cos^2 and x = 1 - (1 - a^2) u, the integral of a^2 / (x^2 + 1e-7) is an arc tangent.
double unity_integral(double alpha) {
    const double a2 = alpha * alpha, root = std::sqrt(1e-7);
    if (alpha == 1) return 1 / (1 + 1e-7);
    return a2 / ((1 - a2) * root) * (std::atan(1 / root) - std::atan(a2 / root));
}

TEST(Ndf, UnitysGuardLosesSmoothHighlights) {
    Term distribution = Term::of(ndf(", float a", "DistributionGGXUnity(ndoth, a)"));
    // Computed apart from this project, to the digits given.
    const std::vector<std::array<double, 3>> table = {
        {0.002, 0.0197, 5e-5}, {0.01, 0.3998, 5e-5}, {0.05, 0.9947, 5e-5}, {0.1, 0.99966, 5e-6}, {0.25, 0.99999, 5e-6}};
    for (const auto& [alpha, figure, digits] : table) {
        const double integral = projected_integral(distribution, {alpha}, alpha);
        std::printf("DistributionGGXUnity             alpha %-5g integral %.6f\n", alpha, integral);
        EXPECT_NEAR(integral, figure, digits) << alpha;
        EXPECT_NEAR(integral, unity_integral(alpha), 1e-7) << alpha;
    }
}

// The same with 1e-5 beside x, which is squared afterwards.
TEST(Ndf, TheMinimalistGuardLosesSmoothHighlights) {
    Term distribution = Term::of(ndf(", float a", "DistributionGGXMinimalist(ndoth, a)"));
    for (const double alpha : {0.002, 0.01, 0.05, 0.1, 0.25}) {
        const double a2 = alpha * alpha, guard = 1e-5;
        const double closed = a2 / (1 - a2) * (1 / (a2 + guard) - 1 / (1 + guard));
        const double integral = projected_integral(distribution, {alpha}, alpha);
        std::printf("DistributionGGXMinimalist        alpha %-5g integral %.6f\n", alpha, integral);
        EXPECT_NEAR(integral, closed, 1e-7) << alpha;
    }
}

// The largest half, 65504, is p^2: where p = alpha / x is larger, with x as above, there is a plateau.
double mobile_integral(double alpha) {
    const double a2 = alpha * alpha, edge = alpha / 255.937;
    if (edge <= a2) return 1;
    return (65504 * (edge - a2) + a2 * (1 / edge - 1)) / (1 - a2);
}

TEST(Ndf, MobileGgxWithoutItsPiIntegratesToPi) {
    Term distribution = Term::of(
        ndf(", float a",
            "PI * DistributionGGXMobile(float3(0, 0, 1), float3(sqrt(max(1 - ndoth * ndoth, 0)), 0, ndoth), a)"));
    for (const double alpha : {0.002, 0.003, 0.004, 0.01, 0.1, 1.0}) {
        const double integral = projected_integral(distribution, {alpha}, alpha);
        std::printf("pi DistributionGGXMobile         alpha %-5g integral %.5f pi\n", alpha, integral / kPi);
        // The edge of the plateau is a kink, which slows the rule down.
        EXPECT_NEAR(integral, kPi * mobile_integral(alpha), alpha < 0.004 ? 5e-4 : 1e-6) << alpha;
    }
    EXPECT_NEAR(projected_integral(distribution, {0.002}, 0.002) / kPi, 0.7617, 1e-4);
}

TEST(Ndf, AClassicBlinnPhongPowerMissesOne) {
    Term power = Term::of(ndf(", float e", "pow(ndoth, e)"));
    for (const double exponent : {1.0, 8.0, 32.0, 256.0}) {
        const double integral = projected_integral(power, {exponent}, std::sqrt(2 / (exponent + 2)));
        EXPECT_NEAR(integral, 2 * kPi / (exponent + 2), 1e-9) << exponent;
        EXPECT_GT(std::abs(integral - 1), 0.3) << exponent;
    }
}

// The whole light of a classic lobe, looked at along the normal, for a light of 1 from all around.
double lobe_integral(Term& lobe, double exponent) {
    // In x = (1 - cos)^(1/2) the lobe is smooth and the peak wide.
    const Rule rule = composite(0, 1, 64, 8);
    double sum = 0;
    lobe.each(
        rule.size(),
        [&](std::size_t i, double* in) {
            const Direction l = direction(1 - rule.points[i] * rule.points[i], 0.7);
            std::copy(l.begin(), l.end(), in);
            in[3] = exponent;
        },
        [&](std::size_t i, const double* out) { sum += out[0] * 2 * rule.points[i] * rule.weights[i]; });
    return 2 * kPi * sum;
}

TEST(Ndf, ClassicLobesLookedAtStraight) {
    const auto lobe = [](const std::string& call) {
        return Term::of("float f(float3 l, float e) { float3 n = float3(0, 0, 1); return " + call +
                        " * NdotL(n, l); }");
    };
    Term phong = lobe("PhongHighlight(n, l, n, e)"), blinn = lobe("BlinnPhongHighlight(n, l, n, e)");
    Term whole_phong = lobe("PhongHighlight(n, l, n, e, Normalized)");
    Term whole_blinn = lobe("BlinnPhongHighlight(n, l, n, e, Normalized)");
    for (const double e : {1.0, 8.0, 32.0, 256.0, 2000.0}) {
        const double closed = 8 * kPi * (std::exp2(-e / 2) + e) / ((e + 2) * (e + 4));
        EXPECT_NEAR(lobe_integral(phong, e), 2 * kPi / (e + 2), 1e-9) << e;
        EXPECT_NEAR(lobe_integral(blinn, e), closed, 1e-9) << e;
        // In units of E / pi a normalised lobe sends back just what falls in.
        EXPECT_NEAR(lobe_integral(whole_phong, e), kPi, 1e-6) << e;
        EXPECT_NEAR(lobe_integral(whole_blinn, e), kPi, 1e-6) << e;
        std::printf("exponent %-5g Phong's lobe %.6f, Blinn-Phong's %.6f; its usual norm (e + 8) / (8 pi) gives %.4f\n",
                    e, 2 * kPi / (e + 2), closed, closed * (e + 8) / (8 * kPi));
    }
}

// --- shape invariance (Heitz, JCGT 3(2), 2014, section 5.1)

// Stretching a surface by 1 / s divides its slopes by s: the density of slopes D cos^4, times the area s^2, stays. So a
// distribution of shape g keeps alpha^2 D cos^4 = g(tan / alpha) for every alpha. Gives the largest difference between
// roughnesses, relative to the larger value.
double shape_difference(const std::string& call) {
    Term density = Term::of(
        "float f(float x, float a) {"
        "  float c = rsqrt(1 + x * x * a * a);"
        "  return " +
        call + " * a * a * c * c * c * c; }");
    double worst = 0;
    for (double x = 0; x <= 3; x += 0.125) {
        double least = INFINITY, most = 0;
        for (const double alpha : {0.05, 0.1, 0.2, 0.4, 0.8}) {
            const double value = density({x, alpha});
            least = std::min(least, value);
            most = std::max(most, value);
        }
        worst = std::max(worst, (most - least) / most);
    }
    return worst;
}

TEST(Ndf, GgxAndBeckmannKeepTheirShape) {
    for (const char* call : {"DistributionGGX(c, a)", "DistributionBeckmann(c, a)", "DistributionGTR(c, a, 2)"}) {
        const double difference = shape_difference(call);
        std::printf("%-40s shape differs by %.1e\n", call, difference);
        EXPECT_LE(difference, 1e-9) << call;
    }
}

TEST(Ndf, BlinnPhongAndOtherGtrDoNot) {
    for (const char* call : {"DistributionBlinnPhongRoughness(c, a)", "DistributionGTR1(c, a)",
                             "DistributionGTR(c, a, 1.5)", "DistributionGTR(c, a, 3)"}) {
        const double difference = shape_difference(call);
        std::printf("%-40s shape differs by %.2f\n", call, difference);
        EXPECT_GE(difference, 0.1) << call;
    }
}

// The same along one direction: anisotropic GGX is the isotropic one of a stretched half vector.
TEST(Ndf, AnisotropicGgxIsGgxStretched) {
    Term both = Term::of(
        "float2 f(float x, float y, float at, float ab) {"
        "  float c = rsqrt(1 + x * x + y * y);"
        "  float stretched = rsqrt(1 + x / at * x / at + y / ab * y / ab);"
        "  float whole = DistributionGGXAnisotropic(c, x * c, y * c, at, ab) * c * c * c * c;"
        "  float round = DistributionGGX(stretched, 1) * pow(stretched, 4) / (at * ab);"
        "  return float2(whole, round); }");
    const Sequence points(4);
    double worst = 0;
    both.each(
        2000,
        [&](std::size_t i, double* in) {
            in[2] = 0.02 + 0.98 * points(i, 2);
            in[3] = 0.02 + 0.98 * points(i, 3);
            in[0] = 4 * in[2] * (points(i, 0) - 0.5);
            in[1] = 4 * in[3] * (points(i, 1) - 0.5);
        },
        [&](std::size_t, const double* out) { worst = std::max(worst, std::abs(out[0] / out[1] - 1)); });
    std::printf("anisotropic GGX and stretched GGX differ by at most %.1e\n", worst);
    EXPECT_LE(worst, 1e-9);
}

// --- monotony

// Facets are rarer the further they lean; Beckmann's density of directions (not of slopes) only up to alpha 0.7071:
// above, its derivative at the pole is positive.
TEST(Ndf, FallsWithTheAngle) {
    const auto rises = [](Term& distribution, std::vector<double> parameters) {
        double before = INFINITY, largest = 0;
        distribution.each(
            1001,
            [&](std::size_t i, double* in) {
                in[0] = std::cos(kPi / 2 * static_cast<double>(i) / 1000);
                std::copy(parameters.begin(), parameters.end(), in + 1);
            },
            [&](std::size_t, const double* out) {
                largest = std::max(largest, (out[0] - before) / std::max(before, 1e-300));
                before = out[0];
            });
        return largest > 1e-12;
    };
    Term ggx = Term::of(ndf(", float a", "DistributionGGX(ndoth, a)"));
    Term blinn = Term::of(ndf(", float a", "DistributionBlinnPhongRoughness(ndoth, a)"));
    Term gtr = Term::of(ndf(", float a, float g", "DistributionGTR(ndoth, a, g)"));
    Term beckmann = Term::of(ndf(", float a", "DistributionBeckmann(ndoth, a)"));
    for (const double alpha : kAlphas) {
        EXPECT_FALSE(rises(ggx, {alpha})) << alpha;
        EXPECT_FALSE(rises(blinn, {alpha})) << alpha;
        for (const double gamma : {0.5, 1.0, 3.0}) EXPECT_FALSE(rises(gtr, {alpha, gamma})) << alpha << " " << gamma;
    }
    for (const double alpha : {0.01, 0.1, 0.3, 0.5, 0.7, 0.707}) EXPECT_FALSE(rises(beckmann, {alpha})) << alpha;
    for (const double alpha : {0.71, 0.8, 1.0}) EXPECT_TRUE(rises(beckmann, {alpha})) << alpha;
}

}  // namespace
}  // namespace patina::proof
