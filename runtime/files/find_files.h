// The files of a folder and of the folders below it.
//
//   Outcome<std::vector<std::string>> files = files_below("art");   // "art/metal/rust.graph.json", ...
#pragma once

#include <string>
#include <vector>

#include "runtime/outcome.h"

namespace patina::runtime {

// Normal paths that begin with the folder's, sorted. Not hidden files, nor those of hidden folders or of folders behind
// symbolic links; no FIFOs and devices. A folder that is removed meanwhile has none. A failure says what is wrong.
Outcome<std::vector<std::string>> files_below(const std::string& folder);
// The folder itself, and the folders that files_below() looks into.
Outcome<std::vector<std::string>> folders_below(const std::string& folder);

}  // namespace patina::runtime
