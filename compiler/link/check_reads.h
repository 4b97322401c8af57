// What passes read and do not have. It is known only when what they do not need is gone.
#pragma once

#include "compiler/link/link.h"
#include "compiler/resolve/session.h"

namespace patina::assemble {

// The passes of a user's file: a target that nobody draws, a value of an object where none is drawn. Reports at the
// function.
void check_reads(graph::Session& session, const graph::Lowered& lowered, std::span<const LinkedPass> passes);

// A value that a stage reads though no included file declares it and it is not the material's.
struct Missing {
    std::string name;
    ir::Origin where;
};
std::optional<Missing> missing_in(const ir::Module& stage);
// Whether the included files have all that the pass reads. If not, reports at the node: as a warning, if the pass is
// optional.
bool has_all(graph::Session& session, const Linked& linked, const LinkedPass& pass);

}  // namespace patina::assemble
