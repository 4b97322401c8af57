// Which instructions of a function are settled once some parameters are: known as constants (specialise), or the same
// for all lights (inline_calls). The passes ask this before they decide; it changes nothing.
//
//   auto known = settled(callee, 1u << 2, Globals::Vary);   // what follows from its third argument
#pragma once

#include "compiler/ir/ir.h"

namespace patina::ir {

// Parameters from 64 on are never settled.
inline constexpr std::uint32_t kMaxSettledParams = 64;

enum class Globals : std::uint8_t { Settled, Vary };

// By Value: 1 if all that it depends on is a constant, a parameter in the mask, or a global if those are settled.
std::vector<std::uint8_t> settled(const Function& function, std::uint64_t params, Globals globals);

// True for ops that cost something: false for leaves, for ops that only rearrange values, and for structure.
bool is_work(Op op);

// True if a writer searches for calls of the function, because it follows a global (ir.h). Then the calls must stay
// unchanged.
bool is_follower(const Module& module, const Function& function);

}  // namespace patina::ir
