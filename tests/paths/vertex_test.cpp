// Vertex lit (Gouraud) comes to forward as the mesh is refined. Both draw the same mesh, so that they differ in nothing
// but the rate of lighting.
//
// Linear interpolation of f over triangles with sides of h misses it by h^2 |f''| / 4 at most in two dimensions (h^2 /
// 8 along each). Halving h leaves a quarter. Where light ends on a body, f has a bend: there a strip as wide as h is
// missed by h / 4 at most, which in the mean is h^2 again. A method of the first order would leave half. Less than
// sqrt(1/2 * 1/4) left, the geometric middle of both, is the second order.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "paths/drawing/drawing.h"

namespace patina::paths {
namespace {

World ball(const std::string& graph, int segments) {
    World world{.view = runtime::default_scene("")};
    world.view.width = world.view.height = 128;
    world.view.samples = 1;
    world.view.background = glm::vec4(0);
    world.view.camera = {.position = {0, 0, 4.5f}, .target = {0, 0, 0}, .fov = 28};
    world.view.lights = {{.direction = {-0.5f, 0.7f, 0.6f}, .color = {0.7f, 0.65f, 0.6f}},
                         {.kind = LightKind::Point, .position = {2.2f, 0.5f, 2}, .color = {1.5f, 2, 2.5f}, .range = 8}};
    add_object(world, graph, "sphere", segments, glm::mat4(1));
    return world;
}

std::string painted(const std::string& name, const std::string& lighting, const std::string& color) {
    return written(name + ".graph.json", R"({ "patina": 1, "workflow": "metallic-roughness", "lighting": ")" +
                                             lighting + R"(", "surface": { "baseColor": )" + color +
                                             R"(, "roughness": 0.6 } })");
}

// Over the pixels that show the ball.
double mean_error(const std::string& graph, int segments) {
    const World world = ball(graph, segments);
    const Image forward = draw(world, {.path = "forward"}), vertex = draw(world, {.path = "vertex"});
    const auto shows_ball = [&](int x, int y) { return forward.at(x, y)[3] > 0; };
    return difference(forward, vertex, shows_ball).mean;
}

void expect_second_order(const std::string& graph) {
    std::vector<double> errors;
    for (int segments : {24, 48, 96, 192}) errors.push_back(mean_error(graph, segments));
    for (std::size_t i = 1; i < errors.size(); ++i) {
        EXPECT_LT(errors[i], errors[i - 1] * std::sqrt(1.0 / 8)) << "doubled " << i << " times";
        std::printf("mean error %.3g / 255, %.2f times the one before\n", 255 * errors[i], errors[i] / errors[i - 1]);
    }
    EXPECT_LE(errors.back(), kStep);
}

TEST(VertexLit, ComesToForwardByTheSquare) {
    for (const char* model : {"lambert", "blinn-phong", "unity-brdf1", "gltf"}) {
        SCOPED_TRACE(model);
        expect_second_order(painted(model, model, "[0.8, 0.6, 0.5]"));
    }
}

// A diffuse texture is multiplied in each pixel, however coarse the mesh, where light is linear in the diffuse colour.
TEST(VertexLit, KeepsTheDiffuseTexture) {
    expect_second_order(painted("striped", "lambert", R"word("= float3(step(0.5, frac(@uv0.x * 24)), 0.5, 0.2)")word"));
}

// The bound above in numbers, for Lambert's sun alone: |f''| is the light's colour times the cosine, 0.7 at most, and
// the strip where light ends is a share of the ball of h at most.
TEST(VertexLit, IsAsFarFromForwardAsInterpolationIs) {
    for (int segments : {24, 96}) {
        World world = ball(painted("white", "lambert", "[1, 1, 1]"), segments);
        world.view.lights.resize(1);
        const Image forward = draw(world, {.path = "forward"}), vertex = draw(world, {.path = "vertex"});
        const auto shows_ball = [&](int x, int y) { return forward.at(x, y)[3] > 0; };
        const double h = 2 * std::numbers::pi / segments;
        const Difference far = difference(forward, vertex, shows_ball);
        EXPECT_LE(far.mean, 0.7 * (h * h / 4 + h * h / 4)) << to_text(far);
        EXPECT_GT(far.mean, 0.7 * h * h / 100) << "as if every pixel had been lit";
    }
}

// Seen in parallel, under the sun, all is the same everywhere on a plane but its colour: whatever the lighting graph,
// the picture of forward comes out of four vertices, or a note says that the colour is lost between them.
TEST(VertexLit, KeepsTheColourOfPixelsOrSaysSo) {
    int kept = 0, lost = 0;
    for (const ModelInfo& model : compiler().lighting_models()) {
        SCOPED_TRACE(model.name);
        World world;
        world.view.width = world.view.height = 32;
        world.view.camera = {.position = {0, 0, 4}, .target = {0, 0, 0}, .orthographic_height = 1.9f};
        world.view.ambient = runtime::constant_ambient(glm::vec3(0.25f));
        world.view.lights = {{.direction = {0.5f, 0.25f, 1}, .color = glm::vec3(1.5f)}};
        add_object(world,
                   painted("stripes_" + model.name, model.name, R"("= 0.2 + step(0.5, frac(@uv0.x * 7)) * 0.6")"),
                   "plane", 1, glm::mat4(1));
        const Image forward = draw(world, {.path = "forward", .exact_targets = true});
        const Drawn vertex = drawn(world, {.path = "vertex", .exact_targets = true});
        const std::vector<std::string> codes = vertex.codes();
        const bool is_lost = std::find(codes.begin(), codes.end(), "path-loses") != codes.end();
        const double largest = difference(forward, vertex.image).largest;
        if (is_lost) {
            EXPECT_GT(largest, 5 * kStep) << "the note is wrong";
        } else {
            EXPECT_LE(largest, kStep) << "no note says that something is lost";
        }
        (is_lost ? lost : kept) += 1;
    }
    EXPECT_GT(kept, 8);
    EXPECT_GT(lost, 0);
}

}  // namespace
}  // namespace patina::paths
