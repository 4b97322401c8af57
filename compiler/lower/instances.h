// Many of an object in one draw. A material is instanced when a property of it is bound `as: instance`; then what
// belongs to the object that is drawn, and those properties, are arrays with an element for each instance.
#pragma once

#include "compiler/lower/lower.h"

namespace patina::graph {

bool is_instanced(const Material& material);

// What a uniform block may hold on every device that matters: D3D11's limit, and Vulkan's wherever there is a GPU.
inline constexpr std::uint32_t kMostBlockBytes = 65536;

// What one instance takes of a block, and what others leave there for it, in bytes.
struct InstanceSize {
    std::uint32_t bytes = 0, room = 0;
};
// Of the block of which an instance takes most.
InstanceSize size_of_instance(const Lowered& lowered, const std::set<std::uint32_t>& globals);

// Makes the globals arrays of as many elements as fit in their blocks, and every read of them one of the element of the
// instance that is drawn. Returns how many those are. The functions are lowered, and not linked yet.
std::uint32_t make_instanced(Lowered& lowered, const std::set<std::uint32_t>& globals);

}  // namespace patina::graph
