#include "paths/drawing/checkerboard.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "runtime/lighting/environment.h"

namespace patina::paths {
namespace {

constexpr int kSquares = 16;
const glm::dvec3 kDark(0.02, 0.1, 0.3), kLight(0.9, 0.8, 0.5);

}  // namespace

World checkerboard() {
    World world;
    world.view.width = world.view.height = kBoardPixels;
    world.view.background = glm::vec4(0);
    world.view.camera = {.position = {0, 0, 4}, .target = {0, 0, 0}, .orthographic_height = 2};
    static const auto kNothingAround =
        std::make_shared<const runtime::Environment>(runtime::constant_ambient(glm::vec3(0)));
    world.view.ambient = runtime::constant_ambient(glm::vec3(0));
    world.view.environment = kNothingAround;
    world.view.lights = {{.direction = {0, 0, 1}, .color = glm::vec3(kSun)}};
    const std::string board = written("board.graph.json", R"({ "patina": 1, "workflow": "unlit", "properties": [
  { "name": "_MainTex", "type": "texture2d", "usage": "data", "sampler": { "filter": "nearest" } }
], "nodes": [ { "id": "main", "node": "SampleTexture2D", "in": { "texture": "$_MainTex" } } ],
"surface": { "color": "main.rgb" } })");
    const std::string squares = written_texture("squares.exr", kSquares, kSquares, [](int x, int y) {
        return glm::dvec4((x + y) % 2 == 0 ? kDark : kLight, 1);
    });
    // Twice as large as the picture, which shows its middle.
    add_object(world, board, "plane", 1, glm::scale(glm::translate(glm::mat4(1), {0, 0, -1}), glm::vec3(2)),
               {{"_MainTex", squares}});
    return world;
}

glm::dvec2 uv_of(int x, int y) {
    return {(x + 0.5) / kBoardPixels, (y + 0.5) / kBoardPixels};
}

glm::dvec3 behind(int x, int y) {
    const glm::dvec2 square = glm::floor((0.25 + 0.5 * uv_of(x, y)) * double(kSquares));
    return (int(square.x) + int(square.y)) % 2 == 0 ? kDark : kLight;
}

double highlight(double smoothness) {
    const double alpha = (1 - smoothness) * (1 - smoothness), alpha2 = alpha * alpha;
    return kF0 / 4 * alpha2 / (alpha2 * alpha2 + 1e-7);
}

glm::dvec3 scattered(const glm::dvec3& color) {
    return color * (1 - kF0) * kSun;
}

void expect_pixels(const World& world, const std::function<glm::dvec3(int x, int y)>& expected, double tolerance) {
    for (const char* via : {"glsl", "hlsl", "cpu"}) {
        SCOPED_TRACE(fmt::format("via {}", via));
        const Image image = draw(world, {.via = via, .exact_textures = true, .exact_targets = true});
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                for (int c = 0; c < 3; ++c) {
                    const double wanted = expected(x, y)[c];
                    ASSERT_NEAR(double(image.at(x, y)[std::size_t(c)]), wanted, tolerance * std::max(1.0, wanted))
                        << "pixel (" << x << ", " << y << "), channel " << c;
                }
    }
}

}  // namespace patina::paths
