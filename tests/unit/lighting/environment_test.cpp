// What an environment becomes: coefficients against integrals in closed form, the cube and its levels against integrals
// worked out here, and the table of the split sum against the reference values.
#include "runtime/lighting/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "runtime/lighting/cube.h"
#include "runtime/lighting/prefilter.h"
#include "runtime/lighting/split_sum.h"
#include "runtime/lighting/studio.h"
#include "tests/terms/reference_values.h"

namespace patina::runtime {
namespace {

constexpr double kPi = std::numbers::pi;

// --- cubes

// The place of a direction by the table in Vulkan's "Cube Map Face Selection": face, s and t.
struct FacePoint {
    int face;
    float s, t;
};
FacePoint place_of(glm::vec3 d) {
    const glm::vec3 length = glm::abs(d);
    int axis = length.z >= length.x && length.z >= length.y ? 2 : length.y >= length.x ? 1 : 0;
    const bool is_negative = d[axis] < 0;
    const float x = is_negative ? -1.0f : 1.0f;
    const glm::vec2 places[3] = {{-x * d.z, -d.y}, {d.x, x * d.z}, {x * d.x, -d.y}};
    const glm::vec2 at = places[axis] / length[axis] * 0.5f + 0.5f;
    return {2 * axis + (is_negative ? 1 : 0), at.x, at.y};
}

TEST(Cube, ATexelsDirectionLeadsBackToIt) {
    constexpr int kSize = 8;
    for (int face = 0; face < 6; ++face) {
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                const glm::vec3 direction = cube_direction(face, x, y, kSize);
                EXPECT_NEAR(glm::length(direction), 1, 1e-6);
                const FacePoint place = place_of(direction);
                EXPECT_EQ(place.face, face);
                EXPECT_NEAR(place.s, (float(x) + 0.5f) / kSize, 1e-6);
                EXPECT_NEAR(place.t, (float(y) + 0.5f) / kSize, 1e-6);
            }
        }
    }
}

// Sums over the texels of a cube: of their solid angles, and of these times each square of a component.
struct Sums {
    double all = 0;
    glm::dvec3 directions{0}, squares{0};
};
Sums sums(int size) {
    Sums sum;
    for (int face = 0; face < 6; ++face) {
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const double angle = double(cube_solid_angle(x, y, size));
                const glm::dvec3 d(cube_direction(face, x, y, size));
                sum.all += angle;
                sum.directions += angle * d;
                sum.squares += angle * d * d;
            }
        }
    }
    return sum;
}

TEST(Cube, SolidAnglesCoverTheSphere) {
    const Sums fine = sums(32), coarse = sums(16);
    EXPECT_NEAR(fine.all, 4 * kPi, 4 * kPi * 1e-3);
    // The error is of the second order in a texel's size.
    EXPECT_NEAR((coarse.all - 4 * kPi) / (fine.all - 4 * kPi), 4, 0.1);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(fine.directions[i], 0, 1e-4);
        EXPECT_NEAR(fine.squares[i], 4 * kPi / 3, 4 * kPi / 3 * 1e-3);
    }
}

// --- spherical harmonics

void expect_coefficients(const std::function<float(glm::vec3)>& radiance, const std::array<double, 9>& expected) {
    const Environment environment([&](glm::vec3 d) { return radiance(d) * glm::vec3(1, 0.5f, 0); }, 64);
    for (std::size_t i = 0; i < 9; ++i) {
        const glm::vec3 c = environment.ambient().coefficients[i];
        EXPECT_NEAR(c.r, expected[i], 2e-3) << i;
        EXPECT_NEAR(c.g, expected[i] / 2, 1e-3) << i;
        EXPECT_EQ(c.b, 0) << i;
    }
}

TEST(Harmonics, ProjectionsInClosedForm) {
    const double root_pi = std::sqrt(kPi), k1 = std::sqrt(3 / (4 * kPi));
    expect_coefficients([](glm::vec3) { return 1.0f; }, {2 * root_pi});
    // A hemisphere of light about each axis: 2 pi Y_0 / 2, and K1 times the integral of a cosine, pi.
    expect_coefficients([](glm::vec3 d) { return d.y > 0 ? 1.0f : 0.0f; }, {root_pi, k1 * kPi});
    expect_coefficients([](glm::vec3 d) { return d.z > 0 ? 1.0f : 0.0f; }, {root_pi, 0, k1 * kPi});
    expect_coefficients([](glm::vec3 d) { return d.x > 0 ? 1.0f : 0.0f; }, {root_pi, 0, 0, k1 * kPi});
    expect_coefficients([](glm::vec3 d) { return std::max(d.z, 0.0f); },
                        {root_pi / 2, 0, std::sqrt(kPi / 3), 0, 0, 0, std::sqrt(5 * kPi) / 8});
    expect_coefficients([](glm::vec3 d) { return d.z * d.z; },
                        {2 * root_pi / 3, 0, 0, 0, 0, 0, 2.0 / 3 * std::sqrt(4 * kPi / 5)});
    // The squares of xy, yz and xz integrate to 4 pi / 15, that of x^2 - y^2 to 16 pi / 15.
    const double k2 = std::sqrt(15 / (4 * kPi)), k4 = k2 / 2;
    expect_coefficients([](glm::vec3 d) { return d.x * d.y; }, {0, 0, 0, 0, k2 * 4 * kPi / 15});
    expect_coefficients([](glm::vec3 d) { return d.y * d.z; }, {0, 0, 0, 0, 0, k2 * 4 * kPi / 15});
    expect_coefficients([](glm::vec3 d) { return d.x * d.z; }, {0, 0, 0, 0, 0, 0, 0, k2 * 4 * kPi / 15});
    expect_coefficients([](glm::vec3 d) { return d.x * d.x - d.y * d.y; },
                        {0, 0, 0, 0, 0, 0, 0, 0, k4 * 16 * kPi / 15});
}

// The irradiance of a hemisphere of light is pi / 2 (1 + cosine), exactly.
TEST(Harmonics, AHemisphereOfLight) {
    const Environment environment([](glm::vec3 d) { return glm::vec3(d.y > 0 ? 1.0f : 0.0f); }, 64);
    const double convolved[3] = {kPi, 2 * kPi / 3, kPi / 4};
    for (const glm::vec3 normal :
         {glm::vec3(0, 1, 0), glm::vec3(1, 0, 0), glm::vec3(0, -1, 0), glm::vec3(0, 0.6f, 0.8f)}) {
        const std::array<float, 9> basis = spherical_harmonics_basis(normal);
        double irradiance = 0;
        for (std::size_t i = 0; i < 9; ++i)
            irradiance += convolved[i == 0  ? 0
                                    : i < 4 ? 1
                                            : 2] *
                          double(basis[i] * environment.ambient().coefficients[i].g);
        EXPECT_NEAR(irradiance, kPi / 2 * (1 + double(normal.y)), 3e-3);
    }
}

TEST(Harmonics, AConstantAndAGradient) {
    EXPECT_NEAR(evaluate(constant_ambient({0.25f, 0.5f, 1}), {0.6f, 0, -0.8f}).g, 0.5, 1e-6);
    const glm::vec3 sky(0.1f, 0.5f, 1), horizon(0.4f), ground(0.2f, 0.1f, 0);
    const SphericalHarmonics gradient = gradient_ambient(sky, horizon, ground);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(evaluate(gradient, {0, 1, 0})[c], sky[c], 1e-6);
        EXPECT_NEAR(evaluate(gradient, {0.8f, 0, -0.6f})[c], horizon[c], 1e-6);
        EXPECT_NEAR(evaluate(gradient, {0, -1, 0})[c], ground[c], 1e-6);
    }
}

// --- levels

const TextureLevel& level_of(const Environment& environment, int level) {
    return environment.map()->levels.at(static_cast<std::size_t>(level));
}
glm::vec3 texel(const TextureLevel& level, int face, int x, int y) {
    const float* at = level.texels.data() + 4 * ((face * level.height + y) * level.width + x);
    return {at[0], at[1], at[2]};
}

// Light from one direction alone gives, in nine coefficients, the irradiance 1/4pi (0.375 + 2 c + 1.875 c^2) for a
// normal with the cosine c to it: less than none where c is near -0.5.
TEST(Harmonics, ALampLeavesNoBlackSpot) {
    const glm::vec3 to_lamp = glm::normalize(glm::vec3(1, 2, -0.5f));
    SphericalHarmonics lamp = constant_ambient(glm::vec3(0));
    const std::array<float, 9> basis = spherical_harmonics_basis(to_lamp);
    for (std::size_t i = 0; i < basis.size(); i++) lamp.coefficients[i] = glm::vec3(basis[i]);
    const auto range_of = [](const SphericalHarmonics& light) {
        const PackedIrradiance packed = packed_irradiance(light);
        double low = 1e9, high = -1e9;
        for (int face = 0; face < 6; ++face) {
            for (int i = 0; i < 48 * 48; ++i) {
                const glm::vec3 n = cube_direction(face, i % 48, i / 48, 48);
                const double value =
                    double(glm::dot(packed.linear[0], glm::vec4(n, 1)) +
                           glm::dot(packed.quadratic[0], glm::vec4(n.x * n.y, n.y * n.z, n.z * n.z, n.z * n.x)) +
                           packed.last.r * (n.x * n.x - n.y * n.y));
                low = std::min(low, value), high = std::max(high, value);
            }
        }
        return std::pair(low, high);
    };
    EXPECT_NEAR(range_of(lamp).first, -0.15833 / (4 * kPi), 1e-4);
    const SphericalHarmonics smooth = without_negative_light(lamp);
    const auto [low, high] = range_of(smooth);
    EXPECT_NEAR(low / high, 0, 1e-3);
    // 1 + a c + b (3 c^2 - 1) with a = 2 / (1 + 4 w) and b = 0.625 / (1 + 36 w) is least at c = -1, and 0 there if
    // w = 0.1783: then it is 2.337 towards the lamp.
    EXPECT_NEAR(high, 2.337 / (4 * kPi), 1e-3);
    EXPECT_EQ(smooth.coefficients[0], lamp.coefficients[0]);
    // Light that has no such spot stays as it is.
    const SphericalHarmonics sky = gradient_ambient({0.4f, 0.5f, 0.7f}, glm::vec3(0.3f), glm::vec3(0.1f));
    EXPECT_EQ(without_negative_light(sky).coefficients, sky.coefficients);
    EXPECT_EQ(without_negative_light({}).coefficients, SphericalHarmonics{}.coefficients);
}

TEST(Levels, HalveInSize) {
    const Environment environment([](glm::vec3) { return glm::vec3(1); }, 64);
    EXPECT_EQ(environment.map()->layers, 6);
    ASSERT_EQ(environment.map()->levels.size(), std::size_t(kEnvironmentLevels));
    for (int i = 0; i < kEnvironmentLevels; ++i) {
        EXPECT_EQ(level_of(environment, i).width, 64 >> i);
        EXPECT_EQ(level_of(environment, i).height, 64 >> i);
        EXPECT_EQ(level_of(environment, i).texels.size(), std::size_t(4 * 6 * (64 >> i) * (64 >> i)));
    }
}

TEST(Levels, EvenLightStaysAsItIs) {
    const glm::vec3 light(0.25f, 1, 7);
    const Environment environment([&](glm::vec3) { return light; }, 64);
    for (const TextureLevel& level : environment.map()->levels) {
        for (std::size_t i = 0; i < level.texels.size(); i += 4) {
            for (int c = 0; c < 3; ++c) ASSERT_NEAR(level.texels[i + std::size_t(c)], light[c], 1e-5f * light[c]);
            ASSERT_EQ(level.texels[i + 3], 1);
        }
    }
}

TEST(Levels, TheFirstIsAMirror) {
    const auto radiance = [](glm::vec3 d) { return glm::vec3(std::sin(9 * d.x), std::cos(7 * d.y), d.z * d.x); };
    const Environment environment(radiance, 64);
    for (int face = 0; face < 6; ++face) {
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 64; ++x) {
                const glm::vec3 expected = radiance(cube_direction(face, x, y, 64));
                EXPECT_LT(glm::length(texel(level_of(environment, 0), face, x, y) - expected), 1e-5f);
            }
        }
    }
}

// Of light a + b d.z a surface that looks at it along its normal n reflects a + b m n.z, with m the mean of n.l under
// the weights D (n.h) (n.l) / (4 v.h), that is, over u from 0 to 1: n.l = 2 cos^2 - 1, cos^2 = (1 - u) / (1 + (a^2 - 1)
// u).
double mean_cosine(double alpha) {
    double sum = 0, weights = 0;
    constexpr int kSteps = 100000;
    for (int i = 0; i < kSteps; ++i) {
        const double u = (i + 0.5) / kSteps;
        const double cosine = 2 * (1 - u) / (1 + (alpha * alpha - 1) * u) - 1;
        if (cosine <= 0) continue;
        sum += cosine * cosine;
        weights += cosine;
    }
    return sum / weights;
}

// Irradiance over pi, by a sum over a fine cube.
glm::vec3 cosine_mean(const Radiance& radiance, glm::vec3 n) {
    constexpr int kSize = 48;
    glm::vec3 sum(0);
    for (int face = 0; face < 6; ++face) {
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                const glm::vec3 l = cube_direction(face, x, y, kSize);
                const float cosine = std::max(glm::dot(n, l), 0.0f);
                sum += radiance(l) * (cosine * cube_solid_angle(x, y, kSize));
            }
        }
    }
    return sum / std::acos(-1.0f);
}

// The levels that are computed when Patina is built are those of the studio, at their places.
TEST(Levels, TheStudiosAreKept) {
    const auto kept = studio_environment()->map(), computed = Environment(studio_radiance, kStudioSize).map();
    ASSERT_EQ(kept->levels.size(), computed->levels.size());
    for (std::size_t level = 0; level < computed->levels.size(); ++level) {
        const std::vector<float>&texels = kept->levels[level].texels, &wanted = computed->levels[level].texels;
        ASSERT_EQ(texels.size(), wanted.size()) << level;
        float off = 0;
        for (std::size_t i = 0; i < wanted.size(); ++i) off = std::max(off, std::abs(texels[i] - wanted[i]));
        EXPECT_LE(off, 1e-6f) << level;
    }
}

// With alpha 1 all mirrored directions are equally likely, so that the mean weighted by n.l is the irradiance over pi.
// Each texel is that to 2 % of the studio's mean radiance. Where four texels meet, filtering adds its own error, which
// is what four exact values would have there: the level is fine enough if that is as small.
TEST(Levels, RoughSurfacesSeeTheStudioWithoutFacets) {
    const Environment& studio = *studio_environment();
    const TextureLevel& last = level_of(studio, kEnvironmentLevels - 1);
    const int size = last.width;
    const float mean = studio.ambient().coefficients[0].g * 0.28209479f;
    float texel_error = 0, filter_error = 0;
    for (int face = 0; face < 6; ++face) {
        for (int y = 0; y + 1 < size; y += 2) {
            for (int x = 0; x + 1 < size; x += 2) {
                const glm::vec3 n = glm::normalize(cube_direction(face, 2 * x + 1, 2 * y + 1, 2 * size) +
                                                   cube_direction(face, 2 * x + 2, 2 * y + 2, 2 * size));
                glm::vec3 exact(0);
                for (const auto& [column, row] : {std::pair(x, y), {x + 1, y}, {x, y + 1}, {x + 1, y + 1}}) {
                    const glm::vec3 value = cosine_mean(studio_radiance, cube_direction(face, column, row, size));
                    const glm::vec3 off = glm::abs(texel(last, face, column, row) - value);
                    texel_error = std::max({texel_error, off.r, off.g, off.b});
                    exact += value / 4.0f;
                }
                const glm::vec3 off = glm::abs(exact - cosine_mean(studio_radiance, n));
                filter_error = std::max({filter_error, off.r, off.g, off.b});
            }
        }
    }
    std::printf("mean radiance %.3f, texels off by %.4f, filtering by %.4f\n", double(mean), double(texel_error),
                double(filter_error));
    EXPECT_LE(texel_error, 0.02f * mean);
    EXPECT_LE(filter_error, 0.02f * mean);
}

TEST(Levels, BlurAsGgxDoes) {
    // A rough surface's mean is known in closed form: of alpha 1 n.l has the weights of n.l itself, and m = 2 / 3.
    EXPECT_NEAR(mean_cosine(1), 2.0 / 3, 1e-6);
    const Environment environment([](glm::vec3 d) { return glm::vec3(2 + d.z, 2 - d.y, 3 + 2 * d.x); }, 256);
    for (int i = 1; i < kEnvironmentLevels; ++i) {
        const double roughness = double(roughness_of_level(i)), m = mean_cosine(roughness * roughness);
        const TextureLevel& level = level_of(environment, i);
        for (int face = 0; face < 6; ++face) {
            for (int y = 0; y < level.height; ++y) {
                for (int x = 0; x < level.width; ++x) {
                    const glm::vec3 n = cube_direction(face, x, y, level.width), seen = texel(level, face, x, y);
                    EXPECT_NEAR(seen.r, 2 + m * double(n.z), 5e-3) << i;
                    EXPECT_NEAR(seen.g, 2 - m * double(n.y), 5e-3) << i;
                    EXPECT_NEAR(seen.b, 3 + 2 * m * double(n.x), 1e-2) << i;
                }
            }
        }
    }
}

TEST(Levels, AreThoseThatMipFromRoughnessReads) {
    const Compiler compiler;
    EXPECT_EQ(roughness_of_level(0), 0);
    EXPECT_NEAR(roughness_of_level(kEnvironmentLevels - 1), 1, 1e-6);
    for (int i = 0; i < kEnvironmentLevels; ++i) {
        const std::pair<std::string, std::string> given[] = {{"roughness", std::to_string(roughness_of_level(i))},
                                                             {"steps", std::to_string(kEnvironmentLevels - 1)}};
        const EvalResult level = compiler.evaluate("MipFromRoughness", given);
        ASSERT_TRUE(level.ok);
        EXPECT_NEAR(level.outputs[0].values[0], i, 1e-5);
    }
}

// --- the split sum

// Reference values of GGX with Smith's exact joint visibility: {roughness, n.v} -> {scale, offset}.
struct Entry {
    double roughness, ndotv, scale, offset;
};
std::vector<Entry> entries() {
    std::vector<Entry> result;
    for (const reference::Json& row : reference::rows().GetArray()) {
        if (std::string_view(row["term"].GetString()) != "DFG_AB_smith_joint_exact") continue;
        const auto& in = row["inputs"];
        const auto& out = row["expected"];
        result.push_back({in["roughness"].GetDouble(), in["NoV"].GetDouble(), out[0].GetDouble(), out[1].GetDouble()});
    }
    return result;
}

TEST(SplitSum, EqualsTheReferenceValues) {
    EXPECT_EQ(entries().size(), 74u);
    for (const Entry& entry : entries()) {
        const auto [scale, offset] = split_sum(entry.roughness * entry.roughness, entry.ndotv, 32);
        EXPECT_NEAR(scale, entry.scale, 1e-3) << entry.roughness << ", " << entry.ndotv;
        EXPECT_NEAR(offset, entry.offset, 1e-3) << entry.roughness << ", " << entry.ndotv;
    }
    // A mirror, and the roughest surface seen along its normal: 1 - ln 2.
    EXPECT_EQ(split_sum(0, 1, 32), (std::array{1.0, 0.0}));
    EXPECT_NEAR(split_sum(0, 0.5, 32)[1], 1.0 / 32, 1e-12);
    const auto [scale, offset] = split_sum(1, 1, 32);
    EXPECT_NEAR(scale + offset, 1 - std::numbers::ln2, 1e-3);
}

// Entry by entry, against the same integral with nine times as many points. Columns follow the root of n.v.
TEST(SplitSum, TheTableHoldsIt) {
    const auto table = split_sum_table();
    ASSERT_EQ(table->levels.size(), 1u);
    const TextureLevel& level = table->levels[0];
    ASSERT_EQ(level.width, 64);
    ASSERT_EQ(level.height, 64);
    for (int y = 0; y < 64; y += 3) {
        for (int x = 0; x < 64; x += 3) {
            const double roughness = y / 63.0, root = x / 63.0;
            const auto [scale, offset] = split_sum(roughness * roughness, root * root, 96);
            const glm::vec3 entry = texel(level, 0, x, y);
            EXPECT_NEAR(entry.r, scale, 1e-3) << "roughness " << roughness << ", n.v " << root * root;
            EXPECT_NEAR(entry.g, offset, 1e-3) << "roughness " << roughness << ", n.v " << root * root;
        }
    }
}

// As a material reads it.
TEST(SplitSum, TheTableBetweenItsEntries) {
    const TextureLevel& level = split_sum_table()->levels[0];
    for (const Entry& entry : entries()) {
        const double x = std::sqrt(entry.ndotv) * 63, y = entry.roughness * 63;
        const int left = std::min(int(x), 62), top = std::min(int(y), 62);
        const auto row = [&](int at) {
            return glm::mix(texel(level, 0, left, at), texel(level, 0, left + 1, at), float(x - left));
        };
        const glm::vec3 seen = glm::mix(row(top), row(top + 1), float(y - top));
        EXPECT_NEAR(seen.r, entry.scale, 3e-3) << entry.roughness << ", " << entry.ndotv;
        EXPECT_NEAR(seen.g, entry.offset, 3e-3) << entry.roughness << ", " << entry.ndotv;
    }
}

}  // namespace
}  // namespace patina::runtime
