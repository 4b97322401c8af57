// Every path through GLSL, through HLSL and on the CPU: three ways to the same small picture.
#include "paths/drawing/drawing.h"
#include "runtime/picture/compare.h"

namespace patina::paths {
namespace {

// At an outline, and at a hard step of a material, the three may fall to different sides: of so few pixels a handful.
void expect_alike(const Image& expected, const Image& image, const std::string& via) {
    const runtime::Comparison difference = runtime::compare(expected, image, 3.01 / 255);
    EXPECT_TRUE(difference.same_size);
    EXPECT_LE(difference.share, 0.01) << via << ", the worst at " << difference.worst_x << ", " << difference.worst_y;
    EXPECT_LE(difference.average, 0.001) << via;
}

class Witnesses : public testing::TestWithParam<const char*> {};

TEST_P(Witnesses, DrawTheSame) {
    World world = proof_world(32, 24);
    world.pixel_light_count = 3;  // so that some are vertex lights and some harmonics
    RenderOptions options{.path = GetParam(), .exact_textures = true, .exact_targets = true, .shadow_atlas_size = 256};
    const Image glsl = draw(world, options);
    for (const char* via : {"hlsl", "cpu"}) {
        options.via = via;
        expect_alike(glsl, draw(world, options), via);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Witnesses,
                         testing::Values("forward", "forward-add", "forward-directional", "vertex", "deferred",
                                         "deferred-extended", "deferred-ldr", "depth-normals"),
                         [](const auto& info) {
                             std::string name = info.param;
                             std::erase(name, '-');
                             return name;
                         });

}  // namespace
}  // namespace patina::paths
