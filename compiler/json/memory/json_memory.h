// The room `json/memory` has memory for RapidJSON, for all trees. RapidJSON's own allocator gives what malloc gives,
// and RapidJSON writes there without a look, also if that is null. This one throws std::bad_alloc.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <new>

namespace patina {

// As RapidJSON's allocators are.
class JsonMemory {
public:
    static const bool kNeedFree = true;

    void* Malloc(std::size_t size) { return size > 0 ? ::operator new(size) : nullptr; }
    void* Realloc(void* old, std::size_t old_size, std::size_t size) {
        void* const made = Malloc(size);
        if (made && old) std::memcpy(made, old, std::min(old_size, size));
        Free(old);
        return made;
    }
    static void Free(void* memory) noexcept { ::operator delete(memory); }
};

}  // namespace patina
