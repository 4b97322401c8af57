// Rewrites of a linked stage. Each is Module -> Module, one file, and rebuilds functions through the Builder, so that new
// chances to fold are taken on the way. The list and its order are passes.def.
#pragma once

#include "compiler/ir/ir.h"

namespace patina::ir {

// Drops instructions that nothing reads, functions that nothing calls, parameters that a function does not read, members
// that no one takes from a function's result struct (all callers use Extract only), and carried loop values that are
// never used or never change. Stage inputs of a fragment stage that are not read are dropped from the interface too.
// Material blocks and texture slots keep their layout.
Module prune(const Module& module);

// Calls with constant arguments get a copy of the callee with them filled in, when that removes a branch or a loop;
// calls whose arguments are all constant fold away.
Module specialise(const Module& module);

// Replaces a call by the callee's body: functions marked always_inline; functions with Texture2D-like struct parameters
// or opaque parameters; functions whose body is at most `kSmall` operations; functions called with a value that lets
// something be hoisted out of a light loop.
Module inline_calls(const Module& module);

// Moves loop-invariant instructions out of For (derivatives and samples too: out is always allowed), outermost first, and
// sinks nothing. After it a light loop computes only what depends on the light.
Module schedule(const Module& module);

// The passes of passes.def in order, verified after each in debug builds.
Module tidy(const Module& module);

// Rate of every instruction of a function, given its params' rates. Indexed by Value.
std::vector<Rate> rates(const Module& module, const Function& function);

}  // namespace patina::ir
