// Which known word an unknown one means.
#include "compiler/base/text.h"

#include <gtest/gtest.h>

#include <array>

namespace patina {
namespace {

using namespace std::string_view_literals;

TEST(Nearest, FindsAWordByFewLetters) {
    constexpr std::array kWords = {"roughness"sv, "metallic"sv, "normalWS"sv};
    EXPECT_EQ(nearest("roughnes", kWords), "roughness");
    EXPECT_EQ(nearest("mettalic", kWords), "metallic");
    EXPECT_EQ(nearest("colour", kWords), "");
}

TEST(Nearest, UnderscoresAndCaseMakeNoDifference) {
    constexpr std::array kWords = {"normalOS"sv, "normalWS"sv, "nearPlane"sv, "isLit"sv, "perObject"sv};
    EXPECT_EQ(nearest("normalWS", kWords), "normalWS");
    EXPECT_EQ(nearest("normalOS", kWords), "normalOS");
    EXPECT_EQ(nearest("nearPlane", kWords), "nearPlane");
    EXPECT_EQ(nearest("is_lit", kWords), "isLit");
    EXPECT_EQ(nearest("PER_OBJECT", kWords), "perObject");
}

// Each underscore would count as a letter that is wrong.
TEST(Nearest, AnOldSpellingWithAMistakeIsFound) {
    constexpr std::array kWords = {"ambientOrLightmapUV"sv, "oneMinusSrcAlpha"sv, "normalWS"sv};
    EXPECT_EQ(nearest("one_minus_src_aplha", kWords), "oneMinusSrcAlpha");
    EXPECT_EQ(nearest("normlWS", kWords), "normalWS");
}

TEST(Nearest, AWordThatDiffersByUnderscoresOnlyIsPreferred) {
    constexpr std::array kWords = {"light_ax"sv, "lightAxis"sv, "_Tint"sv, "Tint2"sv};
    EXPECT_EQ(nearest("lightAxis", kWords), "lightAxis");
    EXPECT_EQ(nearest("Tint", kWords), "_Tint");
}

}  // namespace
}  // namespace patina
