#include "runtime/render/render_jobs.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

namespace patina::runtime {
namespace {

constexpr unsigned kMostJobs = 4;  // without a wish: each needs a device and its memory

class Jobs {
public:
    Jobs(std::size_t count, const std::function<void(std::size_t, RenderMachine&)>& work,
         const std::function<void(std::size_t)>& done)
        : count_(count), work_(work), done_(done), is_done_(count) {}

    void run(std::size_t threads) {
        std::vector<std::thread> others;
        for (std::size_t i = 1; i < std::min(threads, count_); i++) others.emplace_back([this] { take(); });
        take();
        for (std::thread& other : others) other.join();
    }

private:
    void take() {
        RenderMachine machine;
        for (std::size_t i = next_++; i < count_; i = next_++) {
            work_(i, machine);
            const std::scoped_lock lock(mutex_);
            is_done_[i] = true;
            for (; told_ < count_ && is_done_[told_]; told_++)
                if (done_) done_(told_);
        }
    }

    std::size_t count_;
    const std::function<void(std::size_t, RenderMachine&)>& work_;
    const std::function<void(std::size_t)>& done_;
    std::atomic<std::size_t> next_{0};
    std::mutex mutex_{};  // of what follows
    std::vector<bool> is_done_;
    std::size_t told_ = 0;
};

}  // namespace

void render_jobs(std::size_t count, int jobs, const std::function<void(std::size_t, RenderMachine&)>& work,
                 const std::function<void(std::size_t)>& done) {
    const unsigned cores = std::clamp(std::thread::hardware_concurrency(), 1u, kMostJobs);
    Jobs(count, work, done).run(jobs > 0 ? std::size_t(jobs) : cores);
}

}  // namespace patina::runtime
