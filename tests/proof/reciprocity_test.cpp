// Helmholtz's reciprocity: light and viewer may change places, f(l, v) = f(v, l). Held for the terms that promise it,
// measured for those that do not. And which terms only grow, only fall, or are symmetric.
#include <gtest/gtest.h>

#include "proof/quadrature.h"
#include "proof/term.h"

namespace patina::proof {
namespace {

struct Formula {
    const char *name, *call;
};

// The names that a row's expression may use; the normal is z.
Term over_directions(const char* call) {
    return Term::of(
        "float f(float3 l, float3 v, float r) {"
        "  float3 n = float3(0, 0, 1);"
        "  float3 h = HalfVectorExact(v, l);"
        "  float a = r * r;"
        "  float nl = NdotL(n, l);  float nv = NdotV(n, v);  float nh = NdotH(n, h);"
        "  float lh = LdotH(l, h);  float lv = dot(l, v);"
        "  return " +
        std::string(call) + "; }");
}

// The largest |f(l, v) - f(v, l)| / max(f(l, v), f(v, l)) of 20000 pairs spread over the hemisphere and over roughness.
// Rows that look at light from below get the view from the whole sphere.
double asymmetry(const char* call, bool view_from_below = false) {
    Term term = over_directions(call);
    constexpr std::size_t pairs = kSanitized ? 1000 : 20000;
    const Sequence points(5);
    double worst = 0, first = 0;
    term.each(
        2 * pairs,
        [&](std::size_t i, double* in) {
            const std::size_t pair = i / 2;
            const Direction l = on_hemisphere(points(pair, 0), points(pair, 1));
            const double u = points(pair, 2), w = points(pair, 3);
            const Direction v = view_from_below ? on_sphere(u, w) : on_hemisphere(u, w);
            std::copy(l.begin(), l.end(), in + (i % 2 == 0 ? 0 : 3));
            std::copy(v.begin(), v.end(), in + (i % 2 == 0 ? 3 : 0));
            in[6] = 0.1 + 0.9 * points(pair, 4);
        },
        [&](std::size_t i, const double* out) {
            if (i % 2 == 0) {
                first = out[0];
            } else if (first != out[0]) {
                // Written so that NaN counts.
                const double off = std::abs(first - out[0]) / std::max(std::abs(first), std::abs(out[0]));
                if (!(off <= worst)) worst = off;
            }
        });
    return worst;
}

constexpr Formula kVisibilities[] = {
    {"VisibilitySmithJoint", "VisibilitySmithJoint(nl, nv, a)"},
    {"VisibilitySmithJointApproximate", "VisibilitySmithJointApproximate(nl, nv, a)"},
    {"VisibilitySmithSeparable", "VisibilitySmithSeparable(nl, nv, a)"},
    {"VisibilitySchlick, Ambient", "VisibilitySchlick(nl, nv, r, Ambient)"},
    {"VisibilitySchlick, Direct", "VisibilitySchlick(nl, nv, r, Direct)"},
    {"VisibilitySchlick, Beckmann", "VisibilitySchlick(nl, nv, r, Beckmann)"},
    {"VisibilitySmithBeckmannUnity", "VisibilitySmithBeckmannUnity(nl, nv, a)"},
    {"VisibilitySmithBeckmann", "VisibilitySmithBeckmann(nl, nv, a)"},
    {"VisibilityImplicit", "VisibilityImplicit()"},
    {"VisibilityKelemen", "VisibilityKelemen(lh)"},
    {"VisibilityNeumann", "VisibilityNeumann(nl, nv)"},
    {"VisibilityNeubelt", "VisibilityNeubelt(nl, nv)"},
    {"VisibilitySmithAnisotropic", "VisibilitySmithAnisotropic(nl, l.x, l.y, nv, v.x, v.y, a, 0.3)"},
    {"SmithMaskingShadowing", "SmithMaskingShadowing(nl, nv, a)"},
    {"SmithMasking, of both", "SmithMasking(nl, a) * SmithMasking(nv, a)"},
    {"DisneyMasking, of both", "DisneyMasking(nl, r) * DisneyMasking(nv, r)"},
    {"MaskingCookTorrance", "MaskingCookTorrance(nl, nv, nh, lh)"},
    {"VisibilityFromMasking", "VisibilityFromMasking(MaskingCookTorrance(nl, nv, nh, lh), nl, nv)"},
};

constexpr Formula kLobes[] = {
    {"GGX, Smith joint, Schlick",
     "DistributionGGX(nh, a) * VisibilitySmithJoint(nl, nv, a) * FresnelSchlick(0.04, lh).x"},
    {"GGX as in Unity's BRDF1",
     "DistributionGGXUnity(nh, a) * VisibilitySmithJointApproximate(nl, nv, a) * FresnelSchlick(0.04, lh).x"},
    {"Beckmann, Smith, dielectric",
     "DistributionBeckmann(nh, a) * VisibilitySmithBeckmann(nl, nv, a) * FresnelDielectric(lh, 1.5)"},
    {"Blinn-Phong, V-cavity, conductor",
     "DistributionBlinnPhongRoughness(nh, a) * VisibilityFromMasking(MaskingCookTorrance(nl, nv, nh, lh), nl, nv) *"
     " FresnelConductor(lh).x"},
    {"GTR, Kelemen, Gaussian",
     "DistributionGTR(nh, a, 1.5) * VisibilityKelemen(lh) * FresnelSphericalGaussian(0.04, lh).x"},
    {"anisotropic GGX",
     "DistributionGGXAnisotropic(nh, h.x, h.y, a, 0.3) *"
     " VisibilitySmithAnisotropic(nl, l.x, l.y, nv, v.x, v.y, a, 0.3)"},
    {"mobile GGX, separable Smith", "DistributionGGXMobile(n, h, a) * VisibilitySmithSeparable(nl, nv, a)"},
    {"PhongHighlight", "PhongHighlight(n, l, v, 20)"},
    {"BlinnPhongHighlight, Normalized", "BlinnPhongHighlight(n, l, v, 20, Normalized)"},
    {"MinimalistHighlight", "MinimalistHighlight(n, l, v, 1 - r)"},
    {"PhongHighlightUnity", "PhongHighlightUnity(RdotV(n, l, v), 1 - r)"},
    {"Disney's clear coat",
     "DistributionGTR1(nh, 0.1) * SmithVisibilityFactor(nl, 0.25) * SmithVisibilityFactor(nv, 0.25) *"
     " FresnelSchlick(0.04, lh).x"},
};

constexpr Formula kDiffuse[] = {
    {"LambertBrdf", "LambertBrdf(float3(0.5, 0.5, 0.5)).x"},
    {"DisneyDiffuse", "DisneyDiffuse(nv, nl, lh, r)"},
    {"DisneySubsurface", "DisneySubsurface(nv, nl, lh, r)"},
    {"OrenNayarDiffuse, Qualitative", "OrenNayarDiffuse(nv, nl, lv, r, Qualitative)"},
    {"OrenNayarDiffuse, Improved", "OrenNayarDiffuse(nv, nl, lv, r, Improved)"},
    {"Lambert times 1 - F(l.h)", "1 - FresnelSchlick(0.04, lh).x"},
};

class Reciprocal : public testing::TestWithParam<Formula> {};
TEST_P(Reciprocal, LightAndViewerMayChangePlaces) {
    const double worst = asymmetry(GetParam().call);
    std::printf("%-36s differs by at most %.1e\n", GetParam().name, worst);
    EXPECT_LE(worst, 1e-6);
}
INSTANTIATE_TEST_SUITE_P(Visibility, Reciprocal, testing::ValuesIn(kVisibilities));
INSTANTIATE_TEST_SUITE_P(Lobe, Reciprocal, testing::ValuesIn(kLobes));
INSTANTIATE_TEST_SUITE_P(Diffuse, Reciprocal, testing::ValuesIn(kDiffuse));

// What depends on one of the two directions alone. `below`: only where the normal looks away from the viewer.
struct OneSided {
    Formula row;
    bool below = false;
};
constexpr OneSided kOneSided[] = {
    {{"Phong's lobe over n.l", "PhongHighlight(n, l, v, 20) / max(nl, 1e-4)"}},
    {{"Blinn-Phong's lobe over n.l", "BlinnPhongHighlight(n, l, v, 20) / max(nl, 1e-4)"}},
    {{"HalfLambert over n.l", "HalfLambert(nl, Squared) / max(nl, 1e-4)"}},
    {{"Lambert times 1 - F(n.v)", "1 - FresnelSchlick(0.04, nv).x"}},
    {{"FresnelLerp of n.v", "FresnelLerp(0.04, 1, nv).x"}},
    {{"FresnelSchlickRoughness of n.v", "FresnelSchlickRoughness(0.04, nv, r).x"}},
    {{"EnvBRDFApprox", "EnvBRDFApprox(r, nv).scale"}},
    {{"EnvBRDFLazarov", "EnvBRDFLazarov(1 - r, nv).offset + 1"}},
    {{"SpecularOcclusion", "SpecularOcclusion(nv, 0.5, r)"}},
    {{"GGX with the absolute n.v", "DistributionGGX(nh, a) * VisibilitySmithJoint(nl, NdotV(n, v, Absolute), a)"},
     true},
    {{"GGX with the shifted n.v", "DistributionGGX(nh, a) * VisibilitySmithJoint(nl, NdotVShifted(n, v), a)"}, true},
};

class NotReciprocal : public testing::TestWithParam<OneSided> {};
TEST_P(NotReciprocal, ByThisMuch) {
    const double worst = asymmetry(GetParam().row.call, GetParam().below);
    std::printf("%-36s differs by up to %.3f\n", GetParam().row.name, worst);
    EXPECT_GE(worst, 0.01);
}
INSTANTIATE_TEST_SUITE_P(OneSided, NotReciprocal, testing::ValuesIn(kOneSided));

// With the absolute or the shifted cosine a lobe is reciprocal as long as both stand above the surface.
TEST(Reciprocity, ShiftedAndAbsoluteCosinesAreClampedOnesAbove) {
    EXPECT_LE(asymmetry(kOneSided[9].row.call), 1e-6);
    EXPECT_LE(asymmetry(kOneSided[10].row.call), 1e-6);
}

// --- the same from every side

// An isotropic BRDF does not see a turn about the normal; an anisotropic one with equal roughnesses is isotropic.
TEST(Symmetry, ATurnAboutTheNormalChangesNothing) {
    Term turned = Term::of(
        "float3 f(float3 l, float3 v, float a, float turn) {"
        "  float3x3 m = float3x3(cos(turn), sin(turn), 0, -sin(turn), cos(turn), 0, 0, 0, 1);"
        "  float3 h = HalfVectorExact(v, l);"
        "  float3 h2 = HalfVectorExact(mul(m, v), mul(m, l));"
        "  float one = DistributionGGX(h.z, a) * VisibilitySmithJoint(l.z, v.z, a);"
        "  float two = DistributionGGX(h2.z, a) * VisibilitySmithJoint(l.z, v.z, a);"
        "  float three = DistributionGGXAnisotropic(h2.z, h2.x, h2.y, a, a) *"
        "    VisibilitySmithAnisotropic(l.z, mul(m, l).x, mul(m, l).y, v.z, mul(m, v).x, mul(m, v).y, a, a);"
        "  return float3(one, two, three); }");
    const Sequence points(6);
    double worst = 0;
    turned.each(
        5000,
        [&](std::size_t i, double* in) {
            const Direction l = on_hemisphere(points(i, 0), points(i, 1));
            const Direction v = on_hemisphere(points(i, 2), points(i, 3));
            std::copy(l.begin(), l.end(), in);
            std::copy(v.begin(), v.end(), in + 3);
            in[6] = 0.02 + 0.98 * points(i, 4);
            in[7] = 2 * kPi * points(i, 5);
        },
        [&](std::size_t, const double* out) {
            worst = std::max({worst, std::abs(out[1] / out[0] - 1), std::abs(out[2] / out[0] - 1)});
        });
    std::printf("turned about the normal, and isotropic: differs by at most %.1e\n", worst);
    EXPECT_LE(worst, 1e-6);
}

// --- monotony

// The largest step against the direction that `sign` says (1: rises), over the whole range of x.
double step_back(const std::string& call, double from, double to, double sign) {
    Term term = Term::of("float f(float x) { return " + call + "; }");
    double before = -INFINITY, worst = 0;
    term.each(
        2001, [&](std::size_t i, double* in) { in[0] = from + (to - from) * static_cast<double>(i) / 2000; },
        [&](std::size_t i, const double* out) {
            if (i > 0) worst = std::max(worst, before - sign * out[0]);
            before = sign * out[0];
        });
    return worst;
}

TEST(Monotony, FresnelTermsRiseTowardsGrazing) {
    for (const char* call :
         {"SchlickWeight(x)", "FresnelSchlick(0.04, x).x", "FresnelLerp(0.04, 0.7, x).x",
          "FresnelLerpFast(0.04, 0.7, x).x", "FresnelSchlickRoughness(0.04, x, 0.3).x",
          "FresnelSphericalGaussian(0.04, x).x", "FresnelDielectric(x, 1.5)", "FresnelDielectric(x, 1 / 1.5)"})
        EXPECT_LE(step_back(call, 0, 1, -1), 1e-12) << call;
    // A metal's reflectance dips before it rises, here aluminium's: Schlick's never does.
    Term aluminium = Term::of("float f(float x) { return FresnelConductor(x, 1.09, 6.8).x; }");
    EXPECT_LT(aluminium({0.16}), aluminium({1}) - 0.03);
    EXPECT_NEAR(aluminium({0}), 1, 1e-12);
}

TEST(Monotony, OfWhatFollowsFromRoughness) {
    for (const char* call : {"MipFromRoughness(x)", "AlphaFromRoughness(x, 0)", "RoughnessFromAlpha(x)"})
        EXPECT_LE(step_back(call, 0, 1, 1), 1e-12) << call;
    for (const char* call : {"SurfaceReduction(x)", "SurfaceReduction(x, Gamma)", "SurfaceReduction(x, SimpleLinear)",
                             "SpecPowerFromRoughness(x)", "GrazingTerm(1 - x, 0.96)", "EnvBRDFApprox(x, 0.5).scale"})
        EXPECT_LE(step_back(call, 0, 1, -1), 1e-12) << call;
}

TEST(Monotony, MaskingFallsTowardsGrazing) {
    for (const char* call : {"SmithMasking(x, 0.3)", "DisneyMasking(x, 0.3)", "SmithMaskingShadowing(x, 0.5, 0.3)"})
        EXPECT_LE(step_back(call, 0, 1, 1), 1e-12) << call;
    EXPECT_LE(step_back("SmithLambda(x, 0.3)", 0.001, 1, -1), 1e-12);
}

TEST(Monotony, LightFallsWithDistance) {
    for (const char* call : {"InverseSquareAttenuation(x, 4)", "RangeAttenuation(x, 4)", "UnityAttenuation(x / 4)",
                             "VertexLightAttenuation(x * x, 25.0 / 16)"})
        EXPECT_LE(step_back(call, 0, 5, -1), 1e-12) << call;
}

}  // namespace
}  // namespace patina::proof
