// Directional albedo: the share of the light from all around that a surface sends to one viewer. Of the GGX lobe with
// each visibility term, against tables computed elsewhere; of diffuse terms; and what is brighter than white.
#include <gtest/gtest.h>
#include <rapidjson/document.h>
#include <rapidjson/istreamwrapper.h>

#include <fstream>

#include "proof/hemisphere.h"
#include "proof/term.h"

namespace patina::proof {
namespace {

struct Visibility {
    const char* table;
    const char* call;
};
// The approximate term without the guard that Unity adds: the tables are of the formula.
constexpr Visibility kVisibilities[] = {
    {"smith-joint", "VisibilitySmithJoint(nl, nv, a)"},
    {"smith-joint-approximate", "VisibilitySmithJointApproximate(nl, nv, a, 0)"},
    {"smith-separable", "VisibilitySmithSeparable(nl, nv, a)"},
    {"schlick", "VisibilitySchlick(nl, nv, sqrt(a), Ambient)"},
};

Term ggx_lobe(const std::string& visibility) {
    return Term::of("float f(float nh, float nl, float nv, float a) { return DistributionGGX(nh, a) * " + visibility +
                    " * nl; }");
}

double albedo(Term& lobe, double ndotv, double alpha, Fineness fineness = kFine) {
    const std::vector<LightPoint> points = light_points(ndotv, alpha, fineness);
    double sum = 0;
    lobe.each(
        points.size(),
        [&](std::size_t i, double* in) {
            in[0] = points[i].ndoth;
            in[1] = points[i].ndotl;
            in[2] = ndotv;
            in[3] = alpha;
        },
        [&](std::size_t i, const double* out) { sum += out[0] * points[i].weight; });
    return sum;
}

std::vector<double> numbers(const rapidjson::Value& array) {
    std::vector<double> values;
    for (const rapidjson::Value& value : array.GetArray()) values.push_back(value.GetDouble());
    return values;
}

struct Tables {
    std::vector<double> ndotv, alpha;
    std::vector<std::vector<std::vector<double>>> albedo;  // by kVisibilities, alpha, ndotv
};

const Tables& tables() {
    static const Tables read = [] {
        std::ifstream file("tests/data/directional-albedo.json");
        rapidjson::IStreamWrapper stream(file);
        rapidjson::Document document;
        document.ParseStream(stream);
        Tables all{.ndotv = numbers(document["ndotv"]), .alpha = numbers(document["alpha"]), .albedo = {}};
        for (const Visibility& visibility : kVisibilities) {
            auto& table = all.albedo.emplace_back();
            for (const rapidjson::Value& row : document[visibility.table].GetArray()) table.push_back(numbers(row));
        }
        return all;
    }();
    return read;
}

TEST(Albedo, OfTheGgxLobeIsThatOfTheTables) {
    for (std::size_t k = 0; k < std::size(kVisibilities); ++k) {
        Term lobe = ggx_lobe(kVisibilities[k].call);
        double worst = 0, coarse = 0, largest = 0;
        for (std::size_t i = 0; i < tables().alpha.size(); ++i) {
            for (std::size_t j = 0; j < tables().ndotv.size(); ++j) {
                const double ndotv = tables().ndotv[j], alpha = tables().alpha[i];
                const double value = albedo(lobe, ndotv, alpha);
                EXPECT_NEAR(value, tables().albedo[k][i][j], 1e-4)
                    << kVisibilities[k].table << " alpha " << alpha << " n.v " << ndotv;
                worst = std::max(worst, std::abs(value - tables().albedo[k][i][j]));
                coarse = std::max(coarse, std::abs(value - albedo(lobe, ndotv, alpha, kCoarse)));
                largest = std::max(largest, value);
            }
        }
        std::printf("%-24s off the table by at most %.1e, largest albedo %.6f\n", kVisibilities[k].table, worst,
                    largest);
        // What the models are integrated with, at ten times the price of a term.
        std::printf("%-24s with few points: off by at most %.1e\n", kVisibilities[k].table, coarse);
        EXPECT_LE(coarse, 1e-3);
        EXPECT_LE(largest, 1 + 1e-6);
    }
}

// Each approximation takes light away, and none gives any.
TEST(Albedo, KeepsItsOrder) {
    std::vector<Term> lobes;
    for (const Visibility& visibility : kVisibilities) lobes.push_back(ggx_lobe(visibility.call));
    for (const double alpha : {0.01, 0.03, 0.1, 0.3, 0.7, 1.0}) {
        for (const double ndotv : {0.02, 0.07, 0.15, 0.4, 0.6, 0.8, 1.0}) {
            const double joint = albedo(lobes[0], ndotv, alpha), approximate = albedo(lobes[1], ndotv, alpha);
            const double separable = albedo(lobes[2], ndotv, alpha), schlick = albedo(lobes[3], ndotv, alpha);
            const auto where = testing::Message() << "alpha " << alpha << " n.v " << ndotv;
            EXPECT_LE(joint, 1 + 1e-6) << where;
            EXPECT_GE(joint, separable - 1e-9) << where;
            EXPECT_GE(separable, schlick - 1e-9) << where;
            EXPECT_GE(joint, approximate - 1e-9) << where;
            EXPECT_GE(approximate, schlick - 1e-9) << where;
            if (alpha == 1) {
                EXPECT_NEAR(joint, approximate, 1e-9) << where;
                EXPECT_NEAR(separable, schlick, 1e-9) << where;
            }
        }
    }
}

TEST(Albedo, OfTheRoughestSurfaceLookedAtStraightIsOneMinusLn2) {
    for (const Visibility& visibility : kVisibilities) {
        Term lobe = ggx_lobe(visibility.call);
        EXPECT_NEAR(albedo(lobe, 1, 1), 1 - std::numbers::ln2, 1e-9) << visibility.table;
    }
}

// Without shadowing, all that leaves a facet is seen: the visible facets fill the view (Heitz 2014, section 3.3).
TEST(Albedo, WeakWhiteFurnace) {
    Term visible = Term::of(
        "float f(float nh, float vh, float nv, float a) {"
        "  return SmithMasking(nv, a) * DistributionGGX(nh, a) * vh / nv; }");
    double worst = 0;
    for (const double alpha : {0.01, 0.05, 0.1, 0.3, 0.6, 1.0}) {
        for (const double ndotv : {0.01, 0.05, 0.2, 0.5, 0.8, 1.0}) {
            const Direction v = view_of(ndotv);
            const double tan_v = v[0] / ndotv;
            // v.h > 0 where cos(phi) > -cot(theta) / tan(theta_v): all around as long as theta < 90 deg - theta_v.
            const double first = std::log(alpha) - 12, whole = -std::log(std::max(tan_v, 1e-5));
            double sum = 0;
            const auto add = [&](const Rule& t) {
                for (std::size_t i = 0; i < t.size(); ++i) {
                    const double tangent = std::exp(t.points[i]), cosine = 1 / std::sqrt(1 + tangent * tangent);
                    const double cut = -1 / (tangent * std::max(tan_v, 1e-12));
                    const Rule phi = gauss_legendre(0, std::acos(std::clamp(cut, -1.0, 1.0)), 32);
                    visible.each(
                        phi.size(),
                        [&](std::size_t j, double* in) {
                            in[0] = cosine;
                            in[1] = dot(v, direction(cosine, phi.points[j]));
                            in[2] = ndotv;
                            in[3] = alpha;
                        },
                        [&](std::size_t j, const double* out) {
                            sum += 2 * out[0] * (1 - cosine * cosine) * cosine * phi.weights[j] * t.weights[i];
                        });
                }
            };
            add(composite(first, whole, 24, 8));
            add(root_ended(whole, whole + 18, 192));
            EXPECT_NEAR(sum, 1, 1e-5) << alpha << " " << ndotv;
            worst = std::max(worst, std::abs(sum - 1));
        }
    }
    std::printf("weak white furnace: off by at most %.1e\n", worst);
}

// --- diffuse terms, for a white surface

// 1 / pi times the integral of f(l) n.l; the function gets n.l, n.v, l.v and the roughness.
double diffuse_albedo(Term& term, double ndotv, double roughness) {
    const Rule cosine = gauss_legendre(0, 1, 24), angle = gauss_legendre(0, kPi, 24);
    const Direction v = view_of(ndotv);
    const auto light = [&](std::size_t i) {
        return direction(cosine.points[i / angle.size()], angle.points[i % angle.size()]);
    };
    double sum = 0;
    term.each(
        cosine.size() * angle.size(),
        [&](std::size_t i, double* in) {
            in[0] = light(i)[2];
            in[1] = ndotv;
            in[2] = dot(light(i), v);
            in[3] = roughness;
        },
        [&](std::size_t i, const double* out) {
            sum += out[0] * light(i)[2] * cosine.weights[i / angle.size()] * angle.weights[i % angle.size()];
        });
    return 2 * sum / kPi;
}

Term diffuse(const std::string& call) {
    return Term::of("float f(float nl, float nv, float lv, float r) { return " + call + "; }");
}

// Of the albedos over all views, weighted by their cosine: what the surface sends out of all that falls in.
double hemispherical_albedo(Term& term, double roughness) {
    const Rule view = gauss_legendre(0, 1, 24);
    double sum = 0;
    for (std::size_t i = 0; i < view.size(); ++i)
        sum += 2 * view.points[i] * view.weights[i] * diffuse_albedo(term, view.points[i], roughness);
    return sum;
}

TEST(Albedo, LambertIsWhiteAndHalfLambertBrighter) {
    Term lambert = diffuse("LambertDiffuse(nl) / max(nl, 1e-7)");
    EXPECT_NEAR(diffuse_albedo(lambert, 0.3, 0), 1, 1e-12);
    Term brdf = diffuse("PI * LambertBrdf(float3(1, 1, 1)).x");
    EXPECT_NEAR(diffuse_albedo(brdf, 0.3, 0), 1, 1e-12);
    // Half Lambert lights the far side as well: its integral is over the sphere, where Lambert's is 1.
    const Rule cosine = gauss_legendre(-1, 1, 16);
    for (const auto& [curve, expected] :
         {std::pair<std::string, double>{"Linear", 2}, std::pair<std::string, double>{"Squared", 4.0 / 3}}) {
        Term half = Term::of("float f(float nl) { return HalfLambert(nl, " + curve + "); }");
        double sum = 0;
        for (std::size_t i = 0; i < cosine.size(); ++i) sum += 2 * half({cosine.points[i]}) * cosine.weights[i];
        EXPECT_NEAR(sum, expected, 1e-12) << curve;
        std::printf("half Lambert, %-8s sends out %.6f of what falls on it\n", curve.c_str(), sum);
    }
}

// At n.v = 0 the view's factor is 0.5 + r + r x and the light's 1 + (r - 0.5 + r x) (1 - n.l)^5 with x = l.v, whose
// mean over the azimuth is 0 and whose mean square is (1 - (n.l)^2) / 2; what is left are beta functions.
double disney_grazing_albedo(double r) {
    const double b = r - 0.5;
    return (1 + b) * (1 + b / 21) + r * r * (1.0 / 42 - 1.0 / 504);
}

TEST(Albedo, DisneyDiffuseExceedsOne) {
    Term disney = diffuse("DisneyDiffuse(nv, nl, sqrt(max(0.5 + 0.5 * lv, 0)), r)");
    // Computed apart from this project, to the digits given.
    EXPECT_NEAR(diffuse_albedo(disney, 0.02, 0), 0.535, 5e-4);
    EXPECT_NEAR(diffuse_albedo(disney, 0.1, 1), 1.380, 5e-4);
    EXPECT_NEAR(diffuse_albedo(disney, 1, 1), 1.036, 5e-4);
    for (const auto& [roughness, mean] : {std::array{0.0, 0.953}, std::array{0.5, 1.008}, std::array{1.0, 1.065}}) {
        EXPECT_NEAR(diffuse_albedo(disney, 0, roughness), disney_grazing_albedo(roughness), 1e-12) << roughness;
        double most = 0, at = 0;
        for (int i = 0; i <= 100; ++i) {
            const double value = diffuse_albedo(disney, i / 100.0, roughness);
            if (value > most) at = i / 100.0;
            most = std::max(most, value);
        }
        const double whole = hemispherical_albedo(disney, roughness);
        std::printf("Disney diffuse, roughness %-4g albedo at most %.4f, at n.v = %g; over all views %.4f\n", roughness,
                    most, at, whole);
        EXPECT_NEAR(whole, mean, 5e-4) << roughness;
        if (roughness == 1) {
            EXPECT_NEAR(most, disney_grazing_albedo(1), 1e-12);
        }
    }
}

// Shown, and held to be what the formulas say where one can integrate them.
TEST(Albedo, OfTheOtherDiffuseTerms) {
    struct Row {
        const char *name, *call;
    };
    for (const Row& row : {Row{"Oren-Nayar qualitative", "OrenNayarDiffuse(nv, nl, lv, r, Qualitative)"},
                           Row{"Oren-Nayar improved", "OrenNayarDiffuse(nv, nl, lv, r, Improved)"},
                           Row{"Disney subsurface", "DisneySubsurface(nv, nl, sqrt(max(0.5 + 0.5 * lv, 0)), r)"}}) {
        Term term = diffuse(row.call);
        for (const double roughness : {0.0, 0.5, 1.0}) {
            double most = 0, least = INFINITY;
            for (int i = 1; i <= 50; ++i) {
                const double value = diffuse_albedo(term, i / 50.0, roughness);
                most = std::max(most, value);
                least = std::min(least, value);
            }
            std::printf("%-24s roughness %-4g albedo from %.4f to %.4f\n", row.name, roughness, least, most);
        }
    }
    // Oren and Nayar's surface is Lambert's when it is not rough.
    for (const char* form : {"Qualitative", "Improved"}) {
        Term smooth = diffuse("OrenNayarDiffuse(nv, nl, lv, r, " + std::string(form) + ")");
        for (const double ndotv : {0.05, 0.5, 1.0}) EXPECT_NEAR(diffuse_albedo(smooth, ndotv, 0), 1, 1e-9) << form;
    }
    // Looked at straight, l.v = n.l and s is 0: 1 - 0.5 r^2 / (r^2 + 0.33), and 1 / (1 + (1/2 - 2/(3 pi)) r).
    Term qualitative = diffuse("OrenNayarDiffuse(nv, nl, lv, r, Qualitative)");
    Term improved = diffuse("OrenNayarDiffuse(nv, nl, lv, r, Improved)");
    EXPECT_NEAR(diffuse_albedo(qualitative, 1, 0.5), 1 - 0.125 / 0.58, 1e-9);
    EXPECT_NEAR(diffuse_albedo(improved, 1, 0.5), 1 / (1 + 0.5 * (0.5 - 2 / (3 * kPi))), 1e-9);
}

// --- Unity's BRDF1, for one light of a white insulator: Disney's diffuse term plus a highlight

double brdf1_albedo(Term& lobe, double ndotv, double roughness) {
    const double alpha = std::max(roughness * roughness, 0.002);
    const std::vector<LightPoint> points = light_points(ndotv, alpha);
    double sum = 0;
    lobe.each(
        points.size(),
        [&](std::size_t i, double* in) {
            in[0] = points[i].ndotl;
            in[1] = ndotv;
            in[2] = points[i].ndoth;
            in[3] = points[i].ldoth;
            in[4] = roughness;
        },
        [&](std::size_t i, const double* out) { sum += out[0] * points[i].weight; });
    return sum / kPi;
}

TEST(Albedo, UnityBrdf1ExceedsOne) {
    Term lobe = Term::of(
        "float f(float nl, float nv, float nh, float lh, float r) {"
        "  float a = AlphaFromRoughness(r);"
        "  float specular = PI * DistributionGGXUnity(nh, a) * VisibilitySmithJointApproximate(nl, nv, a);"
        "  return (0.96 * DisneyDiffuse(nv, nl, lh, r) + specular * FresnelSchlick(0.04, lh).x) * nl; }");
    // Computed apart from this project, to the digits given.
    EXPECT_NEAR(brdf1_albedo(lobe, 0.05, 1), 1.470, 5e-4);
    EXPECT_NEAR(brdf1_albedo(lobe, 1, 1), 1.007, 5e-4);
    EXPECT_NEAR(brdf1_albedo(lobe, 0.05, 0.5), 1.147, 5e-4);
    EXPECT_NEAR(brdf1_albedo(lobe, 1, 0.5), 1.0015, 5e-5);
    EXPECT_NEAR(brdf1_albedo(lobe, 0.2, 0.25), 1.126, 5e-4);
    for (const double roughness : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        double most = 0, at = 0;
        for (const double ndotv : {0.005, 0.01, 0.02, 0.03, 0.05, 0.07, 0.1, 0.15, 0.2, 0.3, 0.5, 0.7, 1.0}) {
            const double value = brdf1_albedo(lobe, ndotv, roughness);
            if (value > most) at = ndotv;
            most = std::max(most, value);
        }
        std::printf("Unity BRDF1, white, roughness %-5g largest albedo %.4f at n.v = %g\n", roughness, most, at);
    }
}

}  // namespace
}  // namespace patina::proof
