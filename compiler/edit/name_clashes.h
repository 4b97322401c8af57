// What belongs to a conflict about a name. If each side has something else of one name, or one side has it no more,
// then the readers of the name are a part of the conflict: whoever takes a side gets readers that read what they read
// on that side.
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

// Adds the changes that go with those that clash: of nodes, properties and inputs that both sides added or that one
// side removed. What they bring may bring others.
void add_readers(const SameNames& names, const SideChanges& changes, std::set<Path>& clashing);

}  // namespace patina::edit
