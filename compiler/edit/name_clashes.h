// What belongs to a conflict about a name. If the two sides have different things of one name, or one side no longer
// has the name, then the readers of the name are a part of the conflict. So a user who chooses one side gets readers
// that mean the same things as on that side.
//
//   clashing.insert({"nodes", "grain"});
//   add_readers(names, {by_ours, by_theirs}, clashing);
#pragma once

#include "compiler/edit/merge_names.h"

namespace patina::edit {

// What each side changed.
struct SideChanges {
    std::span<const TreeChange> ours, theirs;
};

// Adds the changes that belong to the conflicting ones: changes of nodes, properties and inputs that both sides added
// or one side removed. What they bring may bring others.
void add_readers(const SameNames& names, const SideChanges& changes, std::set<Path>& clashing);

}  // namespace patina::edit
