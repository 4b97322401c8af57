// The part of simplify() for composites that are built and taken apart again: an extract from a construct is the part
// from which the composite was built. No arithmetic is simplified here.
//
//   extract(construct(a, b), 1) = b        swizzle(swizzle(v, yzx), xy) = swizzle(v, yz)
#pragma once

#include "compiler/ir/builder.h"

namespace patina::ir {

Value simplify_composite(Builder& b, Op op, Type type, std::span<const Value> args, std::uint32_t data);

// An op of vectors that repeat one scalar each is computed once: construct(a) * construct(b) = construct(a * b)
Value simplify_splat(Builder& b, Op op, Type type, std::span<const Value> args);

}  // namespace patina::ir
