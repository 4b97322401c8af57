// Rounds numbers to what each scalar kind can hold. Every value of the interpreter is a double, and these functions
// bring a result back to its type. They share no code with the compiler's folding, so that the two can be compared.
//
//   to_half(0.1) == 0.0999755859375      wrap(Scalar::Int, 1LL << 31) == -2147483648.0
#pragma once

#include <cstdint>

#include "compiler/ir/types.h"
#include "patina/interpret.h"

namespace patina::interpret {

// To IEEE 754 binary16 and binary32: to nearest, ties to even. A number that is too large becomes infinite.
double to_half(double value);
double to_float(double value);

// The low 32 bits, read as an int or a uint.
double wrap(ir::Scalar scalar, std::int64_t value);

// The nearest value that the type can hold. A float beyond the range of integers becomes the nearest integer, and NaN
// becomes 0, as Direct3D defines the conversion; Vulkan leaves it open.
double fit(ir::Scalar scalar, Precision precision, double value);

}  // namespace patina::interpret
