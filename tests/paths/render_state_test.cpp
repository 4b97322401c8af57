// The state in "render" has its effect, by formulas: planes in front of each other, along each path, on the GPU and the
// CPU. Every picture is 8 x 8 pixels of planes that fill it or its left half.
#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>

#include "paths/drawing/drawing.h"

namespace patina::paths {
namespace {

struct Way {
    const char* path;
    const char* via;
};
constexpr Way kWays[] = {{"forward", "glsl"}, {"forward", "hlsl"},  {"forward", "cpu"}, {"forward-add", "glsl"},
                         {"vertex", "glsl"},  {"deferred", "glsl"}, {"deferred", "cpu"}};

constexpr glm::vec3 kRed(1, 0, 0), kGreen(0, 1, 0), kBlue(0, 0, 1), kNothing(0);
constexpr double kDielectric = 0.04;  // f0 of the workflow: the diffuse colour has the rest

// Seen straight from the front; 8 m of the plane z = 0 fill the picture.
World empty_world() {
    World world;
    world.view.width = world.view.height = 8;
    world.view.background = glm::vec4(0, 0, 0, 1);
    world.view.camera = {.position = {0, 0, 40}, .target = {0, 0, 0}, .fov = float(glm::degrees(2 * std::atan(0.1)))};
    world.view.ambient = runtime::constant_ambient(glm::vec3(0));
    world.pixel_light_count = 4;
    return world;
}

// `depth` metres towards the camera. The mesh spans -1 to 1.
glm::mat4 wall(float depth, bool is_left_half = false) {
    const glm::mat4 placed = glm::translate(glm::mat4(1), {is_left_half ? -10 : 0, 0, depth});
    return glm::scale(placed, glm::vec3(10));
}

std::string unlit(const std::string& color, const std::string& render) {
    static int number = 0;
    return written(fmt::format("unlit_{}.graph.json", number++),
                   R"({ "patina": 1, "workflow": "unlit", "surface": { "color": )" + color + R"(, "alpha": 0.5 },
  "render": { )" + render +
                       " } }");
}

std::string matt(const std::string& render) {
    static int number = 0;
    return written(
        fmt::format("matt_{}.graph.json", number++),
        R"({ "patina": 1, "workflow": "metallic-roughness", "lighting": "lambert", "surface": { "baseColor": 0.5 },
  "render": { )" +
            render + " } }");
}

glm::vec3 at(const Image& image, int x, int y) {
    const auto pixel = image.at(x, y);
    return {pixel[0], pixel[1], pixel[2]};
}

// Left and right half.
void expect_halves(const World& world, const glm::vec3& left, const glm::vec3& right, double tolerance = 1e-6) {
    for (const Way& way : kWays) {
        SCOPED_TRACE(fmt::format("along {} via {}", way.path, way.via));
        const Image image = drawn(world, {.path = way.path, .via = way.via, .exact_targets = true}).image;
        for (int c = 0; c < 3; c++) {
            EXPECT_NEAR(at(image, 1, 3)[c], left[c], tolerance) << "left, " << c;
            EXPECT_NEAR(at(image, 6, 4)[c], right[c], tolerance) << "right, " << c;
        }
    }
}

TEST(RenderState, AStencilCutsAWindow) {
    World world = empty_world();
    add_object(world, unlit("[1, 0, 0]", R"("stencil": { "reference": 5, "pass": "replace" }, "depthWrite": false)"),
               "plane", 2, wall(0, true));
    add_object(world, unlit("[0, 1, 0]", R"("stencil": { "reference": 5, "test": "notEqual" }, "queue": 2001)"),
               "plane", 2, wall(-1));
    expect_halves(world, kRed, kGreen);
    world.objects.pop_back();
    add_object(world,
               unlit("[0, 1, 0]", R"("stencil": { "reference": 13, "readMask": 7, "test": "equal" }, "queue": 2001)"),
               "plane", 2, wall(1));
    expect_halves(world, kGreen, kNothing);
}

// Of a number all of whose bits are set, the bits of the mask arrive.
TEST(RenderState, AStencilWritesTheBitsOfItsMask) {
    for (const auto& [asked, is_seen] : {std::pair(6, true), std::pair(15, false), std::pair(0, false)}) {
        World world = empty_world();
        add_object(world, unlit("0", R"("stencil": { "reference": 15, "pass": "replace", "writeMask": 6 })"), "plane",
                   2, wall(0));
        add_object(world,
                   unlit("[0, 1, 0]",
                         fmt::format(R"("stencil": {{ "reference": {}, "test": "equal" }}, "queue": 2001)", asked)),
                   "plane", 2, wall(1));
        expect_halves(world, is_seen ? kGreen : kNothing, is_seen ? kGreen : kNothing);
    }
}

// A plane that is hidden by depth on the left, and one that the stencil lets through nowhere: what each leaves behind.
TEST(RenderState, AStencilKnowsWhyASurfaceIsNotSeen) {
    const auto numbers = [](const std::string& stencil, int left, int right) {
        SCOPED_TRACE(stencil);
        World world = empty_world();
        add_object(world, unlit("0", ""), "plane", 2, wall(2, true));
        add_object(world, unlit("0", R"("queue": 2001, "stencil": { "reference": 3, )" + stencil + " }"), "plane", 2,
                   wall(0));
        // They change what they test, so that along each path they go the way of the surface before them.
        const std::string shown =
            R"("queue": 2002, "depthTest": "always", "stencil": { "test": "equal", "pass": "zero", "reference": )";
        add_object(world, unlit("[1, 0, 0]", shown + fmt::format("{} }}", left)), "plane", 2, wall(0, true));
        add_object(world, unlit("[0, 1, 0]", shown + fmt::format("{} }}", right)), "plane", 2,
                   glm::translate(glm::mat4(1), {20, 0, 0}) * wall(0, true));
        expect_halves(world, kRed, kGreen);
    };
    const std::string words = R"("pass": "replace", "depthFail": "increment", "fail": "invert")";
    numbers(words, 1, 3);
    numbers(R"("test": "never", )" + words, 255, 255);
}

// Blended surfaces obey it too: each pixel once, however often the surface lies over itself.
TEST(RenderState, AStencilKeepsAFadingSurfaceFromCoveringItself) {
    World world = empty_world();
    const std::string once = unlit(
        "[1, 0, 0]", R"("surface": "fade", "stencil": { "reference": 1, "test": "notEqual", "pass": "replace" })");
    add_object(world, once, "plane", 2, wall(0));
    add_object(world, once, "plane", 2, wall(1, true));
    expect_halves(world, 0.5f * kRed, 0.5f * kRed);
    const std::string twice = unlit("[1, 0, 0]", R"("surface": "fade")");
    add_object(world, twice, "plane", 2, wall(2, true));
    expect_halves(world, 0.75f * kRed, 0.5f * kRed);
}

// A deferred wall behind, whose lighting marks its pixels with the number 1: the material's own stencil starts at 0.
TEST(RenderState, LightingByStencilDoesNotDisturbTheMaterials) {
    World world = empty_world();
    world.view.lights = {{.direction = {0, 0, 1}}};
    add_object(world, matt(""), "plane", 2, wall(-2));
    const auto lit = float(0.5 * (1 - kDielectric));
    add_object(world, unlit("[0, 0, 1]", R"("stencil": { "test": "equal", "reference": 1 })"), "plane", 2, wall(0));
    expect_halves(world, glm::vec3(lit), glm::vec3(lit), 1e-4);
    add_object(world, unlit("[1, 0, 0]", R"("stencil": { "reference": 1, "pass": "replace" }, "queue": 1999)"), "plane",
               2, wall(-1, true));
    expect_halves(world, kBlue, glm::vec3(lit), 1e-4);
}

// Two lights: the second is added in a pass of its own where the first has been drawn.
TEST(RenderState, LitSurfacesObeyTestsInEveryPass) {
    const auto lit = [](double light) { return glm::vec3(float(0.5 * (1 - kDielectric) * light)); };
    World world = empty_world();
    world.view.lights = {{.direction = {0, 0, 1}, .color = glm::vec3(0.5f)},
                         {.direction = {0, 0, 1}, .color = glm::vec3(0.25f)}};
    add_object(world, unlit("0", ""), "plane", 2, wall(1, true));  // black, in front on the left
    World marked = world;
    // Behind something only, as a silhouette is.
    add_object(world, matt(R"("depthTest": "greater", "queue": 2100)"), "plane", 2, wall(0));
    expect_halves(world, lit(0.75), kNothing, 1e-5);
    World silhouette = world;
    silhouette.objects.pop_back();
    add_object(silhouette, matt(R"("depthTest": "greater", "depthWrite": false, "queue": 2100)"), "plane", 2, wall(0));
    expect_halves(silhouette, lit(0.75), kNothing, 1e-5);
    World through = world;
    through.objects.pop_back();
    add_object(through, matt(R"("depthTest": "always", "queue": 2100)"), "plane", 2, wall(0));
    expect_halves(through, lit(0.75), lit(0.75), 1e-5);

    add_object(marked, unlit("0", R"("stencil": { "reference": 9, "pass": "replace" }, "queue": 1900)"), "plane", 2,
               wall(2, true));
    add_object(marked, matt(R"("stencil": { "reference": 9, "test": "equal" })"), "plane", 2, wall(3));
    expect_halves(marked, lit(0.75), kNothing, 1e-5);
}

// A path that draws an object for each light does not take a stencil that changes under it: it is drawn in one pass.
TEST(RenderState, AStencilThatChangesWhatItTestsIsDrawnOnce) {
    World world = empty_world();
    world.view.lights = {{.direction = {0, 0, 1}, .color = glm::vec3(0.5f)},
                         {.direction = {0, 0, 1}, .color = glm::vec3(0.25f)}};
    const std::string once = matt(R"("stencil": { "test": "equal", "pass": "increment" })");
    add_object(world, once, "plane", 2, wall(0));
    add_object(world, once, "plane", 2, wall(1));
    expect_halves(world, glm::vec3(0.36f), glm::vec3(0.36f), 1e-5);
    const Result result = compiled(once, "forward-add");
    EXPECT_EQ(result.reflection.path, "forward");
    ASSERT_FALSE(result.diagnostics.empty());
    EXPECT_EQ(result.diagnostics.front().code, "path-refused");
    EXPECT_EQ(result.diagnostics.front().line, 2);
}

// glPolygonOffset: the depth grows by factor * slope + units * r. Planes of one depth: whoever is moved is behind.
TEST(RenderState, DepthOffsetDecidesBetweenPlanesOfOneDepth) {
    const auto shown = [](const std::string& offset, const glm::vec3& expected) {
        SCOPED_TRACE(offset);
        World world = empty_world();
        // Leaning back, so that it has a slope.
        const glm::mat4 leaning = glm::rotate(wall(0), -0.5f, glm::vec3(1, 0, 0));
        add_object(world, unlit("[1, 0, 0]", ""), "plane", 2, leaning);
        add_object(world, unlit("[0, 1, 0]", R"("queue": 2001, "depthTest": "less")" + offset), "plane", 2, leaning);
        expect_halves(world, expected, expected);
    };
    shown("", kRed);
    shown(R"(, "depthOffset": [0, -4])", kGreen);
    shown(R"(, "depthOffset": [-1, 0])", kGreen);
    shown(R"(, "depthOffset": [1, 1])", kRed);
    const Pass* pass = nullptr;
    const Result result = compiled(unlit("1", R"("depthOffset": [-1.5, 3])"), "forward");
    ASSERT_TRUE(pass = find_pass(result, "forward"));
    EXPECT_EQ(pass->depth_slope_bias, -1.5);
    EXPECT_EQ(pass->depth_bias, 3);
}

TEST(RenderState, TheQueueDecidesWhatIsDrawnLast) {
    World world = empty_world();
    const std::string on_top = R"("depthTest": "always")";
    add_object(world, unlit("[1, 0, 0]", on_top + R"(, "queue": 2010)"), "plane", 2, wall(0, true));
    add_object(world, unlit("[0, 1, 0]", on_top + R"(, "queue": 2005)"), "plane", 2, wall(1));
    expect_halves(world, kRed, kGreen);
    // At one queue blended surfaces come from the farthest: red over green is 0.5, 0.25.
    World blended = empty_world();
    add_object(blended, unlit("[1, 0, 0]", R"("surface": "fade")"), "plane", 2, wall(5, true));
    add_object(blended, unlit("[0, 1, 0]", R"("surface": "fade")"), "plane", 2, wall(0));
    expect_halves(blended, {0.5f, 0.25f, 0}, 0.5f * kGreen);
    blended.objects.pop_back();
    add_object(blended, unlit("[0, 1, 0]", R"("surface": "fade", "queue": 3001)"), "plane", 2, wall(0));
    expect_halves(blended, {0.25f, 0.5f, 0}, 0.5f * kGreen);
}

TEST(RenderState, DepthIsWrittenAsTheMaterialSays) {
    World world = empty_world();
    add_object(world, unlit("[1, 0, 0]", R"("depthWrite": false)"), "plane", 2, wall(1, true));
    add_object(world, unlit("[0, 1, 0]", R"("queue": 2001)"), "plane", 2, wall(0));
    expect_halves(world, kGreen, kGreen);
    World fading = empty_world();
    add_object(fading, unlit("[1, 0, 0]", R"("surface": "fade", "depthWrite": true, "queue": 2999)"), "plane", 2,
               wall(1, true));
    add_object(fading, unlit("[0, 1, 0]", R"("surface": "fade")"), "plane", 2, wall(0));
    expect_halves(fading, 0.5f * kRed, 0.5f * kGreen);
}

// A wall whose back is seen, the light behind the camera: turned to the viewer its normal meets the light, 0.5 * 0.96.
// Along `vertex` triangles have no back yet (docs/rendering-paths.md), so it is left out.
TEST(RenderState, NormalsOfBacksAreTurnedToTheViewer) {
    const glm::mat4 from_behind = glm::rotate(wall(0), glm::pi<float>(), glm::vec3(0, 1, 0));
    const auto shown = [&](const std::string& cull, const glm::mat4& place, double light) {
        World world = empty_world();
        world.view.lights = {{.direction = {0, 0, 1}}};
        add_object(world, matt(fmt::format(R"("cull": "{}")", cull)), "plane", 2, place);
        for (const Way& way : kWays) {
            if (std::string_view(way.path) == "vertex") continue;
            SCOPED_TRACE(fmt::format("{} along {} via {}", cull, way.path, way.via));
            const Image image = draw(world, {.path = way.path, .via = way.via, .exact_targets = true});
            EXPECT_NEAR(at(image, 3, 3).r, 0.5 * (1 - kDielectric) * light, 1e-5);
        }
    };
    shown("back", wall(0), 1);
    shown("back", from_behind, 0);
    shown("front", wall(0), 0);
    shown("front", from_behind, 1);
    shown("off", wall(0), 1);
    shown("off", from_behind, 1);
}

// A lamp of 2 m range, 4 m above a floor that the material lifts by 3 m: only where it says so is it known to be
// reached.
TEST(RenderState, BoundsSayWhereTheMeshIsDrawn) {
    const auto shown = [](const std::string& bounds) {
        World world = empty_world();
        world.view.lights = {{.kind = LightKind::Point, .position = {0, 0, 4}, .range = 2}};
        const std::string graph = written("lifted.graph.json", R"({ "patina": 1, "workflow": "metallic-roughness",
  "lighting": "lambert", "vertex": { "positionOS": "= @positionOS + 3 * @normalOS" }, "surface": { "baseColor": 0.5 })" +
                                                                   bounds + " }");
        add_object(world, graph, "plane", 2, glm::mat4(1));
        return at(draw(world, {.path = "forward-add", .exact_targets = true}), 4, 4).r;
    };
    EXPECT_EQ(shown(""), 0);
    EXPECT_GT(shown(R"(, "render": { "bounds": 3 })"), 0.1f);
    EXPECT_GT(shown(R"(, "render": { "bounds": [[-1, -1, 3], [1, 1, 3]] })"), 0.1f);
    const Result result = compiled(written("bounded.graph.json", R"({ "patina": 1, "workflow": "unlit",
  "render": { "bounds": [[-1, -2, -3], [1, 2, 3]] } })"),
                                   "forward");
    ASSERT_TRUE(result.reflection.bounds && result.reflection.bounds->box);
    EXPECT_EQ((*result.reflection.bounds->box)[1][1], 2);
}

// A material that lifts its plane over another one: they blend in the order of where they are drawn, green over red.
TEST(RenderState, BoundsOrderWhatBlends) {
    const auto lifted = [](const std::string& bounds) {
        World world = empty_world();
        add_object(world, written("lifted_fade.graph.json", R"json({ "patina": 1, "workflow": "unlit",
  "vertex": { "positionOS": "= @positionOS + float3(0, 0, 0.5)" }, "surface": { "color": [0, 1, 0], "alpha": 0.5 },
  "render": { "surface": "fade")json" + bounds + " } }"),
                   "plane", 2, wall(0));
        add_object(world, unlit("[1, 0, 0]", R"("surface": "fade")"), "plane", 2, wall(2));
        return world;
    };
    expect_halves(lifted(R"(, "bounds": [[-1, -1, 0.5], [1, 1, 0.5]])"), {0.25f, 0.5f, 0}, {0.25f, 0.5f, 0});
    // Where the object itself is, it is the farther one.
    expect_halves(lifted(""), {0.5f, 0.25f, 0}, {0.5f, 0.25f, 0});
}

// The material moves its mesh, and not the square that deferred lights the screen by: it would end in the middle.
TEST(RenderState, AMovedMeshDoesNotMoveTheScreen) {
    World world = empty_world();
    world.view.lights = {{.direction = {0, 0, 1}}};
    const std::string moved = written("moved.graph.json", R"json({ "patina": 1, "workflow": "metallic-roughness",
  "lighting": "lambert", "vertex": { "positionOS": "= @positionOS + float3(1, 0, 0)" },
  "surface": { "baseColor": 0.5 } })json");
    add_object(world, moved, "plane", 2, glm::scale(glm::translate(glm::mat4(1), {-10, 0, 0}), glm::vec3(10)));
    const auto lit = float(0.5 * (1 - kDielectric));
    expect_halves(world, glm::vec3(lit), glm::vec3(lit), 1e-4);
}

}  // namespace
}  // namespace patina::paths
