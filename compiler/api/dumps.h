// What `patina compile --dump graph` shows: what the graph says, resolved, each node after those that it reads.
#pragma once

#include "compiler/resolve/material.h"

namespace patina {

void dump_graph(Result& result, const graph::Session& session, const graph::Material& material);

}  // namespace patina
