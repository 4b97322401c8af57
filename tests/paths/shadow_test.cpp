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

#include "paths/drawing/drawing.h"
#include "runtime/lights/shadow_view.h"

namespace patina::paths {
namespace {

using runtime::Light;
using runtime::ShadowView;

constexpr float kRadius = 0.5f;
constexpr glm::vec3 kBall{0, 2, 0};
// Their texels are about as large as a pixel: what a map holds is what they cast, the ball's square or the spot's cone.
constexpr int kSunAtlas = 128, kSpotAtlas = 512;
constexpr double kTent = 2.5;  // texels

Light sun() {
    Light light{.direction = {-0.6f, 1, 0.25f}};
    light.shadow = {.casts = true};
    return light;
}
// `height`: degrees above the horizon; at an angle to the axes of the world and, low, of the map.
Light sun_at(float height) {
    const float angle = glm::radians(height), turn = glm::radians(25.0f);
    Light light{.direction = {-std::cos(angle) * std::cos(turn), std::sin(angle), std::cos(angle) * std::sin(turn)}};
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

// A floor of y = 0 that shows its shadow; the camera looks straight down on a square of it.
World floor_scene(const Light& light, int size, float floor, glm::vec3 middle, float seen) {
    World world{.view = runtime::default_scene("")};
    world.view.width = world.view.height = size;
    world.view.samples = 1;
    world.view.lights = {light};
    world.view.camera = {
        .position = middle + glm::vec3(0, 0.9f, 0.001f), .target = middle, .orthographic_height = seen};
    const std::string receiver = written("receiver.graph.json", R"json({ "patina": 1, "workflow": "unlit",
  "nodes": [ { "id": "shadow", "expr": "@light.shadow" } ], "surface": { "color": "= float3(shadow)" } })json");
    const glm::mat4 flat = glm::rotate(glm::mat4(1), glm::radians(-90.0f), {1, 0, 0});
    add_object(world, receiver, "plane", 1, glm::scale(flat, glm::vec3(floor / 2)));
    return world;
}

// The camera sees the ball's shadow whole, and not the ball. `floor`: metres along a side.
World scene(const Light& light, int size, const std::string& caster, float floor = 8) {
    const glm::vec3 way = way_past_ball(light);
    const glm::vec3 middle = kBall + way * (-kBall.y / way.y);
    World world = floor_scene(light, size, floor, middle, 1.9f / std::abs(way.y));
    add_object(world, caster, "sphere", 256, glm::scale(glm::translate(glm::mat4(1), kBall), glm::vec3(kRadius)));
    return world;
}

std::string plain_caster() {
    return written("plain.graph.json", R"json({ "patina": 1, "workflow": "unlit" })json");
}

// The map as the frame has it: every object casts.
ShadowView map_of(const World& world, int atlas) {
    const Light& light = world.view.lights[0];
    const runtime::ShadowTile tile{.number = 0, .atlas_size = atlas};
    std::vector<runtime::ShadowObject> all;
    for (const runtime::WorldObject& object : world.objects)
        all.push_back({.mesh = object.mesh.get(), .object_to_world = object.object_to_world});
    return light.kind == LightKind::Spot
               ? runtime::spot_shadow(light, tile)
               : runtime::directional_shadow(light, all, runtime::camera_view(world.view), {}, tile);
}

class Measured {
public:
    Measured(const World& world, const Image& image, int atlas) : world_(world), map_(map_of(world, atlas)) {
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

    // How far the normal bias moves the outline, where the light grazes the ball; a spot's in the texels that are
    // there.
    double bias_in_texels() const { return double(world_.view.lights[0].shadow.normal_bias); }
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

void expect_shadow(const Light& light, int atlas, float floor = 8) {
    const World world = scene(light, 192, plain_caster(), floor);
    const Image image = draw(world, {.path = "forward", .shadow_atlas_size = atlas});
    const Measured measured(world, image, atlas);
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
    expect_shadow(sun(), kSunAtlas);
}

TEST(Shadow, OfASpotIsWhereRaysSayItIs) {
    expect_shadow(spot(), kSpotAtlas);
}

// Whatever the floor's size, the map holds the ball, and its texels are as large.
TEST(Shadow, OfTheSunIsThereForEveryHeightAndFloor) {
    for (float height : {11.0f, 26.0f, 44.0f, 80.0f}) {
        for (float floor : {30.0f, 600.0f}) {
            SCOPED_TRACE(testing::Message() << "height " << height << " floor " << floor);
            expect_shadow(sun_at(height), kSunAtlas, floor);
        }
    }
}

TEST(Shadow, OfASpotIsThereForEveryRangeAndCone) {
    for (float range : {10.0f, 200.0f, 900.0f}) {
        SCOPED_TRACE(testing::Message() << "range " << range);
        Light light = spot();
        light.range = range;
        expect_shadow(light, kSpotAtlas);
    }
    Light wide = spot();
    wide.outer_angle = 80;
    expect_shadow(wide, 4096);
    wide.outer_angle = 90;  // the map holds 85
    expect_shadow(wide, 8192);
}

double least(const Image& image) {
    double least = 1;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) least = std::min(least, double(image.pixels[i]));
    return least;
}

// Of @light.shadow on a floor on which nothing stands.
double least_on_lone_floor(const Light& light, float floor, glm::vec3 middle, float seen, bool on_cpu = false) {
    const World world = floor_scene(light, 96, floor, middle, seen);
    RenderOptions options{.path = "forward", .shadow_atlas_size = 512};
    if (on_cpu) options.via = "cpu";
    return least(draw(world, options));
}

TEST(Shadow, OfALoneFloorIsNone) {
    for (float floor : {10.0f, 20.0f, 40.0f, 80.0f, 600.0f})
        for (float height : {11.0f, 26.0f, 44.0f, 62.0f, 80.0f})
            EXPECT_GE(least_on_lone_floor(sun_at(height), floor, {}, floor / 4), 1 - kStep) << floor << " " << height;
    EXPECT_GE(least_on_lone_floor(sun_at(26), 600, {}, 60, true), 1 - kStep);

    for (float range : {10.0f, 200.0f, 900.0f}) {
        Light light = spot();
        light.range = range;
        light.outer_angle = 50;
        EXPECT_GE(least_on_lone_floor(light, 8, {}, 8), 1 - kStep) << range;
        EXPECT_GE(least_on_lone_floor(light, 600, {}, 8), 1 - kStep) << range;
        light.position *= range / 9;  // at six tenths of the range
        EXPECT_GE(least_on_lone_floor(light, 2 * range, {}, range), 1 - kStep) << range;
    }
}

// Without the light's own biases, what the filter needs is all there is: on planes that fall off along an axis of the
// map or between both: no texel that the filter weighs, however little, is in front; ...
TEST(Shadow, OfALonePlaneIsNoneWithoutBiases) {
    Light light = sun();
    light.shadow.bias = light.shadow.normal_bias = 0;
    const glm::mat3 to_world = glm::transpose(glm::mat3(runtime::world_to_light(light)));
    for (float theta : {10.0f, 45.0f, 75.0f, 80.0f}) {
        for (float turn : {0.0f, 20.0f, 45.0f}) {
            const float t = glm::radians(theta), u = glm::radians(turn);
            const glm::vec3 normal =
                to_world * glm::vec3(std::sin(t) * std::cos(u), std::sin(t) * std::sin(u), std::cos(t));
            World world = floor_scene(light, 96, 40, {}, 10);
            world.view.camera.position = 30.0f * normal;
            world.objects[0].object_to_world =
                glm::scale(glm::inverse(runtime::world_to_view({.position = normal, .target = {}})), glm::vec3(20));
            EXPECT_GE(least(draw(world, {.path = "forward", .shadow_atlas_size = 512})), 1 - 1e-5)
                << theta << " " << turn;
        }
    }
}

// ... and on a ball of 24 texels, up to 60 degrees from the light.
TEST(Shadow, OfALoneBallIsNoneOnItsLitSideWithoutBiases) {
    Light light = sun();
    light.shadow.bias = light.shadow.normal_bias = 0;
    World world = floor_scene(light, 192, 8, {}, 2 * kRadius * std::sin(glm::radians(60.0f)));
    world.objects.clear();
    const glm::mat4 ball = glm::scale(glm::mat4(1), glm::vec3(kRadius));
    world.objects.push_back({.name = "ball",
                             .mesh = std::make_shared<const runtime::Mesh>(*runtime::make_mesh("sphere", 512)),
                             .object_to_world = ball});
    world.view.camera.position = 3.0f * glm::normalize(light.direction);
    const Image image = draw(world, {.path = "forward", .shadow_atlas_size = kSunAtlas});
    double darkest = 1;
    for (int y = 0; y < 192; ++y)
        for (int x = 0; x < 192; ++x)
            if (std::hypot(x - 95.5, y - 95.5) < 95) darkest = std::min(darkest, double(image.at(x, y)[0]));
    EXPECT_GE(darkest, 1 - kStep);
}

// A box whose foot is on the floor: behind it, the shadow begins where the box ends.
TEST(Shadow, OfABoxBeginsAtItsFoot) {
    const float half = 0.5f;
    for (float height : {26.0f, 44.0f, 62.0f}) {
        const Light light = sun_at(height);
        World world = floor_scene(light, 192, 600, {}, 3);
        world.view.camera.position.y = 3;
        add_object(world, plain_caster(), "cube", 1,
                   glm::scale(glm::translate(glm::mat4(1), {0, half, 0}), glm::vec3(half / 0.75f)));
        const Image image = draw(world, {.path = "forward"});
        const double texel = 3.0 / 1000;  // and less: the box is smaller than 3 m however it is seen
        int close = 0;
        for (int y = 0; y < 192; ++y) {
            for (int x = 0; x < 192; ++x) {
                const glm::dvec3 point((x + 0.5) / 64 - 1.5, 0, (y + 0.5) / 64 - 1.5);
                const double past_foot = std::max(std::abs(point.x), std::abs(point.z)) - double(half);
                if (past_foot <= 0.01 || past_foot > 0.1) continue;  // the box itself, or far from its foot
                // The ray leaves the box's height at `top`: within the box, by more than the filter's reach, it hit it.
                const auto hits = [&](double aside_x, double aside_z) {
                    const glm::dvec3 way(light.direction);
                    for (int step = 0; step <= 400; ++step) {
                        const glm::dvec3 at = point + glm::dvec3(aside_x, 0, aside_z) + way * (step / 400.0 / way.y);
                        if (std::max(std::abs(at.x), std::abs(at.z)) <= double(half) && at.y <= 2 * double(half))
                            return true;
                    }
                    return false;
                };
                const double reach = 5 * texel / double(light.direction.y);
                if (!hits(0, 0) || !hits(reach, reach) || !hits(-reach, reach) || !hits(reach, -reach) ||
                    !hits(-reach, -reach))
                    continue;
                ++close;
                EXPECT_EQ(image.at(x, y)[0], 0) << height << " at " << point.x << " " << point.z;
            }
        }
        EXPECT_GT(close, 100);
    }
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
    const Image coarse = draw(world, {.path = "forward", .shadow_atlas_size = 128});
    const Image fine = draw(world, {.path = "forward", .shadow_atlas_size = 1024});
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
  "surface": { "alpha": "= step(0, @positionOS.z)" }, "render": { "surface": "cutout", "cull": "off" } })json");
    const World whole = scene(sun(), 128, plain_caster()), half = scene(sun(), 128, caster);
    const RenderOptions options{.path = "forward"};
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
