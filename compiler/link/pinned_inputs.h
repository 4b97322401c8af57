// What nodes that are pinned to the vertex stage hand over to the fragment stage: what is equal is handed over once,
// and their order follows from what they compute, whatever the nodes are called and wherever they stand.
//
//   made.vertex = ir::tidy(link_vertex(linked, pass, made.fragment, options));
//   if (order_pinned(linked, made.fragment, made.vertex)) ...   // the vertex stage is to be linked again
#pragma once

#include "compiler/link/link.h"

namespace patina::assemble {

// The fragment stage reads the first of those inputs that are equal. True if there were any: then it is to be tidied
// again, and the vertex stage to be linked again.
bool share_pinned(const Linked& linked, ir::Module& fragment, const ir::Module& vertex);

// Puts the fragment stage's inputs in order. True if that changed it: then the vertex stage is to be linked again.
bool order_pinned(const Linked& linked, ir::Module& fragment, const ir::Module& vertex);

}  // namespace patina::assemble
