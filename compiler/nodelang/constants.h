// Constants of a file may be made of other constants. This finds constants that lead back to themselves, and constants
// that stand for so much text that reading them would not end in a reasonable time.
#pragma once

#include "compiler/nodelang/library.h"

namespace patina::nodelang {

// Reports such constants of `ast`, whose names are in `declarations`, and puts constants without a value in their
// place.
void check_constants(Ast& ast, Declarations& declarations, Diagnostics& diagnostics);

}  // namespace patina::nodelang
