// The name hints of inlined values.
#include <gtest/gtest.h>

#include "compiler/ir/hints.h"

namespace patina::ir {
namespace {

TEST(Hints, AnAuthorsNameIsAWord) {
    Module module;
    const Hint hint = hint_of(module, module.intern("albedo"));
    EXPECT_EQ(hint.name, "albedo");
    EXPECT_EQ(hint.local, "albedo");
    EXPECT_EQ(hint.callee, "");
    EXPECT_EQ(hint_of(module, {}).name, "");
}

TEST(Hints, ALocalKnowsTheFunctionThatItComesFrom) {
    Module module;
    const NameId local = inlined_local(module, "SchlickWeight", module.intern("m"));
    EXPECT_EQ(hint_of(module, local).name, "m");
    EXPECT_EQ(hint_of(module, local).callee, "schlickWeight");
    EXPECT_EQ(inlined_local(module, "DisneyDiffuse", local), local)
        << "the innermost function is the one that says more";
}

TEST(Hints, AResultWithoutANameIsWeaklyNamedAfterTheFunction) {
    Module module;
    const NameId result = inlined_result(module, "SchlickWeight", {});
    EXPECT_EQ(module.name_of(result), "") << "it gets no statement because of that";
    EXPECT_EQ(hint_of(module, result).callee, "schlickWeight");
    EXPECT_EQ(inlined_local(module, "DisneyDiffuse", result), result);
}

TEST(Hints, AResultThatTheFunctionNamesIsNamedAfterTheFunction) {
    Module module;
    const NameId result = inlined_result(module, "NormalTangentToWorld", module.intern("direction"));
    EXPECT_EQ(module.name_of(result), "normalTangentToWorld");
    EXPECT_EQ(hint_of(module, result).local, "direction");
    EXPECT_EQ(module.name_of(inlined_result(module, "FromMap", result)), "fromMap")
        << "the outermost call has the result";
}

}  // namespace
}  // namespace patina::ir
