// What is thrown on another thread arrives where the work was asked for.
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "runtime/jobs/jobs.h"
#include "runtime/jobs/shares.h"

namespace patina::runtime {
namespace {

struct Broken : std::runtime_error {
    Broken() : std::runtime_error("broken") {}
};

TEST(JobsFailure, OfAPiece) {
    for (const int jobs : {1, 2, 8}) {
        for (const std::size_t broken : {0u, 37u, 999u}) {
            const auto make = [&]() -> Work {
                return [&](std::size_t i) {
                    if (i == broken) throw Broken();
                };
            };
            std::size_t told = 0;
            EXPECT_THROW(in_order(1000, jobs, make, [&](std::size_t) { ++told; }), Broken);
            EXPECT_LE(told, broken) << "a later piece was told";
        }
    }
}

TEST(JobsFailure, OfWhatIsTold) {
    for (const int jobs : {1, 8}) {
        const auto make = []() -> Work { return [](std::size_t) {}; };
        std::size_t told = 0;
        const auto tell = [&](std::size_t i) {
            if (i == 300) throw Broken();
            ++told;
        };
        EXPECT_THROW(in_order(1000, jobs, make, tell), Broken);
        EXPECT_EQ(told, 300u);
    }
}

TEST(JobsFailure, OfAWorker) {
    std::atomic<int> made = 0;
    const auto make = [&]() -> Work {
        if (made++ == 1) throw Broken();
        return [](std::size_t) {};
    };
    EXPECT_THROW(in_order(100000, 4, make, [](std::size_t) {}), Broken);
}

TEST(SharesFailure, AllSharesEndBefore) {
    for (const int broken : {0, 3, 5}) {
        std::atomic<int> ended = 0;
        const auto work = [&](int share) {
            if (share == broken) throw Broken();
            ++ended;
        };
        EXPECT_THROW(on_threads(6, work), Broken);
        EXPECT_EQ(ended, 5);
    }
}

}  // namespace
}  // namespace patina::runtime
