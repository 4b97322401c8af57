// The room `json/memory` has memory for RapidJSON, for all trees. RapidJSON's own allocator gives what malloc gives, and
// RapidJSON writes there without a look, also if that is null. This one throws std::bad_alloc.
//
//   JsonBuffer buffer;
//   JsonLines writer(buffer);   // or JsonPages, which is indented
#pragma once

#include <rapidjson/prettywriter.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

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

using JsonBuffer = rapidjson::GenericStringBuffer<rapidjson::UTF8<>, JsonMemory>;
using JsonLines = rapidjson::Writer<JsonBuffer, rapidjson::UTF8<>, rapidjson::UTF8<>, JsonMemory>;
using JsonPages = rapidjson::PrettyWriter<JsonBuffer, rapidjson::UTF8<>, rapidjson::UTF8<>, JsonMemory>;

}  // namespace patina
