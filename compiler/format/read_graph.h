// JSON tree -> Graph: reads every key, checks its JSON type and words, complains about what nobody reads (with a
// suggestion) and about what only a later version of Patina compiles. Resolves no name.
#pragma once

#include "compiler/base/diagnostics.h"
#include "compiler/format/graph.h"
#include "compiler/json/json.h"

namespace patina::graph {

// Returns a graph even after errors (what could be read); `ast` owns the expressions. `expected`: the kind that the
// place demands (a material file, a sub-graph at a node, ...), or nothing if any kind may stand there.
std::shared_ptr<Graph> read_graph(const Json& json, std::string path, const SourceMap& sources, nodelang::Ast& ast,
                                  Diagnostics& diagnostics, std::optional<GraphKind> expected);

// The value grammar: one JSON value at a port -> expression. Null after an error.
const nodelang::Expr* read_value(const Json& json, const SourceMap& sources, nodelang::Ast& ast,
                                 Diagnostics& diagnostics);

}  // namespace patina::graph
