// Frames of several steps against closed forms, on the GPU with the validation layer on, and on the CPU.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "frame_fixture.h"

namespace patina::runtime {
namespace {

constexpr int kSize = 8;

FrameTarget target(TargetFormat format, glm::vec4 clear = glm::vec4(0), int size = kSize) {
    return {
        .name = "a " + std::string(to_string(format)), .format = format, .width = size, .height = size, .clear = clear};
}

glm::vec4 pixel(const Image& image, int x = 0, int y = 0) {
    const std::span<const float> p = image.at(x, y);
    return {p[0], p[1], p[2], p[3]};
}

void expect_near(const glm::vec4& value, const glm::vec4& expected, float tolerance, const std::string& where) {
    for (int c = 0; c < 4; c++) EXPECT_NEAR(value[c], expected[c], tolerance) << where << ", channel " << c;
}

class Frames : public testing::Test {
protected:
    static void SetUpTestSuite() {
        auto opened = Renderer::open({.validation = true});
        ASSERT_TRUE(opened) << opened.error;
        renderer = std::move(opened.value);
    }
    static void TearDownTestSuite() { renderer.reset(); }
    void TearDown() override {
        ASSERT_TRUE(renderer);
        EXPECT_EQ(renderer->messages(), std::vector<std::string>{});
    }

    static Outcome<Image> try_draw(const Frame& frame, bool on_gpu) {
        return on_gpu ? renderer->draw(frame) : cpu_draw(frame);
    }
    static Image draw(const Frame& frame, bool on_gpu) {
        auto image = try_draw(frame, on_gpu);
        EXPECT_TRUE(image) << image.error;
        return image ? image.value : make_image(kSize, kSize);
    }

    static inline std::unique_ptr<Renderer> renderer;
    const Mesh full = clip_quad();
};

// The parameter: drawn on the GPU.
class FrameTest : public Frames, public testing::WithParamInterface<bool> {
protected:
    static Image draw(const Frame& frame) { return Frames::draw(frame, GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(Both, FrameTest, testing::Values(true, false),
                         [](const auto& info) { return info.param ? "Gpu" : "Cpu"; });

// --- colours

// Each pair of words in a pixel of its own: alpha has the two the other way round.
TEST_P(FrameTest, BlendsByEveryPairOfWords) {
    const glm::vec4 source(0.25f, 0.5f, 0.75f, 0.5f), before(0.5f, 0.25f, 1, 0.75f), one(1);
    const std::vector<std::pair<BlendFactor, glm::vec4>> words = {{BlendFactor::Zero, glm::vec4(0)},
                                                                  {BlendFactor::One, one},
                                                                  {BlendFactor::SourceColor, source},
                                                                  {BlendFactor::OneMinusSourceColor, one - source},
                                                                  {BlendFactor::TargetColor, before},
                                                                  {BlendFactor::OneMinusTargetColor, one - before},
                                                                  {BlendFactor::SourceAlpha, glm::vec4(0.5f)},
                                                                  {BlendFactor::OneMinusSourceAlpha, glm::vec4(0.5f)},
                                                                  {BlendFactor::TargetAlpha, glm::vec4(0.75f)},
                                                                  {BlendFactor::OneMinusTargetAlpha, glm::vec4(0.25f)}};
    const auto count = int(words.size());
    const HandMaterial material = hand_material(1);
    std::deque<HandMaterial> materials;
    Frame frame{.targets = {target(TargetFormat::Rgba32F, before, count)}};
    for (int i = 0; i < count * count; i++) {
        HandMaterial& each = materials.emplace_back(material);
        each.pass().targets[0].blend = {.source = words[i % count].first,
                                        .destination = words[i / count].first,
                                        .source_alpha = words[i / count].first,
                                        .destination_alpha = words[i % count].first};
        frame.steps.push_back(hand_step(each, full, {source}, {0}));
        frame.steps.back().area = {.x = i % count, .y = i / count, .width = 1, .height = 1};
    }
    const Image image = draw(frame);
    for (int y = 0; y < count; y++)
        for (int x = 0; x < count; x++) {
            glm::vec4 expected = source * words[x].second + before * words[y].second;
            expected.a = source.a * words[y].second.a + before.a * words[x].second.a;
            expect_near(pixel(image, x, y), expected, 1e-6f,
                        fmt::format("{}, {}", to_string(words[x].first), to_string(words[y].first)));
        }
}

TEST_P(FrameTest, WritesWhatTheFormatHolds) {
    const HandMaterial material = hand_material(1);
    const auto stored = [&](TargetFormat format, const glm::vec4& value) {
        return pixel(draw({.targets = {target(format)}, .steps = {hand_step(material, full, {value}, {0})}}));
    };
    EXPECT_EQ(stored(TargetFormat::Rgba8, {0.5f, 2, -1, 0.123f}), glm::vec4(128 / 255.0f, 1, 0, 31 / 255.0f));
    EXPECT_EQ(stored(TargetFormat::Rgb10A2, {0.5f, 2, -1, 0.5f}), glm::vec4(512 / 1023.0f, 1, 0, 2 / 3.0f));
    EXPECT_EQ(stored(TargetFormat::Rgba32F, {0.1f, -2, 1e9f, 0.7f}), glm::vec4(0.1f, -2, 1e9f, 0.7f));
    EXPECT_EQ(stored(TargetFormat::R32F, {0.1f, 0.2f, 0.3f, 0.4f}), glm::vec4(0.1f, 0, 0, 1));

    // Exact in 11 bits, a quarter above one step, three quarters above it, and a subnormal number. Vulkan leaves it
    // open whether a half is the nearest or the one towards zero; the CPU takes the nearest.
    const float step = 1 / 1024.0f;
    const glm::vec4 half = stored(TargetFormat::Rgba16F, {1.5f, 1 + step / 4, 1 + step * 3 / 4, std::ldexp(3.0f, -24)});
    EXPECT_EQ(half.r, 1.5f);
    EXPECT_EQ(half.g, 1);
    EXPECT_TRUE(half.b == 1 + step || (GetParam() && half.b == 1)) << half.b;
    EXPECT_EQ(half.a, std::ldexp(3.0f, -24));
}

// Fixed-point targets blend what is clamped to 0..1: 0.2 of 1, not of 2.
TEST_P(FrameTest, ClampsBeforeItBlendsInFixedPoint) {
    HandMaterial material = hand_material(1);
    material.pass().targets[0].blend.source = BlendFactor::SourceAlpha;
    material.pass().targets[0].blend.destination = BlendFactor::One;
    const Frame frame{.targets = {target(TargetFormat::Rgba8, glm::vec4(0, 0.6f, 1, 0))},
                      .steps = {hand_step(material, full, {{2, 2, 2, 0.2f}}, {0})}};
    expect_near(pixel(draw(frame)), {51 / 255.0f, 204 / 255.0f, 1, 51 / 255.0f}, 1e-6f, "0.2 * 1 + before");
}

TEST_P(FrameTest, WritesSeveralTargetsEachInItsWay) {
    HandMaterial material = hand_material(5);
    material.pass().targets[3].blend.destination = material.pass().targets[3].blend.destination_alpha =
        BlendFactor::One;
    const std::vector<glm::vec4> colors = {{1, 0, 0, 1}, {0, 1 / 3.0f, 0, 1}, {0, 0, 3, 1}, {4, 4, 4, 4}, {5, 0, 0, 1}};
    Frame frame{.targets = {target(TargetFormat::R32F), target(TargetFormat::Rgba32F, glm::vec4(1)),
                            target(TargetFormat::Rgba16F), target(TargetFormat::Rgb10A2), target(TargetFormat::Rgba8)},
                .steps = {hand_step(material, full, colors, {4, 3, 2, 1, 0})}};
    const glm::vec4 expected[] = {{5, 0, 0, 1}, glm::vec4(5), {0, 0, 3, 1}, {0, 341 / 1023.0f, 0, 1}, {1, 0, 0, 1}};
    for (frame.shown = 0; frame.shown < 5; frame.shown++)
        expect_near(pixel(draw(frame), 3, 5), expected[frame.shown], 1e-6f, frame.targets[frame.shown].name);
}

// --- reads

TEST_P(FrameTest, ReadsWhatWasThereWhenTheStepBegan) {
    const HandMaterial material = hand_material(1, true);
    Mesh twice = full;  // the second layer must not see the first
    for (std::size_t i = 0; i < full.indices.size(); i++) twice.indices.push_back(full.indices[i]);
    Frame frame{.targets = {target(TargetFormat::Rgba32F, {1, 2, 3, 4})}};
    for (int i = 0; i < 3; i++) {
        frame.steps.push_back(hand_step(material, twice, {{0.25f, 0.5f, -1, 2}}, {0}));
        frame.steps.back().reads = {{.texture = "earlier", .target = 0}};
    }
    EXPECT_EQ(pixel(draw(frame), 7, 7), glm::vec4(1.75f, 3.5f, 0, 10));
    EXPECT_EQ(pixel(draw(frame), 7, 7), glm::vec4(1.75f, 3.5f, 0, 10));  // and begins anew
}

// A paints, B = A + 1, A = B + 1: back and forth between reading and drawing.
TEST_P(FrameTest, ReadsTargetsOfEarlierSteps) {
    const HandMaterial paint = hand_material(1), add = hand_material(1, true);
    Frame frame{.targets = {target(TargetFormat::Rgba32F), target(TargetFormat::Rgba32F),
                            target(TargetFormat::R32F, glm::vec4(9))},
                .steps = {hand_step(paint, full, {glm::vec4(0.5f)}, {0}), hand_step(add, full, {glm::vec4(1)}, {1}),
                          hand_step(add, full, {glm::vec4(1)}, {0}), hand_step(add, full, {glm::vec4(1)}, {1})}};
    frame.steps[1].reads = {{.texture = "earlier", .target = 0}};
    frame.steps[2].reads = {{.texture = "earlier", .target = 1}};
    frame.steps[3].reads = {{.texture = "earlier", .target = 2}};  // never drawn into: as it was cleared
    EXPECT_EQ(pixel(draw(frame)), glm::vec4(2.5f));
    frame.shown = 1;
    EXPECT_EQ(pixel(draw(frame)), glm::vec4(10, 1, 1, 2));
}

// What the pass does not read need not be there.
TEST_P(FrameTest, SkipsATextureThatThePassDoesNotRead) {
    HandMaterial material = hand_material(1);
    material.reflection.textures = hand_material(1, true).reflection.textures;
    const Frame frame{.targets = {target(TargetFormat::Rgba8)},
                      .steps = {hand_step(material, full, {glm::vec4(1)}, {0})}};
    EXPECT_EQ(pixel(draw(frame)), glm::vec4(1));
}

// --- depth and stencil

// Depth at the centre of column x of a plane from `left` to `right`.
float plane_depth(int x, float left, float right, int width = kSize) {
    return left + (right - left) * (float(x) + 0.5f) / float(width);
}

TEST_P(FrameTest, DrawsDepthAloneAndReadsIt) {
    HandMaterial depth_only = hand_material(0);
    depth_only.pass().depth_test = Compare::Less;
    depth_only.pass().depth_write = true;
    HandMaterial show = hand_material(1, true);
    const Mesh plane = clip_quad(-1, 1, 0.25f, 0.75f), behind = clip_quad(-1, 1, 0.8f, 0.9f);
    Frame frame{.targets = {target(TargetFormat::Rgba32F), target(TargetFormat::Depth, glm::vec4(1))},
                .steps = {hand_step(depth_only, plane, {}, {}, 1), hand_step(depth_only, behind, {}, {}, 1),
                          hand_step(show, full, {glm::vec4(0)}, {0})}};
    frame.steps[2].reads = {{.texture = "earlier", .target = 1}};
    const auto expect_plane = [&](const std::string& where) {
        const Image image = draw(frame);
        for (int x = 0; x < kSize; x++)
            expect_near(pixel(image, x, x), {plane_depth(x, 0.25f, 0.75f), 0, 0, 1}, 1e-6f, where);
    };
    expect_plane("read");
    frame.steps[2].depth = 1;  // now with the same depth attached
    expect_plane("attached");
    show.pass().depth_write = true;  // it writes 0.5 everywhere, and still sees the plane
    expect_plane("written");
    frame.shown = 1;
    EXPECT_EQ(pixel(draw(frame), 2, 2), glm::vec4(0.5f, 0, 0, 1));
    frame.steps.pop_back();
    expect_plane("shown");
}

TEST_P(FrameTest, TestsDepthFromStepToStep) {
    HandMaterial material = hand_material(1);
    material.pass().depth_write = true;
    const Mesh near_left = clip_quad(-1, 0, 0.25f, 0.25f);
    const auto shows = [&](Compare test) {
        material.pass().depth_test = test;
        const Frame frame{.targets = {target(TargetFormat::Rgba8), target(TargetFormat::Depth, glm::vec4(0.5f))},
                          .steps = {hand_step(material, near_left, {{1, 0, 0, 1}}, {0}, 1),
                                    hand_step(material, full, {{0, 1, 0, 1}}, {0}, 1)}};
        const Image image = draw(frame);
        return std::pair(pixel(image, 0, 0), pixel(image, 7, 0));
    };
    const glm::vec4 none(0), red(1, 0, 0, 1), green(0, 1, 0, 1);
    EXPECT_EQ(shows(Compare::Never), std::pair(none, none));
    EXPECT_EQ(shows(Compare::Less), std::pair(red, none));
    EXPECT_EQ(shows(Compare::LessEqual), std::pair(red, green));
    EXPECT_EQ(shows(Compare::Equal), std::pair(green, green));
    EXPECT_EQ(shows(Compare::NotEqual), std::pair(green, none));  // 0.25, and then 0.5 against 0.25
    EXPECT_EQ(shows(Compare::Greater), std::pair(none, none));
    EXPECT_EQ(shows(Compare::GreaterEqual), std::pair(green, green));
    EXPECT_EQ(shows(Compare::Always), std::pair(green, green));
}

// Vulkan 1.3, "Depth Bias": for a 32-bit float the least difference is 2^(e - 23) with the exponent e of the largest
// depth of the triangle; the slope is the larger of the two derivatives.
TEST_P(FrameTest, AddsTheDepthBias) {
    HandMaterial material = hand_material(0);
    material.pass().depth_write = true;
    const auto depth_of = [&](const Mesh& mesh, double bias, double slope_bias, int x) {
        material.pass().depth_bias = bias;
        material.pass().depth_slope_bias = slope_bias;
        return pixel(draw({.targets = {target(TargetFormat::Depth)}, .steps = {hand_step(material, mesh, {}, {}, 0)}}),
                     x, 3)
            .r;
    };
    EXPECT_EQ(depth_of(full, 8, 0, 1), 0.5f + std::ldexp(8.0f, -1 - 23));
    EXPECT_EQ(depth_of(clip_quad(-1, 1, 0.25f, 0.25f), -8, 0, 1), 0.25f - std::ldexp(8.0f, -2 - 23));
    EXPECT_EQ(depth_of(full, 0, 100, 1), 0.5f);  // it has no slope
    const float slope = 0.5f / kSize;
    for (int x : {0, 5})
        EXPECT_NEAR(depth_of(clip_quad(-1, 1, 0.75f, 0.25f), 0, 1.5, x), plane_depth(x, 0.75f, 0.25f) + 1.5f * slope,
                    1e-6f);
    // Exponents below are those of 0.75, not of each pixel.
    EXPECT_NEAR(depth_of(clip_quad(-1, 1, 0, 0.75f), 1 << 20, 0, 0), plane_depth(0, 0, 0.75f) + std::ldexp(1.0f, -4),
                1e-6f);
    EXPECT_EQ(depth_of(full, 1 << 28, 0, 1), 1);  // no further than the far plane
}

TEST_P(FrameTest, MasksByStencil) {
    HandMaterial mark = hand_material(0), paint = hand_material(1);
    mark.pass().stencil = {Compare::Always, StencilOp::Replace};
    const Mesh left = clip_quad(-1, 0);
    // The left half holds 3, the right 0.
    const auto shows = [&](Compare test, std::uint8_t reference) {
        paint.pass().stencil = {test, StencilOp::Keep};
        Frame frame{.targets = {target(TargetFormat::Rgba8), target(TargetFormat::Depth, glm::vec4(1))},
                    .steps = {hand_step(mark, left, {}, {}, 1), hand_step(paint, full, {glm::vec4(1)}, {0}, 1)}};
        frame.steps[0].stencil_reference = 3;
        frame.steps[1].stencil_reference = reference;
        const Image image = draw(frame);
        return std::pair(image.at(0, 0)[0] > 0, image.at(7, 7)[0] > 0);
    };
    EXPECT_EQ(shows(Compare::Equal, 3), std::pair(true, false));
    EXPECT_EQ(shows(Compare::Equal, 0), std::pair(false, true));
    EXPECT_EQ(shows(Compare::NotEqual, 3), std::pair(false, true));
    EXPECT_EQ(shows(Compare::Less, 2), std::pair(true, false));  // 2 < what is there
    EXPECT_EQ(shows(Compare::Greater, 2), std::pair(false, true));
    EXPECT_EQ(shows(Compare::LessEqual, 3), std::pair(true, false));
    EXPECT_EQ(shows(Compare::Always, 7), std::pair(true, true));
    EXPECT_EQ(shows(Compare::Never, 7), std::pair(false, false));
}

// Where the depth test fails, the stencil stays.
TEST_P(FrameTest, ReplacesStencilWhereBothTestsPass) {
    HandMaterial mark = hand_material(0), paint = hand_material(1);
    mark.pass().stencil = {Compare::Greater, StencilOp::Replace};
    mark.pass().depth_test = Compare::Less;
    paint.pass().stencil = {Compare::Equal, StencilOp::Keep};
    const Mesh plane = clip_quad(-1, 1, 0.25f, 0.75f);
    Frame frame{.targets = {target(TargetFormat::Rgba8), target(TargetFormat::Depth, glm::vec4(0.5f))},
                .steps = {hand_step(mark, plane, {}, {}, 1), hand_step(mark, plane, {}, {}, 1),
                          hand_step(paint, full, {glm::vec4(1)}, {0}, 1)}};
    frame.steps[0].stencil_reference = frame.steps[2].stencil_reference = 5;
    frame.steps[1].stencil_reference = 4;  // not greater than 5
    const Image image = draw(frame);
    for (int x = 0; x < kSize; x++) EXPECT_EQ(image.at(x, 2)[0], x < kSize / 2 ? 1 : 0) << x;
}

// Vulkan 1.3, "Stencil Operation": (old value & ~writeMask) | (new value & writeMask), of 8 bits.
TEST_P(FrameTest, ChangesStencilAsItsWordsSay) {
    struct Case {
        StencilOp op;
        int there, reference, write_mask, expected;
    };
    constexpr Case kCases[] = {
        {StencilOp::Keep, 7, 3, 255, 7},
        {StencilOp::Zero, 7, 3, 255, 0},
        {StencilOp::Replace, 7, 3, 255, 3},
        {StencilOp::Increment, 7, 3, 255, 8},
        {StencilOp::Increment, 255, 3, 255, 255},
        {StencilOp::Decrement, 7, 3, 255, 6},
        {StencilOp::Decrement, 0, 3, 255, 0},
        {StencilOp::Invert, 0x5a, 3, 255, 0xa5},
        {StencilOp::IncrementWrap, 7, 3, 255, 8},
        {StencilOp::IncrementWrap, 255, 3, 255, 0},
        {StencilOp::DecrementWrap, 7, 3, 255, 6},
        {StencilOp::DecrementWrap, 0, 3, 255, 255},
        {StencilOp::Replace, 0xf0, 0x35, 0x0f, 0xf5},
        {StencilOp::Invert, 0x5a, 3, 0xf0, 0xaa},
        {StencilOp::Zero, 0xff, 3, 0x81, 0x7e},
    };
    HandMaterial mark = hand_material(0), change = hand_material(0), paint = hand_material(1);
    mark.pass().stencil = {Compare::Always, StencilOp::Replace};
    paint.pass().stencil = {Compare::Equal, StencilOp::Keep};
    // Where it happens: both tests pass, the stencil's fails, or the depth's alone.
    for (const std::string when : {"pass", "fail", "depthFail"}) {
        Stencil stencil{.test = when == "fail" ? Compare::Never : Compare::Always};
        change.pass().depth_test = when == "pass" ? Compare::Always : Compare::Never;
        for (const Case& each : kCases) {
            SCOPED_TRACE(when + ": " + std::string(to_string(each.op)) + " of " + std::to_string(each.there));
            (when == "pass" ? stencil.pass : when == "fail" ? stencil.fail : stencil.depth_fail) = each.op;
            stencil.write_mask = each.write_mask;
            change.pass().stencil = stencil;
            Frame frame{.targets = {target(TargetFormat::Rgba8), target(TargetFormat::Depth, glm::vec4(1))},
                        .steps = {hand_step(mark, full, {}, {}, 1), hand_step(change, full, {}, {}, 1),
                                  hand_step(paint, full, {glm::vec4(1)}, {0}, 1)}};
            const int references[] = {each.there, each.reference, each.expected};
            for (std::size_t i = 0; i < 3; i++) frame.steps[i].stencil_reference = std::uint8_t(references[i]);
            EXPECT_EQ(pixel(draw(frame)), glm::vec4(1));
        }
    }
}

TEST_P(FrameTest, ComparesTheBitsOfTheStencilThatAreRead) {
    HandMaterial mark = hand_material(0), paint = hand_material(1);
    mark.pass().stencil = {Compare::Always, StencilOp::Replace};
    const auto shows = [&](Compare test, int reference, int mask) {
        paint.pass().stencil = {.test = test, .read_mask = mask};
        Frame frame{.targets = {target(TargetFormat::Rgba8), target(TargetFormat::Depth, glm::vec4(1))},
                    .steps = {hand_step(mark, full, {}, {}, 1), hand_step(paint, full, {glm::vec4(1)}, {0}, 1)}};
        frame.steps[0].stencil_reference = 0xa5;
        frame.steps[1].stencil_reference = std::uint8_t(reference);
        return pixel(draw(frame)) == glm::vec4(1);
    };
    EXPECT_TRUE(shows(Compare::Equal, 0x05, 0x0f));
    EXPECT_FALSE(shows(Compare::Equal, 0x05, 0xff));
    EXPECT_TRUE(shows(Compare::Less, 0x94, 0x0f));  // 4 < 5, though 0x94 < 0xa5 too
    EXPECT_FALSE(shows(Compare::Less, 0x0f, 0x0f));
    EXPECT_TRUE(shows(Compare::Equal, 0x12, 0));
}

TEST_P(FrameTest, ClearsTheStencilBeforeAStep) {
    HandMaterial mark = hand_material(0), paint = hand_material(1);
    mark.pass().stencil = {Compare::Always, StencilOp::Replace};
    mark.pass().depth_write = true;
    mark.pass().depth_test = Compare::Always;
    paint.pass().stencil = {Compare::Equal, StencilOp::Keep};
    paint.pass().depth_test = Compare::Less;  // the depth stays: 0.5 is not less than 0.25 on the left
    const Mesh left = clip_quad(-1, 0, 0.25f, 0.25f);
    Frame frame{.targets = {target(TargetFormat::Rgba8), target(TargetFormat::Depth, glm::vec4(1))},
                .steps = {hand_step(mark, left, {}, {}, 1), hand_step(paint, full, {glm::vec4(1)}, {0}, 1)}};
    frame.steps[0].stencil_reference = 4;
    frame.steps[1].clears_stencil = true;
    const Image image = draw(frame);
    EXPECT_EQ(pixel(image, 0, 0), glm::vec4(0));
    EXPECT_EQ(pixel(image, 7, 0), glm::vec4(1));
}

// --- areas and samples

TEST_P(FrameTest, KeepsToItsArea) {
    HandMaterial material = hand_material(1);
    material.pass().depth_write = true;
    // It sticks out on the right: its depth is 0.25 to 0.5 from the area's left edge to its right one.
    const Mesh wide = clip_quad(-1, 3, 0.25f, 0.75f);
    Frame frame{.targets = {target(TargetFormat::Rgba8), target(TargetFormat::Depth, glm::vec4(1))},
                .steps = {hand_step(material, wide, {glm::vec4(1)}, {0}, 1)}};
    frame.steps[0].area = {.x = 1, .y = 3, .width = 5, .height = 2};
    const auto inside = [](int x, int y) { return x >= 1 && x < 6 && y >= 3 && y < 5; };
    const Image color = draw(frame);
    frame.shown = 1;
    const Image depth = draw(frame);
    for (int y = 0; y < kSize; y++) {
        for (int x = 0; x < kSize; x++) {
            EXPECT_EQ(color.at(x, y)[0], inside(x, y) ? 1 : 0) << x << ", " << y;
            EXPECT_NEAR(depth.at(x, y)[0], inside(x, y) ? plane_depth(x - 1, 0.25f, 0.5f, 5) : 1, 1e-6f)
                << x << ", " << y;
        }
    }
}

TEST_P(FrameTest, AveragesTheSamplesOfWhatIsShown) {
    HandMaterial material = hand_material(0);
    material.pass().depth_write = true;
    const Mesh plane = clip_quad(-1, 1, 0, 1);
    const Image image = draw(
        {.targets = {target(TargetFormat::Depth)}, .steps = {hand_step(material, plane, {}, {}, 0)}, .samples = 4});
    ASSERT_EQ(image.width, 2);
    EXPECT_NEAR(image.at(0, 0)[0], 0.25f, 1e-6f);
    EXPECT_NEAR(image.at(1, 1)[0], 0.75f, 1e-6f);
}

TEST_P(FrameTest, WithoutStepsIsWhatWasCleared) {
    EXPECT_EQ(pixel(draw({.targets = {target(TargetFormat::Rgba16F, {0.5f, -2, 3, 0.25f})}}), 4, 4),
              glm::vec4(0.5f, -2, 3, 0.25f));
}

// --- mistakes

TEST_P(FrameTest, ThatDoesNotFitTogetherIsAnError) {
    struct Case {
        const char* expected;
        void (*spoil)(Frame&, HandMaterial&);
    };
    for (const Case& each : {
             Case{"0 x 8 pixels", [](Frame&f, HandMaterial&) { f.targets[0].width = 0; }},
             Case{"shows a target that it does not have", [](Frame&f, HandMaterial&) { f.shown = 2; }},
             Case{"at least one sample", [](Frame&f, HandMaterial&) { f.samples = 0; }},
             Case{"names a target", [](Frame&f, HandMaterial&) { f.steps[0].targets = {7}; }},
             Case{"names a target", [](Frame&f, HandMaterial&) { f.steps[0].reads[0].target = 7; }},
             Case{"writes 1 targets and is given 0", [](Frame&f, HandMaterial&) { f.steps[0].targets = {}; }},
             Case{"differ in size", [](Frame&f, HandMaterial&) { f.targets[1].height = 9; }},
             Case{"takes 'a depth' for a colour", [](Frame&f, HandMaterial&) { f.steps[0].targets = {1}; }},
             Case{"takes 'a rgba8' for depth", [](Frame&f, HandMaterial&) { f.steps[0].depth = 0; }},
             Case{"not inside 'a rgba8'",
                  [](Frame&f, HandMaterial&) {
                      f.steps[0].area = {1, 0, 8, 8};
                  }},
             Case{"the block 'Colors' is not filled", [](Frame&f, HandMaterial&) { f.steps[0].blocks.clear(); }},
             Case{"the texture 'earlier' is not loaded", [](Frame&f, HandMaterial&) { f.steps[0].reads.clear(); }},
             Case{"no texture 'later'",
                  [](Frame&f, HandMaterial&) {
                      f.steps[0].reads.push_back({"later", 0});
                  }},
             Case{"has no targets to draw into",
                  [](Frame&f, HandMaterial&m) {
                      m.pass().targets.clear();
                      f.steps[0].targets.clear();
                      f.steps[0].depth = -1;
                  }},
             Case{"'a rgba8' twice",
                  [](Frame&f, HandMaterial&m) {
                      m.pass().targets.resize(2);
                      f.steps[0].targets = {0, 0};
                  }},
         }) {
        HandMaterial material = hand_material(1, true);
        Frame frame{.targets = {target(TargetFormat::Rgba8), target(TargetFormat::Depth)},
                    .steps = {hand_step(material, full, {glm::vec4(1)}, {0}, 1)}};
        frame.steps[0].reads = {{.texture = "earlier", .target = 0}};
        each.spoil(frame, material);
        const auto image = try_draw(frame, GetParam());
        ASSERT_FALSE(image) << each.expected;
        EXPECT_NE(image.error.find(each.expected), std::string::npos) << image.error;
    }
}

// --- the two against each other

// A ball into three targets and depth, then what is there brightened through blending where the stencil says so.
TEST_F(Frames, AreTheSameOnBoth) {
    HandMaterial ball = hand_material(3), light = hand_material(1, true);
    ball.pass().cull = Cull::Back;
    ball.pass().depth_test = Compare::Less;
    ball.pass().depth_write = true;
    ball.pass().stencil = {Compare::Always, StencilOp::Replace};
    light.pass().stencil = {Compare::Equal, StencilOp::Keep};
    light.pass().targets[0].blend.source = BlendFactor::SourceAlpha;
    light.pass().targets[0].blend.destination = BlendFactor::One;
    Mesh sphere = make_sphere(0.8f, 24, 12);
    for (Vertex& vertex : sphere.vertices) vertex.position.z = 0.5f - 0.5f * vertex.position.z;  // nearer is less
    constexpr int kLarge = 33;
    Frame frame{
        .targets = {target(TargetFormat::Rgba16F, glm::vec4(0.125f), kLarge), target(TargetFormat::Rgb10A2, {}, kLarge),
                    target(TargetFormat::Rgba8, {}, kLarge), target(TargetFormat::Depth, glm::vec4(1), kLarge)},
        .steps = {hand_step(ball, sphere, {{1, 0.5f, 0.25f, 0.5f}, glm::vec4(0.3f), glm::vec4(0.7f)}, {0, 1, 2}, 3),
                  hand_step(light, full, {{0.25f, 0.5f, 1, 0.5f}}, {0}, 3),
                  hand_step(light, full, {{0.25f, 0.5f, 1, 0.5f}}, {0}, 3)}};
    for (FrameStep& step : frame.steps) step.stencil_reference = 1;
    frame.steps[1].reads = {{.texture = "earlier", .target = 3}};
    frame.steps[2].reads = {{.texture = "earlier", .target = 2}};
    for (frame.shown = 0; frame.shown < 4; frame.shown++) {
        const Image gpu = draw(frame, true), cpu = draw(frame, false);
        float largest = 0;
        for (std::size_t i = 0; i < gpu.pixels.size(); i++)
            largest = std::max(largest, std::abs(gpu.pixels[i] - cpu.pixels[i]));
        // Halves may be rounded either way, twice: numbers are below 4.
        EXPECT_LE(largest, frame.shown == 0 ? 2 * std::ldexp(1.0f, 1 - 10) : 1e-6f) << frame.targets[frame.shown].name;
        EXPECT_NE(pixel(gpu, kLarge / 2, kLarge / 2), pixel(gpu, 0, 0));
    }
}

}  // namespace
}  // namespace patina::runtime
