// What the passes of a user's file read, once what is not needed is gone: a target that nobody draws, a value of an
// object where none is drawn. Only here is known what a pass reads; it is told at the function.
#pragma once

#include "compiler/assemble/reflect.h"
#include "compiler/graph/session.h"

namespace patina::assemble {

void check_reads(graph::Session& session, const graph::Lowered& lowered, std::span<const LinkedPass> passes);

}  // namespace patina::assemble
