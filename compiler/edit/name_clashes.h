// What belongs to a conflict about a name. If each side has something else of one name, or one side has it no more,
// then the readers of the name are a part of the conflict: whoever takes a side gets readers that read what they read
// on that side.
//
//   for (const TreeConflict& conflict : merged.conflicts) add_readers(names, changes, conflict, clashing);
#pragma once

#include "compiler/edit/merge_names.h"

namespace patina::graph {

// What each side changed.
struct SideChanges {
    std::span<const TreeChange> ours, theirs;
};

// The changes that go with a conflict about a whole node, property or input. Of other conflicts: none.
void add_readers(const SameNames& names, const SideChanges& changes, const TreeConflict& conflict,
                 std::set<Path>& clashing);
// The changes that go with something that one side renamed and the other one removed.
void add_readers(const SameNames& names, const SideChanges& changes, const LostName& lost, std::set<Path>& clashing);

}  // namespace patina::graph
