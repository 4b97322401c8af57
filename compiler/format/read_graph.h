// Makes a Graph of a JSON tree: reads every key and checks its JSON type and words. It reports unknown keys (with a
// suggestion), and keys that only a later version of Patina compiles. It resolves no name.
#pragma once

#include "compiler/base/diagnostics.h"
#include "compiler/format/graph.h"
#include "compiler/json/json.h"

namespace patina::format {

// "textures/wall.v1.graph.json" -> "wall.v1": the name of files that are made from a graph, and of the graph if it sets
// no name.
std::string name_of_file(std::string_view path);

// Returns a graph even after errors (the parts that could be read). `ast` owns the expressions. `expected`: the kind
// that the place requires (a material file, a sub-graph at a node, ...), or nothing if every kind is allowed.
std::shared_ptr<Graph> read_graph(const json::Json& json, std::string path, const SourceMap& sources,
                                  nodelang::Ast& ast, Diagnostics& diagnostics, std::optional<GraphKind> expected);

// Reads the value grammar: one JSON value at a port -> an expression. Null after an error.
const nodelang::Expr* read_value(const json::Json& json, const SourceMap& sources, nodelang::Ast& ast,
                                 Diagnostics& diagnostics);

// The location of a span, for diagnostics that only a renderer can find.
FileLocation place_of(const SourceMap& sources, Span span);

}  // namespace patina::format
