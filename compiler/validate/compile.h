// What the files of this room share of glslang.
#pragma once

#include "patina/validate.h"

namespace patina {

// Sets the place in the graph that a line of the shader comes from, and adds the line as a note.
void locate(Diagnostic& d, const Shader& shader, int line);

// SPIR-V that knows the lines of the text; empty if glslang does not accept it.
std::vector<std::uint32_t> spirv_with_lines(const Shader& shader);

}  // namespace patina
