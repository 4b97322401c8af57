// Prints GLSL 4.50 for Vulkan: separate textures and samplers, uniform blocks in std140, one `main` for each stage.
// OpenGL's GLSL differs: it has no sets, and joins textures with samplers.
#pragma once

#include "compiler/languages/language.h"
#include "compiler/languages/print.h"

namespace patina::languages::glsl {

extern const SpellingTable kSpellings;  // spelling.cpp

std::optional<ir::Module> legalize(const ir::Module& module);
Printed print(const ir::Module& module, const PrintOptions& options);

}  // namespace patina::languages::glsl
