// Layers out of one picture, and their mip levels. Colours are worked out by hand.
#include "runtime/values/texture_layers.h"

#include <gtest/gtest.h>

#include "runtime/picture/mip_chain.h"

namespace patina::runtime {
namespace {

// Red counts the pixels by rows.
Image counted(int width, int height) {
    Image image = make_image(width, height);
    for (int i = 0; i < width * height; i++) image.pixels[4 * std::size_t(i)] = float(i);
    return image;
}

TEST(TextureLayers, GridsAreReadByRows) {
    const auto layers = grid_layers(counted(6, 4), {3, 2}, "a.png");
    ASSERT_TRUE(layers) << layers.error;
    ASSERT_EQ(layers.value.size(), 6u);
    EXPECT_EQ(layers.value[0].at(0, 0)[0], 0);
    EXPECT_EQ(layers.value[1].at(1, 1)[0], 9);  // row 1, column 3
    EXPECT_EQ(layers.value[5].at(0, 0)[0], 16);
    EXPECT_EQ(layers.value[5].at(1, 1)[0], 23);
}

TEST(TextureLayers, RefusesGridsThatDoNotFit) {
    EXPECT_EQ(grid_layers(counted(6, 4), {4, 2}, "a.png").error,
              "'a.png' has 6 x 4 pixels, which the grid [4, 2] does not divide into equal layers");
    EXPECT_EQ(grid_layers(make_image(64, 64), {64, 64}, "a.png").error,
              "the grid [64, 64] of 'a.png' has 4096 layers; a texture may have 2048");
    EXPECT_EQ(cube_faces(counted(5, 3), "a.png").error.find("'a.png' does not show all directions"), 0u);
}

// A strip of faces: right, left, up, down, ahead (-z), behind (+z), each as it is seen from the middle.
TEST(TextureLayers, FacesOfACubeAreThoseOfTheWorld) {
    const auto faces = cube_faces(counted(6, 1), "a.png");
    ASSERT_TRUE(faces) << faces.error;
    const float expected[] = {0, 1, 2, 3, 5, 4};  // +X, -X, +Y, -Y, +Z, -Z
    for (std::size_t face = 0; face < 6; face++) EXPECT_EQ(faces.value[face].at(0, 0)[0], expected[face]) << face;
}

TEST(TextureLayers, LevelsOfAVolumeHaveFewerLayers) {
    const std::vector<Image> layers(5, counted(4, 2));
    const std::vector<TextureLevel> levels = volume_mip_chain(layers);
    ASSERT_EQ(levels.size(), 3u);
    EXPECT_EQ(levels[0].depth, 5);
    EXPECT_EQ(levels[1].depth, 2);
    EXPECT_EQ(levels[2].depth, 1);
    EXPECT_EQ(levels[1].texels.size(), 4u * 2 * 1 * 2);
    EXPECT_EQ(levels[1].texels[0], (0 + 1 + 4 + 5) / 4.0f);
    // Two layers that differ: their mean.
    const std::vector<Image> two = {make_image(1, 1, 0, 0, 0), make_image(1, 1, 1, 1, 1)};
    EXPECT_EQ(volume_mip_chain(two).back().texels[0], 0.5f);
}

TEST(TextureLayers, LevelsOfAnArrayKeepLayersApart) {
    const std::vector<Image> two = {make_image(2, 2, 0, 0, 0), make_image(2, 2, 1, 1, 1)};
    const std::vector<TextureLevel> levels = mip_chain(two);
    ASSERT_EQ(levels.size(), 2u);
    EXPECT_EQ(levels[1].texels, (std::vector<float>{0, 0, 0, 1, 1, 1, 1, 1}));
}

}  // namespace
}  // namespace patina::runtime
