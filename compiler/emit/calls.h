// Calls: f(a, b) in a text, where f is an intrinsic, a constructor, a slot or a declared function. call(), which a node
// of a graph becomes, is public (emit.h).
#pragma once

#include "compiler/emit/emit.h"

namespace patina::emit {

Typed call_expression(Emitter& emitter, const Expr& expr, Scope& scope);

}  // namespace patina::emit
