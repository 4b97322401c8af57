// Which known word an unknown one means, and numbers as text: these are what std::to_chars and std::from_chars make of
// them, though the compiler does without both.
#include "compiler/base/text.h"

#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "compiler/base/bits.h"

namespace patina {
namespace {

template <class T, class... Format>
std::string by_standard_library(T value, Format... format) {
    char buffer[512];
    const auto result = std::to_chars(std::begin(buffer), std::end(buffer), value, format...);
    return {buffer, result.ptr};
}

template <class T>
void expect_same_text(T value) {
    for (const T each : {value, -value, T(1) / value, std::nextafter(value, T(1e30)), std::nextafter(value, T(0))}) {
        ASSERT_EQ(shortest(each), by_standard_library(each));
    }
}

template <class T, class Bits>
void check_random_values(int count) {
    std::mt19937_64 random(1);
    for (int i = 0; i < count; ++i) {
        const T value = bits_as<T>(static_cast<Bits>(random()));
        if (std::isfinite(value)) expect_same_text(value);
    }
}

// Those that people write, and whole numbers around the places where a form becomes the shorter one.
template <class T>
void check_written_values() {
    for (int exponent = std::numeric_limits<T>::min_exponent10; exponent <= std::numeric_limits<T>::max_exponent10;
         ++exponent) {
        for (const char* digits : {"1", "1.5", "9.99", "1.2345", "1.2345678", "7.0000001", "9.87654321012345"}) {
            const double written = std::strtod((digits + ("e" + std::to_string(exponent))).c_str(), nullptr);
            expect_same_text(static_cast<T>(written));
        }
    }
    for (int shift = 0; shift < 120; ++shift) expect_same_text(static_cast<T>(std::ldexp(1, shift)));
    for (int n = 1; n < 20000; ++n) {
        expect_same_text(static_cast<T>(n));
        expect_same_text(static_cast<T>(n * 0.001));
        expect_same_text(static_cast<T>(n * 12345.0));
    }
}

TEST(Shortest, IsWhatToCharsWrites) {
    check_written_values<double>();
    check_written_values<float>();
    check_random_values<double, std::uint64_t>(300000);
    check_random_values<float, std::uint32_t>(300000);
    for (const double special : {0.0, -0.0, double(NAN), -double(NAN), double(INFINITY), -double(INFINITY)}) {
        EXPECT_EQ(shortest(special), by_standard_library(special));
        EXPECT_EQ(shortest(float(special)), by_standard_library(float(special)));
    }
}

TEST(ShortestDecimals, IsWhatToCharsWritesWithoutExponents) {
    std::mt19937 random(2);
    for (int i = 0; i < 300000; ++i) {
        const auto value = bits_as<float>(static_cast<std::uint32_t>(random()));
        if (!std::isfinite(value)) continue;
        ASSERT_EQ(shortest_decimals(value), by_standard_library(value, std::chars_format::fixed));
    }
    for (const float value : {0.f, -0.f, 0.005f, 0.00001f, 1e10f, 16777216.f, 0.1f}) {
        EXPECT_EQ(shortest_decimals(value), by_standard_library(value, std::chars_format::fixed));
    }
}

TEST(ReadNumber, ReadsBackWhatShortestWrites) {
    std::mt19937_64 random(3);
    for (int i = 0; i < 100000; ++i) {
        const auto value = bits_as<double>(static_cast<std::uint64_t>(random()));
        if (!std::isfinite(value)) continue;
        ASSERT_EQ(read_number(shortest(value)), value);
    }
}

TEST(ReadNumber, TakesNothingElse) {
    for (const char* text : {"", "x", "1x", "0x10", " 1", "+1", "1e", "1.5.2", "--1", "e5"}) {
        EXPECT_FALSE(read_number(text)) << text;
    }
    EXPECT_EQ(read_number(".5"), 0.5);
    EXPECT_EQ(read_number("5."), 5);
    EXPECT_EQ(read_number("0e999"), 0);
    EXPECT_EQ(read_number("1e999"), INFINITY);
    EXPECT_EQ(read_number("1e-999"), INFINITY);
}

using namespace std::string_view_literals;

TEST(Nearest, FindsAWordByFewLetters) {
    constexpr std::array kWords = {"roughness"sv, "metallic"sv, "normalWS"sv};
    EXPECT_EQ(nearest("roughnes", kWords), "roughness");
    EXPECT_EQ(nearest("mettalic", kWords), "metallic");
    EXPECT_EQ(nearest("colour", kWords), "");
}

TEST(Nearest, UnderscoresAndCaseMakeNoDifference) {
    constexpr std::array kWords = {"normalOS"sv, "normalWS"sv, "nearPlane"sv, "isLit"sv, "perObject"sv};
    EXPECT_EQ(nearest("normal_ws", kWords), "normalWS");
    EXPECT_EQ(nearest("normal_os", kWords), "normalOS");
    EXPECT_EQ(nearest("near_plane", kWords), "nearPlane");
    EXPECT_EQ(nearest("is_lit", kWords), "isLit");
    EXPECT_EQ(nearest("PER_OBJECT", kWords), "perObject");
}

// Each underscore would count as a letter that is wrong.
TEST(Nearest, AnOldSpellingWithAMistakeIsFound) {
    constexpr std::array kWords = {"ambientOrLightmapUV"sv, "oneMinusSrcAlpha"sv, "normalWS"sv};
    EXPECT_EQ(nearest("one_minus_src_aplha", kWords), "oneMinusSrcAlpha");
    EXPECT_EQ(nearest("norml_ws", kWords), "normalWS");
}

TEST(Nearest, AWordThatDiffersByUnderscoresOnlyIsPreferred) {
    constexpr std::array kWords = {"light_ax"sv, "lightAxis"sv, "_Tint"sv, "Tint2"sv};
    EXPECT_EQ(nearest("light_axis", kWords), "lightAxis");
    EXPECT_EQ(nearest("Tint", kWords), "_Tint");
}

}  // namespace
}  // namespace patina
