// Assigns descriptor sets, bindings and registers to the globals of a module, as the engine numbers them.
#pragma once

#include "compiler/engines/engine.h"
#include "compiler/ir/ir.h"
#include "compiler/lower/declare.h"

namespace patina::lower {

// binding = HLSL register + shift, in a set.
struct SetShifts {
    std::uint32_t set = 0, buffers = 0, textures = 0, samplers = 0;
};

// Places blocks, textures and samplers: those of a material in the order of declaration, the library's by `numbering`.
// Returns the shifts of each set that an owner
// has, in the order of the owners: engine, material, targets.
std::vector<SetShifts> place_globals(ir::Module& module, const engines::Engine& engine, const Numbering& numbering);

}  // namespace patina::lower
