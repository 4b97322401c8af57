// Deferred in Unity's formats: it is forward over the surface that the G-buffer remembers, and what that costs against
// forward over the surface as it is stands in docs/proofs.md.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "paths/drawing.h"

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
    const Image ramp = draw(world, {.path = "tests/paths/ten_bits.pass.hlsl", .stated_formats = true});
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

// A number on the border between two steps goes to either, as the last bits of its float will have it: the picture of
// each pixel is one of three.
class Remembered {
public:
    explicit Remembered(const World& world) {
        const std::pair<std::string, std::string> cuts{"cuts_to_ten_bits",
                                                       device_cuts_to_ten_bits() ? "true" : "false"};
        const WorldOptions options{.path = "tests/paths/quantised.pass.hlsl", .exact_targets = true};
        for (const char* direction : {"", "upwards", "downwards"}) {
            WorldOptions one = options;
            one.switches = {cuts};
            if (*direction) one.switches.emplace_back(direction, "true");
            pictures_.push_back(draw(world, one));
        }
    }

    // Of the three the nearest one in each pixel.
    Difference difference_to(const Image& image) const {
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
        return difference(nearest, image);
    }

private:
    std::vector<Image> pictures_;
};

// Five lights and the reflections round the sum in the half floats of RT3 once each, and what is there before them: by
// half of 2^-10 of the value at most. 7 * 2^-11 is 0.9 / 255 of the bound.
TEST(UnitysFormats, DeferredIsForwardOverWhatIsRemembered) {
    const World world = proof_scene_and_metals();
    const Remembered remembered(world);
    for (bool stated_formats : {false, true}) {
        const Difference far =
            remembered.difference_to(draw(world, {.path = "deferred", .stated_formats = stated_formats}));
        EXPECT_LE(far.largest, kStep) << to_text(far);
        std::printf("RT3 in %d bits: %s\n", stated_formats ? 16 : 32, to_text(far).c_str());
    }
    // And that is not forward over the surface as it is.
    EXPECT_GT(remembered.difference_to(draw(world, {.path = "forward"})).largest, 2 * kStep);
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
