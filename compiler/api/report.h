// Internal diagnostics -> the public ones, with places resolved.
#pragma once

#include "compiler/base/diagnostics.h"
#include "patina/patina.h"

namespace patina {

std::vector<Diagnostic> to_public(const Diagnostics& diagnostics, const SourceMap& sources);

}  // namespace patina
