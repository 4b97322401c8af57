// inline_calls: a function of the library that one place calls goes there, if it is short.
#include "compiler/ir/passes/passes.h"
#include "tests/unit/ir/ir_testing.h"

namespace patina::ir {
namespace {

struct Case {
    int operations = 5;
    int calls = 1;
    const char* comment = "The half vector.";
    Linkage linkage = Linkage::Internal;
};

// How many functions are left when main() calls f() of so many operations so often.
std::size_t functions_left(const Case& wanted) {
    Module module;
    const FunctionId f = add(module, "f", {kX}, kFloat, [&](Builder& b) {
        Value value = b.param(0);
        for (int i = 0; i < wanted.operations; ++i) value = b.emit(i % 2 == 0 ? Op::Sin : Op::Exp, {value});
        return value;
    });
    module[f].comment = wanted.comment;
    module[f].linkage = wanted.linkage;
    const FunctionId main = add(module, "main", {kX}, kFloat, [&](Builder& b) {
        Value value = b.param(0);
        for (int i = 0; i < wanted.calls; ++i) value = b.call(f, std::vector{value});
        return value;
    });
    set_entry(module, main);
    return checked(prune(inline_calls(std::move(module)))).functions.size();
}

TEST(InlineOnce, AShortFunctionOfTheLibrary) {
    EXPECT_EQ(functions_left({}), 1u);
    EXPECT_EQ(functions_left({.operations = 6}), 1u);
    EXPECT_EQ(functions_left({.operations = 7}), 2u);
}

TEST(InlineOnce, NotWhereItIsCalledTwice) {
    EXPECT_EQ(functions_left({.calls = 2}), 2u);
}

// Passes that share a text share its functions: the other pass may call it more often.
TEST(InlineOnce, NotWhatOtherStagesCall) {
    EXPECT_EQ(functions_left({.linkage = Linkage::Exported}), 2u);
}

// What a graph's author wrote has no comment.
TEST(InlineOnce, NotTheFunctionOfAGraph) {
    EXPECT_EQ(functions_left({.comment = ""}), 2u);
}

}  // namespace
}  // namespace patina::ir
