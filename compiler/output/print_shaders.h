// Finished stages as texts: a shader for each stage and language, or functions that are pasted into other shaders. What
// the texts say is the languages' (compiler/languages).
#pragma once

#include "compiler/output/writer.h"

namespace patina::output {

// A file for each stage of each pass, in each language.
extern const Writer kStageFiles;
// Functions instead of passes (CompileOptions::functions).
extern const Writer kFunctions;

}  // namespace patina::output
