// The last look at an imported graph, which all importers of node graphs share: the compiler reads it, and what it
// refuses becomes a constant. So whatever is imported passes `patina check`.
//
//   const std::string error = refuse_invalid(graph, files, put_constant, report);
//   if (!error.empty()) ...      // the compiler refuses what has no place for a constant: nothing is written
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "compiler/importers/graph_writer.h"
#include "compiler/importers/importer.h"
#include "compiler/importers/types.h"
#include "patina/patina.h"

namespace patina::importers {

// The library, of which graphs name nodes.
const Compiler& library();

// Puts a constant in the place of the value that the compiler refuses: of an input of the surface, an input of a node,
// or an expression. `type`: of the surface's input, or of the expression. False: there is no such place, or the
// constant is there already.
bool has_constant(GraphFile& graph, const Diagnostic& wrong, terms::Type type);

// Has the compiler read the graph until it refuses nothing more. `files`: that the graph reads. `put_constant`: puts a
// constant in the place of what is wrong; false: there is no such place. `report`: notes why. A node gets a note, too.
// Returns nothing, or what is wrong that has no such place: "'uv.tiling' would not be valid: ...".
std::string refuse_invalid(GraphFile& graph, std::span<const TextFile> files,
                           const std::function<bool(const Diagnostic&)>& put_constant,
                           const std::function<void(const Diagnostic&, const std::string& reason)>& report);

}  // namespace patina::importers
