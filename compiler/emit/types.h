// Types that the language declares: structs. type(), which finds the type of any word, is public (emit.h).
#pragma once

#include "compiler/emit/emit.h"

namespace patina::emit {

// The IR struct of a declaration, with the extra members that Known lists. Made once in a module.
ir::Type structure(Emitter& emitter, const StructDecl& decl, const Declarations& home);

}  // namespace patina::emit
