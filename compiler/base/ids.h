// Typed indices into vectors: `Id<struct FunctionTag>` cannot be used where an `Id<struct GlobalTag>` is meant.
// Not a pointer and not an owner: the vector that it indexes owns the thing.
//
//   using FunctionId = Id<struct FunctionTag>;
//   FunctionId id{3};
//   if (id) module.functions[id.index];
#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace patina {

template <class Tag>
struct Id {
    static constexpr std::uint32_t kNone = 0xffffffffu;
    std::uint32_t index = kNone;

    constexpr explicit operator bool() const { return index != kNone; }
    friend constexpr auto operator<=>(Id, Id) = default;
};

}  // namespace patina

template <class Tag>
struct std::hash<patina::Id<Tag>> {
    std::size_t operator()(patina::Id<Tag> id) const noexcept { return std::hash<std::uint32_t>{}(id.index); }
};
