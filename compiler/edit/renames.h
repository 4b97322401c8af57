// Names of a graph that changed: nodes, properties, and the inputs of a sub-graph or a lighting graph. A name is what
// other values read, so a rename changes every reader, and is not a removal and an addition.
//
//   for (const Rename& rename : find_renames(*base, *theirs)) ...
//   std::string renamed = apply(ours.sources, ours.base, rename_edits(ours, renames));
#pragma once

#include <span>

#include "compiler/edit/graph_text.h"
#include "compiler/edit/text_edits.h"

namespace patina::graph {

struct Rename {
    std::string list;  // "nodes", "properties", "inputs"; of a lighting graph "surface"
    std::string from, to;

    friend bool operator==(const Rename&, const Rename&) = default;
};

// A thing is the same under another name if only the name differs; a property that is read must have a reader that
// reads the new name. Only for the graph of the file; a lighting graph in place has names of its own.
std::vector<Rename> find_renames(const GraphText& before, const GraphText& after);

// Changes each name and all that reads it. Names that the graph does not have change nothing.
std::vector<TextEdit> rename_edits(const GraphText& text, std::span<const Rename> renames);

// The names of a list, in the order of the text.
std::vector<std::string_view> names_of(const Graph& graph, std::string_view list);

// All names that are read as those of the list are: a property and an input of a sub-graph are both `$name`.
std::vector<std::string_view> names_read_like(const Graph& graph, std::string_view list);

}  // namespace patina::graph
