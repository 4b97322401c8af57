// A car paint as if it had been measured: the table of a BRDF that no single model here has. A satin clear coat lies
// over flakes whose colour turns from petrol to violet with the angle at which light meets them, and over a dark
// pigment.
//
// source: GGX: Walter et al., EGSR 2007; Smith's joint visibility: Heitz, JCGT 3(2), 2014; Fresnel: Schlick,
// Eurographics 1994
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "examples/textures/sets.h"
#include "runtime/lighting/merl.h"

namespace textures {
namespace {

using Triple = std::array<double, 3>;

constexpr double kPi = std::numbers::pi;

struct Cosines {
    double nl, nv, nh, lh;
};

// D V of GGX, in 1/sr.
double lobe(double alpha, const Cosines& at) {
    const double a2 = alpha * alpha, spread = at.nh * at.nh * (a2 - 1) + 1;
    const double view = at.nl * std::sqrt(at.nv * at.nv * (1 - a2) + a2);
    const double light = at.nv * std::sqrt(at.nl * at.nl * (1 - a2) + a2);
    return a2 / (kPi * spread * spread) * 0.5 / (view + light);
}

double schlick(double f0, double cosine) {
    return f0 + (1 - f0) * std::pow(1 - cosine, 5);
}

Triple satin_paint(const patina::runtime::DirectionPair& pair) {
    const auto& [l, v] = pair;
    const Triple sum = {l[0] + v[0], l[1] + v[1], l[2] + v[2]};
    const double length = std::max(std::hypot(sum[0], sum[1], sum[2]), 1e-6);
    // Below the horizon it goes on as at the horizon, so that the last entries above have something to lean on.
    const Cosines at = {std::max(l[2], 0.03), std::max(v[2], 0.03), sum[2] / length,
                        (sum[0] * l[0] + sum[1] * l[1] + sum[2] * l[2]) / length};
    constexpr Triple kPigment = {0.004, 0.01, 0.022}, kFacing = {0.01, 0.36, 0.4}, kGrazing = {0.42, 0.05, 0.5};
    const double turn = std::clamp((1 - at.lh) / 0.35, 0.0, 1.0);
    // Light passes the coat twice.
    const double through = (1 - schlick(0.04, at.nl)) * (1 - schlick(0.04, at.nv));
    const double coat = lobe(0.12, at) * schlick(0.04, at.lh), flakes = lobe(0.4, at);
    Triple result;
    for (std::size_t c = 0; c < 3; ++c) {
        const double flake = kFacing[c] + (kGrazing[c] - kFacing[c]) * turn;
        result[c] = coat + through * (kPigment[c] / kPi + flake * flakes);
    }
    return result;
}

}  // namespace

// Half floats: three digits are more than the table's own steps keep.
std::string save_satin_paint(const std::string& path) {
    const patina::runtime::Image image = as_texture(patina::runtime::sampled_table(satin_paint, 24, 24, 48));
    std::vector<float> texels;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4)
        texels.insert(texels.end(), image.pixels.begin() + std::ptrdiff_t(i),
                      image.pixels.begin() + std::ptrdiff_t(i) + 3);
    std::unique_ptr<OIIO::ImageOutput> file = OIIO::ImageOutput::create(path);
    if (!file) return OIIO::geterror();
    OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::HALF);
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "2000:01:01 00:00:00");  // else the file would be another every day
    if (!file->open(path, spec) || !file->write_image(OIIO::TypeDesc::FLOAT, texels.data()) || !file->close())
        return file->geterror();
    return {};
}

}  // namespace textures
