// HLSL as it stands in a ShaderLab file for Unity's built-in render pipeline: uniforms without blocks, textures by
// Unity's macros, entry functions `vert` and `frag` over Unity's appdata_full and a struct v2f that both share. Only a
// stage's text is made here; the file around it is engines/shaderlab/shader_file.h.
#pragma once

#include "compiler/languages/language.h"
#include "compiler/languages/print.h"

namespace patina::targets::shaderlab {

ir::Module legalize(ir::Module module);
Printed print(const ir::Module& module, const PrintOptions& options);

// Where all that is read of a texture goes on to its decoder's follower, a foreign function does both
// (decode_at_once.cpp).
ir::Module decode_at_once(ir::Module module);

// The keyword of a bool property, or of an enum property's value: "_DETAIL", "_MODE_WET". A property whose name is in
// capitals is its own keyword; another gets "_ON" behind it, as Unity's Toggle does.
std::string keyword_of(std::string_view property, std::string_view value);

}  // namespace patina::targets::shaderlab
