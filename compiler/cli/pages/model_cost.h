// What a lighting model costs: the size of the fragment shader of a material that uses it.
#pragma once

#include "patina/patina.h"

namespace patina::cli {

struct ModelCost {
    std::string workflow{}, pass{};  // of the shader that was measured
    StageCost fragment{};            // all 0: it could not be compiled
};

// The material gives every input of the surface a property, so that none is a constant.
ModelCost cost_of(const Compiler& compiler, const ModelInfo& model);

}  // namespace patina::cli
