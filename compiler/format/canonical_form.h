// Writes the canonical text of a graph file, so that the changes of two people can be merged. Keys are in the format's
// order, with two spaces of indentation. A value that fits on a line has one line; a list of objects has one line for
// each element. Comments stay with their values. The JSON must be readable; the graph may have errors.
//
//   FormattedText formatted = format_graph(sources, base, diagnostics);
//   if (formatted.ok) write(path, formatted.text);
#pragma once

#include "compiler/json/json.h"

namespace patina::format {

struct FormattedText {
    bool ok = false;
    std::string text;  // empty unless ok
};

// Formats the file whose text starts at `base` in the map. Formatting the result again gives the same text.
FormattedText format_graph(const SourceMap& sources, std::uint32_t base, Diagnostics& diagnostics);

// Lays out any JSON in the same way, with the keys in the order that they have.
std::string layout_json(const json::Json& root, const SourceMap& sources);
// The same for a value in a file: it starts at `column` of a line that is indented by `indent`.
std::string layout_value(const json::Json& value, const SourceMap& sources, std::size_t indent, std::size_t column);

}  // namespace patina::format
