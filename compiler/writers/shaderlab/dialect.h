// Prints HLSL as a ShaderLab file for Unity's built-in render pipeline needs it: uniforms without blocks, textures
// through Unity's macros, entry functions `vert` and `frag` with Unity's appdata_full and a struct v2f that both share.
// It prints only the text of a stage; shader_file.h makes the file around it.
#pragma once

#include "compiler/languages/language.h"
#include "compiler/languages/print.h"

namespace patina::writers::shaderlab {

using languages::Printed;
using languages::PrintOptions;

ir::Module legalize(ir::Module module);
Printed print(const ir::Module& module, const PrintOptions& options);

// If all texels of a texture go to its decoder's follower, calls a foreign function that does both
// (decode_at_once.cpp).
ir::Module decode_at_once(ir::Module module);
// True if all reads of a texture use the samplers of others (share_samplers.cpp).
bool has_no_sampler(const ir::Module& stage, std::uint32_t texture);

// The keyword (shader_properties.cpp) of a bool property, or of an enum property's value: "_DETAIL", "_MODE_WET". A
// property whose name is in capitals is its own keyword; another gets "_ON" behind it, as Unity's Toggle does. Two
// properties have the keywords of Unity's own shaders.
std::string keyword_of(std::string_view property, std::string_view value);

}  // namespace patina::writers::shaderlab
