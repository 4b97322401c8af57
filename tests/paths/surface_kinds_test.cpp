// The example of every kind of surface, before a checkerboard: what each leaves of it, by the kind's blend equation and
// by the light of a plane that is lit and seen along its normal. Through GLSL, HLSL and the CPU.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "paths/drawing/checkerboard.h"

namespace patina::paths {
namespace {

void expect_picture(const std::string& graph, const std::map<std::string, std::string>& overrides,
                    const std::function<glm::dvec3(int x, int y)>& expected) {
    SCOPED_TRACE(graph);
    World world = checkerboard();
    add_object(world, graph, "plane", 1, glm::mat4(1), overrides);
    expect_pixels(world, expected);
}

TEST(SurfaceKinds, OpaqueCoversWithLightBrighterThanWhite) {
    const auto emission = [](int x, int y) {
        const double v = uv_of(x, y).y * 7, from_tube = std::abs(v - std::floor(v) - 0.5);
        const double t = std::clamp((from_tube - 0.06) / 0.04, 0.0, 1.0), tube = 1 - t * t * (3 - 2 * t);
        const double spill = 0.12 * (1 - 2 * from_tube) * (1 - 2 * from_tube);
        return glm::dvec3(4, 0.12, 0.5) * (tube + spill) + highlight(0.6) * kSun;
    };
    EXPECT_GT(emission(0, 2).r, 4) << "some row of pixels lies in a tube";
    expect_picture("examples/surfaces/neon.graph.json", {{"_Color", "0,0,0"}}, emission);
}

// Four by two tiles, the left half of each a white leaf and the right half below the cut-off.
TEST(SurfaceKinds, CutoutCoversWhereItIsNotCut) {
    const std::string leaf =
        written_texture("leaf.exr", 64, 2, [](int x, int) { return glm::dvec4(1, 1, 1, x < 32 ? 0.75 : 0.25); });
    const std::string flat = written_texture("flat.exr", 1, 1, [](int, int) { return glm::dvec4(0.5, 0.5, 1, 1); });
    expect_picture("examples/graphs/ivy.graph.json", {{"_MainTex", leaf}, {"_BumpMap", flat}}, [](int x, int y) {
        return x % 8 < 4 ? scattered(glm::dvec3(1)) + highlight(0.55) * kSun : behind(x, y);
    });
}

TEST(SurfaceKinds, FadeTakesAllOfItByItsAlpha) {
    for (const double alpha : {0.0, 0.35, 1.0})
        expect_picture("examples/surfaces/ghost.graph.json",
                       {{"_Color", fmt::format("0.8,0.4,0.2,{}", alpha)}, {"_Glossiness", "0.5"}}, [&](int x, int y) {
                           const glm::dvec3 own = scattered({0.8, 0.4, 0.2}) + highlight(0.5) * kSun;
                           return alpha * own + (1 - alpha) * behind(x, y);
                       });
}

// Even where it scatters nothing it mirrors, and hides as much of the board as it mirrors of what is before it.
TEST(SurfaceKinds, TransparentKeepsItsHighlight) {
    for (const double alpha : {0.0, 0.15, 1.0})
        expect_picture("examples/surfaces/glass_pane.graph.json",
                       {{"_Color", fmt::format("0.8,0.4,0.2,{}", alpha)}, {"_Glossiness", "0.5"}}, [&](int x, int y) {
                           const glm::dvec3 own = alpha * scattered({0.8, 0.4, 0.2}) + highlight(0.5) * kSun;
                           return own + (1 - alpha) * (1 - kF0) * behind(x, y);
                       });
}

std::string transparent(const std::string& name, const std::string& workflow, const std::string& light) {
    return written(name, fmt::format(R"({{ "patina": 1, "workflow": "{}", "properties": [
  {{ "name": "_Alpha", "type": "float", "default": 1 }} ],
  "surface": {{ {}, "alpha": "$_Alpha" }}, "render": {{ "surface": "transparent" }} }})",
                                     workflow, light));
}

// An unlit one is gone with its alpha, as all that it has is its colour; what a lit one emits stays.
TEST(SurfaceKinds, TransparentTakesAnUnlitColorByItsAlphaAndLeavesEmission) {
    const glm::dvec3 color(0.8, 0.4, 2);
    const std::string unlit = transparent("unlit.graph.json", "unlit", R"("color": [0.8, 0.4, 2])");
    const std::string lit = transparent("glowing.graph.json", "specular-glossiness",
                                        R"("baseColor": 0, "specular": 0, "emission": [0.8, 0.4, 2])");
    for (const double alpha : {0.0, 0.35, 1.0}) {
        const std::map<std::string, std::string> words = {{"_Alpha", fmt::format("{}", alpha)}};
        expect_picture(unlit, words, [&](int x, int y) { return alpha * color + (1 - alpha) * behind(x, y); });
        expect_picture(lit, words, [&](int x, int y) { return color + (1 - alpha) * behind(x, y); });
    }
}

TEST(SurfaceKinds, AdditiveAddsItsLight) {
    expect_picture("examples/surfaces/halo.graph.json", {{"_EmissionColor", "2,1,0.5"}}, [](int x, int y) {
        const double inside = std::max(0.0, 1 - 2 * glm::length(uv_of(x, y) - glm::dvec2(0.5)));
        return behind(x, y) + inside * inside * glm::dvec3(2, 1, 0.5);
    });
}

TEST(SurfaceKinds, MultiplyTakesItsShare) {
    const std::map<std::string, std::string> even = {{"_Uneven", "0"}, {"_Color", "0.5,0.25,0.125"}};
    expect_picture("examples/surfaces/stain.graph.json", even, [](int x, int y) {
        const auto step = [](double from, double to, double value) {
            const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
            return t * t * (3 - 2 * t);
        };
        const double radius = glm::length(uv_of(x, y) - glm::dvec2(0.5));
        const double ring = 1 - step(0.015, 0.05, std::abs(radius - 0.38)), inside = 1 - step(0.36, 0.40, radius);
        return behind(x, y) *
               glm::mix(glm::dvec3(1), glm::dvec3(0.5, 0.25, 0.125), std::min(0.35 * inside + ring, 1.0));
    });
}

}  // namespace
}  // namespace patina::paths
