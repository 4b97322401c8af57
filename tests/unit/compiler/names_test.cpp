// Identifiers of the emitted text: reserved words, clashes, numbers.
#include "compiler/languages/names.h"

#include <gtest/gtest.h>

#include "compiler/languages/print.h"

namespace patina::languages {
namespace {

TEST(Names, WordsOfEitherLanguageAreReserved) {
    for (const char* word : {"vec3", "texture", "sampler", "out", "smooth", "inversesqrt", "sample", "dFdx"}) {
        EXPECT_TRUE(is_reserved_word(word)) << word << " is GLSL's";
    }
    for (const char* word :
         {"float3", "cbuffer", "lerp", "saturate", "matrix", "line", "pass", "half", "SamplerState"}) {
        EXPECT_TRUE(is_reserved_word(word)) << word << " is HLSL's";
    }
    EXPECT_TRUE(is_reserved_word("main"));
    for (const char* word : {"albedo", "roughness", "_MainTex", "i", "Vec3", ""})
        EXPECT_FALSE(is_reserved_word(word)) << word;
}

TEST(Names, SafeIdentifierKeepsGoodNames) {
    for (const char* word : {"albedo", "_MainTex", "Tint2", "x"}) EXPECT_EQ(safe_identifier(word), word);
}

TEST(Names, SafeIdentifierChangesWhatATargetRefuses) {
    EXPECT_EQ(safe_identifier("texture"), "texture_");
    EXPECT_EQ(safe_identifier("a__b"), "a_b");
    EXPECT_EQ(safe_identifier("gl_Position"), "glPosition");
    EXPECT_EQ(safe_identifier("__"), "value");
    EXPECT_EQ(safe_identifier(""), "value");
    EXPECT_EQ(safe_identifier("2nd"), "_2nd");
    EXPECT_EQ(safe_identifier("rust.amount"), "rust_amount");
    EXPECT_EQ(safe_identifier("gr\xc3\xbc"
                              "n"),
              "gr_n");
}

TEST(Names, SafeIdentifierIsSafe) {
    for (const char* word : {"texture", "gl_", "gl__x", "_", "___a__", "float", "9", "a b", "in__out", "gl_in"}) {
        const std::string name = safe_identifier(word);
        EXPECT_FALSE(is_reserved_word(name)) << name;
        EXPECT_EQ(name.find("__"), std::string::npos) << name;
        EXPECT_FALSE(name.starts_with("gl_")) << name;
        EXPECT_EQ(safe_identifier(name), name) << "a safe name stays as it is";
    }
}

TEST(Names, ANumberOnlyOnAClash) {
    Names names;
    EXPECT_EQ(names.declare("albedo"), "albedo");
    EXPECT_EQ(names.declare("albedo"), "albedo2");
    EXPECT_EQ(names.declare("albedo"), "albedo3");
    EXPECT_EQ(names.declare("tint"), "tint");
}

TEST(Names, ANumberedNameMayBeTakenAlready) {
    Names names;
    EXPECT_EQ(names.declare("albedo2"), "albedo2");
    EXPECT_EQ(names.declare("albedo"), "albedo");
    EXPECT_EQ(names.declare("albedo"), "albedo3");
}

TEST(Names, ReservedWordsThatClash) {
    Names names;
    EXPECT_EQ(names.declare("texture"), "texture_");
    EXPECT_EQ(names.declare("texture"), "texture_2");
}

TEST(Names, InnerScopesSeeOuterOnesAndAreForgotten) {
    Names names;
    names.declare("n");
    names.open();
    EXPECT_EQ(names.declare("n"), "n2");
    EXPECT_EQ(names.declare("t"), "t");
    names.close();
    names.open();
    EXPECT_EQ(names.declare("t"), "t") << "a sibling scope may use the name again";
    EXPECT_EQ(names.declare("n"), "n2");
    names.close();
}

TEST(Names, TargetsAreFoundByName) {
    ASSERT_NE(find_language("glsl"), nullptr);
    EXPECT_EQ(find_language("hlsl")->name, "hlsl");
    EXPECT_EQ(find_language("cobol"), nullptr);
}

}  // namespace
}  // namespace patina::languages
