// The value of an expression that is known before a shader runs: literals, constants, const parameters, statics, and
// arithmetic of these. Emits nothing and reports nothing.
#pragma once

#include "compiler/emit/known.h"
#include "compiler/emit/scope.h"

namespace patina::emit {

// Nothing if the expression's value is not known.
std::optional<double> constant_value(const Known& known, const Expr& expr, const Scope& scope);

}  // namespace patina::emit
