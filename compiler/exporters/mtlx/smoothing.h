// Edges that are smoothed over one pixel. MaterialX has no derivatives, so a document has these edges without
// smoothing.
//
//   saturate(0.5 - d / max(fwidth(d), 1e-6))   ->  the same with 1e-6
//   smoothstep(c - fwidth(x), c + fwidth(x), x)  ->  c <= x; either end may be c itself
#pragma once

#include <optional>

#include "compiler/exporters/mtlx/node_writer.h"

namespace patina::exporters::mtlx {

// The value of an operation that reads the width of a pixel as that of an edge; nothing: it does not.
std::optional<Ref> sharp_edge(NodeWriter& writer, ir::Value value);

}  // namespace patina::exporters::mtlx
