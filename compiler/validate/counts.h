// Counts what a SPIR-V module costs: its instructions by kind, in all and for each owner, and its registers.
//
//   const SpirvCounts counts = count(optimised(with_owners(spirv, lines)), Stage::Fragment, owners);
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/validate/spirv_module.h"
#include "patina/reflection.h"

namespace patina {

struct SpirvCounts {
    // Of one owner (owners.h).
    struct Share {
        CostCounts once{}, per_light{};
    };
    StageCost total{};            // the sum of the shares
    std::vector<Share> shares{};  // by owner
    std::uint32_t light_loops = 0;
};

// Each instruction counts as often as its function is called. One without a line belongs to the owner of the one before
// it. All zero if the words are not a module. `owners`: how many there are, at least 1.
SpirvCounts count(const std::vector<std::uint32_t>& spirv, Stage stage, std::size_t owners = 1);

// The most scalars that are live at one point of the entry point and of the functions that it calls. Variables in
// memory always are.
std::uint32_t live_registers(const SpirvModule& module);

}  // namespace patina
