// Light from all around, against integrals that are worked out here: diffuse light by nine coefficients, prefiltered
// reflections, and the white furnace through the whole renderer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>

#include "runtime/lighting/cube.h"
#include "runtime/lighting/harmonics.h"
#include "runtime/lighting/prefilter.h"
#include "runtime/render/render_request.h"

namespace patina::proof {
namespace {

using runtime::Radiance;
constexpr double kPi = std::numbers::pi;

struct Surroundings {
    const char* name;
    Radiance radiance;
};

// An overcast sky (Moon and Spencer 1942) over dark ground; a sunset, with a broad glow; a room with a window and a
// lamp.
std::vector<Surroundings> surroundings() {
    const auto glow = [](glm::vec3 d, glm::vec3 to, float sharpness) {
        return std::exp(sharpness * (glm::dot(d, glm::normalize(to)) - 1));
    };
    return {
        {"overcast", [](glm::vec3 d) { return glm::vec3(d.y > 0 ? (1 + 2 * d.y) / 3 : 0.1f); }},
        {"sunset",
         [=](glm::vec3 d) {
             const glm::vec3 sky = glm::mix(glm::vec3(0.5f, 0.4f, 0.35f), glm::vec3(0.2f, 0.3f, 0.6f), 0.5f + d.y / 2);
             return sky + glm::vec3(3, 1.5f, 0.6f) * glow(d, {1, 0.2f, -0.5f}, 4);
         }},
        {"room",
         [=](glm::vec3 d) {
             return glm::vec3(0.3f, 0.28f, 0.25f) + glm::vec3(1.2f, 1.4f, 1.6f) * glow(d, {-1, 0.3f, 0.4f}, 5) +
                    glm::vec3(0.8f, 0.6f, 0.3f) * glow(d, {0.3f, 1, 0.3f}, 3);
         }},
    };
}

glm::vec3 direction_at(double cosine, double azimuth) {
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    return {float(sine * std::cos(azimuth)), float(cosine), float(sine * std::sin(azimuth))};
}

// On a grid of equal areas: cosines from the axis, and azimuths.
std::vector<glm::vec3> sphere_grid(int rows, int columns) {
    std::vector<glm::vec3> grid;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            grid.push_back(direction_at(1 - 2 * (row + 0.5) / rows, 2 * kPi * (column + 0.5) / columns));
    return grid;
}

// Irradiance over pi by summing all directions.
glm::dvec3 irradiance(const Radiance& radiance, glm::vec3 normal, const std::vector<glm::vec3>& grid) {
    glm::dvec3 sum(0);
    for (const glm::vec3& l : grid)
        if (const float cosine = glm::dot(l, normal); cosine > 0) sum += glm::dvec3(radiance(l) * cosine);
    return sum * (4 / double(grid.size()));
}

// As Unity's ShadeSH9 computes it.
glm::dvec3 packed_light(const runtime::PackedIrradiance& packed, glm::vec3 n) {
    glm::dvec3 light;
    for (int c = 0; c < 3; ++c) {
        const std::size_t i = std::size_t(c);
        light[c] = double(glm::dot(packed.linear[i], glm::vec4(n, 1)) +
                          glm::dot(packed.quadratic[i], glm::vec4(n.x * n.y, n.y * n.z, n.z * n.z, n.z * n.x)) +
                          packed.last[c] * (n.x * n.x - n.y * n.y));
    }
    return light;
}

// The error of nine coefficients, and of the packed vectors, is on average 1 % of the mean (Ramamoorthi and Hanrahan
// 2001, section 3, say the same of their environments).
TEST(Surroundings, NineCoefficientsGiveDiffuseLight) {
    const std::vector<glm::vec3> grid = sphere_grid(200, 400), normals = sphere_grid(12, 16);
    for (const Surroundings& each : surroundings()) {
        const runtime::SphericalHarmonics light = runtime::project(each.radiance);
        const runtime::PackedIrradiance packed = runtime::packed_irradiance(light);
        const runtime::PackedIrradiance mirrored = runtime::packed_irradiance(runtime::with_z_reversed(light));
        double mean = 0, error = 0;
        for (const glm::vec3& n : normals) {
            const glm::dvec3 exact = irradiance(each.radiance, n, grid), seen = packed_light(packed, n);
            const glm::dvec3 off = glm::abs(seen - exact);
            mean += (exact.x + exact.y + exact.z) / 3;
            error += (off.x + off.y + off.z) / 3;
            EXPECT_LT(glm::length(packed_light(mirrored, {n.x, n.y, -n.z}) - seen), 1e-5);
        }
        std::printf("%s: %.2f %% of the mean\n", each.name, 100 * error / mean);
        EXPECT_LT(error / mean, 0.01) << each.name;
    }
}

// What a surface reflects that is looked at along its normal, by Monte Carlo: half vectors that are distributed as D
// n.h (Walter et al., EGSR 2007, equations 35 and 36), weighted by n.l.
glm::dvec3 reflected(const Radiance& radiance, glm::vec3 n, double alpha, int count, std::mt19937& random) {
    std::uniform_real_distribution<double> uniform;
    const glm::dvec3 normal(n), helper = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 t = glm::normalize(glm::cross(helper, normal)), b = glm::cross(normal, t);
    glm::dvec3 sum(0);
    double weights = 0;
    for (int i = 0; i < count; ++i) {
        const double u = uniform(random), azimuth = 2 * kPi * uniform(random);
        const double tangent2 = alpha * alpha * u / (1 - u), cosine = 1 / std::sqrt(1 + tangent2);
        const double sine = std::sqrt(1 - cosine * cosine);
        const glm::dvec3 h = sine * std::cos(azimuth) * t + sine * std::sin(azimuth) * b + cosine * normal;
        const glm::dvec3 l = 2 * cosine * h - normal;
        const double weight = glm::dot(l, normal);
        if (weight <= 0) continue;
        sum += weight * glm::dvec3(radiance(glm::vec3(l)));
        weights += weight;
    }
    return sum / weights;
}

TEST(Surroundings, PrefilteredReflectionsAreThoseOfMonteCarlo) {
    struct Case {
        float roughness;
        int size;  // as the level that is next to it
    };
    std::mt19937 random(11);
    for (const Surroundings& each : surroundings()) {
        const runtime::Pyramid pyramid(each.radiance, 256);
        const glm::vec3 mean = runtime::project(each.radiance).coefficients[0] * 0.28209479f;
        for (const Case& c : {Case{0.1f, 128}, {0.3f, 64}, {0.6f, 16}, {1.0f, 8}}) {
            const TextureLevel level = runtime::blurred(pyramid, c.roughness, c.size);
            double largest = 0;
            for (int face = 0; face < 6; ++face) {
                for (int i = 0; i < 4; ++i) {
                    const int x = (i % 2 ? 5 : 2) * c.size / 8, y = (i / 2 ? 6 : 1) * c.size / 8;
                    const glm::dvec3 exact = reflected(each.radiance, runtime::cube_direction(face, x, y, c.size),
                                                       double(c.roughness) * double(c.roughness), 60000, random);
                    const float* texel = level.texels.data() + 4 * ((face * c.size + y) * c.size + x);
                    for (int k = 0; k < 3; ++k)
                        largest = std::max(largest, std::abs(double(texel[k]) - exact[k]) / double(mean[k]));
                }
            }
            std::printf("%s, roughness %.1f: at most %.2f %% of the mean\n", each.name, double(c.roughness),
                        100 * largest);
            EXPECT_LT(largest, 0.02) << each.name << " " << c.roughness;
        }
    }
}

// The same by summing all directions: by chance, a small lamp would hardly be met.
glm::dvec3 reflected(const std::vector<glm::vec3>& grid, const std::vector<glm::vec3>& radiances, glm::vec3 n,
                     double alpha) {
    glm::dvec3 sum(0);
    double weights = 0;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const glm::dvec3 l(grid[i]);
        const double cosine = glm::dot(l, glm::dvec3(n));
        if (cosine <= 0) continue;
        const double nh = glm::dot(glm::normalize(l + glm::dvec3(n)), glm::dvec3(n));
        const double root = nh * nh * (alpha * alpha - 1) + 1;  // of D (Walter et al., equation 33)
        const double weight = cosine / (root * root);
        sum += weight * glm::dvec3(radiances[i]);
        weights += weight;
    }
    return sum / weights;
}

// Lamps of two degrees, a thousand times as bright as the room: they are smooth spots on a rough surface.
TEST(Surroundings, SmallLampsLeaveNoGrain) {
    const float edge = float(std::cos(2 * kPi / 180));
    const std::vector<glm::vec3> lamps = {glm::normalize(glm::vec3(1, 0.7f, 0.2f)),
                                          glm::normalize(glm::vec3(-0.3f, 1, -1)),
                                          glm::normalize(glm::vec3(0.1f, -0.4f, 1))};
    const Radiance room = [&](glm::vec3 d) {
        const bool is_lamp =
            std::any_of(lamps.begin(), lamps.end(), [&](glm::vec3 to) { return glm::dot(d, to) > edge; });
        return is_lamp ? glm::vec3(300, 280, 250) : glm::vec3(0.3f, 0.28f, 0.25f);
    };
    const std::vector<glm::vec3> grid = sphere_grid(1000, 2000);
    std::vector<glm::vec3> radiances;
    for (const glm::vec3& d : grid) radiances.push_back(room(d));
    const runtime::Pyramid pyramid(room, 256, 8);
    for (const auto& [roughness, size] : {std::pair(0.12f, 128), {0.26f, 64}, {0.43f, 32}, {0.64f, 16}, {1.0f, 8}}) {
        const TextureLevel level = runtime::blurred(pyramid, roughness, size);
        double largest = 0;
        for (int i = 0; i < 24; ++i) {
            // All over the cube, and where the first lamp is.
            const runtime::CubePlace lamp = runtime::cube_place(lamps[0]);
            const int face = i < 20 ? i % 6 : lamp.face;
            const int x = i < 20 ? (7 * i + 3) % size : std::clamp(int(lamp.u * float(size)) + i % 2, 0, size - 1);
            const int y = i < 20 ? (11 * i + 5) % size : std::clamp(int(lamp.v * float(size)) + i / 2 % 2, 0, size - 1);
            const glm::dvec3 exact = reflected(grid, radiances, runtime::cube_direction(face, x, y, size),
                                               double(roughness) * double(roughness));
            const float* texel = level.texels.data() + 4 * ((face * size + y) * size + x);
            for (int k = 0; k < 3; ++k)
                largest = std::max(largest, std::abs(double(texel[k]) - exact[k]) / (0.3 + exact[k]));
        }
        std::printf("lamps, roughness %.2f: at most %.2f %%\n", double(roughness), 100 * largest);
        EXPECT_LT(largest, 0.02) << roughness;
    }
}

// A white object in light of 1 from everywhere is 1 at each of its pixels. Both workflows.
TEST(Surroundings, TheWhiteFurnaceOfTheRenderer) {
    std::string name = (std::filesystem::temp_directory_path() / "patina_furnace_XXXXXX").string();
    const std::filesystem::path folder = mkdtemp(name.data());
    const std::string graph = (folder / "white.graph.json").string();
    const Compiler compiler;
    runtime::RenderMachine machine;
    const auto check = [&](const std::string& workflow, const std::string& surface, const std::string& what) {
        std::ofstream(graph) << R"({"patina":1,"lighting":"energy-conserving","workflow":")" << workflow
                             << R"(","surface":{)" << surface << "}}";
        const runtime::RenderOutcome drawn = runtime::render(
            compiler,
            {.graph = graph, .size = 32, .samples = 1, .lights = {"none"}, .ambient = "1", .background = "none"},
            machine);
        ASSERT_TRUE(drawn.ok) << drawn.error;
        float low = 2, high = 0;
        int seen = 0;
        for (std::size_t i = 0; i < drawn.image.pixels.size(); i += 4) {
            const float* pixel = drawn.image.pixels.data() + i;
            if (pixel[3] < 1) continue;  // the background is transparent
            seen++;
            low = std::min({low, pixel[0], pixel[1], pixel[2]});
            high = std::max({high, pixel[0], pixel[1], pixel[2]});
        }
        EXPECT_GT(seen, 500) << what;
        std::printf("%s: %.4f to %.4f\n", what.c_str(), double(low), double(high));
        EXPECT_GT(low, 0.99f) << what;
        EXPECT_LT(high, 1.01f) << what;
    };
    for (const double roughness : {0.1, 0.5, 1.0}) {
        for (const double metallic : {0.0, 0.5, 1.0}) {
            const std::string f0 = std::to_string(0.04 * (1 - metallic) + metallic);
            const std::string what =
                "metallic " + std::to_string(metallic) + ", roughness " + std::to_string(roughness);
            check("metallic-roughness",
                  R"("baseColor":[1,1,1],"metallic":)" + std::to_string(metallic) + R"(,"roughness":)" +
                      std::to_string(roughness),
                  what);
            check("specular-glossiness",
                  R"("baseColor":)" + std::string(metallic < 1 ? "[1,1,1]" : "[0,0,0]") + R"(,"specular":[)" + f0 +
                      "," + f0 + "," + f0 + R"(],"glossiness":)" + std::to_string(1 - roughness),
                  what + ", specular");
        }
    }
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace patina::proof
