// operator new and delete of the command: a compile makes some ten thousand small things and frees them together.
// mimalloc's own ones (mimalloc-new-delete.h) end the program when there is no memory, if mimalloc was built as C.
// These throw, as the standard says.
#include <mimalloc.h>

#include <new>

namespace {

template <class Allocate>
void* or_throw(const Allocate& allocate) {
    while (true) {
        if (void* memory = allocate()) return memory;
        const std::new_handler handler = std::get_new_handler();
        if (!handler) throw std::bad_alloc();
        handler();
    }
}

void* take(std::size_t size) {
    return or_throw([&] { return mi_malloc(size); });
}
void* take(std::size_t size, std::align_val_t align) {
    return or_throw([&] { return mi_malloc_aligned(size, static_cast<std::size_t>(align)); });
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
