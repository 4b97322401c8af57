// Functions of the language -> IR functions. semantic_function(), given_function() and plain_function() are public
// (emit.h).
#pragma once

#include "compiler/emit/arguments.h"

namespace patina::emit {

// The function for this width, precision and these constant arguments: from the store, or emitted now. Reports
// recursion at `call_span`. After an error, the result's type is Error.
const Instance& instantiate(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                            std::span<const Argument> arguments, unsigned width, bool half, Span call_span);

// The function's statements. Those of a library function are parsed now if they have not been parsed yet; a mistake in
// them is reported.
const Statements& sound_body_of(Emitter& emitter, const FunctionDecl& function);

}  // namespace patina::emit
