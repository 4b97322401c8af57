// The lighting models of nodes/models: each equals its closed form, written once more in plain C++; each that is made
// of microfacets is a graph of a distribution, a visibility, a Fresnel and a diffuse term, and every one of them
// counts.
#include <gtest/gtest.h>

#include <set>

#include "proof/closed_models.h"
#include "proof/quadrature.h"
#include "runtime/lighting/model.h"

namespace patina::proof {

std::string title(const ClosedModel& model) {
    std::string text = model.name;
    for (const auto& [property, word] : model.variant) text += " " + word;
    return text;
}
// What GoogleTest calls a model.
void PrintTo(const ClosedModel& model, std::ostream* stream) {
    *stream << title(model);
}

namespace {

using runtime::Model;

// Models without a closed form here, and why.
constexpr std::pair<std::string_view, std::string_view> kExempt[] = {
    {"merl", "a table of measurements: its own test samples one from a known BRDF"},
};

const Compiler& compiler() {
    static const Compiler made;
    return made;
}

std::string literal(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}
std::string literal(const Color& color) {
    return literal(color[0]) + "," + literal(color[1]) + "," + literal(color[2]);
}

// Surface number `index` of a sequence; the first few are the corners of roughness and metallic.
Surface surface_of(const ClosedModel& model, std::size_t index) {
    static const Sequence points(24);
    Surface surface;
    for (std::size_t c = 0; c < 3; ++c) surface.base[c] = points(index, c);
    surface.metallic = index < 4 ? static_cast<double>(index % 2) : points(index, 3);
    surface.roughness = index < 4 ? static_cast<double>(index / 2) : points(index, 4);
    surface.occlusion = points(index, 5);
    std::size_t dimension = 6;
    for (const ClosedModel::Own& own : model.own) {
        Color& value = surface.own[own.name];
        for (std::size_t c = 0; c < 3; ++c)
            value[c] = own.low + (own.high - own.low) * points(index, dimension + (own.is_color ? c : 0));
        dimension += own.is_color ? 3 : 1;
    }
    return surface;
}

// Any normal; light and view from all around it, the view mostly above. Every second light is where a highlight as wide
// as the roughness sends it to the viewer. Left out is where nodes have their limits, which closed forms have not:
// within a quarter of a degree of the horizon, and lights within eight degrees of straight behind what the viewer sees.
Directions directions_of(std::size_t index, double roughness) {
    static const Sequence points(7);
    const auto u = [index](std::size_t dimension) { return points(index, dimension); };
    Directions d;
    d.n = on_sphere(u(0), u(1));
    const auto normalized = [](Vector a) {
        const double length = std::sqrt(dot(a, a));
        for (double& c : a) c /= length;
        return a;
    };
    const auto cross = [](const Vector& a, const Vector& b) {
        return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    const Vector side = std::abs(d.n[0]) < 0.5 ? Vector{1, 0, 0} : Vector{0, 1, 0};
    const Vector x = normalized(cross(side, d.n)), y = cross(d.n, x);
    const auto in_frame = [&](const Direction& a) {
        Vector sum{};
        for (std::size_t c = 0; c < 3; ++c) sum[c] = a[0] * x[c] + a[1] * y[c] + a[2] * d.n[c];
        return normalized(sum);
    };
    const Direction v = on_sphere(0.4 + 0.6 * u(4), u(5));
    Direction l = on_sphere(0.2 + 0.8 * u(2), u(3));
    if (index % 2 == 1) {
        const double width = std::max(roughness * roughness, 0.002);
        const Direction h = direction(1 / std::sqrt(1 + std::pow(width * std::tan(kPi / 2 * u(2)), 2)), 2 * kPi * u(3));
        for (std::size_t c = 0; c < 3; ++c) l[c] = 2 * dot(v, h) * h[c] - v[c];
    }
    if (dot(l, v) < -0.99 || std::abs(l[2]) < 0.004 || std::abs(v[2]) < 0.004)
        return directions_of(index + 5000, roughness);
    d.l = in_frame(l);
    d.v = in_frame(v);
    d.t = in_frame(direction(0, 2 * kPi * u(6)));
    return d;
}

Model model_of(const ClosedModel& closed, const Surface& surface) {
    runtime::ModelChoice choice{.model = closed.name, .values = closed.variant};
    choice.values.push_back({"baseColor", literal(surface.base)});
    choice.values.push_back({"metallic", literal(surface.metallic)});
    choice.values.push_back({"roughness", literal(surface.roughness)});
    choice.values.push_back({"occlusion", literal(surface.occlusion)});
    for (const ClosedModel::Own& own : closed.own)
        choice.values.push_back(
            {own.name, own.is_color ? literal(surface.own.at(own.name)) : literal(surface.number(own.name))});
    return Model(compiler(), choice);
}

class ModelTest : public testing::TestWithParam<ClosedModel> {};

TEST_P(ModelTest, EqualsItsClosedForm) {
    const ClosedModel& closed = GetParam();
    double worst = 0, brightest = 0;
    for (std::size_t s = 0; s < (kSanitized ? 5 : 40); ++s) {
        const Surface surface = surface_of(closed, s);
        Model model = model_of(closed, surface);
        ASSERT_TRUE(model.ok()) << to_text(model.diagnostics().at(0));
        for (std::size_t i = 0; i < 50; ++i) {
            const Directions d = directions_of(50 * s + i, surface.roughness);
            const runtime::ModelPoint point{.n = d.n, .l = d.l, .v = d.v, .t = d.t};
            const auto compare = [&](const Color& actual, const Color& expected, const char* part) {
                for (std::size_t c = 0; c < 3; ++c) {
                    const double off = std::abs(actual[c] - expected[c]) / std::max(std::abs(expected[c]), 1e-3);
                    ASSERT_LE(off, 1e-9) << part << ", surface " << s << ", directions " << i << ": " << actual[c]
                                         << " is not " << expected[c];
                    worst = std::max(worst, off);
                    brightest = std::max(brightest, expected[c]);
                }
            };
            compare(model.direct(point), closed.direct(surface, d), "direct");
            if (HasFatalFailure()) return;
            // The table of the split sum and the texels of a cube hold floats.
            if (!closed.ambient || i % 10 != 0) continue;
            compare(model.color(point, {.light = {}, .ambient = {1, 1, 1}}), closed.ambient(surface, d), "ambient");
            compare(model.color(point, {.light = {}, .environment = {1, 1, 1}}), closed.environment(surface, d),
                    "environment");
            if (HasFatalFailure()) return;
        }
    }
    std::printf("%-40s differs by at most %.1e, brightest %.4g\n", title(closed).c_str(), worst, brightest);
    if (closed.name != "unlit") {
        EXPECT_GT(brightest, 0.1);
    }
}
INSTANTIATE_TEST_SUITE_P(All, ModelTest, testing::ValuesIn(closed_models()), [](const auto& info) {
    std::string name = title(info.param);
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
    return name;
});

// Where closed forms have no value the graphs still have one.
TEST_P(ModelTest, IsFiniteAndNotNegativeEverywhere) {
    double brightest = 0;
    for (const double roughness : {0.0, 0.5, 1.0}) {
        for (const double metallic : {0.0, 1.0}) {
            for (const double gray : {0.0, 1.0}) {
                Surface surface = surface_of(GetParam(), 7);
                surface.base = {gray, gray, gray};
                surface.metallic = metallic;
                surface.roughness = roughness;
                Model model = model_of(GetParam(), surface);
                ASSERT_TRUE(model.ok()) << to_text(model.diagnostics().at(0));
                for (const double nl : {1.0, 0.5, 1e-4, 0.0, -1e-4, -1.0}) {
                    for (const double nv : {1.0, 0.5, 1e-4, 0.0, -1e-4, -0.5}) {
                        for (const double turn : {0.0, 1.0, kPi}) {
                            const runtime::ModelPoint point{.l = direction(nl, turn), .v = direction(nv, 0)};
                            const runtime::ModelLight light{.ambient = {1, 1, 1}, .environment = {1, 1, 1}};
                            for (const double value : model.color(point, light)) {
                                ASSERT_TRUE(std::isfinite(value) && value >= 0)
                                    << value << ": roughness " << roughness << ", metallic " << metallic << ", base "
                                    << gray << ", n.l " << nl << ", n.v " << nv << ", turn " << turn;
                                brightest = std::max(brightest, value);
                            }
                        }
                    }
                }
            }
        }
    }
    std::printf("%-40s at its limits at most %.4g\n", title(GetParam()).c_str(), brightest);
}

// Models whose direct light depends on one of the two directions more than on the other.
constexpr std::string_view kOneSided[] = {"half-lambert Squared",
                                          "half-lambert Linear",
                                          "phong Classic",
                                          "blinn-phong Classic",
                                          "energy-conserving",
                                          "openpbr",
                                          "toon"};

TEST_P(ModelTest, LightAndViewerMayChangePlaces) {
    const bool is_one_sided =
        std::find(std::begin(kOneSided), std::end(kOneSided), title(GetParam())) != std::end(kOneSided);
    const Sequence points(4);
    double worst = 0;
    for (std::size_t s = 4; s < (kSanitized ? 5 : 12); ++s) {
        Model model = model_of(GetParam(), surface_of(GetParam(), s));
        ASSERT_TRUE(model.ok()) << to_text(model.diagnostics().at(0));
        for (std::size_t i = 0; i < 100; ++i) {
            const Direction a = on_hemisphere(0.005 + 0.995 * points(i, 0), points(i, 1));
            const Direction b = on_hemisphere(0.005 + 0.995 * points(i, 2), points(i, 3));
            const Color there = model.direct({.l = a, .v = b}), back = model.direct({.l = b, .v = a});
            for (std::size_t c = 0; c < 3; ++c) {
                const double one = there[c] / a[2], two = back[c] / b[2];
                if (one != two) worst = std::max(worst, std::abs(one - two) / std::max(std::abs(one), std::abs(two)));
            }
        }
    }
    std::printf("%-40s light and viewer exchanged: differs by %s %.1e\n", title(GetParam()).c_str(),
                is_one_sided ? "up to" : "at most", worst);
    if (is_one_sided) {
        EXPECT_GE(worst, 0.01);
    } else {
        EXPECT_LE(worst, 1e-6);
    }
}

// What CL/pbr-specular carries with it: the sky of its coefficients on the diffuse colour, at half strength.
TEST(Models, ClPbrSpecularCarriesASky) {
    Model model(compiler(),
                {.model = "cl-pbr-specular", .values = {{"baseColor", "0.8,0.4,0.1"}, {"_ReflectIntensity", "0"}}});
    ASSERT_TRUE(model.ok());
    // Computed apart from this project, for a normal that points up.
    const Color sky = {0.4623682976584511, 0.5989277753568758, 0.77809948882419}, base = {0.8, 0.4, 0.1};
    const Color seen = model.color({.n = {0, 1, 0}, .l = {0, -1, 0}, .v = {0, 1, 0}, .t = {1, 0, 0}}, {});
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], 0.96 * base[c] * sky[c] * 0.5, 1e-12) << c;
}

// And what a mirror shows: its lit ball, of which there is none but middle grey, 0.5 as a colour texture stores it.
// Where alpha is 0.002 the surroundings keep 1 / (1 + alpha^2) of themselves.
TEST(Models, ClPbrSpecularMirrorsMiddleGreyWithoutItsBall) {
    Model model(compiler(), {.model = "cl-pbr-specular",
                             .values = {{"baseColor", "1,1,1"}, {"metallic", "1"}, {"roughness", "0"}}});
    ASSERT_TRUE(model.ok());
    const double gray = std::pow((0.5 + 0.055) / 1.055, 2.4);
    const Color seen = model.color({.n = {0, 0, 1}, .l = {0, 0, -1}, .v = {0, 0, 1}, .t = {1, 0, 0}}, {});
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], gray / (1 + 0.002 * 0.002), 1e-6) << c;
}

// The figure is that of Unity's BRDF3_Unity_PBS, which reads its table with (r.l)^4.
TEST(Models, UnityBrdf3HasAHighlightOppositeToTheMirror) {
    Model model(compiler(),
                {.model = "unity-brdf3", .values = {{"baseColor", "1,1,1"}, {"metallic", "1"}, {"roughness", "0.7"}}});
    const double z = 0.199, x = std::sqrt(1 - z * z);
    EXPECT_NEAR(model.direct({.l = {x, 0, z}, .v = {x, 0, z}})[0], 0.0317, 0.00005);
}

TEST(Models, EachHasAClosedFormOrAReasonForNone) {
    std::set<std::string_view> known;
    for (const ClosedModel& closed : closed_models()) known.insert(closed.name);
    for (const auto& [name, reason] : kExempt) known.insert(name);
    for (const ModelInfo& model : compiler().lighting_models()) EXPECT_TRUE(known.contains(model.name)) << model.name;
}

}  // namespace
}  // namespace patina::proof
