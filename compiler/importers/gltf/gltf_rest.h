// Remarks on the parts of a glTF file that are neither materials nor cameras nor lights: what the scene shows of them,
// and what it does not.
#pragma once

#include "compiler/importers/gltf/gltf_pictures.h"
#include "runtime/gltf/gltf_model.h"

namespace patina::importers::gltf {

void report_rest(const Context& context, const runtime::GltfModel& model);

}  // namespace patina::importers::gltf
