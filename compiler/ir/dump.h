// The IR as text, for --dump, for the messages of verify() and for tests. The same module always gives the same text.
#pragma once

#include <string>

#include "compiler/ir/ir.h"

namespace patina::ir {

std::string dump(const Module& module);
std::string dump(const Module& module, const Function& function, bool with_rates = false);

// A remark on one instruction, or on the whole function if `value` is null.
struct Mark {
    Value value;
    std::string_view reason;
};
std::string dump(const Module& module, const Function& function, const Mark& mark);

}  // namespace patina::ir
