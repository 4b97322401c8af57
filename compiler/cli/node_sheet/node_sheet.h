// `patina nodes --sheet`: the nodes of the library as one page of pictures, by category.
//
// A node's picture is that of its page in the reference: a pattern, a plot, or bands of colours, drawn anew. A value of
// the mesh or the camera is drawn on a ball. What has no picture shows its formula, or a test.
#pragma once

#include <span>
#include <string>

#include "compiler/cli/console.h"
#include "patina/patina.h"

namespace patina::cli {

// Writes the page; `output` is its file. It complains about what is wrong.
Exit write_node_sheet(const Console& console, const Compiler& compiler, std::span<const NodeInfo* const> nodes,
                      const std::string& output);

}  // namespace patina::cli
