#include "paths/drawing/matt_plane.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace patina::paths {

double right(int x) {
    return 2 * (x + 0.5) / kSide - 1;
}
double up(int y) {
    return 1 - 2 * (y + 0.5) / kSide;
}

std::string matt() {
    return written("matt.graph.json",
                   R"({"patina":1,"workflow":"metallic-roughness","lighting":"lambert","surface":{"baseColor":0.5}})");
}

World matt_plane(int segments) {
    World world;
    world.view.width = world.view.height = kSide;
    world.view.background = glm::vec4(0);
    world.view.camera = {
        .position = {0, 0, 4}, .target = {0, 0, 0}, .fov = float(2 * std::atan(0.25) * 180 / std::numbers::pi)};
    add_object(world, matt(), "plane", segments, glm::mat4(1));
    return world;
}

World matt_plane_of_pixels() {
    World world = matt_plane(kSide + 1);
    world.objects[0].object_to_world = glm::scale(glm::mat4(1), glm::vec3(float(kSide + 1) / kSide));
    return world;
}

void expect_everywhere(const Image& image, const std::function<glm::dvec3(int x, int y)>& expected, double tolerance,
                       const std::function<bool(int x, int y)>& counts) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            if (counts && !counts(x, y)) continue;
            const glm::dvec3 wanted = expected(x, y);
            for (int c = 0; c < 3; ++c) {
                const double got = double(image.at(x, y)[std::size_t(c)]);
                ASSERT_NEAR(got, wanted[c], tolerance * std::max(1.0, wanted[c]))
                    << "pixel (" << x << ", " << y << "), channel " << c;
            }
        }
}

}  // namespace patina::paths
