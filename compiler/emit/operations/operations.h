// The room `emit/operations` emits what computes something of its operands. It emits no statement and no call of a
// node.
//
// Expressions that compute something from operands: members (members.cpp), operators (operators.cpp), and the functions
// and constructors of the language itself (intrinsics.cpp).
#pragma once

#include "compiler/emit/emit.h"

namespace patina::emit {

// object.name: an output, a struct's member, a function marked [member], or a swizzle.
Typed member(Emitter& emitter, Typed object, std::string_view name, Span span, Scope& scope);
// The elements that HLSL names by "_m01", "_12" or "_m00_m11"; empty: the word is none of these.
struct MatrixElement {
    std::uint32_t row = 0, column = 0;
};
std::vector<MatrixElement> matrix_elements(std::string_view word, ir::Type matrix);
// object[index]
Typed element(Emitter& emitter, const Expr& expr, Scope& scope);

Typed unary(Emitter& emitter, const Expr& expr, Scope& scope);
Typed binary(Emitter& emitter, const Expr& expr, Scope& scope);
Typed ternary(Emitter& emitter, const Expr& expr, Scope& scope);

// The call of an intrinsic function. `found` is false if there is none of that name.
Typed intrinsic(Emitter& emitter, std::string_view name, const Expr& expr, Scope& scope, bool& found);
// The names of all intrinsic functions, for suggestions.
std::vector<std::string_view> intrinsic_names();
// float3(a, b)
Typed constructor(Emitter& emitter, ir::Type wanted, const Expr& expr, Scope& scope);

// Notes that neighbouring pixels are read, and reports it where there are none. `samples`: because a texture is
// sampled; otherwise because of a derivative.
void need_quad(Emitter& emitter, Scope& scope, Span span, std::string_view what, bool samples);
// Warns if the operands are constants and the result is infinite or NaN. The builder does not fold these.
void warn_unless_finite(Emitter& emitter, ir::Op op, ir::Type type, std::span<const ir::Value> values,
                        const Scope& scope, Span span, std::string_view what);

}  // namespace patina::emit
