// What changed in meaning between two texts. Layout, comments, the order of nodes and of keys, and what an editor keeps
// under "ui" are no meaning. A change has the smallest place that holds it: a port, a key of a property, a whole node
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

// Names are compared as they are: who wants renames to be no change applies rename_edits() before.
std::vector<TreeChange> find_changes(const GraphText& before, const GraphText& after);

// The indices of children of `value` in the order of `wanted`; those that `wanted` does not have keep their places.
std::vector<std::size_t> order_like(const TreeValue& value, const TreeValue& wanted);
bool is_in_order(const std::vector<std::size_t>& order);

}  // namespace patina::edit
