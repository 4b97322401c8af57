#include "tests/textures/drawn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace patina::runtime {

std::string png_of(const std::string& name, int width, int height, const std::vector<std::array<float, 4>>& texels) {
    const std::string path = testing::TempDir() + name + ".png";
    Image image = make_image(width, height);
    for (std::size_t i = 0; i < texels.size(); ++i)
        std::copy(texels[i].begin(), texels[i].end(), image.pixels.begin() + static_cast<std::ptrdiff_t>(4 * i));
    EXPECT_EQ(save_png_as_is(path, image), "");
    return path;
}

Image drawn(const std::string& via, const std::string& name, const std::string& graph,
            const std::map<std::string, std::string>& files) {
    static const Compiler compiler;
    static RenderMachine machine;
    const std::string path = testing::TempDir() + name + ".graph.json";
    std::ofstream(path) << R"({ "patina": 1, "workflow": "unlit", )" << graph << " }";
    RenderRequest request{.graph = path, .mesh = "plane", .size = kSide, .samples = 1, .overrides = files};
    // Straight at the plane: 2 units high at distance 2 is a field of view of 2 atan(1/2).
    request.camera = "position=0,0,2 target=0,0,0 fov=53.13010235415598";
    request.options.via = via;
    request.options.validation = true;
    request.options.exact_textures = true;
    const RenderOutcome outcome = render(compiler, request, machine);
    for (const Diagnostic& each : outcome.diagnostics) ADD_FAILURE() << to_text(each);
    EXPECT_TRUE(outcome.ok) << outcome.error;
    return outcome.ok ? outcome.image : make_image(kSide, kSide, -1, -1, -1);
}

void expect_at(const Image& picture, int right, int down, std::array<double, 3> expected, const std::string& what) {
    const auto pixel = picture.at(kSide / 4 + right * kSide / 2, kSide / 4 + down * kSide / 2);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(pixel[i], expected[i], 1e-5) << what << ", channel " << i;
}

}  // namespace patina::runtime
