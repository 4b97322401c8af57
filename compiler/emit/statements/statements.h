// Statements -> structured SSA. A variable is the value that it holds now, so an assignment emits no instruction; an If
// yields what its branches assigned, and a For carries it. In three files: statements.cpp, control_flow.cpp (if, for)
// and assignments.cpp (declarations, assignments).
#pragma once

#include "compiler/emit/emit.h"

namespace patina::emit {

inline constexpr std::string_view kReturnOnce = "assign to a variable here, and return it at the end of the function";

// Emits list[first..]. Returns true if these always return; the value is then in `returned`.
bool statements(Emitter& emitter, const Statements& list, std::size_t first, Scope& scope, ir::Value& returned);
// `list` and `next`: the statements that follow the If, which are in its else if a branch returns.
bool if_statement(Emitter& emitter, const Stmt& stmt, const Statements& list, std::size_t next, Scope& scope,
                  ir::Value& returned);
void for_statement(Emitter& emitter, const Stmt& stmt, Scope& scope);
void declare(Emitter& emitter, const Stmt& stmt, Scope& scope);
void assign(Emitter& emitter, const Stmt& stmt, Scope& scope);
// The function's result and its out parameters as one value. Null `stmt`: the body ends without a return.
ir::Value return_value(Emitter& emitter, const Stmt* stmt, Scope& scope);

// Adds the iterations of a loop, or a call with those of its function, and reports when all of them are too many.
void count_rounds(Emitter& emitter, double rounds, Scope& scope, Span span);

}  // namespace patina::emit
