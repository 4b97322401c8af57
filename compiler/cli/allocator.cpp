// operator new and delete of the command: a compile makes some ten thousand small things and frees them together.
// mimalloc's own ones (mimalloc-new-delete.h) end the program when there is no memory, if mimalloc was built as C.
// These throw, as the standard says.
#include <mimalloc.h>

#include <new>

namespace {

// Apart, so that an allocation with memory does nothing else.
[[gnu::noinline, gnu::cold]] void ask_for_memory() {
    const std::new_handler handler = std::get_new_handler();
    if (!handler) throw std::bad_alloc();
    handler();
}

void* take(std::size_t size) {
    while (true) {
        if (void* const memory = mi_malloc(size)) return memory;
        ask_for_memory();
    }
}
void* take(std::size_t size, std::align_val_t align) {
    while (true) {
        if (void* const memory = mi_malloc_aligned(size, static_cast<std::size_t>(align))) return memory;
        ask_for_memory();
    }
}
void give(void* memory, std::align_val_t align) {
    mi_free_aligned(memory, static_cast<std::size_t>(align));
}

}  // namespace

// clang-format off
void* operator new(std::size_t size) { return take(size); }
void* operator new[](std::size_t size) { return take(size); }
void* operator new(std::size_t size, std::align_val_t align) { return take(size, align); }
void* operator new[](std::size_t size, std::align_val_t align) { return take(size, align); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return mi_malloc(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return mi_malloc(size); }
void* operator new(std::size_t size, std::align_val_t align, const std::nothrow_t&) noexcept { return mi_malloc_aligned(size, static_cast<std::size_t>(align)); }
void* operator new[](std::size_t size, std::align_val_t align, const std::nothrow_t&) noexcept { return mi_malloc_aligned(size, static_cast<std::size_t>(align)); }

void operator delete(void* memory) noexcept { mi_free(memory); }
void operator delete[](void* memory) noexcept { mi_free(memory); }
void operator delete(void* memory, std::size_t size) noexcept { mi_free_size(memory, size); }
void operator delete[](void* memory, std::size_t size) noexcept { mi_free_size(memory, size); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { mi_free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { mi_free(memory); }
void operator delete(void* memory, std::align_val_t align) noexcept { give(memory, align); }
void operator delete[](void* memory, std::align_val_t align) noexcept { give(memory, align); }
void operator delete(void* memory, std::size_t, std::align_val_t align) noexcept { give(memory, align); }
void operator delete[](void* memory, std::size_t, std::align_val_t align) noexcept { give(memory, align); }
void operator delete(void* memory, std::align_val_t align, const std::nothrow_t&) noexcept { give(memory, align); }
void operator delete[](void* memory, std::align_val_t align, const std::nothrow_t&) noexcept { give(memory, align); }
// clang-format on
