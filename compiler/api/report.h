// Makes public diagnostics of the internal ones, with their places resolved.
#pragma once

#include "compiler/base/diagnostics.h"
#include "patina/patina.h"

namespace patina {

std::vector<Diagnostic> to_public(const Diagnostics& diagnostics, const SourceMap& sources);

}  // namespace patina
