// Orders the values that nodes pinned to the vertex stage send to the fragment stage. Equal values are sent once. The
// order follows from what they compute, and not from the names and places of the nodes.
//
//   made.vertex = ir::tidy(link_vertex(linked, pass, made.fragment, options));
//   if (order_pinned(linked, made.fragment, made.vertex)) ...   // the vertex stage is to be linked again
#pragma once

#include "compiler/link/link.h"

namespace patina::link {

// Replaces equal inputs of the fragment stage by the first of them. True if there were any: then the fragment stage
// must be tidied again, and the vertex stage linked again.
bool share_pinned(const Linked& linked, ir::Module& fragment, const ir::Module& vertex);

// Orders the fragment stage's inputs. True if the order changed: then the vertex stage must be linked again.
bool order_pinned(const Linked& linked, ir::Module& fragment, const ir::Module& vertex);

}  // namespace patina::link
