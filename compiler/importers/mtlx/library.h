// Definitions of nodes that a document need not have.
#pragma once

#include "compiler/importers/mtlx/read/document.h"

namespace patina::importers::mtlx {

// A root with nodedefs and the node graphs that implement them.
const Element& standard_library();
bool is_of_library(const Element& node);

}  // namespace patina::importers::mtlx
