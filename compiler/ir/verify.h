// Checks the rules of ir.h and ops.def: each operand is computed before it is used, types fit, blocks have the right
// shape, each function returns once, and callees come before their callers.
#pragma once

#include <string>

#include "compiler/ir/ir.h"

namespace patina::ir {

// Empty if the module is sound; otherwise the text of the first wrong function, with the wrong line marked and
// explained.
std::string verify(const Module& module);
// True in debug builds, and if the environment says PATINA_VERIFY=1, as it does for the tests.
bool is_verifying();
// Aborts with the text of verify() if the module is not sound. `stage`: what made the module.
void check(const Module& module, std::string_view stage);
inline void check_if_verifying(const Module& module, std::string_view stage) {
    if (is_verifying()) check(module, stage);
}

}  // namespace patina::ir
