// Names of what a shader shares with its host: members of uniform blocks, textures and samplers. They are settled once
// for a whole material, so that all of its stages and its reflection say the same, whatever else a stage declares.
//
//   name_interface(lowered.module);   // a property "texture" is `texture_` in every shader and in the reflection
#pragma once

#include "compiler/ir/ir.h"

namespace patina::assemble {

// A property keeps its name where a target language allows it and nothing else of the interface has it.
void name_interface(ir::Module& module);

}  // namespace patina::assemble
