// Merges three texts: finds renames, merges the trees, checks the result, and finds out which changes of both sides do
// not go together. It compiles through a function that it is given.
//
//   MergeResult merged = merge_texts(sides, options, [&](const std::string& text) { return errors_of(text); });
#pragma once

#include <functional>

#include "compiler/edit/merge_report.h"
#include "patina/graph_merge.h"

namespace patina::edit {

// The errors of a graph with this text.
using MergeCheck = std::function<std::vector<Diagnostic>(const std::string& text)>;

// OURS and THEIRS are ok.
MergeResult merge_texts(const Sides& original, const MergeOptions& options, const MergeCheck& check);

// The text of one side, because the other side changed nothing.
MergeResult take_text(const Sides& original, const std::string& text, const MergeCheck& check);

}  // namespace patina::edit
