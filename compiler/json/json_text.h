// JSON tree -> text on one line, without comments: numbers keep the value and the kind (whole or not) that they were
// written with, strings are escaped no more than needed. Laying out a whole file is format.h's.
//
//   {"a":1.50,}   ->   { "a": 1.5 }
#pragma once

#include "compiler/json/json.h"

namespace patina::graph {

// Appends the text of `json`. Gives up, and returns false, once `out` has grown past `limit` bytes.
bool append_one_line(std::string& out, const Json& json, const SourceMap& sources,
                     std::size_t limit = std::string::npos);

// A quoted string.
void append_quoted(std::string& out, std::string_view text);

// The text of a JSON number without what changes nothing: "1.50E+02" -> "1.5e2".
std::string canonical_number(std::string_view raw);

}  // namespace patina::graph
