// Which changes of two sides made an error of their merge. The changes are sorted by their distance from the error:
// first the changes at its place, then those of names in its message, then those of values that its place reads, and so
// on.
//
//   Suspects suspects = find_suspects({error, *merged, {base, ours, theirs}}, changes_of_ours);
#pragma once

#include <span>

#include "compiler/edit/changes.h"
#include "patina/patina.h"

namespace patina::edit {

struct MergeError {
    const Diagnostic& error;
    const GraphText& merged;                   // which has the error
    std::span<const GraphText* const> others;  // texts that may hold what it lacks
};

// Indices of changes by their distance. The last distance holds all that no other one has.
using Suspects = std::vector<std::vector<std::size_t>>;
Suspects find_suspects(const MergeError& where, std::span<const TreeChange> changes);

}  // namespace patina::edit
