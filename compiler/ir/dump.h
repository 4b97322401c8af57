// The IR as text, for --dump, for the verifier's messages and for tests. Deterministic; names no addresses.
#pragma once

#include "compiler/ir/ir.h"

#include <string>

namespace patina::ir {

std::string dump(const Module& module);
std::string dump(const Module& module, const Function& function, bool with_rates = false);

}  // namespace patina::ir
