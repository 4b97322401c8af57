// The room `capi` is the C face of the public classes: patina/patina_c.h. No exception leaves it.
//
// Reads the options of a compilation from JSON, as the C functions take them.
//
//   CompileOptions options;
//   std::vector<Diagnostic> wrong = read_options(compiler, "{ \"targets\": [\"glsl\"] }", options);
#pragma once

#include <string>
#include <vector>

#include "patina/patina.h"

namespace patina::capi {

// Sets what the text states. Returns the errors in the text; their locations are in a file called "options".
std::vector<Diagnostic> read_options(const Compiler& compiler, std::string text, CompileOptions& options);

}  // namespace patina::capi
