// Names of a graph that changed: nodes, properties, and the inputs of a sub-graph or a lighting graph. A name is what
// other values read, so a rename changes every reader, and is not a removal and an addition.
//
//   for (const Rename& rename : find_renames(*base, *theirs)) ...
//   std::string renamed = apply(ours.sources, ours.base, rename_edits(ours, renames));
#pragma once

#include <span>

#include "compiler/edit/name_readers.h"
#include "compiler/edit/text_edits.h"

namespace patina::edit {

struct Rename {
    std::string list;  // "nodes", "properties", "inputs"; of a lighting graph "surface"
    std::string from, to;

    friend bool operator==(const Rename&, const Rename&) = default;
};

// A thing counts as renamed if only its name differs. If a property is read, a reader must also have the new name. Only
// for the graph of the file; a lighting graph in place has names of its own.
std::vector<Rename> find_renames(const GraphText& before, const GraphText& after);

// Changes each name and all that reads it. Names that the graph does not have change nothing.
std::vector<TextEdit> rename_edits(const GraphText& text, std::span<const Rename> renames);

// Names that both texts have, but for different things: two names were swapped, or a thing was renamed and another
// thing got its old name. A thing with another value keeps its name, if something reads it as before.
struct ReusedNames {
    std::vector<Rename> moves{};                       // as far as they are known by what the things hold
    std::set<std::pair<ReadAs, std::string>> taken{};  // the names that both texts have
    std::set<std::pair<ReadAs, std::string>> all{};    // and the others of the moves

    bool holds(const Rename& rename) const;
    friend bool operator==(const ReusedNames&, const ReusedNames&) = default;
};
// `renames`: those that find_renames() has found.
ReusedNames find_reused_names(const GraphText& before, const GraphText& after, std::span<const Rename> renames);

}  // namespace patina::edit
