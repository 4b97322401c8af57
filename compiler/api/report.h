// Makes public diagnostics of the internal ones, with their places resolved.
#pragma once

#include "compiler/base/cancellation.h"
#include "compiler/base/diagnostics.h"
#include "patina/patina.h"

namespace patina {

std::vector<Diagnostic> to_public(const Diagnostics& diagnostics, const SourceMap& sources);
// A diagnostic of no place.
template <class... Words>
Diagnostic diagnostic_of(Code code, const Words&... words) {
    Diagnostics diagnostics;
    diagnostics.report(code, {}, words...);
    return to_public(diagnostics, SourceMap()).front();
}
inline Diagnostic diagnostic_of(const Stopped& stopped) {
    return diagnostic_of(Code::Cancelled, stopped.why.empty() ? "" : ": " + stopped.why);
}

// Does the work on texts that the program gives, within its limits `source_bytes` and `cancelled`. A Result has
// diagnostics, which then are the only thing in it.
template <class Result, class Work>
Result within(const Limits& limits, std::size_t bytes, const Work& work) {
    if (bytes > limits.source_bytes) {
        Result refused;
        refused.diagnostics.push_back(
            diagnostic_of(Code::OverBudget, "bytes of source text", bytes, limits.source_bytes));
        return refused;
    }
    const Cancellation cancellation(limits.cancelled);
    try {
        return work();
    } catch (const Stopped& stopped) {
        Result cancelled;
        cancelled.diagnostics.push_back(diagnostic_of(stopped));
        return cancelled;
    }
}
// The same of one graph: what is in a file of the library names the graph in a note.
std::vector<Diagnostic> to_public(const Diagnostics& diagnostics, const SourceMap& sources, const SourceMap& library,
                                  std::string_view graph);

}  // namespace patina
