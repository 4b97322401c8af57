// Work on several threads: everything is done once, and told in its order, by one thread at a time.
#include "runtime/jobs/jobs.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <thread>
#include <vector>

namespace patina::runtime {
namespace {

TEST(Jobs, AreDoneOnceAndToldInOrder) {
    for (const int jobs : {0, 1, 2, 7}) {
        for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{3}, std::size_t{1000}}) {
            std::vector<std::atomic<int>> made(count);
            std::vector<std::size_t> told;  // without a lock: the thread sanitizer sees it if two threads tell at once
            in_order(
                count, jobs, [&]() -> Work { return [&](std::size_t i) { ++made[i]; }; },
                [&](std::size_t i) {
                    EXPECT_EQ(made[i], 1);
                    told.push_back(i);
                });
            ASSERT_EQ(told.size(), count);
            for (std::size_t i = 0; i < count; i++) EXPECT_EQ(told[i], i);
        }
    }
}

TEST(Jobs, HaveAWorkerForEachThread) {
    std::atomic<int> workers{0};
    in_order(
        100, 3,
        [&]() -> Work {
            ++workers;
            return [busy = std::make_shared<std::atomic<bool>>(false)](std::size_t) {
                EXPECT_FALSE(busy->exchange(true)) << "two threads have one worker";
                std::this_thread::yield();
                *busy = false;
            };
        },
        [](std::size_t) {});
    EXPECT_EQ(workers, 3);
}

// While the first piece takes long, the others do not run away from it.
TEST(Jobs, StayNearToWhatIsTold) {
    std::atomic<std::size_t> furthest{0};
    std::atomic<bool> is_first_done{false};
    in_order(
        5000, 2,
        [&]() -> Work {
            return [&](std::size_t i) {
                if (i == 0) {
                    std::this_thread::sleep_for(std::chrono::milliseconds(100));
                    is_first_done = true;
                } else if (!is_first_done) {
                    furthest = std::max<std::size_t>(furthest, i);
                }
            };
        },
        [](std::size_t) {});
    EXPECT_LE(furthest, 256u);
}

}  // namespace
}  // namespace patina::runtime
