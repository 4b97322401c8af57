// A module in which each call has a copy of its function, so that the optimiser's inlining does not forget which line
// called it.
//
// Functions of the library are called from the lines of several nodes, and OpLine says only where an instruction
// stands. The copies' OpLine has that line and, in place of a column, the line of the call. If the call stands in a
// function of the library itself, the line is that of the call around it, and so on.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/validate/spirv.h"

namespace patina::spirv {

// `is_owner(line)`: the line belongs to somebody, who owns what it calls. Functions that the entry point does not reach
// are left out.
std::vector<std::uint32_t> expand_calls(const Spirv& module, const std::function<bool(std::uint32_t line)>& is_owner);

}  // namespace patina::spirv
