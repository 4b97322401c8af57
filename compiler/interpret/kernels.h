// What each op computes, as functions over four lanes: component by component (arithmetic.cpp), over vectors and
// matrices (vectors.cpp), and of textures (sampling.cpp). In Float precision a float op computes in float at each step,
// as a GPU does. A half op computes in double, and the caller rounds the result once.
//
//   Kernel add = arithmetic_kernel(Op::Add, Scalar::Float, Precision::Float);
#pragma once

#include "compiler/interpret/machine.h"

namespace patina::interpret {

// Null if the op does not work component by component. `scalar`: of the operands.
Kernel arithmetic_kernel(ir::Op op, ir::Scalar scalar, Precision precision);
// Convert and Bitcast. `from` is never the same as `to`.
Kernel conversion_kernel(ir::Scalar from, ir::Scalar to, Precision precision);
Kernel bitcast_kernel(ir::Scalar from, ir::Scalar to);
// The kernels of Select (shapes[0] is the condition's), of Index (data is the number of parts), and of the ops over
// vectors, matrices and neighbouring pixels.
Kernel vector_kernel(ir::Op op, ir::Scalar scalar, Precision precision);
// `texture`: the kind of the first operand.
Kernel sampling_kernel(ir::Op op, ir::Kind texture);

}  // namespace patina::interpret
