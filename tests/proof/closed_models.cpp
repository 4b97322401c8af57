#include "proof/closed_models.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/lighting/environment.h"
#include "runtime/lighting/split_sum.h"

namespace patina::proof {
namespace {

constexpr double kPi = std::numbers::pi;

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
double clamped(double x) {
    return std::clamp(x, 0.0, 1.0);
}
Color times(const Color& a, double s) {
    return {a[0] * s, a[1] * s, a[2] * s};
}
Color plus(const Color& a, const Color& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Color product(const Color& a, const Color& b) {
    return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
}
Color mixed(const Color& a, const Color& b, double t) {
    return plus(times(a, 1 - t), times(b, t));
}
Color gray(double x) {
    return {x, x, x};
}
double fifth(double cosine) {
    return std::pow(1 - clamped(cosine), 5);
}

// Unity keeps the length of l + v away from zero; the plain half vector does not.
enum class Half { Floored, Plain };
struct Cosines {
    double nl, nv, nh, lh, signed_nl, signed_nv;
    Cosines(const Directions& d, Half half) {
        const Vector sum = plus(d.l, d.v);
        const double length = std::sqrt(half == Half::Floored ? std::max(dot(sum, sum), 0.001) : dot(sum, sum));
        const Vector h = times(sum, 1 / length);
        signed_nl = dot(d.n, d.l);
        signed_nv = dot(d.n, d.v);
        nl = clamped(signed_nl);
        nv = clamped(signed_nv);
        nh = clamped(dot(d.n, h));
        lh = clamped(dot(d.l, h));
    }
};
// Phong: the light mirrored at the surface, seen by the viewer.
double signed_mirror_cosine(const Directions& d) {
    return dot(plus(times(d.n, 2 * dot(d.n, d.l)), times(d.l, -1)), d.v);
}
double mirror_cosine(const Directions& d) {
    return clamped(signed_mirror_cosine(d));
}

Color schlick(const Color& f0, double f90, double cosine) {
    return mixed(f0, gray(f90), fifth(cosine));
}
double disney_diffuse(double nl, double nv, double lh, double roughness) {
    const double f90 = 0.5 + 2 * lh * lh * roughness;
    return (1 + (f90 - 1) * fifth(nl)) * (1 + (f90 - 1) * fifth(nv));
}
double ggx(double nh, double alpha) {
    const double d = nh * nh * (alpha * alpha - 1) + 1;
    return alpha * alpha / (kPi * d * d);
}
double ggx_unity(double nh, double alpha) {
    const double d = (nh * alpha * alpha - nh) * nh + 1;
    return alpha * alpha / (kPi * (d * d + 1e-7));
}
double joint_approximate(double nl, double nv, double alpha, double guard) {
    return 0.5 / (nl * (nv * (1 - alpha) + alpha) + nv * (nl * (1 - alpha) + alpha) + guard);
}
// Unity's f90 for surroundings.
double grazing(const Surface& s) {
    return clamped(1 - s.roughness + 1 - s.one_minus_reflectivity());
}
double spec_power(double roughness) {
    return std::max(2 / std::max(std::pow(roughness, 4), 1e-4) - 2, 1e-4);
}

// --- Lambert 1760
Color lambert(const Surface& s, const Directions& d) {
    return times(s.diffuse_color(), clamped(dot(d.n, d.l)));
}
Color diffuse_ambient(const Surface& s, const Directions&) {
    return times(s.diffuse_color(), s.occlusion);
}
Color nothing(const Surface&, const Directions&) {
    return {};
}

// --- half Lambert (Valve, SIGGRAPH 2006)
Color half_lambert_squared(const Surface& s, const Directions& d) {
    const double wrapped = 0.5 * dot(d.n, d.l) + 0.5;
    return times(s.diffuse_color(), wrapped * wrapped);
}
Color half_lambert_linear(const Surface& s, const Directions& d) {
    return times(s.diffuse_color(), 0.5 * dot(d.n, d.l) + 0.5);
}

// --- Phong 1975, Blinn 1977
Color phong_classic(const Surface& s, const Directions& d) {
    const double lobe = dot(d.n, d.l) > 0 ? std::pow(mirror_cosine(d), s.number("exponent")) : 0;
    return plus(lambert(s, d), times(s.own.at("specularColor"), lobe));
}
Color phong_normalized(const Surface& s, const Directions& d) {
    const double alpha = std::max(s.roughness * s.roughness, 0.002);
    const double exponent = std::max(std::max(2 / std::max(alpha * alpha, 1e-4) - 2, 1e-4) / 4, 1.0);
    const double lobe = (exponent + 2) / 2 * std::pow(mirror_cosine(d), exponent) * clamped(dot(d.n, d.l));
    return plus(lambert(s, d), times(s.f0(), mirror_cosine(d) > 0 ? lobe : 0));
}
Color blinn_classic(const Surface& s, const Directions& d) {
    const Cosines c(d, Half::Plain);
    const double lobe = c.signed_nl > 0 ? std::pow(c.nh, s.number("exponent")) : 0;
    return plus(lambert(s, d), times(s.own.at("specularColor"), lobe));
}
Color blinn_normalized(const Surface& s, const Directions& d) {
    const Cosines c(d, Half::Floored);
    const double alpha = std::max(s.roughness * s.roughness, 0.002);
    const double exponent = std::max(2 / std::max(alpha * alpha, 1e-4) - 2, 1e-4);
    return plus(lambert(s, d), times(s.f0(), (exponent + 2) / 8 * std::pow(c.nh, exponent) * c.nl));
}
Color mirrored_f0(const Surface& s, const Directions&) {
    return times(s.f0(), s.occlusion);
}

// --- Unity's three
Color brdf1(const Surface& s, const Directions& d) {
    const Cosines c(d, Half::Floored);
    const double nv = std::min(std::abs(c.signed_nv), 1.0), alpha = std::max(s.roughness * s.roughness, 0.002);
    const bool has_specular = s.f0()[0] > 0 || s.f0()[1] > 0 || s.f0()[2] > 0;
    const double lobe =
        has_specular ? joint_approximate(c.nl, nv, alpha, 1e-5) * ggx_unity(c.nh, alpha) * kPi * c.nl : 0;
    return plus(times(s.diffuse_color(), disney_diffuse(c.nl, nv, c.lh, s.roughness) * c.nl),
                times(schlick(s.f0(), 1, c.lh), lobe));
}
Color brdf1_environment(const Surface& s, const Directions& d) {
    const double nv = std::min(std::abs(dot(d.n, d.v)), 1.0), alpha = std::max(s.roughness * s.roughness, 0.002);
    return times(schlick(s.f0(), grazing(s), nv), s.occlusion / (alpha * alpha + 1));
}
Color brdf2(const Surface& s, const Directions& d) {
    const Cosines c(d, Half::Floored);
    const double alpha = s.roughness * s.roughness, spread = c.nh * c.nh * (alpha * alpha - 1) + 1.00001;
    const double lobe = alpha * alpha / (std::max(0.1, c.lh * c.lh) * (alpha + 0.5) * 4 * spread * spread);
    return times(plus(s.diffuse_color(), times(s.f0(), lobe)), c.nl);
}
Color brdf2_environment(const Surface& s, const Directions& d) {
    const double r = s.roughness, reduction = 1 - r * r * r * (0.6 - 0.08 * r);
    const double weight = std::pow(1 - clamped(dot(d.n, d.v)), 4);
    return times(mixed(s.f0(), gray(grazing(s)), weight), reduction * s.occlusion);
}
// The branch of an early release that stands in for the table, with the table's argument: (r.l)^4, which has no sign.
Color brdf3(const Surface& s, const Directions& d) {
    const double exponent = spec_power(s.roughness) / 4, fourth = std::pow(signed_mirror_cosine(d), 4);
    const double lobe = fourth > 0 ? (exponent + 2) / (2 * kPi * kPi) * std::pow(fourth, exponent / 4) : 0;
    return times(plus(s.diffuse_color(), times(s.f0(), std::min(lobe, 16.0))), clamped(dot(d.n, d.l)));
}
Color brdf3_environment(const Surface& s, const Directions& d) {
    const double weight = std::pow(1 - clamped(dot(d.n, d.v)), 4);
    return times(mixed(s.f0(), gray(grazing(s)), weight), s.occlusion);
}

// --- the shader CL/pbr-specular: BRDF1 with a larger guard, and without its switch for black reflectances
Color cl_pbr_specular(const Surface& s, const Directions& d) {
    const Cosines c(d, Half::Floored);
    const double nv = std::min(std::abs(c.signed_nv), 1.0), alpha = std::max(s.roughness * s.roughness, 0.002);
    const double lobe = joint_approximate(c.nl, nv, alpha, 1e-4) * ggx_unity(c.nh, alpha) * kPi * c.nl;
    return plus(times(s.diffuse_color(), disney_diffuse(c.nl, nv, c.lh, s.roughness) * c.nl),
                times(schlick(s.f0(), 1, c.lh), lobe));
}

// Its default strength of the ambient light is one half.
Color half_ambient(const Surface& s, const Directions& d) {
    return times(diffuse_ambient(s, d), 0.5);
}

// --- the tutorial in four parts
Color four_parts_specular(const Surface& s, const Directions& d) {
    const Cosines c(d, Half::Plain);
    const double k = (s.roughness + 1) * (s.roughness + 1) / 8;
    const double g = 1 / ((c.nv * (1 - k) + k) * (c.nl * (1 - k) + k));
    const double alpha = std::max(s.roughness * s.roughness, 0.002);
    return times(schlick(s.f0(), 1, c.lh), ggx(c.nh, alpha) * g / 4 * kPi * c.nl);
}
Color four_parts_diffuse(const Surface& s, const Directions& d) {
    const Cosines c(d, Half::Plain);
    const Color scattered = plus(gray(1), times(schlick(s.f0(), 1, c.lh), -1));
    return times(product(s.base, scattered), (1 - s.metallic) * c.nl);
}
Color four_parts(const Surface& s, const Directions& d) {
    return plus(four_parts_specular(s, d), four_parts_diffuse(s, d));
}
Color four_parts_ambient(const Surface& s, const Directions& d) {
    Color scattered{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double f0 = s.f0()[i], f90 = std::max(1 - s.roughness, f0);
        scattered[i] = (1 - f0 - (f90 - f0) * fifth(dot(d.n, d.v))) * (1 - s.metallic);
    }
    return times(product(s.base, scattered), s.occlusion);
}
// Karis's fit for phones.
Color four_parts_environment(const Surface& s, const Directions& d) {
    const double r = s.roughness, x = 1 - r;
    const double a = std::min(x * x, std::exp2(-9.28 * clamped(dot(d.n, d.v)))) * x + 0.0425 - 0.0275 * r;
    const double scale = 1.04 - 0.572 * r - 1.04 * a, offset = 1.04 * a + 0.022 * r - 0.04;
    Color sum{};
    for (std::size_t i = 0; i < 3; ++i) sum[i] = std::max(s.f0()[i] * scale + offset, 0.0) * s.occlusion;
    return sum;
}

// --- the split sum's table: linear between its entries, whose axes are the root of n.v and the roughness
struct SplitSum {
    double scale, offset;
};
SplitSum split_sum(const Surface& s, double nv) {
    static const auto table = runtime::split_sum_table();
    const TextureLevel& level = table->levels[0];
    const auto place = [](double x, int size) {
        const double at = std::clamp(x, 0.0, 1.0) * (size - 1);
        const int left = std::min(static_cast<int>(at), size - 2);
        return std::pair(left, at - left);
    };
    const auto [x, fx] = place(std::sqrt(clamped(nv)), level.width);
    const auto [y, fy] = place(s.roughness, level.height);
    std::array<double, 2> sum{};
    for (const int i : {0, 1}) {
        for (const int k : {0, 1}) {
            const double weight = (i ? fx : 1 - fx) * (k ? fy : 1 - fy);
            const std::size_t texel = 4 * static_cast<std::size_t>((y + k) * level.width + x + i);
            for (std::size_t c = 0; c < 2; ++c) sum[c] += weight * static_cast<double>(level.texels[texel + c]);
        }
    }
    return {sum[0], sum[1]};
}

double absolute_nv(const Directions& d) {
    return std::min(std::abs(dot(d.n, d.v)), 1.0);
}
double joint(double nl, double nv, double alpha) {
    const double a2 = alpha * alpha;
    return 0.5 / (nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2));
}
double smooth_alpha(const Surface& s) {
    return std::max(s.roughness * s.roughness, 0.002);
}
// pi D V n.l of GGX with Smith's exact joint visibility.
double ggx_lobe(const Surface& s, const Cosines& c, const Directions& d) {
    return c.nl > 0 ? kPi * ggx(c.nh, smooth_alpha(s)) * joint(c.nl, absolute_nv(d), smooth_alpha(s)) * c.nl : 0;
}

// --- energy conserving: Turquin's compensation, and what the specular term leaves to Lambert
Color compensation(const Color& f0, const SplitSum& e) {
    return plus(gray(1), times(f0, 1 / (e.scale + e.offset) - 1));
}
Color whole_albedo(const Color& f0, const SplitSum& e) {
    return product(plus(times(f0, e.scale), gray(e.offset)), compensation(f0, e));
}
Color energy_conserving(const Surface& s, const Directions& d) {
    const Cosines c(d, Half::Floored);
    const SplitSum e = split_sum(s, absolute_nv(d));
    const double lobe = ggx_lobe(s, c, d);
    const Color glass = gray(0.04), left = plus(gray(1), times(whole_albedo(glass, e), -1));
    const Color dielectric =
        plus(times(product(s.base, left), c.nl), times(product(schlick(glass, 1, c.lh), compensation(glass, e)), lobe));
    const Color metal = times(product(schlick(s.base, 1, c.lh), compensation(s.base, e)), lobe);
    return mixed(dielectric, metal, s.metallic);
}
Color energy_conserving_ambient(const Surface& s, const Directions& d) {
    const Color left = plus(gray(1), times(whole_albedo(gray(0.04), split_sum(s, absolute_nv(d))), -1));
    return times(product(s.base, left), (1 - s.metallic) * s.occlusion);
}
Color energy_conserving_environment(const Surface& s, const Directions& d) {
    const double nv = absolute_nv(d);
    const SplitSum e = split_sum(s, nv);
    // Lagarde's specular occlusion.
    const double open =
        clamped(std::pow(nv + s.occlusion, std::exp2(-16 * s.roughness * s.roughness - 1)) - 1 + s.occlusion);
    return times(mixed(whole_albedo(gray(0.04), e), whole_albedo(s.base, e), s.metallic), open);
}

// --- glTF 2.0, appendix B
Color gltf(const Surface& s, const Directions& d) {
    const Cosines c(d, Half::Floored);
    const Color fresnel = schlick(s.f0(), 1, c.lh), left = plus(gray(1), times(fresnel, -1));
    return plus(times(product(s.base, left), (1 - s.metallic) * c.nl), times(fresnel, ggx_lobe(s, c, d)));
}
Color mirrored_split_sum(const Surface& s, const Directions& d) {
    const SplitSum e = split_sum(s, absolute_nv(d));
    return times(plus(times(s.f0(), e.scale), gray(e.offset)), s.occlusion);
}
Color gltf_ambient(const Surface& s, const Directions& d) {
    const SplitSum e = split_sum(s, absolute_nv(d));
    const Color left = plus(gray(1 - e.offset), times(s.f0(), -e.scale));
    return times(product(s.base, left), (1 - s.metallic) * s.occlusion);
}

// --- OpenPBR 1.1: dielectric, metal and coat, each compensated (Turquin 2019)
struct OpenLobe {
    SplitSum e;
    Color f0;
    double f90;
    Color compensation() const { return plus(gray(1), times(f0, 1 / (e.scale + e.offset) - 1)); }
    Color albedo() const {
        Color sum = product(plus(times(f0, e.scale), gray(f90 * e.offset)), compensation());
        for (double& c : sum) c = std::min(c, 1.0);
        return sum;
    }
    Color fresnel(double cosine) const { return product(schlick(f0, f90, cosine), compensation()); }
};
struct OpenPbr {
    double nv, share;
    Surface below;
    Color base;
    OpenLobe dielectric, metal, coat;
    Color kept, through;
    OpenPbr(const Surface& s, const Directions& d) : nv(absolute_nv(d)), share(s.number("coatWeight")), below(s) {
        const double r = s.roughness, c = s.number("coatRoughness"), n = s.number("coatIor");
        below.roughness = r + (std::pow(std::min(1.0, std::pow(r, 4) + 2 * std::pow(c, 4)), 0.25) - r) * share;
        base = times(s.base, s.number("baseWeight"));
        const double ratio = s.number("specularIor") / (1 + (n - 1) * share), weight = s.number("specularWeight");
        const double f0 = std::pow((ratio - 1) / (ratio + 1), 2) * weight, coat_f0 = std::pow((n - 1) / (n + 1), 2);
        const SplitSum e = split_sum(below, nv);
        Surface above = s;
        above.roughness = c;
        dielectric = {e, gray(f0), std::min(1.0, 50 * f0)};
        metal = {e, base, 1};
        coat = {split_sum(above, nv), gray(coat_f0), std::min(1.0, 50 * coat_f0)};
        kept = plus(gray(1), times(dielectric.albedo(), -1));
        // Light between coat and base, and its way through the coat.
        const Color albedo =
            mixed(plus(dielectric.albedo(), product(kept, base)), times(metal.albedo(), weight), s.metallic);
        const double mean = (n - 1) / (4.08567 + 1.00071 * n), rough = 1 - (1 - mean) / (n * n);
        const double smooth = coat_f0 + (1 - coat_f0) * fifth(nv), matte = 1 + (r - 1) * s.metallic;
        const double back = smooth + (rough - smooth) * matte, way = 1 / std::sqrt(1 - (1 - nv * nv) / (n * n));
        for (std::size_t i = 0; i < 3; ++i) {
            through[i] =
                (1 - coat.albedo()[i]) * std::pow(s.own.at("coatColor")[i], way) * (1 - back) / (1 - albedo[i] * back);
        }
    }
    Color covered(const Color& light) const { return mixed(light, product(light, through), share); }
};
Color open_pbr(const Surface& s, const Directions& d) {
    const Cosines c(d, Half::Floored);
    const OpenPbr o(s, d);
    Surface above = s;
    above.roughness = s.number("coatRoughness");
    const double lobe = ggx_lobe(o.below, c, d);
    const Color insulator = plus(times(product(o.kept, o.base), c.nl), times(o.dielectric.fresnel(c.lh), lobe));
    const Color conductor = times(o.metal.fresnel(c.lh), lobe * s.number("specularWeight"));
    return plus(o.covered(mixed(insulator, conductor, s.metallic)),
                times(o.coat.fresnel(c.lh), o.share * ggx_lobe(above, c, d)));
}
Color open_pbr_ambient(const Surface& s, const Directions& d) {
    const OpenPbr o(s, d);
    return times(o.covered(product(o.kept, o.base)), (1 - s.metallic) * s.occlusion);
}
Color open_pbr_environment(const Surface& s, const Directions& d) {
    const OpenPbr o(s, d);
    const Color base = mixed(o.dielectric.albedo(), times(o.metal.albedo(), s.number("specularWeight")), s.metallic);
    return times(plus(o.covered(base), times(o.coat.albedo(), o.share)), s.occlusion);
}

// --- Cook-Torrance, with one term at a time other than GGX, Smith's joint V, Schlick and Lambert
using Visibility = double (*)(const Surface&, const Cosines&, double nv);
template <double (*D)(double, double), Visibility V>
Color cook_torrance(const Surface& s, const Directions& d) {
    const Cosines c(d, Half::Floored);
    const double lobe = c.nl > 0 ? kPi * D(c.nh, smooth_alpha(s)) * V(s, c, absolute_nv(d)) * c.nl : 0;
    return plus(times(s.diffuse_color(), c.nl), times(schlick(s.f0(), 1, c.lh), lobe));
}
double beckmann(double nh, double alpha) {
    const double c2 = nh * nh, a2 = alpha * alpha;
    return c2 > 0 ? std::exp((c2 - 1) / (a2 * c2)) / (kPi * a2 * c2 * c2) : 0;
}
double blinn_phong_of_roughness(double nh, double alpha) {
    return std::pow(nh, 2 / (alpha * alpha) - 2) / (kPi * alpha * alpha);
}
double berry(double nh, double alpha) {
    const double a2 = alpha * alpha, spread = 1 + (a2 - 1) * nh * nh;
    return a2 < 1 ? (a2 - 1) / (kPi * std::log(a2) * spread) : 1 / kPi;
}
double v_joint(const Surface& s, const Cosines& c, double nv) {
    return joint(c.nl, nv, smooth_alpha(s));
}
double v_approximate(const Surface& s, const Cosines& c, double nv) {
    return joint_approximate(c.nl, nv, smooth_alpha(s), 1e-5);
}
double v_separable(const Surface& s, const Cosines& c, double nv) {
    const double a2 = smooth_alpha(s) * smooth_alpha(s);
    const auto part = [a2](double x) { return 1 / (x + std::sqrt(x * x * (1 - a2) + a2)); };
    return part(c.nl) * part(nv);
}
double v_beckmann(const Surface& s, const Cosines& c, double nv) {
    const double alpha = smooth_alpha(s);
    const auto g1 = [alpha](double x) {
        const double a = x / (alpha * std::sqrt(std::max(1 - x * x, 1e-300)));
        return a < 1.6 ? (3.535 * a + 2.181 * a * a) / (1 + 2.276 * a + 2.577 * a * a) : 1;
    };
    return g1(c.nl) * g1(nv) / (4 * c.nl * nv);
}
double v_schlick(const Surface& s, const Cosines& c, double nv) {
    const double k = (s.roughness + 1) * (s.roughness + 1) / 8;
    return 0.25 / ((nv * (1 - k) + k) * (c.nl * (1 - k) + k));
}
double v_grooves(const Surface&, const Cosines& c, double nv) {
    return std::min({1.0, 2 * c.nh * nv / c.lh, 2 * c.nh * c.nl / c.lh}) / (4 * c.nl * nv);
}
double v_kelemen(const Surface&, const Cosines& c, double) {
    return 1 / (4 * c.lh * c.lh);
}
double v_neumann(const Surface&, const Cosines& c, double nv) {
    return 1 / (4 * std::max(c.nl, nv));
}
double v_implicit(const Surface&, const Cosines&, double) {
    return 0.25;
}
Color with_gaussian(const Surface& s, const Directions& d) {
    const Cosines c(d, Half::Floored);
    const Color fresnel = mixed(s.f0(), gray(1), std::exp2((-5.55473 * c.lh - 6.98316) * c.lh));
    return plus(times(s.diffuse_color(), c.nl), times(fresnel, ggx_lobe(s, c, d)));
}
Color without_fresnel(const Surface& s, const Directions& d) {
    const Cosines c(d, Half::Floored);
    return plus(times(s.diffuse_color(), c.nl), times(s.f0(), ggx_lobe(s, c, d)));
}
Color over_disney(const Surface& s, const Directions& d) {
    const Cosines c(d, Half::Floored);
    const double term = disney_diffuse(c.nl, absolute_nv(d), c.lh, s.roughness);
    return plus(times(s.diffuse_color(), term * c.nl), times(schlick(s.f0(), 1, c.lh), ggx_lobe(s, c, d)));
}
// Fujii's improvement of Oren and Nayar's model.
Color over_oren_nayar(const Surface& s, const Directions& d) {
    const Cosines c(d, Half::Floored);
    const double nv = absolute_nv(d), along = dot(d.l, d.v) - c.nl * nv, larger = along > 0 ? std::max(c.nl, nv) : 1;
    const double term = (1 + s.roughness * along / larger) / (1 + (0.5 - 2 / (3 * kPi)) * s.roughness);
    return plus(times(s.diffuse_color(), term * c.nl), times(schlick(s.f0(), 1, c.lh), ggx_lobe(s, c, d)));
}

// --- Disney's principled BRDF of 2012, on a base colour that is linear already
struct DisneyColors {
    Color f0, sheen;
};
DisneyColors disney_colors(const Surface& s) {
    const double luminance = 0.3 * s.base[0] + 0.6 * s.base[1] + 0.1 * s.base[2];
    const Color tint = luminance > 0 ? times(s.base, 1 / luminance) : gray(1);
    const Color dielectric = times(mixed(gray(1), tint, s.number("specularTint")), 0.08 * s.number("specularLevel"));
    return {mixed(dielectric, s.base, s.metallic),
            times(mixed(gray(1), tint, s.number("sheenTint")), s.number("sheen"))};
}
Color disney(const Surface& s, const Directions& d) {
    const Cosines c(d, Half::Plain);
    const Vector b = {d.n[1] * d.t[2] - d.n[2] * d.t[1], d.n[2] * d.t[0] - d.n[0] * d.t[2],
                      d.n[0] * d.t[1] - d.n[1] * d.t[0]};
    const double nv = absolute_nv(d), aspect = std::sqrt(1 - 0.9 * s.number("anisotropic"));
    const double ax = std::max(0.001, s.roughness * s.roughness / aspect);
    const double ay = std::max(0.001, s.roughness * s.roughness * aspect);
    const Vector sum = plus(d.l, d.v);
    const Vector h = times(sum, 1 / std::sqrt(dot(sum, sum)));
    const double spread = std::pow(dot(h, d.t) / ax, 2) + std::pow(dot(h, b) / ay, 2) + c.nh * c.nh;
    const auto smith = [&](const Vector& w, double cosine) {
        return 1 / (cosine + std::sqrt(std::pow(dot(w, d.t) * ax, 2) + std::pow(dot(w, b) * ay, 2) + cosine * cosine));
    };
    const auto [f0, sheen] = disney_colors(s);
    const double lobe = smith(d.l, c.nl) * smith(d.v, nv) / (kPi * ax * ay * spread * spread);

    const double fss90 = c.lh * c.lh * s.roughness;
    const double fss = (1 + (fss90 - 1) * fifth(c.nl)) * (1 + (fss90 - 1) * fifth(nv));
    const double flat = c.nl + nv > 0 ? 1.25 * (fss * (1 / (c.nl + nv) - 0.5) + 0.5) : 0;
    const double scatter =
        disney_diffuse(c.nl, nv, c.lh, s.roughness) * (1 - s.number("subsurface")) + flat * s.number("subsurface");
    const Color cloth = plus(times(s.base, scatter), times(sheen, kPi * fifth(c.lh)));

    const double coat_alpha = 0.1 + (0.001 - 0.1) * s.number("clearcoatGloss");
    const auto coat_smith = [](double x) { return 1 / (x + std::sqrt(0.0625 + x * x - 0.0625 * x * x)); };
    const double coat = 0.25 * s.number("clearcoat") * berry(c.nh, coat_alpha) * (0.04 + 0.96 * fifth(c.lh)) *
                        coat_smith(c.nl) * coat_smith(nv);
    const Color specular = plus(times(schlick(f0, 1, c.lh), lobe), gray(coat));
    return times(plus(times(cloth, 1 - s.metallic), times(specular, kPi)), c.nl);
}
Color disney_ambient(const Surface& s, const Directions& d) {
    const Color spread = plus(s.base, times(disney_colors(s).sheen, fifth(absolute_nv(d))));
    return times(spread, (1 - s.metallic) * s.occlusion);
}
Color disney_environment(const Surface& s, const Directions& d) {
    const SplitSum e = split_sum(s, absolute_nv(d));
    const double coat = 0.25 * s.number("clearcoat") * (0.04 + 0.96 * fifth(absolute_nv(d)));
    return times(plus(times(disney_colors(s).f0, e.scale), gray(e.offset + coat)), s.occlusion);
}

// --- toon: a ramp of soft steps, a spot and a rim
double smooth(double from, double to, double x) {
    const double t = clamped((x - from) / (to - from));
    return t * t * (3 - 2 * t);
}
Color toon(const Surface& s, const Directions& d) {
    const Cosines c(d, Half::Plain);
    const double steps = c.nl * s.number("bands"), whole = std::floor(steps);
    const double blend = smooth(0, std::max(s.number("bandSoftness"), 0.001), steps - whole);
    const double tone = clamped((whole + blend) / s.number("bands")), lit = smooth(0, 0.05, c.nl);
    const double edge = 1 - 0.12 * s.roughness * s.roughness - 0.004;
    const double spot = smooth(edge, edge + 0.004, c.nh) * lit * s.number("highlight");
    const double glow = smooth(-0.04, 0.04, s.number("rimWidth") - c.nv) * lit * s.number("rim");
    return plus(times(s.base, tone + glow), gray(spot));
}
Color toon_ambient(const Surface& s, const Directions&) {
    return times(product(s.base, s.own.at("shadeColor")), s.occlusion);
}

}  // namespace

Color Surface::f0() const {
    return mixed(gray(0.04), base, metallic);
}
Color Surface::diffuse_color() const {
    return times(base, one_minus_reflectivity());
}
double Surface::one_minus_reflectivity() const {
    return 0.96 * (1 - metallic);
}

const std::vector<ClosedModel>& closed_models() {
    using Own = std::vector<ClosedModel::Own>;
    static const Own highlight = {{"specularColor", true}, {"exponent", false, 1, 1000}};
    static const Own bands = {{"bands", false, 1, 8}, {"bandSoftness"}, {"shadeColor", true},
                              {"highlight"},          {"rim"},          {"rimWidth"}};
    static const Own coated = {{"baseWeight"},
                               {"specularWeight"},
                               {"specularIor", false, 1.1, 2.5},
                               {"coatWeight"},
                               {"coatColor", true, 0.05, 1},
                               {"coatRoughness"},
                               {"coatIor", false, 1.1, 2.5}};
    static const Own eleven = {{"subsurface"}, {"specularLevel"}, {"specularTint"}, {"anisotropic"},
                               {"sheen"},      {"sheenTint"},     {"clearcoat"},    {"clearcoatGloss"}};
    const auto torrance = [](const char* choice, const char* word, Color (*direct)(const Surface&, const Directions&)) {
        return ClosedModel{"cook-torrance", {{choice, word}}, {}, direct, diffuse_ambient, mirrored_split_sum};
    };
    static const std::vector<ClosedModel> all = {
        {"unlit", {}, {}, nothing, nothing, nothing},
        {"lambert", {}, {}, lambert, diffuse_ambient, nothing},
        {"half-lambert", {{"_Curve", "Squared"}}, {}, half_lambert_squared, diffuse_ambient, nothing},
        {"half-lambert", {{"_Curve", "Linear"}}, {}, half_lambert_linear, diffuse_ambient, nothing},
        {"phong", {{"_Normalization", "Classic"}}, highlight, phong_classic, diffuse_ambient, nothing},
        {"phong", {{"_Normalization", "Normalized"}}, {}, phong_normalized, diffuse_ambient, mirrored_f0},
        {"blinn-phong", {{"_Normalization", "Classic"}}, highlight, blinn_classic, diffuse_ambient, nothing},
        {"blinn-phong", {{"_Normalization", "Normalized"}}, {}, blinn_normalized, diffuse_ambient, mirrored_f0},
        {"unity-brdf1", {}, {}, brdf1, diffuse_ambient, brdf1_environment},
        {"unity-brdf2", {}, {}, brdf2, diffuse_ambient, brdf2_environment},
        {"unity-brdf3", {}, {}, brdf3, diffuse_ambient, brdf3_environment},
        {"cl-pbr-specular", {{"_Surroundings", "Scene"}}, {}, cl_pbr_specular, half_ambient, brdf1_environment},
        {"pbr-direct-indirect", {}, {}, four_parts, four_parts_ambient, four_parts_environment},
        {"pbr-direct-indirect", {{"_Part", "Direct"}}, {}, four_parts, nothing, nothing},
        {"pbr-direct-indirect", {{"_Part", "DirectSpecular"}}, {}, four_parts_specular, nothing, nothing},
        {"pbr-direct-indirect", {{"_Part", "DirectDiffuse"}}, {}, four_parts_diffuse, nothing, nothing},
        {"pbr-direct-indirect", {{"_Part", "IndirectSpecular"}}, {}, nothing, nothing, four_parts_environment},
        {"pbr-direct-indirect", {{"_Part", "IndirectDiffuse"}}, {}, nothing, four_parts_ambient, nothing},
        {"energy-conserving", {}, {}, energy_conserving, energy_conserving_ambient, energy_conserving_environment},
        {"gltf", {}, {}, gltf, gltf_ambient, mirrored_split_sum},
        {"openpbr", {}, coated, open_pbr, open_pbr_ambient, open_pbr_environment},
        torrance("_Distribution", "GGX", cook_torrance<ggx, v_joint>),
        torrance("_Distribution", "Beckmann", cook_torrance<beckmann, v_joint>),
        torrance("_Distribution", "BlinnPhong", cook_torrance<blinn_phong_of_roughness, v_joint>),
        torrance("_Distribution", "GTR1", cook_torrance<berry, v_joint>),
        torrance("_Visibility", "SmithJointApproximate", cook_torrance<ggx, v_approximate>),
        torrance("_Visibility", "SmithSeparable", cook_torrance<ggx, v_separable>),
        torrance("_Visibility", "SmithBeckmann", cook_torrance<ggx, v_beckmann>),
        torrance("_Visibility", "Schlick", cook_torrance<ggx, v_schlick>),
        torrance("_Visibility", "CookTorrance", cook_torrance<ggx, v_grooves>),
        torrance("_Visibility", "Kelemen", cook_torrance<ggx, v_kelemen>),
        torrance("_Visibility", "Neumann", cook_torrance<ggx, v_neumann>),
        torrance("_Visibility", "Implicit", cook_torrance<ggx, v_implicit>),
        torrance("_Fresnel", "SphericalGaussian", with_gaussian),
        torrance("_Fresnel", "None", without_fresnel),
        torrance("_Diffuse", "Disney", over_disney),
        torrance("_Diffuse", "OrenNayar", over_oren_nayar),
        {"disney-principled", {}, eleven, disney, disney_ambient, disney_environment},
        {"toon", {}, bands, toon, toon_ambient, nothing},
    };
    return all;
}

}  // namespace patina::proof
