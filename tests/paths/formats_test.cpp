// Deferred in Unity's formats: it is forward over the surface that the G-buffer remembers, and what that costs against
// forward over the surface as it is stands in docs/proofs.md.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "paths/drawing/drawing.h"

namespace patina::paths {
namespace {

World scene() {
    World world = proof_world();
    world.pixel_light_count = 16;
    return world;
}

// --- ten bits

// Vulkan asks for the nearest number of a format, but does not insist. Two roundings are known here: to the nearest,
// and lavapipe's, which makes 16 bits of a number and leaves out the last six.
int nearest(double number) {
    return int(std::lround(number * 1023));
}
int cut(double number) {
    return int(std::floor(std::round(number * 65535) / 64));
}

bool device_cuts_to_ten_bits() {
    World world = proof_world();
    world.objects.clear();
    world.materials.clear();
    add_object(world, written("white.graph.json", R"({ "patina": 1, "workflow": "unlit" })"), "plane", 0, glm::mat4(1));
    const Image ramp = draw(world, {.path = "tests/paths/data/ten_bits.pass.hlsl", .stated_formats = true});
    const int count = ramp.width * ramp.height;
    int of_nearest = 0, of_cut = 0;
    for (int i = 0; i < count; ++i) {
        const int steps = int(std::lround(1023 * double(ramp.pixels[4 * std::size_t(i)])));
        of_nearest += steps == nearest(double(i) / count);
        of_cut += steps == cut(double(i) / count);
    }
    EXPECT_GE(std::max(of_nearest, of_cut), count * 999 / 1000) << "the device rounds in a way of its own";
    return of_cut > of_nearest;
}

// tests/paths/data/quantised.pass.hlsl for the extended layout: what that packs is remembered too, in half floats.
std::string quantised_with_extras() {
    std::ifstream file("tests/paths/data/quantised.pass.hlsl");
    std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const auto replace = [&](const std::string& what, const std::string& with) {
        int count = 0;
        for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += with.size(), ++count)
            text.replace(at, what.size(), with);
        EXPECT_EQ(count, 2) << what;
    };
    replace("remembered(lightingSurface())", "rememberedInFull(lightingSurface())");
    replace("\"occlusion\")]", "\"occlusion\", \"packSurface\")]");
    return written("quantised_extended.pass.hlsl", text + R"(
/// The device leaves out the bits that a half has no room for, where another rounds.
[switch] bool cutsToHalves;

/// Eleven bits from the first that is not 0.
float4 inHalves(float4 value) {
    float4 step = exp2(floor(log2(max(abs(value), 0.0001))) - 10);
    return (cutsToHalves ? trunc(value / step) : round(value / step)) * step;
}

LightingSurface rememberedInFull(LightingSurface lit) {
    SurfaceExtras extras = packSurface(lit);
    extras.first = inHalves(extras.first);
    extras.second = inHalves(extras.second);
    extras.third = inHalves(extras.third);
    return unpackSurface(remembered(lit), extras);
})");
}

// A number on the border between two steps (a smoothness of 0.7 is 178.5 bytes) goes to either, as the last bits of its
// float will have it, and those are not the same in two shaders: the picture of each pixel is one of three.
class Remembered {
public:
    using Switches = std::vector<std::pair<std::string, std::string>>;
    explicit Remembered(const World& world, const Switches& switches = {},
                        const std::string& path = "tests/paths/data/quantised.pass.hlsl") {
        for (const char* direction : {"", "upwards", "downwards"}) {
            RenderOptions options{.path = path, .switches = switches, .exact_targets = true};
            options.switches.emplace_back("cutsToTenBits", device_cuts_to_ten_bits() ? "true" : "false");
            if (*direction) options.switches.emplace_back(direction, "true");
            pictures_.push_back(draw(world, options));
        }
    }

    Difference difference_to(const Image& image) const { return difference(nearest_to(image), image); }

    // Of the three the nearest one in each pixel.
    Image nearest_to(const Image& image) const {
        Image nearest = pictures_.front();
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const auto is_nearer = [&](const Image& a, const Image& b) {
                    return apart(a, image, x, y) < apart(b, image, x, y);
                };
                const auto best = std::min_element(pictures_.begin(), pictures_.end(), is_nearer);
                std::copy_n(best->at(x, y).begin(), 4, nearest.at(x, y).begin());
            }
        }
        return nearest;
    }

private:
    std::vector<Image> pictures_;
};

// Five lights and the reflections round the sum in the half floats of RT3 once each, and what is there before them: by
// half of 2^-10 of the value at most. 7 * 2^-11 is 0.9 / 255 of the bound.
TEST(UnitysFormats, DeferredIsForwardOverWhatIsRemembered) {
    const World world = proof_scene_and_metals();
    const Remembered remembered(world);
    for (const char* path : {"deferred", "deferred-shadowmask"}) {
        for (bool stated_formats : {false, true}) {
            const Difference far =
                remembered.difference_to(draw(world, {.path = path, .stated_formats = stated_formats}));
            EXPECT_LE(far.largest, kStep) << path << ": " << to_text(far);
            std::printf("%s, RT3 in %d bits: %s\n", path, stated_formats ? 16 : 32, to_text(far).c_str());
        }
    }
    // And that is not forward over the surface as it is.
    EXPECT_GT(remembered.difference_to(draw(world, {.path = "forward"})).largest, 2 * kStep);
}

// Without the lacquer: that asks for the mesh's tangents, which no G-buffer has and the pass file of the test does.
TEST(UnitysFormats, ExtendedIsForwardOverWhatIsRememberedAndPacked) {
    World world = proof_scene_and_metals();
    std::erase_if(world.objects, [&](const runtime::WorldObject& object) {
        return world.materials[object.material].name == "lacquer";
    });
    const std::string path = quantised_with_extras();
    const Remembered rounded(world, {}, path), cut(world, {{"cutsToHalves", "true"}}, path);
    for (bool stated_formats : {false, true}) {
        const Image image = draw(world, {.path = "deferred-extended", .stated_formats = stated_formats});
        const Difference far_from_rounded = rounded.difference_to(image), far_from_cut = cut.difference_to(image);
        const Difference& far = far_from_cut.largest < far_from_rounded.largest ? far_from_cut : far_from_rounded;
        EXPECT_LE(far.largest, kStep) << to_text(far);
        std::printf("deferred-extended, RT3 in %d bits: %s\n", stated_formats ? 16 : 32, to_text(far).c_str());
    }
}

// Masks that are not of 256 steps themselves.
TEST(UnitysFormats, ShadowMasksAreRememberedInEightBits) {
    World world = proof_scene_and_metals();
    Image masks = runtime::make_image(16, 16);
    for (int i = 0; i < 256; ++i)
        for (int c = 0; c < 4; ++c) masks.at(i % 16, i / 16)[std::size_t(c)] = float((i * (3 + 2 * c)) % 100) / 99;
    const std::string file = written("masks_of_99.exr", "");
    ASSERT_EQ(runtime::save_exr(file, masks), "");
    for (runtime::WorldObject& object : world.objects) object.shadow_mask = file;
    const Image image = draw(world, {.path = "deferred-shadowmask", .stated_formats = true});
    const Difference far = Remembered(world).difference_to(image);
    EXPECT_LE(far.largest, kStep) << to_text(far);
    std::printf("with shadow masks: %s\n", to_text(far).c_str());
    for (runtime::WorldObject& object : world.objects) object.shadow_mask.clear();
    EXPECT_GT(Remembered(world).difference_to(image).largest, 2 * kStep);
}

// --- 2^-light in ten bits

double encoded(float light) {
    return std::exp2(-double(light));
}

// Each light that is multiplied in is rounded by the device's blending, in a way that no shader can repeat to the bit,
// and a step of ten bits is more than a step of the picture from a light of 1.5 on. But roundings add up to no more
// than their number, since factors are 1 at most: of five lights and what is there before them, six steps of 1/1023.
TEST(UnitysFormats, LogarithmicLightIsSixStepsAwayAtMost) {
    constexpr double kBound = 6.0 / 1023;
    const World world = proof_scene_and_metals();
    ASSERT_EQ(world.view.lights.size(), 5u);
    const Image image = draw(world, {.path = "deferred-ldr", .stated_formats = true});
    const Image expected = Remembered(world, {{"mirrorsAtOnce", "true"}}).nearest_to(image);
    double largest = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        if (i % 4 != 3) largest = std::max(largest, std::abs(encoded(image.pixels[i]) - encoded(expected.pixels[i])));
    EXPECT_LE(largest, kBound);
    EXPECT_GT(largest, 0.25 / 1023) << "as if nothing had been rounded";
    std::printf("deferred-ldr: %.2f steps of 1/1023\n", 1023 * largest);
}

// Beyond the last step of the ten bits, 1/1023, there is black alone: light ends at log2(2046).
TEST(UnitysFormats, LogarithmicLightEndsAtHalfAStep) {
    World world = proof_world();
    world.objects.clear();
    world.materials.clear();
    world.view.lights.clear();
    world.view.ambient = {};
    world.view.environment = nullptr;
    world.view.background = glm::vec4(0);
    add_object(world,
               written("lamp.graph.json", R"word({ "patina": 1, "workflow": "metallic-roughness", "lighting": "lambert",
 "properties": [{ "name": "_Light", "type": "float", "default": 0 }],
 "surface": { "baseColor": 0, "emission": "= float3($_Light)" } })word"),
               "sphere", 24, glm::mat4(1));
    world.view.camera = {.position = {0, 0, 4}, .target = {0, 0, 0}};
    const auto middle = [&](double light) {
        world.materials[0].overrides["_Light"] = fmt::format("{}", light);
        const Image image = draw(world, {.path = "deferred-ldr", .stated_formats = true});
        return double(image.at(image.width / 2, image.height / 2)[0]);
    };
    for (double light : {0.0, 0.5, 1.0, 3.0, 6.0, 9.0}) {
        // Between the light of a step more and that of a step less.
        const double code = std::exp2(-light), step = 1.0 / 1023;
        EXPECT_GE(middle(light), -std::log2(std::min(code + step, 1.0)) - 1e-3) << light;
        EXPECT_LE(middle(light), -std::log2(code - step) + 1e-3) << light;
    }
    for (double light : {12.0, 20.0, 1000.0}) EXPECT_NEAR(middle(light), std::log2(2046.0), 0.01) << light;
}

// --- what the formats cost

bool has_line(const std::string& file, const std::string& line) {
    std::ifstream in(file);
    for (std::string one; std::getline(in, one);)
        if (one == line) return true;
    return false;
}

// The table in docs/proofs.md says the truth.
TEST(UnitysFormats, CostWhatTheDocumentationSays) {
    const World world = scene();
    const Image forward = draw(world, {.path = "forward"});
    for (const char* path : {"deferred", "deferred-extended", "deferred-ldr"}) {
        const Image image = draw(world, {.path = path, .stated_formats = true});
        std::array<double, 3> largest{}, mean{};
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            if (i % 4 == 3) continue;
            const double far = 255 * apart(double(forward.pixels[i]), double(image.pixels[i]));
            largest[i % 4] = std::max(largest[i % 4], far);
            mean[i % 4] += far / (double(image.width) * image.height);
        }
        const std::string row = fmt::format("| `{}` | {:.1f} | {:.1f} | {:.1f} | {:.2f} | {:.2f} | {:.2f} |", path,
                                            largest[0], largest[1], largest[2], mean[0], mean[1], mean[2]);
        EXPECT_TRUE(has_line("docs/proofs.md", row)) << "docs/proofs.md lacks this row:\n" << row;
    }
}

}  // namespace
}  // namespace patina::paths
