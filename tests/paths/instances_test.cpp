// Instances: as many objects in one draw as their block holds, and the picture of as many single draws.
#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "paths/drawing/drawing.h"

namespace patina::paths {
namespace {

struct Way {
    const char* path;
    const char* via;
};
constexpr Way kWays[] = {{"forward", "glsl"}, {"forward", "hlsl"},  {"forward", "cpu"},  {"forward-add", "glsl"},
                         {"vertex", "glsl"},  {"deferred", "glsl"}, {"deferred", "hlsl"}};

// The colour is read by the fragment stage, the bulge by the vertex stage; the roughness is the same for all.
std::string bead(const std::string& binding) {
    return written("bead_" + binding + ".graph.json",
                   R"json({ "patina": 1, "workflow": "metallic-roughness", "properties": [
  { "name": "_Color", "type": "color", "default": "#808080", "as": ")json" +
                       binding + R"json(" },
  { "name": "_Roughness", "type": "float", "default": 0.4 },
  { "name": "_Bulge", "type": "float", "default": 0, "as": ")json" +
                       binding + R"json(" },
  { "name": "_Rings", "type": "int", "default": 1, "as": ")json" +
                       binding + R"json(" } ],
  "vertex": { "positionOS": "= @positionOS * (1 + $_Bulge * @positionOS.y)" },
  "surface": { "baseColor": "= $_Color.rgb * (0.75 + 0.25 * sin(@uv0.y * 6.28 * float($_Rings)))",
               "roughness": "$_Roughness" },
  "render": { "bounds": 1 } })json");
}

constexpr int kKinds = 6;  // of values
struct Bead {
    glm::mat4 place;
    std::map<std::string, std::string> values;
};
std::vector<Bead> beads(int count) {
    std::vector<Bead> made;
    for (int i = 0; i < count; ++i) {
        const float angle = float(i) * 2.39996f, radius = 0.19f * std::sqrt(float(i) + 0.5f);
        glm::mat4 place = glm::translate(glm::mat4(1), {radius * std::cos(angle), radius * std::sin(angle), 0});
        place = glm::scale(glm::rotate(place, angle, glm::vec3(1, 0, 0)), glm::vec3(0.14f, 0.14f, 0.1f));
        const int kind = i % kKinds;
        made.push_back({place,
                        {{"_Color", fmt::format("{},{},{}", kind / 5.0, 1 - kind / 5.0, kind % 3 / 2.0)},
                         {"_Bulge", fmt::format("{}", kind % 3 * 0.2)},
                         {"_Rings", fmt::format("{}", 1 + kind % 4)}}});
    }
    return made;
}

World empty_world(int size) {
    World world;
    world.view.width = world.view.height = size;
    world.view.camera = {.position = {0, 0, 7}, .target = {0, 0, 0}, .fov = 35};
    world.view.ambient = runtime::constant_ambient(glm::vec3(0.1f));
    world.view.lights = {{.direction = {0.3f, 0.5f, 1}, .color = glm::vec3(0.6f)},
                         {.direction = {-1, 0.2f, 0.4f}, .color = glm::vec3(0.4f, 0.3f, 0.2f)}};
    world.pixel_light_count = 4;
    return world;
}

// All in one object.
World together(const std::string& graph, const std::vector<Bead>& all, int size) {
    World world = empty_world(size);
    add_object(world, graph, "sphere", 12, glm::mat4(1));
    for (const Bead& each : all)
        world.objects.back().instances.push_back({.object_to_world = each.place, .overrides = each.values});
    return world;
}

// An object each, of materials that know no instances.
World apart(const std::vector<Bead>& all, int size) {
    World world = empty_world(size);
    for (std::size_t i = 0; i < all.size(); ++i) {
        add_object(world, bead("uniform"), "sphere", 12, all[i].place, all[i].values);
        if (i < kKinds) continue;
        world.materials.pop_back();
        world.objects.back().material = i % kKinds;
    }
    return world;
}

// An image, and the calls that drew it.
runtime::RenderOutcome outcome(const World& world, const RenderOptions& options) {
    static runtime::RenderMachine machine;
    runtime::RenderOutcome made = runtime::draw_world(compiler(), world, options, machine);
    EXPECT_TRUE(made.ok) << made.error;
    for (const Diagnostic& each : made.diagnostics) ADD_FAILURE() << to_text(each);
    return made;
}

TEST(Instances, EightyObjectsAreOneDraw) {
    const std::vector<Bead> all = beads(80);
    for (const Way& way : kWays) {
        SCOPED_TRACE(fmt::format("along {} via {}", way.path, way.via));
        const bool on_cpu = std::string_view(way.via) == "cpu";
        const RenderOptions options{.path = way.path, .via = way.via, .exact_targets = true};
        const int size = on_cpu ? 48 : 160;
        const runtime::RenderOutcome one = outcome(together(bead("instance"), all, size), options),
                                     many = outcome(apart(all, size), options);
        EXPECT_LE(difference(one.image, many.image).largest, 1e-5);
        EXPECT_GT(lit_pixels(one.image), size * size / 8);
        const std::string_view path = way.path;
        // The second light is a draw of its own along forward-add; deferred draws both, and what mirrors, on the
        // screen.
        if (path == "forward" || path == "vertex") {
            EXPECT_EQ(one.draws, 1u);
            EXPECT_EQ(many.draws, 80u);
        } else if (path == "forward-add") {
            EXPECT_EQ(one.draws, 2u);
            EXPECT_EQ(many.draws, 160u);
        } else {
            EXPECT_EQ(one.draws, 3u);
            EXPECT_EQ(many.draws, 82u);
        }
    }
}

// 16 KiB, which every device takes, for two matrices of 64 bytes each, and 16 for each of three properties and for what
// a switch may add; the rest goes into further draws.
TEST(Instances, AsManyAsTheBlockHolds) {
    const Result result = compiled(bead("instance"), "forward");
    constexpr std::uint32_t kMost = 16384 / (2 * 64 + 3 * 16 + 16);
    EXPECT_EQ(result.reflection.most_instances, kMost);
    for (const Block& block : result.reflection.blocks) EXPECT_LE(block.size, 16384u) << block.name;
    for (const Property& property : result.reflection.properties)
        EXPECT_EQ(property.instance_stride, property.name == "_Roughness" ? 0u : 16u) << property.name;
    EXPECT_EQ(compiled(bead("uniform"), "forward").reflection.most_instances, 0u);

    const std::vector<Bead> all = beads(int(2 * kMost + 1));
    const runtime::RenderOutcome drawn = outcome(together(bead("instance"), all, 64), {.exact_targets = true});
    EXPECT_EQ(drawn.draws, 3u);
    EXPECT_LE(difference(drawn.image, draw(apart(all, 64), {.exact_targets = true})).largest, 1e-5);
}

// Places alone need no property of instances, and are then drawn one by one.
TEST(Instances, OfAnyMaterialAreDrawn) {
    std::vector<Bead> all = beads(20);
    for (Bead& each : all) each.values.clear();
    const runtime::RenderOutcome one_by_one = outcome(together(bead("uniform"), all, 96), {.exact_targets = true}),
                                 at_once = outcome(together(bead("instance"), all, 96), {.exact_targets = true});
    EXPECT_EQ(one_by_one.draws, 20u);
    EXPECT_EQ(at_once.draws, 1u);
    EXPECT_LE(difference(one_by_one.image, at_once.image).largest, 1e-5);
}

// One draw into the shadow map, and one of the picture; an object alone is an instance, too.
TEST(Instances, CastTheirShadows) {
    std::vector<Bead> all = beads(30);
    for (const char* path : {"forward", "deferred"}) {
        SCOPED_TRACE(path);
        World one = together(bead("instance"), all, 128), many = apart(all, 128);
        const std::string floor = written("floor.graph.json", R"({ "patina": 1, "workflow": "metallic-roughness",
  "properties": [ { "name": "_Tint", "type": "color", "default": [0.5, 0.6, 0.7], "as": "instance" } ],
  "surface": { "baseColor": "$_Tint" } })");
        for (World* world : {&one, &many}) {
            world->view.lights.front().shadow.casts = true;
            add_object(*world, floor, "plane", 8,
                       glm::scale(glm::translate(glm::mat4(1), {0, 0, -0.4f}), glm::vec3(3)));
        }
        const RenderOptions options{.path = path, .exact_targets = true};
        const Image lit = draw(one, options);
        EXPECT_LE(difference(lit, draw(many, options)).largest, 1e-4);
        if (std::string_view(path) == "forward") {
            EXPECT_EQ(outcome(one, options).draws, 4u);
        }
        one.view.lights.front().shadow.casts = false;
        EXPECT_GT(difference(lit, draw(one, options)).largest, 0.05);
    }
}

// A lamp that reaches the last instance alone is not too far from the object.
TEST(Instances, AreReachedByLampsWhereverTheyAre) {
    std::vector<Bead> all = beads(2);
    all[0].place = glm::translate(glm::mat4(1), {-1.5f, 0, 0}) * all[0].place;
    all[1].place = glm::translate(glm::mat4(1), {1.5f, 0, 0}) * all[1].place;
    World one = together(bead("instance"), all, 64), many = apart(all, 64);
    const RenderOptions options{.path = "forward-add", .exact_targets = true};
    const Image unlit = draw(one, options);
    for (World* world : {&one, &many})
        world->view.lights.push_back(
            {.kind = LightKind::Point, .position = glm::vec3(all[1].place[3]) + glm::vec3(0, 0, 0.5f), .range = 1});
    const Image lit = draw(one, options);
    EXPECT_LE(difference(lit, draw(many, options)).largest, 1e-5);
    EXPECT_GT(difference(lit, unlit).largest, 0.1);
}

}  // namespace
}  // namespace patina::paths
