// What of a function its own result needs: the rest is left behind by whoever rebuilds it with Copy::live. Looks at one
// function and takes every call as needing all its arguments; prune() knows better, for a whole module.
//
//   const Liveness live = live_in(function);
//   Copy copy{.from = function, .to = builder, .live = &live};
#pragma once

#include "compiler/ir/rebuild.h"

namespace patina::ir {

Liveness live_in(const Function& function);

}  // namespace patina::ir
