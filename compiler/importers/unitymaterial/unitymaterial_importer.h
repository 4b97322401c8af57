// Materials of Unity (.mat): a graph, or for a material of a shader graph that graph and a scene with the values.
#pragma once

#include "compiler/importers/importer.h"

namespace patina::importers {

Importer unitymaterial_importer();

}  // namespace patina::importers
