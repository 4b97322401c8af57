// Functions of the language -> IR functions. semantic_function(), given_function() and plain_function() are public
// (emit.h).
#pragma once

#include <functional>

#include "compiler/emit/arguments.h"

namespace patina::emit {

// The function for this width, precision and these constant arguments: from the store, or emitted now. Reports
// recursion at `call_span`. After an error, the result's type is Error.
const Instance& instantiate(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                            std::span<const Argument> arguments, unsigned width, bool half, Span call_span);

// Declares the parameters in the scope of a function's body, and sets the scope's result: the function's own result, or
// a struct of all outputs. Then the names of the members are returned. `value_of` is asked for each parameter that is
// neither an output nor const. After an error, the result is Error.
const Outputs* begin_body(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                          std::span<const Argument> arguments, const std::string& name, Scope& scope,
                          const std::function<ir::Value(const ParamDecl&, ir::Type)>& value_of);

// The function's statements. The statements of a library function are parsed now if they have not been parsed yet;
// their errors are reported.
const Statements& sound_body_of(Emitter& emitter, const FunctionDecl& function);

// The text of a [foreign] function with a body, and of the functions of its file that it mentions (foreign_code.cpp).
// Reports what such a function cannot have: `types` are those of its parameters.
ir::ForeignCode foreign_code(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                             std::span<const ir::Type> types);
// True if a word of the text needs the neighbouring pixels.
bool needs_quad(const ir::ForeignCode& code);

}  // namespace patina::emit
