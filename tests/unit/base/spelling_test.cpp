// How names that the compiler makes are spelled.
#include "compiler/base/spelling.h"

#include <gtest/gtest.h>

namespace patina {
namespace {

TEST(Spelling, NamesOfTypesAndFunctionsBecomeCamelCase) {
    EXPECT_EQ(camel_case("DistributionGGX"), "distributionGGX");
    EXPECT_EQ(camel_case("LightingSurface"), "lightingSurface");
    EXPECT_EQ(camel_case("GGXTerm"), "ggxTerm");
    EXPECT_EQ(camel_case("defaultSurface"), "defaultSurface");
    EXPECT_EQ(camel_case("SH9"), "sh9");
    EXPECT_EQ(camel_case("F0FromIor"), "f0FromIor");
}

TEST(Spelling, WordsBetweenSignsBecomeCamelCase) {
    EXPECT_EQ(camel_case("FORWARD_DELTA"), "forwardDelta");
    EXPECT_EQ(camel_case("rim-light"), "rimLight");
    EXPECT_EQ(camel_case("own_struct"), "ownStruct");
    EXPECT_EQ(camel_case("_"), "");
}

TEST(Spelling, JoinedWordsHaveACapitalBetweenThem) {
    EXPECT_EQ(joined("vertex", "positionOS"), "vertexPositionOS");
    EXPECT_EQ(joined("v", "uv0"), "vUv0");
    EXPECT_EQ(joined("own", "_Tint"), "own_Tint");
    EXPECT_EQ(joined("", "sum"), "sum");
    EXPECT_EQ(joined("cosine", ""), "cosine");
}

TEST(Spelling, ANumberStandsOffADigit) {
    EXPECT_EQ(numbered("albedo", 2), "albedo2");
    EXPECT_EQ(numbered("uv0", 2), "uv0_2");
    EXPECT_EQ(numbered("texture_", 2), "texture_2");
}

TEST(Spelling, InitialsAreThoseOfTheWords) {
    EXPECT_EQ(initials("lightingSurface"), "ls");
    EXPECT_EQ(initials("metallicSetupResult"), "msr");
    EXPECT_EQ(initials("LightGGX"), "lg");
}

}  // namespace
}  // namespace patina
