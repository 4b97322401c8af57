// A material whose shader is a shader graph: that graph, and a scene that shows it with the material's values.
#pragma once

#include "compiler/importers/unitymaterial/material_maker.h"

namespace patina::importers::unitymaterial {

// If the output folder has the graph already, that one is used, and none is written. A material that has chosen another
// render state than the graph's gets a graph of its own.
Imported make_instance(MaterialMaker& maker, const std::string& name, const Options& options);

}  // namespace patina::importers::unitymaterial
