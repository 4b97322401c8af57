// What a watcher saw in the machine's memory -> values with the names that the graphs give them.
#pragma once

#include "compiler/interpret/machine.h"
#include "compiler/link/program.h"

namespace patina::interpret {

// One row for each port, each once, or once for each light; see Interpreter::trace for the order.
std::vector<TracedValue> traced_values(const Program& program, const ir::Module& module, const Machine& machine,
                                       std::span<const Sighting> sightings);

}  // namespace patina::interpret
