// Passes that a material adds: each is drawn as a material of its own would be, along every path, by its queue.
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

// Seen straight from the front; 8 m of the plane z = 0 fill the picture.
World empty_world() {
    World world;
    world.view.width = world.view.height = 8;
    world.view.background = glm::vec4(0, 0, 0, 1);
    world.view.camera = {.position = {0, 0, 40}, .target = {0, 0, 0}, .fov = float(glm::degrees(2 * std::atan(0.1)))};
    world.view.ambient = runtime::constant_ambient(glm::vec3(0));
    world.view.lights = {{.direction = {0, 0, 1}, .color = glm::vec3(0.5f)},
                         {.direction = {0, 0, 1}, .color = glm::vec3(0.25f)}};
    world.pixel_light_count = 4;
    return world;
}

// A green square of 4 m in the middle, and a pass.
std::string squared(const std::string& pass,
                    const std::string& workflow = R"("unlit", "surface": { "color": [0, 1, 0] })") {
    static int number = 0;
    return written(
        fmt::format("passes_{}.graph.json", number++),
        R"({ "patina": 1, "workflow": )" + workflow + R"(, "passes": [ { "name": "added", )" + pass + " } ] }");
}

struct Seen {
    glm::vec3 inside, outside;
};
void expect_seen(const World& world, const Seen& expected, double tolerance = 1e-6) {
    for (const Way& way : kWays) {
        SCOPED_TRACE(fmt::format("along {} via {}", way.path, way.via));
        const Image image = draw(world, {.path = way.path, .via = way.via, .exact_targets = true});
        for (std::size_t c = 0; c < 3; c++) {
            EXPECT_NEAR(image.at(4, 3)[c], expected.inside[int(c)], tolerance) << "inside, " << c;
            EXPECT_NEAR(image.at(1, 3)[c], expected.outside[int(c)], tolerance) << "outside, " << c;
        }
    }
}

constexpr glm::vec3 kRed(1, 0, 0), kGreen(0, 1, 0);

void expect_with(const std::string& pass, const Seen& expected) {
    SCOPED_TRACE(pass);
    World world = empty_world();
    add_object(world, squared(pass), "plane", 4, glm::scale(glm::mat4(1), glm::vec3(2)));
    expect_seen(world, expected);
}

const std::string kLarger =
    R"("vertex": { "positionOS": "= 4 * @positionOS" }, "surface": { "color": [1, 0, 0], "alpha": 0.5 })";

TEST(ExtraPasses, AreDrawnByTheirQueue) {
    expect_with(kLarger + R"(, "render": { "depthTest": "always", "queue": 1999 })", {kGreen, kRed});
    expect_with(kLarger + R"(, "render": { "depthTest": "always", "queue": 2000 })", {kRed, kRed});
    expect_with(kLarger + R"(, "render": { "depthTest": "less", "queue": 2001 })", {kGreen, kRed});
    expect_with(kLarger + R"(, "render": { "surface": "fade" })", {{0.5f, 0.5f, 0}, 0.5f * kRed});
    expect_with(kLarger + R"(, "render": { "surface": "additive" })", {{1, 1, 0}, kRed});
    expect_with(kLarger + R"(, "render": { "cull": "front" })", {kGreen, glm::vec3(0)});
}

// What it leaves out is the material's.
TEST(ExtraPasses, TakeTheRestFromTheMaterial) {
    expect_with(R"("vertex": { "positionOS": "= 4 * @positionOS" })", {kGreen, kGreen});
    expect_with(R"("surface": { "color": [1, 0, 0] }, "render": { "depthTest": "always" })", {kRed, glm::vec3(0)});
}

// Lit by both lights in its one pass: 0.8 * 0.96 of each channel's light, as the workflow's diffuse colour.
TEST(ExtraPasses, AreLitByAllLights) {
    World world = empty_world();
    add_object(
        world,
        squared(R"("workflow": "metallic-roughness", "lighting": "lambert", "surface": { "baseColor": [0.8, 0, 0] },
  "vertex": { "positionOS": "= 4 * @positionOS" }, "render": { "depthWrite": false })",
                R"("metallic-roughness", "lighting": "lambert", "surface": { "baseColor": [0, 0.5, 0] },
  "render": { "queue": 2001 })"),
        "plane", 4, glm::scale(glm::mat4(1), glm::vec3(2)));
    expect_seen(world, {{0, 0.5f * 0.96f * 0.75f, 0}, {0.8f * 0.96f * 0.75f, 0, 0}}, 1e-5);
}

// Two materials on two objects in one place, in the example's scene of an outline.
TEST(ExtraPasses, AreWhatAMaterialOfTheirOwnWouldBe) {
    const std::string ink = written("ink.graph.json", R"({ "patina": 1, "workflow": "unlit",
  "properties": [ { "name": "_Ink", "type": "color", "default": "#2a1e38" },
                  { "name": "_Width", "type": "float", "default": 0.03 } ],
  "vertex": { "positionOS": "= @positionOS + @normalOS * $_Width" },
  "surface": { "color": "$_Ink" }, "render": { "cull": "front", "bounds": 0.2 } })");
    const std::string plain = written("plain_toon.graph.json", R"({ "patina": 1, "workflow": "metallic-roughness",
  "lighting": "toon", "properties": [ { "name": "_Color", "type": "color", "default": "#e8703a" } ],
  "surface": { "baseColor": "$_Color", "roughness": 0.6 } })");
    for (const Way& way : kWays) {
        SCOPED_TRACE(fmt::format("along {} via {}", way.path, way.via));
        const bool on_cpu = std::string_view(way.via) == "cpu";
        World together = proof_world(on_cpu ? 40 : 80, on_cpu ? 30 : 60);
        for (runtime::Light& light : together.view.lights) light.shadow.casts = false;  // a pass casts none
        const glm::mat4 place = glm::scale(glm::translate(glm::mat4(1), {0.2f, 0.5f, 2.2f}), glm::vec3(0.5f));
        World apart = together;
        add_object(together, "examples/graphs/outlined.graph.json", "sphere", 24, place,
                   {{"_Width", "0.1"}, {"_Ink", "1,0,0"}});
        add_object(apart, plain, "sphere", 24, place);
        const Image without = draw(apart, {.path = way.path, .via = way.via, .exact_targets = true});
        add_object(apart, ink, "sphere", 24, place, {{"_Width", "0.1"}, {"_Ink", "1,0,0"}});
        const RenderOptions options{.path = way.path, .via = way.via, .exact_targets = true};
        const Image expected = draw(apart, options);
        EXPECT_LE(difference(draw(together, options), expected).largest, 1e-5);
        EXPECT_GT(difference(without, expected).largest, 0.5);
    }
}

TEST(ExtraPasses, ShareOneBlockAndHaveFilesOfTheirOwn) {
    const Result with = compiled("examples/graphs/outlined.graph.json", "deferred");
    ASSERT_TRUE(with.ok);
    const Pass* outline = find_pass(with, "outline");
    ASSERT_TRUE(outline);
    EXPECT_TRUE(outline->is_extra);
    EXPECT_EQ(outline->cull, Cull::Front);
    EXPECT_TRUE(has(outline->blocks, "Material"));
    std::vector<std::string> files;
    for (const Shader& shader : with.shaders) files.push_back(shader.file_name);
    EXPECT_TRUE(has(files, "outlined.outline.frag.glsl"));
    EXPECT_TRUE(has(files, "outlined.outline.vert.hlsl"));
    // It is one material: its block is that of the same graph without the pass.
    const auto layout = [](const std::string& end) {
        const std::string graph = written("layout.graph.json", R"({ "patina": 1, "workflow": "unlit", "properties": [
  { "name": "_A", "type": "float3" }, { "name": "_T", "type": "texture2d" }, { "name": "_B", "type": "color" } ],
  "nodes": [ { "id": "t", "node": "SampleTexture2D", "in": { "texture": "$_T" } } ],
  "surface": { "color": "$_B.rgb" })" + end + " }");
        return compiled(graph, "forward").reflection.layout_hash;
    };
    EXPECT_EQ(layout(""), layout(R"(, "passes": [ { "name": "p", "surface": { "color": "= t.rgb * $_A" } } ])"));
    // A pass that does not draw into the picture cannot be seen in it.
    EXPECT_FALSE(find_pass(compiled("examples/graphs/outlined.graph.json", "depth-only"), "outline"));
}

}  // namespace
}  // namespace patina::paths
