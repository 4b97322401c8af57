// patina/lighting.h lets no exception out, also of its threads.
#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "failing_new.h"
#include "patina/lighting.h"

namespace patina::lighting {
namespace {

using patina::testing::Failing;

TEST(LightingFailure, WithoutMemory) {
    const std::vector<float> pixels(3 * 8 * 4, 0.5f);
    const Picture picture{.width = 8, .height = 4, .numbers = pixels};
    for (const Failing how : {Failing::Once, Failing::FromHere}) {
        for (const long nth : {1L, 2L, 3L, 5L, 8L, 13L}) {
            patina::testing::fail_at(nth, how);
            const Environment made = prefilter(picture);
            patina::testing::stop_failing();
            EXPECT_TRUE(how == Failing::Once || made.error == "out of memory") << made.error << nth;
            EXPECT_TRUE(made.error.empty() || made.error == "out of memory") << made.error;
            EXPECT_EQ(made.levels.empty(), !made.error.empty());
            if (made.error.empty()) break;  // the others take as long
        }
    }
}

TEST(LightingFailure, ProgressThatThrows) {
    const std::vector<float> pixels(3 * 8 * 4, 0.5f);
    const Options options{.progress = [](double) { throw std::runtime_error("the window is closed"); }};
    const Environment made = prefilter({.width = 8, .height = 4, .numbers = pixels}, options);
    EXPECT_EQ(made.error, "the window is closed");
    EXPECT_TRUE(made.levels.empty());
}

}  // namespace
}  // namespace patina::lighting
