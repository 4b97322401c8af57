// The name that the files made from a graph begin with. Not the graph's "name", which need not be one that files can
// have.
//
//   output_name("art/wall.v1.graph.json")   // "wall.v1"
#pragma once

#include <string>
#include <string_view>

#include "patina/export.h"

namespace patina {

// The last part of the path without ".graph.json", or without its last ending.
PATINA_API std::string output_name(std::string_view path);

}  // namespace patina
