// Numbers as GLSL and HLSL write them: shortest text that reads back the same, always recognisable as a float.
//
//   literal(kFloat, 1)       1.0        literal(kUint, 5)   5u
//   literal(kHalf, 0.5)      0.5hf (GLSL), 0.5h (HLSL)
#pragma once

#include "compiler/ir/types.h"
#include "compiler/languages/language.h"
#include "compiler/languages/precedence.h"

namespace patina::targets {

// The value is rounded to the scalar kind first.
Text literal(const Language& language, ir::Scalar scalar, double value);

}  // namespace patina::targets
