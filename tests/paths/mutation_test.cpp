// The comparisons of paths can fail: a pass file with one thing wrong in it makes another picture. A user's file takes
// the place of the library's.
#include <fstream>
#include <sstream>

#include "paths/drawing.h"

namespace patina::paths {
namespace {

struct Mistake {
    const char* name;
    const char* file;  // of the library: the path whose passes have it
    const char* path;  // that is drawn
    const char* right;
    const char* wrong;
};
void PrintTo(const Mistake& mistake, std::ostream* out) {
    *out << mistake.name;
}

std::string library_text(const std::string& path) {
    std::ifstream file("nodes/passes/" + path + ".pass.hlsl");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, AreSeen) {
    const Mistake& mistake = GetParam();
    World world = proof_world(128, 96);
    world.pixel_light_count = 16;
    const Image forward = draw(world, {.path = "forward", .exact_targets = true});
    const std::string text = library_text(mistake.file);
    // As it is, copied: the right picture.
    const std::string copy = written(std::string(mistake.path) + ".pass.hlsl", text);
    EXPECT_SAME_PICTURE(forward, draw(world, {.path = copy, .exact_targets = true}));

    const std::size_t place = text.find(mistake.right);
    ASSERT_NE(place, text.npos) << mistake.right;
    std::string changed = text;
    changed.replace(place, std::string(mistake.right).size(), mistake.wrong);
    written(std::string(mistake.path) + ".pass.hlsl", changed);
    const Image other = draw(world, {.path = copy, .exact_targets = true});
    EXPECT_GT(difference(forward, other).largest, 2 * kStep) << "nobody would have seen it";
}

INSTANTIATE_TEST_SUITE_P(
    Of, Mistakes,
    testing::Values(
        Mistake{"LightsReplaceEachOther", "forward-add", "forward-add", R"([blend("opaque", "one", "one")])",
                R"([blend("opaque", "one", "zero")])"},
        Mistake{"AddedPassIsHidden", "forward-add", "forward-add", R"([depth("lessEqual", "keep")])",
                R"([depth("less", "keep")])"},
        Mistake{"AddedPassTakesAllLights", "forward-add", "forward-add", R"([each("light")] [lights("further")])",
                R"([each("light")] [lights("all")])"},
        Mistake{"BaseHasNoMainLight", "forward-add", "forward-add", R"([lights("main")])", R"([lights("none")])"},
        Mistake{"OneModelLightsAll", "deferred", "deferred",
                R"([stencil("equal", "keep", "lighting")] [blend("one", "one")])",
                R"([stencil("always", "keep", "lighting")] [blend("one", "one")])"},
        Mistake{"NormalIsNotDecoded", "deferred", "deferred", "DecodeGBufferNormal(gbuffer_normal_texture",
                "normalize(gbuffer_normal_texture"},
        Mistake{"SmoothnessAsRoughness", "deferred", "deferred", "lit.roughness = 1 - specular.a",
                "lit.roughness = specular.a"},
        Mistake{"LightsReplaceTheGBuffersLight", "deferred", "deferred", R"([blend("one", "one")])",
                R"([blend("one", "zero")])"},
        Mistake{"FrontsOfVolumes", "deferred", "deferred", R"([cull("front")] [depth("greaterEqual", "keep")])",
                R"([cull("front")] [depth("lessEqual", "keep")])"},
        Mistake{"PositionOfAnotherPixel", "deferred", "deferred", "WorldFromDepth(uv,", "WorldFromDepth(uv + 0.004,"},
        Mistake{"ReflectionsTwice", "deferred", "deferred", "{ start.indirect = not_reflected(lit); }",
                "{ start.indirect = indirect(lit); }"},
        Mistake{"OcclusionIsForgotten", "deferred", "deferred", "lit.occlusion = diffuse.a", "lit.occlusion = 0"}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace patina::paths
