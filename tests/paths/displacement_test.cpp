// A mesh that its material moves, by the function of the example `swell`: place, normal and tangent in each pixel are
// those of the moved surface, whose formula is written down here and differentiated by differences.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "paths/drawing/drawing.h"

namespace patina::paths {
namespace {

constexpr int kPixels = 48;
constexpr double kWavelength = 6, kAmplitude = 0.15, kSteepness = 0.5, kSeconds = 0.75;
constexpr double kFar = -100;  // what no pixel of the surface has

// Finch, GPU Gems 1: four Gerstner waves.
glm::dvec3 moved(double x, double y) {
    constexpr std::array<glm::dvec2, 4> kDirections = {{{0.8, 0.6}, {0.96, -0.28}, {0.28, 0.96}, {0.6, -0.8}}};
    glm::dvec3 place(x, y, 0);
    double share = 1;
    for (const glm::dvec2& d : kDirections) {
        const double k = 2 * std::numbers::pi / (kWavelength * share), a = kAmplitude * share;
        const double phase = k * (d.x * x + d.y * y) - std::sqrt(9.81 * k) * kSeconds, q = kSteepness / (4 * k * a);
        place += glm::dvec3(q * a * d.x * std::cos(phase), q * a * d.y * std::cos(phase), a * std::sin(phase));
        share /= 2;
    }
    return place;
}

struct Moved {
    glm::dvec3 position, normal, tangent;
};
// Of the plane's mesh: x grows with u, y against v.
Moved in_world(const glm::dmat4& object_to_world, double u, double v) {
    constexpr double kStep = 1e-5;
    const double x = 2 * u - 1, y = 1 - 2 * v;
    const glm::dvec3 along_x = moved(x + kStep, y) - moved(x - kStep, y);
    const glm::dvec3 along_y = moved(x, y + kStep) - moved(x, y - kStep);
    const glm::dmat3 linear(object_to_world);
    // Tangents go by the matrix; the normal is square to both of them after that.
    return {.position = glm::dvec3(object_to_world * glm::dvec4(moved(x, y), 1)),
            .normal = glm::normalize(glm::cross(linear * along_x, linear * along_y)),
            .tangent = glm::normalize(linear * along_x)};
}

Image drawn(const std::string& shown, const glm::mat4& object_to_world, const char* via) {
    World world;
    world.view.width = world.view.height = kPixels;
    world.view.background = glm::vec4(float(kFar));
    world.view.time = float(kSeconds);
    world.view.camera = {.position = {0.5f, -4, 3}, .target = {0, 0, 0}, .fov = 40};
    const std::string graph =
        written("moved_" + shown.substr(1) + ".graph.json",
                fmt::format(R"json({{ "patina": 1, "workflow": "unlit", "nodes": [
  {{ "id": "waves", "node": "./swell.node.hlsl",
    "in": {{ "wavelength": {}, "amplitude": {}, "steepness": {} }} }}
], "vertex": {{ "positionOS": "waves", "normalOS": "waves.normal", "tangentOS": "waves.tangent" }},
"surface": {{ "color": "= float3({}{})" }} }})json",
                            kWavelength, kAmplitude, kSteepness, shown, shown == "@uv0" ? ", 0" : ""));
    add_object(world, graph, "plane", 128, object_to_world);
    return draw(world, {.via = via, .exact_targets = true, .include_dirs = {"examples/surfaces"}});
}

TEST(Displacement, MovesPlaceNormalAndTangentTogether) {
    const glm::mat4 cases[] = {
        glm::mat4(1), glm::scale(glm::rotate(glm::mat4(1), 0.6f, {0.2f, -0.4f, 1}), glm::vec3(0.7f, 1.2f, 1.5f))};
    for (const glm::mat4& object_to_world : cases) {
        for (const char* via : {"glsl", "hlsl", "cpu"}) {
            SCOPED_TRACE(via);
            const Image uv = drawn("@uv0", object_to_world, via);
            const Image position = drawn("@positionWS", object_to_world, via);
            const Image normal = drawn("@normalWS", object_to_world, via);
            const Image tangent = drawn("@tangentWS", object_to_world, via);
            int compared = 0;
            for (int y = 0; y < kPixels; ++y) {
                for (int x = 0; x < kPixels; ++x) {
                    if (uv.at(x, y)[0] < -1) continue;
                    ++compared;
                    const Moved wanted =
                        in_world(glm::dmat4(object_to_world), double(uv.at(x, y)[0]), double(uv.at(x, y)[1]));
                    for (int c = 0; c < 3; ++c) {
                        const auto i = std::size_t(c);
                        // The mesh is flat between its vertices, a 64th of a metre apart.
                        ASSERT_NEAR(double(position.at(x, y)[i]), wanted.position[c], 2e-4) << "at " << x << ", " << y;
                        ASSERT_NEAR(double(normal.at(x, y)[i]), wanted.normal[c], 2e-3) << "at " << x << ", " << y;
                        ASSERT_NEAR(double(tangent.at(x, y)[i]), wanted.tangent[c], 2e-3) << "at " << x << ", " << y;
                    }
                }
            }
            EXPECT_GT(compared, 300);
        }
    }
}

// What the waves do is far more than the tolerances above.
TEST(Displacement, IsFarFromThePlane) {
    glm::dvec3 largest(0);  // of height, slope of the normal, slope of the tangent
    for (double u = 0.1; u < 1; u += 0.1) {
        const Moved at = in_world(glm::dmat4(1), u, 0.5);
        largest = glm::max(largest, glm::dvec3(std::abs(at.position.z), 1 - at.normal.z, std::abs(at.tangent.z)));
    }
    EXPECT_GT(largest.x, 0.1);
    EXPECT_GT(largest.y, 0.02);
    EXPECT_GT(largest.z, 0.2);
}

}  // namespace
}  // namespace patina::paths
