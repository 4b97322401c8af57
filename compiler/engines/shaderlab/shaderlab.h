// The writer of ShaderLab, Unity's format of a file that holds all passes of a material: properties, passes with their
// state, and what the passes share. Its parts are listed in shader_file.h; the HLSL in it is dialect.h.
#pragma once

#include "compiler/output/writer.h"

namespace patina::engines::shaderlab {

extern const output::Writer kWriter;

}  // namespace patina::engines::shaderlab
