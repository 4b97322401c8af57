// What each op computes, as functions over four lanes: component by component (arithmetic.cpp), over vectors and
// matrices (vectors.cpp), and textures (sampling.cpp). In Float precision a float op computes in float, step by step,
// as a GPU does; half ops compute in double and are rounded once, by the caller.
//
//   Kernel add = arithmetic_kernel(Op::Add, Scalar::Float, Precision::Float);
#pragma once

#include "compiler/interpret/machine.h"

namespace patina::interpret {

// Null if the op is not component by component. `scalar`: of the operands.
Kernel arithmetic_kernel(ir::Op op, ir::Scalar scalar, Precision precision);
// Convert and Bitcast. `from` is never the same as `to`.
Kernel conversion_kernel(ir::Scalar from, ir::Scalar to, Precision precision);
Kernel bitcast_kernel(ir::Scalar from, ir::Scalar to);
// Select (shapes[0]: of the condition), Index (data: number of parts), and the ops over vectors, matrices and
// neighbouring pixels.
Kernel vector_kernel(ir::Op op, ir::Scalar scalar, Precision precision);
// `texture`: Texture2D or TextureCube.
Kernel sampling_kernel(ir::Op op, ir::Kind texture);

}  // namespace patina::interpret
