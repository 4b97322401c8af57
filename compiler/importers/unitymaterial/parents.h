// A material and those that it is a variant of, as one: what the material does not say, the next one above says.
#pragma once

#include "compiler/importers/unity/assets.h"
#include "compiler/importers/unitymaterial/material_file.h"

namespace patina::importers::unitymaterial {

// The error is that of whichever file cannot be read, or says that the material is its own parent. A parent that is not
// there is left in `parent`.
MaterialFile read_with_parents(const std::string& path, Assets& assets);

}  // namespace patina::importers::unitymaterial
