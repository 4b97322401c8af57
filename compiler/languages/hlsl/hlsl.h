// Prints HLSL in the style of Shader Model 5.1: cbuffers, separate textures and samplers, registers with spaces. It
// avoids code that glslang's HLSL front end accepts and translates wrongly (fmod, % of floats and ints, component-wise
// products of matrices).
#pragma once

#include "compiler/languages/language.h"
#include "compiler/languages/print.h"

namespace patina::languages::hlsl {

extern const SpellingTable kSpellings;  // spelling.cpp
// The language, of which a dialect may replace parts.
const Language& language();
std::string semantic(const ir::StageVariable& variable, bool is_target);

std::optional<ir::Module> legalize(const ir::Module& module);
Printed print(const ir::Module& module, const PrintOptions& options);

}  // namespace patina::languages::hlsl
