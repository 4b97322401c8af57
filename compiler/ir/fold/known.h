// The part of simplify() that uses facts about operands (facts.h): limits that have no effect, vectors that are
// normalised already, and finite numbers minus themselves.
//
//   clamp(abs(x), 0, 5) = min(abs(x), 5)        normalize(-normalize(x)) = -normalize(x)
#pragma once

#include "compiler/ir/builder.h"
#include "compiler/ir/fold/facts.h"

namespace patina::ir {

Value simplify_known(Builder& b, Op op, Type type, std::span<const Value> args);

// The operand that a limit or a Normalize does not change; none if it may change the operand.
Value unchanged_operand(const FactsOf& facts, Op op, std::span<const Value> args);

}  // namespace patina::ir
