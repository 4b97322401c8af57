// The canonical text of a graph file, so that two people's changes merge: keys in the format's order, two spaces, on
// one line what fits there, one element of a list of objects per line, comments where they were. It needs JSON that can
// be read, not a graph without errors.
//
//   FormattedText formatted = format_graph(sources, base, diagnostics);
//   if (formatted.ok) write(path, formatted.text);
#pragma once

#include "compiler/json/json.h"

namespace patina::graph {

struct FormattedText {
    bool ok = false;
    std::string text;  // empty unless ok
};

// The file whose text starts at `base` in the map. Formatting what it returns gives the same text again.
FormattedText format_graph(const SourceMap& sources, std::uint32_t base, Diagnostics& diagnostics);

// The same layout for any JSON, its keys in the order in which they are.
std::string layout_json(const Json& root, const SourceMap& sources);

}  // namespace patina::graph
