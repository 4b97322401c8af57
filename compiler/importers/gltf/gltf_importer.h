// Models in glTF 2.0 (.glb, .gltf): a graph for each material, their textures, and a scene that draws the model. The
// meshes stay in the file, and the scene names them.
#pragma once

#include "compiler/importers/importer.h"

namespace patina::importers {

Importer gltf_importer();

}  // namespace patina::importers
