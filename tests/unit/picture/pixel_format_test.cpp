// What the formats of render targets keep of a number.
#include "runtime/frame/pixel_format.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace patina::runtime {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(HalfBits, EveryHalfIsItself) {
    for (std::uint32_t bits = 0; bits < 0x10000; bits++) {
        const float value = half_value(std::uint16_t(bits));
        if (std::isnan(value))
            EXPECT_TRUE(std::isnan(half_value(half_bits(value))));
        else
            EXPECT_EQ(half_bits(value), bits);
    }
}

// IEEE 754-2008, 3.6: 5 bits of exponent biased by 15, 10 of fraction.
TEST(HalfBits, AreThoseOfTheStandard) {
    EXPECT_EQ(half_bits(1), 0x3c00);
    EXPECT_EQ(half_bits(-2), 0xc000);
    EXPECT_EQ(half_bits(65504), 0x7bff);
    EXPECT_EQ(half_bits(std::ldexp(1.0f, -14)), 0x0400);
    EXPECT_EQ(half_bits(std::ldexp(1.0f, -24)), 0x0001);
    EXPECT_EQ(half_bits(-0.0f), 0x8000);
    EXPECT_EQ(half_bits(kInfinity), 0x7c00);
    EXPECT_TRUE(std::isnan(half_value(half_bits(std::nanf("")))));
}

TEST(HalfBits, RoundToTheNearestAndTiesToEven) {
    const float step = 1 / 1024.0f;
    const auto rounded = [](float value) { return half_value(half_bits(value)); };
    EXPECT_EQ(rounded(1 + 0.5f * step), 1);
    EXPECT_EQ(rounded(1 + 1.5f * step), 1 + 2 * step);
    EXPECT_EQ(rounded(1 + 0.51f * step), 1 + step);
    EXPECT_EQ(rounded(-1 - 0.49f * step), -1);
    EXPECT_EQ(rounded(2 - 0.25f * step), 2);  // into the next exponent
    EXPECT_EQ(rounded(std::ldexp(0.5f, -24)), 0);
    EXPECT_EQ(rounded(std::ldexp(1.5f, -24)), std::ldexp(2.0f, -24));
    EXPECT_EQ(rounded(std::ldexp(1023.75f, -24)), std::ldexp(1.0f, -14));  // out of the subnormal numbers
    EXPECT_EQ(rounded(65519), 65504);
    EXPECT_EQ(rounded(65520), kInfinity);
    EXPECT_EQ(rounded(-1e30f), -kInfinity);
}

TEST(PixelFormat, LaysOutItsBytesAsVulkanDoes) {
    const auto bytes = [](TargetFormat format, const glm::vec4& value) {
        std::array<std::byte, 16> pixel{};
        pixel_format(format).store(value, pixel.data());
        std::array<int, 8> result{};
        for (std::size_t i = 0; i < result.size(); i++) result[i] = int(pixel[i]);
        return result;
    };
    EXPECT_EQ(bytes(TargetFormat::Rgba8, {0, 1 / 255.0f, 0.5f, 1}), (std::array{0, 1, 128, 255, 0, 0, 0, 0}));
    // 1 | 2 << 10 | 3 << 20 | 2 << 30, the lowest byte first.
    EXPECT_EQ(bytes(TargetFormat::Rgb10A2, {1 / 1023.0f, 2 / 1023.0f, 3 / 1023.0f, 2 / 3.0f}),
              (std::array{0x01, 0x08, 0x30, 0x80, 0, 0, 0, 0}));
    EXPECT_EQ(bytes(TargetFormat::Rgba16F, {1, -2, 0, 0.5f}), (std::array{0, 0x3c, 0, 0xc0, 0, 0, 0, 0x38}));
    EXPECT_EQ(bytes(TargetFormat::R32F, {1, 2, 3, 4}), (std::array{0, 0, 0x80, 0x3f, 0, 0, 0, 0}));
    EXPECT_EQ(bytes(TargetFormat::Rgba8, glm::vec4(std::nanf(""))), (std::array{0, 0, 0, 0, 0, 0, 0, 0}));
    // 0.7 as a float is just below 178.5 / 255.
    EXPECT_EQ(bytes(TargetFormat::Rgba8, glm::vec4(0.7f))[0], 178);
}

}  // namespace
}  // namespace patina::runtime
