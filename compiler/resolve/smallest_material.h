// Puts a lighting graph or a sub-graph into the smallest material that uses it, so that it can be checked on its own.
#pragma once

#include "compiler/resolve/session.h"

namespace patina::resolve {

// Returns a material itself. Returns null, with an error, for a kind that no material can use directly.
std::shared_ptr<format::Graph> material_around(Session& session, std::shared_ptr<format::Graph> part);

}  // namespace patina::resolve
