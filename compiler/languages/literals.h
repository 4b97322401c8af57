// Prints numbers as GLSL and HLSL write them: the shortest text that reads back the same, always recognisable as a
// float.
#pragma once

#include "compiler/ir/types.h"
#include "compiler/languages/language.h"
#include "compiler/languages/precedence.h"

namespace patina::languages {

// The value is rounded to the scalar kind first.
Text literal(const Language& language, ir::Scalar scalar, double value);

}  // namespace patina::languages
