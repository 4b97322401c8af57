// A few equal shares of some work, each on a thread of its own.
//
//   on_threads(6, [&](int face) { blur(face); });
#pragma once

#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace patina::runtime {

// Calls `work` for 0 to `count` - 1, all at the same time if the machine has the threads for it. What it throws is
// thrown here, when all have ended.
template <class Work>
void on_threads(int count, const Work& work) {
    std::mutex mutex;
    std::exception_ptr failure;
    const auto guarded = [&](int share) {
        try {
            work(share);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
        }
    };
    std::vector<std::thread> threads;
    if (count > 1) threads.reserve(static_cast<std::size_t>(count) - 1);
    int started = 1;  // the first share is this thread's
    try {
        for (; started < count; ++started) threads.emplace_back(guarded, started);
    } catch (const std::system_error&) {  // there are no more threads: this one does the rest
    } catch (const std::bad_alloc&) {
    }
    if (count > 0) guarded(0);
    for (int share = started; share < count; ++share) guarded(share);
    for (std::thread& thread : threads) thread.join();
    if (failure) std::rethrow_exception(failure);
}

}  // namespace patina::runtime
