// The examples of render state and of variants, each pixel by what it is meant to show; and, without the words that the
// example is about, what goes wrong.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <sstream>

#include "paths/drawing/checkerboard.h"
#include "patina/variants.h"

namespace patina::paths {
namespace {

std::string texture(const std::string& name, const glm::dvec4& texel) {
    return written_texture(name, 1, 1, [&](int, int) { return texel; });
}

// A copy of an example, `from` in its text replaced; its path.
std::string changed(const std::string& example, const std::string& from, const std::string& to) {
    std::ifstream file("examples/surfaces/" + example + ".graph.json");
    std::stringstream text;
    text << file.rdbuf();
    std::string copy = text.str();
    const std::size_t at = copy.find(from);
    EXPECT_NE(at, copy.npos) << example << " does not say " << from;
    if (at != copy.npos) copy.replace(at, from.size(), to);
    return written("changed_" + example + ".graph.json", copy);
}

glm::mat4 placed(const glm::vec3& position, const glm::vec3& scale) {
    return glm::scale(glm::translate(glm::mat4(1), position), scale);
}

// A wall that fills the picture, and in it the hole: the left half of it, as wide as high.
TEST(SurfaceExamples, APortholeShowsTheBoardThroughTheWall) {
    World world = checkerboard();
    add_object(
        world, "examples/surfaces/holed_wall.graph.json", "plane", 1, glm::mat4(1),
        {{"_MainTex", texture("white.exr", glm::dvec4(1))}, {"_BumpMap", texture("flat.exr", {0.5, 0.5, 1, 1})}});
    add_object(world, "examples/surfaces/porthole.graph.json", "plane", 1,
               placed({-0.25f, 0.125f, 0.5f}, glm::vec3(0.5f)), {{"_Color", "0.1,0.2,0.3"}});
    const auto is_hole = [](int x, int y) { return glm::distance(uv_of(x, y), glm::dvec2(0.375, 0.4375)) < 0.25; };
    const glm::dvec3 wall = scattered(glm::dvec3(1)) + highlight(0.2) * kSun;
    expect_pixels(world, [&](int x, int y) { return is_hole(x, y) ? behind(x, y) : wall; });
    // Where nothing lies behind there is the hole's own colour.
    World empty = world;
    empty.objects.erase(empty.objects.begin());
    expect_pixels(empty, [&](int x, int y) { return is_hole(x, y) ? glm::dvec3(0.1, 0.2, 0.3) : wall; });
}

// Of a ball of radius r the board, which lies at a distance d from its middle, shows a disc of radius sqrt(r^2 - d^2).
// A patch before the ball is not dyed, whatever number it leaves in the stencil, and a patch in the middle is.
TEST(SurfaceExamples, ABallOfDyeReachesWhatLiesInIt) {
    const glm::dvec3 dye(0.9, 0.3, 0.5), front(0.25, 0.5, 0.75), middle(0.8, 0.7, 0.2);
    const glm::dvec2 center(0.19, -0.22);
    constexpr double kRadius = 0.5, kDistance = 0.3;
    const double disc = std::sqrt(kRadius * kRadius - kDistance * kDistance);
    const auto patch = [](const std::string& name, const std::string& color, const std::string& rest) {
        return written(name + ".graph.json",
                       R"({ "patina": 1, "workflow": "unlit", "surface": { "color": )" + color + " }" + rest + " }");
    };
    const auto shown = [&](const std::string& graph, double before, double in_it, double behind_it) {
        SCOPED_TRACE(graph);
        World world = checkerboard();
        add_object(world,
                   patch("front", "[0.25, 0.5, 0.75]",
                         R"(, "render": { "stencil": { "reference": 128, "pass": "replace" } })"),
                   "plane", 1, placed({-0.2f, -0.1f, 0}, glm::vec3(0.15f)));
        add_object(world, patch("middle", "[0.8, 0.7, 0.2]", ""), "plane", 1,
                   placed({0.25f, -0.2f, kDistance - 1}, glm::vec3(0.1f)));
        add_object(world, graph, "sphere", 256, placed({center.x, center.y, kDistance - 1}, glm::vec3(kRadius)),
                   {{"_Color", "0.9,0.3,0.5"}});
        const auto dyed = [&](const glm::dvec3& color, bool is_there) { return is_there ? color * dye : color; };
        expect_pixels(world, [&](int x, int y) {
            const glm::dvec2 right_down = 2.0 * uv_of(x, y) - 1.0;
            const glm::dvec2 at(right_down.x, -right_down.y);
            const double aside = glm::distance(at, center);
            const auto is_near = [&](const glm::dvec2& where, double size) {
                return std::max(std::abs(at.x - where.x), std::abs(at.y - where.y)) < size;
            };
            if (is_near({-0.2, -0.1}, 0.15)) return dyed(front, aside < before);
            if (is_near({0.25, -0.2}, 0.1)) return dyed(middle, aside < in_it);
            return dyed(behind(x, y), aside < behind_it);
        });
    };
    shown("examples/surfaces/dye.graph.json", 0, kRadius, disc);
    shown(changed("dye", R"("depthTest": "greater",)", ""), 0, 0, 0);
    // As far as the near side is hidden, and nothing else.
    shown(changed("dye", R"(, "depthFail": "incrementWrap")", ""), kRadius, 0, 0);
    // The patch's own number is taken for a count.
    shown(changed("dye", R"("readMask": 15, )", ""), kRadius, kRadius, disc);
}

// Wall and poster are one plane, which leans away, so that its depth has a slope. Light comes from around, and no lamp.
TEST(SurfaceExamples, APosterIsSeenOnTheWallThatItLiesIn) {
    constexpr double kLean = 0.6;
    const glm::dvec3 around(0.5, 0.25, 1);
    const auto shown = [&](const std::string& poster, int segments, bool is_seen) {
        SCOPED_TRACE(fmt::format("{}, {} segments", poster, segments));
        World world = checkerboard();
        world.view.lights.clear();
        world.view.ambient = runtime::constant_ambient(glm::vec3(around));
        const glm::mat4 leaning = glm::rotate(glm::mat4(1), float(-kLean), glm::vec3(1, 0, 0));
        const std::string wall = written("wall.graph.json", R"({ "patina": 1, "workflow": "unlit",
  "surface": { "color": [0.25, 0.5, 0.75] } })");
        add_object(world, wall, "plane", 24, leaning);
        add_object(world, poster, "plane", segments, leaning, {{"_Paper", "0.9,0.7,0.5"}, {"_Ink", "0.9,0.7,0.5"}});
        expect_pixels(world, [&](int x, int y) {
            const glm::dvec2 right_down = 2.0 * uv_of(x, y) - 1.0;
            const glm::dvec2 on_poster(right_down.x, right_down.y / std::cos(kLean));
            if (std::abs(on_poster.y) > 1) return behind(x, y);
            const bool is_paper = std::max(std::abs(on_poster.x) * 1.4, std::abs(on_poster.y)) < 0.8;
            return is_paper && is_seen ? glm::dvec3(0.9, 0.7, 0.5) * (1 - kF0) * around : glm::dvec3(0.25, 0.5, 0.75);
        });
    };
    shown("examples/surfaces/poster.graph.json", 3, true);
    shown("examples/surfaces/poster.graph.json", 24, true);
    // Depths that are equal to the last bit, of which the first is kept, with the offset and without.
    const std::string offset = R"("depthOffset": [-1, -4])", keeps_first = R"("queue": 2450, "depthTest": "less")";
    shown(changed("poster", offset, offset + ", " + keeps_first), 24, true);
    shown(changed("poster", offset, keeps_first), 24, false);
    shown(changed("poster", offset, R"("depthOffset": [1, 4])"), 24, false);
}

// The sticker's middle is farther from the camera than the pane's, and lies on this side of it.
TEST(SurfaceExamples, AStickerIsDrawnOverTheGlassItSticksTo) {
    const glm::dvec3 color(0.9, 0.6, 0.1), sky(0.3, 0.5, 0.7);
    constexpr double kMilky = 0.6;
    const auto shown = [&](const std::string& sticker, const glm::dvec3& expected) {
        World world = checkerboard();
        world.objects.clear();
        world.view.background = glm::vec4(glm::vec3(sky), 1);
        world.view.lights.clear();
        world.view.camera = {.position = {1.9f, 0.25f, 1.9f}, .target = {-0.9f, 0, 0.01f}, .fov = 2};
        add_object(world, "examples/surfaces/glass_pane.graph.json", "plane", 1, placed({0, 0, 0}, {1.4f, 0.6f, 1}),
                   {{"_Color", fmt::format("0.3,0.6,0.5,{}", kMilky)}});
        add_object(world, sticker, "plane", 1, placed({-0.9f, 0, 0.01f}, glm::vec3(0.4f)),
                   {{"_Color", "0.9,0.6,0.1"}, {"_Ink", "0.9,0.6,0.1"}});
        expect_pixels(world, [&](int, int) { return expected; });
        world.view.camera.target = {0.1f, 0, 0};
        expect_pixels(world, [&](int, int) { return (1 - kMilky) * (1 - kF0) * sky; });
    };
    shown("examples/surfaces/sticker.graph.json", color);
    shown(changed("sticker", R"(, "queue": 3010)", ""), (1 - kMilky) * (1 - kF0) * color);
}

// The sun stands at 45 degrees over a floor that is seen from above: as high as the balloon is, as far aside is the
// middle of its shadow. A balloon that is not drawn out is a ball; its neck is below, in the middle of the shadow's far
// half.
TEST(SurfaceExamples, ABalloonCastsItsShadowFromWhereItIs) {
    World world = checkerboard();
    world.objects.clear();
    world.view.camera = {.position = {0, 9, 0.001f}, .target = {0, 0, 0}, .orthographic_height = 8};
    world.view.lights = {{.direction = {1, 1, 0}, .color = glm::vec3(kSun), .shadow = {.casts = true}}};
    const std::string floor = written("floor.graph.json", R"({ "patina": 1, "workflow": "metallic-roughness",
  "lighting": "lambert", "surface": { "baseColor": 0.5 } })");
    add_object(world, floor, "plane", 1,
               glm::scale(glm::rotate(glm::mat4(1), -glm::half_pi<float>(), glm::vec3(1, 0, 0)), glm::vec3(6)));
    add_object(world, "examples/surfaces/balloon.graph.json", "sphere", 48, glm::scale(glm::mat4(1), glm::vec3(0.5f)),
               {{"_Rise", "4"}});
    const double height = 0.5 * 4, lit = 0.5 * (1 - kF0) * std::sqrt(0.5);
    for (const char* via : {"glsl", "cpu"}) {
        const Image image = draw(world, {.via = via, .exact_targets = true});
        const auto red_at = [&](double x) {
            return double(image.at(int((x / 8 + 0.5) * kBoardPixels), kBoardPixels / 2)[0]);
        };
        EXPECT_NEAR(red_at(-height), 0, 1e-3) << via;
        for (const double x : {-height - 1.2, -height + 1.2, height}) EXPECT_NEAR(red_at(x), lit * kSun.x, 1e-3) << via;
    }
}

// A surface that lies deep everywhere and is flat: moss and snow cover all of it where there is enough of them.
TEST(SurfaceExamples, AWallIsWhatItsVariantsAndConstantsSay) {
    const glm::dvec3 brick(0.5, 0.2, 0.1), moss(0.1, 0.4, 0.05), snow(0.85, 0.88, 0.92);
    const std::map<std::string, std::string> maps = {{"_MainTex", texture("brick.exr", glm::dvec4(brick, 1))},
                                                     {"_MossTex", texture("moss.exr", glm::dvec4(moss, 1))},
                                                     {"_BumpMap", texture("flat.exr", {0.5, 0.5, 1, 1})},
                                                     {"_ParallaxMap", texture("deep.exr", glm::dvec4(0, 0, 0, 1))},
                                                     {"_Amount", "1"}};
    for (const auto& [cover, color] : {std::pair("Bare", brick), std::pair("Moss", moss), std::pair("Snow", snow)}) {
        for (const bool is_wet : {false, true}) {
            SCOPED_TRACE(fmt::format("{}, wet {}", cover, is_wet));
            auto words = maps;
            words["_Cover"] = cover;
            words["_Wet"] = is_wet ? "true" : "false";
            words["_PARALLAXMAP"] = is_wet ? "false" : "true";
            World world = checkerboard();
            add_object(world, "examples/surfaces/weathered.graph.json", "plane", 1, glm::mat4(1), words);
            const glm::dvec3 wanted = scattered(is_wet ? 0.55 * color : color) + highlight(is_wet ? 0.75 : 0.2) * kSun;
            expect_pixels(world, [&](int, int) { return wanted; });
        }
    }
}

// Each cover is a shader of its own; what is a constant is in all of them, under one number.
TEST(SurfaceExamples, VariantsAreShadersAndConstantsAreNot) {
    const std::string graph = "examples/surfaces/weathered.graph.json";
    for (const auto& [wanted, count] : {std::pair(VariantsWanted::All, 6u), std::pair(VariantsWanted::Listed, 3u)}) {
        const VariantPlan plan = compiler().plan_variants(graph, wanted, {}, kVariantLimit);
        ASSERT_TRUE(plan.ok);
        EXPECT_EQ(plan.count, count);
        const VariantSet set = compiler().compile_variants(graph, plan, {});
        EXPECT_EQ(set.programs.size(), count);
        for (const VariantProgram& program : set.programs) {
            for (const Property& property : program.result.reflection.properties) {
                const bool is_constant = property.name == "_Steps" || property.name == "_Wet";
                EXPECT_EQ(property.constant_id.has_value(), is_constant) << property.name;
                if (property.constant_id) {
                    EXPECT_EQ(*property.constant_id, property.name == "_Steps" ? 0u : 1u);
                }
            }
        }
    }
}

}  // namespace
}  // namespace patina::paths
