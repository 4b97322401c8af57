// Which pictures a folder's snapshots are: each NAME.snapshot.json, and each graph and scene that no snapshot of the
// folder shows. It reads the snapshot files and draws nothing.
//
//   FoundCases found = find_cases("art");   // art/rust.graph.json -> the case "rust", art/rust.reference.png
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/snapshot/snapshot_file.h"

namespace patina::runtime {

struct PlannedCase {
    std::string name{};    // "metal/rust", below the folder; with its variation: "metal/rust.deferred"
    std::string base{};    // without the variation
    std::string folder{};  // that was searched
    std::string file{};    // the snapshot file; without one the graph or scene
    std::string stem{};    // of its references: "art/metal/rust.deferred"
    RenderRequest request{};
    Tolerance tolerance{};
    bool text = false;
    std::map<std::string, FileLocation> places{};  // as ReadSnapshot's
    std::optional<Diagnostic> problem{};           // why it cannot be drawn

    std::string picture() const { return stem + ".reference.png"; }
    std::string shaders(std::string_view language) const { return stem + ".reference." + std::string(language); }
};

struct FoundCases {
    std::string error{};                 // the folder cannot be read, or holds none
    std::vector<PlannedCase> cases{};    // by name; no two have the same references
    std::vector<std::string> orphans{};  // reference pictures of no case
};

// Looks into folders below `folder`, too, but not into hidden ones.
FoundCases find_cases(const std::string& folder);

}  // namespace patina::runtime
