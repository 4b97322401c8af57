// Checks every rule that ir.h and ops.def state: operand dominance, types, block shapes, one Return, callee order.
#pragma once

#include <string>

#include "compiler/ir/ir.h"

namespace patina::ir {

// Empty if the module is sound; otherwise the module's own text with the first offending line marked and explained.
std::string verify(const Module& module);
// In debug builds, and wherever the environment says PATINA_VERIFY=1, as it does for the tests.
bool is_verifying();
// Aborts with verify()'s text.
void check(const Module& module, std::string_view stage);
inline void check_if_verifying(const Module& module, std::string_view stage) {
    if (is_verifying()) check(module, stage);
}

}  // namespace patina::ir
