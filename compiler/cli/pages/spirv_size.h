// How many instructions a SPIR-V module has, and where they stand.
//
//   const SpirvSize size = size_of(optimised(validated.spirv));
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace patina::cli {

struct SpirvSize {
    std::size_t instructions = 0;  // declarations too
    std::size_t in_functions = 0;
    std::size_t loops = 0;     // that stand in no other loop
    std::size_t in_loops = 0;  // one trip of each of them, with the functions that are called there; loops inside once
};

// All zero for words that are no module.
SpirvSize size_of(const std::vector<std::uint32_t>& spirv);

}  // namespace patina::cli
