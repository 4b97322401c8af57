// Many instances of an object in one draw. If a property of a material is bound `as: instance`, then this property and
// the globals of the drawn object become arrays with an element for each instance. So do these globals if the material
// reads the index of the instance.
#pragma once

#include "compiler/lower/lower.h"

namespace patina::lower {

bool is_instanced(const resolve::Material& material);
// Whether a pass of the material may read the index of the instance.
bool reads_instance(const Lowered& lowered);

// The values of the object that belong to a switch (by their globals), if a switch that adds them is on, and the types
// of all others. No switch moves a member: these members come after the properties, and have space even if they are not
// declared.
struct OptionalValues {
    std::set<std::uint32_t> declared;
    std::vector<ir::Type> absent;
};

// How many bytes of a block one instance takes, and how many there are for all instances.
struct InstanceSize {
    std::uint32_t bytes = 0, room = 0;
};
// For the block of which one instance takes the most. `most_bytes`: the engine's limit of a uniform block.
InstanceSize size_of_instance(const Lowered& lowered, const std::set<std::uint32_t>& globals,
                              const OptionalValues& optional, std::uint32_t most_bytes);

// Turns the globals into arrays with as many elements as fit in their blocks, and replaces each read by a read of the
// drawn instance's element. Returns the number of elements. The functions must be lowered and not linked yet.
std::uint32_t make_instanced(Lowered& lowered, const std::set<std::uint32_t>& globals, const OptionalValues& optional,
                             std::uint32_t most_bytes);

}  // namespace patina::lower
