// Functions that are stages of passes.
#pragma once

#include "compiler/nodelang/ast.h"

namespace patina::nodelang {

// True for the vertex or fragment function of a pass, which nothing calls.
bool is_stage(const FunctionDecl& function);

}  // namespace patina::nodelang
