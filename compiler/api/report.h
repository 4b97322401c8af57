// Makes public diagnostics of the internal ones, with their places resolved.
#pragma once

#include "compiler/base/diagnostics.h"
#include "patina/patina.h"

namespace patina {

std::vector<Diagnostic> to_public(const Diagnostics& diagnostics, const SourceMap& sources);
// The same of one graph: what is in a file of the library names the graph in a note.
std::vector<Diagnostic> to_public(const Diagnostics& diagnostics, const SourceMap& sources, const SourceMap& library,
                                  std::string_view graph);

}  // namespace patina
