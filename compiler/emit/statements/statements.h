// The room `emit/statements` emits statements. It parses nothing and knows no graph.
//
// Statements -> structured SSA. A variable is its present value, so an assignment emits no instruction. An If yields
// the variables that its branches assigned, and a For carries them. In four files: statements.cpp, control_flow.cpp
// (if, for), loops.cpp (the loops of HLSL) and assignments.cpp (declarations, assignments).
#pragma once

#include "compiler/emit/emit.h"

namespace patina::emit {

inline constexpr std::string_view kReturnOnce = "assign to a variable here, and return it at the end of the function";
inline constexpr double kMaxIterations = 4096;  // of one loop whose rounds can be counted

// Emits list[first..]. Returns true if these always return; the value is then in `returned`.
bool statements(Emitter& emitter, const Statements& list, std::size_t first, Scope& scope, ir::Value& returned);
// The same for a block, whose variables are gone behind it, unless it returns.
bool block(Emitter& emitter, const Statements& list, Scope& scope, ir::Value& returned);
// `list` and `next`: the statements that follow the If, which are in its else if a branch returns.
bool if_statement(Emitter& emitter, const Stmt& stmt, const Statements& list, std::size_t next, Scope& scope,
                  ir::Value& returned);
void for_statement(Emitter& emitter, const Stmt& stmt, Scope& scope);
void declare(Emitter& emitter, const Stmt& stmt, Scope& scope);
void assign(Emitter& emitter, const Stmt& stmt, Scope& scope);
// Assigns to a variable or to a part of it.
bool store(Emitter& emitter, const Expr& target, Typed value, Scope& scope);
// An assignment of HLSL in an expression, and its value.
Typed assignment(Emitter& emitter, const Expr& expr, Scope& scope);
// The names of all variables that the statements assign to.
void collect_assigned(const Statements& list, const Scope& scope, std::vector<std::string_view>& names);
// A loop of HLSL (loops.cpp).
void loop_statement(Emitter& emitter, const Stmt& stmt, Scope& scope);
// The function's result and its out parameters as one value. Null `stmt`: the body ends without a return.
ir::Value return_value(Emitter& emitter, const Stmt* stmt, Scope& scope);

// Adds the iterations of a loop, or a call with those of its function, and reports when all of them are too many.
void count_rounds(Emitter& emitter, double rounds, Scope& scope, Span span);

}  // namespace patina::emit
