// Reads the JSON of a reflection. Keys that this version does not know are skipped, because a later version may write
// more of them. What is missing or has another type is reported.
#pragma once

#include "compiler/base/diagnostics.h"
#include "patina/reflection.h"

namespace patina::reflection {

// The text starts at `base` in the sources. After errors, what could be read.
Reflection read_reflection(const SourceMap& sources, std::uint32_t base, Diagnostics& diagnostics);

}  // namespace patina::reflection
