// What passes read and have not got, once what is not needed is gone: only here is known what a pass reads.
#pragma once

#include "compiler/output/reflect.h"
#include "compiler/resolve/session.h"

namespace patina::assemble {

// The passes of a user's file: a target that nobody draws, a value of an object where none is drawn. It is told at the
// function.
void check_reads(graph::Session& session, const graph::Lowered& lowered, std::span<const LinkedPass> passes);

// A value that a stage reads though no file of the tool declares it and it is not the material's.
struct Missing {
    std::string name;
    ir::Origin where;
};
std::optional<Missing> missing_in(const ir::Module& stage);
// Whether a tool can draw the pass. If not, it is told at the node: as a warning, if the pass is optional.
bool has_all(graph::Session& session, const Linked& linked, const LinkedPass& pass);

}  // namespace patina::assemble
