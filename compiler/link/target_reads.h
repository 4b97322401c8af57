// How a pass reads the targets of the picture that other passes draw: only at its own pixel, or also at other pixels.
// Targets that hold only a part of the picture can be read at the own pixel alone, and through a function
// (lower::Wraps).
//
//   wrap_reads(function, lowered.picture_reads, place_in_tile);
//   made.reads_elsewhere = reads_elsewhere(linked, pass, fragment, vertex);
#pragma once

#include <set>
#include <span>

#include "compiler/link/link.h"

namespace patina::link {

// Puts a call of `wrap` around the coordinates at which the function samples one of the globals. In place, so that
// probes stay. Where a function gets the texture as a parameter, nothing changes: reads_elsewhere() finds that.
void wrap_reads(ir::Function& function, const std::set<std::uint32_t>& globals, ir::FunctionId wrap, ir::Type type);

// True if the pass may read a target of the picture at other pixels than its own, or asks for its size. `fragment`,
// `vertex`: its tidied stages.
bool reads_elsewhere(const Linked& linked, const lower::LoweredPass& pass, const ir::Module& fragment,
                     const ir::Module& vertex);

// How many of the last [optional] targets of a pass none of the material's linked passes reads.
std::uint32_t unread_targets(const lower::LoweredPass& pass, std::span<const LinkedPass> passes);

}  // namespace patina::link
