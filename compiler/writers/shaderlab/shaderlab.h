// The room `writers/shaderlab` makes one file of finished passes. It changes no value that a shader computes.
//
// The writer of ShaderLab, Unity's file format that holds all passes of a material: properties, passes with their
// state, and shared declarations. shader_file.h lists its parts; dialect.h prints the HLSL in it.
#pragma once

#include "compiler/output/writer.h"

namespace patina::writers::shaderlab {

extern const output::Writer kWriter;

}  // namespace patina::writers::shaderlab
