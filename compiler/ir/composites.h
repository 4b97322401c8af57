// The part of simplify() for composites that are put together and taken apart again: what is extracted from a construct
// is the part that was put in. No arithmetic is simplified here.
//
//   extract(construct(a, b), 1) = b        swizzle(swizzle(v, yzx), xy) = swizzle(v, yz)
#pragma once

#include "compiler/ir/builder.h"

namespace patina::ir {

Value simplify_composite(Builder& b, Op op, Type type, std::span<const Value> args, std::uint32_t data);

// An op of vectors that repeat one scalar each is computed once: construct(a) * construct(b) = construct(a * b)
Value simplify_splat(Builder& b, Op op, Type type, std::span<const Value> args);

}  // namespace patina::ir
