// Merges two versions of a graph or a scene by meaning: two people may change different values of one line. Both
// versions were made from a third text, the base. The result is the text of OURS with the changes of THEIRS; comments
// and order stay.
//
//   patina::MergeResult merged = patina::merge_graphs(compiler, base, ours, theirs, {.path = "art/rust.graph.json"});
//   if (merged.state == patina::MergeState::Clean) save(merged.text);   // it compiles
#pragma once

#include "patina/patina.h"

namespace patina {

// One of the three texts.
struct MergeInput {
    std::string name;  // for messages: "rust.graph.json (ours)"
    std::string text;  // of the base: empty if both sides added the file
};

// How two versions are merged.
struct MergeOptions {
    std::string path;  // of the graph: files that the graph names are searched in its folder
    std::string ours_label = "ours", theirs_label = "theirs";  // behind the conflict markers
    std::size_t marker_size = 7;                               // characters of a conflict marker: "<<<<<<<"
    CompileOptions compile{};                                  // only `include_dirs`, `files` and `limits` count
};

// The outcome of a merge.
enum class MergeState {
    Clean,       // the text has the changes of both sides, and compiles if the files that it names exist
    Conflicts,   // the text has conflict markers; or it is complete, but one side alone does not compile
    Unreadable,  // an input is no graph and no scene, memory ran out, or it was cancelled: the text is OURS
};

// What a merge makes.
struct MergeResult {
    MergeState state = MergeState::Unreadable;  // says what `text` is
    // The text between markers is OURS and THEIRS. If a user chooses the same side at all markers, the graph compiles.
    std::string text{};
    // Each conflict, with the changes of both sides; warnings of a clean merge; a note if comments of THEIRS are
    // missing.
    std::vector<Diagnostic> diagnostics{};
};

// The text of `ours` with the changes from `base` to `theirs`. The function compiles the merged text, to check it.
PATINA_API MergeResult merge_graphs(const Compiler& compiler, const MergeInput& base, const MergeInput& ours,
                                    const MergeInput& theirs, const MergeOptions& options);

}  // namespace patina
