// What the files of this room share of glslang.
#pragma once

#include "patina/validate.h"

namespace patina {

// SPIR-V that knows the lines of the text; empty if glslang does not accept it.
std::vector<std::uint32_t> spirv_with_lines(const Shader& shader);

}  // namespace patina
