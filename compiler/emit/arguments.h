// The values of a function's parameters at one call: arguments, defaults, constants, and the width of floatN.
#pragma once

#include "compiler/emit/emit.h"

namespace patina::emit {

struct Argument {
    Typed value;
    std::optional<double> constant;  // of a const parameter
    // Of a const parameter whose `value` is known only when the shader runs: the constant that each value selects.
    std::vector<double> choices{};
};

// Appends one Argument for each parameter (null in `arguments`: its default); false after an error.
bool gather_arguments(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                      std::span<const Expr* const> arguments, Scope& scope, Span span, std::vector<Argument>& gathered);
Argument const_argument(Emitter& emitter, const ParamDecl& param, const Declarations& home, const Expr& expr,
                        Scope& scope);
// A parameter's default. `port`: the port that is left open by it, for messages.
Typed default_value(Emitter& emitter, const Expr& expr, const Declarations& home, Scope& scope, ir::Type wanted,
                    const OpenPort* port = nullptr);
// 0 if the function has no floatN.
unsigned deduce_width(const FunctionDecl& function, std::span<const Argument> arguments);

}  // namespace patina::emit
