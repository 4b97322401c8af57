// The room `ir/passes` rewrites linked stages. A pass never changes what a stage computes.
//
// The IR passes: rewrites of a linked stage. Each is a function from Module to Module in a file of its own. It rebuilds
// functions through the Builder, which folds again, and does not edit instructions in place (ir.h). tidy() runs the
// list of passes.def in its order. If a module has no stage, its exported functions stay, because other texts call
// them. If it has no exported functions either, functions that nothing calls stay.
//
//   Module small = tidy(std::move(linked));
#pragma once

#include <span>

#include "compiler/ir/ir.h"

namespace patina::ir {

// Drops instructions and parameters that nothing reads, functions that nothing calls, members of a function's result
// struct that no caller extracts, and values that a loop carries but nothing reads or changes. Stage inputs that
// nothing reads are dropped from the interface too. Blocks and texture slots keep their layout.
Module prune(Module module);

// If all values of a struct type have the same constant as a member, readers of the member use the constant.
Module settle_members(Module module);

// A call with constant arguments gets a copy of the callee for these constants, if the constants decide a branch or a
// loop or remove half of the callee's work. If the copy is only a constant, the call becomes that constant. If a member
// of the result is always the same constant, the member becomes that constant.
Module specialise(Module module);

// Replaces a call by the callee's body, if the callee is marked always_inline or has few operations, if a parameter
// contains something opaque (a texture), or if a part of the body could then move out of a light loop.
Module inline_calls(Module module);

// Removes operations that the calls of a function, or the result of a called function, make needless: a second
// normalisation of a unit vector, its length, and limits within which all arguments are already.
Module drop_needless(Module module);

// For an engine whose texture coordinates count from the bottom. Graphs count from the top: each read of such a
// coordinate is turned, and so is each coordinate that a texture is read at. Two turns cancel. Functions pass such
// coordinates on as the engine has them. Without them, does nothing.
Module turn_textures(Module module);

// Moves out of each loop what does not depend on it, derivatives and samples too, for these may always move outwards.
// After it a light loop computes only what depends on the light.
Module schedule(Module module);

// Moves the discards of the entry function behind the last derivative and the last sample that needs one, because a
// discarded pixel gives its neighbours no values. Not part of tidy(): for languages whose discard ends the pixel at
// once.
Module legalize_discard(Module module);

// Where keywords alone choose between two values, makes an If of the choice and moves into each branch what only that
// value needs. A text can then leave out the other branch, with its samples and derivatives. Not part of tidy(): for
// engines that have keywords.
Module branch_on_keywords(Module module);
// By value: 1 if it is computed from keywords and constants by comparisons and logic only.
std::vector<std::uint8_t> keyword_values(const Module& module, const Function& function);

// Drops members of structs that no function reads, in all functions alike, and what was computed for them alone.
// Somebody else reads the whole result of `entries`; `called` are called from outside, too, but only for members that
// are read here. The parameters and results of functions that are defined elsewhere stay whole. For stages that share
// the text of their functions: a member that one stage reads stays in all of them. Not part of tidy().
Module drop_members(Module module, std::span<const FunctionId> entries, std::span<const FunctionId> called);

// If all calls of a function have the same constant as an argument, the function uses it instead of the parameter. The
// same applies if all calls read the same part of a global for the argument, or have the same value as for another
// argument. A semantic parameter takes the name that it has in all callers. prune() then drops the parameters.
// Functions that other stages share stay as they are.
Module settle_params(Module module);

// The passes of passes.def in order; verified after each if is_verifying().
Module tidy(Module module);

// The rate of each instruction of a function, by Value. The rates of its parameters are given (Param::rate).
std::vector<Rate> rates(const Module& module, const Function& function);

}  // namespace patina::ir
