// What changed in meaning between two texts. Layout, comments, the order of nodes and of keys, and what an editor keeps
// under "ui" are no meaning. A change has the smallest path that contains it: a port, a key of a property, a whole node
// that was added.
//
//   for (const TreeChange& change : find_changes(*before, *after)) print(to_string(change.path));
#pragma once

#include "compiler/edit/graph_text.h"

namespace patina::edit {

struct TreeChange {
    Path path;
    TreeValue before{}, after{};  // neither: no such value
    bool is_order = false;        // of an array whose order has a meaning
};

// Names are compared without renames. If renames should be no changes, apply rename_edits() first.
std::vector<TreeChange> find_changes(const GraphText& before, const GraphText& after);

// The indices of children of `value` in the order of `wanted`. Children that `wanted` does not have stay where they
// are.
std::vector<std::size_t> order_like(const TreeValue& value, const TreeValue& wanted);
bool is_in_order(const std::vector<std::size_t>& order);

}  // namespace patina::edit
