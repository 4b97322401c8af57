// The studio around a material: ambient light in closed form, cameras, and the words that describe them.
#include "runtime/scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/type_precision.hpp>
#include <numbers>

#include "runtime/scene/scene_text.h"

namespace patina::runtime {
namespace {

glm::vec3 radiance(const SphericalHarmonics& sh, glm::vec3 direction) {
    std::array<float, 9> basis = spherical_harmonics_basis(glm::normalize(direction));
    glm::vec3 sum(0);
    for (std::size_t i = 0; i < 9; i++) sum += sh.coefficients[i] * basis[i];
    return sum;
}

void expect_near(glm::vec3 value, glm::vec3 expected, float tolerance = 1e-5f) {
    for (int c = 0; c < 3; c++) EXPECT_NEAR(value[c], expected[c], tolerance) << "channel " << c;
}

const glm::vec3 kDirections[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0},
                                 {0, 0, 1}, {0, 0, -1}, {1, 1, 1}, {-1, 2, 3}};

TEST(SphericalHarmonics, BasisIsOrthonormal) {
    // Gauss-Legendre would be exact; the midpoint rule over z and the angle is near enough.
    constexpr int kRows = 400, kColumns = 64;
    double product[9][9] = {};
    for (int row = 0; row < kRows; row++) {
        double z = (row + 0.5) / kRows * 2 - 1, radius = std::sqrt(1 - z * z);
        for (int column = 0; column < kColumns; column++) {
            double angle = 2 * std::numbers::pi * (column + 0.5) / kColumns;
            auto basis = spherical_harmonics_basis(glm::vec3(radius * std::cos(angle), radius * std::sin(angle), z));
            double weight = 4 * std::numbers::pi / (kRows * kColumns);
            for (int i = 0; i < 9; i++)
                for (int j = 0; j < 9; j++) product[i][j] += basis[i] * basis[j] * weight;
        }
    }
    for (int i = 0; i < 9; i++)
        for (int j = 0; j < 9; j++) EXPECT_NEAR(product[i][j], i == j ? 1 : 0, 1e-4) << i << ", " << j;
}

TEST(SphericalHarmonics, ConstantLightIsConstant) {
    glm::vec3 color(0.2f, 0.5f, 3);
    for (glm::vec3 direction : kDirections) expect_near(radiance(constant_ambient(color), direction), color);
}

TEST(SphericalHarmonics, GradientIsTheParabolaThatItSays) {
    glm::vec3 sky(0.3f, 0.4f, 0.9f), horizon(0.5f, 0.2f, 0.1f), ground(0.1f, 0.05f, 0);
    SphericalHarmonics sh = gradient_ambient(sky, horizon, ground);
    expect_near(radiance(sh, {0, 1, 0}), sky);
    expect_near(radiance(sh, {0, -1, 0}), ground);
    expect_near(radiance(sh, {1, 0, 0}), horizon);
    expect_near(radiance(sh, {0.6f, 0, -0.8f}), horizon);
    float y = 0.5f;
    expect_near(radiance(sh, {std::sqrt(1 - y * y), y, 0}),
                horizon + (sky - ground) * (y / 2) + ((sky + ground) / 2.0f - horizon) * (y * y));
}

TEST(Camera, LooksAlongMinusZWithYUp) {
    Camera camera;  // at 0, 0, 4, looking at the origin
    glm::mat4 to_clip = view_to_clip(camera, 1) * world_to_view(camera);
    glm::vec4 center = to_clip * glm::vec4(0, 0, 0, 1);
    EXPECT_NEAR(center.x, 0, 1e-6);
    EXPECT_NEAR(center.y, 0, 1e-6);
    EXPECT_NEAR(center.w, 4, 1e-5);
    EXPECT_GT((to_clip * glm::vec4(0, 1, 0, 1)).y, 0);
    EXPECT_GT((to_clip * glm::vec4(1, 0, 0, 1)).x, 0);
    // fov is vertical: a point at half its angle is at the upper edge.
    float edge = 4 * std::tan(glm::radians(camera.fov / 2));
    glm::vec4 upper = to_clip * glm::vec4(0, edge, 0, 1);
    EXPECT_NEAR(upper.y / upper.w, 1, 1e-5);
}

TEST(Camera, DepthGoesFromNoughtToOne) {
    for (bool parallel : {false, true}) {
        Camera camera;
        if (parallel) camera.orthographic_height = 2;
        glm::mat4 to_clip = view_to_clip(camera, 1);
        glm::vec4 at_near = to_clip * glm::vec4(0, 0, -camera.near_plane, 1);
        glm::vec4 at_far = to_clip * glm::vec4(0, 0, -camera.far_plane, 1);
        EXPECT_NEAR(at_near.z / at_near.w, 0, 1e-5);
        EXPECT_NEAR(at_far.z / at_far.w, 1, 1e-5);
    }
}

TEST(Camera, StraightDownIsNoSingularity) {
    Camera camera{.position = {0, 5, 0}};
    glm::vec4 right = world_to_view(camera) * glm::vec4(1, 0, 0, 1);
    EXPECT_NEAR(right.x, 1, 1e-6);
    EXPECT_NEAR(right.z, -5, 1e-5);
}

// The picture turns clockwise by what the camera turns counter-clockwise.
TEST(Camera, UpTurnsThePicture) {
    const glm::mat4 to_view = world_to_view({.position = {0, 0, 4}, .up = {-3, 0, 0}});
    const glm::vec4 above = to_view * glm::vec4(0, 1, 0, 1);
    EXPECT_NEAR(above.x, 1, 1e-6);
    EXPECT_NEAR(above.y, 0, 1e-6);
    EXPECT_NEAR(above.z, -4, 1e-6);
}

TEST(DefaultScene, FramesEveryMesh) {
    for (std::string_view name : mesh_names()) {
        Scene scene = default_scene(name);
        glm::mat4 to_clip = view_to_clip(scene.camera, 1) * world_to_view(scene.camera);
        float extent = 0;
        for (const Vertex& vertex : scene.mesh.vertices) {
            glm::vec4 p = to_clip * glm::vec4(vertex.position, 1);
            extent = std::max({extent, std::abs(p.x / p.w), std::abs(p.y / p.w)});
        }
        EXPECT_LT(extent, 0.97f) << name;
        EXPECT_GT(extent, 0.7f) << name;
    }
}

TEST(DefaultScene, KeyLightComesFromTheUpperLeftFront) {
    glm::vec3 key = default_lights().front().direction;
    EXPECT_LT(key.x, 0);
    EXPECT_GT(key.y, 0);
    EXPECT_GT(key.z, 0);
}

TEST(ParseLight, ReadsEachKind) {
    Outcome<Light> point = parse_light("point position=1,2,0 color=#ff0000 intensity=3 range=5");
    ASSERT_TRUE(point) << point.error;
    EXPECT_EQ(point.value.kind, LightKind::Point);
    EXPECT_EQ(point.value.position, glm::vec3(1, 2, 0));
    EXPECT_EQ(point.value.color, glm::vec3(3, 0, 0));
    EXPECT_EQ(point.value.range, 5);

    Outcome<Light> spot = parse_light("  spot direction=0,-1,0   inner=40 ");
    ASSERT_TRUE(spot) << spot.error;
    EXPECT_EQ(spot.value.kind, LightKind::Spot);
    EXPECT_GT(spot.value.outer_angle, spot.value.inner_angle);

    Outcome<Light> sun = parse_light("directional direction=-1,1,1 color=0.5");
    ASSERT_TRUE(sun) << sun.error;
    EXPECT_EQ(sun.value.color, glm::vec3(0.5f));
}

TEST(ParseLight, SaysWhatIsWrong) {
    struct Case {
        const char* text;
        const char* expected;
    };
    for (Case each :
         {Case{"", "'directional', 'point' or 'spot'"}, Case{"lamp", "'lamp'"},
          Case{"point direction=0,1,0", "has no 'direction'; it has color, intensity, position, range"},
          Case{"point range=nan", "range must be one number"}, Case{"point range=-1", "range must be between"},
          Case{"directional direction=0,0,0", "longer than zero"}, Case{"point range=1 range=2", "twice"},
          Case{"spot inner=50 outer=20", "inner must not be larger"}, Case{"point color=#12345", "color must be"}}) {
        Outcome<Light> light = parse_light(each.text);
        ASSERT_FALSE(light) << each.text;
        EXPECT_NE(light.error.find(each.expected), std::string::npos) << light.error;
    }
}

TEST(ParseAmbient, ReadsColorsAndGradients) {
    expect_near(radiance(parse_ambient("0.25").value, {1, 2, 3}), glm::vec3(0.25f));
    expect_near(radiance(parse_ambient("none").value, {1, 2, 3}), glm::vec3(0));
    Outcome<SphericalHarmonics> gradient = parse_ambient("sky=#ffffff ground=0");
    ASSERT_TRUE(gradient) << gradient.error;
    expect_near(radiance(gradient.value, {0, 1, 0}), glm::vec3(1));
    expect_near(radiance(gradient.value, {1, 0, 0}), glm::vec3(0.5f));
    expect_near(radiance(gradient.value, {0, -1, 0}), glm::vec3(0));
    EXPECT_FALSE(parse_ambient("bright"));
    EXPECT_FALSE(parse_ambient("sky=1 sea=2"));
    EXPECT_FALSE(parse_ambient(""));
}

TEST(ParseEnvironment, AFileAndItsSettings) {
    const auto plain = parse_environment("my sunset.hdr");
    ASSERT_TRUE(plain) << plain.error;
    EXPECT_EQ(plain.value.path, "my sunset.hdr");
    EXPECT_EQ(plain.value.rotation, 0);
    EXPECT_EQ(plain.value.intensity, 1);
    const auto set = parse_environment("a=b.hdr  intensity=0.5 rotation=-90");
    ASSERT_TRUE(set) << set.error;
    EXPECT_EQ(set.value.path, "a=b.hdr");
    EXPECT_EQ(set.value.rotation, -90);
    EXPECT_EQ(set.value.intensity, 0.5);
    for (const char* wrong :
         {"", "rotation=90", "a.hdr intensity=-1", "a.hdr rotation=x", "a.hdr rotation=1 rotation=2",
          "studio rotation=90", "none intensity=2", "a.hdr rotate=90"})
        EXPECT_FALSE(parse_environment(wrong)) << wrong;
}

TEST(ParseCamera, ChangesOnlyWhatIsSaid) {
    Camera base{.position = {1, 2, 3}, .fov = 20};
    Outcome<Camera> camera = parse_camera("target=0,1,0 orthographic=3", base);
    ASSERT_TRUE(camera) << camera.error;
    EXPECT_EQ(camera.value.position, base.position);
    EXPECT_EQ(camera.value.fov, 20);
    EXPECT_EQ(camera.value.target, glm::vec3(0, 1, 0));
    EXPECT_EQ(camera.value.orthographic_height, 3);
    EXPECT_FALSE(parse_camera("fov=0", base));
    EXPECT_FALSE(parse_camera("fov=180", base));
    EXPECT_FALSE(parse_camera("zoom=2", base));
    EXPECT_FALSE(parse_camera("position=0,0,0", Camera{}));
    EXPECT_FALSE(parse_camera("near=5 far=4", base));
}

TEST(ParseNumbers, TakesOneToFour) {
    int count = 0;
    EXPECT_EQ(parse_numbers("1, 2.5,-3e-1", count).value, glm::vec4(1, 2.5f, -0.3f, 0));
    EXPECT_EQ(count, 3);
    for (const char* wrong : {"", "a", "1,", ",1", "1 2", "1,2,3,4,5", "inf", "nan", "1e999", "0x10"})
        EXPECT_FALSE(parse_numbers(wrong, count)) << wrong;
}

TEST(ParseHexColor, DecodesSrgb) {
    Outcome<glm::vec4> color = parse_hex_color("#ff800040");
    ASSERT_TRUE(color) << color.error;
    EXPECT_NEAR(color.value.y, std::pow((128 / 255.0 + 0.055) / 1.055, 2.4), 1e-6);
    EXPECT_NEAR(color.value.w, 64 / 255.0, 1e-6);
    EXPECT_EQ(parse_hex_color("#f00").value, glm::vec4(1, 0, 0, 1));
    for (const char* wrong : {"", "#", "ff0000", "#ff", "#gg0000", "#ff00000", "#ff00-1"})
        EXPECT_FALSE(parse_hex_color(wrong)) << wrong;
}

}  // namespace
}  // namespace patina::runtime
