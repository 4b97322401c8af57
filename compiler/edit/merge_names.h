// The renames of two sides of a merge. If one side renamed a node, the other side's text gets the new name, too. So the
// other side's changes of the node, and its new links to the node, are merged with the rename.
//
//   SameNames same = unify_names(std::move(base), std::move(ours), std::move(theirs));
#pragma once

#include <memory>

#include "compiler/edit/merge_trees.h"
#include "compiler/edit/renames.h"

namespace patina::edit {

struct NameConflict {
    std::string list, from, ours, theirs;  // both sides renamed one thing
};

// One side renamed a thing that the other side removed.
struct LostName {
    std::string list, from, to;
    Side renamed_by;
};

struct SameNames {
    std::unique_ptr<GraphText> base, ours, theirs;  // with the names of the result
    std::vector<Rename> from_ours, from_theirs;     // that were carried into the other texts
    std::vector<NameConflict> conflicts;            // the texts have the name of OURS
    std::vector<LostName> lost;                     // the base has the new name
    // Names that one side now uses for other things, if the other side did not do the same.
    ReusedNames reused_by_ours, reused_by_theirs;
    // Renames that were not carried over, because the other text has such a name.
    std::vector<Rename> held_of_ours, held_of_theirs;
};

SameNames unify_names(std::unique_ptr<GraphText> base, std::unique_ptr<GraphText> ours,
                      std::unique_ptr<GraphText> theirs);

// A path by the names that a thing had before the renames.
Path before_renames(Path path, std::span<const Rename> renames);

}  // namespace patina::edit
