// Implicit conversions: which numbers convert to each other, and how operands come to have one type. convert() and
// expression_as() are public (emit.h).
//
//   unify({half3, float}, ...)     both become float3
//   unify({2, float3}, ...)        the literal becomes a float and is splatted
#pragma once

#include "compiler/emit/emit.h"

namespace patina::emit {

// Numbers from here on are infinite in 16 bits.
inline constexpr double kHalfLimit = 65520;

// True if an operator converts one scalar kind to the other: half becomes float.
bool joins(ir::Scalar a, ir::Scalar b);
// The first components of a vector, as a swizzle: "xy" for 2.
std::string_view swizzle_prefix(unsigned width);

// A literal with the given scalar kind. Reports one that is too large for a half.
Typed literal_as(Emitter& emitter, Typed value, ir::Scalar scalar, Scope& scope, Span span);
// As view_as(); or an array, of a list of its elements.
Typed array_or_value(Emitter& emitter, const Expr& expr, ir::Type wanted, Scope& scope, std::string_view what);
// As HLSL converts: any number to any other, and what is too long is cut. Not ok() if there is no such conversion.
Typed hlsl_cast(const Typed& value, ir::Type wanted, Scope& scope);
// Brings operands to one type: literals adapt, half becomes float, scalars are splatted. In HLSL, also as hlsl_cast():
// all get the later of their kinds (bool, int, uint, half, float) and the shortest of their widths. Reports what cannot
// be joined.
bool unify(Emitter& emitter, std::span<Typed> operands, Scope& scope, Span span, std::string_view op);
// A value of the graph in the precision of the node that reads it.
Typed at_border(Typed value, const Scope& scope);

}  // namespace patina::emit
