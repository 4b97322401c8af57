// The line of a message, with a caret under its place: the two lines that follow the message itself.
//
//   show_source(text, diagnostic, colors);   //     3 | "node": "Lrep"
//                                             //       |         ^~~~~~
#pragma once

#include <string>
#include <string_view>

#include "patina/diagnostic.h"

namespace patina {

// Appends nothing if the diagnostic has no line or no column. Any other numbers can be shown: a column behind the line
// is its end, and an end before the begin is one cell.
void show_source(std::string& text, const Diagnostic& diagnostic, bool colors);

// The text with U+FFFD for each byte that is not UTF-8 and each control character except tabs and ends of lines. Names
// come from files, and a terminal would execute control characters in them.
std::string printable(std::string_view text);

}  // namespace patina
