// The tables of words: each word reads back as its value, and no word stands for two.
#include "patina/words.h"

#include <gtest/gtest.h>

#include <set>

namespace patina {
namespace {

template <class E>
class Words : public testing::Test {};

using Enums =
    testing::Types<PropertyType, Binding, TextureUsage, TextureDimension, Wrap, Filter, Stage, SurfaceKind, Cull,
                   Compare, StencilOp, StencilReference, BlendFactor, TargetFormat, PassDraws, PassEach, PassLights,
                   PassCamera, LightKind, LightImportance, SceneEnvironment, FogMode, LightMixing, LightmapEncoding>;
TYPED_TEST_SUITE(Words, Enums);

TYPED_TEST(Words, ReadBackAsTheyAreWritten) {
    std::set<std::string_view> texts;
    std::set<TypeParam> values;
    for (const Word<TypeParam>& word : kWords<TypeParam>) {
        EXPECT_EQ(to_string(word.value), word.text);
        EXPECT_EQ(from_word<TypeParam>(word.text), word.value);
        EXPECT_TRUE(texts.insert(word.text).second) << word.text;
        EXPECT_TRUE(values.insert(word.value).second) << word.text;
    }
    EXPECT_EQ(from_word<TypeParam>("cubes"), std::nullopt);
    EXPECT_EQ(from_word<TypeParam>(""), std::nullopt);
}

TEST(Word, IsMissingForWhatHasNone) {
    EXPECT_EQ(to_string(StencilReference::Own), "");
    EXPECT_EQ(to_string(FogMode::None), "");
}

}  // namespace
}  // namespace patina
