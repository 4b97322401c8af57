// What a lighting model costs: the size of the fragment shader of a material that uses it.
#pragma once

#include "patina/patina.h"

namespace patina::cli {

struct ModelCost {
    std::string workflow{}, pass{};  // of the shader that was measured
    std::size_t instructions = 0;    // of the optimised SPIR-V with its declarations; 0: it could not be compiled
    std::size_t in_functions = 0;
    std::size_t per_light = 0;  // of them in the loop over the lights, the only loop of the shader
};

// The material gives every input of the surface a property, so that none is a constant.
ModelCost cost_of(const Compiler& compiler, const ModelInfo& model);

}  // namespace patina::cli
