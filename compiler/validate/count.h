// Which instructions of a module run, how often, and what computes them.
//
//   for_each_run(module, is_light_loop, [&](const Instruction& at, bool per_light) { add(cost, at.op); });
#pragma once

#include <functional>

#include "compiler/validate/spirv.h"
#include "patina/cost.h"

namespace patina::spirv {

// Adds the instruction to the number that it belongs to; not if it does nothing, as a label.
void add(Instructions& cost, const Instruction& at);

// Visits what the entry point runs: functions once for each call, each block once. `per_light`: it is inside a loop
// that `is_light_loop` accepts by its OpLoopMerge.
void for_each_run(const Spirv& module, const std::function<bool(const Instruction& loop)>& is_light_loop,
                  const std::function<void(const Instruction& at, bool per_light)>& visit);

}  // namespace patina::spirv
