// Which values of a function its result needs. A copy with Copy::live leaves out the others. This examines one
// function, and assumes that a call needs all of its arguments. prune() examines the whole module and knows which
// arguments are needed.
//
//   const Liveness live = live_in(function);
//   Copy copy{.from = function, .to = builder, .live = &live};
#pragma once

#include "compiler/ir/rebuild.h"

namespace patina::ir {

Liveness live_in(const Function& function);

}  // namespace patina::ir
