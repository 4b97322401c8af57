// How many instructions a stage has when all calls are replaced by what they call, as spirv-opt and drivers do:
// functions that each call the next one twice are few lines, and an exponential number of instructions. Nothing is
// inlined here.
#pragma once

#include "compiler/validate/spirv_module.h"
#include "patina/validate.h"

namespace patina {

struct Inlined {
    double instructions = 0;
    int line = 0;  // of the text: the innermost call that is too much by itself; 0: there is none
};
// `most`: from so many instructions on a call is too much. Of the function that nothing calls.
Inlined inlined(const SpirvModule& module, double most);

// Why the stage is not measured: spirv-opt cannot be interrupted, and would take minutes. Nothing if it can be.
std::optional<Diagnostic> too_large(const Shader& shader, const std::vector<std::uint32_t>& spirv);

}  // namespace patina
