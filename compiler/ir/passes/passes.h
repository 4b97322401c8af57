// Rewrites of a linked stage. Each is Module -> Module, one file, and rebuilds functions through the Builder, so that
// new chances to fold are taken on the way. The list and its order are passes.def. A module without a stage may be
// given too: then every exported function is kept as it is called from outside, or, where there are none, every
// function that nothing calls.
//
//   Module small = tidy(std::move(linked));
#pragma once

#include <span>

#include "compiler/ir/ir.h"

namespace patina::ir {

// Drops instructions that nothing reads, functions that nothing calls, parameters that a function does not read,
// members that no one takes from a function's result struct (all callers use Extract only), and carried loop values
// that are never used or never change. Stage inputs that are not read are dropped from the interface too. Material
// blocks and texture slots keep their layout.
Module prune(Module module);

// Calls with constant arguments get a copy of the callee with them filled in, when that removes a branch or a loop, or
// half of the callee's work; calls whose arguments are all constant fold away.
Module specialise(Module module);

// Replaces a call by the callee's body: functions marked always_inline; functions with Texture2D-like struct parameters
// or opaque parameters; functions whose body is at most `kSmall` operations; functions called with a value that lets
// something be hoisted out of a light loop.
Module inline_calls(Module module);

// Moves loop-invariant instructions out of For (derivatives and samples too: out is always allowed), outermost first,
// and sinks nothing. After it a light loop computes only what depends on the light.
Module schedule(Module module);

// Moves discards of the entry function behind the last derivative and the last sample that needs one: pixels that are
// gone help their neighbours no more. Not part of tidy(); for targets whose discard ends the pixel at once.
Module legalize_discard(Module module);

// Where keywords alone choose between two values, what only one of them needs goes to its side of a branch: a text can
// then leave the other side out, whatever is in it, samples and derivatives too. Not part of tidy(); for targets that
// have keywords.
Module branch_on_keywords(Module module);
// By value: 1 if it is made of keywords and constants by nothing but comparisons and logic.
std::vector<std::uint8_t> keyword_values(const Module& module, const Function& function);

// Drops members of structs that nothing reads of what is reached, in every function alike, and what was computed for
// them alone. `entries` return what somebody else reads; `called` are called by whoever links them. What functions that
// are defined elsewhere take and return stays whole, too. For stages that share their functions' text: what one of them
// reads, all have. Not part of tidy().
Module drop_members(Module module, std::span<const FunctionId> entries, std::span<const FunctionId> called);

// Where all calls of a function agree about an argument, the function knows it: a constant, or one that it is handed
// already. What it is handed on by others is called as there. Not part of tidy(), which prunes the parameters then.
Module settle_params(Module module);

// The passes of passes.def in order, verified after each in debug builds.
Module tidy(Module module);

// Rate of every instruction of a function, given its params' rates. Indexed by Value.
std::vector<Rate> rates(const Module& module, const Function& function);

}  // namespace patina::ir
