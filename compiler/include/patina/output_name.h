// The name that the files made from a graph begin with. Not the graph's "name", which need not be one that files can
// have.
//
//   output_name("art/wall.v1.graph.json")   // "wall.v1"
#pragma once

#include <string>
#include <string_view>

#include "patina/export.h"

namespace patina {

// The last part of the path, without an ending of a graph or a scene: ".graph.json", ".subgraph.json",
// ".lighting.json", ".workflow.json", ".scene.json" or ".json". Every system takes its characters: control characters,
// those that Windows refuses (angle brackets, colon, quotation mark, bar, question mark, asterisk) and bytes that are
// not UTF-8 become '_', and so does the first letter of a name that Windows keeps for a device ("con", "com1"). If
// nothing is left, it is "graph". A long name is not shortened.
PATINA_API std::string output_name(std::string_view path);

}  // namespace patina
