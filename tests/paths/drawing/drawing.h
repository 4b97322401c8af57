// Worlds drawn along rendering paths for tests, and how far apart two of the pictures are. One sample a pixel, linear
// floats; the validation layer's messages are failures.
//
//   const Image forward = draw(proof_world(), {.path = "forward"}), base_and_add = draw(..., {.path = "forward-add"});
//   EXPECT_LE(largest(apart(forward, base_and_add)).value, kStep);
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "runtime/render/render_world.h"

namespace patina::paths {

using runtime::Image;
using runtime::RenderOptions;
using runtime::World;

inline constexpr double kStep = 1.0 / 255;  // the smallest step of a picture of bytes

const Compiler& compiler();

// The scene of examples/scenes/five-lights.scene.json. Tests run in the project's folder.
World proof_world(int width = 160, int height = 120);
// An object of one mesh, drawn with a new material that this graph file makes.
void add_object(World& world, const std::string& graph, const std::string& mesh, int segments,
                const glm::mat4& object_to_world, std::map<std::string, std::string> overrides = {});

// The proof scene with as many pixel lights as it has lights, and in front of it a row of metal balls of lighting
// models that it lacks: those mirror the surroundings in a pass of their own where there is a G-buffer.
World proof_scene_and_metals(int width = 160, int height = 120);

// A graph, lighting graph or pass file that a test writes; its path. The same name is the same file.
std::string written(const std::string& name, const std::string& text);
// A texture of floats, which are linear colours or data; its path.
std::string written_texture(const std::string& name, int width, int height,
                            const std::function<glm::dvec4(int x, int y)>& texel);

// A graph compiled for a path, or for what it falls back to.
Result compiled(const std::string& graph, const std::string& path,
                std::vector<std::pair<std::string, std::string>> switches = {});
bool has(const std::vector<std::string>& names, const std::string& name);
// Null: it has none of this name.
const Pass* find_pass(const Result& result, const std::string& name);

struct Drawn {
    Image image{};
    std::vector<Diagnostic> diagnostics{};

    // The codes of its warnings, once each, in order.
    std::vector<std::string> codes() const;
};
// Anything that goes wrong fails the test.
Drawn drawn(const World& world, const RenderOptions& options);
Image draw(const World& world, const RenderOptions& options);

// How far two numbers of pictures are apart: their difference, and where they are brighter than white, their difference
// for each unit of the brighter. A picture shows nothing beyond white, so this asks for more there than can be seen;
// an absolute bound would ask a highlight of 1000 for the last bits of its floats.
double apart(double a, double b);

// The largest of red, green and blue.
double apart(const Image& a, const Image& b, int x, int y);

struct Difference {
    double largest = 0;   // of all channels; infinite where one picture holds no number
    double mean = 0;      // of the channels, over what was compared
    int x = 0, y = 0;     // where the largest is
    std::string shown{};  // both pixels there
};
// Red, green and blue of the pixels that `counts` names; all, where it names none. Pictures of one size.
Difference difference(const Image& a, const Image& b, const std::function<bool(int x, int y)>& counts = {});
std::string to_text(const Difference& difference);

// Pixels of which red, green or blue is not what `empty` has: pictures that show nothing prove nothing.
int lit_pixels(const Image& image, float darkest = 0.02f);

}  // namespace patina::paths

#define EXPECT_SAME_PICTURE(a, b)                                                                \
    do {                                                                                         \
        const ::patina::paths::Difference how_far = ::patina::paths::difference(a, b);           \
        EXPECT_LE(how_far.largest, ::patina::paths::kStep) << ::patina::paths::to_text(how_far); \
    } while (false)
