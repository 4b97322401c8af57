// Surfaces that blend, by formulas: what a plane in front of the background leaves of it, its coverage, and the fog
// between it and the camera. Along each path that draws it, on the GPU and the CPU.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "paths/drawing/drawing.h"

namespace patina::paths {
namespace {

constexpr double kBase = 0.5, kAlpha = 0.25, kAmbient = 0.75;
constexpr double kDielectric = 0.04;  // f0 of the workflow: the diffuse colour has the rest
const glm::dvec4 kBehind(0.25, 0.5, 1, 0.5);
const glm::dvec3 kFog(0.8, 0.4, 0.1);
constexpr double kDistance = 4, kDensity = 0.2;

struct Way {
    const char* path;
    const char* via;
};
constexpr Way kWays[] = {{"forward", "glsl"},
                         {"forward", "hlsl"},
                         {"forward", "cpu"},
                         {"forward-add", "glsl"},
                         {"forward-add", "cpu"},
                         {"vertex", "glsl"},
                         {"forward-directional", "glsl"},
                         {"deferred", "glsl"}};

// Seen from 4 m, it fills the picture; a lamp besides the sun lights it, so that `forward-add` has something to add.
World plane(const std::string& surface, bool in_fog, const std::string& clip = "0.1") {
    World world;
    world.view.width = world.view.height = 4;
    world.view.background = glm::vec4(kBehind);
    world.view.camera = {.position = {0, 0, kDistance}, .target = {0, 0, 0}, .fov = 20};
    world.view.ambient = runtime::constant_ambient(glm::vec3(kAmbient));
    world.view.lights = {{.direction = {0, 0, 1}, .color = glm::vec3(0.5f)},
                         {.direction = {0, 0, 1}, .color = glm::vec3(0.25f)}};
    world.pixel_light_count = 4;
    if (in_fog) world.view.fog = {.mode = FogMode::Exponential, .color = glm::vec3(kFog), .density = float(kDensity)};
    const std::string graph = written("blended_" + surface + clip + ".graph.json", R"({ "patina": 1,
  "workflow": "metallic-roughness", "lighting": "lambert", "surface": { "baseColor": 0.5, "alpha": 0.25, "alphaClip": )" +
                                                                                       clip + R"( },
  "render": { "surface": ")" + surface + "\" } }");
    add_object(world, graph, "plane", 8, glm::scale(glm::mat4(1), glm::vec3(4)));
    return world;
}

struct Case {
    const char* surface;
    glm::dvec4 (*expected)(double light, double seen);  // of the surface's own light, and what the fog leaves of it
};
// The light of a matt plane that covers all.
constexpr double kLight = kBase * (1 - kDielectric) * (kAmbient + 0.5 + 0.25);
glm::dvec3 fogged(const glm::dvec3& fog, double light, double seen) {
    return glm::mix(fog, glm::dvec3(light), seen);
}
constexpr Case kCases[] = {
    {"opaque", [](double light, double seen) { return glm::dvec4(fogged(kFog, light, seen), 1); }},
    {"cutout",  // alpha is not below alphaClip, which is 0.1
     [](double light, double seen) { return glm::dvec4(fogged(kFog, light, seen), 1); }},
    {"fade",
     [](double light, double seen) {
         return glm::dvec4(glm::mix(glm::dvec3(kBehind), fogged(kFog, light, seen), kAlpha),
                           kAlpha + (1 - kAlpha) * kBehind.a);
     }},
    {"transparent",  // its reflections stay: its coverage is not less than its reflectance
     [](double light, double seen) {
         const double covered = 1 - (1 - kAlpha) * (1 - kDielectric);
         return glm::dvec4(fogged(kFog * covered, light * kAlpha, seen), covered) + (1 - covered) * kBehind;
     }},
    {"additive",
     [](double light, double seen) { return glm::dvec4(fogged({}, light, seen) + glm::dvec3(kBehind), kBehind.a); }},
    {"multiply", [](double light, double seen) {
         return glm::dvec4(fogged(glm::dvec3(1), light, seen) * glm::dvec3(kBehind), kBehind.a);
     }}};

// Surfaces without an add pass have the sun and the ambient light alone (docs/rendering-paths.md).
double light_along(const Case& each, const Way& way) {
    const bool is_split = std::string_view(way.path).starts_with("forward-");
    const bool is_whole = std::string_view(each.surface) != "additive" && std::string_view(each.surface) != "multiply";
    return is_split && !is_whole ? kBase * (1 - kDielectric) * (kAmbient + 0.5) : kLight;
}

TEST(Blending, LeavesWhatItsFormulaSays) {
    for (const Case& each : kCases) {
        for (const Way& way : kWays) {
            for (const bool in_fog : {false, true}) {
                SCOPED_TRACE(std::string(each.surface) + " along " + way.path + " via " + way.via +
                             (in_fog ? ", in fog" : ""));
                const double seen = in_fog ? std::exp(-kDistance * kDensity) : 1;
                const glm::dvec4 expected = each.expected(light_along(each, way), seen);
                const Image image =
                    draw(plane(each.surface, in_fog), {.path = way.path, .via = way.via, .exact_targets = true});
                for (int c = 0; c < 4; ++c) EXPECT_NEAR(double(image.at(2, 2)[std::size_t(c)]), expected[c], 2e-4);
            }
        }
    }
}

// Below alphaClip nothing is drawn: neither the colour, nor highlights, nor the depth. The coverage of a transparent
// surface is above it here, because its reflections cover, too.
TEST(Blending, WhatIsClippedLeavesTheBackground) {
    static_assert(1 - (1 - kAlpha) * (1 - kDielectric) > 0.26);
    for (const Case& each : kCases) {
        if (std::string_view(each.surface) == "opaque") continue;
        for (const Way& way : kWays) {
            SCOPED_TRACE(std::string(each.surface) + " along " + way.path + " via " + way.via);
            const Image image =
                draw(plane(each.surface, false, "0.26"), {.path = way.path, .via = way.via, .exact_targets = true});
            for (int c = 0; c < 4; ++c) EXPECT_NEAR(double(image.at(2, 2)[std::size_t(c)]), kBehind[c], 1e-6);
        }
    }
}

}  // namespace
}  // namespace patina::paths
