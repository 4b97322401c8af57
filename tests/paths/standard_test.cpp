// The example `standard`: what each option of the Standard shader's inspector makes of a plane that is lit and seen
// along its normal, by that shader's formulas; each main texture has a texel for each pixel.
#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <set>

#include "paths/drawing/drawing.h"
#include "patina/variants.h"
#include "runtime/lighting/environment.h"

namespace patina::paths {
namespace {

constexpr const char* kOpaque = "examples/sources/standard.graph.json";
constexpr const char* kCutout = "examples/sources/standard-cutout.graph.json";
constexpr int kPixels = 16;
const glm::dvec3 kSun(0.75, 0.5, 0.25), kAround(0.2, 0.3, 0.4);  // irradiance over pi
const glm::dvec3 kTint(0.8, 0.6, 0.4);

using Words = std::map<std::string, std::string>;

Words with(Words words, const Words& more) {
    for (const auto& [name, word] : more) words[name] = word;
    return words;
}

// From -1 to 1, all of the picture; nothing is mirrored but the sun.
World lit_plane(const char* graph, const Words& words) {
    static const auto kNothing = std::make_shared<const runtime::Environment>(runtime::constant_ambient(glm::vec3(0)));
    World world;
    world.view.width = world.view.height = kPixels;
    world.view.background = glm::vec4(0);
    world.view.camera = {.position = {0, 0, 4}, .target = {0, 0, 0}, .orthographic_height = 2};
    world.view.ambient = runtime::constant_ambient(glm::vec3(kAround));
    world.view.environment = kNothing;
    world.view.lights = {{.direction = {0, 0, 1}, .color = glm::vec3(kSun)}};
    add_object(world, graph, "plane", 1, glm::mat4(1), words);
    return world;
}

struct Surface {
    glm::dvec3 base_color = kTint;
    double metallic = 0, smoothness = 0.5, occlusion = 1;
    glm::dvec3 emission = glm::dvec3(0);
};

// Where n, l, v and h are one direction: Disney's diffuse term is 1, Smith's visibility term 1/4, GGX 1 / (pi a^2), and
// Fresnel's is f0.
glm::dvec3 shown(const Surface& s) {
    const double alpha = (1 - s.smoothness) * (1 - s.smoothness);
    const glm::dvec3 f0 = glm::mix(glm::dvec3(0.04), s.base_color, s.metallic);
    const glm::dvec3 scattered = s.base_color * 0.96 * (1 - s.metallic);
    return scattered * (kSun + s.occlusion * kAround) + f0 / (4 * alpha * alpha) * kSun + s.emission;
}

void expect_picture(const char* graph, const Words& words,
                    const std::function<std::optional<Surface>(int x, int y)>& expected) {
    const Words all = with({{"_Color", "0.8,0.6,0.4,1"}}, words);
    for (const char* via : {"glsl", "hlsl", "cpu"}) {
        SCOPED_TRACE(via);
        const Image image = draw(lit_plane(graph, all), {.via = via, .exact_textures = true, .exact_targets = true});
        for (int y = 0; y < kPixels; ++y) {
            for (int x = 0; x < kPixels; ++x) {
                const std::optional<Surface> surface = expected(x, y);
                const glm::dvec3 wanted = surface ? shown(*surface) : glm::dvec3(0);
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(double(image.at(x, y)[std::size_t(c)]), wanted[c], 1e-3 * std::max(1.0, wanted[c]))
                        << "pixel (" << x << ", " << y << "), channel " << c;
            }
        }
    }
}

// Of kPixels by kPixels texels that all differ.
double step(int x, int y) {
    return (x + kPixels * y + 0.5) / (kPixels * kPixels);
}
std::string steps(const std::string& name, const std::function<glm::dvec4(double)>& texel) {
    return written_texture(name, kPixels, kPixels, [&](int x, int y) { return texel(step(x, y)); });
}

// Four ways to a smoothness; the slider of metallic alone is decoded as a colour is, by IEC 61966-2-1.
TEST(Standard, MetallicAndSmoothnessComeFromWhereTheKeywordsSay) {
    const Words maps = {
        {"_MainTex", steps("albedo.exr", [](double t) { return glm::dvec4(1, 1, 1, 0.2 + 0.5 * t); })},
        {"_MetallicGlossMap", steps("gloss.exr", [](double t) { return glm::dvec4(t, 0.9, 0.9, 0.7 - 0.5 * t); })},
        {"_Metallic", "0.5"},
        {"_Glossiness", "0.4"},
        {"_GlossMapScale", "0.8"}};
    for (const bool has_map : {false, true}) {
        for (const bool from_albedo : {false, true}) {
            SCOPED_TRACE(fmt::format("_METALLICGLOSSMAP {}, from albedo {}", has_map, from_albedo));
            const Words words = with(maps, {{"_METALLICGLOSSMAP", has_map ? "true" : "false"},
                                            {"_SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A", from_albedo ? "true" : "false"}});
            expect_picture(kOpaque, words, [&](int x, int y) {
                const double t = step(x, y);
                return Surface{.metallic = has_map ? t : std::pow((0.5 + 0.055) / 1.055, 2.4),
                               .smoothness = from_albedo ? 0.8 * (0.2 + 0.5 * t)
                                             : has_map   ? 0.8 * (0.7 - 0.5 * t)
                                                         : 0.4};
            });
        }
    }
}

// The detail map lies twice over the plane, four of its texels further; the mask lies as the main maps do.
TEST(Standard, DetailMapsLieOverTheMainOnesWhereTheMaskSays) {
    const Words maps = {
        {"_MainTex", steps("main.exr", [](double t) { return glm::dvec4(t, 1 - t, 0.5, 1); })},
        {"_DetailMask", steps("mask.exr", [](double t) { return glm::dvec4(0, 0, 0, t); })},
        {"_DetailAlbedoMap",
         written_texture("detail.exr", 8, 8, [](int x, int y) { return glm::dvec4(x / 16.0, y / 16.0, 0.25, 1); })},
        {"_DetailAlbedoMap_ST", "2,2,0.5,0.25"}};
    for (const bool is_detailed : {false, true}) {
        expect_picture(kOpaque, with(maps, {{"_DETAIL_MULX2", is_detailed ? "true" : "false"}}), [&](int x, int y) {
            const double t = step(x, y);
            const glm::dvec3 detail((x + 4) % 8 / 16.0, (y + 2) % 8 / 16.0, 0.25);
            const glm::dvec3 factor = glm::mix(glm::dvec3(1), std::pow(2, 2.2) * detail, is_detailed ? t : 0.0);
            return Surface{.base_color = kTint * glm::dvec3(t, 1 - t, 0.5) * factor};
        });
    }
}

// Without a detail map its place holds middle grey, 0.214 decoded, of which Unity's factor 2^2.2 makes 0.983.
TEST(Standard, AnEmptyDetailMapLeavesTheAlbedoNearlyAsItIs) {
    const double factor = std::pow(2, 2.2) * std::pow((0.5 + 0.055) / 1.055, 2.4);
    EXPECT_NEAR(factor, 1, 0.02);
    expect_picture(kOpaque, {{"_DETAIL_MULX2", "true"}},
                   [&](int, int) { return Surface{.base_color = factor * kTint}; });
}

TEST(Standard, OcclusionDimsWhatIsAroundAndEmissionIsAdded) {
    const Words maps = {{"_OcclusionMap", steps("open.exr", [](double t) { return glm::dvec4(1, t, 1, 1); })},
                        {"_OcclusionStrength", "0.75"},
                        {"_EmissionMap", steps("glow.exr", [](double t) { return glm::dvec4(t, 0.5, 1 - t, 1); })},
                        {"_EmissionColor", "2,4,8"}};
    for (const bool glows : {false, true}) {
        expect_picture(kOpaque, with(maps, {{"_EMISSION", glows ? "true" : "false"}}), [&](int x, int y) {
            const double t = step(x, y);
            return Surface{.occlusion = 0.25 + 0.75 * t,
                           .emission = (glows ? 1.0 : 0.0) * glm::dvec3(2, 4, 8) * glm::dvec3(t, 0.5, 1 - t)};
        });
    }
}

// Alpha is that of albedo and colour; of the colour alone where the albedo's is a smoothness.
TEST(Standard, CutoutCutsBelowTheCutoff) {
    const std::string albedo = steps("leaf.exr", [](double t) { return glm::dvec4(1, 1, 1, t); });
    const Words words = {{"_MainTex", albedo}, {"_Cutoff", "0.3"}, {"_Color", "0.8,0.6,0.4,0.75"}};
    expect_picture(kCutout, words,
                   [](int x, int y) { return 0.75 * step(x, y) < 0.3 ? std::nullopt : std::optional(Surface{}); });
    const Words smooth = with(words, {{"_SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A", "true"}, {"_GlossMapScale", "0.5"}});
    expect_picture(kCutout, smooth, [](int x, int y) { return Surface{.smoothness = 0.5 * step(x, y)}; });
    expect_picture(kCutout, with(smooth, {{"_Color", "0.8,0.6,0.4,0.25"}}),
                   [](int, int) { return std::optional<Surface>(); });
}

// What is drawn of two bindings of one material is the same.
void expect_same(World world, const Words& a, const Words& b, double least_from_neither, const Words& neither) {
    const auto seen = [&](const Words& words) {
        world.materials.front().overrides = words;
        return draw(world, {.exact_textures = true, .exact_targets = true});
    };
    const Image first = seen(a);
    EXPECT_LE(difference(first, seen(b)).largest, 1e-4);
    EXPECT_GT(difference(first, seen(neither)).largest, least_from_neither);
}

// Whiteout, and from there as far as the mask says: the same light as from one map of that normal.
TEST(Standard, NormalsOfTheDetailAreBlendedByWhiteout) {
    const auto normal_map = [](const std::string& name, const glm::dvec3& n) {
        return written_texture(name, 1, 1, [&](int, int) { return glm::dvec4(0.5 * n + 0.5, 1); });
    };
    const glm::dvec3 base(0.6, 0, 0.8), detail(0, 0.48, std::sqrt(1 - 0.48 * 0.48));
    const glm::dvec3 whiteout = glm::normalize(glm::dvec3(base.x, detail.y, base.z * detail.z));
    const Words plain = {{"_NORMALMAP", "true"}, {"_BumpMap", normal_map("base.exr", base)}};
    for (const double mask : {1.0, 0.25}) {
        const Words detailed = with(
            plain,
            {{"_DETAIL_MULX2", "true"},
             {"_DetailNormalMap", normal_map("detail_normal.exr", detail)},
             {"_DetailAlbedoMap",
              written_texture("grey.exr", 1, 1, [](int, int) { return glm::dvec4(glm::dvec3(std::pow(2, -2.2)), 1); })},
             {"_DetailMask",
              written_texture(fmt::format("mask_{}.exr", mask), 1, 1, [&](int, int) { return glm::dvec4(mask); })}});
        const Words one = with(plain, {{"_BumpMap", normal_map(fmt::format("one_{}.exr", mask),
                                                               glm::normalize(glm::mix(base, whiteout, mask)))}});
        expect_same(lit_plane(kOpaque, {}), detailed, one, 0.01, plain);
    }
    const Words off = with(plain, {{"_NORMALMAP", "false"}});
    expect_same(lit_plane(kOpaque, {}), off, {}, 0.01, plain);
}

// One height everywhere, seen from one direction: every texture lies as far aside, main and detail maps alike.
TEST(Standard, ParallaxMovesMainAndDetailMaps) {
    const auto wave = [](const std::string& name, double phase) {
        return written_texture(name, 64, 64, [&](int x, int y) {
            return glm::dvec4(0.5 + 0.4 * std::sin(0.4 * x + phase), 0.5 + 0.4 * std::cos(0.3 * y + phase), 0.5, 1);
        });
    };
    const Words maps = {{"_MainTex", wave("main_wave.exr", 0)},
                        {"_DETAIL_MULX2", "true"},
                        {"_DetailAlbedoMap", wave("detail_wave.exr", 1)}};
    const std::string height = written_texture("height.exr", 1, 1, [](int, int) { return glm::dvec4(0, 0.75, 0, 0); });
    for (const glm::dvec3& view : {glm::dvec3(0.6, 0, 0.8), glm::dvec3(0, -0.6, 0.8)}) {
        World world = lit_plane(kOpaque, {});
        world.view.camera = {.position = glm::vec3(4.0 * view), .target = {0, 0, 0}, .orthographic_height = 1.2f};
        // Up in the picture is against v.
        const glm::dvec2 offset = (0.75 - 0.5) * 0.08 * glm::dvec2(view.x, -view.y) / (view.z + 0.42);
        const std::string placed = fmt::format("1,1,{},{}", offset.x, offset.y);
        const Words parallax = {{"_PARALLAXMAP", "true"}, {"_ParallaxMap", height}, {"_Parallax", "0.08"}};
        const Words moved = with(maps, {{"_MainTex_ST", placed}, {"_DetailAlbedoMap_ST", placed}});
        expect_same(world, with(maps, parallax), moved, 0.01, with(maps, {{"_MainTex_ST", placed}}));
    }
}

// Keywords and properties are called as in the Standard shader; those that only its inspector reads are not there.
TEST(Standard, HasTheNamesOfTheStandardShader) {
    const Result result = compiled(kCutout, "forward");
    std::set<std::string> names, keywords;
    for (const Property& property : result.reflection.properties)
        (property.binding == Binding::Variant ? keywords : names).insert(property.name);
    EXPECT_EQ(keywords, (std::set<std::string>{"_NORMALMAP", "_METALLICGLOSSMAP", "_PARALLAXMAP", "_EMISSION",
                                               "_DETAIL_MULX2", "_SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A"}));
    EXPECT_EQ(names, (std::set<std::string>{"_Color",
                                            "_MainTex",
                                            "_Cutoff",
                                            "_Glossiness",
                                            "_GlossMapScale",
                                            "_Metallic",
                                            "_MetallicGlossMap",
                                            "_BumpScale",
                                            "_BumpMap",
                                            "_Parallax",
                                            "_ParallaxMap",
                                            "_OcclusionStrength",
                                            "_OcclusionMap",
                                            "_EmissionColor",
                                            "_EmissionMap",
                                            "_DetailMask",
                                            "_DetailAlbedoMap",
                                            "_DetailNormalMapScale",
                                            "_DetailNormalMap",
                                            "_UVSec"}));
    const VariantPlan plan = compiler().plan_variants(kOpaque, VariantsWanted::All, {}, kVariantLimit);
    EXPECT_TRUE(plan.ok);
    EXPECT_EQ(plan.count, 64u);
}

}  // namespace
}  // namespace patina::paths
