// Texels of arrays and of 3D textures. Every expected number is worked out by hand from Vulkan's "Texel Input
// Operations".
#include "compiler/interpret/texels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace patina::interpret {
namespace {

// Red is 100 for each layer, 10 for each row and 1 for each column.
TextureData counted(int size, int layers, bool is_volume) {
    TextureLevel level{.width = size, .height = size, .texels = {}, .depth = is_volume ? layers : 1};
    for (int layer = 0; layer < layers; ++layer) {
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const float red = static_cast<float>(100 * layer + 10 * y + x);
                level.texels.insert(level.texels.end(), {red, 0, 0, 1});
            }
        }
    }
    return {.levels = {level}, .sampler = {}, .layers = is_volume ? 1 : layers};
}

TEST(Texels, OfALayerAreNotMixedWithOtherLayers) {
    const TextureData data = counted(2, 3, false);
    const Reader linear{.texture = data, .wrap = Wrap::Clamp};
    EXPECT_EQ(in_layer(linear, 0.25, 0.25, 0, 2)[0], 200);
    EXPECT_EQ(in_layer(linear, 0.5, 0.5, 0, 1)[0], 100 + (0 + 1 + 10 + 11) / 4.0);
    const Reader nearest{.texture = data, .wrap = Wrap::Clamp, .is_linear = false};
    EXPECT_EQ(in_layer(nearest, 0.6, 0.6, 0, 1)[0], 111);
}

TEST(Texels, OfAVolumeAreMixedBetweenLayers) {
    const TextureData data = counted(2, 4, true);
    const Reader clamped{.texture = data, .wrap = Wrap::Clamp};
    EXPECT_EQ(in_volume(clamped, {0.25, 0.25, 0.125}, 0)[0], 0);    // the middle of the first layer
    EXPECT_EQ(in_volume(clamped, {0.25, 0.25, 0.5}, 0)[0], 150);    // between the second and the third
    EXPECT_EQ(in_volume(clamped, {0.75, 0.25, 0.3125}, 0)[0], 76);  // three quarters from the first to the second
    EXPECT_EQ(in_volume(clamped, {0.25, 0.25, 1.5}, 0)[0], 300);
    const Reader repeated{.texture = data, .wrap = Wrap::Repeat};
    EXPECT_EQ(in_volume(repeated, {0.25, 0.25, 0}, 0)[0], 150);  // half of the first and half of the last
    EXPECT_EQ(in_volume(repeated, {0.25, 0.25, 1.125}, 0)[0], 0);
    const Reader nearest{.texture = data, .wrap = Wrap::Clamp, .is_linear = false};
    EXPECT_EQ(in_volume(nearest, {0.25, 0.75, 0.51}, 0)[0], 210);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(in_volume(nearest, {0.25, 0.25, nan}, 0)[0], 0);
}

// A step of one texel is level 0, of two level 1; in depth as in the other directions.
TEST(Texels, LevelsOfAVolumeCountItsDepth) {
    const TextureData data = counted(4, 8, true);
    const Reader reader{.texture = data};
    EXPECT_DOUBLE_EQ(volume_level(reader, {0.25, 0, 0}, {0, 0, 0}), 0);
    EXPECT_DOUBLE_EQ(volume_level(reader, {0, 0, 0.25}, {0, 0, 0}), 1);
    EXPECT_DOUBLE_EQ(volume_level(reader, {0.25, 0, 0}, {0, 0.5, 0.25}), std::log2(std::hypot(2, 2)));
}

}  // namespace
}  // namespace patina::interpret
