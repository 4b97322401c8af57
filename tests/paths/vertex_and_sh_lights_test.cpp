// Lights that forward-add computes at vertices or as spherical harmonics, by formulas on matt surfaces: what each adds,
// where it is computed, and that every light is there once.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "paths/drawing/matt_plane.h"

namespace patina::paths {
namespace {

using runtime::Light;

constexpr const char* kVias[] = {"glsl", "hlsl", "cpu"};

RenderOptions additive(const char* via, bool sh_per_vertex = false) {
    return {.path = "forward-add",
            .switches = {{"shPerVertex", sh_per_vertex ? "true" : "false"}},
            .via = via,
            .exact_targets = true};
}

// --- the formulas

// The inverse square law with a window: Lagarde and de Rousiers 2014, Karis 2013 eq. 9.
double attenuation(double distance, double range) {
    const double ratio = distance / range;
    return std::pow(std::max(1 - std::pow(ratio, 4), 0.0), 2) / (distance * distance);
}

// What a point light sends to a white matt surface: E / pi.
glm::dvec3 arrives(const Light& light, glm::dvec3 place, glm::dvec3 normal) {
    const glm::dvec3 way = glm::dvec3(light.position) - place;
    const double distance = glm::length(way), cosine = glm::dot(normal, way) / distance;
    return glm::dvec3(light.color) * (std::max(cosine, 0.0) * attenuation(distance, double(light.range)));
}

// The same of light from one side through nine coefficients. By the addition theorem the sum of band l is (2 l + 1) /
// (4 pi) P_l(n.l); the cosine weighs bands by 1, 2/3 and 1/4 (Ramamoorthi and Hanrahan 2001), and 16 pi / 17 makes it 1
// where the light is faced (Sloan 2008).
double in_harmonics(double cosine) {
    return 4 / 17.0 * (1 + 2 * cosine + 5 / 8.0 * (3 * cosine * cosine - 1));
}

// Of a light as the object's middle sees it, from outside.
glm::dvec3 in_harmonics(const Light& light, glm::dvec3 normal, glm::dvec3 middle = glm::dvec3(0)) {
    const bool is_directional = light.kind == LightKind::Directional;
    const glm::dvec3 way = is_directional ? glm::dvec3(light.direction) : glm::dvec3(light.position) - middle;
    const double far = glm::length(way);
    return glm::dvec3(light.color) *
           ((is_directional ? 1 : attenuation(far, double(light.range))) * in_harmonics(glm::dot(normal, way) / far));
}

// --- on a plane

const glm::dvec3 kForwards(0, 0, 1);
constexpr float kBeyond = 40;  // so far that distance alone says what is brightest

Light point_at(glm::vec3 position, glm::vec3 color) {
    return {.kind = LightKind::Point, .position = position, .color = color, .range = kBeyond};
}

glm::dvec3 on_plane(int x, int y) {
    return {right(x), up(y), 0};
}

// Around the plane, one of them to the side and one behind it, where it lights nothing.
std::vector<Light> four_points() {
    return {point_at({1.5f, 0.5f, 1}, {3, 0.5f, 0.25f}), point_at({-1, -1.2f, 0.6f}, {0.25f, 2, 0.5f}),
            point_at({0, 0.3f, 2}, {1, 1, 4}), point_at({0.4f, 0, -1.5f}, {5, 5, 5})};
}

TEST(VertexLights, AreTheFormulaAtEveryVertex) {
    World world = matt_plane_of_pixels();
    world.pixel_light_count = 0;
    world.view.lights = four_points();
    const Light sun{.direction = {0.6f, 0, 0.8f}, .color = {0.5f, 0.25f, 1}};
    for (bool has_sun : {false, true}) {  // they stand behind the main light
        if (has_sun) world.view.lights.insert(world.view.lights.begin() + 2, sun);
        const auto expected = [&](int x, int y) {
            glm::dvec3 sum = has_sun ? glm::dvec3(sun.color) * 0.8 : glm::dvec3(0);
            for (const Light& light : four_points()) sum += arrives(light, on_plane(x, y), kForwards);
            return kDiffuse * sum;
        };
        for (const char* via : kVias) {
            SCOPED_TRACE(via);
            expect_everywhere(draw(world, additive(via)), expected, 1e-4);
        }
    }
}

// On a single square all four corners are alike to a light before its middle, and so is all between them; per pixel,
// the middle is brighter.
TEST(VertexLights, AreInterpolatedBetweenVertices) {
    World world = matt_plane(1);
    const Light lamp = point_at({0, 0, 1}, {1, 2, 0.5f});
    world.view.lights = {lamp};
    for (const char* via : kVias) {
        SCOPED_TRACE(via);
        world.pixel_light_count = 0;
        expect_everywhere(
            draw(world, additive(via)),
            [&](int, int) {
                return kDiffuse * arrives(lamp, {1, 1, 0}, kForwards);
            },
            1e-4);
        world.pixel_light_count = 1;
        expect_everywhere(
            draw(world, additive(via)),
            [&](int x, int y) { return kDiffuse * arrives(lamp, on_plane(x, y), kForwards); }, 1e-4);
    }
}

// Lights that no vertex takes: the fainter suns, and spots. All share their sum, which is cut off at 0.
TEST(HarmonicLights, AreTheFormulaOnAPlane) {
    World world = matt_plane();
    world.pixel_light_count = 0;
    const Light main{.direction = {0, 0.6f, 0.8f}, .color = glm::vec3(1)};
    const Light spot{.kind = LightKind::Spot,
                     .position = {1.8f, 0, 2.4f},
                     .direction = {-0.6f, 0, -0.8f},
                     .color = {6, 3, 1},
                     .range = kBeyond};
    for (const glm::vec3 side : {glm::vec3(0, 0, 1), {0.6f, 0, 0.8f}, {1, 0, 0}, {0, 0.8f, -0.6f}, {0, 0, -1}}) {
        const Light sun{.direction = side, .color = {0.25f, 0.5f, 0.75f}};
        for (bool has_spot : {false, true}) {
            world.view.lights = {main, sun};
            if (has_spot) world.view.lights.push_back(spot);
            const glm::dvec3 ambient =
                in_harmonics(sun, kForwards) + (has_spot ? in_harmonics(spot, kForwards) : glm::dvec3(0));
            const glm::dvec3 expected = kDiffuse * (glm::max(ambient, glm::dvec3(0)) + 0.8);
            for (const char* via : kVias) {
                for (bool sh_per_vertex : {false, true}) {
                    SCOPED_TRACE(std::string(via) + (sh_per_vertex ? ", at vertices, n.l " : ", n.l ") +
                                 std::to_string(side.z) + (has_spot ? ", and a spot" : ""));
                    expect_everywhere(
                        draw(world, additive(via, sh_per_vertex)), [&](int, int) { return expected; }, 1e-4);
                }
            }
        }
    }
}

// --- on a sphere

constexpr int kBallSide = 96;
constexpr double kViewer = 4.5, kFov = 28;

World ball(int segments) {
    World world{.view = runtime::default_scene("")};
    world.view.width = world.view.height = kBallSide;
    world.view.samples = 1;
    world.view.background = glm::vec4(0);
    world.view.ambient = {};
    world.view.camera = {.position = {0, 0, float(kViewer)}, .target = {0, 0, 0}, .fov = float(kFov)};
    world.pixel_light_count = 0;
    world.view.lights = {{.direction = {0, 0, 1}, .color = glm::vec3(1)},
                         {.direction = glm::vec3(2, 3, 6) / 7.0f, .color = {0.5f, 0, 0}},
                         {.direction = glm::vec3(-6, 2, 3) / 7.0f, .color = {0, 0.9f, 0}},
                         {.kind = LightKind::Spot,
                          .position = {0, -3, 0},
                          .direction = {0, 1, 0},
                          .color = {0, 0, 7},
                          .range = kBeyond}};
    add_object(world, matt(), "sphere", segments, glm::mat4(1));
    return world;
}

// Normal of the unit sphere behind a pixel's centre; z 0: there is none.
glm::dvec3 normal_behind(int x, int y) {
    const double half = std::tan(kFov / 2 * std::numbers::pi / 180);
    const glm::dvec3 way =
        glm::normalize(glm::dvec3(half * (2 * (x + 0.5) / kBallSide - 1), half * (1 - 2 * (y + 0.5) / kBallSide), -1));
    const double along = -kViewer * way.z, squared = along * along - kViewer * kViewer + 1;
    if (squared < 0) return glm::dvec3(0);
    return glm::dvec3(0, 0, kViewer) + (along - std::sqrt(squared)) * way;
}

// By 70 degrees away from the viewer at most: beyond, the mesh is farther from the sphere.
bool is_in_front(int x, int y) {
    const glm::dvec3 normal = normal_behind(x, y);
    return glm::dot(normal, glm::normalize(glm::dvec3(0, 0, kViewer) - normal)) > 0.342;
}

// A sphere of triangles with sides of h = 2 pi / 192 lies h^2 / 4 = 2.7e-4 inside the true one at most. Seen at 70
// degrees that moves the normal by 2.7 times as much, 7.4e-4. The sun changes by 1 a radian at most and what comes in
// harmonics, 0.9 of light in each channel, by 4 / 17 (2 + 15 / 4) = 1.35: 1.7e-3 of light, and half of it of picture.
TEST(HarmonicLights, AreTheFormulaOnASphere) {
    const World world = ball(192);
    const auto expected = [&](int x, int y) {
        const glm::dvec3 normal = normal_behind(x, y);
        glm::dvec3 ambient(0);
        for (std::size_t i = 1; i < world.view.lights.size(); ++i)
            ambient += in_harmonics(world.view.lights[i], normal);
        return kDiffuse *
               (glm::max(ambient, glm::dvec3(0)) + glm::dvec3(world.view.lights[0].color) * std::max(normal.z, 0.0));
    };
    for (const char* via : kVias) {
        SCOPED_TRACE(via);
        expect_everywhere(draw(world, additive(via)), expected, 1e-3, is_in_front);
    }
}

// The second order is a quadratic form Q of the normal. Between three vertices with weights b its interpolation misses
// Q at the unit normal by the sum of b_i b_j (Q(e) - |e|^2 Q(n)) over the edges e = n_i - n_j: by that of b_i b_j |e|^2
// times the spread of Q's eigenvalues at most. Of a light they are 4 / 17 * 5 / 8 times 2 and -1: a spread of 7.5 / 17.
// The sum is at most the squared radius of the circle around the triangle, whose sides are h: h^2 / 2.
TEST(HarmonicLights, AtVerticesAreAsFarFromPixelsAsInterpolationIs) {
    for (int segments : {24, 48}) {
        const double h = 2 * std::numbers::pi / segments, bound = kDiffuse * 0.9 * 7.5 / 17 * h * h / 2;
        const World world = ball(segments);
        for (const char* via : kVias) {
            const Image pixels = draw(world, additive(via)), vertices = draw(world, additive(via, true));
            const Difference far = difference(pixels, vertices);
            EXPECT_LE(far.largest, bound) << via << ": " << to_text(far);
            EXPECT_GT(far.largest, bound / 8) << via << ": as if it had been computed per pixel";
            std::printf("%d segments, %s: %s; the bound is %.3g / 255\n", segments, via, to_text(far).c_str(),
                        255 * bound);
        }
    }
}

// --- twelve lights

// A sun and eleven points before the plane's middle, each fainter than the one before; its number is in what it adds.
// All are outside the sphere around the plane, whose radius is the root of 2.
std::vector<Light> twelve_lights() {
    std::vector<Light> lights = {{.direction = {0, 0, 1}, .color = {0.1f, 0.2f, 0.3f}}};
    for (int i = 1; i < 12; ++i) lights.push_back(point_at({0, 0, 1.6f + 0.1f * float(i)}, {1, 0.5f, 0.25f}));
    return lights;
}

// Four pixel lights: the sun and the next three. Then four at the vertices, then harmonics.
TEST(TwelveLights, AreFourAndFourAndFourAndNoneIsLost) {
    World world = matt_plane(1);
    const std::vector<Light> lights = twelve_lights();
    const glm::dvec3 corner(1, 1, 0);
    const auto adds = [&](std::size_t i, int x, int y) {
        if (i == 0) return glm::dvec3(lights[0].color);
        if (i < 4) return arrives(lights[i], on_plane(x, y), kForwards);
        return i < 8 ? arrives(lights[i], corner, kForwards) : in_harmonics(lights[i], kForwards);
    };
    // Were one missing, or in another group, it would show.
    constexpr double kTolerance = 1e-4;
    for (std::size_t i = 1; i < lights.size(); ++i) {
        const int where = i < 8 ? 8 : 0;  // vertices are far from the middle, and the middle is from a corner
        const glm::dvec3 in_pixel = arrives(lights[i], on_plane(where, where), kForwards);
        EXPECT_GT(in_pixel.x, 100 * kTolerance) << i;
        EXPECT_EQ(std::abs(adds(i, where, where).x - in_pixel.x) > 10 * kTolerance, i >= 4) << i;
    }
    // The scene's order is not that of brightness.
    for (std::size_t i = 0; i < lights.size(); ++i) world.view.lights.push_back(lights[(7 * i) % lights.size()]);
    world.pixel_light_count = 4;
    for (const char* via : kVias) {
        SCOPED_TRACE(via);
        const auto expected = [&](int x, int y) {
            glm::dvec3 sum(0);
            for (std::size_t i = 0; i < lights.size(); ++i) sum += adds(i, x, y);
            return kDiffuse * sum;
        };
        expect_everywhere(draw(world, additive(via)), expected, kTolerance);
    }
}

// The light of all twelve on the plane against the direct sum. Harmonics of a light that is faced are the light itself;
// so with a vertex in every pixel only those four differ, by how the light seen from the middle differs from that in
// the pixel: the test holds the rest to the direct sum.
TEST(TwelveLights, ShineAsBrightlyAsTheirDirectSum) {
    World world = matt_plane_of_pixels();
    world.view.lights = twelve_lights();
    world.pixel_light_count = 4;
    glm::dvec3 direct(0), from_middle(0), pictured(0);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            for (std::size_t i = 0; i < 12; ++i) {
                const Light& light = world.view.lights[i];
                const glm::dvec3 here = i == 0 ? glm::dvec3(light.color) : arrives(light, on_plane(x, y), kForwards);
                direct += here;
                if (i >= 8) from_middle += arrives(light, {0, 0, 0}, kForwards) - here;
            }
    const Image image = draw(world, additive("glsl"));
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            for (int c = 0; c < 3; ++c) pictured[c] += double(image.at(x, y)[std::size_t(c)]) / kDiffuse;
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(pictured[c] / (direct[c] + from_middle[c]), 1, 1e-4) << c;
        EXPECT_LT(from_middle[c] / direct[c], 0.05) << c;
    }
}

}  // namespace
}  // namespace patina::paths
