// Links a pass of a lowered material: two stages, tidied and numbered. Links the same without any folding for the CPU
// reference.
//
//   LinkedPass pass = link_pass(material, linked, linked.lowered.passes[0], session, result);
#pragma once

#include "compiler/link/link.h"
#include "compiler/link/program.h"

namespace patina::link {

// The material itself and its extra passes.
using Materials = std::vector<const resolve::Material*>;

// `result` gets the dumps. `left_out`: how many of its last targets it does not write.
LinkedPass link_pass(const resolve::Material& material, const Linked& linked, const lower::LoweredPass& pass,
                     const resolve::Session& session, Result& result, std::uint32_t left_out = 0);

// The vectors that a pass sends from the vertex stage to the fragment stage, without the position: those with a number,
// and those that the engine's text adds without a number.
struct Varyings {
    std::size_t numbered = 0, others = 0;
};
Varyings varyings_of(const LinkedPass& pass);
// Reports a pass that sends more vectors than the engine has room for.
void check_varyings(const LinkedPass& pass, resolve::Session& session);
// The lines that the pass and its functions add to the engine's file: those of both stages, each line once.
std::vector<ir::StageText> texts_of(const LinkedPass& pass);

// The interpreter's stages: lowered and linked without folding, and never tidied. Null after errors.
std::shared_ptr<const Program> keep_program(resolve::Session& session, const Materials& materials);

}  // namespace patina::link
