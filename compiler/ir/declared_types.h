// The type rules of ops whose result type is declared (TypeRule::Declared), one function for each op: composites,
// leaves, conversions, calls. verify.cpp has the rules that need more than the instruction: blocks and yields.
#pragma once

#include <string>

#include "compiler/ir/ir.h"

namespace patina::ir {

// Empty if operands, data and type fit each other; otherwise what is wrong. Operand indices must be in range.
std::string declared_type_error(const Module& module, const Function& function, const Inst& inst);

// True if every struct and array that the type refers to exists and numbers have a possible shape.
bool is_possible(const Module& module, Type type);

}  // namespace patina::ir
