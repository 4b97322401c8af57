// Finds the changes in meaning between two graphs or scenes. Layout, comments, the order of nodes and of keys, and an
// editor's data under "ui" have no meaning. Nothing is compiled.
//
//   patina::GraphDiff diff = patina::diff_graphs({"old.graph.json", old_text}, {"new.graph.json", new_text});
//   for (const patina::GraphChange& change : diff.changes) show(change.path, change.before, change.after);
#pragma once

#include "patina/patina.h"

namespace patina {

// A text of a graph or a scene.
struct GraphVersion {
    std::string name;  // for messages
    std::string text;  // empty: the file did not exist
};

// What happened to a value.
enum class GraphChangeKind {
    Added,      // only the new version has the value
    Removed,    // only the old version has the value
    Changed,    // the value differs
    Renamed,    // `path` has the new name, `before` and `after` the names; links to it are no changes
    Reordered,  // a list whose order has a meaning: properties, passes
};

// A value that is not the same in both.
struct GraphChange {
    GraphChangeKind kind = GraphChangeKind::Changed;  // what happened to it
    // {"nodes", "rust", "in", "level"}: keys, and the ids and names of the objects in lists.
    std::vector<std::string> path{};
    std::string before{}, after{};                     // JSON on one line; empty: there is none
    FileLocation before_location{}, after_location{};  // line 0: there is none
};

// All changes between two versions.
struct GraphDiff {
    bool ok = false;                        // both are graphs or scenes
    std::vector<GraphChange> changes{};     // renames first
    std::vector<Diagnostic> diagnostics{};  // why a text is neither a graph nor a scene
};

// The changes that turn `before` into `after`. A text that did not exist has no values. Of the limits, only
// `source_bytes`, for both texts together, and `cancelled` count.
PATINA_API GraphDiff diff_graphs(const GraphVersion& before, const GraphVersion& after, const Limits& limits = {});

}  // namespace patina
