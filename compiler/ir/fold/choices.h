// The part of simplify() for choices: within one side of a choice its condition is known, however deep.
//
//   c ? (c ? x : y) * z : w  =  c ? x * z : w
#pragma once

#include "compiler/ir/builder.h"

namespace patina::ir {

// Of a Select with these operands.
Value simplify_choice(Builder& b, Type type, std::span<const Value> args);

}  // namespace patina::ir
