// Turns a function of HLSL, in which statements jump out of branches, loops and the function, into a function without
// jumps. The statements after a jump go into an else, or behind a test of a bool that says that nothing has jumped.
//
//   for (...) { if (a) continue; b; }       ->   for (...) { if (a) { } else { b; } }
//   while (c) { b; if (a) break; }          ->   while (running && c) { b; if (a) { running = false; } }
//   if (a) { if (b) return 1; c; } return 2;
//     ->   if (a) { if (b) { result = 1; done = true; } if (!done) { c; } } if (!done) { result = 2; } return result;
#pragma once

#include "compiler/base/diagnostics.h"
#include "compiler/nodelang/ast.h"

namespace patina::nodelang {

// The function's body without Break and Continue. A Return is only where the node language allows it: at the end of the
// body, or at the end of each branch there.
// Code behind a jump is nested one level deeper; too many levels are reported.
void remove_jumps(FunctionDecl& function, Ast& ast, Diagnostics& diagnostics);

// No statement after the list is reached.
bool always_leaves(const Statements& list);

}  // namespace patina::nodelang
