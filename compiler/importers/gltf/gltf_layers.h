// The layers that the extensions KHR_materials_* put on a glTF material, each as inputs of the lighting model. A layer
// that is switched off leaves nothing in the graph.
#pragma once

#include "compiler/importers/gltf/gltf_material.h"

namespace patina::importers::gltf {

void set_layers(MaterialGraph& graph, Object& material, const MaterialUse& use);
// Reports all of them as without effect, with the reason.
void leave_layers(Object& material, const std::string& why);

}  // namespace patina::importers::gltf
