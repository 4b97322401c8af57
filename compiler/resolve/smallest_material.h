// Puts a lighting graph or a sub-graph into the smallest material that uses it, to check it alone.
#pragma once

#include "compiler/resolve/session.h"

namespace patina::resolve {

// Returns a material itself. Returns null, with an error, for a kind that no material can use directly.
std::shared_ptr<format::Graph> material_around(Session& session, std::shared_ptr<format::Graph> part);

}  // namespace patina::resolve
