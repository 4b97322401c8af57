// A pass of a lowered material as its two stages: linked, tidied and numbered; and, for the CPU reference, the same
// without any of the folding.
//
//   LinkedPass pass = link_pass(material, linked, linked.lowered.passes[0], true, result, options);
#pragma once

#include "compiler/link/link.h"
#include "compiler/link/program.h"
#include "compiler/lower/lower.h"
#include "compiler/output/reflect.h"

namespace patina {

// The material itself, and passes that it adds.
using Materials = std::vector<const graph::Material*>;

// `result` and `options`: where the dumps go, and which.
assemble::LinkedPass link_pass(const graph::Material& material, const assemble::Linked& linked,
                               const graph::LoweredPass& pass, bool optimise, Result& result,
                               const CompileOptions& options);
// Reports a pass that hands more from vertices to pixels than there is room for.
void check_varyings(const assemble::LinkedPass& pass, graph::Session& session);

// The interpreter's stages: lowered and linked without folding, and never tidied. Null after errors.
std::shared_ptr<const Program> keep_program(graph::Session& session, const Materials& materials);

}  // namespace patina
