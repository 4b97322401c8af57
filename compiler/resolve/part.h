// A lighting graph or a sub-graph on its own, as the smallest material that uses it: so that it can be checked without
// one.
#pragma once

#include "compiler/resolve/session.h"

namespace patina::graph {

// A material is itself; null (and a complaint) for a kind that no material uses directly.
std::shared_ptr<Graph> material_around(Session& session, std::shared_ptr<Graph> part);

}  // namespace patina::graph
