// A value that is made when somebody first asks for it, by whichever thread comes first. If that fails with an
// exception, nothing is stored, and the next thread that asks makes the value. No thread ever sees a half-made value.
// std::call_once would do for one thread after another, but some C libraries hang after an exception.
//
//   MadeOnce<ReadBody> body;
//   const ReadBody& read = body.get([&] { return std::make_unique<ReadBody>(...); });
#pragma once

#include <atomic>
#include <memory>
#include <mutex>

namespace patina {

template <class T>
class MadeOnce {
public:
    // `make` returns a std::unique_ptr, which is not null.
    template <class Make>
    const T& get(const Make& make) const {
        if (const T* made = made_.load(std::memory_order_acquire)) return *made;
        const std::lock_guard lock(mutex_);
        if (!owned_) {
            owned_ = make();
            made_.store(owned_.get(), std::memory_order_release);
        }
        return *owned_;
    }

private:
    mutable std::atomic<const T*> made_ = nullptr;
    mutable std::unique_ptr<const T> owned_;
    mutable std::mutex mutex_;
};

}  // namespace patina
