// The comparisons of paths can fail: a pass file with one thing wrong in it makes another picture. A user's file takes
// the place of the library's.
#include <fstream>
#include <sstream>

#include "paths/drawing/drawing.h"

namespace patina::paths {
namespace {

struct Mistake {
    const char* name;
    const char* path;
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

World scene() {
    return proof_scene_and_metals(96, 72);
}

Image draw_with(const std::string& path, const std::string& text) {
    return draw(scene(), {.path = written(path + ".pass.hlsl", text), .exact_targets = true});
}

const Image& forward() {
    static const Image kForward = draw(scene(), {.path = "forward", .exact_targets = true});
    return kForward;
}

// As it is, copied: the right picture.
TEST(Copies, AreRight) {
    for (const char* path : {"forward-add", "deferred"})
        EXPECT_SAME_PICTURE(forward(), draw_with(path, library_text(path)));
}

class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, AreSeen) {
    const Mistake& mistake = GetParam();
    std::string text = library_text(mistake.path);
    const std::size_t place = text.find(mistake.right);
    ASSERT_NE(place, text.npos) << mistake.right;
    text.replace(place, std::string(mistake.right).size(), mistake.wrong);
    EXPECT_GT(difference(forward(), draw_with(mistake.path, text)).largest, 2 * kStep) << "nobody would have seen it";
}

INSTANTIATE_TEST_SUITE_P(
    Of, Mistakes,
    testing::Values(
        Mistake{"LightsReplaceEachOther", "forward-add", R"([blend("opaque", "one", "one", "zero", "one")])",
                R"([blend("opaque", "one", "zero")])"},
        Mistake{"AddedPassIsHidden", "forward-add", R"([depth("lessEqual", "keep")])", R"([depth("less", "keep")])"},
        Mistake{"AddedPassTakesAllLights", "forward-add", R"([each("light")] [lights("further")])",
                R"([each("light")] [lights("all")])"},
        Mistake{"BaseHasNoMainLight", "forward-add", R"([lights("main")])", R"([lights("none")])"},
        Mistake{"OneModelLightsAll", "deferred", R"([stencil("equal", "keep", "lighting")] [blend("one", "one")])",
                R"([stencil("always", "keep", "lighting")] [blend("one", "one")])"},
        Mistake{"NormalIsNotDecoded", "deferred", "DecodeGBufferNormal(gbufferNormalTexture",
                "normalize(gbufferNormalTexture"},
        Mistake{"SmoothnessAsRoughness", "deferred", "lit.roughness = 1 - specular.a", "lit.roughness = specular.a"},
        Mistake{"LightsReplaceTheGBuffersLight", "deferred", R"([blend("one", "one")])", R"([blend("one", "zero")])"},
        Mistake{"FrontsOfVolumes", "deferred", R"([cull("front")] [depth("greaterEqual", "keep")])",
                R"([cull("front")] [depth("lessEqual", "keep")])"},
        Mistake{"PositionOfAnotherPixel", "deferred", "WorldFromDepth(uv,", "WorldFromDepth(uv + 0.004,"},
        Mistake{"ReflectionsTwice", "deferred", "{ start.indirect = notReflected(lit); }",
                "{ start.indirect = indirect(lit); }"},
        Mistake{"OcclusionIsForgotten", "deferred", "lit.occlusion = diffuse.a", "lit.occlusion = 0"}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace patina::paths
