// The lighting models that are no full microfacet models, as graphs, against the same formulas written once as plain
// C++: half-lambert, phong, blinn-phong, unity-brdf2 and -3, cl-pbr-specular, pbr-direct-indirect. Units are those of
// the graphs: light is E/pi, so that a light of 1 on a white Lambert surface gives n.l.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "runtime/model.h"

namespace patina::runtime {
namespace {

constexpr double kPi = 3.14159265358979323846;

double dot(const Triple& a, const Triple& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
double clamped(double x) {
    return std::min(std::max(x, 0.0), 1.0);
}
Triple operator+(const Triple& a, const Triple& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Triple operator*(const Triple& a, double s) {
    return {a[0] * s, a[1] * s, a[2] * s};
}
Triple unit(const Triple& a) {
    return a * (1 / std::sqrt(dot(a, a)));
}

// The cosines of one light and one view, about the normal (0, 0, 1).
struct Cosines {
    Triple l, v;
    double nl, nv, nh, lh, rv;  // clamped
    double signed_nl;
};
Cosines cosines(const Triple& l, const Triple& v) {
    const Triple h = unit(l + v);
    const Triple r = {-l[0], -l[1], l[2]};
    return {.l = l,
            .v = v,
            .nl = clamped(l[2]),
            .nv = clamped(v[2]),
            .nh = clamped(h[2]),
            .lh = clamped(dot(l, h)),
            .rv = clamped(dot(r, v)),
            .signed_nl = l[2]};
}

// Views in front of the surface; lights mostly in front, and some behind.
std::vector<Cosines> directions() {
    std::mt19937 dice(7);
    const auto number = [&](double low, double high) { return low + (high - low) * (dice() / 4294967296.0); };
    const auto direction = [&](double z) {
        const double angle = number(0, 2 * kPi), s = std::sqrt(1 - z * z);
        return Triple{s * std::cos(angle), s * std::sin(angle), z};
    };
    std::vector<Cosines> made;
    for (int i = 0; i < 60; ++i) made.push_back(cosines(direction(number(-0.3, 1)), direction(number(0.05, 1))));
    return made;
}

// A surface as the metallic/roughness workflow makes it.
struct Surface {
    Triple base{0.8, 0.4, 0.1};
    double metallic = 0, roughness = 0.5;

    Triple diffuse() const { return base * (0.96 * (1 - metallic)); }
    Triple f0() const { return base * metallic + Triple{0.04, 0.04, 0.04} * (1 - metallic); }
    double reflectivity() const { return 0.04 + 0.96 * metallic; }
};
const Surface kSurfaces[] = {{}, {.metallic = 1, .roughness = 0.3}, {.metallic = 0.4, .roughness = 0.9}};

const Compiler& compiler() {
    static const Compiler kCompiler;
    return kCompiler;
}

std::string text(double x) {
    return std::to_string(x);
}

Model model_of(const std::string& name, const Surface& s,
               const std::vector<std::pair<std::string, std::string>>& more = {}) {
    ModelChoice choice{.model = name,
                       .values = {{"baseColor", text(s.base[0]) + "," + text(s.base[1]) + "," + text(s.base[2])},
                                  {"metallic", text(s.metallic)},
                                  {"roughness", text(s.roughness)}}};
    choice.values.insert(choice.values.end(), more.begin(), more.end());
    Model model(compiler(), choice);
    for (const Diagnostic& d : model.diagnostics()) ADD_FAILURE() << to_text(d);
    return model;
}

void expect_near(const Triple& got, const Triple& expected, const char* what) {
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(got[i], expected[i], 1e-12 + 1e-9 * std::abs(expected[i])) << what << " channel " << i;
}

TEST(SimpleModels, HalfLambert) {
    const Surface s;
    Model squared = model_of("half-lambert", s), linear = model_of("half-lambert", s, {{"_Curve", "Linear"}});
    for (const Cosines& c : directions()) {
        const double wrapped = 0.5 * c.signed_nl + 0.5;
        expect_near(squared.direct({.l = c.l, .v = c.v}), s.diffuse() * (wrapped * wrapped), "squared");
        expect_near(linear.direct({.l = c.l, .v = c.v}), s.diffuse() * wrapped, "linear");
    }
}

// Phong 1975; Blinn 1977. No light, no highlight.
TEST(SimpleModels, ClassicHighlights) {
    const Surface s;
    const Triple specular = {0.9, 0.6, 0.3};
    const std::vector<std::pair<std::string, std::string>> classic = {
        {"_Normalization", "Classic"}, {"specularColor", "0.9,0.6,0.3"}, {"exponent", "20"}};
    Model phong = model_of("phong", s, classic), blinn = model_of("blinn-phong", s, classic);
    for (const Cosines& c : directions()) {
        const double lit = c.signed_nl > 0 ? 1 : 0;
        const Triple diffuse = s.diffuse() * c.nl;
        expect_near(phong.direct({.l = c.l, .v = c.v}), diffuse + specular * (lit * std::pow(c.rv, 20)), "phong");
        expect_near(blinn.direct({.l = c.l, .v = c.v}), diffuse + specular * (lit * std::pow(c.nh, 20)), "blinn");
    }
}

// Blinn-Phong's D = (e + 2) / (2 pi) (n.h)^e with V = 1/4; Phong's lobe is (e' + 2) / (2 pi) (r.v)^e', e' = e / 4. Each
// times pi.
TEST(SimpleModels, NormalizedHighlights) {
    for (const Surface& s : kSurfaces) {
        Model phong = model_of("phong", s), blinn = model_of("blinn-phong", s);
        const double e = 2 / std::pow(s.roughness, 4) - 2;
        for (const Cosines& c : directions()) {
            const Triple diffuse = s.diffuse() * c.nl;
            const double of_h = (e + 2) / 8 * std::pow(c.nh, e) * c.nl;
            const double of_r = (e / 4 + 2) / 2 * std::pow(c.rv, e / 4) * c.nl;
            expect_near(blinn.direct({.l = c.l, .v = c.v}), diffuse + s.f0() * of_h, "blinn");
            expect_near(phong.direct({.l = c.l, .v = c.v}), diffuse + s.f0() * of_r, "phong");
        }
    }
}

// What Unity's second and third model make of the surroundings but for their factor of roughness.
Triple mirrored(const Surface& s, const Cosines& c, const Triple& environment) {
    const double f90 = clamped(1 - s.roughness + s.reflectivity()), weight = std::pow(1 - c.nv, 4);
    Triple sum{};
    for (std::size_t i = 0; i < 3; ++i) sum[i] = (s.f0()[i] + (f90 - s.f0()[i]) * weight) * environment[i];
    return sum;
}

TEST(SimpleModels, UnityBrdf2) {
    const ModelLight light{.light = {1, 1, 1}, .ambient = {0.2, 0.2, 0.2}, .environment = {0.5, 0.4, 0.3}};
    for (const Surface& s : kSurfaces) {
        Model model = model_of("unity-brdf2", s);
        const double alpha = s.roughness * s.roughness;
        for (const Cosines& c : directions()) {
            const double d = c.nh * c.nh * (alpha * alpha - 1) + 1.00001;
            const double spec = alpha * alpha / (std::max(0.1, c.lh * c.lh) * (alpha + 0.5) * 4 * d * d);
            const double reduction = 1 - alpha * s.roughness * (0.6 - 0.08 * s.roughness);
            const Triple direct = (s.diffuse() + s.f0() * spec) * c.nl;
            expect_near(model.direct({.l = c.l, .v = c.v}), direct, "direct");
            expect_near(model.color({.l = c.l, .v = c.v}, light),
                        direct + s.diffuse() * 0.2 + mirrored(s, c, light.environment) * reduction, "color");
        }
    }
}

// With the lobe that Unity 5.0 documents, (e + 2) / (2 pi^2) (r.l)^e, in place of the table that ends at 16.
TEST(SimpleModels, UnityBrdf3) {
    const ModelLight light{.light = {1, 1, 1}, .ambient = {0.2, 0.2, 0.2}, .environment = {0.5, 0.4, 0.3}};
    for (const double roughness : {0.15, 0.3, 0.9}) {
        const Surface s{.metallic = 0.4, .roughness = roughness};
        Model model = model_of("unity-brdf3", s);
        const double e = (2 / std::pow(s.roughness, 4) - 2) / 4;
        for (const Cosines& c : directions()) {
            const double lobe = std::min((e + 2) / (2 * kPi * kPi) * std::pow(c.rv, e), 16.0);
            const Triple direct = (s.diffuse() + s.f0() * lobe) * c.nl;
            expect_near(model.direct({.l = c.l, .v = c.v}), direct, "direct");
            expect_near(model.color({.l = c.l, .v = c.v}, light),
                        direct + s.diffuse() * 0.2 + mirrored(s, c, light.environment), "color");
        }
    }
}

double schlick(double f0, double cosine) {
    return f0 + (1 - f0) * std::pow(1 - cosine, 5);
}

// BRDF1's terms with 0.0001 in the visibility. Its own surroundings are turned off.
TEST(SimpleModels, ClPbrSpecular) {
    for (const Surface& s : kSurfaces) {
        Model model = model_of("cl-pbr-specular", s, {{"_SHIntensity", "0"}, {"_ReflectIntensity", "0"}});
        const double alpha = s.roughness * s.roughness, a2 = alpha * alpha;
        for (const Cosines& c : directions()) {
            const double f90 = 0.5 + 2 * c.lh * c.lh * s.roughness;
            const double diffuse =
                (1 + (f90 - 1) * std::pow(1 - c.nl, 5)) * (1 + (f90 - 1) * std::pow(1 - c.nv, 5)) * c.nl;
            const double v = 0.5 / (c.nl * (c.nv * (1 - alpha) + alpha) + c.nv * (c.nl * (1 - alpha) + alpha) + 1e-4);
            const double spread = c.nh * c.nh * (a2 - 1) + 1;
            const double d = a2 / (kPi * (spread * spread + 1e-7));
            Triple expected = s.diffuse() * diffuse;
            for (std::size_t i = 0; i < 3; ++i) expected[i] += kPi * v * d * schlick(s.f0()[i], c.lh) * c.nl;
            expect_near(model.direct({.l = c.l, .v = c.v}), expected, "direct");
        }
    }
}

// What it carries: the sky of its coefficients, at half strength, on the diffuse colour.
TEST(SimpleModels, ClPbrSpecularsSky) {
    const Surface s;
    Model model = model_of("cl-pbr-specular", s, {{"_ReflectIntensity", "0"}});
    const Triple sky = {0.4623682976584511, 0.5989277753568758, 0.77809948882419};  // of a normal that points up
    const Triple seen = model.color({.n = {0, 1, 0}, .l = {0, -1, 0}, .v = {0, 1, 0}, .t = {1, 0, 0}}, {});
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(seen[i], s.diffuse()[i] * sky[i] * 0.5, 1e-12) << i;
}

// Each part alone is its closed form, and together they are the whole.
TEST(SimpleModels, PbrDirectIndirect) {
    const ModelLight light{.light = {1, 1, 1}, .ambient = {0.2, 0.3, 0.4}, .environment = {0.5, 0.4, 0.3}};
    const auto part = [&](const Surface& s, const char* word) {
        return model_of("pbr-direct-indirect", s, {{"_Part", word}});
    };
    for (const Surface& s : kSurfaces) {
        Model all = part(s, "All"), direct = part(s, "Direct"), a = part(s, "DirectSpecular"),
              b = part(s, "DirectDiffuse"), c_part = part(s, "IndirectSpecular"), d_part = part(s, "IndirectDiffuse");
        const double r = s.roughness, alpha = r * r, k = (r + 1) * (r + 1) / 8;
        for (const Cosines& c : directions()) {
            const ModelPoint point{.l = c.l, .v = c.v};
            const double spread = c.nh * c.nh * (alpha * alpha - 1) + 1;
            const double d = alpha * alpha / (kPi * spread * spread);
            const double v = 0.25 / ((c.nl * (1 - k) + k) * (c.nv * (1 - k) + k));
            // Karis, "Physically Based Shading on Mobile".
            const double x = 1 - r, lobe = std::min(x * x, std::exp2(-9.28 * c.nv)) * x + 0.0425 - 0.0275 * r;
            const double scale = 1.04 - 0.572 * r - 1.04 * lobe, offset = 1.04 * lobe + 0.022 * r - 0.04;
            Triple specular, diffuse, sky_specular, sky_diffuse;
            for (std::size_t i = 0; i < 3; ++i) {
                const double f0 = s.f0()[i], f = schlick(f0, c.lh);
                specular[i] = kPi * d * v * f * c.nl;
                diffuse[i] = (1 - f) * (1 - s.metallic) * s.base[i] * c.nl;
                sky_specular[i] = std::max(f0 * scale + offset, 0.0) * light.environment[i];
                const double around = f0 + (std::max(1 - r, f0) - f0) * std::pow(1 - c.nv, 5);
                sky_diffuse[i] = (1 - around) * (1 - s.metallic) * s.base[i] * light.ambient[i];
            }
            expect_near(a.color(point, light), specular, "direct specular");
            expect_near(b.color(point, light), diffuse, "direct diffuse");
            expect_near(direct.color(point, light), specular + diffuse, "direct");
            expect_near(c_part.color(point, light), sky_specular, "indirect specular");
            expect_near(d_part.color(point, light), sky_diffuse, "indirect diffuse");
            expect_near(all.color(point, light), specular + diffuse + sky_specular + sky_diffuse, "all");
        }
    }
}

// With one band and no softness a light is on or off; with eight soft ones it is never far from Lambert's:
// a smooth step leaves the straight line by 0.0962 at most.
TEST(SimpleModels, Toon) {
    const Surface s;
    const std::vector<std::pair<std::string, std::string>> plain = {{"highlight", "0"}, {"rim", "0"}};
    auto hard = plain, soft = plain;
    hard.insert(hard.end(), {{"bands", "1"}, {"bandSoftness", "0"}});
    soft.insert(soft.end(), {{"bands", "8"}, {"bandSoftness", "1"}});
    Model on_off = model_of("toon", s, hard), lambert = model_of("toon", s, soft);
    for (const Cosines& c : directions()) {
        if (c.signed_nl < 0 || c.nl > 0.01) {
            expect_near(on_off.direct({.l = c.l, .v = c.v}), s.base * (c.signed_nl > 0 ? 1 : 0), "hard");
        }
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(lambert.direct({.l = c.l, .v = c.v})[i], s.base[i] * c.nl, 0.0963 / 8) << "soft";
    }
}

}  // namespace
}  // namespace patina::runtime
