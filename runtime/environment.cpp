#include "runtime/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/cube.h"

namespace patina::runtime {
namespace {

constexpr double kPi = std::numbers::pi;

// Normalisation of the basis: sqrt(1 / 4pi), sqrt(3 / 4pi), sqrt(15 / 4pi), sqrt(5 / 16pi), sqrt(15 / 16pi).
constexpr float kK0 = 0.28209479177387814f;
constexpr float kK1 = 0.48860251190291992f;
constexpr float kK2 = 1.0925484305920792f;
constexpr float kK3 = 0.31539156525252005f;
constexpr float kK4 = 0.5462742152960396f;

glm::vec3 evaluate(const SphericalHarmonics& sh, glm::vec3 direction) {
    std::array<float, 9> basis = spherical_harmonics_basis(direction);
    glm::vec3 sum(0);
    for (std::size_t i = 0; i < basis.size(); i++) sum += basis[i] * sh.coefficients[i];
    return glm::max(sum, glm::vec3(0));
}

// c_i = integral of L Y_i, over the texels of a cube with their solid angles, which are made to sum to 4 pi.
SphericalHarmonics project(const Radiance& radiance) {
    constexpr int kSize = 48;
    SphericalHarmonics result;
    double weight_sum = 0;
    for (int face = 0; face < 6; face++) {
        for (int y = 0; y < kSize; y++) {
            for (int x = 0; x < kSize; x++) {
                glm::vec3 direction = cube_direction(face, x, y, kSize);
                float weight = cube_solid_angle(x, y, kSize);
                weight_sum += weight;
                std::array<float, 9> basis = spherical_harmonics_basis(direction);
                glm::vec3 light = radiance(direction) * weight;
                for (std::size_t i = 0; i < basis.size(); i++) result.coefficients[i] += basis[i] * light;
            }
        }
    }
    for (glm::vec3& coefficient : result.coefficients) coefficient *= float(4 * kPi / weight_sum);
    return result;
}

// Van der Corput's sequence in base 2.
double radical_inverse(std::uint32_t bits) {
    bits = (bits << 16) | (bits >> 16);
    bits = ((bits & 0x55555555u) << 1) | ((bits & 0xAAAAAAAAu) >> 1);
    bits = ((bits & 0x33333333u) << 2) | ((bits & 0xCCCCCCCCu) >> 2);
    bits = ((bits & 0x0F0F0F0Fu) << 4) | ((bits & 0xF0F0F0F0u) >> 4);
    bits = ((bits & 0x00FF00FFu) << 8) | ((bits & 0xFF00FF00u) >> 8);
    return bits * (1.0 / 4294967296.0);
}

// Directions around +z in which a surface of that roughness, looked at along its normal, mirrors, and n.l of each.
std::vector<glm::vec3> mirrored_directions(float roughness, int count) {
    double a2 = std::pow(double(roughness), 4);
    std::vector<glm::vec3> result;
    for (int i = 0; i < count; i++) {
        double u = (i + 0.5) / count, phi = 2 * kPi * radical_inverse(std::uint32_t(i));
        double cos2 = (1 - u) / (1 + (a2 - 1) * u), sin2 = std::max(1 - cos2, 0.0);
        // l = 2 (v.h) h - v with v = (0, 0, 1)
        double along = 2 * cos2 - 1, across = 2 * std::sqrt(cos2 * sin2);
        if (along > 0) result.emplace_back(across * std::cos(phi), across * std::sin(phi), along);
    }
    return result;
}

// The mean of what is mirrored, weighted by n.l (Karis, SIGGRAPH 2013), for a view along the normal.
TextureLevel blurred(const Radiance& radiance, int level, int size) {
    std::vector<glm::vec3> around = {{0, 0, 1}};
    // Coarser levels have fewer texels, each of which looks at more of the surroundings.
    if (level > 0) around = mirrored_directions(roughness_of_level(level), std::min(16 << 2 * level, 1024));
    TextureLevel result{.width = size, .height = size, .texels = {}};
    for (int face = 0; face < 6; face++) {
        for (int y = 0; y < size; y++) {
            for (int x = 0; x < size; x++) {
                glm::vec3 normal = cube_direction(face, x, y, size);
                glm::vec3 helper = std::abs(normal.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
                glm::vec3 tangent = glm::normalize(glm::cross(helper, normal)), bitangent = glm::cross(normal, tangent);
                glm::vec3 sum(0);
                float weights = 0;
                for (glm::vec3 l : around) {
                    sum += radiance(tangent * l.x + bitangent * l.y + normal * l.z) * l.z;
                    weights += l.z;
                }
                sum /= weights;
                result.texels.insert(result.texels.end(), {sum.x, sum.y, sum.z, 1});
            }
        }
    }
    return result;
}

// --- the studio

// A window of light, seen from the middle of the room.
struct SoftBox {
    glm::vec3 forward, right, up;  // to its middle, and along its sides
    float width, height;           // half of each, at a distance of 1
    glm::vec3 light;               // radiance
};
constexpr float kSoftness = 0.12f;  // of a box's edge, at a distance of 1

SoftBox soft_box(glm::vec3 towards, float width, float height, glm::vec3 light) {
    glm::vec3 forward = glm::normalize(towards), right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), forward));
    return {forward, right, glm::cross(forward, right), width, height, light};
}

glm::vec3 box_light(const SoftBox& box, glm::vec3 direction) {
    float depth = glm::dot(direction, box.forward);
    if (depth <= 0.05f) return glm::vec3(0);
    auto inside = [&](float at, float half) {
        return 1 - glm::smoothstep(half - kSoftness / 2, half + kSoftness / 2, std::abs(at));
    };
    float across = inside(glm::dot(direction, box.right) / depth, box.width);
    if (across == 0) return glm::vec3(0);
    return box.light * (across * inside(glm::dot(direction, box.up) / depth, box.height));
}

glm::vec3 studio_radiance(glm::vec3 direction) {
    static const SoftBox kBoxes[] = {
        soft_box({-0.75f, 0.75f, 0.7f}, 0.42f, 0.42f, {2.6f, 2.5f, 2.35f}),
        soft_box({1, 0.15f, 0.35f}, 0.16f, 0.55f, {0.85f, 1.0f, 1.25f}),
        soft_box({0.5f, 0.55f, -0.9f}, 0.6f, 0.14f, {1.9f, 1.9f, 1.9f}),
    };
    const glm::vec3 sky(0.26f, 0.29f, 0.34f), horizon(0.11f, 0.11f, 0.115f), ground(0.05f, 0.046f, 0.042f);
    float up = direction.y;
    glm::vec3 sum = up > 0 ? glm::mix(horizon, sky, std::sqrt(up)) : glm::mix(horizon, ground, std::sqrt(-up));
    for (const SoftBox& box : kBoxes) sum += box_light(box, direction);
    return sum;
}

}  // namespace

std::array<float, 9> spherical_harmonics_basis(glm::vec3 d) {
    return {kK0,
            kK1 * d.y,
            kK1 * d.z,
            kK1 * d.x,
            kK2 * d.x * d.y,
            kK2 * d.y * d.z,
            kK3 * (3 * d.z * d.z - 1),
            kK2 * d.x * d.z,
            kK4 * (d.x * d.x - d.y * d.y)};
}

SphericalHarmonics constant_ambient(glm::vec3 radiance) {
    SphericalHarmonics result;
    result.coefficients[0] = radiance / kK0;
    return result;
}

SphericalHarmonics gradient_ambient(glm::vec3 sky, glm::vec3 horizon, glm::vec3 ground) {
    // On the unit sphere y^2 = 1/3 - (3z^2 - 1)/6 - (x^2 - y^2)/2: each term is one basis function.
    glm::vec3 linear = (sky - ground) / 2.0f;
    glm::vec3 square = (sky + ground) / 2.0f - horizon;
    SphericalHarmonics result;
    result.coefficients[0] = (horizon + square / 3.0f) / kK0;
    result.coefficients[1] = linear / kK1;
    result.coefficients[6] = square * (-1.0f / 6) / kK3;
    result.coefficients[8] = square * (-1.0f / 2) / kK4;
    return result;
}

float roughness_of_level(int level) {
    // The root of r (1.7 - 0.7 r) = level / (levels - 1).
    float share = float(level) / float(kEnvironmentLevels - 1);
    return (1.7f - std::sqrt(1.7f * 1.7f - 4 * 0.7f * share)) / 1.4f;
}

Environment::Environment(Radiance radiance, int face_size)
    : radiance_(std::move(radiance)), face_size_(face_size), ambient_(project(radiance_)) {}

Environment::Environment(const SphericalHarmonics& ambient)
    : radiance_([ambient](glm::vec3 direction) { return evaluate(ambient, direction); }),
      face_size_(64),
      ambient_(ambient) {}

std::shared_ptr<const TextureData> Environment::map() const {
    std::call_once(made_, [this] {
        TextureData data{.levels = {}, .sampler = {.wrap = "clamp", .filter = "linear", .anisotropy = 1}, .faces = 6};
        for (int level = 0; level < kEnvironmentLevels; level++)
            data.levels.push_back(blurred(radiance_, level, std::max(face_size_ >> level, 1)));
        map_ = std::make_shared<const TextureData>(std::move(data));
    });
    return map_;
}

std::shared_ptr<const Environment> studio_environment() {
    static const auto kStudio = std::make_shared<const Environment>(studio_radiance, 128);
    return kStudio;
}

namespace {

// A point of [0, 1] moved towards both ends, and by how much the steps shrink there. What is integrated, root or slope
// at an end and all, then ends flat up to its second derivative, for which the midpoint rule is of the fourth order.
struct Crowded {
    double at, step;
};
Crowded crowded(int index, int count) {
    double s = (index + 0.5) / count;
    return {s * s * s * (10 + s * (6 * s - 15)), 30 * s * s * (1 - s) * (1 - s) / count};
}

}  // namespace

std::array<double, 2> split_sum(double alpha, double ndotv, int samples) {
    // A mirror has one half vector: its F is the offset.
    double grazing = std::pow(1 - ndotv, 5);
    if (alpha < 1e-4) return {1 - grazing, grazing};
    // Half vectors in polar coordinates, tan(angle) = alpha sinh(x), in which GGX times its solid angle is smooth. The
    // light is above the surface all around up to the first angle, and nowhere from the second on.
    double a2 = alpha * alpha, view_angle = std::acos(ndotv), view_sine = std::sin(view_angle);
    double view_root = std::sqrt(ndotv * ndotv * (1 - a2) + a2);
    double highest = std::min(kPi / 4 + view_angle / 2, kPi / 2 - 1e-9);
    std::array<double, 3> ends = {0, std::asinh(std::tan(kPi / 4 - view_angle / 2) / alpha),
                                  std::asinh(std::tan(highest) / alpha)};
    double scale = 0, offset = 0;
    int around = std::max(1, samples / 2);  // the other half mirrors this one
    for (std::size_t part = 0; part < 2; part++) {
        for (int i = 0; i < samples; i++) {
            double length = ends[part + 1] - ends[part];
            double x = ends[part] + length * crowded(i, samples).at;
            double tangent = alpha * std::sinh(x), ndoth = 1 / std::sqrt(1 + tangent * tangent), sine = tangent * ndoth;
            double share = 2 * std::sinh(x) / std::pow(std::cosh(x), 3) * length * crowded(i, samples).step / kPi;
            double edge = (ndotv / (2 * ndoth) - ndotv * ndoth) / std::max(view_sine * sine, 1e-12);
            double last = std::acos(std::clamp(edge, -1.0, 1.0));
            for (int k = 0; k < around; k++) {
                double phi = last * crowded(k, around).at;
                double vdoth = view_sine * sine * std::cos(phi) + ndotv * ndoth, ndotl = 2 * vdoth * ndoth - ndotv;
                if (ndotl <= 0 || vdoth <= 0) continue;
                // w = 4 V (n.l) (v.h) / (n.h), with Smith's exact joint V.
                double light_root = std::sqrt(ndotl * ndotl * (1 - a2) + a2);
                double weight = 2 * ndotl * vdoth / (ndoth * (ndotl * view_root + ndotv * light_root));
                weight *= share * last * crowded(k, around).step;
                double fresnel = std::pow(1 - vdoth, 5);
                scale += (1 - fresnel) * weight;
                offset += fresnel * weight;
            }
        }
    }
    return {scale, offset};
}

std::shared_ptr<const TextureData> split_sum_table() {
    static const auto kTable = [] {
        constexpr int kSize = 64, kSamples = 24;
        TextureLevel level{.width = kSize, .height = kSize, .texels = {}};
        for (int y = 0; y < kSize; y++) {
            double roughness = double(y) / (kSize - 1);
            for (int x = 0; x < kSize; x++) {
                double root = double(x) / (kSize - 1);
                auto [scale, offset] = split_sum(roughness * roughness, root * root, kSamples);
                level.texels.insert(level.texels.end(), {float(scale), float(offset), 0, 1});
            }
        }
        TextureData data{.levels = {std::move(level)},
                         .sampler = {.wrap = "clamp", .filter = "linear", .anisotropy = 1},
                         .faces = 1};
        return std::make_shared<const TextureData>(std::move(data));
    }();
    return kTable;
}

}  // namespace patina::runtime
