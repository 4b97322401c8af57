// Settles the names that a shader shares with its host: members of uniform blocks, textures and samplers. This is done
// once for a material. So all its stages and its reflection use the same names, even if some stage declares other
// names.
//
//   name_interface(lowered.module);   // a property "texture" is `texture_` in every shader and in the reflection
#pragma once

#include "compiler/ir/ir.h"

namespace patina::link {

// A property keeps its name if every target language allows it and no other part of the interface has it.
void name_interface(ir::Module& module);

}  // namespace patina::link
