// The part of simplify() that is about taking composites apart and putting them together: what is extracted from what
// was just constructed is the part itself, and so on. Moves values, computes none.
//
//   extract(construct(a, b), 1) = b        swizzle(swizzle(v, yzx), xy) = swizzle(v, yz)
#pragma once

#include "compiler/ir/builder.h"

namespace patina::ir {

Value simplify_composite(Builder& b, Op op, Type type, std::span<const Value> args, std::uint32_t data);

}  // namespace patina::ir
