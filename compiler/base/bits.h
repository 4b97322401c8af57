// The bits of a value as another type of the same size. std::bit_cast does this, but the standard library of
// Emscripten 3.1.6 (libc++ 13) does not have it.
//
//   const auto bits = bits_as<std::uint64_t>(0.5);
#pragma once

#include <cstring>
#include <type_traits>

#include "compiler/base/bits.h"

namespace patina {

template <class To, class From>
To bits_as(const From& from) {
    static_assert(sizeof(To) == sizeof(From));
    static_assert(std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
    To to;
    std::memcpy(&to, &from, sizeof to);
    return to;
}

}  // namespace patina
