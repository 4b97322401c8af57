// The number of the vertex and of the instance, against the order of meshes and instances that the tests make.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "paths/drawing/drawing.h"

namespace patina::paths {
namespace {

struct Way {
    const char* path;
    const char* via;
};
constexpr Way kWays[] = {{"forward", "glsl"}, {"forward", "hlsl"}, {"forward", "cpu"}, {"deferred", "glsl"}};

constexpr int kSize = 64;
constexpr float kHeight = 4;  // world units that the picture shows

World empty_world() {
    World world;
    world.view.width = world.view.height = kSize;
    world.view.samples = 1;
    world.view.background = glm::vec4(0);
    world.view.camera = {.position = {0, 0, 5}, .target = {0, 0, 0}, .orthographic_height = kHeight};
    return world;
}

// The pixel that shows a place of the plane z = 0.
glm::ivec2 pixel_of(double x, double y) {
    return {int(std::floor((x / kHeight + 0.5) * kSize)), int(std::floor((0.5 - y / kHeight) * kSize))};
}
// The place that its centre shows.
glm::dvec2 place_of(glm::ivec2 pixel) {
    return {((pixel.x + 0.5) / kSize - 0.5) * kHeight, (0.5 - (pixel.y + 0.5) / kSize) * kHeight};
}

constexpr int kSquares = 5;
constexpr double kSide = 0.5;

// Squares of four vertices each, all at one place: x from -2, y from 0. The triangles of the last one come first.
runtime::Mesh squares() {
    runtime::Mesh mesh;
    for (int square = 0; square < kSquares; ++square) {
        for (int corner = 0; corner < 4; ++corner) {
            const glm::vec2 at(corner % 2, corner / 2);
            mesh.vertices.push_back({.position = {-2 + kSide * at.x, kSide * at.y, 0},
                                     .normal = {0, 0, 1},
                                     .tangent = {1, 0, 0, 1},
                                     .uv0 = at});
        }
    }
    for (std::uint32_t square = kSquares; square-- > 0;) {
        for (const std::uint32_t corner : {0u, 1u, 2u, 2u, 1u, 3u}) mesh.indices.push_back(4 * square + corner);
    }
    return mesh;
}

// The number moves each square to a place of its own; red is the number of the square, computed for each vertex, and
// green is the number of the vertex as the fragment stage reads it.
TEST(DrawNumbers, OfVerticesAreTheirOrderInTheMesh) {
    const std::string graph = written("numbered.graph.json", R"json({ "patina": 1, "workflow": "unlit", "nodes": [
  { "id": "number", "node": "VertexId" },
  { "id": "square", "expr": "floor(number / 4)", "stage": "vertex" } ],
  "vertex": { "positionOS": "= @positionOS + float3(0.75 * floor(number / 4), 0, 0)" },
  "surface": { "color": "= float3(square / 8, @vertexId / 32, 1)" },
  "render": { "bounds": 4 } })json");
    World world = empty_world();
    add_object(world, graph, "plane", 3, glm::mat4(1));
    world.objects.back().mesh = std::make_shared<const runtime::Mesh>(squares());
    for (const Way& way : kWays) {
        SCOPED_TRACE(fmt::format("along {} via {}", way.path, way.via));
        const Image image = draw(world, {.path = way.path, .via = way.via, .exact_targets = true});
        for (int square = 0; square < kSquares; ++square) {
            const double left = -2 + 0.75 * square;
            const glm::ivec2 pixel = pixel_of(left + 0.2, 0.3);
            const glm::dvec2 within = (place_of(pixel) - glm::dvec2(left, 0)) / kSide;
            // The numbers of the corners are 0, 1, 2 and 3 more than 4 times the square's.
            const double number = 4 * square + within.x + 2 * within.y;
            EXPECT_NEAR(image.at(pixel.x, pixel.y)[0], square / 8.0, 1e-5) << "square " << square;
            EXPECT_NEAR(image.at(pixel.x, pixel.y)[1], number / 32, 1e-5) << "square " << square;
            const glm::ivec2 between = pixel_of(left + 0.6, 0.3);
            EXPECT_EQ(image.at(between.x, between.y)[2], 0) << "beside square " << square;
        }
    }
}

// In the vertex stage the number moves the instance, in the fragment stage it colours it.
std::string numbered_instances() {
    return written("instances.graph.json", R"json({ "patina": 1, "workflow": "unlit", "nodes": [
  { "id": "number", "node": "InstanceId" } ],
  "vertex": { "positionOS": "= @positionOS + float3(0, 0.75 * number, 0)" },
  "surface": { "color": "= float3(number / 4, 1 - number / 4, @instanceId / 1024)" },
  "render": { "bounds": 4 } })json");
}

glm::mat4 at(float x, float y) {
    return glm::scale(glm::translate(glm::mat4(1), {x, y, 0}), glm::vec3(0.25f, 1, 1));
}

void expect_number(const Image& image, double x, double y, int number) {
    const glm::ivec2 pixel = pixel_of(x, y);
    const auto color = image.at(pixel.x, pixel.y);
    EXPECT_NEAR(color[0], number / 4.0, 1e-6) << "at " << x << ", " << y;
    EXPECT_NEAR(color[1], 1 - number / 4.0, 1e-6) << "at " << x << ", " << y;
}

// Planes of the height 0.5, whose instances begin at the height -1 and stand side by side.
TEST(DrawNumbers, OfInstancesAreTheirOrderInTheDraw) {
    World world = empty_world();
    add_object(world, numbered_instances(), "plane", 3, glm::mat4(1));
    runtime::Mesh mesh = *runtime::make_mesh("plane", 3);
    for (runtime::Vertex& vertex : mesh.vertices) vertex.position.y *= 0.25f;
    world.objects.back().mesh = std::make_shared<const runtime::Mesh>(mesh);
    for (int i = 0; i < 3; ++i) world.objects.back().instances.push_back({.object_to_world = at(float(i) - 1, -1)});
    World alone = world;
    alone.objects.back().instances.clear();
    alone.objects.back().object_to_world = at(1, -1);
    for (const Way& way : kWays) {
        SCOPED_TRACE(fmt::format("along {} via {}", way.path, way.via));
        const RenderOptions options{.path = way.path, .via = way.via, .exact_targets = true};
        const Image image = draw(world, options);
        for (int i = 0; i < 3; ++i) expect_number(image, i - 1, -1 + 0.75 * i, i);
        expect_number(draw(alone, options), 1, -1, 0);
    }
}

TEST(DrawNumbers, OfInstancesCountFromZeroInEachDraw) {
    const std::string graph = written("counted.graph.json", R"json({ "patina": 1, "workflow": "unlit",
  "surface": { "color": "= float3(@instanceId / 1024, 1, 0)" } })json");
    const std::uint32_t most = compiled(graph, "forward").reflection.most_instances;
    EXPECT_EQ(most, 16384u / (2 * 64 + 16));  // two matrices, and what a switch may add
    World world = empty_world();
    add_object(world, graph, "plane", 3, glm::mat4(1));
    // All but three are behind the camera.
    for (std::uint32_t i = 0; i <= most; ++i) {
        const bool is_seen = i == 1 || i + 1 >= most;
        const float x = i == 1 ? -1.0f : i == most ? 1.0f : 0.0f;
        const glm::mat4 place = glm::translate(glm::mat4(1), {x, 0, is_seen ? 0.0f : 20.0f});
        world.objects.back().instances.push_back({.object_to_world = glm::scale(place, glm::vec3(0.25f))});
    }
    const Image image = draw(world, {.exact_targets = true});
    const std::array<double, 3> numbers = {1, double(most) - 1, 0};
    for (int i = 0; i < 3; ++i) {
        const glm::ivec2 pixel = pixel_of(i - 1, 0);
        EXPECT_NEAR(image.at(pixel.x, pixel.y)[0], numbers[std::size_t(i)] / 1024, 1e-6) << i;
        EXPECT_EQ(image.at(pixel.x, pixel.y)[1], 1) << i;
    }
}

// The number alone makes the matrices arrays; a material without it keeps one matrix.
TEST(DrawNumbers, OfVerticesNeedNoInstances) {
    const std::string graph = written("plain.graph.json", R"json({ "patina": 1, "workflow": "unlit",
  "surface": { "color": "= float3(@vertexId / 1024, 1, 0)" } })json");
    EXPECT_EQ(compiled(graph, "forward").reflection.most_instances, 0u);
}

}  // namespace
}  // namespace patina::paths
