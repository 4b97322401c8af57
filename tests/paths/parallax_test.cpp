// Parallax, by geometry: through which point of a plane with a relief each pixel looks. The picture's colours are the
// texture coordinates that a material would read there.
#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>

#include "paths/drawing/drawing.h"

namespace patina::paths {
namespace {

constexpr int kPixels = 96, kTexels = 64;
constexpr double kHeight = 0.1;  // of the relief, in units of uv; the plane is 2 m wide, so it is 0.2 m
constexpr const char* kWays[] = {"glsl", "hlsl", "cpu"};

// A height map, written as floats; its path.
std::string height_map(const std::string& name, const std::function<double(double u, double v)>& height) {
    Image image = runtime::make_image(kTexels, kTexels);
    for (int y = 0; y < kTexels; ++y)
        for (int x = 0; x < kTexels; ++x) image.at(x, y)[0] = float(height((x + 0.5) / kTexels, (y + 0.5) / kTexels));
    const std::string path = written(name, "");
    EXPECT_EQ(runtime::save_exr(path, image), "");
    return path;
}

// The step's edges are sharp, a slope is interpolated.
std::string graph(const std::string& name, const std::string& filter, const std::string& offset) {
    return written(name, R"({ "patina": 1, "workflow": "unlit", "properties": [
  { "name": "_ParallaxMap", "type": "texture2d", "usage": "data",
    "sampler": { "wrap": "clamp", "filter": ")" +
                             filter + R"(" } },
  { "name": "_Parallax", "type": "float", "default": 0.1 }
], "nodes": [
  { "id": "view", "node": "WorldToTangent" },
  )" + offset + R"json(
], "surface": { "color": "= float3(@uv0 + offset, 0)" } })json");
}

std::string occlusion(const std::string& name, const std::string& filter, int fewest, int most) {
    return graph(name, filter,
                 fmt::format(R"({{ "id": "offset", "node": "ParallaxOcclusion", "in": {{
      "texture": "$_ParallaxMap", "height": "$_Parallax", "viewTS": "view",
      "fewestSteps": {}, "mostSteps": {} }} }})",
                             fewest, most));
}

// 3 m from the middle of the plane, which faces +z.
World seen_from(const glm::vec3& direction, const std::string& graph, const std::string& heights) {
    World world;
    world.view.width = world.view.height = kPixels;
    world.view.background = glm::vec4(-1);
    world.view.camera = {.position = 3.0f * glm::normalize(direction), .target = {0, 0, 0}, .fov = 40};
    add_object(world, graph, "plane", 8, glm::mat4(1), {{"_ParallaxMap", heights}});
    return world;
}

struct Sight {
    glm::dvec2 uv;    // where a pixel's line of sight meets the plane
    glm::dvec3 view;  // from there to the camera, unit
};

// None: it passes the plane by.
std::optional<Sight> sight(const World& world, int x, int y) {
    const glm::dmat4 to_world = glm::inverse(glm::dmat4(runtime::view_to_clip(world.view.camera, 1)) *
                                             glm::dmat4(runtime::world_to_view(world.view.camera)));
    const glm::dvec4 far = to_world * glm::dvec4(2 * (x + 0.5) / kPixels - 1, 1 - 2 * (y + 0.5) / kPixels, 1, 1);
    const glm::dvec3 camera(world.view.camera.position), way = glm::dvec3(far) / far.w - camera;
    const glm::dvec3 point = camera - way * (camera.z / way.z);
    if (std::abs(point.x) > 0.98 || std::abs(point.y) > 0.98) return {};
    return Sight{.uv = {(point.x + 1) / 2, (1 - point.y) / 2}, .view = -glm::normalize(way)};
}

// How far the line of sight moves over the texture while it sinks by the whole height: to the left of a camera on the
// right, and downwards in the picture from a camera above.
glm::dvec2 path_of(const Sight& sight) {
    return kHeight * glm::dvec2(-sight.view.x, sight.view.y) / sight.view.z;
}

constexpr glm::vec3 kFrom[] = {{0.9f, 0, 1}, {-0.9f, 0.2f, 1}, {0.1f, 0.8f, 1}, {0.3f, -1, 0.8f}};

// Pixels of the picture whose line of sight stays over the texture, each with what is right there and how near it must
// come; none where nothing is expected.
struct Expected {
    glm::dvec2 uv;
    double tolerance;
};
void expect_reads(const World& world, const std::string& via,
                  const std::function<std::optional<Expected>(const Sight& sight)>& expected) {
    SCOPED_TRACE(via);
    const Image image = draw(world, {.via = via, .exact_textures = true, .exact_targets = true});
    int compared = 0;
    for (int y = 0; y < kPixels; ++y) {
        for (int x = 0; x < kPixels; ++x) {
            const std::optional<Sight> at = sight(world, x, y);
            if (!at) continue;
            const std::optional<Expected> wanted = expected(*at);
            if (!wanted) continue;
            ++compared;
            const auto got = image.at(x, y);
            ASSERT_NEAR(double(got[0]), wanted->uv.x, wanted->tolerance) << "u at pixel (" << x << ", " << y << ")";
            ASSERT_NEAR(double(got[1]), wanted->uv.y, wanted->tolerance) << "v at pixel (" << x << ", " << y << ")";
        }
    }
    EXPECT_GT(compared, 1000);
}

// The upper half of the texture, or its left half, stands high; the rest lies at the bottom.
double step_along(glm::dvec2 uv, int axis) {
    return uv[axis] < 0.5 ? 1 : 0;
}
std::string step_map(int axis) {
    return height_map(fmt::format("step{}.exr", axis), [axis](double u, double v) { return step_along({u, v}, axis); });
}

// A line of sight over the low half runs into the step, or down to the ground. A step of the search is as near as the
// wall is found.
TEST(ParallaxOcclusion, SeesTheWallOfAStepAndHidesWhatLiesBehind) {
    constexpr int kSteps = 128;
    for (const int axis : {0, 1}) {
        const std::string graph = occlusion("wall.graph.json", "nearest", kSteps, kSteps), heights = step_map(axis);
        for (const glm::vec3& from : kFrom) {
            SCOPED_TRACE(fmt::format("a step along {} from ({}, {}, {})", "uv"[axis], from.x, from.y, from.z));
            for (const char* via : kWays) {
                expect_reads(seen_from(from, graph, heights), via, [&](const Sight& at) -> std::optional<Expected> {
                    const glm::dvec2 path = path_of(at);
                    if (std::abs(at.uv[axis] - 0.5) < 1e-3) return {};  // either side of the edge
                    double t = 1;
                    if (at.uv[axis] < 0.5)
                        t = 0;
                    else if (at.uv[axis] + path[axis] < 0.5)
                        t = (0.5 - at.uv[axis]) / path[axis];
                    return Expected{at.uv + t * path, glm::length(path) / kSteps + 1e-4};
                });
            }
        }
    }
}

// Where the ground begins to show beside a step that hides it, in texels from the edge: height times the tangent of the
// angle between view and normal, along u. A pixel is less than a texel wide.
TEST(ParallaxOcclusion, MovesTheSilhouetteOfAStepByThePredictedTexels) {
    const World world = seen_from({0.9f, 0, 1}, occlusion("edge.graph.json", "nearest", 128, 128), step_map(0));
    for (const char* via : kWays) {
        SCOPED_TRACE(via);
        const Image image = draw(world, {.via = via, .exact_textures = true, .exact_targets = true});
        const int row = kPixels / 2;
        bool was_ground = false;
        for (int x = 0; x < kPixels && !was_ground; ++x) {
            const std::optional<Sight> at = sight(world, x, row);
            if (!at || at->uv.x < 0.5) continue;
            was_ground = std::abs(double(image.at(x, row)[0]) - (at->uv.x + path_of(*at).x)) < 1e-4;
            const double predicted = kTexels * kHeight * at->view.x / at->view.z;
            if (was_ground) {
                EXPECT_NEAR(kTexels * (at->uv.x - 0.5), predicted, 1);
                EXPECT_GT(predicted, 4) << "the prediction says something";
            }
        }
        EXPECT_TRUE(was_ground);
    }
}

// Over a relief of one slope the cut with the straight line between two heights is exact, so few steps
// suffice: 1 - t = height = 1 - u - t path.u.
TEST(ParallaxOcclusion, MeetsASlopeExactly) {
    const std::string graph = occlusion("slope.graph.json", "linear", 3, 7);
    const std::string heights = height_map("slope.exr", [](double u, double) { return 1 - u; });
    for (const glm::vec3& from : kFrom) {
        for (const char* via : kWays) {
            expect_reads(seen_from(from, graph, heights), via, [&](const Sight& at) -> std::optional<Expected> {
                const glm::dvec2 path = path_of(at), read = at.uv + at.uv.x / (1 - path.x) * path;
                // What is read between here and there must be slope, which ends half a texel before the texture does.
                const auto is_slope = [](double u) { return u > 0.02 && u < 0.98; };
                if (!is_slope(at.uv.x) || !is_slope(at.uv.x + path.x)) return {};
                return Expected{read, 2e-4};
            });
        }
    }
}

// Seen in parallel at a cosine of 0.6, 8 to 32 steps are 32 - 24 * 0.6 = 17.6, so 18.
TEST(ParallaxOcclusion, TakesMoreStepsTheFlatterTheView) {
    const auto drawn_with = [](int fewest, int most, const char* via) {
        World world = seen_from({0.8f, 0, 0.6f}, occlusion("more.graph.json", "nearest", fewest, most), step_map(0));
        world.view.camera.orthographic_height = 2;
        return draw(world, {.via = via, .exact_textures = true, .exact_targets = true});
    };
    for (const char* via : kWays) {
        SCOPED_TRACE(via);
        const Image between = drawn_with(8, 32, via);
        EXPECT_LT(difference(between, drawn_with(18, 18, via)).largest, 1e-6);
        EXPECT_GT(difference(between, drawn_with(17, 17, via)).largest, 1e-3);
    }
}

// Where bricks hide the joints the coordinates jump; a level of detail by their differences would be a seam there.
TEST(ParallaxOcclusion, OfTheExampleReadsItsMapsWithTheLevelsOfTheWall) {
    const Result result = compiled("examples/surfaces/bricks_occlusion.graph.json", "forward");
    int shaders = 0;
    for (const Shader& shader : result.shaders) {
        if (shader.stage != Stage::Fragment || shader.target != Target::Glsl) continue;
        ++shaders;
        for (const char* map : {"_MainTex", "_BumpMap", "_ParallaxMap"}) {
            EXPECT_NE(shader.text.find(fmt::format("textureGrad(sampler2D({0}, ", map)), std::string::npos) << map;
            EXPECT_EQ(shader.text.find(fmt::format("texture(sampler2D({0}, ", map)), std::string::npos) << map;
        }
    }
    EXPECT_EQ(shaders, 1);
}

// One step: by the height right below, half of the relief above the plane, with the 0.42 of its source.
TEST(ParallaxOffset, MovesBothSidesOfAStepByItsFormula) {
    const std::string graph_file = graph("one_step.graph.json", "nearest", R"(
  { "id": "texel", "node": "SampleTexture2D", "in": { "texture": "$_ParallaxMap" } },
  { "id": "offset", "node": "ParallaxOffset",
    "in": { "texel": "texel.r", "height": "$_Parallax", "viewTS": "view" } })");
    for (const int axis : {0, 1}) {
        for (const glm::vec3& from : kFrom) {
            for (const char* via : kWays) {
                expect_reads(seen_from(from, graph_file, step_map(axis)), via,
                             [&](const Sight& at) -> std::optional<Expected> {
                                 if (std::abs(at.uv[axis] - 0.5) < 1e-3) return {};
                                 const double above = kHeight * (step_along(at.uv, axis) - 0.5);
                                 const glm::dvec2 towards_viewer(at.view.x, -at.view.y);
                                 return Expected{at.uv + above * towards_viewer / (at.view.z + 0.42), 1e-5};
                             });
            }
        }
    }
}

}  // namespace
}  // namespace patina::paths
