// Texture coordinates as a map to draw into, and what fills the texels between the charts. Shares of overlap are those
// of rectangles; the nearest texels are found again by looking at all of them.
#include "runtime/bake/uv_layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "runtime/bake/padding.h"

namespace patina::runtime {
namespace {

// A rectangle of the texture, of two triangles that share the diagonal. `turned`: against the clock in the texture.
void add_rectangle(Mesh& mesh, glm::vec2 low, glm::vec2 high, bool turned = false) {
    const auto first = std::uint32_t(mesh.vertices.size());
    for (const glm::vec2 uv : {low, glm::vec2(high.x, low.y), high, glm::vec2(low.x, high.y)})
        mesh.vertices.push_back({.position = {uv, 0}, .normal = {0, 0, 1}, .tangent = {1, 0, 0, 1}, .uv0 = uv});
    for (const std::uint32_t corner : {0, turned ? 2 : 1, turned ? 1 : 2, 0, turned ? 3 : 2, turned ? 2 : 3})
        mesh.indices.push_back(first + corner);
}

Mesh rectangles(std::initializer_list<std::array<glm::vec2, 2>> all) {
    Mesh mesh;
    for (const auto& [low, high] : all) add_rectangle(mesh, low, high);
    return mesh;
}

std::string error_of(const Mesh& mesh) {
    return uv_layout(mesh, 64).error;
}

TEST(UvLayout, TrianglesThatShareAnEdgeDoNotOverlap) {
    const Outcome<UvLayout> whole = uv_layout(rectangles({{{{0, 0}, {1, 1}}}}), 64);
    ASSERT_TRUE(whole) << whole.error;
    EXPECT_EQ(whole.value.overlap, 0);
    // The built-in meshes: many small triangles, of which each texel has one.
    for (const Mesh& mesh : {make_sphere(), make_plane(), make_torus()}) {
        const Outcome<UvLayout> layout = uv_layout(mesh, 256);
        ASSERT_TRUE(layout) << layout.error;
        EXPECT_EQ(layout.value.overlap, 0);
    }
}

// Together they cover three quarters of the texture, and a quarter of it twice.
TEST(UvLayout, OverlapIsAShareOfWhatIsCovered) {
    const Outcome<UvLayout> layout = uv_layout(rectangles({{{{0, 0}, {0.5f, 1}}}, {{{0.25f, 0}, {0.75f, 1}}}}), 64);
    ASSERT_TRUE(layout) << layout.error;
    EXPECT_DOUBLE_EQ(layout.value.overlap, 1.0 / 3);
}

TEST(UvLayout, MirroredChartsTurnLikeTheOthers) {
    Mesh mesh;
    add_rectangle(mesh, {0, 0}, {0.5f, 1});
    add_rectangle(mesh, {0.5f, 0}, {1, 1}, true);
    mesh.indices.insert(mesh.indices.end(), {0, 1, 1});  // without area
    const Outcome<UvLayout> layout = uv_layout(mesh, 64);
    ASSERT_TRUE(layout) << layout.error;
    const Mesh& made = layout.value.mesh;
    ASSERT_EQ(made.indices.size(), 12u);
    for (std::size_t i = 0; i < made.indices.size(); i += 3) {
        const auto uv = [&](std::size_t corner) { return made.vertices[made.indices[i + corner]].uv0; };
        const glm::vec2 u = uv(1) - uv(0), v = uv(2) - uv(0);
        EXPECT_LT(u.x * v.y - u.y * v.x, 0) << i;  // against the clock, as v grows downwards
    }
}

TEST(UvLayout, SaysWhatIsWrong) {
    Mesh none = rectangles({{{{0, 0}, {1, 1}}}});
    for (Vertex& vertex : none.vertices) vertex.uv0 = {0, 0};
    EXPECT_NE(error_of(none).find("no texture coordinates"), std::string::npos) << error_of(none);
    const std::string outside = error_of(rectangles({{{{-0.5f, 0}, {2, 1}}}}));
    EXPECT_NE(outside.find("from -0.5, 0 to 2, 1"), std::string::npos) << outside;
    Mesh endless = rectangles({{{{0, 0}, {1, 1}}}});
    endless.vertices[2].uv0.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(error_of(endless).find("finite"), std::string::npos) << error_of(endless);
    // The border itself belongs to the square, up to rounding.
    EXPECT_EQ(error_of(rectangles({{{{-1e-5f, 0}, {1.00001f, 1}}}})), "");
}

TEST(Padding, TakesTheNearestTexel) {
    constexpr int kWidth = 37, kHeight = 23;
    std::mt19937 random(7);
    for (const unsigned rarity : {2u, 20u, 400u}) {
        std::vector<std::uint8_t> covered(std::size_t(kWidth * kHeight));
        for (std::uint8_t& each : covered) each = random() % rarity == 0;
        covered[5] = 1;
        const std::vector<std::uint32_t> from = nearest_covered(covered, kWidth, kHeight);
        ASSERT_EQ(from.size(), covered.size());
        const auto distance = [](std::size_t a, std::size_t b) {
            return std::hypot(double(a % kWidth) - double(b % kWidth), double(a / kWidth) - double(b / kWidth));
        };
        for (std::size_t i = 0; i < from.size(); i++) {
            double nearest = std::numeric_limits<double>::max();
            for (std::size_t k = 0; k < covered.size(); k++)
                if (covered[k]) nearest = std::min(nearest, distance(i, k));
            ASSERT_TRUE(covered[from[i]]) << i;
            // Danielsson's bound for this method: less than 0.29 of a texel too far.
            EXPECT_LE(distance(i, from[i]), nearest + 0.29) << i;
        }
    }
}

TEST(Padding, LeavesWhatIsCovered) {
    Image image = make_image(3, 1);
    image.pixels = {1, 2, 3, 4, 0, 0, 0, 0, 5, 6, 7, 8};
    fill(image, {0, 2, 2});
    EXPECT_EQ(image.pixels, (std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8, 5, 6, 7, 8}));
}

}  // namespace
}  // namespace patina::runtime
