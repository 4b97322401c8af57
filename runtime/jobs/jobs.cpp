#include "runtime/jobs/jobs.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace patina::runtime {
namespace {

constexpr std::size_t kLead = 256;  // pieces that may be made and not done

class Jobs {
public:
    Jobs(std::size_t count, const std::function<Work()>& make_worker, const Work& done)
        : count_(count), make_worker_(make_worker), done_(done), is_made_(count) {}

    void run(std::size_t threads) {
        std::vector<std::thread> others;
        try {
            for (std::size_t i = 1; i < std::min(threads, count_); i++) others.emplace_back([this] { work_to_end(); });
        } catch (const std::system_error&) {  // there are no more threads: those that are there do all
        } catch (const std::bad_alloc&) {
        }
        work_to_end();
        for (std::thread& other : others) other.join();
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    // After an exception, no thread begins another piece.
    void work_to_end() {
        try {
            work();
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!failure_) failure_ = std::current_exception();
            next_ = count_;
            room_.notify_all();
        }
    }

    void work() {
        const Work worker = make_worker_();
        std::unique_lock lock(mutex_);
        while (true) {
            room_.wait(lock, [this] { return next_ >= count_ || next_ < told_ + kLead; });
            if (next_ >= count_) return;
            const std::size_t i = next_++;
            lock.unlock();
            worker(i);
            lock.lock();
            is_made_[i] = true;
            tell(lock);
        }
    }

    // The thread that reports continues until nothing is left; the others continue with their work.
    void tell(std::unique_lock<std::mutex>& lock) {
        if (is_telling_) return;
        is_telling_ = true;
        while (told_ < count_ && is_made_[told_]) {
            lock.unlock();
            done_(told_);
            lock.lock();
            ++told_;
            room_.notify_all();
        }
        is_telling_ = false;
    }

    std::size_t count_;
    const std::function<Work()>& make_worker_;
    const Work& done_;
    std::mutex mutex_{};  // of what follows
    std::condition_variable room_{};
    std::vector<bool> is_made_;
    bool is_telling_ = false;
    std::size_t next_ = 0, told_ = 0;
    std::exception_ptr failure_{};  // the first one
};

}  // namespace

void in_order(std::size_t count, int jobs, const std::function<Work()>& make_worker, const Work& done, unsigned most) {
    if (count == 0) return;
    const unsigned cores = std::clamp(std::thread::hardware_concurrency(), 1u, most);
    Jobs(count, make_worker, done).run(jobs > 0 ? std::size_t(jobs) : cores);
}

}  // namespace patina::runtime
