// JSON tree -> text on one line, without comments. A number keeps its value and its kind (whole or not). A string is
// escaped only where JSON requires it. compiler/format lays out whole files.
//
//   {"a":1.50,}   ->   { "a": 1.5 }
#pragma once

#include "compiler/json/json.h"

namespace patina::json {

// Appends the text of `json`. Stops and returns false as soon as `out` is longer than `limit` bytes.
bool append_one_line(std::string& out, const Json& json, const SourceMap& sources,
                     std::size_t limit = std::string::npos);

// A quoted string.
void append_quoted(std::string& out, std::string_view text);

// The shortest spelling of the same JSON number: "1.50E+02" -> "1.5e2".
std::string canonical_number(std::string_view raw);

}  // namespace patina::json
