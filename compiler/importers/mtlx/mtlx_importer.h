// Imports MaterialX documents: a graph for each of their materials.
#pragma once

#include "compiler/importers/importer.h"

namespace patina::importers {

Importer mtlx_importer();

}  // namespace patina::importers
