// Baked light behind passes, by formulas: a matt plane that fills the picture shows its lightmap, baked shadows mixed
// with real-time ones, subtractive shadows, and the pictures that lights shine through. Along each path, on the GPU and
// the CPU.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "paths/drawing/matt_plane.h"

namespace patina::paths {
namespace {

using runtime::Light;

// Texels are as many as pixels, so that pixel centres are texel centres.
std::string texture_file(const std::string& name, const std::function<glm::dvec4(int x, int y)>& texel) {
    Image image = runtime::make_image(kSide, kSide);
    for (int i = 0; i < kSide * kSide; ++i) {
        const glm::dvec4 value = texel(i % kSide, i / kSide);
        for (int c = 0; c < 4; ++c) image.at(i % kSide, i / kSide)[std::size_t(c)] = float(value[c]);
    }
    const std::string file = written(name, "");
    EXPECT_EQ(name.ends_with(".png") ? runtime::save_png_as_is(file, image) : runtime::save_exr(file, image), "");
    return file;
}

struct Way {
    const char* path;
    const char* via = "glsl";
};
constexpr Way kWays[] = {{"forward"},       {"forward", "hlsl"},     {"forward", "cpu"},
                         {"forward-add"},   {"forward-directional"}, {"vertex"},
                         {"deferred"},      {"deferred-extended"},   {"deferred-shadowmask"},
                         {"vertex", "cpu"}, {"deferred", "cpu"}};
RenderOptions options_of(const Way& way) {
    return {.path = way.path, .via = way.via, .exact_targets = true};
}

// --- lightmaps

// 8 bits of sRGB, as IEC 61966-2-1 has them.
double linear_of_byte(int byte) {
    const double encoded = byte / 255.0;
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}
glm::ivec4 bytes_at(int x, int y) {
    return {16 * x, 255 - 16 * y, 128, 40 + 12 * x};
}
glm::dvec4 texel_of_bytes(int x, int y) {
    return glm::dvec4(bytes_at(x, y)) / 255.0;
}

struct Baked {
    const char* name;
    LightmapEncoding encoding;
    std::string file;
    std::function<glm::dvec3(int x, int y)> light;
};
std::vector<Baked> all_baked() {
    using enum LightmapEncoding;
    const auto colors = [](int x, int y) {
        const glm::ivec4 b = bytes_at(x, y);
        return glm::dvec3(linear_of_byte(b.x), linear_of_byte(b.y), linear_of_byte(b.z));
    };
    const auto gradient = [](int x, int y) { return glm::dvec3(0.25 * x, 0.1 * y, 1.5); };
    return {{"constant", Hdr, texture_file("constant.exr", [](int, int) { return glm::dvec4(3, 2, 0.5, 1); }),
             [](int, int) { return glm::dvec3(3, 2, 0.5); }},
            {"gradient", Hdr,
             texture_file("gradient.exr", [&](int x, int y) { return glm::dvec4(gradient(x, y), 0.3); }), gradient},
            {"bytes as they are", Hdr, texture_file("bytes.png", texel_of_bytes), colors},
            {"rgbm", Rgbm, texture_file("bytes.png", texel_of_bytes),
             [=](int x, int y) { return colors(x, y) * std::pow(5 * bytes_at(x, y).w / 255.0, 2.2); }},
            {"dldr", DoubleLdr, texture_file("bytes.png", texel_of_bytes),
             [=](int x, int y) { return colors(x, y) * std::pow(2.0, 2.2); }}};
}

// The lightmap stands in the place of ambient light, of which there is some; a lamp adds its own.
TEST(Lightmaps, AreTheDiffuseColourTimesTheirLight) {
    World world = matt_plane();
    world.view.ambient = runtime::constant_ambient(glm::vec3(7));
    world.view.lights = {{.direction = {0, 0, 1}, .color = {0.25f, 0.5f, 1}}};
    for (const Baked& baked : all_baked()) {
        world.objects[0].lightmap = baked.file;
        world.objects[0].lightmap_encoding = baked.encoding;
        for (const Way& way : kWays) {
            SCOPED_TRACE(std::string(baked.name) + " along " + way.path + " via " + way.via);
            expect_everywhere(draw(world, options_of(way)),
                              [&](int x, int y) { return kDiffuse * (baked.light(x, y) + glm::dvec3(0.25, 0.5, 1)); });
        }
    }
}

TEST(Lightmaps, BelongToTheirObjectsAlone) {
    World world = matt_plane();
    world.view.ambient = runtime::constant_ambient(glm::vec3(0.5f));
    world.objects[0].object_to_world = glm::scale(glm::mat4(1), {1, 1, 1});
    // The left half is another plane, a little nearer, without a lightmap.
    world.objects.push_back(world.objects[0]);
    world.objects[1].object_to_world = glm::translate(glm::mat4(1), {-1, 0, 1e-3f});
    world.objects[0].lightmap = texture_file("constant.exr", [](int, int) { return glm::dvec4(3, 2, 0.5, 1); });
    for (const Way& way : kWays) {
        SCOPED_TRACE(std::string(way.path) + " via " + way.via);
        expect_everywhere(draw(world, options_of(way)), [&](int x, int) {
            return kDiffuse * (right(x) < 0 ? glm::dvec3(0.5) : glm::dvec3(3, 2, 0.5));
        });
    }
}

// --- shadows

// The sun shines from the right at 45 degrees, past a screen that the camera does not see; its shadow covers the left
// half. A lamp straight in front casts shadows too, and none falls on the plane.
constexpr double kSun = 2, kLamp = 0.5, kSunCosine = 1 / std::numbers::sqrt2;
World shaded_plane(float strength = 1) {
    World world = matt_plane();
    world.view.lights = {{.direction = {0, 0, 1}, .color = glm::vec3(kLamp), .shadow = {.casts = true}},
                         {.direction = {1, 0, 1}, .color = glm::vec3(kSun), .shadow = {.casts = true}}};
    world.view.lights[1].shadow.strength = strength;
    const glm::mat4 screen = glm::translate(glm::mat4(1), {2.25f, 0, 3}) * glm::scale(glm::mat4(1), {0.75f, 1.5f, 1});
    add_object(world, matt(), "plane", 8, screen);
    return world;
}
// The filter blurs the shadow's edge.
bool is_clear(int x, int) {
    return std::abs(right(x)) > 0.15;
}
double realtime(int x) {
    return right(x) < 0 ? 0 : 1;
}

// The lamp casts first, so it has red, and the sun green.
glm::dvec4 masks(int x, int y) {
    return {y / 15.0, (x + y) / 30.0, 0, 0};
}

struct Mixing {
    const char* name;
    LightMixing mode;
    bool has_mask;
    double (*formula)(double realtime, double baked, double fade);
};
constexpr Mixing kMixings[] = {
    {"shadow mask", LightMixing::ShadowMask, true,
     [](double realtime, double baked, double fade) { return std::min(std::min(realtime + fade, 1.0), baked); }},
    {"distance shadow mask", LightMixing::DistanceShadowMask, true,
     [](double realtime, double baked, double fade) { return realtime + (baked - realtime) * fade; }},
    {"no mask", LightMixing::ShadowMask, false,
     [](double realtime, double, double fade) { return std::min(realtime + fade, 1.0); }},
};

// Shadows end where they fade by so much at 4 m.
void set_fade(World& world, double fade) {
    if (fade == 0.5) world.view.mixed_lighting.shadow_distance = 5.0f, world.view.mixed_lighting.shadow_fade = 2.0f;
    if (fade == 1) world.view.mixed_lighting.shadow_distance = 3.0f;
}

void expect_mixed(const Mixing& mixing, double fade, const Way& way) {
    SCOPED_TRACE(std::string(mixing.name) + ", fade " + std::to_string(fade) + ", along " + way.path + " via " +
                 way.via);
    World world = shaded_plane();
    world.view.mixed_lighting.mode = mixing.mode;
    if (mixing.has_mask) world.objects[0].shadow_mask = texture_file("masks.exr", masks);
    set_fade(world, fade);
    const auto expected = [&](int x, int y) {
        const double sun = mixing.formula(realtime(x), masks(x, y).y, fade);
        const double lamp = mixing.formula(1, masks(x, y).x, fade);
        return glm::dvec3(kDiffuse * (kSun * kSunCosine * sun + kLamp * lamp));
    };
    expect_everywhere(draw(world, options_of(way)), expected, 2e-3, is_clear);
}

TEST(ShadowMasks, MixByTheirFormulas) {
    for (const Mixing& mixing : kMixings) {
        for (const double fade : {0.0, 0.5, 1.0}) expect_mixed(mixing, fade, {"forward"});
        for (const Way& way : kWays)
            if (std::string(way.path) != "vertex") expect_mixed(mixing, 0.5, way);
    }
}

// Where they are the same in all pixels, so are they along the path that reads them at the vertices.
TEST(ShadowMasks, AreReadAtTheVertices) {
    World world = shaded_plane();
    world.objects[0].shadow_mask = texture_file("even.exr", [](int, int) { return glm::dvec4(0.25, 0.75, 0, 0); });
    const auto expected = [](int x, int) {
        return glm::dvec3(kDiffuse * (kSun * kSunCosine * std::min(realtime(x), 0.75) + kLamp * 0.25));
    };
    const auto is_far = [](int x, int) { return std::abs(right(x)) > 0.4; };  // from the edge, by more than a triangle
    for (const char* via : {"glsl", "cpu"})
        expect_everywhere(draw(world, {.path = "vertex", .via = via}), expected, 2e-3, is_far);
}

// Without a fifth target there is no place for them: the objects that have one are drawn along `forward`.
TEST(ShadowMasks, NeedTheirOwnDeferredPath) {
    World world = shaded_plane();
    EXPECT_EQ(drawn(world, {.path = "deferred"}).codes(), std::vector<std::string>{});
    world.objects[0].shadow_mask = texture_file("masks.exr", masks);
    EXPECT_EQ(drawn(world, {.path = "deferred"}).codes(), std::vector<std::string>{"path-refused"});
    EXPECT_EQ(drawn(world, {.path = "deferred-shadowmask"}).codes(), std::vector<std::string>{});
}

// Eight materials, lights of three kinds: the fifth target tells what the forward path reads itself.
TEST(ShadowMasks, AreTheSameInDeferredAndForward) {
    World world = proof_world();
    world.pixel_light_count = 16;  // all of them
    for (runtime::WorldObject& object : world.objects) {
        if (&object != &world.objects[2]) object.shadow_mask = texture_file("masks.exr", masks);
        if (&object == &world.objects[0])
            object.lightmap = texture_file("constant.exr", [](int, int) { return glm::dvec4(0.3, 0.2, 0.5, 1); });
    }
    world.view.mixed_lighting = {.mode = LightMixing::DistanceShadowMask, .shadow_distance = 9.0f, .shadow_fade = 4.0f};
    const Image forward = draw(world, {.path = "forward", .exact_targets = true});
    EXPECT_SAME_PICTURE(forward, draw(world, {.path = "deferred-shadowmask", .exact_targets = true}));
    EXPECT_SAME_PICTURE(forward, draw(world, {.path = "forward-add", .exact_targets = true}));
    world.view.mixed_lighting = {};
    for (runtime::WorldObject& object : world.objects) object.shadow_mask.clear();
    EXPECT_GT(difference(forward, draw(world, {.path = "forward", .exact_targets = true})).mean, kStep);
}

TEST(Subtractive, TakesTheShadowOutOfTheLightmap) {
    const glm::dvec3 map(1.6, 1.2, 0.4), floor_color(0.1, 0.5, 0.6);
    for (const double strength : {1.0, 0.6}) {
        for (const double fade : {0.0, 0.5, 1.0}) {
            World world = shaded_plane(float(strength));
            world.view.mixed_lighting = {.mode = LightMixing::Subtractive, .shadow_color = glm::vec3(floor_color)};
            set_fade(world, fade);
            world.objects[0].lightmap = texture_file("map.exr", [&](int, int) { return glm::dvec4(map, 1); });
            const auto expected = [&](int x, int) {
                const double left = std::min(realtime(x) + fade, 1.0);
                const glm::dvec3 taken = glm::dvec3(kSunCosine * (1 - left) * kSun);
                const glm::dvec3 darkest = glm::max(map - taken, floor_color);
                // The lamp is real; the sun is in the lightmap alone.
                return kDiffuse * (glm::min(map, glm::mix(darkest, map, 1 - strength)) + glm::dvec3(kLamp));
            };
            for (const Way& way : kWays) {
                SCOPED_TRACE(std::string(way.path) + " via " + way.via + ", strength " + std::to_string(strength) +
                             ", fade " + std::to_string(fade));
                const bool is_usual = strength == 1 && fade == 0;
                if (!is_usual && std::string(way.path) != "forward") continue;
                expect_everywhere(draw(world, options_of(way)), expected, 2e-3, is_clear);
            }
        }
    }
}

// --- cookies

std::shared_ptr<const TextureData> cookie() {
    Image image = runtime::make_image(8, 8);
    for (int i = 0; i < 64; ++i) image.at(i % 8, i / 8)[0] = float(i % 8 + 2 * (i / 8)) / 21;
    TextureData data{.levels = {{.width = 8, .height = 8, .texels = image.pixels}}, .sampler = {}};
    data.sampler.wrap = Wrap::Clamp;
    return std::make_shared<const TextureData>(std::move(data));
}
// The picture is linear in u and v between the centres of its outer texels.
double cookie_at(double u, double v) {
    const auto texel = [](double t) { return std::clamp(8 * t - 0.5, 0.0, 7.0); };
    return (texel(u) + 2 * texel(v)) / 21;
}

// Straight in front, 4 m wide: u to the right, v downwards, the origin in the middle.
Light sun_with_cookie() {
    return {.direction = {0, 0, 1}, .color = glm::vec3(1), .cookie = cookie(), .cookie_size = 4};
}
double through_sun(int x, int y) {
    return cookie_at(0.5 + right(x) / 4, 0.5 - up(y) / 4);
}
// From 2 m; its picture ends with its cone, at 2 m from the middle of the plane.
Light spot_with_cookie() {
    return {.kind = LightKind::Spot,
            .position = {0, 0, 2},
            .direction = {0, 0, -1},
            .color = glm::vec3(4),
            .range = 10,
            .inner_angle = 44.9f,
            .outer_angle = 45,
            .cookie = cookie()};
}
double through_spot(int x, int y) {
    const double squared = 4 + right(x) * right(x) + up(y) * up(y), share = squared / 100;
    const double window = std::pow(1 - share * share, 2), cosine = 2 / std::sqrt(squared);
    return 4 * window / squared * cosine * cookie_at(0.5 + right(x) / 4, 0.5 - up(y) / 4);
}

TEST(Cookies, AreWhatLightsShineThrough) {
    World world = matt_plane();
    for (const Way& way : kWays) {
        SCOPED_TRACE(std::string(way.path) + " via " + way.via);
        if (std::string(way.path) == "vertex") continue;  // it has their light at the vertices
        world.view.lights = {sun_with_cookie()};
        expect_everywhere(draw(world, options_of(way)),
                          [](int x, int y) { return glm::dvec3(kDiffuse * through_sun(x, y)); });
        world.view.lights = {spot_with_cookie()};
        expect_everywhere(draw(world, options_of(way)),
                          [](int x, int y) { return glm::dvec3(kDiffuse * through_spot(x, y)); });
    }
}

TEST(Cookies, OfSeveralLightsNeedADrawForEach) {
    World world = matt_plane();
    world.view.lights = {sun_with_cookie(), spot_with_cookie()};
    for (const char* path : {"forward-add", "deferred"}) {
        const Drawn both = drawn(world, {.path = path, .exact_targets = true});
        EXPECT_EQ(both.codes(), std::vector<std::string>{}) << path;
        expect_everywhere(both.image,
                          [](int x, int y) { return glm::dvec3(kDiffuse * (through_sun(x, y) + through_spot(x, y))); });
    }
    EXPECT_EQ(drawn(world, {.path = "forward"}).codes(), std::vector<std::string>{"one-cookie"});
    world.view.lights.pop_back();
    EXPECT_EQ(drawn(world, {.path = "forward"}).codes(), std::vector<std::string>{});
}

// --- what is not there costs nothing

// In a block, a texture or a shader's text.
bool mentions(const Result& result, const std::string& name) {
    for (const Block& block : result.reflection.blocks)
        for (const BlockMember& member : block.members)
            if (member.name == name) return true;
    for (const Texture& texture : result.reflection.textures)
        if (texture.name == name) return true;
    for (const Shader& shader : result.shaders)
        if (shader.text.find(name) != shader.text.npos) return true;
    return false;
}

// Of fog and cookies, too.
TEST(BakedLight, LeavesNoTraceWhereItIsOff) {
    const std::vector<std::string> own = {"lightmapTexture", "lightmapDecode", "mainLight",   "shadowColor",
                                          "shadowMask",      "lightMask",      "shadowFade",  "uv1",
                                          "fogColor",        "fogSettings",    "lightCookie", "worldToCookie"};
    for (const char* path :
         {"forward", "forward-add", "forward-directional", "vertex", "deferred", "deferred-extended", "deferred-ldr"})
        for (const std::string& name : own)
            EXPECT_FALSE(mentions(compiled(matt(), path), name)) << path << ": " << name;
}

TEST(BakedLight, IsThereWhereASwitchIsOn) {
    const std::pair<const char*, std::vector<std::string>> on[] = {{"fog", {"fogColor", "fogSettings"}},
                                                                   {"cookies", {"lightCookie", "worldToCookie"}},
                                                                   {"lightmap", {"lightmapTexture", "uv1"}}};
    for (const auto& [name, values] : on)
        for (const std::string& value : values)
            EXPECT_TRUE(mentions(compiled(matt(), "forward", {{name, "true"}}), value)) << value;
}

TEST(BakedLight, ReadsWhatItsSwitchesSay) {
    const Result with_map = compiled(matt(), "forward", {{"lightmap", "true"}});
    const Pass& pass = *find_pass(with_map, "forward");
    EXPECT_TRUE(has(pass.textures, "lightmapTexture"));
    EXPECT_FALSE(has(pass.textures, "shadowMaskTexture"));
    EXPECT_FALSE(has(pass.blocks, "Ambient"));  // it is not there to be read, too
    const Result with_mask = compiled(matt(), "deferred-shadowmask", {{"shadowMask", "true"}});
    EXPECT_TRUE(has(find_pass(with_mask, "gbuffer-shadowmask")->textures, "shadowMaskTexture"));
    EXPECT_EQ(find_pass(with_mask, "gbuffer-shadowmask")->targets.size(), 5u);
    EXPECT_TRUE(has(find_pass(with_mask, "shadowmask-directional")->textures, "gbufferShadowMaskTexture"));
    EXPECT_FALSE(has(find_pass(with_mask, "shadowmask-directional")->textures, "shadowMaskTexture"));
}

}  // namespace
}  // namespace patina::paths
