// Makes the text of `patina compile --dump graph`: the resolved graph, with each node after those that it reads.
#pragma once

#include "compiler/resolve/material.h"

namespace patina {

void dump_graph(Result& result, const resolve::Session& session, const resolve::Material& material);

}  // namespace patina
