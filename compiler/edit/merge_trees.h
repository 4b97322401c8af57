// The three-way merge of graphs by meaning. The result is the text of OURS with the edits that THEIRS made since BASE.
// Every value is decided for itself: if only one side changed it, that side's value holds. If both did, it is a
// conflict, and the wish says whose value the text gets.
//
//   MergedTrees merged = merge_trees(*base, *ours, *theirs, {.prefer = Side::Ours});
#pragma once

#include <set>

#include "compiler/edit/graph_text.h"

namespace patina::edit {

enum class Side { Ours, Theirs };

struct MergeWish {
    Side prefer = Side::Ours;
    std::set<Path> decided{};  // values that get the preferred side's, though only one side changed them
};

struct TreeConflict {
    enum class Kind { BothChanged, BothAdded, OursRemoved, TheirsRemoved, BothReordered };
    Kind kind = Kind::BothChanged;
    Path path{};
    std::vector<Path> added{};  // they replace inputs that a side removed, of a node that is a file
};

struct MergedTrees {
    std::string text;
    std::vector<TreeConflict> conflicts;  // of values that `decided` does not hold
};

// OURS and THEIRS are ok. Of what an editor keeps under "ui", OURS holds without a conflict.
MergedTrees merge_trees(const GraphText& base, const GraphText& ours, const GraphText& theirs, const MergeWish& wish);

}  // namespace patina::edit
