// What the passes of a compiled material cost, counted from optimised SPIR-V.
//
//   for (const PassCost& cost : costs(compiled)) print(cost.pass, cost.fragment.instructions);
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "patina/patina.h"

namespace patina::runtime {

struct StageCost {
    std::size_t instructions = 0;  // after `spirv-opt -O`, without declarations; each loop counts once
    std::size_t per_light = 0;     // of them in loops, which are over lights in the library's passes
};
struct PassCost {
    std::string pass;
    StageCost vertex{}, fragment{};
    std::size_t textures = 0;       // that either stage reads
    std::size_t uniform_bytes = 0;  // of the material's own blocks
    std::size_t lines = 0;          // of both stages' texts
};

// In the order of the reflection's passes. Needs GLSL; a stage that glslang refuses has no instructions.
std::vector<PassCost> costs(const Result& compiled);

}  // namespace patina::runtime
