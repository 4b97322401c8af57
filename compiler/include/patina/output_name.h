// The name with which the files made from a graph begin. It is not the graph's "name", which may be impossible as a
// file name.
//
//   output_name("art/wall.v1.graph.json")   // "wall.v1"
#pragma once

#include <string>
#include <string_view>

#include "patina/export.h"

namespace patina {

// The last part of the path, without an ending of a graph or a scene: ".graph.json", ".subgraph.json",
// ".lighting.json", ".workflow.json", ".scene.json" or ".json". Every system accepts the name. Control characters,
// characters that Windows refuses (angle brackets, colon, quotation mark, bar, question mark, asterisk) and bytes that
// are not UTF-8 become '_'. If Windows reserves the name for a device ("con", "com1"), its first letter becomes '_'. If
// nothing is left, the name is "graph". A long name is not shortened.
PATINA_API std::string output_name(std::string_view path);

}  // namespace patina
