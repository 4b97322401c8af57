// How many instructions a SPIR-V module has, and how many of them are in loops.
//
//   const SpirvSize size = size_of(optimised(validated.spirv));
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace patina {

// The size of a module, in instructions.
struct SpirvSize {
    std::size_t instructions = 0;  // with declarations
    std::size_t in_functions = 0;  // of the bodies of all functions
    std::size_t loops = 0;         // that are not inside another loop
    std::size_t in_loops = 0;  // one round of each of them, with the functions that it calls; inner loops count once
};

// All zero if the words are not a module.
SpirvSize size_of(const std::vector<std::uint32_t>& spirv);

}  // namespace patina
