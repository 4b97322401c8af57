// The comments of a merge. Those of OURS stay. A comment that only THEIRS changed becomes that of THEIRS.
//
//   text = with_comments(names, std::move(text));
#pragma once

#include <utility>

#include "compiler/edit/merge_names.h"

namespace patina::edit {

// The merged text with comments of THEIRS. A value gets them if OURS left its comments as in BASE, or if the merge took
// the value from THEIRS instead of another one in OURS.
std::string with_comments(const SameNames& names, std::string merged);

// The comments that only THEIRS has and the merged text lacks, each with the value that has it.
std::vector<std::pair<std::string, Span>> lost_comments(const GraphText& base, const GraphText& theirs,
                                                        const std::string& merged);

}  // namespace patina::edit
