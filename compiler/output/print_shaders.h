// Prints finished stages: a shader for each stage and language, or functions that are pasted into other shaders. The
// languages (compiler/languages) decide how the text looks.
#pragma once

#include "compiler/output/writer.h"

namespace patina::output {

// A file for each stage of each pass, in each language.
extern const Writer kStageFiles;
// Functions in place of passes (CompileOptions::Functions).
extern const Writer kFunctions;

}  // namespace patina::output
