// Reports values that passes read and do not have, and code that they call and a language cannot take. The checks come
// after tidying, when unneeded reads and calls are gone.
#pragma once

#include "compiler/link/link.h"
#include "compiler/resolve/session.h"

namespace patina::link {

// Checks the passes of a user's file: for targets that no pass draws, and for values of an object in a pass that draws
// no objects. Reports at the function.
void check_reads(resolve::Session& session, const lower::Lowered& lowered, std::span<const LinkedPass> passes);

// A value that a stage reads although no included file declares it and the material does not have it.
struct Missing {
    std::string name;
    ir::Origin where;
};
std::optional<Missing> missing_in(const ir::Module& stage);
// True if the included files declare everything that the pass reads. Otherwise reports at the node; as a warning, if
// the pass is optional.
bool has_all(resolve::Session& session, const Linked& linked, const LinkedPass& pass);

// Reports the first call of a [foreign] function whose code the language of a target cannot contain. The report is at
// the function's node, or at `at` if no node leads to it.
void check_foreign(resolve::Session& session, std::span<const ir::Module* const> stages, Span at);
// The same for a reader that can take none: "the interpreter". False: there is one.
bool has_no_foreign(Diagnostics& diagnostics, const ir::Module& stage, std::string_view reader, Span at);

}  // namespace patina::link
