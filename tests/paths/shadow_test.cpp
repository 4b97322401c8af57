// Shadows against a mask of rays: a ball above a plane, the sun and a spot, seen by a material that shows
// @light.shadow.
//
// Errors are measured in texels of the shadow map, in the map's own plane, where the ball's outline is a circle (sun)
// or a conic (spot): the area between picture and mask, divided by the outline's length, is the mean distance from the
// true edge. What that may be:
//   - the filter is a tent of half width w = 2.5 texels along x and y: an edge in any direction is spread with a
//   variance
//     of w^2 / 6 = 1.04
//   - the normal bias moves the outline inwards by s texels
//   - depths are known at texels' centres: an edge is known to a texel, with a variance of 1/12
// By Jensen's inequality the mean of |x| is at most the root of the mean square, sqrt(w^2 / 6 + s^2 + 1 / 12). A tent
// along an axis has a mean of w / 3 = 0.83: an edge that is much sharper has not been filtered.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "paths/drawing.h"
#include "runtime/shadow_view.h"

namespace patina::paths {
namespace {

using runtime::Light;
using runtime::LightKind;
using runtime::ShadowView;

constexpr float kRadius = 0.5f;
constexpr glm::vec3 kBall{0, 2, 0};
constexpr int kAtlas = 512;
constexpr double kTent = 2.5;  // texels

Light sun() {
    Light light{.direction = {-0.6f, 1, 0.25f}};
    light.shadow = {.casts = true};
    return light;
}
Light spot() {
    Light light{.kind = LightKind::Spot,
                .position = {-1.3f, 5, 0.6f},
                .direction = glm::vec3(0.2f, 0, 0) + kBall - glm::vec3(-1.3f, 5, 0.6f),
                .range = 9,
                .inner_angle = 20,
                .outer_angle = 25};
    light.shadow = {.casts = true};
    return light;
}

// The way of the light that passes the ball's centre, unit.
glm::vec3 way_past_ball(const Light& light) {
    return light.kind == LightKind::Directional ? -glm::normalize(light.direction)
                                                : glm::normalize(kBall - light.position);
}

// The camera looks straight down on the shadow, and does not see the ball.
World scene(const Light& light, int size, const std::string& caster) {
    World world{.view = runtime::default_scene("")};
    world.view.width = world.view.height = size;
    world.view.samples = 1;
    world.view.lights = {light};
    const glm::vec3 way = way_past_ball(light);
    const glm::vec3 middle = kBall + way * (-kBall.y / way.y);
    world.view.camera = {
        .position = middle + glm::vec3(0, 0.9f, 0.001f), .target = middle, .orthographic_height = 2.2f};
    const std::string receiver = written("receiver.graph.json", R"json({ "patina": 1, "workflow": "unlit",
  "nodes": [ { "id": "shadow", "expr": "@light.shadow" } ], "surface": { "color": "= float3(shadow)" } })json");
    const glm::mat4 flat = glm::rotate(glm::mat4(1), glm::radians(-90.0f), {1, 0, 0});
    add_object(world, receiver, "plane", 1, glm::scale(flat, glm::vec3(4)));
    add_object(world, caster, "sphere", 256, glm::scale(glm::translate(glm::mat4(1), kBall), glm::vec3(kRadius)));
    return world;
}

std::string plain_caster() {
    return written("plain.graph.json", R"json({ "patina": 1, "workflow": "unlit" })json");
}

// The map as the frame has it: every object casts.
ShadowView map_of(const World& world) {
    const Light& light = world.view.lights[0];
    const runtime::ShadowTile tile{.number = 0, .atlas_size = kAtlas};
    std::vector<runtime::Sphere> all;
    for (const runtime::WorldObject& object : world.objects)
        all.push_back(runtime::world_bounds(*object.mesh, object.object_to_world));
    return light.kind == LightKind::Spot ? runtime::spot_shadow(light, tile)
                                         : runtime::directional_shadow(light, all, all, tile);
}

class Measured {
public:
    Measured(const World& world, const Image& image) : world_(world), map_(map_of(world)) {
        const Light& light = world.view.lights[0];
        const glm::dmat4 to_world = glm::inverse(glm::dmat4(runtime::view_to_clip(world.view.camera, 1)) *
                                                 glm::dmat4(runtime::world_to_view(world.view.camera)));
        const int size = image.width;
        const auto on_plane = [&](double x, double y) {
            const glm::dvec4 near = to_world * glm::dvec4(2 * x / size - 1, 1 - 2 * y / size, 0, 1);
            const glm::dvec4 far = to_world * glm::dvec4(2 * x / size - 1, 1 - 2 * y / size, 1, 1);
            const glm::dvec3 way = glm::dvec3(far) - glm::dvec3(near);
            return glm::dvec3(near) - way * (near.y / way.y);
        };
        find_outline(light);
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const double shown = double(image.at(x, y)[0]);
                const glm::dvec3 point = on_plane(x + 0.5, y + 0.5);
                const double lit = is_lit(light, point) ? 1 : 0;
                const glm::dvec2 here = in_texels(point);
                const glm::dvec2 right = in_texels(on_plane(x + 1.5, y + 0.5)) - here;
                const glm::dvec2 down = in_texels(on_plane(x + 0.5, y + 1.5)) - here;
                const double area = std::abs(right.x * down.y - right.y * down.x);
                mean_distance += std::abs(shown - lit) * area;
                inwards += (shown - lit) * area;  // lit where it should be dark
                dark += (1 - lit) * area;
                // Beyond the filter's corners, the bias and the texel that an edge is known to, there is nothing
                // between.
                if (shown != lit && distance_to_outline(here) > kTent * std::numbers::sqrt2 + bias_in_texels() + 1.5)
                    ++wrong_far_away;
            }
        }
        mean_distance /= length_;
        inwards /= length_;
    }

    // How far the normal bias moves the outline: by its metres where the light grazes the ball.
    double bias_in_texels() const {
        const Light& light = world_.view.lights[0];
        if (light.kind == LightKind::Directional) return double(light.shadow.normal_bias);
        // Said in texels at the range, which are larger than those where rays touch the ball.
        const glm::vec3 to_ball = kBall - light.position;
        const glm::vec3 to_outline = to_ball * (1 - kRadius * kRadius / glm::dot(to_ball, to_ball));
        return double(light.shadow.normal_bias * light.range / glm::dot(to_outline, glm::normalize(light.direction)));
    }
    double most() const { return std::sqrt(kTent * kTent / 6 + bias_in_texels() * bias_in_texels() + 1.0 / 12); }

    double mean_distance = 0;  // texels from the true edge
    double inwards = 0;        // texels by which the shadow is too small, in the mean
    double dark = 0;           // texels in shadow
    int wrong_far_away = 0;    // pixels

private:
    // Texels of the map.
    glm::dvec2 in_texels(const glm::dvec3& point) const {
        const glm::dvec4 clip = glm::dmat4(map_.world_to_shadow) * glm::dvec4(point, 1);
        return glm::dvec2(clip) / clip.w * 0.5 * double(map_.area.width);
    }

    static bool is_lit(const Light& light, const glm::dvec3& point) {
        const bool is_sun = light.kind == LightKind::Directional;
        const glm::dvec3 way = is_sun ? glm::dvec3(light.direction) : glm::dvec3(light.position) - point;
        const glm::dvec3 to_ball = glm::dvec3(kBall) - point;
        const double along = glm::dot(to_ball, glm::normalize(way));
        return glm::dot(to_ball, to_ball) - along * along > double(kRadius * kRadius);
    }

    // Where rays touch the ball.
    void find_outline(const Light& light) {
        const glm::dvec3 way = way_past_ball(light);
        const glm::dvec3 aside = glm::normalize(glm::cross(way, glm::dvec3(0, 0, 1))), up = glm::cross(aside, way);
        const double distance = glm::distance(glm::dvec3(light.position), glm::dvec3(kBall));
        const bool is_sun = light.kind == LightKind::Directional;
        const double sine = is_sun ? 0 : double(kRadius) / distance;
        const glm::dvec3 middle = glm::dvec3(kBall) - way * (double(kRadius) * sine);
        const double radius = double(kRadius) * std::sqrt(1 - sine * sine);
        for (int i = 0; i < 720; ++i) {
            const double angle = 2 * std::numbers::pi * i / 720;
            outline_.push_back(in_texels(middle + radius * (std::cos(angle) * aside + std::sin(angle) * up)));
        }
        for (std::size_t i = 0; i < outline_.size(); ++i)
            length_ += glm::distance(outline_[i], outline_[(i + 1) % outline_.size()]);
    }
    double distance_to_outline(const glm::dvec2& place) const {
        double nearest = 1e9;
        for (const glm::dvec2& point : outline_) nearest = std::min(nearest, glm::distance(point, place));
        return nearest;
    }

    const World& world_;
    ShadowView map_;
    std::vector<glm::dvec2> outline_{};
    double length_ = 0;
};

void expect_shadow(const Light& light) {
    const World world = scene(light, 192, plain_caster());
    const Image image = draw(world, {.path = "forward", .shadow_atlas_size = kAtlas});
    const Measured measured(world, image);
    std::printf("mean distance %.3f texels (at most %.3f), too small by %.3f (bias %.3f), over %.0f texels\n",
                measured.mean_distance, measured.most(), measured.inwards, measured.bias_in_texels(), measured.dark);
    EXPECT_GT(measured.dark, 150);
    EXPECT_LE(measured.mean_distance, measured.most());
    EXPECT_GE(measured.mean_distance, 0.8 * kTent / 3);
    // A filter moves no edge: what is left is the bias, and the texel that the edge is known to.
    EXPECT_NEAR(measured.inwards, measured.bias_in_texels(), 0.25);
    EXPECT_EQ(measured.wrong_far_away, 0);
}

TEST(Shadow, OfTheSunIsWhereRaysSayItIs) {
    expect_shadow(sun());
}

TEST(Shadow, OfASpotIsWhereRaysSayItIs) {
    expect_shadow(spot());
}

TEST(Shadow, IsAsDarkAsItsStrength) {
    Light light = sun();
    light.shadow.strength = 0.75f;
    const World world = scene(light, 64, plain_caster());
    EXPECT_NEAR(double(draw(world, {.path = "forward"}).at(32, 32)[0]), 0.25, 1e-6);
}

// A finer map has a sharper edge: errors are texels, whatever their size.
TEST(Shadow, OfAFinerMapIsNearerToTheTruth) {
    const World world = scene(sun(), 128, plain_caster());
    const Image coarse = draw(world, {.path = "forward", .shadow_atlas_size = 512});
    const Image fine = draw(world, {.path = "forward", .shadow_atlas_size = 4096});
    int between_coarse = 0, between_fine = 0;
    for (std::size_t i = 0; i < coarse.pixels.size(); i += 4) {
        between_coarse += coarse.pixels[i] > 0 && coarse.pixels[i] < 1;
        between_fine += fine.pixels[i] > 0 && fine.pixels[i] < 1;
    }
    EXPECT_LT(between_fine, between_coarse / 4);
    EXPECT_GT(between_fine, 0);
}

// Cutout surfaces cast the shadow of what is left of them: here, of one half.
TEST(Shadow, OfACutoutHasItsHoles) {
    const std::string caster = written("half.graph.json", R"json({ "patina": 1, "workflow": "unlit",
  "surface": { "alpha": "= step(0, @position_os.z)" }, "render": { "surface": "cutout", "cull": "off" } })json");
    const World whole = scene(sun(), 128, plain_caster()), half = scene(sun(), 128, caster);
    const WorldOptions options{.path = "forward"};
    const Image of_whole = draw(whole, options), of_half = draw(half, options);
    const auto dark = [](const Image& image) {
        double sum = 0;
        for (std::size_t i = 0; i < image.pixels.size(); i += 4) sum += 1 - double(image.pixels[i]);
        return sum;
    };
    EXPECT_LT(dark(of_half), 0.8 * dark(of_whole));
    EXPECT_GT(dark(of_half), 0.4 * dark(of_whole));
}

}  // namespace
}  // namespace patina::paths
