// Turns what a Watcher has read of the machine's memory into values with the names that they have in the graphs.
#pragma once

#include "compiler/interpret/machine.h"
#include "compiler/link/program.h"

namespace patina::interpret {

// One row for each port, each once, or once for each light; see Interpreter::trace for the order.
std::vector<TracedValue> traced_values(const Program& program, const ir::Module& module, const Machine& machine,
                                       std::span<const Sighting> sightings);

}  // namespace patina::interpret
