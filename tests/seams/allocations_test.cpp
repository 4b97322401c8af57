// Without memory, the library answers with an error, keeps nothing that is half made, and is as usable as before. One
// allocation fails, or all from one on: every one where there are few, else some of them, spread evenly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "works.h"

namespace patina::testing {
namespace {

struct Case {
    Work work;
    bool may_throw = false;
};

const std::vector<Case>& all_cases() {
    static const std::vector<Case> all = [] {
        std::vector<Case> cases;
        for (Work& work : works_with_results()) cases.push_back({std::move(work), false});
        for (Work& work : works_with_values()) cases.push_back({std::move(work), true});
        for (Work& work : works_in_c()) cases.push_back({std::move(work), false});
        return cases;
    }();
    return all;
}

// `most` numbers from 1 to `count`. Their distance to the next multiple of the stride changes from one to the next.
std::vector<long> some_of(long count, long most) {
    const long stride = std::max(1L, count / most + (count % most != 0 ? 1 : 0));
    std::vector<long> chosen;
    for (long begin = 0, i = 0; begin < count; begin += stride, ++i)
        chosen.push_back(std::min(count, begin + 1 + i % stride));
    return chosen;
}

void check_answer(const Case& each, const Answer& answer, const std::string& undisturbed, const Plan& plan) {
    EXPECT_EQ(answer.escaped, "");
    if (answer.text == undisturbed && !answer.is_without_memory) return;  // it could do without that memory
    EXPECT_TRUE(answer.is_without_memory) << answer.text;
    if (each.may_throw || plan.how == Failing::FromHere) return;
    // One allocation alone leaves memory for the message, unless it is the message's.
    if (answer.diagnostics.empty()) return;
    EXPECT_TRUE(answer.has_error);
}

void fail_everywhere(const Case& each, Failing how, long most) {
    const Compiler undisturbed;
    Plan count;
    const std::string text = each.work.run(undisturbed, count).text;
    ASSERT_GT(count.counted, 0);
    const Compiler shared;  // its caches see all failures
    each.work.run(shared, count);
    bool is_shared = false;
    for (const long nth : some_of(count.counted, most)) {
        SCOPED_TRACE(each.work.name + ", allocation " + std::to_string(nth) + " of " + std::to_string(count.counted));
        is_shared = !is_shared;
        std::optional<Compiler> fresh;
        if (!is_shared) fresh.emplace();
        const Compiler& compiler = is_shared ? shared : *fresh;
        Plan plan{.nth = nth, .how = how};
        check_answer(each, each.work.run(compiler, plan), text, plan);
        Plan never;
        const Answer again = each.work.run(compiler, never);
        ASSERT_EQ(again.text, text) << "after a failure, the compiler is another one";
    }
}

class Allocations : public ::testing::TestWithParam<std::size_t> {
protected:
    static const Case& each() { return all_cases()[GetParam()]; }
};
using Quick = Allocations;
using Every = Allocations;

constexpr long kQuick = 8;
// PATINA_EACH_ALLOCATION=1: all of them, which takes a quarter of an hour.
long thorough() {
    constexpr long kMost = 400;
    return std::getenv("PATINA_EACH_ALLOCATION") ? std::numeric_limits<long>::max() : kMost;
}

TEST_P(Quick, OneFails) {
    fail_everywhere(each(), Failing::Once, kQuick);
}
TEST_P(Quick, AllFail) {
    fail_everywhere(each(), Failing::FromHere, kQuick);
}
TEST_P(Every, OneFails) {
    fail_everywhere(each(), Failing::Once, thorough());
}
TEST_P(Every, AllFail) {
    fail_everywhere(each(), Failing::FromHere, thorough());
}

std::string name_of(const ::testing::TestParamInfo<std::size_t>& info) {
    return all_cases()[info.param].work.name;
}
INSTANTIATE_TEST_SUITE_P(All, Quick, ::testing::Range(std::size_t{0}, all_cases().size()), name_of);
INSTANTIATE_TEST_SUITE_P(All, Every, ::testing::Range(std::size_t{0}, all_cases().size()), name_of);

// The constructor has no result: it throws, and what it has made is freed.
TEST(QuickCompiler, CannotBeMade) {
    const LibraryOverlay overlay{.files = {{"mine/dots.node.hlsl",
                                            "/// Dots.\n[node(\"Procedural/Dots\")]\nfloat Dots(float scale = 4) "
                                            "{ return scale; }\n"}}};
    fail_at(kNever, Failing::Once);
    { const Compiler compiler(overlay); }
    const long count = stop_failing();
    for (const Failing how : {Failing::Once, Failing::FromHere}) {
        for (const long nth : some_of(count, kQuick)) {
            fail_at(nth, how);
            try {
                const Compiler compiler(overlay);
            } catch (const std::bad_alloc&) {
            }
            stop_failing();
        }
    }
}

}  // namespace
}  // namespace patina::testing
