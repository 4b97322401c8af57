// The part of simplify() for products with constants: the constant factors of a chain become one. Equal but for
// rounding, as long as no intermediate result overflows.
//
//   x * 4 * 6.28 = x * 25.12        x / 3 * 6 = x * 2        a * (x * pi / b) * (1 / pi) = a * (x / b)
#pragma once

#include "compiler/ir/builder.h"

namespace patina::ir {

// op: Mul or Div.
Value simplify_product(Builder& b, Op op, Type type, std::span<const Value> args);

}  // namespace patina::ir
