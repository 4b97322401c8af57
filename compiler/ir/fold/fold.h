// The room `ir/fold` computes ops of constants. It makes no instructions of its own.
//
// What an op gives for constant operands, as numbers: no instruction is made here. evaluate() computes the meaning of
// an op, NaN and infinity included, also for the tests of the identities. fold_constant() (builder.h) refuses results
// that the builder must not fold. The interpreter has arithmetic of its own, so that the two can be compared.
//
//   round_to(Scalar::Half, 0.1) == 0.0999755859375
#pragma once

#include "compiler/ir/ir.h"

namespace patina::ir {

// The nearest value that the scalar kind can hold; integers wrap to 32 bits. A number that would become infinite stays
// as it is.
double round_to(Scalar scalar, double value);

// Components of the result, or false for ops that are not arithmetic. `types` and `operands` are one per operand.
bool evaluate(Op op, Type type, std::span<const Type> types, std::span<const std::span<const double>> operands,
              std::uint32_t data, std::vector<double>& out);

}  // namespace patina::ir
