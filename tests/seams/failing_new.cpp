#include "failing_new.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

using patina::testing::Failing;

std::atomic<bool> counts = false;
std::atomic<long> counted = 0;
std::atomic<long> failing = patina::testing::kNever;
std::atomic<Failing> how_it_fails = Failing::Once;

bool fails() {
    if (!counts) return false;
    const long now = ++counted, nth = failing;
    if (nth == patina::testing::kNever) return false;
    return how_it_fails == Failing::Once ? now == nth : now >= nth;
}

// By malloc, which sanitizers watch.
void* take(std::size_t size) {
    return fails() ? nullptr : std::malloc(size ? size : 1);
}
void* take(std::size_t size, std::align_val_t align) {
    if (fails()) return nullptr;
    const auto step = static_cast<std::size_t>(align);
    return std::aligned_alloc(step, (size + step - 1) / step * step);
}
void* or_throw(void* memory) {
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

namespace patina::testing {

void fail_at(long nth, Failing how) {
    counted = 0;
    failing = nth;
    how_it_fails = how;
    counts = true;
}

long stop_failing() {
    counts = false;
    return counted;
}

}  // namespace patina::testing

// clang-format off
void* operator new(std::size_t size) { return or_throw(take(size)); }
void* operator new[](std::size_t size) { return or_throw(take(size)); }
void* operator new(std::size_t size, std::align_val_t align) { return or_throw(take(size, align)); }
void* operator new[](std::size_t size, std::align_val_t align) { return or_throw(take(size, align)); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return take(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return take(size); }
void* operator new(std::size_t size, std::align_val_t align, const std::nothrow_t&) noexcept { return take(size, align); }
void* operator new[](std::size_t size, std::align_val_t align, const std::nothrow_t&) noexcept { return take(size, align); }

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t, const std::nothrow_t&) noexcept { std::free(memory); }
// clang-format on
