// Shader graphs of Unity (.shadergraph, .shadersubgraph) as graphs: docs/import.md.
#pragma once

#include "compiler/importers/importer.h"

namespace patina::importers {

Importer shadergraph_importer();

}  // namespace patina::importers
