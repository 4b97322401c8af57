// What a lighting model costs: the size of a shader that uses it.
#pragma once

#include "patina/patina.h"

namespace patina::cli {

struct ModelCost {
    std::string workflow{}, pass{};  // in which it was measured
    std::size_t instructions = 0;    // of the optimised SPIR-V, declarations too; 0: it could not be compiled
    std::size_t in_functions = 0;
    std::size_t per_light = 0;  // of them in the loop over the lights, which is the shader's only one
};

// Of the fragment shader of a material that gives every input of the surface a property.
ModelCost cost_of(const Compiler& compiler, const ModelInfo& model);

}  // namespace patina::cli
