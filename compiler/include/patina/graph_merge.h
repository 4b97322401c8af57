// Merges two versions of a graph or a scene that were both made from a third one, by meaning: two people may change
// different values of one line. The result is the text of OURS with the changes of THEIRS; comments and order stay.
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
    std::string path;  // where the graph lies: files that it names are searched from there
    std::string ours_label = "ours", theirs_label = "theirs";  // behind the conflict markers
    std::size_t marker_size = 7;                               // characters of a conflict marker: "<<<<<<<"
    CompileOptions compile{};  // of these, only `include_dirs`, `files` and `limits` count
};

// What a merge has come to.
enum class MergeState {
    Clean,       // it holds the changes of both sides, and compiles if files that it names are there
    Conflicts,   // the text has conflict markers, or it is complete but a side does not compile by itself
    Unreadable,  // one of the three is no graph and no scene, there is no memory, or it was cancelled: the text is OURS
};

// What a merge makes.
struct MergeResult {
    MergeState state = MergeState::Unreadable;  // says what `text` is
    // The text between markers is OURS and THEIRS. Whoever takes the same side everywhere gets a graph that compiles.
    std::string text{};
    // Each conflict, with what both sides did; warnings of a clean merge; a note if it lacks comments of THEIRS.
    std::vector<Diagnostic> diagnostics{};
};

// The text of `ours` with the changes that made `theirs` of `base`. It compiles what it has merged.
PATINA_API MergeResult merge_graphs(const Compiler& compiler, const MergeInput& base, const MergeInput& ours,
                                    const MergeInput& theirs, const MergeOptions& options);

}  // namespace patina
