// Graphs with [foreign] code, which only one language can contain: their shaders are measured and checked in that
// language.
#pragma once

#include <string>

#include "patina/patina.h"

namespace patina::cli {

// Compiles the graph. If only HLSL can take its code, compiles it for that alone, and the error becomes a warning.
Result compile_if_foreign(const Compiler& compiler, const std::string& graph, CompileOptions options);

}  // namespace patina::cli
