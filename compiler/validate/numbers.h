// How many numbers a module passes between its stages, and how many it keeps at the same time where they are most: the
// registers that it needs if nothing is reordered.
//
//   cost.registers = live_numbers(module);
//
// Numbers are scalar components: a float3 is three, a half is one. Constants, pointers, textures and samplers are none.
#pragma once

#include <cstdint>

#include "compiler/validate/spirv.h"

namespace patina::spirv {

// A variable that a function keeps as an array is alive in the whole function. A call adds what its function needs.
std::uint32_t live_numbers(const Spirv& module);

// Of the inputs or outputs that have a location.
std::uint32_t interface_numbers(const Spirv& module, spv::StorageClass storage);

}  // namespace patina::spirv
